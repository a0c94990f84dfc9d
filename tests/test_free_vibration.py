"""The first natural frequency about the shape under load, and the viscosity that a loss tangent means at it.

The filament of the package's own runs is not used here, but for :func:`test_a_run_rings_as_foreseen`.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.linalg import null_space
from scipy.optimize import brentq
from scipy.special import jn_zeros

from softcat_sym.estimates.free_vibration import (
    damping_note,
    first_vibration,
    ringing,
    solid_retardation,
    solid_viscosity,
)
from softcat_sym.scene.scene import Scene


def links(length: float, span: float, drop: float = 0.0, count: int = 120) -> float:
    """Lowest frequency [1/s] of masses on stiff links that hang as a catenary, by equations of its own.

    The links keep their lengths: what moves lies in the null space of their changes, and only tension resists.
    """
    u = brentq(lambda u: math.sinh(u) / u - math.sqrt(length**2 - drop**2) / span, 1e-6, 20)
    a = span / 2 / u
    s = a * math.sinh(-math.atanh(drop / length) - u) + np.linspace(0, length, count + 1)
    step = np.diff(np.column_stack([a * np.arcsinh(s / a), np.hypot(a, s)]), axis=0)
    assert step.sum(axis=0) == pytest.approx([span, -drop], rel=1e-9, abs=1e-9)
    along = step / np.linalg.norm(step, axis=1)[:, None]
    taut = GRAVITY * np.hypot(a, (s[1:] + s[:-1]) / 2) / np.linalg.norm(step, axis=1)
    longer, turned = (np.zeros((count, 2 * count + 2)) for _ in range(2))
    for n, (x, y) in enumerate(along):
        longer[n, 2 * n : 2 * n + 4] = -x, -y, x, y
        turned[n, 2 * n : 2 * n + 4] = y, -x, -y, x
    held = slice(2, -2)
    free = null_space(longer[:, held])
    stiffness = free.T @ turned[:, held].T @ np.diag(taut) @ turned[:, held] @ free
    return math.sqrt(float(np.linalg.eigvalsh(stiffness)[0]) * count / length)


GRAVITY = 9.81
# Roots of the frequency equations (Rayleigh 1877, sections 172 to 177).
BETA = {
    ("clamped", "clamped"): 4.730040744862704,
    ("clamped", "pinned"): 3.926602312047919,
    ("pinned", "pinned"): math.pi,
    ("clamped", "free"): 1.875104068711961,
    ("free", "clamped"): 1.875104068711961,
}


def strand(diameter: str = "1 mm", modulus: str = "45 GPa", **changes: object) -> Scene:
    table = {
        "filament": {"span": "20 mm", "diameter": diameter, "density": "1050 kg/m^3"},
        "material": {"law": "elastic", "youngs_modulus": modulus, "loss_tangent": 0.1},
        "run": {"duration": "1 s"},
    }
    return Scene.model_validate(table).replace({key.replace("__", "."): value for key, value in changes.items()})


def frequency(scene: Scene) -> float:
    found = first_vibration(scene)
    assert found is not None
    return found.frequency


def test_a_beam_has_the_frequency_of_its_ends() -> None:
    for ends, beta in BETA.items():
        # So thin that it does not shear.
        scene = strand("0.01 mm", load__gravity="0 m/s^2", ends__left=ends[0], ends__right=ends[1])
        wanted = beta**2 / 0.02**2 * math.sqrt(45e9 * (1e-5) ** 2 / 16 / 1050)
        assert frequency(scene) == pytest.approx(wanted, rel=2e-6)
        assert first_vibration(scene).material_share == pytest.approx(1.0, abs=1e-6)  # type: ignore[union-attr]


def test_a_taut_string_sings_by_its_tension_which_loses_nothing() -> None:
    scene = strand(
        "0.05 mm", "45 kPa", ends__left="pinned", ends__right="pinned", filament__rest_length="10 mm",
        load__gravity="0 m/s^2",
    )  # fmt: skip
    # Drawn to twice its length it is half as thick, and as heavy along its rest length.
    wanted = math.pi / 0.02 * math.sqrt(45e3 * math.log(2) / 2 / (1050 / 2))
    assert frequency(scene) == pytest.approx(wanted, rel=1e-4)
    assert first_vibration(scene).material_share < 1e-3  # type: ignore[union-attr]


@pytest.mark.parametrize("arm", [1e-6, 0.3, 2.0])
def test_a_string_that_hangs_in_its_weight_has_irvine_s_frequency(arm: float) -> None:
    """tan u = u - 4 u^3/lambda^2, omega^2 = 4 u^2 N/(m L^2), lambda^2 = 24 of a string that its weight has stretched.

    That of a solid which has crept to the sag of its soft spring is larger by the ratio of both springs to that one.
    """
    solid = {"law": "standard-linear", "youngs_modulus": "45 MPa", "second_modulus": f"{45 * arm} MPa"}
    string = strand("0.002 mm", ends__left="pinned", ends__right="pinned", load__ramp="10 s")
    scene = Scene.model_validate({**string.given(), "material": {**solid, "viscosity": "1 MPa*s"}})
    u = float(brentq(lambda u: math.tan(u) - u + u**3 / (6 + 6 * arm), 1.6, 4.7))
    sag = (3 * 1050 * 9.81 * 0.02**4 / (64 * 45e6)) ** (1 / 3)
    assert frequency(scene) ** 2 == pytest.approx(4 * u**2 / 8 * 9.81 / sag, rel=2e-3)


def test_a_mass_at_midspan_and_a_profile_count() -> None:
    beam = 192 * 45e9 * math.pi * 1e-12 / 64 / 0.02**3
    still = {"load__gravity": "0 m/s^2", "run__effects": ["inertia", "bending", "extensibility"]}
    heavy = frequency(strand(load__point_mass="1 kg", **still))
    assert heavy == pytest.approx(math.sqrt(beam), rel=1e-3)
    thin = frequency(strand(filament__profile=[0.5, 0.5], **still))
    assert thin == pytest.approx(frequency(strand(**still)) / 2, rel=1e-6)


def test_of_a_sheet_it_is_the_loss_tangent_of_its_fibres() -> None:
    """4/3 eta over E/(1 - nu^2) there (THEORY 3), and the same ratio to lose."""
    scene = Scene.model_validate(
        {
            "filament": {"span": "20 mm", "thickness": "1 mm", "section": "sheet", "density": "1050 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "45 GPa", "loss_tangent": 0.1},
            "run": {"duration": "1 s"},
        }
    )
    ratio = 4 / 3 * solid_viscosity(scene) / (45e9 / (1 - 0.45**2))
    assert ratio * frequency(scene) == pytest.approx(0.1)
    assert solid_retardation(scene) == pytest.approx(ratio)


PINNED = {"ends__left": "pinned", "ends__right": "pinned"}
STILL = {"load__gravity": "0 m/s^2"}
# Thin and stiff: it neither bends nor stretches by as much as is compared.
WIRE = {"filament__span": "120 m", "filament__density": "7800 kg/m^3"}
BEAM = math.pi**2 / 0.02**2 * math.sqrt(45e9 * 1e-6 / 16 / 1050)
"""A beam of Euler's between pins, 1 mm thick."""
EULER = (math.pi * 0.25e-3 / 0.02) ** 2
"""Strain at which it buckles."""
SLENDER = {"run__effects": ["inertia", "bending", "extensibility", "finite-stretch", "large-rotation"]}


