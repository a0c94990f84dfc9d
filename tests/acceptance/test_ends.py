"""Ends of every kind against exact curves: elasticas, catenaries, beams of varying section, a bar drawn out."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from tests.common import curves, materials
from tests.marks import few

from .rheology import GEOMETRY, STRING, Array, flow_of, limit_of, scene, solved
from .table import show

STRESS = 1e4
"""rho g times 1 m [Pa]."""
PINS = {"left": "pinned", "right": "pinned"}
CANTILEVER = {"left": "clamped", "right": "free"}
GRIDS = (20, 40)


def shape(
    E: float,
    filament: Mapping[str, Any],
    effects: tuple[str, ...],
    ends: Mapping[str, Any],
    gravity: float = 10.0,
    grids: tuple[int, int] = GRIDS,
) -> tuple[Array, Array]:
    """Static shape of an elastic filament from its left support, on the nodes of the coarser of two grids."""
    found = []
    for cells in grids:
        material = {"law": "elastic", "youngs_modulus": E}
        data = solved(scene(material, filament, effects=effects, ends=ends, load={"gravity": gravity}, cells=cells))
        place = np.array([data["x"].values[-1], data["y"].values[-1]])[:, :: cells // grids[0]]
        found.append(place - place[:, :1])
    return found[1], limit_of(*found)


def material_points(length: float) -> Array:
    return np.linspace(0, length, 2 * GRIDS[0] + 1)


def judge(title: str, exact: Array, found: tuple[Array, Array], tolerance: float, *, fine: float = 1e-2) -> None:
    """Print and compare, in parts of the largest excursion from the straight line between the ends or along x."""
    size = max(float(np.ptp(exact[1])), 1e-9)
    errors = [float(np.max(np.abs(one - exact))) / size for one in found]
    show(title, ("depth [m]", "N = 40", "without a grid"), [[f"{size:.6f}", *(f"{e:.1e}" for e in errors)]])
    assert errors[0] < fine
    assert errors[1] < tolerance


@pytest.mark.parametrize(("load", "angle"), few([(1.0, 0.0), (12.0, 0.0), (12.0, 0.8)], (12.0, 0.0)))
def test_cantilever_is_the_heavy_elastica(load: float, angle: float) -> None:
    """w L^3/EI given; the oracle stretches and thins as the filament does."""
    thickness = 0.01
    E = 12 * STRESS / (load * thickness**2)
    section = curves.uniform(E * thickness**2, E * thickness**4 / 12)
    X = material_points(1.0)
    exact = curves.held(section, STRESS * thickness**2, 1.0, 0.0, X, ("clamped", angle), ("free", 0.0))
    found = shape(E, {"thickness": thickness}, GEOMETRY, {**CANTILEVER, "left_angle": angle})
    judge(f"cantilever, w L^3/EI = {load:g}, clamp at {angle:g}", np.array([exact.x, exact.y]), found, 2e-4)


def test_unloaded_cantilever_is_the_arc_of_its_natural_curvature() -> None:
    curvature = 1.5
    X = material_points(1.0)
    exact = np.array([np.sin(curvature * X), 1 - np.cos(curvature * X)]) / curvature
    found = shape(1e9, {"thickness": 0.01, "curvature": curvature}, GEOMETRY, CANTILEVER, gravity=0.0)
    judge("natural curvature 1.5/m", exact, found, 1e-5)


@pytest.mark.parametrize("drop", few((0.0, 0.3, -0.4), 0.3))
def test_slack_string_between_heights_is_the_catenary(drop: float) -> None:
    """Thin, pinned, inextensible to 1e-5: no bending at all."""
    length = 1.3
    chain = curves.catenary(1.0, drop, length)
    filament = {"thickness": 0.01, "rest_length": length}
    found = shape(1e5 * STRESS, filament, ("large-rotation",), {**PINS, "drop": drop})
    judge(f"catenary, drop {drop:g} m", np.array(chain.at(material_points(length))), found, 5e-5)


def test_thin_filament_that_bends_hangs_as_the_catenary() -> None:
    """The whole theory; EI/(w L^3) is 8e-7, and what it stretches is in the oracle."""
    length, drop, E_star = 1.3, 0.3, 1e3
    X = material_points(length)
    exact = curves.hanging_string(curves.true_strain_stretch(E_star), 1.0, length, 1.0, X, drop=drop)
    filament = {"thickness": 1e-4, "rest_length": length}
    found = shape(E_star * STRESS, filament, GEOMETRY, {**PINS, "drop": drop})
    judge("bending included, h/L = 1e-4", np.array([exact.x, exact.y]), found, 5e-5)


@pytest.mark.parametrize("E_star", few((3.0, 30.0), 3.0))
@pytest.mark.parametrize("effects", [("large-rotation",), STRING], ids=["linear", "true strain"])
def test_slack_elastic_filament_is_the_elastic_catenary(effects: tuple[str, ...], E_star: float) -> None:
    """Irvine's with T = EA (s - 1), and that of constant volume with T = EA log(s)/s."""
    length, drop = 1.2, 0.2
    stretch = (curves.linear_stretch if len(effects) == 1 else curves.true_strain_stretch)(E_star)
    X = material_points(length)
    exact = curves.hanging_string(stretch, 1.0, length, 1.0, X, drop=drop)
    found = shape(E_star * STRESS, {"thickness": 0.01, "rest_length": length}, effects, {**PINS, "drop": drop})
    judge(f"elastic catenary, E* = {E_star:g}, {effects}", np.array([exact.x, exact.y]), found, 2e-5)


