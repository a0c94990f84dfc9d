"""The beam that bends and does not stretch: what the filament is without extensibility."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from softcat_sym import Trajectory, simulate
from softcat_sym.scene.scene import Scene
from tests.marks import few

from .closed_forms import BEAM_CONSTANT, FIRST_EIGENVALUE, GYRATION
from .scenes import paper_scene, run, sag, scene
from .test_motion import upward_crossings

THICKNESS, WEIGHT, TINY = 0.02, 1e4, 2e-5
"""Thickness, weight per volume and sag of most beams here, span 1 m: H/h0 is a thousandth."""

CONSTANT = {**BEAM_CONSTANT, ("pinned", "clamped"): 192.0, ("clamped", "free"): 384 / 17, ("free", "clamped"): 384 / 17}
"""C in: midpoint sag = w L^4/(C E I), cantilevers included (17/384 at half their length)."""

LOST_TO_TENSION = {
    ("clamped", "clamped"): 32 / 525,
    ("pinned", "pinned"): 16592 / 65625,
    ("clamped", "pinned"): 23 / 175,
}
"""Share of the sag H that tension takes, over A H^2/I: derivations/02_section_and_closures.py."""


def modulus(ends: tuple[str, str], section: str = "rectangle", height: float = TINY) -> float:
    """Young's modulus at which the linear beam sags by this height."""
    return WEIGHT / (CONSTANT[ends] * GYRATION[section] * THICKNESS**2 * height)


def beam(ends: tuple[str, str] = ("clamped", "clamped"), section: str = "rectangle", **changes: Any) -> Scene:
    """An elastic beam of tiny sag at rest, unless changed."""
    given = {"effects": ("bending",), "E": modulus(ends, section)} | changes
    return scene(thickness=THICKNESS, section=section, ends=ends, **given)


def test_static_sag_is_of_second_order_in_the_cells() -> None:
    for section in ["rectangle", "circle"]:
        for ends in list(CONSTANT):
            errors = [sag(run(beam(ends, section, cells=cells))) / TINY - 1 for cells in (10, 20, 40)]
            orders = np.log2(np.abs(errors[:-1]) / np.abs(errors[1:]))
            print(f"{'-'.join(ends)} {section}: errors {errors}, orders {orders}")
            assert abs(errors[-1]) < 2e-3
            assert np.all(np.abs(orders - 2) < 0.05)


def test_the_tip_of_a_cantilever_sags_by_an_eighth() -> None:
    done = run(beam(("clamped", "free"), cells=40))
    tip = -float(done.data["y"][-1, -1]) / TINY
    assert tip == pytest.approx(384 / 17 / 8, rel=1e-3)


def test_the_sag_may_be_of_any_size_as_it_is_linear() -> None:
    """A sheet that a string would have to carry: forty spans, found at once."""
    assert sag(run(beam(E=modulus(("clamped", "clamped"), height=40.0)))) == pytest.approx(40, rel=2e-3)


@pytest.mark.parametrize("ends", list(FIRST_EIGENVALUE), ids="-".join)
def test_first_frequency(ends: tuple[str, str]) -> None:
    """(beta L)^2 sqrt(E I/(rho A L^4)), with beta L = 4.730 between clamps."""
    rigidity = modulus(ends) * GYRATION["rectangle"] * THICKNESS**2 / 1000.0
    period = 2 * np.pi / (FIRST_EIGENVALUE[ends] ** 2 * np.sqrt(rigidity))
    done = run(beam(ends, effects=("inertia", "bending"), duration=10.5 * period, frames=801, rtol=3e-4))
    assert done.outcome.is_success
    assert done.summary["energy_residual"] < 1e-3
    t, y = done.data["time"].values, done.data["midpoint"].values
    crossings = upward_crossings(t, y + TINY)
    assert len(crossings) == 10
    assert (crossings[-1] - crossings[0]) / 9 == pytest.approx(period, rel=2e-3)
    assert -np.mean(y[t < 10 * period]) == pytest.approx(TINY, rel=5e-3)


