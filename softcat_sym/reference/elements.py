"""Explicit finite elements of a filament in plane stress, from a scene to a finished run."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Protocol

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.reference.checkpoint import fingerprint, read_checkpoint, write_checkpoint
from softcat_sym.reference.element_loop import ElementLoop, element_sources
from softcat_sym.reference.element_run import ElementRun, run_of
from softcat_sym.reference.interrupts import deferred
from softcat_sym.reference.march import March
from softcat_sym.reference.mesh import Mesh, Strip
from softcat_sym.reference.point_code import point_code
from softcat_sym.reference.problem import Problem, problem_of
from softcat_sym.reference.supports import Clamp, half_span_supports
from softcat_sym.scene import Scene
from softcat_sym.scene.scales import elastic_time


class Progress(Protocol):
    """Listens to a run."""

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note of the time reached [s] and of the step [s]."""
        ...


def run_elements(
    scene: Scene,
    mesh: Mesh | None = None,
    *,
    clamp: Clamp = Clamp.THINNING,
    step_factor: float = 1.0,
    checkpoint: Path | None = None,
    checkpoint_every: float = 30.0,
    progress: Progress | None = None,
) -> ElementRun:
    """Run the elements over a scene.

    The law is (3.1)-(3.8), corrected, in plane stress; the leap-frog integrates the motion, undamped.

    Parameters
    ----------
    scene : Scene
        A rectangular filament between two clamps; elastic, Maxwell or Bingham. Its width only scales energies.
    mesh : Mesh, optional
        64 x 4 equal elements unless given.
    clamp : Clamp
        What the clamped face may do.
    step_factor : float
        Step over the stable one; at most 1.
    checkpoint : pathlib.Path, optional
        File that holds the complete state. If it is there the run goes on from it, to the very same numbers.
    checkpoint_every : float
        Seconds between two checkpoints; one is also written at the end and on Ctrl-C, which is then passed on.
    progress : Progress, optional
        Told the simulated time.

    Returns
    -------
    ElementRun

    Raises
    ------
    SceneError
        If the scene holds what the elements do not know; every such key is named.
    SoftcatError
        If an element is turned inside out, the energies do not add up, there is no compiler, or the checkpoint is of
        another problem.
    """
    if not 0 < step_factor <= 1:
        raise SoftcatError(f"step_factor of {step_factor}: take a value above 0, and at most 1, the stable step")
    strip = Strip(mesh if mesh is not None else Mesh(), problem_of(scene).thickness)
    run, dofs = _set_up(problem_of(scene), strip, clamp, step_factor, checkpoint)
    run.finish(checkpoint_every, progress, elastic_time(scene))
    return run_of(scene, strip, clamp, run.march.records, dofs=dofs, wall=run.wall)


def _set_up(
    problem: Problem, strip: Strip, clamp: Clamp, step_factor: float, checkpoint: Path | None
) -> tuple[_Resumable, int]:
    """The run, where its checkpoint left it, and its degrees of freedom."""
    supports, code = half_span_supports(strip, clamp), point_code(problem.law)
    key = fingerprint(problem, strip.mesh, clamp, step_factor, element_sources(code))
    loop = ElementLoop(strip, supports, code, dict(problem.material), gravity=problem.gravity, ramp=problem.ramp)
    # The nodes of a face that thins share one displacement.
    dofs = int(np.sum(~supports.held)) + (1 if len(supports.face) else 0)
    return _Resumable(March(problem, loop, step_factor), checkpoint, key), dofs


class _Resumable:
    """A march that keeps a checkpoint, if there is a place for one."""

    def __init__(self, march: March, path: Path | None, key: str) -> None:
        self.march, self._path, self._key = march, path, key
        self._start, self._before = time.perf_counter(), 0.0
        if path is not None and not path.parent.is_dir():
            raise SoftcatError(f"no folder {path.parent} for the checkpoint {path.name}; make it first")
        state = read_checkpoint(path, key) if path is not None else None
        if state is not None:
            march.restore(state)
            self._before = float(state["wall"].item())

    @property
    def wall(self) -> float:
        """Seconds spent, those before a resumption included."""
        return self._before + time.perf_counter() - self._start

    def finish(self, every: float, progress: Progress | None, second: float) -> None:
        """Advance to the last output time; `second` is the elastic time in s."""
        saved = time.perf_counter()
        with deferred() as interrupt:
            while not self.march.finished:
                self.march.advance()
                if progress is not None:
                    progress.update(second * self.march.time, second * self.march.step)
                if interrupt.pending or self.march.finished or time.perf_counter() - saved > every:
                    self._save()
                    saved = time.perf_counter()
                if interrupt.pending:
                    raise KeyboardInterrupt

    def _save(self) -> None:
        if self._path is not None:
            write_checkpoint(self._path, self._key, {**self.march.state(), "wall": np.array(self.wall)})
