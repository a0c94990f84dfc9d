"""A filament against finite elements of the same scene, ours or CalculiX, with the published theory beside it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.files import folder_of
from softcat_sym.reference.calculix import STEP, CalculixRun, require_calculix, run_calculix
from softcat_sym.reference.element_loop import Clamp, Mesh, problem_of
from softcat_sym.reference.elements import ElementRun, run_elements
from softcat_sym.simulate import identity_of, simulated
from softcat_sym.solvers.solution import Progress, Silence
from softcat_sym.store import Form, key_of, packed, stored, unpacked

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.results.trajectory import Trajectory
    from softcat_sym.scene.scene import Scene

SHARES = (0.10, 0.25, 0.50, 1.00)
"""Moments that are tabulated, as shares of the duration: t L^-1 sqrt(E/rho) = 46, 115, 230, 460 in the paper's runs."""

MEAN_SINCE = 1 / 7
"""The mean leaves out this share of the duration, in which a filament falls into place."""

DEFINITION = (
    "(filament - elements)/max |elements| of the midpoint's height: positive where the filament sags less; "
    "mean: over the frames of the last 6/7 of the duration; largest: in magnitude, over all frames"
)


@dataclass(frozen=True)
class Discrepancy:
    """Differences of two midpoint curves over the largest magnitude of the reference.

    NaN where there is nothing to compare: after a filament's run has ended early, or with a reference that never moves.
    """

    error: Floats  # shape (frames,); (filament - elements)/max |elements|
    at: tuple[float, ...]  # The error at `SHARES` of the duration
    mean: float  # Mean error over the last 6/7
    largest: float  # Largest magnitude over the frames that were reached


def moments(frames: int) -> tuple[int, ...]:
    """The frames nearest to `SHARES` of the duration."""
    return tuple(round(share * (frames - 1)) for share in SHARES)


