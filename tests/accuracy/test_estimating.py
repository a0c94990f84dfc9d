"""Runs that are estimated and refined: against closed forms, and against the same filament on a much finer grid."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from softcat_sym import Scene, load_scene, simulate
from softcat_sym.error_control import control as refining
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.simulate import without_estimate

BEAM_SAG = 1 / 32
"""Of a rectangular beam between clamps, over rho g L^4/(E h0^2): the largest by beam theory, at midspan."""

HONEY = {"run.frames": 21}


def beam(accuracy: float, **numerics: object) -> Scene:
    """A beam at rest that sags a thousandth of its span."""
    span, thickness, weight = 1.0, 0.02, 1e4
    modulus = BEAM_SAG * weight * span**4 / thickness**2 / 1e-4
    return Scene.model_validate(
        {
            "filament": {"span": f"{span} m", "thickness": f"{thickness} m", "density": "1000 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": f"{modulus!r} Pa"},
            "load": {"gravity": "10 m/s^2", "ramp": "1 s"},
            "run": {"duration": "1 s", "frames": 3, "effects": ["bending"], "accuracy": accuracy},
            "numerics": numerics,
        }
    )


@cache
def honey(accuracy: float, **numerics: object) -> Trajectory:
    """A Newtonian thread at an accuracy."""
    changes = HONEY | {"run.accuracy": accuracy} | {f"numerics.{name}": value for name, value in numerics.items()}
    return simulate(load_scene("cold-honey", changes))


def test_the_estimate_of_a_beam_is_its_error() -> None:
    run = simulate(beam(0.1, cells=40))
    true = abs(float(run.data.midpoint[-1]) / -1e-4 - 1)
    estimate = run.summary["error_estimate"]
    assert run.outcome.is_success
    assert estimate["space"] == pytest.approx(true, rel=0.1)
    assert estimate["section"] is None
    assert estimate["total"] == estimate["space"] + estimate["time"]


def test_a_beam_is_refined_until_it_is_as_accurate_as_was_asked() -> None:
    for accuracy in (1e-3, 1e-4, 1e-5):
        run = simulate(beam(accuracy))
        assert run.outcome.is_success, run.summary["message"]
        assert abs(float(run.data.midpoint[-1]) / -1e-4 - 1) < accuracy
    assert run.summary["refinements"]
    assert run.summary["cells"] == run.summary["resolution"]["cells"] > 40


@pytest.mark.parametrize("accuracy", [1e-3, 1e-5])
def test_a_run_is_as_near_a_finer_one_as_its_estimate_says(accuracy: float) -> None:
    run = honey(accuracy)
    at = run.summary["resolution"]
    finer = {"numerics.cells": 4 * at["cells"], "numerics.grading": at["grading"], "numerics.rtol": at["rtol"] / 50}
    best = simulate(without_estimate(run.scene.replace(finer)))
    true = float(np.max(np.abs(run.data.midpoint - best.data.midpoint)) / np.max(np.abs(best.data.midpoint)))
    assert true < accuracy
    assert 0.3 < true / run.summary["error_estimate"]["total"] < 3


def test_what_the_user_fixed_is_kept_and_told() -> None:
    run = honey(1e-5, cells=12)
    assert run.outcome.is_success
    assert run.summary["cells"] == 12
    assert any("numerics.cells" in warning for warning in run.summary["warnings"])


@pytest.mark.parametrize(("times", "outcome"), [(0.9, "solved"), (1.5, "solved"), (2.5, "inaccurate")])
def test_an_accuracy_missed_by_little_is_an_answer(times: float, outcome: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a beam that may have no more cells: with a warning up to twice the accuracy, and no advice that is no use."""
    monkeypatch.setattr(refining, "MAX_CELLS", 1)
    error = simulate(beam(1e-4)).summary["error_estimate"]["total"]
    run = simulate(beam(error / times))
    assert run.outcome.name == outcome
    assert not run.summary["refinements"]
    told = [text for text in (*run.summary["warnings"], run.summary["message"]) if "accuracy" in text]
    assert len(told) == (times > 1)
    assert not any("leave out" in text or "by hand" in text for text in (*told, run.summary["advice"]))
    if times == 1.5:
        assert told == [f"accuracy {error:.2g} instead of {error / times:g}"]


@pytest.mark.slow
def test_a_hinge_that_necks_as_the_grid_lets_it_is_no_success() -> None:
    by_hand = {"numerics.cells": 80, "numerics.grading": 10, "numerics.fibres": 8}
    run = simulate(load_scene("arrested-underdamped", by_hand))
    assert run.outcome.name == "inaccurate"
    assert "numerics.grading" in run.summary["message"]


def test_what_cannot_be_reached_is_inaccurate(monkeypatch: pytest.MonkeyPatch) -> None:
    from softcat_sym.error_control import control as refining

    monkeypatch.setattr(refining, "MAX_CELLS", 40)
    run = simulate(load_scene("cold-honey", HONEY | {"run.accuracy": 1e-6}))
    assert run.outcome.name == "inaccurate"
    assert run.summary["regime"] is None
    assert "1e-06" in run.summary["message"]


def test_without_an_estimate_nothing_runs_beside() -> None:
    run = simulate(without_estimate(load_scene("cold-honey", HONEY)))
    assert run.summary["error_estimate"] is None
    assert run.summary["wall_s"]["estimate"] == 0


def test_companions_count_under_estimate() -> None:
    wall = honey(1e-3).summary["wall_s"]
    assert wall["estimate"] > 0
    assert wall["total"] == pytest.approx(sum(seconds for stage, seconds in wall.items() if stage != "total"))