def law_scene(law: str, ends: tuple[str, str], section: str, effects: tuple[str, ...], duration: float) -> Scene:
    """A beam of a law that flows as much as it springs within a second."""
    outline = "rectangle" if section == "sheet" else section
    E, eta = (f"{modulus(ends, outline)!r} {unit}" for unit in ("Pa", "Pa*s"))
    # Stress of the outermost fibre under the largest moment, within a factor of two.
    fibre = WEIGHT * THICKNESS / 20 / (GYRATION[outline] * THICKNESS**2)
    material: dict[str, Any] = {
        "elastic": {"youngs_modulus": E},
        "maxwell": {"youngs_modulus": E, "viscosity": eta},
        "newtonian": {"viscosity": eta},
        "kelvin-voigt": {"youngs_modulus": E, "viscosity": eta},
        "standard-linear": {"youngs_modulus": E, "second_modulus": E, "viscosity": eta},
        "multimode-maxwell": {
            "modes": [
                {"youngs_modulus": E, "viscosity": f"{factor * modulus(ends, outline)!r} Pa*s"} for factor in (0.3, 3.0)
            ]
        },
        "bingham": {
            "youngs_modulus": E,
            "viscosity": f"{modulus(ends, outline) / 10!r} Pa*s",
            "yield_stress": f"{fibre / 2!r} Pa",
        },
        "power-law": {"youngs_modulus": E, "index": 1.5, "viscosity": f"{fibre / 2e-8!r} Pa*s**1.5"},
        "herschel-bulkley": {
            "youngs_modulus": E,
            "index": 0.5,
            "viscosity": f"{fibre / 1e-2!r} Pa*s**0.5",
            "yield_stress": f"{fibre / 2!r} Pa",
        },
        "custom": {
            "youngs_modulus": E,
            "flow": "sinh(sigma/s0)/t0",
            "parameters": {"s0": f"{5 * fibre!r} Pa", "t0": "2e4 s"},
        },
    }[law]
    return Scene.model_validate(
        {
            "filament": {"span": "1 m", "thickness": "20 mm", "section": section, "density": "1000 kg/m^3"},
            "material": {"law": law, **material},
            "ends": {"left": ends[0], "right": ends[1]},
            "load": {"gravity": "10 m/s^2"},
            "run": {"duration": f"{duration!r} s", "frames": 21, "effects": list(effects)},
            "numerics": {"cells": 10, "rtol": 1e-6},
        }
    )


VISCOUS, FLOWING, YIELDING = ("viscous-stress",), ("viscous-flow",), ("viscous-flow", "yielding")
LAWS = {
    "elastic": ((), ("clamped", "pinned"), "rectangle"),
    "maxwell": (FLOWING, ("clamped", "free"), "circle"),
    "newtonian": (VISCOUS, ("clamped", "clamped"), "rectangle"),
    "kelvin-voigt": (VISCOUS, ("pinned", "pinned"), "sheet"),
    "standard-linear": (FLOWING, ("clamped", "clamped"), "circle"),
    "multimode-maxwell": (FLOWING, ("clamped", "pinned"), "rectangle"),
    "bingham": (YIELDING, ("clamped", "clamped"), "circle"),
    "power-law": (FLOWING, ("pinned", "pinned"), "rectangle"),
    "herschel-bulkley": (YIELDING, ("clamped", "pinned"), "sheet"),
    "custom": (FLOWING, ("free", "clamped"), "rectangle"),
}


