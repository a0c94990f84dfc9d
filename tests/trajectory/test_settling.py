"""A run that ends when nothing moves any more, and the height about which a filament rings at last."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from softcat_sym import simulate
from softcat_sym.error_control.estimate import Judge
from softcat_sym.results.motion import STRIDE, period_of, ringing_of, still_to_move
from softcat_sym.scene.scene import Scene

ACCURACY = 0.01


def strand(*, backend: str = "compiled", run: dict[str, Any] | None = None, **material: Any) -> Scene:
    return Scene.model_validate(
        {
            "filament": {"span": "20 mm", "diameter": "1 mm", "density": "1050 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "450 kPa", "loss_tangent": 0.1, **material},
            "run": {"duration": "3 s", "frames": 41, "accuracy": ACCURACY, "until": "settled", **(run or {})},
            "numerics": {"estimate": False, "cells": 16, "backend": backend},
        }
    )


@pytest.mark.parametrize("backend", ["interpreted", "compiled"])
def test_a_damped_strand_ends_early_at_its_static_sag(backend: str) -> None:
    run = simulate(strand(backend=backend))
    still = simulate(strand(run={"until": "duration"}))
    settled = run.summary["settled_s"]
    assert settled is not None
    assert settled < 1
    assert run.summary["time_final_s"] == pytest.approx(settled)
    times = run.data.time.values
    np.testing.assert_allclose(np.diff(times), times[-1] / 40)
    largest = float(np.max(np.abs(run.data.midpoint)))
    rests = float(still.data.midpoint[-1])
    assert abs(float(run.data.midpoint[-1]) - rests) < ACCURACY * largest
    assert run.summary["midpoint_settled_m"]["mean"] == pytest.approx(rests, abs=1e-3 * largest)
    assert run.summary["midpoint_settled_m"]["amplitude"] < ACCURACY * largest
    # What is asked is what is kept, and it is a scene.
    assert run.scene.run.until == "settled"
    assert 'until = "settled"' in run.scene.to_toml()


def test_an_error_is_estimated_of_a_run_that_settles() -> None:
    scene = strand().replace({"numerics.estimate": True, "numerics.cells": None})
    run = simulate(scene)
    assert run.outcome.is_success
    assert run.summary["error_estimate"]["total"] < ACCURACY
    assert run.summary["time_final_s"] == pytest.approx(run.summary["settled_s"])


def test_an_undamped_strand_runs_on_and_tells_its_mean_and_amplitude() -> None:
    run = simulate(strand(loss_tangent=0.0, run={"duration": "0.8 s", "frames": 1601}))
    sparse = simulate(strand(loss_tangent=0.0, run={"duration": "0.8 s", "frames": 77}))
    for one in (run, sparse):
        assert one.summary["settled_s"] is None
        assert one.summary["time_final_s"] == pytest.approx(0.8)
    dense, told = run.summary["midpoint_settled_m"], sparse.summary["midpoint_settled_m"]
    # 77 frames over 38 periods would show an amplitude and a mean of their own.
    assert told["mean"] == pytest.approx(dense["mean"], rel=0.01)
    assert told["amplitude"] == pytest.approx(dense["amplitude"], rel=0.02)
    rests = float(simulate(strand()).summary["midpoint_settled_m"]["mean"])
    assert dense["mean"] == pytest.approx(rests, rel=0.1)
    assert dense["amplitude"] == pytest.approx(abs(rests), rel=0.2)


@pytest.mark.parametrize("backend", ["interpreted", "compiled"])
def test_a_creeping_strand_does_not_end_early(backend: str) -> None:
    """In 20 s it flows by three times its elastic sag, but hardly at all in the time in which its ringing ends."""
    run = simulate(strand(backend=backend, law="maxwell", viscosity="4500 kPa*s", run={"duration": "20 s"}))
    assert run.summary["settled_s"] is None
    assert run.summary["time_final_s"] == pytest.approx(20)


def test_what_flows_too_little_to_matter_has_settled() -> None:
    scene = strand(law="maxwell", viscosity="4500 MPa*s", run={"duration": "5 s"})
    effects = ["inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "solid-damping"]
    run = simulate(scene.replace({"run.effects": [*effects, "viscous-flow"]}))
    assert run.summary["settled_s"] is not None
    assert run.summary["settled_s"] < 1


def test_without_inertia_it_has_settled_when_the_load_is_there() -> None:
    static = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "gravity-ramp"]
    scene = strand(run={"effects": static}).replace({"load.ramp": "0.5 s", "numerics.backend": None})
    run = simulate(scene)
    assert run.summary["settled_s"] == pytest.approx(0.5)
    assert run.summary["midpoint_settled_m"] == {"mean": run.summary["midpoint_final_m"], "amplitude": 0.0}


def test_a_run_shorter_than_a_period_says_why_it_has_no_mean() -> None:
    run = simulate(strand(run={"duration": "5 ms", "until": "duration"}))
    assert run.summary["midpoint_settled_m"] is None
    assert "shorter than one period" in run.summary["midpoint_settled_why"]


def test_the_mean_does_not_depend_on_the_phase() -> None:
    for cycles in [5.0, 4.3, 7.71]:
        for phase in [0.0, 1.0, 2.5]:
            time = np.linspace(0, 1, 201)
            found = ringing_of(-2.0 + 0.7 * np.cos(2 * math.pi * cycles * time + phase))
            assert found.mean == pytest.approx(-2.0, abs=0.01)
            assert found.amplitude == pytest.approx(0.7, rel=0.03)


def test_what_only_drifts_has_its_last_height_as_mean() -> None:
    found = ringing_of(np.linspace(-1.0, -1.1, 50))
    assert found.mean == -1.1
    assert found.amplitude < 1e-12


CREEP: dict[str, Callable[[float], float]] = {
    "logarithm": lambda t: 0.01 * math.log(t),
    "cube root": lambda t: 0.02 * t ** (1 / 3),
    "exponential": lambda t: 1 - math.exp(-t / 2),
    "late stop": lambda t: 1 - 1 / t,
    "constant rate": lambda t: 1e-3 * t,
}


def test_what_is_foreseen_is_no_less_than_what_comes() -> None:
    for name in list(CREEP):
        for end in [30.0, 1e3, 1e5]:
            move, noise, longest = CREEP[name], 1e-6, 0
            for n in range(60):
                t = 1.5 * STRIDE**n
                if t > end:
                    break
                means = [move(t / STRIDE**2), move(t / STRIDE), move(t)]
                forecast_motion, comes = still_to_move(means, end / t, noise, flows=True), abs(move(end) - move(t))
                assert forecast_motion >= 0.98 * comes
                longest = n if forecast_motion > 0.01 else longest
            if name == "exponential":
                # It is not called moving for much longer than it moves, 2 log(100) = 9.2, or than noise could hide.
                assert 1.5 * STRIDE**longest < max(20, 6e-4 * end)


def test_what_cannot_flow_is_not_expected_to_go_on() -> None:
    means = [1.0, 1.0, 1.0]
    assert still_to_move(means, 1e6, 1e-3, flows=False) == 1e-3
    assert still_to_move(means, 1e6, 1e-3, flows=True) > 1e2


def test_of_a_long_ringing_the_phase_that_rotary_inertia_shifts_is_not_told() -> None:
    """It slows the swing by half a per cent: a quarter of the swing after forty periods, hardly any of its height."""
    effects = ["inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear"]
    scene = Scene.model_validate(
        {
            "filament": {"span": "3 mm", "thickness": "0.25 mm", "section": "circle", "density": "1100 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "30 kPa"},
            "run": {"duration": "0.3 s", "frames": 2001, "effects": effects},
            "numerics": {"estimate": False, "cells": 20},
        }
    )
    without, turning = (simulate(one) for one in (scene, scene.replace({"run.effects": [*effects, "rotary-inertia"]})))
    one, other = (run.data.midpoint.values for run in (without, turning))
    largest = float(np.max(np.abs(one)))
    judge = Judge.of(one, scene.run.duration / period_of(scene), scene.run.accuracy)
    assert float(np.max(np.abs(one - other))) > 0.2 * largest
    assert judge.windows
    assert judge.between(one, other).size < without.summary["checked"]["rotary-inertia"] < 1e-3
    brief = simulate(scene.replace({"run.duration": "0.06 s"}))
    assert brief.summary["checked"]["rotary-inertia"] > scene.run.accuracy
