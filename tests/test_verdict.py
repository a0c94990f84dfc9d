"""Regimes, necks, rupture, energy and warnings of fields made by hand; what was left out, and runs that call for it."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from softcat_sym import load_scene, simulate
from softcat_sym.effects import selection
from softcat_sym.effects.selection import choose_effects
from softcat_sym.estimates.expected_regime import TURNS_BACK
from softcat_sym.estimates.forecast import forecast
from softcat_sym.results import run as run_module
from softcat_sym.results import verdict
from softcat_sym.results.fields import energy_residual
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME, is_arrested, rebound_of, regime_of
from softcat_sym.results.run import Run
from softcat_sym.results.verdict import (
    SHARE_OF_ONE_CELL,
    gained_energy,
    largest_share_of_one_cell,
    largest_stretch,
    neck_strain,
    neck_that_the_grid_decides,
    rupture,
    rupture_frame,
)
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import without_estimate
from softcat_sym.solvers.outcome import Outcome
from tests.common.runs import scene_of

Array = np.ndarray[Any, Any]

FRAMES, CELLS = 41, 8
RATE = 1960 / 13840  # yield stress over viscosity of the scene
SINKING = -0.05 * np.linspace(0, 1, FRAMES) ** 0.3
DYING = 3 * RATE * np.exp(-np.linspace(0, 8, FRAMES))


def fields(rate: Array) -> dict[str, Array]:
    """Fields whose plastic rate is `rate` (frames,) in every cell."""
    return {"plastic_rate": np.repeat(rate[:, None], CELLS, axis=1)}


def label(
    given: dict[str, Array], scene: Scene | None = None, midpoint: Array = SINKING, *, yielded: bool = True
) -> str:
    scene = scene or scene_of()
    return regime_of(scene, choose_effects(scene), given, midpoint, yielded=yielded)


def test_regimes() -> None:
    still, time = np.zeros(FRAMES), np.linspace(0, 20, FRAMES)
    assert label(fields(still), scene_of("elastic")) == "elastic"
    assert label(fields(np.ones(FRAMES)), scene_of("maxwell")) == "viscous"
    assert label(fields(still), yielded=False) == "no-yield"
    assert label(fields(still)) != "no-yield", "plastic strain that no frame has seen come about"
    assert label(fields(np.full(FRAMES, 2 * RATE))) == "descending"
    assert label(fields(DYING)) == "arrested-overdamped"
    swinging = -0.05 * (1 - np.exp(-0.1 * time) * np.cos(time))
    hardly = -0.05 * (1 - 0.01 * np.cos(time) - np.exp(-time))
    assert label(fields(DYING), midpoint=swinging) == "arrested-underdamped"
    assert label(fields(DYING), midpoint=hardly) == "arrested-overdamped"
    strong = simulate(scene_of(material={"yield_stress": "1 MPa"}))
    assert strong.summary["regime"] == "no-yield"
    assert float(strong.data["energy_dissipated"][-1]) == float(strong.data["yielded_fraction"].max()) == 0


def test_arrest_is_slow_everywhere_for_the_stated_time() -> None:
    scene = scene_of()
    for factor, arrested in ((0.99, True), (1.01, False)):
        assert is_arrested(scene, np.full((FRAMES, CELLS), factor * ARREST_RATE * RATE)) is arrested
    # The last tenth of forty intervals is the last five frames.
    assert pytest.approx(0.1) == ARREST_TIME
    for frame, arrested in ((-6, True), (-5, False), (-1, False)):
        rate = np.zeros((FRAMES, CELLS))
        rate[frame, 2] = RATE
        assert is_arrested(scene, rate) is arrested
    assert is_arrested(scene, np.zeros((1, CELLS)))
    assert not is_arrested(scene, np.full((1, CELLS), RATE))


def test_how_far_the_midpoint_turned_back() -> None:
    for heights, share in (([0.0, -1, -2], 0), ([0.0, -2, -1.5, -1.8], 0.25), ([0.0, -1, -0.5, -4], 0.125), ([0.0], 0)):
        assert rebound_of(np.array(heights)) == pytest.approx(share)
    assert 0 < TURNS_BACK < 0.25


def profile(half: Sequence[float]) -> tuple[Array, Array]:
    stretch = 1 + np.array([*half[::-1], *half])
    return stretch, np.full(len(stretch), 0.1)


def test_a_cell_that_gathers_the_strain_of_its_half_is_a_neck() -> None:
    smooth = ([0.1] * 10, list(np.linspace(0.0, 0.3, 10)), list(np.exp(np.linspace(-3, 0, 10)) / 10))
    for half in smooth:
        assert largest_share_of_one_cell(*profile(half)) < SHARE_OF_ONE_CELL
    for half, share in (
        ([0.0] * 9 + [2.0], 1.0),
        ([0.0, 0.0, 2.0, 0.0], 1.0),
        ([0.1] * 9 + [1.0], 0.9 / 1.9),
        ([0.0] * 5, 0.0),
        ([-0.1] * 4 + [-0.05], 0.0),
    ):
        stretch, length = profile(half)
        found = largest_share_of_one_cell(stretch, length)
        assert found == pytest.approx(share) == largest_share_of_one_cell(stretch, 1e3 * length)
    assert 0.9 / 1.9 > SHARE_OF_ONE_CELL
    stretch, length = profile([0.1] * 10)
    stretch[0] += 5
    for one_half in (stretch, stretch[::-1]):
        assert largest_share_of_one_cell(one_half, length) == pytest.approx(5 / 6)


def test_strain_that_a_finer_grid_spreads_is_no_neck_of_a_liquid() -> None:
    """A stretch x^(q - 1) has the elongation x^q up to x: its share of one cell falls as N^-q, of a cut not at all."""

    def stretches(cells: int, q: float, cut: float) -> Array:
        edges = np.linspace(0, 1, cells + 1)
        half = np.diff(3 * edges**q) * cells
        half[0] += cut * cells
        return np.concatenate([half, half[::-1]])

    for q, cut in ((0.25, 0.0), (0.5, 0.0), (0.25, 9.0), (0.9, 9.0)):
        for cells in (20, 160):
            nodes = np.linspace(-0.5, 0.5, 2 * cells + 1)
            stretch = stretches(cells, q, cut)
            assert bool(neck_that_the_grid_decides(stretch, nodes, None, yields=False)) is (cut > 0)
    # What yields necks at strains that no liquid would gather.
    assert neck_that_the_grid_decides(stretches(20, 0.25, 0.0), np.linspace(-0.5, 0.5, 41), None, yields=True)


def test_the_strain_of_a_neck_does_not_depend_on_the_grid() -> None:
    """A hinge at each clamp that opens by a given length: spread over a neck, whatever the cells."""
    neck, opening = 0.04, 0.012
    for cells in (10, 40, 160):
        length, stretch = np.full(2 * cells, 0.5 / cells), np.full(2 * cells, 1.02)
        near = max(1, round(neck / 2 / length[0]))
        for end in (slice(None, near), slice(-near, None)):
            stretch[end] += opening / (near * length[0])
        assert neck_strain(stretch, length, neck) == pytest.approx(opening / neck, rel=0.02)
    # A thin string yields most at its supports: from cell to cell by far more than a neck of its thickness holds.
    length = np.full(80, 0.5 / 40)
    smooth = 1 + 0.1 * (np.abs(np.arange(80) - 39.5) / 40) ** 2
    assert neck_strain(smooth, length, 1e-5) < 0.1
    smooth[0] += 0.1
    assert neck_strain(smooth, length, 1e-5) > 10
    for opening, refused in ((0.39, False), (0.41, True)):
        stretch, length = profile([0.0] * 9 + [opening])
        nodes = np.concatenate([[0.0], np.cumsum(length)])
        message = neck_that_the_grid_decides(stretch, nodes, length[0])
        assert (bool(message), "X/L = " in message) == (refused, refused)
        assert "carries 100%" in neck_that_the_grid_decides(stretch, nodes, None)


def test_a_viscous_thread_that_thins_at_its_clamps_is_not_refused() -> None:
    """Without a yield stress a neck only grows with the strain itself, and the sag does not depend on the grid."""
    coarse = {"run.accuracy": 1e-5, "numerics.cells": 12, "numerics.estimate": False, "run.frames": 21}
    coarse |= {"run.duration": "0.8 s"}
    thread = simulate(load_scene("silicone-thread", coarse))
    assert "necking-gradient" in thread.summary["effects"]
    assert float(thread.data.stretch.values[-1].max()) > 3
    assert thread.outcome is Outcome.solved


def test_a_filament_too_weak_for_its_weight_ends_at_its_rupture() -> None:
    """A solid is strongest at e, a fluid ends as a thread; the first frame beyond counts."""
    assert (largest_stretch(scene_of("elastic")), largest_stretch(scene_of("maxwell"))) == (math.e, 1000)
    stretch = np.ones((4, 3))
    stretch[2:, 1] = 2.8
    assert rupture_frame(scene_of("elastic"), stretch) == 2
    assert rupture_frame(scene_of("maxwell"), stretch) is None
    assert rupture_frame(scene_of("maxwell"), np.full((2, 3), np.nan)) == 0
    text = rupture(scene_of("elastic"), np.arange(4.0), stretch, np.linspace(-0.5, 0.5, 4))
    assert "t = 2 s" in text and "X/L = 0 " in text
    changes = {"material.youngs_modulus": "2 kPa", "run.effects": "paper", "load.ramp": "0 s", "run.duration": "1 s"}
    weak = without_estimate(scene_of("elastic").replace(changes))
    torn = simulate(weak)
    assert (torn.outcome, torn.summary["regime"]) == (Outcome.ruptured, None)
    assert float(torn.data["stretch"].max()) <= math.e
    assert torn.summary["time_final_s"] < weak.run.duration


ENERGY = ("kinetic", "elastic", "potential", "dissipated", "work", "gradient", "surface")


def energies(**given: Sequence[float]) -> dict[str, Array]:
    """Energies of some frames; what is not given is zero."""
    frames = len(next(iter(given.values())))
    values = {name: np.array(given.get(name, [0.0] * frames)) for name in ENERGY}
    return {"work_external" if name == "work" else f"energy_{name}": value for name, value in values.items()}


def test_the_residual_is_the_worst_imbalance_over_the_largest_energy() -> None:
    balanced = {"kinetic": [0, 1, 2], "elastic": [0, 2, 1], "potential": [0, -4, -5], "dissipated": [0, 1, 3]}
    for given, residual in (
        ({**balanced, "work": [0, 0, 1]}, 0),
        ({"kinetic": [0, 1], "elastic": [0, 2], "potential": [0, -4], "dissipated": [0, 1.1]}, 0.1 / 4),
        ({"kinetic": [0, 1], "elastic": [0, 2], "potential": [0, -4], "dissipated": [0, 1], "work": [0, 8]}, 1),
        ({"kinetic": [0, 1], "potential": [0, -3], "dissipated": [0, 1], "gradient": [0, 1]}, 0),
        ({"kinetic": [0, 1, 0], "potential": [0, 0, -4], "dissipated": [0, 0, 4]}, 0.25),
        ({"elastic": [5, 5], "potential": [-1, -1]}, 0),
        ({"kinetic": [0, 0]}, 0),
    ):
        assert energy_residual(energies(**given)) == pytest.approx(residual), given


def test_nothing_holds_more_than_it_was_given() -> None:
    for kinetic, elastic, potential, work, surface, least, gains in (
        (0.5, 0.4, -1.0, 0.0, 0.0, 0.0, False),
        (0.5, 1.4, -1.0, 1.0, 0.0, 0.0, False),
        (1.0, 0.4, -1.0, 0.0, 0.0, 0.0, True),
        (1.0, 0.4, -1.0, 0.0, -0.4, 0.0, False),
        (1e-9, 0.0, 0.0, 0.0, 0.0, 1e-8, False),
    ):
        given = {"kinetic": kinetic, "elastic": elastic, "potential": potential, "work": work, "surface": surface}
        text = gained_energy(energies(**{name: [0.0, value] for name, value in given.items()}), least)
        assert bool(text) is gains
        assert not gains or "weight and supports gave 1 J" in text


def test_a_balance_that_does_not_close_is_a_failure_unless_the_closure_has_none(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with monkeypatch.context() as open_balance:
        open_balance.setattr(run_module, "energy_residual", lambda fields, least: 0.5)
        drifted = simulate(scene_of())
        assert drifted.outcome is Outcome.energy_drift and "0.5" in drifted.summary["message"]
        assert simulate(scene_of(run={"closure": "printed"})).outcome is Outcome.solved
        # A neck is worse than any other verdict.
        open_balance.setattr(verdict, "neck_that_the_grid_decides", lambda *_, **__: "a neck at X")
        necked = simulate(scene_of())
        assert necked.outcome is Outcome.localised and "a neck at X" in necked.summary["message"]
    # Finite stretch without thinning has no stored energy whose gradient the force is: reported, not failed.
    soft = scene_of("elastic", material={"youngs_modulus": "0.1 MPa"}, run={"duration": "0.3 s"})
    for absent in [(), ("thinning",), ("finite-stretch",), ("thinning", "finite-stretch")]:
        names = [name for name in choose_effects(soft.replace({"run.effects": "paper"})).names if name not in absent]
        assert simulate(soft.replace({"run.effects": names})).outcome is Outcome.solved


WEIGHT = 1e4
"""rho g L [Pa], L = 1 m."""
GUIDED = {"clamped": 32.0, "pinned": 6.4, "free": 32 * 12 / 204}
"""E (h0/L)^2 H over rho g L^2 of the linear beam: 384/12, 384/60 and, of the middle of a cantilever, 384/204."""


def beam(effects: Sequence[str], thickness: float, E: float, right: str = "clamped", **tables: Any) -> Scene:
    """An elastic filament of span 1 m at rest under its weight, unless tables say otherwise."""
    table: dict[str, Any] = {
        "filament": {"span": "1 m", "thickness": f"{thickness!r} m", "density": "1000 kg/m^3"},
        "material": {"law": "elastic", "youngs_modulus": f"{float(E)!r} Pa"},
        "ends": {"left": "clamped" if right == "free" else right, "right": right},
        "load": {"gravity": "10 m/s^2"},
        "run": {"duration": "1 s", "frames": 2, "effects": list(effects)},
        "numerics": {"cells": 20, "estimate": False},
    }
    for name, values in tables.items():
        table[name] = table.get(name, {}) | values
    return Scene.model_validate(table)


def modulus(thickness: float, sag: float, right: str = "clamped") -> float:
    """Young's modulus at which the linear beam sags so far."""
    return WEIGHT / (GUIDED[right] * thickness**2 * sag)


