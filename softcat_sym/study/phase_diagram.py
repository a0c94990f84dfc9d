"""Regimes over planes of dimensionless groups, by what runs show, refined only along their boundaries.

Kamrin & Mahadevan (2012), section 3.2 and figure 3(a). A regime is that of a finished run
(:mod:`softcat_sym.trajectory.regime`), never of a formula; a run that is no answer has none.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from softcat_sym.ensemble.progress import MembersProgress, NobodyListens
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, elastic_time, load_scene
from softcat_sym.solve import watched
from softcat_sym.study.blocks import KeptBlocks, workplace
from softcat_sym.study.phase_boundaries import Crossing, Distance, crossings, distances
from softcat_sym.study.phase_kept import KeptRuns
from softcat_sym.study.phase_lines import PhaseLine, modulus_number, phase_lines
from softcat_sym.study.phase_plane import (
    PLANES,
    PhasePlane,
    Place,
    checked_resolution,
    place_at,
    planes_of,
    refuse_scene,
)
from softcat_sym.study.phase_refinement import Node, RefinedLattice, refined
from softcat_sym.study.phase_runs import PhaseRun, PhaseRunner

SETTINGS: Final = ("run.effects=paper", "run.accuracy=0.01", "numerics.cells=40", "numerics.grading=30")
"""What a diagram changes in a scene: the published physics, an accuracy that decides a regime, one grid for all."""

DESCENT_SCENE: Final = "continual-descent"
DESCENT_TIME: Final = 460.0
"""Of the paper's continual descent, in L sqrt(rho/E); it finds local strains over 23 % near the clamp by then."""

PAPER_STRAIN: Final = 0.23


@dataclass(frozen=True)
class PhasePoint:
    """A run and its lattice node.

    Attributes
    ----------
    i, j : int
        Across (G) and upwards.
    run : PhaseRun
        The run.
    """

    i: int
    j: int
    run: PhaseRun


@dataclass(frozen=True)
class PhaseSheet:
    """One plane.

    Attributes
    ----------
    plane : PhasePlane
        Its axes.
    x, y : ndarray, shape (cells + 1,)
        Lattice values: G, and delta or V.
    points : tuple of PhasePoint
        What was run.
    lattice : RefinedLattice
        Squares and known marks.
    lines : tuple of PhaseLine
        Formulas.
    crossings : tuple of Crossing
        Boundaries that the runs show.
    distances : tuple of Distance
        Between the two.
    wall, processor : float
        Time that it took [s]; of all threads of this process together.
    """

    plane: PhasePlane
    x: Floats
    y: Floats
    points: tuple[PhasePoint, ...]
    lattice: RefinedLattice
    lines: tuple[PhaseLine, ...]
    crossings: tuple[Crossing, ...]
    distances: tuple[Distance, ...]
    wall: float
    processor: float

    @property
    def labels(self) -> npt.NDArray[np.str_]:
        """The mark of every lattice node, shape (cells + 1, cells + 1)."""
        return self.lattice.labels()

    @property
    def nodes(self) -> int:
        """Of the lattice: what a diagram without refinement would run."""
        return (self.lattice.cells + 1) ** 2

    @property
    def runs(self) -> int:
        """All that were made, repetitions included."""
        return sum(point.run.runs for point in self.points)

    @property
    def saved(self) -> int:
        """Nodes that were never run."""
        return self.lattice.saved

    @property
    def counts(self) -> dict[str, int]:
        """Runs of each mark."""
        return dict(sorted(Counter(point.run.mark for point in self.points).items()))

    def held(self, scene: Scene) -> str:
        """The group that does not vary and the modulus, in words."""
        place = self.place(scene, 0, 0)
        fixed = (
            f"V = {place.V:.4g}" if self.plane.y.key == "delta" else f"\N{GREEK SMALL LETTER DELTA} = {place.delta:.4g}"
        )
        return f"{fixed}, E = {modulus_number(scene):.4g} \N{GREEK SMALL LETTER RHO} g L"

    def place(self, scene: Scene, i: int, j: int) -> Place:
        """The groups at a node."""
        return place_at(scene, self.plane, float(self.x[i]), float(self.y[j]))


