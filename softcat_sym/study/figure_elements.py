"""Elements for the paper's figures 3(b) and 4: a whole run, and the strip with its flow at chosen instants."""

from __future__ import annotations

import hashlib
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from softcat_sym.graph.grid import Floats
from softcat_sym.reference import Clamp, ElementRun, Mesh
from softcat_sym.reference.checkpoint import fingerprint, read_checkpoint, write_checkpoint
from softcat_sym.reference.element import POINTS, shape_values
from softcat_sym.reference.element_loop import ElementLoop, element_sources
from softcat_sym.reference.element_run import run_of
from softcat_sym.reference.interrupts import deferred
from softcat_sym.reference.march import March
from softcat_sym.reference.mesh import Strip
from softcat_sym.reference.point_code import point_code
from softcat_sym.reference.problem import problem_of
from softcat_sym.reference.supports import half_span_supports
from softcat_sym.scene import Scene
from softcat_sym.scene.scales import elastic_time
from softcat_sym.solve import Progress

# Seconds between two checkpoints: what an interruption by force can cost.
_EVERY = 30.0

# Sides of an element in the order in which its outline is drawn, by the numbers of element.NODES in lattice places.
_OUTLINE = ((-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0))


@dataclass(frozen=True)
class Snapshot:
    """The half strip X >= 0 at one instant; lengths over the span.

    Attributes
    ----------
    time : float
        t~ = (t/L) sqrt(E/rho).
    outline : ndarray, shape (elements, 8, 2)
        Corners and middles of the sides of each element, in order around it.
    quarter : ndarray, shape (4 elements, 4, 2)
        Corners of the quarter of an element around each Gauss point.
    place : ndarray, shape (4 elements, 2)
        Where the Gauss points are.
    rate : ndarray, shape (4 elements,)
        Plastic shear rate at the Gauss points times L sqrt(rho/E): sqrt(3) times the equivalent tensile rate.
    """

    time: float
    outline: Floats
    quarter: Floats
    place: Floats
    rate: Floats


@dataclass(frozen=True)
class ElementFilm:
    """A finished run with its snapshots.

    Attributes
    ----------
    run : ElementRun
        Midpoint, energies and strains at all output times.
    point : ndarray, shape (4 elements, 2)
        Reference places of the Gauss points over the span.
    snapshots : tuple of Snapshot
        In order of time.
    """

    run: ElementRun
    point: Floats
    snapshots: tuple[Snapshot, ...]

    def at(self, instant: float) -> Snapshot:
        """The snapshot nearest to a time t~."""
        return min(self.snapshots, key=lambda shot: abs(shot.time - instant))


def film_elements(
    scene: Scene, mesh: Mesh, instants: tuple[float, ...], folder: Path, name: str, progress: Progress
) -> ElementFilm:
    """Run the elements over a scene and keep the whole strip at some instants.

    Parameters
    ----------
    scene : Scene
        As for :func:`softcat_sym.reference.run_elements`.
    mesh : Mesh
        Elements.
    instants : tuple of float
        t~; the output times nearest to them are taken.
    folder : pathlib.Path
        Exists. Holds the complete state, in a file named after the scene and after all that decides the numbers: if
        it is there the run goes on from it.
    name : str
        Of the scene, for the file's name.
    progress : Progress
        Told the simulated time [s].

    Raises
    ------
    SceneError
        If the scene holds what the elements do not know.
    SoftcatError
        If the elements fail, there is no C compiler, or the file is damaged.
    KeyboardInterrupt
        On Ctrl-C; the state is in the file.
    """
    problem = problem_of(scene)
    strip, code = Strip(mesh, problem.thickness), point_code(problem.law)
    frames = np.unique(np.round(np.array(instants) / problem.duration * (problem.frames - 1)).astype(int))
    key = fingerprint(problem, mesh, Clamp.THINNING, 1.0, {**element_sources(code), "frames": str(frames.tolist())})
    supports = half_span_supports(strip, Clamp.THINNING)
    loop = ElementLoop(strip, supports, code, dict(problem.material), gravity=problem.gravity, ramp=problem.ramp)
    camera = _Camera(March(problem, loop, 1.0), loop, frames)
    wall = camera.finish(folder / f"elements-{name}-{_short(key)}.npz", key, progress, elastic_time(scene))
    dofs = int(np.sum(~supports.held)) + (1 if len(supports.face) else 0)
    run = run_of(scene, strip, Clamp.THINNING, camera.march.records, dofs=dofs, wall=wall)
    times = np.linspace(0.0, problem.duration, problem.frames)[frames]
    shots = (_snapshot(strip, *of) for of in zip(times.tolist(), camera.displacement, camera.rate, strict=True))
    return ElementFilm(run, strip.points.reshape(-1, 2), tuple(shots))