def late(time: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Which frames belong to the last 6/7; a frame that is there but for rounding does."""
    return np.asarray(time >= MEAN_SINCE * time[-1] * (1 - 1e-12))


def aligned(time: Floats, values: Floats, wanted: Floats) -> Floats:
    """Values at other times, linear between frames, NaN after the last."""
    slack = 1e-9 * float(wanted[-1])
    return np.where(wanted <= time[-1] + slack, np.interp(wanted, time, values), np.nan)


def discrepancy(time: Floats, filament: Floats, elements: Floats) -> Discrepancy:
    """Compare two midpoint curves."""
    scale = float(np.abs(elements).max())
    error = (filament - elements) / scale if scale > 0 else np.full(time.shape, np.nan)
    known = np.abs(error[np.isfinite(error)])
    return Discrepancy(
        error=error,
        at=tuple(float(error[frame]) for frame in moments(len(time))),
        mean=float(error[late(time)].mean()),
        largest=float(known.max()) if known.size else float("nan"),
    )


CLAMP_STRAIN_DEFINITION = (
    "axial true strain, mean and largest over the Gauss points of the elements at the clamp: log |F e_X| of the "
    "elements; log s - theta_s z of the filament [2.6, objective form], in its fibres through the same material points"
)


@dataclass(frozen=True)
class ClampStrain:
    """Axial true strain at the points of the elements at the clamp."""

    mean: Floats  # shape (frames,); Over these points; NaN after a run has ended early
    largest: Floats


def elements_clamp_strain(run: ElementRun) -> ClampStrain:
    """What the elements recorded."""
    return ClampStrain(run.clamp_strain, run.clamp_strain_largest)


def filament_clamp_strain(data: xr.Dataset, run: ElementRun, thickness: float) -> ClampStrain:
    """Strain of the filament's fibres through the Gauss points of the elements at the clamp.

    The strain is the one that the theory itself uses, eps = log s - theta_s (h/2) zeta with the present thickness h.
    Along the filament it is interpolated between cell centres, and constant from the last centre to the clamp.
    """
    X, Y = run.point[-run.mesh.through :].reshape(-1, 2).T
    centres = data["X_cell"].values
    fields = (data[name].values for name in ("stretch", "curvature", "thickness"))
    stretch, curvature, height = (_along(X, centres, values) for values in fields)
    strain = np.log(stretch) - curvature * height / 2 * (Y / (thickness / 2))
    time = data["time"].values
    return ClampStrain(*(aligned(time, values, run.time) for values in (strain.mean(axis=1), strain.max(axis=1))))


def _along(X: Floats, centres: Floats, values: Floats) -> Floats:
    return np.array([np.interp(X, centres, frame) for frame in values])


_NUMBERS = ("elastic_time", "dofs", "steps", "wall")
_ARRAYS = ("time", "midpoint", "X", "x", "y")
_FILE = "file "


def stored_calculix(scene: Scene, mesh: Mesh, clamp: Clamp, step: float, progress: Progress) -> CalculixRun:
    """Run a scene in CalculiX, or take it from the store."""
    return stored(
        key_of("calculix", identity_of(scene), mesh, clamp, step),
        lambda: run_calculix(scene, mesh, clamp=clamp, step=step, progress=progress),
        Form(_written, lambda content: _read(content, mesh, clamp)),
    )


def _written(run: CalculixRun) -> bytes:
    told = {name: np.asarray(getattr(run, name)) for name in (*_NUMBERS, *_ARRAYS)}
    return packed(told | {_FILE + name: np.frombuffer(one, np.uint8) for name, one in run.files.items()})


def _read(content: bytes, mesh: Mesh, clamp: Clamp) -> CalculixRun:
    found = unpacked(content)
    told = {name: found[name].item() for name in _NUMBERS} | {name: found[name] for name in _ARRAYS}
    files = {name.removeprefix(_FILE): one.tobytes() for name, one in found.items() if name.startswith(_FILE)}
    return CalculixRun(**told, mesh=mesh, clamp=clamp, files=files)


Listening = Callable[[str], AbstractContextManager[Progress]]
"""Given what is about to run, a context whose value is told how far it is."""

# Wider than this share of the thickness, one brick across the width is no plane stress.
_NARROW = 0.2


@dataclass(frozen=True)
class CalculixRow:
    """One of ours beside CalculiX."""

    name: str  # ``filament`` or ``elements``
    midpoint: Floats  # shape (frames,); Height [m] at CalculiX's output times; NaN after a run has ended early
    discrepancy: Discrepancy  # (ours - CalculiX)/max |CalculiX|
    dofs: int  # Displacements and, with shear, section angles that are free; steps taken
    steps: int
    wall: float  # Seconds spent


@dataclass(frozen=True)
class CalculixComparison:
    """A scene in CalculiX and in ours."""

    scene: Scene  # What was asked
    calculix: CalculixRun  # The reference
    trajectory: Trajectory  # The filament's run
    # Our elements, on a mesh of the same density with the same clamp, where they were asked for.
    elements: ElementRun | None
    rows: tuple[CalculixRow, ...]  # The filament, then the elements
    warnings: tuple[str, ...]  # Why they might not be comparable


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
    """Run a scene in CalculiX, as a filament and, if wanted, in our elements."""
    require_calculix()
    # Refuses what a filament cannot have before the long run.
    choose_effects(scene)
    listening = progress or _nobody
    with listening("CalculiX") as listener:
        calculix = stored_calculix(scene, mesh or Mesh(), clamp, step, listener)
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


# Wider than this share of the thickness, the filament is no longer what plane stress is the limit of.

# Elements whose energies add up worse than this, relative to the work of gravity, deserve a word.
_BALANCED = 1e-4

_OWN = "filament"
_PUBLISHED = "published, {} closure"


@dataclass(frozen=True)
class FilamentRow:
    """One filament theory, run and compared."""

    name: str  # ``filament`` for the scene's own effects, else which published theory
    trajectory: Trajectory  # Its run
    midpoint: Floats  # shape (frames,); Height [m] at the elements' output times; NaN after a run has ended early
    discrepancy: Discrepancy  # Its midpoint against that of the elements
    clamp_strain: ClampStrain  # Next to the clamp

    @property
    def dofs(self) -> int:
        """Displacements that are free in the half filament, with shear the section angles too."""
        cells = int(self.trajectory.summary["cells"])
        angles = cells - 1 if "shear" in self.trajectory.summary["effects"] else 0
        return 2 * cells - 1 + angles


@dataclass(frozen=True)
class Comparison:
    """A scene as finite elements and as filaments."""

    scene: Scene  # What was asked
    elements: ElementRun  # The reference
    clamp_strain: ClampStrain  # Of the elements
    filaments: tuple[FilamentRow, ...]  # The scene's own effects first
    warnings: tuple[str, ...]  # Why the two might not be comparable

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
    """Run the elements and the filament of a scene; where its effects are ``auto``, the published theories too."""
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
    warnings = tuple(_element_warnings(scene, elements, filaments[0]))
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


def _element_warnings(scene: Scene, elements: ElementRun, own: FilamentRow) -> Iterator[str]:
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