@dataclass(frozen=True)
class PhaseDiagram:
    """What :func:`phase_diagram` returns.

    Attributes
    ----------
    scene : Scene
        What all filaments have in common.
    sheets : tuple of PhaseSheet
        One for each plane.
    descent : PhaseRun
        The paper's continual descent (G 1.9, V 26, delta 0.03) at t~ = 460.
    workers : int
        Threads, or workers of a cluster.
    """

    scene: Scene
    sheets: tuple[PhaseSheet, ...]
    descent: PhaseRun
    workers: int


def phase_diagram(
    scene: Scene,
    planes: Sequence[str] = tuple(PLANES),
    resolution: int = 40,
    *,
    workers: int | None = None,
    scheduler: str | None = None,
    local_cluster: int | None = None,
    kept: KeptBlocks | None = None,
    progress: MembersProgress | None = None,
) -> PhaseDiagram:
    """Regimes over one or more planes.

    Parameters
    ----------
    scene : Scene
        A filament with Bingham's law between level supports; its groups are what a plane does not vary. Load it with
        `SETTINGS` for the paper's physics at a cost of some hundredths of a second a run.
    planes : sequence of str
        Of ``"G-delta"`` and ``"G-V"``.
    resolution : int
        Cells of the finest lattice along each axis.
    workers, scheduler, local_cluster : optional
        Threads, all cores by default; or a Dask cluster, as :func:`softcat_sym.sweep` takes them.
    kept : KeptBlocks, optional
        Where finished runs are kept, and those finished before are found.
    progress : MembersProgress, optional
        Told about each round of refinement.

    Raises
    ------
    SceneError
        If G, V and delta do not decide the regimes of the scene.
    SoftcatError
        If there is no such plane or resolution.
    KeyboardInterrupt
        If the user stops it.
    """
    chosen, cells = planes_of(planes), checked_resolution(resolution)
    refuse_scene(scene)
    known = KeptRuns(kept) if kept is not None else None
    with watched() as interrupts, workplace(workers, scheduler, local_cluster) as place:
        try:
            runner = PhaseRunner(scene, place.size(), progress or NobodyListens(), place, known)
            sheets = tuple(_sheet(scene, plane, cells, runner) for plane in chosen)
            return PhaseDiagram(scene, sheets, descent_run(scene), place.size())
        finally:
            interrupts.check()


def descent_run(scene: Scene) -> PhaseRun:
    """The paper's continual descent to its last time, by the physics and the numerics of a scene."""
    paper = load_scene(DESCENT_SCENE)
    paper = paper.model_copy(update={"run": scene.run, "numerics": scene.numerics})
    place = place_at(paper, PLANES["G-V"], 1.9, 26.0)
    return PhaseRunner(paper, 1, NobodyListens()).run([place], [DESCENT_TIME * elastic_time(paper)])[0]


def _sheet(scene: Scene, plane: PhasePlane, cells: int, runner: PhaseRunner) -> PhaseSheet:
    begun, spent = time.perf_counter(), time.process_time()
    x, y = plane.x.values(cells), plane.y.values(cells)
    points: list[PhasePoint] = []

    def marks(nodes: Sequence[Node]) -> list[str]:
        runs = runner.run([place_at(scene, plane, float(x[i]), float(y[j])) for i, j in nodes])
        points.extend(PhasePoint(i, j, run) for (i, j), run in zip(nodes, runs, strict=True))
        return [run.mark for run in runs]

    lattice = refined(cells, marks)
    lines = phase_lines(scene, plane)
    seen = crossings(x, y, lattice.labels())
    return PhaseSheet(
        plane,
        x,
        y,
        tuple(points),
        lattice,
        lines,
        seen,
        distances(lines, seen),
        time.perf_counter() - begun,
        time.process_time() - spent,
    )