def _short(key: str) -> str:
    return hashlib.sha256(key.encode()).hexdigest()[:8]


class _Camera:
    """A march that keeps displacements and rates at some frames, and all of it in a file."""

    def __init__(self, march: March, loop: ElementLoop, frames: npt.NDArray[np.int_]) -> None:
        self.march, self._loop, self._frames = march, loop, frames
        self.displacement = np.full((len(frames), *loop.displacement.shape), np.nan)
        self.rate = np.full((len(frames), *loop.rate.shape), np.nan)
        self._look()

    def finish(self, path: Path, key: str, progress: Progress, second: float) -> float:
        """Advance to the last output time, from where the file left it; `second` is the elastic time [s].

        Returns
        -------
        float
            Seconds spent, those before a resumption included.
        """
        before, began = self._restore(path, key), time.perf_counter()
        saved = began
        with deferred() as interrupt:
            while not self.march.finished:
                self.march.advance()
                self._look()
                progress.update(second * self.march.time, second * self.march.step)
                now = time.perf_counter()
                if interrupt.pending or self.march.finished or now - saved > _EVERY:
                    shots = {"shot_displacement": self.displacement, "shot_rate": self.rate}
                    wall = np.array(before + now - began)
                    write_checkpoint(path, key, {**self.march.state(), **shots, "wall": wall})
                    saved = now
                if interrupt.pending:
                    raise KeyboardInterrupt
        return before + time.perf_counter() - began

    def _restore(self, path: Path, key: str) -> float:
        state = read_checkpoint(path, key)
        if state is None:
            return 0.0
        self.march.restore(state)
        self.displacement[...], self.rate[...] = state["shot_displacement"], state["shot_rate"]
        return float(state["wall"].item())

    def _look(self) -> None:
        """Take what stands at this frame: a march stops at each, and goes on only when it is told to."""
        reached = np.isfinite(self.march.records.arrays["steps"][self._frames])
        for shot in np.flatnonzero(reached & np.isnan(self.rate[:, 0, 0])):
            self.displacement[shot], self.rate[shot] = self._loop.displacement, self._loop.rate


def _snapshot(strip: Strip, instant: float, displacement: Floats, rate: Floats) -> Snapshot:
    corners = (strip.position + displacement)[strip.corner]

    def placed(local: Floats) -> Floats:
        """Where points of the parent square are; shape (elements, points, 2)."""
        return np.asarray(np.einsum("pa,eai->epi", shape_values(local), corners))

    quarters = np.array([_quarter(point) for point in np.sign(POINTS)])
    return Snapshot(
        time=instant,
        outline=placed(np.array(_OUTLINE, dtype=np.float64)),
        quarter=placed(quarters.reshape(-1, 2)).reshape(-1, 4, 2),
        place=placed(POINTS).reshape(-1, 2),
        rate=np.sqrt(3) * rate.ravel(),
    )


def _quarter(sign: Floats) -> Floats:
    """The quarter of the parent square in one direction, around it."""
    x, y = sign
    return np.array([[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]])