@pytest.mark.parametrize(
    ("law", "moves"),
    few(
        [*((law, False) for law in LAWS), *((law, True) for law in ("elastic", "newtonian", "maxwell"))],
        ("elastic", False),
        ("newtonian", False),
        ("bingham", False),
        ("standard-linear", False),
        ("maxwell", True),
    ),
)
def test_every_law_is_what_the_stretching_filament_becomes(law: str, moves: bool) -> None:
    """At H/h0 of a thousandth tension carries a millionth of the load."""
    flow, ends, section = LAWS[law]
    effects = ("bending", *flow, *(("inertia",) if moves else ()))
    plain = simulate(law_scene(law, ends, section, effects, 0.02 if moves else 1.0))
    stretching = simulate(law_scene(law, ends, section, (*effects, "extensibility"), 0.02 if moves else 1.0))
    assert plain.outcome.is_success, plain.summary["message"]
    heights = [np.asarray(done.data["y"].values) for done in (plain, stretching)]
    difference = float(np.max(np.abs(heights[0] - heights[1])) / np.max(np.abs(heights[1])))
    sags = np.max(np.abs(heights[1]), axis=1)
    residual = plain.summary["energy_residual"]
    print(f"{law}: sag {sags[0]:.1e} to {sags[-1]:.1e} m, differ by {difference:.1e}, energy residual {residual:.1e}")
    assert difference < 2e-4
    assert residual < 1e-3
    assert bool(flow) == bool(plain.data["energy_dissipated"][-1] > 0)
    assert_unstretched(plain)


def assert_unstretched(done: Trajectory) -> None:
    """Every field of a trajectory is there, and those of stretching say that there is none."""
    data = done.data
    assert not np.any(data["tension"].values)
    assert not np.any(data["stress_mean"].values)
    assert np.all(data["stretch"].values == 1)
    assert np.all(data["thickness"].values == data["thickness"].values[0])
    np.testing.assert_allclose(data["x"].values, np.broadcast_to(data["X_node"].values, data["x"].shape), atol=1e-15)


def test_a_viscous_beam_sags_at_a_steady_rate() -> None:
    """A Newtonian beam between clamps: rho g L^4 t/(384 eta I/A)."""
    eta = modulus(("clamped", "clamped"))
    asked = law_scene("newtonian", ("clamped", "clamped"), "rectangle", ("bending", "viscous-stress"), 1.0)
    done = simulate(asked.replace({"numerics.cells": 40}))
    expected = WEIGHT * done.data["time"].values / (384 * eta * THICKNESS**2 / 12)
    np.testing.assert_allclose(-done.data["midpoint"].values, expected, rtol=1.1e-3, atol=1e-12)


def test_a_bingham_beam_below_first_yield_is_elastic() -> None:
    names = ("inertia", "bending", "gravity-ramp")
    bingham = run(paper_scene(0.02, 1.0, 200.0, effects=(*names, "viscous-flow", "yielding"), frames=41, rtol=1e-6))
    elastic = run(paper_scene(0.02, 1.0, 200.0, effects=names, frames=41, rtol=1e-6))
    assert bingham.summary["regime"] == "no-yield"
    assert float(np.max(bingham.data["energy_dissipated"])) == 0
    y, expected = bingham.data["midpoint"].values, elastic.data["midpoint"].values
    np.testing.assert_allclose(y, expected, atol=1e-5 * float(np.max(np.abs(expected))))


@pytest.mark.parametrize("ends", list(LOST_TO_TENSION), ids="-".join)
def test_tension_takes_a_share_that_falls_with_the_square_of_the_sag(ends: tuple[str, str]) -> None:
    """(H/h0)^2 times 0.73 between clamps and 3.03 between pins, for a rectangle."""
    sizes, lost = np.array([0.005, 0.01, 0.02]), []
    for size in sizes.tolist():
        asked = beam(ends, E=modulus(ends, height=size * THICKNESS))
        plain, stretching = sag(run(asked)), sag(run(asked.replace({"run.effects": ["bending", "extensibility"]})))
        lost.append((plain - stretching) / plain)
    orders = np.diff(np.log2(lost))
    prefactor = float(lost[0] / sizes[0] ** 2)
    print(f"{'-'.join(ends)}: share {lost}, orders {orders}, prefactor {prefactor:.4f}")
    assert np.all(np.abs(orders - 2) < 0.01)
    assert prefactor == pytest.approx(LOST_TO_TENSION[ends] / GYRATION["rectangle"], rel=5e-3)
