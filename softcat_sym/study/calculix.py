"""A filament, and if wanted our finite elements, against CalculiX on the same scene."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.effects import choose_effects
from softcat_sym.files import folder_of
from softcat_sym.graph.grid import Floats
from softcat_sym.reference import Clamp, ElementRun, Mesh, run_elements
from softcat_sym.reference.calculix import CalculixRun, require_calculix
from softcat_sym.reference.calculix_deck import STEP
from softcat_sym.simulate import simulated
from softcat_sym.solve import Progress, Silence
from softcat_sym.study.discrepancy import Discrepancy, aligned, discrepancy
from softcat_sym.study.kept_calculix import kept_calculix

if TYPE_CHECKING:
    from softcat_sym.scene import Scene
    from softcat_sym.trajectory import Trajectory

Listening = Callable[[str], AbstractContextManager[Progress]]
"""Given what is about to run, a context whose value is told how far it is."""

# Wider than this share of the thickness, one brick across the width is no plane stress.
_NARROW = 0.2


@dataclass(frozen=True)
class CalculixRow:
    """One of ours beside CalculiX.

    Attributes
    ----------
    name : str
        ``filament`` or ``elements``.
    midpoint : ndarray, shape (frames,)
        Height [m] at CalculiX's output times; NaN after a run has ended early.
    discrepancy : Discrepancy
        (ours - CalculiX)/max |CalculiX|.
    dofs, steps : int
        Displacements and, with shear, section angles that are free; steps taken.
    wall : float
        Seconds spent.
    """

    name: str
    midpoint: Floats
    discrepancy: Discrepancy
    dofs: int
    steps: int
    wall: float


@dataclass(frozen=True)
class CalculixComparison:
    """A scene in CalculiX and in ours.

    Attributes
    ----------
    scene : Scene
        What was asked.
    calculix : CalculixRun
        The reference.
    trajectory : Trajectory
        The filament's run.
    elements : ElementRun or None
        Our elements, on a mesh of the same density with the same clamp, where they were asked for.
    rows : tuple of CalculixRow
        The filament, then the elements.
    warnings : tuple of str
        Why they might not be comparable.
    """

    scene: Scene
    calculix: CalculixRun
    trajectory: Trajectory
    elements: ElementRun | None
    rows: tuple[CalculixRow, ...]
    warnings: tuple[str, ...]


def compare_with_calculix(
    scene: Scene,
    mesh: Mesh | None = None,
    *,
    clamp: Clamp = Clamp.THINNING,
    step: float = STEP,
    with_elements: bool = False,
    checkpoint: Path | None = None,
    progress: Listening | None = None,
) -> CalculixComparison:
    """Run a scene in CalculiX, as a filament and, if wanted, in our elements.

    Parameters
    ----------
    scene : Scene
        A filament that our elements know: rectangular, between two clamps; elastic, Maxwell or Bingham.
    mesh : Mesh, optional
        64 x 4 equal elements unless given, of both.
    clamp : Clamp
        What the clamped face may do, in both.
    step : float
        CalculiX's longest increment in L sqrt(rho/E).
    with_elements : bool
        Run our elements too.
    checkpoint : pathlib.Path, optional
        Where they keep their state, and go on from if it is there.
    progress : callable, optional
        Called with what is about to run; returns a context whose value is told how far it is.

    Raises
    ------
    SceneError
        If the elements or the filament cannot have the scene; before anything is run.
    SoftcatError
        If CalculiX is not installed or gives up, or our elements fail.
    """
    require_calculix()
    # Refuses what a filament cannot have before the long run.
    choose_effects(scene)
    listening = progress or _nobody
    with listening("CalculiX") as listener:
        calculix = kept_calculix(scene, mesh or Mesh(), clamp, step, listener)
    elements = None
    if with_elements:
        with folder_of(checkpoint), listening("elements") as listener:
            elements = run_elements(scene, mesh, clamp=clamp, checkpoint=checkpoint, progress=listener)
    with listening("filament") as listener:
        trajectory = simulated(scene, listener)
    rows = tuple(_rows(calculix, trajectory, elements))
    return CalculixComparison(scene, calculix, trajectory, elements, rows, tuple(_warnings(scene, trajectory)))


def _rows(calculix: CalculixRun, trajectory: Trajectory, elements: ElementRun | None) -> Iterator[CalculixRow]:
    summary, data = trajectory.summary, trajectory.data
    cells = int(summary["cells"])
    dofs = 2 * cells - 1 + (cells - 1 if "shear" in summary["effects"] else 0)
    midpoint = aligned(data["time"].values, data["midpoint"].values, calculix.time)
    found = discrepancy(calculix.time, midpoint, calculix.midpoint)
    yield CalculixRow("filament", midpoint, found, dofs, int(summary["steps"]), float(summary["wall_s"]["total"]))
    if elements is not None:
        found = discrepancy(calculix.time, elements.midpoint, calculix.midpoint)
        yield CalculixRow("elements", elements.midpoint, found, elements.dofs, elements.steps, elements.wall)


def _warnings(scene: Scene, trajectory: Trajectory) -> Iterator[str]:
    width, thickness = scene.filament.width, scene.filament.thickness
    if width > _NARROW * thickness * (1 + 1e-9):
        yield (
            "one brick across the width is in plane stress only where the width is much less than the thickness; "
            f"filament.width is {width / thickness:.2g} times the thickness: to compare like with like set it to "
            f"{1e3 * thickness / 20:.3g} mm"
        )
    yield from trajectory.summary["warnings"]


def _nobody(what: str) -> AbstractContextManager[Progress]:
    del what
    return nullcontext(Silence())