@pytest.mark.parametrize(("length", "drop"), [(140.0, 0.0), (121.0, 0.0), (240.0, 0.0), (140.0, 40.0)])
def test_a_slack_chain_swings_as_its_links_do(length: float, drop: float) -> None:
    """A chain of 140 m over 120 m has 0.161 Hz, and not the 12.8 Hz of a straight bar."""
    ends = {**PINNED, "ends__drop": f"{drop} m"}
    scene = strand("2 mm", "20 TPa", **WIRE, **ends, filament__rest_length=f"{length} m")
    assert frequency(scene) == pytest.approx(links(length, 120.0, drop), rel=2e-3)
    assert first_vibration(scene).material_share < 1e-2  # type: ignore[union-attr]
    if (length, drop) == (140.0, 0.0):
        assert frequency(scene) / (2 * math.pi) == pytest.approx(0.1614, abs=1e-4)
        assert "first natural frequency 0.161" in damping_note(scene)
        assert solid_viscosity(scene) == pytest.approx(0.1 * 20e12 / (2 * math.pi * 0.1614), rel=1e-3)
        assert (ringing(scene).frequency, ringing(scene).amplitude) == (frequency(scene), 0)


def test_what_hangs_by_one_end_swings_or_stretches_as_its_weight_moves_it() -> None:
    pin, clamp = {"ends__left": "pinned", "ends__right": "free"}, {"ends__right": "free"}
    first_zero = float(jn_zeros(0, 1)[0])
    chain = strand("0.002 mm", "45 MPa", filament__span="1 m", **pin)
    assert frequency(chain) == pytest.approx(first_zero / 2 * math.sqrt(GRAVITY), rel=1e-3)
    rod = strand(**pin)
    assert frequency(rod) == pytest.approx(math.sqrt(1.5 * GRAVITY / 0.02), rel=1e-4)
    down = strand(ends__left_angle="-90 deg", **clamp)
    assert frequency(down) == pytest.approx(math.pi / 2 / 0.02 * math.sqrt(45e9 / 1050), rel=1e-3)
    # It need not hang: at once its weight takes it far from where it begins, and it swings as a chain about its rest.
    soft = strand("0.01 mm", "45 MPa", filament__span="1 m", **clamp)
    assert frequency(soft) == pytest.approx(first_zero / 2 * math.sqrt(GRAVITY), rel=0.03)


