"""Runs that end by themselves, at a limit or by Ctrl-C: each says so, and writes what it has."""

from __future__ import annotations

import json
import signal
import threading
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.cli.overview import COMMANDS, INSTANT
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.solvers.compiled import CompiledIntegration
from softcat_sym.solvers.solution import Silence
from tests.common.in_process import Softcat, sets

CASES = Path(__file__).parent / "cases"
CONCRETE = CASES / "runaway-concrete.toml"
COARSE = ("numerics.cells=10",)


def test_what_nothing_holds_falls_until_its_strain_cannot_come_back(softcat: Softcat, tmp_path: Path) -> None:
    """The rate at the end is that of the midpoint in the trajectory, where the largest stretch is a hundred."""
    done = softcat("run", str(CONCRETE), "-q", "--no-pictures", "-o", str(tmp_path), *sets(*COARSE))
    assert done.status == 1 and done.err.startswith("softcat: descends: it falls for ever")
    run, summary = sc.open_run(tmp_path), json.loads((tmp_path / "summary.json").read_text())
    time, midpoint, end = run.fields["time"], run.fields["midpoint"], summary["descends"]
    assert run.outcome is sc.Outcome.descends and 190 < len(time) <= 201
    assert np.allclose(np.diff(time), time[-1] / (len(time) - 1))
    assert (end["time_s"], end["midpoint_m"]) == (time[-1], midpoint[-1])
    # A parabola through the last frames, on times from the end.
    rate = np.polyfit(time[-5:] - time[-1], midpoint[-5:], 2)[1]
    assert end["rate_m_per_s"] == pytest.approx(rate, rel=1e-3)
    assert 95 < run.fields["stretch"].max() < 110


@pytest.mark.parametrize("backend", ["compiled", "interpreted"])
def test_a_viscous_thread_falls_ten_spans(backend: str) -> None:
    """Without a yield stress nothing holds it, and the fall ends at ten spans, to the distance of a step or frame."""
    if backend == "compiled" and find_compiler() is None:
        pytest.skip("no C compiler")
    asked = {"run.duration": "1 h", "run.frames": 20_001, "numerics.backend": backend, "numerics.cells": 6}
    scene = sc.load_scene("cold-honey", asked | {"run.effects": "paper", "numerics.estimate": False})
    run = sc.simulate(scene)
    assert run.outcome is sc.Outcome.descends and run.scene.run.duration == 3600
    assert -10.5 < run.fields["midpoint"][-1] / scene.filament.span < -9.9


def test_members_of_an_ensemble_end_as_single_runs_do() -> None:
    scene = sc.load_scene(CONCRETE, COARSE).replace({"run.frames": 1001, "numerics.estimate": False})
    ensemble = sc.simulate_many(
        scene, {"material.yield_stress": ["1 kPa", "100 kPa"], "run.duration": ["20 s", "0.1 s"]}
    )
    assert [outcome.name for outcome in ensemble.outcomes] == ["descends", "solved"]
    single = sc.simulate(ensemble.scenes[0])
    reached = np.flatnonzero(np.isfinite(ensemble.data.midpoint.values[0]))[-1] * 0.02
    assert reached <= single.summary["descends"]["time_s"] < reached + 0.02 + 1e-3


@pytest.mark.parametrize(("limit", "duration"), [("1 kPa", "0.2 s"), ("3 kPa", "1 s")])
def test_what_stops_or_has_not_fallen_far_is_no_endless_fall(limit: str, duration: str) -> None:
    """The second has G = 0.83, which a catenary bears."""
    changes = {"material.shear_yield_stress": limit, "run.duration": duration, "numerics.estimate": False}
    run = sc.simulate(sc.load_scene(CONCRETE, COARSE).replace(changes))
    assert run.outcome is not sc.Outcome.descends and run.summary["descends"] is None


LONG = sets("run.duration=10 min", "run.frames=20001", "numerics.cells=20")


class FromFirstStep(threading.Timer):
    """A limit that counts from where the integration begins: a machine may take long to get there."""

    begun = threading.Event()

    def run(self) -> None:
        self.begun.wait()
        super().run()


def test_a_limit_leaves_what_a_run_has_computed(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What a run of the time that was reached computes, too; modules are loaded before, which a limit may interrupt."""
    brief = {"run.duration": "1.5 s", "run.frames": 51, "numerics.estimate": False}
    whole = sc.simulate(sc.load_scene("no-yield", LONG[1::2]).replace(brief))
    asked = ("run", "no-yield", "-q", "--no-pictures", "-o", str(tmp_path / "out"), *LONG)
    integrate = CompiledIntegration.run
    monkeypatch.setattr(CompiledIntegration, "run", lambda *given: FromFirstStep.begun.set() or integrate(*given))
    monkeypatch.setattr("softcat_sym.interrupts.threading.Timer", FromFirstStep)
    done = softcat(*asked, "--time-limit", "2")
    run = sc.open_run(tmp_path / "out")
    assert done.status == 1 and "the time limit of 2 s is over; what was computed is in" in done.err
    assert run.outcome is sc.Outcome.interrupted and run.summary["error_estimate"] is None
    assert 0 < run.summary["time_final_s"] == run.fields["time"][-1] < 600
    both = min(51, len(run.fields["time"]))
    assert np.allclose(whole.fields["midpoint"][:both], run.fields["midpoint"][:both], rtol=0, atol=0.02 * 0.008)


@pytest.mark.parametrize("seconds", ["0", "-3", "nan", "inf", "soon"])
@pytest.mark.parametrize("command", ["run", "explain", "fit"])
def test_what_is_no_limit_is_refused(softcat: Softcat, command: str, seconds: str) -> None:
    done = softcat(command, "no-yield", "--time-limit", seconds, *(["--scene", "no-yield"] if command == "fit" else []))
    assert done.status == 2 and "--time-limit" in done.err


def test_every_command_that_computes_has_a_limit(softcat: Softcat) -> None:
    names = [name for group in COMMANDS.values() for name in group]
    assert [name for name in names if "--time-limit" not in softcat(name, "--help").out] == [*INSTANT]


def test_whoever_stops_a_run_in_python_has_what_there_is(monkeypatch: pytest.MonkeyPatch) -> None:
    class Impatient(Silence):
        def update(self, simulated_time: float, step_size: float | None) -> None:
            if simulated_time > 0.2:
                signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr("softcat_sym.solvers.compiled._LOOK", 0.001)
    scene = sc.load_scene("no-yield", LONG[1::2])
    with pytest.raises(KeyboardInterrupt) as stopped:
        sc.simulate(scene, progress=Impatient())
    run = stopped.value.part()  # type: ignore[attr-defined]
    assert run.outcome is sc.Outcome.interrupted and 0 < run.fields["time"][-1] < 600
