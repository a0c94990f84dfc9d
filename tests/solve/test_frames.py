"""A run has the frames that were asked for, however it is cut into chunks."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.solvers import interpreted as integrate
from softcat_sym.solvers.interpreted import FrameIntegrator
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Silence

from .filaments import Listener, midpoint, prepared, scene_of, without


def test_the_number_of_frames_is_exact() -> None:
    """Also where the last chunk goes beyond the end, as nine intervals in eight chunks do."""
    for frames in [2, 3, 8, 9, 10, 201]:
        for solver in ["cvodes", "rosenbrock"]:
            run = prepared(scene_of(frames=frames, cells=4), solver=solver)
            solution = run.solve(Silence())
            assert solution.outcome is Outcome.solved
            assert solution.message == ""
            np.testing.assert_allclose(solution.time, run.times, rtol=1e-12)
            assert len(run.times) == frames
            for states in (solution.x, solution.z, solution.quad):
                assert states.shape[1] == frames
            np.testing.assert_array_equal(solution.x[:, 0], run.graph.start)
            np.testing.assert_array_equal(solution.quad[:, 0], 0)
            assert solution.steps > 0


def test_without_inertia_too() -> None:
    for frames in [2, 9, 10]:
        for law in ["elastic", "bingham"]:
            run = prepared(without(scene_of(law, frames=frames, cells=4), "inertia"))
            solution = run.solve(Silence())
            assert solution.outcome is Outcome.solved
            assert solution.z.shape[1] == solution.x.shape[1] == solution.quad.shape[1] == len(solution.time) == frames


@pytest.mark.parametrize("solver", ["cvodes", "rosenbrock"])
def test_chunks_do_not_show(solver: str, monkeypatch: pytest.MonkeyPatch) -> None:
    scene = scene_of(frames=10)
    solutions = []
    for chunks in (1, 4, 9):
        monkeypatch.setattr(integrate, "_chunks", lambda graph, settings, n=chunks: n)
        solutions.append(prepared(scene, solver=solver, rtol=1e-8, atol=1e-10).solve(Silence()))
    for other in solutions[1:]:
        scale = np.max(np.abs(solutions[0].x), axis=1, keepdims=True) + 1e-6
        assert np.max(np.abs((other.x - solutions[0].x) / scale)) < 1e-5
        np.testing.assert_allclose(other.quad, solutions[0].quad, rtol=0, atol=1e-5 * np.max(np.abs(solutions[0].quad)))


def test_work_adds_up_over_chunks() -> None:
    """Plastic work never falls, and goes on from chunk to chunk."""
    solution = prepared(scene_of(frames=10)).solve(Silence())
    lost = solution.quad[0]
    assert lost[-1] > 0
    assert np.all(np.diff(lost) >= -1e-9 * lost[-1])


def test_an_integrator_is_built_once_for_all_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    built = []

    class Counting(FrameIntegrator):
        def __init__(self, *arguments: object) -> None:
            built.append(arguments)
            super().__init__(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(integrate, "FrameIntegrator", Counting)
    prepared(scene_of(frames=10)).solve(Silence())
    assert len(built) == 1


def test_progress_is_told_increasing_times_up_to_the_end() -> None:
    for frames in [2, 10, 33]:
        for absent in [(), ("inertia",)]:
            scene = scene_of(frames=frames)
            listener = Listener()
            prepared(without(scene, *absent)).solve(listener)
            assert listener.times
            assert all(a < b for a, b in zip(listener.times[:-1], listener.times[1:], strict=True))
            assert listener.times[-1] == pytest.approx(0.1, rel=1e-12)
            assert all(step is None or 0 < step <= 0.1 for step in listener.steps)


@pytest.mark.parametrize("solver", ["cvodes", "rosenbrock"])
def test_steps_are_told_and_counted(solver: str) -> None:
    listener = Listener()
    solution = prepared(scene_of(frames=9), solver=solver).solve(listener)
    assert all(step is not None for step in listener.steps)
    lengths = np.diff([0.0, *listener.times])
    counted = sum(length / step for length, step in zip(lengths, listener.steps, strict=True) if step)
    assert solution.steps == pytest.approx(counted, abs=0.01)
    assert solution.steps > 8


def test_a_march_of_equilibria_tells_every_frame() -> None:
    listener = Listener()
    run = prepared(without(scene_of("elastic", frames=6), "inertia"))
    assert run.integration is None
    solution = run.solve(listener)
    np.testing.assert_allclose(listener.times, 0.1 * np.arange(1, 6) / 5, rtol=1e-12)
    assert np.all(np.diff(midpoint(run, solution.z)) <= 1e-12)