def test_thrust_softens_a_beam_until_it_buckles_and_a_buckled_one_is_stiff_again() -> None:
    maxwell = {"material__law": "maxwell", "material__viscosity": "1e30 Pa*s"}
    for share in (0.5, 0.9):
        pressed = strand(initial__P=[share * EULER], **maxwell, **PINNED, **STILL, **SLENDER)
        assert frequency(pressed) == pytest.approx(BEAM * math.sqrt(1 - share), rel=1e-5)
    # Between pins omega = pi^2 b/sqrt(2) with its rise b in radii of gyration (Nayfeh & Emam 2008).
    rise = 2 * 0.25e-3
    longer = 0.02 * (1 + EULER + (math.pi * rise / 0.02) ** 2 / 4)
    buckled = strand(filament__rest_length=f"{longer:.15g} m", load__gravity="1 m/s^2", **PINNED, **SLENDER)
    assert frequency(buckled) == pytest.approx(BEAM * math.sqrt(2), rel=2e-3)


def test_shear_and_the_fluid_around_slow_a_beam_and_the_pull_of_its_surface_hastens_it() -> None:
    plain = frequency(strand(**PINNED, **STILL, **SLENDER))
    assert plain == pytest.approx(BEAM, rel=1e-6)
    compliance = (math.pi / 0.02) ** 2 * 1e-6 / 16 * 2 * 1.45 / (9 / 10)
    assert frequency(strand(**PINNED, **STILL)) == pytest.approx(BEAM / math.sqrt(1 + compliance), rel=1e-3)
    wet = strand(**PINNED, surroundings__density="1050 kg/m^3")
    assert frequency(wet) == pytest.approx(frequency(strand(**PINNED, **STILL)) / math.sqrt(2), rel=1e-3)
    pulled = strand("1 mm", "450 kPa", **PINNED, **STILL, surroundings__surface_tension="72 mN/m")
    bare = frequency(strand("1 mm", "450 kPa", **PINNED, **STILL))
    wanted = math.sqrt(bare**2 + (math.pi / 0.02) ** 2 * 2 * 0.072 / 1e-3 / 1050)
    assert frequency(pulled) == pytest.approx(wanted, rel=2e-3)


@pytest.mark.parametrize("turns", [4, 5])
def test_a_coil_spring_stretches_by_the_torsion_of_its_wire(turns: int) -> None:
    """k = G d^4/(8 D^3 n) (Wahl), and a quarter of a wave along it; a straight bar has 500 times as much.

    The spring of elements is some per cent slower, as its free end also moves aside.
    """
    radius, climb, wire = 10e-3, 2e-3 / (2 * math.pi), 1e-3
    square = radius**2 + climb**2
    scene = strand("1 mm", "1 GPa", ends__right="free", load__gravity="0.001 m/s^2").replace(
        {
            "filament.span": f"{2 * turns} mm", "filament.shape": "helix", "load.direction": [1, 0, 0],
            "filament.curvature": f"{radius / square!r} 1/m", "filament.twist": f"{climb / square!r} 1/m",
        }
    )  # fmt: skip
    stiffness = 1e9 / 2.9 * wire**4 / (8 * (2 * radius) ** 3 * turns)
    mass = 1050 * math.pi * wire**2 / 4 * 2 * math.pi * turns * math.sqrt(square)
    assert frequency(scene) == pytest.approx(math.pi / 2 * math.sqrt(stiffness / mass), rel=0.03)
