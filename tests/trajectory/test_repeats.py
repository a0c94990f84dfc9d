"""A run is repeated with what it shows to have been overlooked: once or twice, and never where effects are named."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from softcat_sym import clock, load_scene, simulate
from softcat_sym.effects import choosing
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.forecast import forecast
from softcat_sym.results import trajectory
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import Outcome

WEIGHT, ACCURACY = 1e4, 0.01
FORESEES_NOTHING = dict.fromkeys(
    ("tension_share", "sheared", "relaxed", "strain", "slope", "missed", "swings", "risen", "folds"), 0.0
)


def beam(thickness: float, sag: float, law: str = "elastic", effects: Any = "auto") -> Scene:
    """A beam between clamps, span 1 m, that is loaded slowly and sags so far; a Maxwell fluid relaxes in 3 s."""
    E = WEIGHT / (32 * thickness**2 * sag)
    viscosity = {"viscosity": f"{3 * E!r} Pa*s"} if law == "maxwell" else {}
    return Scene.model_validate(
        {
            "filament": {"span": "1 m", "thickness": f"{thickness!r} m", "density": "1000 kg/m^3"},
            "material": {"law": law, "youngs_modulus": f"{E!r} Pa", **viscosity},
            "load": {"gravity": "10 m/s^2", "ramp": "0.5 s"},
            "run": {"duration": "1 s", "frames": 5, "effects": effects, "accuracy": ACCURACY},
            "numerics": {"cells": 20, "estimate": False},
        }
    )


def blind(monkeypatch: pytest.MonkeyPatch, *numbers: str) -> None:
    """What is foreseen of the effects is nothing; what is seen is seen all the same."""
    nothing = dict.fromkeys(numbers, 0.0)
    monkeypatch.setattr(choosing, "forecast", lambda scene: dataclasses.replace(forecast(scene), **nothing))


CASES = {
    "extensibility": (beam(0.01, 0.005), ("tension_share",)),
    "shear": (beam(0.1, 0.001), ("sheared",)),
    "viscous-flow": (beam(0.01, 1e-4, "maxwell"), ("relaxed",)),
}


@pytest.mark.parametrize("effect", CASES)
def test_what_a_run_shows_to_matter_is_taken_in(effect: str, monkeypatch: pytest.MonkeyPatch) -> None:
    scene, numbers = CASES[effect]
    foresighted = simulate(scene)
    assert foresighted.summary["repeats"] == []
    assert effect in foresighted.summary["effects"]
    blind(monkeypatch, *numbers)
    assert effect not in choose_effects(scene).names
    done = simulate(scene)
    print(done.summary["repeats"])
    assert done.outcome is Outcome.solved
    (text,) = done.summary["repeats"]
    assert text.startswith(f"{effect}: the run without it shows that it is worth")
    assert text.removeprefix(f"{effect}: ") in done.summary["effects"][effect]
    assert done.summary["warnings"] == []
    assert effect not in done.summary["checked"]
    assert done.missing_effect == {}
    # Whichever way it was chosen, it is the same filament.
    assert list(done.summary["effects"]) == list(foresighted.summary["effects"])
    assert_same(done, foresighted)


def assert_same(first: Trajectory, second: Trajectory) -> None:
    """Every number of the two is the same."""
    for name in first.data.data_vars:
        np.testing.assert_array_equal(first.data[name].values, second.data[name].values, err_msg=str(name))


def test_the_answer_is_that_of_the_named_effects(monkeypatch: pytest.MonkeyPatch) -> None:
    scene, numbers = CASES["extensibility"]
    blind(monkeypatch, *numbers)
    done = simulate(scene)
    named = simulate(scene.replace({"run.effects": list(done.summary["effects"])}))
    assert named.summary["repeats"] == []
    assert_same(done, named)
    # and not that of the run which overlooked it
    trial = simulate(scene.replace({"run.effects": list(choose_effects(scene).names)}))
    assert float(done.data["midpoint"][-1] / trial.data["midpoint"][-1]) < 0.9


@pytest.mark.parametrize("named", [["bending", "gravity-ramp"], ["inertia", "bending", "gravity-ramp"]], ids=len)
def test_named_effects_are_never_repeated(named: list[str]) -> None:
    done = simulate(beam(0.01, 0.005, effects=named))
    assert done.summary["checked"]["extensibility"] > 10 * ACCURACY
    assert done.outcome is Outcome.solved
    assert done.summary["repeats"] == []
    assert list(done.summary["effects"]) == named


def test_the_paper_s_list_is_not_repeated() -> None:
    done = simulate(beam(0.1, 0.001, effects="paper"))
    assert done.summary["checked"]["shear"] > 10 * ACCURACY
    assert done.outcome is Outcome.solved
    assert done.summary["repeats"] == []


def test_the_trial_is_no_part_of_the_accepted_run_s_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """A clock that strikes once whenever it is read: one each for building and solving, two for the trial."""
    ticks: Iterator[float] = iter(map(float, range(100)))
    monkeypatch.setattr(clock.time, "perf_counter", lambda: next(ticks))
    scene, numbers = CASES["extensibility"]
    scene = scene.replace({"numerics.backend": "interpreted"})
    without = simulate(scene).summary["wall_s"]
    assert (without["build"], without["solve"], without["estimate"], without["total"]) == (1, 1, 0, 2)
    blind(monkeypatch, *numbers)
    wall = simulate(scene).summary["wall_s"]
    assert (wall["build"], wall["solve"], wall["estimate"], wall["total"]) == (1, 1, 2, 4)


def test_two_repeats_are_worth_a_warning(monkeypatch: pytest.MonkeyPatch) -> None:
    """What flows only shows how late its load comes once it flows."""
    blind(monkeypatch, *FORESEES_NOTHING)
    scene = beam(0.01, 1e-4, "maxwell")
    told = iter([{"viscous-flow": "seen first"}, {"gravity-ramp": "seen then"}, {}])
    monkeypatch.setattr(trajectory, "missing_effect", lambda *_: next(told))
    done = simulate(scene)
    assert done.outcome is Outcome.solved
    assert done.summary["repeats"] == ["viscous-flow: seen first", "gravity-ramp: seen then"]
    assert {"viscous-flow", "gravity-ramp"} < set(done.summary["effects"])
    (warning,) = done.summary["warnings"]
    assert "repeated 2 times" in warning


def test_what_is_overlooked_after_two_repeats_is_no_success(monkeypatch: pytest.MonkeyPatch) -> None:
    blind(monkeypatch, *FORESEES_NOTHING)
    order = ("viscous-flow", "gravity-ramp", "extensibility", "shear")
    runs: list[tuple[str, ...]] = []

    def always_one_more(scene: Scene, effects: Any, *_: Any) -> dict[str, str]:
        runs.append(effects.names)
        return {order[len(runs) - 1]: "there something = 0.3"}

    monkeypatch.setattr(trajectory, "missing_effect", always_one_more)
    done = simulate(beam(0.01, 1e-4, "maxwell"))
    assert len(runs) == 3
    assert [set(later) - set(earlier) for earlier, later in pairwise(runs)] == [
        {"viscous-flow"},
        {"gravity-ramp"},
    ]
    assert done.outcome is Outcome.missing_effect
    assert not done.outcome.is_success
    assert done.summary["outcome"] == done.data.attrs["outcome"] == "missing_effect"
    assert done.summary["regime"] is None
    assert done.summary["message"] == "extensibility: there something = 0.3"
    assert "run.effects" in done.summary["advice"]
    assert len(done.summary["repeats"]) == 2
    assert len(done.summary["warnings"]) == 1


def test_a_run_that_fails_without_bending_is_repeated_with_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """A straight string without inertia has nothing to begin with; its accuracy of 20 % does not ask for bending."""
    honey = load_scene("cold-honey", {"run.accuracy": 0.2, "filament.thickness": "0.2 mm"})
    blind(monkeypatch, "missed", "swings")
    assert not {"inertia", "bending"} & set(choose_effects(honey).names)
    done = simulate(honey)
    assert done.outcome is Outcome.solved
    (text,) = done.summary["repeats"]
    assert "bending: the run without it failed" in text
    assert "bending" in done.summary["effects"]
    assert_same(done, simulate(honey.replace({"run.effects": list(done.summary["effects"])})))


def test_sections_that_find_no_angle_are_given_their_inertia() -> None:
    """A soft shear-thinning thread drawn down by a mass: without rotary inertia its section angles are algebraic."""
    thread = Scene.model_validate(
        {
            "filament": {"span": "3.73 m", "thickness": "91 mm", "width": "66 mm", "density": "3772 kg/m^3"},
            "material": {
                "law": "power-law",
                "youngs_modulus": "793.5 kPa",
                "viscosity": "107.2 MPa*s**0.862",
                "index": 0.862,
                "poisson": 0.397,
            },
            "ends": {"left_angle": "-9.5 deg", "right_angle": "7.6 deg"},
            "load": {"gravity": "4.546 m/s^2", "point_mass": "93.8 kg"},
            "run": {"duration": "6.6 s", "frames": 7, "accuracy": 0.1},
            "numerics": {"cells": 11, "estimate": False},
        }
    )
    run, finer = simulate(thread), simulate(thread.replace({"run.accuracy": 0.01}))
    assert run.outcome is Outcome.solved
    assert run.summary["repeats"] == ["rotary-inertia: the run without it failed"]
    assert finer.outcome is Outcome.solved
    assert run.summary["midpoint_final_m"] == pytest.approx(finer.summary["midpoint_final_m"], rel=0.05)