ACCURACY = 0.01


def slow_beam(thickness: float, sag: float, law: str = "elastic", effects: Any = "auto") -> Scene:
    """A beam between clamps that is loaded slowly and sags so far; a Maxwell fluid relaxes in 3 s."""
    E = modulus(thickness, sag)
    material = {"law": law} | ({"viscosity": f"{3 * E!r} Pa*s"} if law == "maxwell" else {})
    during = {"frames": 41, "effects": effects, "accuracy": ACCURACY}
    return beam((), thickness, E, load={"ramp": "0.5 s"}, run=during, material=material)


def blind(monkeypatch: pytest.MonkeyPatch, *numbers: str) -> None:
    """What is foreseen of the effects is nothing; what is seen is seen all the same."""
    nothing = dict.fromkeys(numbers, 0.0)
    monkeypatch.setattr(selection, "forecast", lambda scene: dataclasses.replace(forecast(scene), **nothing))


CASES = {
    "extensibility": (slow_beam(0.01, 0.005), ("tension_share",)),
    "shear": (slow_beam(0.1, 0.001), ("sheared",)),
    "viscous-flow": (slow_beam(0.01, 1e-4, "maxwell"), ("relaxed",)),
}


def assert_same(first: Run, second: Run) -> None:
    for name, values in first.fields.items():
        np.testing.assert_array_equal(values, second.fields[name], err_msg=name)


@pytest.mark.parametrize("effect", CASES)
def test_what_a_run_shows_to_matter_is_taken_in(effect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    scene, numbers = CASES[effect]
    foresighted = simulate(scene)
    assert foresighted.summary["repeats"] == [] and effect in foresighted.summary["effects"]
    blind(monkeypatch, *numbers)
    assert effect not in choose_effects(scene).names
    done = simulate(scene)
    (text,) = done.summary["repeats"]
    assert text.startswith(f"{effect}: shown by the run without it: ")
    assert text.removeprefix(f"{effect}: ") in done.summary["effects"][effect]
    assert (done.outcome, done.summary["warnings"], done.missing_effect) == (Outcome.solved, [], {})
    assert effect not in done.summary["checked"]
    # Whichever way it was chosen, it is the same filament, also with its effects named.
    names = list(done.summary["effects"])
    assert names == list(foresighted.summary["effects"])
    assert_same(done, foresighted)
    assert_same(done, simulate(scene.replace({"run.effects": names})))
