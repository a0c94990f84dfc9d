"""The surface of a thread: which waves grow, elastic thresholds, and a filament that rests under its surface."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError
from tests.common.threads import INVISCID, evolve, growth, newtonian, thread

CELLS = 16
SOFT: dict[str, dict[str, Any]] = {
    "elastic": {"law": "elastic", "youngs_modulus": 3.0},
    "kelvin-voigt": {"law": "kelvin-voigt", "youngs_modulus": 3.0, "viscosity": 1.0},
    "standard-linear": {"law": "standard-linear", "youngs_modulus": 3.0, "second_modulus": 9.0, "viscosity": 1.0},
    "bingham": {"law": "bingham", "youngs_modulus": 30.0, "viscosity": 1.0, "yield_stress": 2.0},
}
FLOW = {
    "kelvin-voigt": ["viscous-stress"],
    "standard-linear": ["viscous-flow"],
    "bingham": ["viscous-flow", "yielding"],
}
HELD, FREE = ("clamped", "clamped"), ("clamped", "free")


def on_grid(kR: float) -> float:
    """Wavenumber of the differences on equal cells, of a wave as long as the thread."""
    return kR * np.sinc(1 / (2 * CELLS))


@pytest.mark.parametrize("kR", [0.3, 0.697, 1.2])
def test_long_waves_of_an_inviscid_thread_grow_and_short_ones_swing(kR: float) -> None:
    """omega^2 = (kR)^2 (1 - (kR)^2)/2, at the wavenumber that the grid has."""
    K = on_grid(kR)
    expected = np.sqrt(complex(K**2 * (1 - K**2) / 2))
    found = growth(thread(2 * np.pi / kR, CELLS, INVISCID), 1, youngs_modulus=0.0)
    assert found.real == pytest.approx(expected.real, rel=1e-7, abs=1e-9)
    assert abs(found.imag) == pytest.approx(expected.imag, rel=1e-7, abs=1e-9)


def test_a_viscous_thread_beads_slower() -> None:
    """omega^2 + 3 nu k^2 omega = (kR)^2 (1 - (kR)^2)/2."""
    K = on_grid(0.5)
    lost = 3 * K**2
    expected = (-lost + np.sqrt(lost**2 + 2 * K**2 * (1 - K**2))) / 2
    assert growth(thread(4 * np.pi, CELLS, newtonian(3.0)), 1).real == pytest.approx(expected, rel=1e-7)


@pytest.mark.parametrize("stretch", [1.0, 1.2])
def test_a_soft_cylinder_beads_beyond_six_shear_moduli(stretch: float) -> None:
    """gamma = 6 mu R (1 - log s)/sqrt(s) of long waves (Mora et al. 2010; Hencky elasticity)."""
    soft = thread(300.0, CELLS, SOFT["elastic"], initial={"stretch": stretch, "relaxed": False})
    threshold = 6 * (1 - np.log(stretch)) / np.sqrt(stretch)
    below, above = (growth(soft, 1, surface_tension=far * threshold).real for far in (0.999, 1.001))
    assert abs(below) < 1e-9
    assert above > 1e-4


@pytest.mark.parametrize("law", ["elastic", "kelvin-voigt", "standard-linear", "bingham"])
def test_solids_alone_are_refused_beyond(law: str) -> None:
    """gamma = 2 E R with the modulus that lasts; what flows may bead."""
    material = SOFT[law]
    thread(50.0, CELLS, material, surroundings={"surface_tension": 5.9})
    soft = thread(50.0, CELLS, material | {"youngs_modulus": 3.0}, surroundings={"surface_tension": 6.1})
    if law == "bingham":
        sc.simulate(soft.replace({"run.effects": "auto", "run.duration": "0.01 s", "run.frames": 2}))
        return
    with pytest.raises(SceneError, match=r"surroundings.surface_tension: .* beads"):
        sc.simulate(soft)


@pytest.mark.parametrize(
    ("law", "section", "ends"),
    [
        ("elastic", "sheet", FREE),
        ("kelvin-voigt", "rectangle", HELD),
        ("standard-linear", "circle", FREE),
        ("bingham", "circle", HELD),
        ("bingham", "sheet", FREE),
    ],
)
def test_a_relaxed_surface_leaves_no_force(law: str, section: str, ends: tuple[str, str]) -> None:
    """Weightless, it stays as it is: the stress of the material balances the surface."""
    size = {"section": section} | ({} if section == "circle" else {"width": 3.0})
    asked = thread(50.0, 6, SOFT[law], initial={"surface": "relaxed"}, filament=size)
    asked = asked.replace(
        {
            "ends.left": ends[0],
            "ends.right": ends[1],
            "run.effects": [*asked.run.effects, *FLOW.get(law, [])],
            "run.frames": 3,
        }
    )
    done = sc.simulate(asked)
    assert done.outcome.is_success, done.summary["message"]
    tension, force = done.data["tension"].values, done.data["axial_force"].values
    assert np.max(tension) < -1.0
    assert np.max(np.abs(force)) < 1e-9 * np.max(np.abs(tension))
    assert any("relaxed" in text for text in done.summary["assumed"])
    assert np.max(np.abs(done.data["x"].values - done.data["x"].values[0])) < 1e-9


def test_a_surface_stronger_than_the_yield_stress_leaves_the_difference() -> None:
    strong = thread(50.0, 6, SOFT["bingham"] | {"yield_stress": 0.4}, initial={"surface": "relaxed"})
    strong = strong.replace({"run.effects": [*strong.run.effects, "viscous-flow", "yielding"], "run.frames": 3})
    found = sc.simulate(strong).data["axial_force"].values / np.pi
    np.testing.assert_allclose(found, 0.6, rtol=1e-9)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"surroundings.surface_tension": "0 N/m"}, "there is no surface tension"),
        ({"initial.P": [0.1]}, "initial.P says too"),
        ({"initial.stretch": 1.1}, "initial.stretch says too"),
        ({"material": {"law": "maxwell", "youngs_modulus": "1 Pa", "viscosity": "1 Pa*s"}}, "has no yield stress"),
        ({"run.effects": "paper"}, "run.effects: without 'surface-tension'"),
    ],
)
def test_a_relaxed_surface_is_refused_where_it_says_nothing(changes: dict[str, Any], said: str) -> None:
    with pytest.raises(SceneError, match=said):
        sc.simulate(sc.load_scene("ink-bridge", {"initial.surface": "relaxed", **changes}))


@pytest.mark.parametrize("shear", [False, True])
def test_the_energy_of_a_thread_that_beads_is_closed(shear: bool) -> None:
    """Half the amplitude grows into a bead: what the surface gives is lost to viscosity, and the rest moves."""
    asked = thread(4 * np.pi, 8, newtonian(3.0), run={"duration": 25.0, "frames": 11}, numerics={"backend": "compiled"})
    if shear:
        asked = asked.replace({"run.effects": [*asked.run.effects, "shear"]})
    done = evolve(asked, lambda X: 1 + 0.1 * np.cos(2 * np.pi * X))
    stretch = done.data["stretch"].values[-1]
    assert stretch.max() / stretch.min() > 3
    assert float(done.data["energy_surface"][-1]) < 0
    assert done.summary["energy_residual"] < 1e-7