TAPER = (1.0, 0.8, 0.6, 0.5, 0.5)
BULGE = (0.6, 1.0, 1.4, 1.0, 0.6)


@pytest.mark.parametrize("section", ["rectangle", "circle"])
@pytest.mark.parametrize(
    ("profile", "ends"),
    [(TAPER, ("clamped", "free")), (TAPER, ("clamped", "clamped")), (BULGE, ("clamped", "pinned"))],
)
def test_varying_section_is_the_beam(profile: tuple[float, ...], ends: tuple[str, str], section: str) -> None:
    """A0 ~ p and I0 ~ p^3 of a rectangle of fixed width, p^2 and p^4 of a circle; linear beam, sag of 1e-3 h."""
    thickness, sag = 0.02, 2e-5
    area_power = 1 if section == "rectangle" else 2
    gyration = 1 / 12 if section == "rectangle" else 1 / 16

    def relative(X: Array) -> Array:
        return np.interp(X, np.linspace(0, 1, len(profile)), profile)

    X = material_points(1.0)
    unit = curves.linear_beam(
        lambda at: gyration * thickness**2 * relative(at) ** (area_power + 2),
        lambda at: relative(at) ** area_power,
        1.0,
        X,
        (ends[0], 0.0),
        (ends[1], 0.0),
    )
    E = STRESS * float(-unit.min()) / sag
    exact = STRESS / E * unit
    filament = {"thickness": thickness, "section": section, "profile": list(profile)}
    fine, limit = shape(E, filament, GEOMETRY, {"left": ends[0], "right": ends[1]})
    errors = [float(np.max(np.abs(one[1] - exact))) / sag for one in (fine, limit)]
    title = f"{section}, profile {profile}, {'-'.join(ends)}"
    show(title, ("sag, over h", "N = 40", "without a grid"), [[sag / thickness, *(f"{e:.1e}" for e in errors)]])
    assert errors[0] < 5e-3
    assert errors[1] < 5e-4


def test_turned_clamps_at_the_length_of_an_arc_hold_that_arc() -> None:
    """Length a/sin(a) times the span: a circular arc without any force; a weight too small to be felt."""
    angle = 0.6
    length = angle / np.sin(angle)
    radius, X = length / (2 * angle), material_points(length)
    exact = radius * np.array([np.sin(X / radius - angle) + np.sin(angle), np.cos(angle) - np.cos(X / radius - angle)])
    ends = {"left_angle": -angle, "right_angle": angle}
    found = shape(1e9, {"thickness": 0.005, "rest_length": length}, GEOMETRY, ends, gravity=1e-6)
    judge("clamps at -0.6 and 0.6", exact, found, 2e-4)


