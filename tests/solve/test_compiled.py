"""The compiled run is the interpreted one, and fails, stops and tells as that does."""

from __future__ import annotations

import os
import signal
import threading
import time
from dataclasses import replace
from typing import cast

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.discretization.assembly import energy_scale
from softcat_sym.errors import SoftcatError
from softcat_sym.solvers import compiled
from softcat_sym.solvers import compiled as c_model
from softcat_sym.solvers.compiled import Answer, CModel, CompiledIntegration, Run, Status
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Silence
from tests.acceptance.table import show

from .filaments import Listener, scene_of
from .twins import kinds, largest_difference, prepared

TIGHT = 1e-9
SAME = 2e-6
KINDS = kinds()
QUICK = ("bingham", "no inertia", "fibres", "viscous stress, moving support")


def integration(run: Prepared) -> CompiledIntegration:
    assert isinstance(run.integration, CompiledIntegration)
    return run.integration


@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=() if kind in QUICK else pytest.mark.slow) for kind in KINDS]
)
def test_the_compiled_run_is_the_interpreted_one(kind: str) -> None:
    runs = [prepared(KINDS[kind], backend, rtol=TIGHT) for backend in ("compiled", "interpreted")]
    one, other = (run.solve(Silence()) for run in runs)
    assert one.outcome is other.outcome is Outcome.solved
    np.testing.assert_allclose(one.time, other.time, rtol=1e-13)
    states = largest_difference(runs[0], one, other)
    works = float(np.max(np.abs(one.quad - other.quad)) / np.max(np.abs(other.quad)))
    show(
        f"{kind}, rtol {TIGHT:g}",
        ("unknowns", "works", "steps compiled", "interpreted"),
        [[f"{states:.1e}", f"{works:.1e}", one.steps, other.steps]],
    )
    assert states < SAME
    assert works < SAME


def test_they_start_from_the_same_numbers() -> None:
    for kind in QUICK:
        runs = [prepared(KINDS[kind], backend) for backend in ("compiled", "interpreted")]
        one, other = (run.start for run in runs)
        assert one is not None and other is not None
        np.testing.assert_array_equal(np.append(one.x, one.z), np.append(other.x, other.z), err_msg=kind)
        found = runs[0].solve(Silence())
        np.testing.assert_array_equal(found.x[:, 0], one.x)
        np.testing.assert_array_equal(found.z[:, 0], one.z)


@pytest.mark.parametrize("kind", ["bingham", "no inertia", "fibres"])
def test_energies_are_balanced(kind: str) -> None:
    """Work of the load = what is stored, moves and was dissipated."""
    scene = KINDS[kind]
    run = prepared(scene, rtol=1e-7)
    solution = run.solve(Silence())
    seen = run.graph.observe(solution.time, solution.x, solution.z, run.p)
    span = scene.filament.span
    unit = energy_scale(scene.filament.density, span, run.scale) * span
    names = [name for name in ("energy_elastic", "energy_kinetic", "energy_potential") if name in seen]
    held = sum(seen[name][:, 0] for name in names)
    plastic, load, gradient = solution.quad * unit
    left = held - held[0] + plastic + gradient - load
    assert np.max(np.abs(plastic)) > 1e-3 * np.max(np.abs(held))
    assert np.max(np.abs(left)) < 1e-5 * np.max(np.abs(held)), left


def test_looser_tolerances_take_fewer_steps_and_err_more() -> None:
    exact = prepared(KINDS["bingham"], rtol=TIGHT).solve(Silence())
    steps, errors = [], []
    for rtol in (1e-3, 1e-5, 1e-7):
        run = prepared(KINDS["bingham"], rtol=rtol)
        found = run.solve(Silence())
        steps.append(found.steps)
        errors.append(largest_difference(run, found, exact))
    assert steps == sorted(steps)
    assert errors[0] > 10 * errors[1] > 100 * errors[2]


