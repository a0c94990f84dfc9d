"""A filament against finite elements of the same scene, with the published theory beside it."""

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
from softcat_sym.reference.problem import problem_of
from softcat_sym.simulate import simulated
from softcat_sym.solve import Progress, Silence
from softcat_sym.study.clamp_strain import ClampStrain, elements_clamp_strain, filament_clamp_strain
from softcat_sym.study.discrepancy import Discrepancy, aligned, discrepancy

if TYPE_CHECKING:
    from softcat_sym.scene import Scene
    from softcat_sym.trajectory import Trajectory

Listening = Callable[[str], AbstractContextManager[Progress]]
"""Given what is about to run, a context whose value is told how far it is."""

# Wider than this share of the thickness, the filament is no longer what plane stress is the limit of.
_NARROW = 0.2

# Elements whose energies add up worse than this, relative to the work of gravity, deserve a word.
_BALANCED = 1e-4

_OWN = "filament"
_PUBLISHED = "published, {} closure"


@dataclass(frozen=True)
class FilamentRow:
    """One filament theory, run and compared.

    Attributes
    ----------
    name : str
        ``filament`` for the scene's own effects, else which published theory.
    trajectory : Trajectory
        Its run.
    midpoint : ndarray, shape (frames,)
        Height [m] at the elements' output times; NaN after a run has ended early.
    discrepancy : Discrepancy
        Its midpoint against that of the elements.
    clamp_strain : ClampStrain
        Next to the clamp.
    """

    name: str
    trajectory: Trajectory
    midpoint: Floats
    discrepancy: Discrepancy
    clamp_strain: ClampStrain

    @property
    def dofs(self) -> int:
        """Displacements that are free in the half filament, with shear the section angles too."""
        cells = int(self.trajectory.summary["cells"])
        angles = cells - 1 if "shear" in self.trajectory.summary["effects"] else 0
        return 2 * cells - 1 + angles


@dataclass(frozen=True)
class Comparison:
    """A scene as finite elements and as filaments.

    Attributes
    ----------
    scene : Scene
        What was asked.
    elements : ElementRun
        The reference.
    clamp_strain : ClampStrain
        Of the elements.
    filaments : tuple of FilamentRow
        The scene's own effects first.
    warnings : tuple of str
        Why the two might not be comparable.
    """

    scene: Scene
    elements: ElementRun
    clamp_strain: ClampStrain
    filaments: tuple[FilamentRow, ...]
    warnings: tuple[str, ...]

    @property
    def filament(self) -> FilamentRow:
        """The row of the scene's own effects."""
        return self.filaments[0]


def compare(
    scene: Scene,
    mesh: Mesh | None = None,
    *,
    clamp: Clamp = Clamp.THINNING,
    checkpoint: Path | None = None,
    progress: Listening | None = None,
) -> Comparison:
    """Run the elements and the filament of a scene; where its effects are ``auto``, the published theories too.

    Parameters
    ----------
    scene : Scene
        A filament that the elements know: rectangular, between two clamps; elastic, Maxwell or Bingham.
    mesh : Mesh, optional
        64 x 4 equal elements unless given.
    clamp : Clamp
        What the clamped face of the elements may do.
    checkpoint : pathlib.Path, optional
        Where the elements keep their state; its folder is made if need be. If the file is there they go on from it.
    progress : callable, optional
        Called with what is about to run; returns a context whose value is told how far it is.

    Returns
    -------
    Comparison
        A filament that fails or localises is in it, with an outcome that is not a success.

    Raises
    ------
    SceneError
        If the elements or the filament cannot have the scene; before anything is run or written.
    SoftcatError
        If the elements fail, there is no C compiler, or the checkpoint is of another problem.
    KeyboardInterrupt
        On Ctrl-C; the elements' state is in the checkpoint.
    """
    # Before the theories: one of them may refuse for a reason that is not the user's.
    problem_of(scene)
    theories = _theories(scene)
    listening = progress or _nobody
    with folder_of(checkpoint), listening("elements") as listener:
        elements = run_elements(scene, mesh, clamp=clamp, checkpoint=checkpoint, progress=listener)
    filaments = []
    for name, theory in theories:
        with listening(name) as listener:
            filaments.append(_row(name, simulated(theory, listener), elements))
    warnings = tuple(_warnings(scene, elements, filaments[0]))
    return Comparison(scene, elements, elements_clamp_strain(elements), tuple(filaments), warnings)


def _theories(scene: Scene) -> list[tuple[str, Scene]]:
    """The scene itself and, where the program chooses its effects, the published theory in both closures.

    A published theory that the program chose by itself is not run twice.
    """
    found = [(_OWN, scene)]
    chosen = choose_effects(scene).names
    if scene.run.effects != "auto":
        return found
    for closure in ("material", "printed"):
        paper = scene.replace(
            {"run.effects": "paper", "run.closure": closure, "numerics.fibres": None, "numerics.order": None}
        )
        if (choose_effects(paper).names, closure) != (chosen, scene.run.closure):
            found.append((_PUBLISHED.format(closure), paper))
    return found


def _row(name: str, trajectory: Trajectory, elements: ElementRun) -> FilamentRow:
    data = trajectory.data
    midpoint = aligned(data["time"].values, data["midpoint"].values, elements.time)
    return FilamentRow(
        name,
        trajectory,
        midpoint,
        discrepancy(elements.time, midpoint, elements.midpoint),
        filament_clamp_strain(data, elements, trajectory.scene.filament.thickness),
    )


def _warnings(scene: Scene, elements: ElementRun, own: FilamentRow) -> Iterator[str]:
    width, thickness = scene.filament.width, scene.filament.thickness
    if width > _NARROW * thickness * (1 + 1e-9):
        yield (
            "the elements are in plane stress, the limit of a width much less than the thickness; filament.width is "
            f"{width / thickness:.2g} times the thickness: to compare like with like set it to "
            f"{1e3 * thickness / 20:.3g} mm"
        )
    if elements.energy_error > _BALANCED:
        yield f"the energies of the elements miss the work of gravity by {elements.energy_error:.1g} of it"
    yield from own.trajectory.summary["warnings"]


def _nobody(what: str) -> AbstractContextManager[Progress]:
    del what
    return nullcontext(Silence())
