"""Runs that end by themselves, at a limit or by Ctrl-C: each says so, and writes what it has."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
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
