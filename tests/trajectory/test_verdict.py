"""Regimes, localisation, energy balance and warnings, on fields made by hand."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest

from softcat_sym import simulate
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.results.fields import energy_residual
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME, TURNED_BACK, is_arrested, regime_of, turned_back
from softcat_sym.results.verdict import (
    SHARE_OF_ONE_CELL,
    SHORTEST_CELL,
    largest_share_of_one_cell,
    neck_strain,
    neck_that_the_grid_decides,
    warnings_of,
)
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.solvers.outcome import Outcome

from .runs import run, scene_of

FRAMES, CELLS = 41, 8
RATE = 1960 / 13840  # yield stress over viscosity of the scene
SINKING = -0.05 * np.linspace(0, 1, FRAMES) ** 0.3


def fields(rate: np.ndarray[Any, Any], yielded: float = 0.2, lost: float = 1e-3) -> dict[str, np.ndarray[Any, Any]]:
    """Fields whose plastic rate is `rate` (frames,) in every cell."""
    return {
        "plastic_rate": np.repeat(rate[:, None], CELLS, axis=1),
        "yielded_fraction": np.full((FRAMES, CELLS), yielded),
        "energy_dissipated": np.linspace(0, lost, FRAMES),
    }


def label(law: str, seen: dict[str, np.ndarray[Any, Any]], midpoint: np.ndarray[Any, Any] = SINKING) -> str:
    scene = scene_of(law)
    return regime_of(scene, choose_effects(scene), seen, midpoint)


def test_laws_that_do_not_yield() -> None:
    assert label("elastic", fields(np.zeros(FRAMES))) == "elastic"
    assert label("maxwell", fields(np.ones(FRAMES))) == "viscous"


def test_no_fibre_ever_yields() -> None:
    assert label("bingham", fields(np.zeros(FRAMES), yielded=0.0, lost=0.0)) == "no-yield"


def test_one_fibre_once_is_yielding() -> None:
    seen = fields(np.zeros(FRAMES), yielded=0.0, lost=0.0)
    seen["yielded_fraction"][3, 5] = 0.01
    assert label("bingham", seen) != "no-yield"


def test_yielding_between_frames_shows_in_the_plastic_work() -> None:
    assert label("bingham", fields(np.zeros(FRAMES), yielded=0.0, lost=1e-9)) != "no-yield"


def test_flow_that_goes_on_is_descent() -> None:
    assert label("bingham", fields(np.full(FRAMES, 2 * RATE))) == "descending"


def test_flow_that_dies_out_is_arrest() -> None:
    rate = 3 * RATE * np.exp(-np.linspace(0, 8, FRAMES))
    assert label("bingham", fields(rate)) == "arrested-overdamped"


def test_a_midpoint_that_comes_back_is_underdamped() -> None:
    rate = 3 * RATE * np.exp(-np.linspace(0, 8, FRAMES))
    time = np.linspace(0, 20, FRAMES)
    ringing = -0.05 * (1 - np.exp(-0.1 * time) * np.cos(time))
    assert label("bingham", fields(rate), ringing) == "arrested-underdamped"
    hardly = -0.05 * (1 - 0.01 * np.cos(time) - np.exp(-time))
    assert label("bingham", fields(rate), hardly) == "arrested-overdamped"


@pytest.mark.parametrize(("factor", "arrested"), [(0.99, True), (1.01, False)])
def test_the_threshold_of_arrest(factor: float, arrested: bool) -> None:
    seen = fields(np.full(FRAMES, factor * ARREST_RATE * RATE))
    assert is_arrested(scene_of(), seen["plastic_rate"]) is arrested


def test_one_cell_that_flows_is_not_arrest() -> None:
    seen = fields(np.zeros(FRAMES))
    seen["plastic_rate"][-1, 2] = RATE
    assert not is_arrested(scene_of(), seen["plastic_rate"])


@pytest.mark.parametrize(("frame", "arrested"), [(-6, True), (-5, False), (-1, False)])
def test_arrest_lasts_for_the_stated_time(frame: int, arrested: bool) -> None:
    """The last tenth of forty intervals is the last five frames."""
    assert pytest.approx(0.1) == ARREST_TIME
    rate = np.zeros(FRAMES)
    rate[frame] = RATE
    assert is_arrested(scene_of(), fields(rate)["plastic_rate"]) is arrested


def shaken(cycles: int) -> Scene:
    """The scene of the other tests, shaken so many times."""
    scene = scene_of()
    return scene.replace({"load.shake": 0.5, "load.shake_frequency": f"{cycles / scene.run.duration!r} Hz"})


@pytest.mark.parametrize(("cycles", "arrested"), [(3, False), (8, True)])
def test_shaken_flow_must_die_out_for_a_whole_period(cycles: int, arrested: bool) -> None:
    """One that flowed at 0.85 of the run: within the last of three periods, and before the last of eight."""
    rate = np.zeros(FRAMES)
    rate[-7] = RATE
    assert is_arrested(shaken(cycles), fields(rate)["plastic_rate"]) is arrested
    assert is_arrested(scene_of(), fields(rate)["plastic_rate"])


def test_what_shakes_is_never_called_arrested() -> None:
    still, scene = fields(np.zeros(FRAMES)), shaken(20)
    assert regime_of(scene, choose_effects(scene), still, SINKING) == "shaken"
    flowing = fields(np.full(FRAMES, 2 * RATE))
    assert regime_of(scene, choose_effects(scene), flowing, SINKING) == "descending"
    calm = fields(np.zeros(FRAMES), yielded=0.0, lost=0.0)
    assert regime_of(scene, choose_effects(scene), calm, SINKING) == "no-yield"


def test_a_single_frame_can_be_judged() -> None:
    assert is_arrested(scene_of(), np.zeros((1, CELLS)))
    assert not is_arrested(scene_of(), np.full((1, CELLS), RATE))


def test_how_far_the_midpoint_turned_back() -> None:
    assert turned_back(np.array([0.0, -1.0, -2.0])) == 0
    assert turned_back(np.array([0.0, -2.0, -1.5, -1.8])) == pytest.approx(0.25)
    assert turned_back(np.array([0.0, -1.0, -0.5, -4.0])) == pytest.approx(0.125)
    assert turned_back(np.zeros(3)) == 0
    assert 0 < TURNED_BACK < 0.25


@pytest.mark.parametrize(("law", "regime"), [("elastic", "elastic"), ("maxwell", "viscous"), ("bingham", "descending")])
def test_labels_of_real_runs(law: str, regime: str) -> None:
    assert run(law).summary["regime"] == regime


@pytest.mark.parametrize("section", ["rectangle", "circle"])
def test_a_filament_too_strong_to_yield(section: str) -> None:
    strong = simulate(scene_of(material={"yield_stress": "1 MPa"}, filament={"section": section}))
    assert strong.summary["regime"] == "no-yield"
    assert float(strong.data["energy_dissipated"][-1]) == 0
    assert float(strong.data["yielded_fraction"].max()) == 0


def profile(half: list[float]) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    stretch = 1 + np.array(half[::-1] + half)
    return stretch, np.full(len(stretch), 0.1)


def test_smooth_profiles_are_not_localised() -> None:
    for half in ([0.1] * 10, list(np.linspace(0.0, 0.3, 10)), list(np.exp(np.linspace(-3, 0, 10)) / 10)):
        assert largest_share_of_one_cell(*profile(half)) < SHARE_OF_ONE_CELL


def test_all_strain_in_one_cell_is_one() -> None:
    assert largest_share_of_one_cell(*profile([0.0] * 9 + [2.0])) == pytest.approx(1)
    assert largest_share_of_one_cell(*profile([0.0, 0.0, 2.0, 0.0])) == pytest.approx(1)


def test_half_the_strain_in_the_cell_at_the_clamp() -> None:
    share = largest_share_of_one_cell(*profile([0.1] * 9 + [1.0]))
    assert share == pytest.approx(0.9 / 1.9)
    assert share > SHARE_OF_ONE_CELL


def test_one_half_is_enough() -> None:
    stretch, length = profile([0.1] * 10)
    stretch[0] += 5
    assert largest_share_of_one_cell(stretch, length) == pytest.approx(5 / 6)
    assert largest_share_of_one_cell(stretch[::-1], length) == pytest.approx(5 / 6)


def test_no_stretch_and_compression_are_no_neck() -> None:
    assert largest_share_of_one_cell(*profile([0.0] * 5)) == 0
    assert largest_share_of_one_cell(*profile([-0.1] * 4 + [-0.05])) == 0


def test_the_measure_does_not_depend_on_units_of_length() -> None:
    stretch, length = profile([0.1] * 9 + [0.7])
    in_metres, in_millimetres = (largest_share_of_one_cell(stretch, unit * length) for unit in (1.0, 1e3))
    assert in_metres == pytest.approx(in_millimetres)


ENERGY = (
    "energy_kinetic",
    "energy_elastic",
    "energy_potential",
    "energy_dissipated",
    "work_external",
    "energy_gradient",
    "energy_surface",
)


def energies(*rows: list[float]) -> dict[str, np.ndarray[Any, Any]]:
    """Rows in the order of ENERGY; what is not given is zero."""
    given = [np.array(row) for row in rows]
    absent = [np.zeros(len(given[0]))] * (len(ENERGY) - len(given))
    return dict(zip(ENERGY, [*given, *absent], strict=True))


def test_a_closed_balance_has_no_residual() -> None:
    assert energy_residual(energies([0, 1, 2], [0, 2, 1], [0, -4, -5], [0, 1, 3], [0, 0, 1])) == 0


def test_the_residual_is_relative_to_the_largest_energy() -> None:
    assert energy_residual(energies([0, 1], [0, 2], [0, -4], [0, 1.1], [0, 0])) == pytest.approx(0.1 / 4)
    assert energy_residual(energies([0, 1], [0, 2], [0, -4], [0, 1], [0, 8])) == pytest.approx(1)


def test_work_against_the_gradient_counts() -> None:
    assert energy_residual(energies([0, 1], [0, 0], [0, -3], [0, 1], [0, 0], [0, 1])) == 0


def test_the_worst_moment_counts() -> None:
    assert energy_residual(energies([0, 1, 0], [0, 0, 0], [0, 0, -4], [0, 0, 4], [0, 0, 0])) == pytest.approx(0.25)


def test_what_was_there_at_the_start_is_no_imbalance() -> None:
    assert energy_residual(energies([0, 0], [5, 5], [-1, -1], [0, 0], [0, 0])) == 0


def test_no_energy_at_all() -> None:
    assert energy_residual(energies(*[[0, 0]] * 5)) == 0


def test_a_balance_that_does_not_close_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    from softcat_sym.results import trajectory

    monkeypatch.setattr(trajectory, "energy_residual", lambda fields, least: 0.5)
    drifted = simulate(scene_of())
    assert drifted.outcome is Outcome.energy_drift
    assert "0.5" in drifted.summary["message"]
    # the printed closure has no energy to be judged by
    assert simulate(scene_of(run={"closure": "printed"})).outcome is Outcome.solved


def test_an_effect_that_the_user_left_out_is_no_failure() -> None:
    """Finite stretch without thinning has no stored energy whose gradient the force is: reported, not failed."""
    for absent in [(), ("thinning",), ("finite-stretch",), ("thinning", "finite-stretch")]:
        soft = scene_of("elastic", material={"youngs_modulus": "0.1 MPa"}, run={"duration": "0.3 s"})
        names = [name for name in choose_effects(soft.replace({"run.effects": "paper"})).names if name not in absent]
        assert simulate(soft.replace({"run.effects": names})).outcome is Outcome.solved


def test_a_neck_is_worse_than_any_other_verdict(monkeypatch: pytest.MonkeyPatch) -> None:
    from softcat_sym.results import verdict

    monkeypatch.setattr(verdict, "neck_that_the_grid_decides", lambda stretch, length, neck: "a neck at X")
    necked = simulate(scene_of())
    assert necked.outcome is Outcome.localised
    assert "a neck at X" in necked.summary["message"]


@pytest.mark.parametrize("cells", [10, 40, 160])
def test_the_strain_of_a_neck_does_not_depend_on_the_grid(cells: int) -> None:
    """A hinge at each clamp that opens by a given length: spread over a neck, whatever the cells."""
    length = np.full(2 * cells, 0.5 / cells)
    stretch = np.full(2 * cells, 1.02)
    neck, opening = 0.04, 0.012
    near = max(1, round(neck / 2 / length[0]))
    for end in (slice(None, near), slice(-near, None)):
        stretch[end] += opening / (near * length[0])
    assert neck_strain(stretch, length, neck) == pytest.approx(opening / neck, rel=0.02)


@pytest.mark.parametrize(("opening", "refused"), [(0.39, False), (0.41, True)])
def test_the_gradient_spreads_a_hinge_until_it_is_drawn_out(opening: float, refused: bool) -> None:
    stretch, length = profile([0.0] * 9 + [opening])
    message = neck_that_the_grid_decides(stretch, length, length[0])
    assert bool(message) is refused
    assert ("X/L = " in message) is refused
    assert "carries 100%" in neck_that_the_grid_decides(stretch, length, None)


def test_a_filament_that_stretches_smoothly_has_no_neck() -> None:
    where = np.linspace(-1, 1, 80)
    assert neck_strain(1 + 0.3 * where**2, np.full(80, 0.01), 0.02) < 0.05


def test_a_viscous_thread_that_thins_at_its_clamps_is_not_refused() -> None:
    """Without a yield stress a neck only grows with the strain itself, and the sag does not depend on the grid."""
    coarse = {"run.accuracy": 1e-5, "numerics.cells": 12, "numerics.estimate": False, "run.frames": 21}
    run = simulate(load_scene("silicone-thread", coarse))
    assert "necking-gradient" in run.summary["effects"]
    assert float(run.data.stretch.values[-1].max()) > 3
    assert run.outcome is Outcome.solved


TIME = np.linspace(0, 1, 11)


def test_surface_tension_left_out_by_name_is_told() -> None:
    """Where it is in force, or is nothing beside the weight, not a word is lost on it."""
    thin = {
        "filament": {"span": "5 mm", "thickness": "0.2 mm"},
        "run": {"duration": "5 ms", "effects": "paper"},
        "load": {"ramp": "2 ms"},
        "surroundings": {"surface_tension": "0.5 N/m"},
    }
    (text,) = simulate(scene_of("elastic", **thin)).summary["warnings"]
    assert "surface tension is left out by run.effects, but would take about" in text
    thin["run"] = {"duration": "5 ms"}
    taken = simulate(scene_of("elastic", **thin))
    assert "surface-tension" in taken.summary["effects"]
    assert taken.summary["warnings"] == []
    small = simulate(scene_of(surroundings={"surface_tension": "0.2 mN/m"}))
    assert "surface-tension" in small.summary["left_out"]
    assert small.summary["warnings"] == run().summary["warnings"] == []


def test_a_trajectory_is_frozen() -> None:
    with pytest.raises(dataclasses.FrozenInstanceError):
        run().outcome = Outcome.localised  # type: ignore[misc]


def test_cells_of_a_hinge_graded_too_short_by_hand_are_warned_of() -> None:
    for by_hand in [True, False]:
        for of_the_limit in [0.8, 1.3]:
            scene = load_scene("arrested-underdamped", {"numerics.grading": 100} if by_hand else {})
            shortest = of_the_limit * SHORTEST_CELL * scene.filament.thickness
            half = rest_length(scene) / 2
            nodes = np.array([-half, -half + shortest, 0.0, half - shortest, half])
            for yielded in (1.0, 0.2):
                fields = {"yielded_fraction": np.full((2, 4), yielded)}
                warnings = warnings_of(scene, choose_effects(scene), 0.0, nodes, fields, 0.0)
                expected = by_hand and of_the_limit < 1 and yielded > 0.5
                assert ["numerics.grading" in text for text in warnings] == [True] * expected