@pytest.mark.parametrize(
    ("left", "right", "drop"), few([(-0.3, 0.3, 0.0), (-0.2, 0.1, 0.1), (0.2, 0.2, 0.0)], (-0.2, 0.1, 0.1))
)
def test_heavy_filament_between_turned_clamps(left: float, right: float, drop: float) -> None:
    """Against the boundary-value solver, at a stiffness where weight, angles and stretching all matter."""
    thickness, E_star = 0.05, 100.0
    area = thickness**2
    section = curves.uniform(E_star * STRESS * area, E_star * STRESS * area * thickness**2 / 12)
    length = float(np.hypot(1.0, drop))
    X = material_points(length)
    weight = STRESS * area
    exact = curves.held(section, weight, length, 1.0, X, ("clamped", left), ("clamped", right), drop=drop)
    ends = {"left_angle": left, "right_angle": right, "drop": drop}
    found = shape(E_star * STRESS, {"thickness": thickness}, GEOMETRY, ends)
    judge(f"clamps at {left:g} and {right:g}, drop {drop:g}", np.array([exact.x, exact.y]), found, 5e-4)


def test_small_angles_bend_a_beam_into_a_parabola() -> None:
    """y = -a x (1 - x/L): no force, a constant moment."""
    angle, X = 1e-3, material_points(1.0)
    found = shape(1e9, {"thickness": 0.05}, GEOMETRY, {"left_angle": -angle, "right_angle": angle}, gravity=0.0)
    judge("clamps at -1e-3 and 1e-3", np.array([X, -angle * X * (1 - X)]), found, 2e-3)


DRAWN: dict[str, tuple[dict[str, Any], materials.Bar]] = {
    "maxwell": ({"youngs_modulus": 1e5, "viscosity": 3e4}, materials.maxwell(1e5, 3e4)),
    "bingham": (
        {"youngs_modulus": 1e5, "viscosity": 1e4, "yield_stress": 5e3},
        materials.bingham(1e5, 1e4, 5e3),
    ),
    "herschel-bulkley": (
        {"youngs_modulus": 1e5, "viscosity": 1e4, "yield_stress": 5e3, "index": 0.5},
        materials.herschel_bulkley(1e5, 1e4, 0.5, 5e3),
    ),
    "power-law": ({"youngs_modulus": 1e5, "viscosity": 1e4, "index": 0.5}, materials.power_law(1e5, 1e4, 0.5)),
    "kelvin-voigt": ({"youngs_modulus": 1e5, "viscosity": 3e4}, materials.kelvin_voigt(1e5, 3e4)),
    "standard-linear": (
        {"youngs_modulus": 1e5, "second_modulus": 2e5, "viscosity": 3e4},
        materials.standard_linear(1e5, 2e5, 3e4),
    ),
    "multimode-maxwell": (
        {"modes": [{"youngs_modulus": 1e5, "viscosity": 1e4}, {"youngs_modulus": 3e4, "viscosity": 3e4}]},
        materials.multimode([(1e5, 1e4), (3e4, 3e4)]),
    ),
    "newtonian": ({"viscosity": 3e4}, materials.newtonian(3e4)),
}


@pytest.mark.parametrize("law", few(DRAWN, "maxwell", "newtonian", "kelvin-voigt", "herschel-bulkley"))
def test_drawn_bridge_is_its_uniaxial_solution(law: str) -> None:
    """Out to 1.6 times the length in 1 s, then held; tension and stretch of every cell, without gravity."""
    constants, bar = DRAWN[law]
    thickness, rows = 0.02, [(0, 0, 0), (1, 0.6, 0)]
    asked = scene(
        {"law": law, **constants},
        {"thickness": thickness},
        effects=(*GEOMETRY, *flow_of(law)),
        ends={"motion": rows},
        load={"gravity": 0.0},
        run={"duration": 1.5, "frames": 16},
        cells=5,
        rtol=1e-8,
    )
    data = solved(asked)
    path = materials.Drawing(tuple((float(t), 1 + x) for t, x, _ in rows))
    time = data["time"].values
    exact = materials.tension(bar, path, time, thickness**2)
    found = data["tension"].values
    # at a sudden change of speed a viscous stress has two values
    steady = np.abs(time - 1.0) > 1e-9
    error = np.abs(found[1:] - exact[1:, None]).max(axis=1)[steady[1:]] / np.abs(exact).max()
    table = [[f"{t:.1f}", f"{f:.6f}", f"{e:.6f}"] for t, f, e in zip(time, found.mean(axis=1), exact, strict=True)]
    show(f"drawn {law} bridge, largest error {error.max():.1e}", ("t [s]", "T [N]", "exact"), table[::3])
    assert error.max() < 1e-5
    np.testing.assert_allclose(data["stretch"].values, path.stretch(time)[:, None] + 0 * found, rtol=1e-6)