def test_too_many_steps_is_a_step_limit_that_keeps_the_sound_part(monkeypatch: pytest.MonkeyPatch) -> None:
    run = prepared(scene_of(frames=11))
    whole = run.solve(Silence())
    monkeypatch.setattr(compiled, "_MAX_STEPS", 1)
    monkeypatch.setattr(compiled, "_STEPS_PER_FRAME", whole.steps // 22)
    cut = run.solve(Silence())
    assert cut.outcome is Outcome.step_limit
    frames = len(cut.time)
    assert 1 < frames < 11
    assert cut.x.shape[1] == cut.quad.shape[1] == frames
    np.testing.assert_array_equal(cut.x, whole.x[:, :frames])
    np.testing.assert_array_equal(cut.quad, whole.quad[:, :frames])
    assert cut.message.startswith("stopped after t = ")
    assert "] at X/L = " in cut.message
    reached = float(cut.message.removeprefix("stopped after t = ").split(" s")[0])
    assert cut.time[-1] * run.scale <= reached * (1 + 1e-5) < whole.time[frames] * run.scale


def test_what_is_no_number_is_non_finite() -> None:
    run = prepared(scene_of())
    p = run.p.copy()
    p[run.graph.parameters.index("youngs_modulus")] = np.nan
    solution = replace(run, p=p).solve(Silence())
    assert solution.outcome is Outcome.non_finite
    assert len(solution.time) == 1
    assert np.all(np.isfinite(solution.x))
    assert "not finite" in solution.message


class Failing:
    """A model whose integration ends with a code, after one frame."""

    def __init__(self, of: CModel, code: int) -> None:
        self.model, self.message, self.room, self._code = of.model, of.message, of.room, code

    def integrate(self, run: Run, status: Status, stop: object, room: Answer) -> Answer:
        del stop
        status.code, status.reached, status.worst_slot = self._code, run.times[1] * 1.5, -1
        room.states[:2] = run.state
        return room


def failing(code: int) -> Prepared:
    run = prepared(scene_of())
    whole = integration(run)
    model = cast(CModel, Failing(whole.filament.model, code))
    return replace(run, integration=replace(whole, filament=replace(whole.filament, model=model)))


def test_every_failure_is_an_outcome_with_the_frames_before_it() -> None:
    for code in sorted(compiled._OUTCOMES):
        run = failing(code)
        solution = run.solve(Silence())
        assert solution.outcome is compiled._OUTCOMES[code]
        assert not solution.outcome.is_success
        assert len(solution.time) == solution.x.shape[1] == solution.quad.shape[1] == 2
        assert np.all(np.isfinite(solution.x))
        message = integration(run).filament.model.message(code)
        assert solution.message == f"stopped after t = {1.5 * run.times[1] * run.scale:.6g} s; {message}"


@pytest.mark.parametrize("code", [c_model.MEMORY, c_model.ARGUMENT])
def test_what_is_no_fault_of_the_filament_is_raised(code: int) -> None:
    with pytest.raises(SoftcatError, match="refused to begin"):
        failing(code).solve(Silence())


def test_every_code_has_its_end() -> None:
    codes = range(c_model.NO_CONVERGENCE + 1)
    others = {c_model.SOLVED, c_model.MEMORY, c_model.ARGUMENT, c_model.STOPPED}
    assert set(compiled._OUTCOMES) == set(codes) - others
    model = integration(prepared(scene_of())).filament.model
    assert len({model.message(code) for code in codes}) == len(codes)


def test_arguments_that_make_no_sense_are_refused() -> None:
    run = prepared(scene_of())
    assert run.start is not None
    with pytest.raises(SoftcatError, match="refused to begin"):
        integration(run).run(run.start, run.p, -1.0, run.scale, Silence())


LONG = sc.load_scene("no-yield", {"numerics.cells": 200, "numerics.rtol": "1e-10"})
"""Takes far longer than any of the waits below."""


def test_ctrl_c_stops_a_long_run_within_a_second() -> None:
    sent: list[float] = []

    def press() -> None:
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    class Started(Silence):
        timer = threading.Timer(0.3, press)

        def update(self, simulated_time: float, step_size: float | None) -> None:
            del simulated_time, step_size
            if not self.timer.ident:
                self.timer.start()

    threads = threading.active_count()
    with pytest.raises(KeyboardInterrupt):
        sc.simulate(LONG, Started())
    assert time.monotonic() - sent[0] < 1
    assert threading.active_count() <= threads + 1, "the integration goes on"
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_listener_that_raises_stops_it_too() -> None:
    class Enough(Exception):  # noqa: N818
        pass

    class Fed(Silence):
        def update(self, simulated_time: float, step_size: float | None) -> None:
            raise Enough

    run, began = prepared(LONG), time.monotonic()
    with pytest.raises(Enough):
        run.solve(Fed())
    assert time.monotonic() - began < 2


def test_progress_is_told_while_it_works() -> None:
    run, listener = prepared(sc.load_scene("no-yield", {"numerics.cells": 60, "numerics.rtol": "1e-7"})), Listener()
    solution = run.solve(listener)
    assert solution.outcome is Outcome.solved
    assert len(listener.times) > 2
    assert listener.times == sorted(listener.times)
    assert 0 < listener.times[len(listener.times) // 2] < listener.times[-1]
    assert listener.times[-1] == pytest.approx(run.times[-1] * run.scale)
    assert all(step is None or step > 0 for step in listener.steps)
    assert listener.steps[-1] == pytest.approx(listener.times[-1] / solution.steps)


def test_no_step_runs_over_a_change_of_pace() -> None:
    """Told of them it needs fewer steps: otherwise each is found by refused ones."""
    run = prepared(KINDS["viscous stress, moving support"], rtol=1e-6)
    whole = integration(run)
    np.testing.assert_allclose(whole.kinks * run.scale, [0.3, 0.6], rtol=1e-12)
    told = run.solve(Silence())
    untold = replace(run, integration=replace(whole, kinks=np.zeros(0))).solve(Silence())
    assert told.steps < 0.95 * untold.steps
    assert largest_difference(run, told, untold) < 1e-4


def test_one_library_serves_every_grid_and_every_number() -> None:
    base = prepared(scene_of(cells=5))
    for other in (prepared(scene_of(cells=9)), prepared(scene_of(cells=5, ramp="0.02 s"))):
        assert integration(other).filament.model is integration(base).filament.model


def test_threads_do_not_disturb_each_other() -> None:
    runs = [prepared(scene_of(cells=cells)) for cells in (4, 5, 6, 7, 8, 9)]
    wanted = [run.solve(Silence()) for run in runs]
    found: dict[int, np.ndarray] = {}

    def solve(k: int) -> None:
        for _ in range(5):
            found[k] = runs[k].solve(Silence()).x

    threads = [threading.Thread(target=solve, args=(k,)) for k in range(len(runs))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for k, one in enumerate(wanted):
        np.testing.assert_array_equal(found[k], one.x)


def test_a_run_leaves_what_it_was_given() -> None:
    run = prepared(KINDS["no inertia"])
    assert run.start is not None
    whole = integration(run)
    before = [array.copy() for array in (run.p, run.start.x, run.start.z, whole.filament.places)]
    first, second = run.solve(Silence()), run.solve(Silence())
    for one, other in zip(before, (run.p, run.start.x, run.start.z, whole.filament.places), strict=True):
        np.testing.assert_array_equal(one, other)
    np.testing.assert_array_equal(first.x, second.x)
    assert isinstance(whole.filament.model, CModel)


def test_what_fails_within_the_thread_is_what_the_caller_gets(monkeypatch: pytest.MonkeyPatch) -> None:
    def no_memory(*_: object) -> None:
        raise MemoryError("frames")

    monkeypatch.setattr("softcat_sym.solvers.compiled.CModel.integrate", no_memory)
    with pytest.raises(MemoryError, match="frames"):
        sc.simulate(sc.load_scene("no-yield", {"numerics.cells": 6, "run.frames": 3}))
