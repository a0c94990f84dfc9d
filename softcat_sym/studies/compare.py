"""A filament against finite elements of the same scene, ours or CalculiX, with the published theory beside it."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

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
    from matplotlib.figure import Figure

    from softcat_sym.results.trajectory import Trajectory
    from softcat_sym.scene.scene import Scene

SHARES = (0.10, 0.25, 0.50, 1.00)
"""Moments that are tabulated, as shares of the duration: t L^-1 sqrt(E/rho) = 46, 115, 230, 460 in the paper's runs."""

MEAN_SINCE = 1 / 7
"""The mean leaves out this share of the duration, in which a filament falls into place."""

_DEFINITION = (
    "({ours} - {reference})/max |{reference}| of the midpoint's height: positive where {sagging} sags less; "
    "mean: over the frames of the last 6/7 of the duration; largest: in magnitude, over all frames"
)
_CLAMP_STRAIN_DEFINITION = (
    "axial true strain, mean and largest over the Gauss points of the elements at the clamp: log |F e_X| of the "
    "elements; log s - theta_s z of the filament [2.6, objective form], in its fibres through the same material points"
)
# Wider than this share of the thickness, the filament is no longer what plane stress is the limit of.
_NARROW = 0.2
# Elements whose energies add up worse than this, relative to the work of gravity, deserve a word.
_BALANCED = 1e-4

Listening = Callable[[str], AbstractContextManager[Progress]]
"""Given what is about to run, the context of its progress."""


@dataclass(frozen=True)
class Discrepancy:
    """Differences of two midpoint curves over the largest magnitude of the reference.

    NaN where there is nothing to compare: after a filament's run has ended early, or with a reference that never moves.
    """

    error: Floats  # shape (frames,); (ours - reference)/max |reference|
    at: tuple[float, ...]  # The error at `SHARES` of the duration
    mean: float  # Mean error over the last 6/7
    largest: float  # Largest magnitude over the frames that were reached

    def to_dict(self) -> dict[str, Any]:
        """What JSON holds of it."""
        return {"at": list(self.at), "mean": self.mean, "largest": self.largest}


def moments(frames: int) -> tuple[int, ...]:
    """The frames nearest to `SHARES` of the duration."""
    return tuple(round(share * (frames - 1)) for share in SHARES)


def late(time: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Which frames belong to the last 6/7; a frame that is there but for rounding does."""
    return np.asarray(time >= MEAN_SINCE * time[-1] * (1 - 1e-12))


def aligned(time: Floats, values: Floats, requested: Floats) -> Floats:
    """Values at other times, linear between frames, NaN after the last."""
    slack = 1e-9 * float(requested[-1])
    return np.where(requested <= time[-1] + slack, np.interp(requested, time, values), np.nan)


def discrepancy(time: Floats, ours: Floats, reference: Floats) -> Discrepancy:
    """Compare two midpoint curves."""
    scale = float(np.abs(reference).max())
    error = (ours - reference) / scale if scale > 0 else np.full(time.shape, np.nan)
    known = np.abs(error[np.isfinite(error)])
    return Discrepancy(
        error=error,
        at=tuple(float(error[frame]) for frame in moments(len(time))),
        mean=float(error[late(time)].mean()),
        largest=float(known.max()) if known.size else float("nan"),
    )


@dataclass(frozen=True)
class ClampStrain:
    """Axial true strain at the points of the elements at the clamp."""

    mean: Floats  # shape (frames,); over these points; NaN after a run has ended early
    largest: Floats


def filament_clamp_strain(data: xr.Dataset, run: ElementRun, thickness: float) -> ClampStrain:
    """Strain of the filament's fibres through the Gauss points of the elements at the clamp.

    The strain is the one that the theory itself uses, eps = log s - theta_s (h/2) zeta with the present thickness h.
    Along the filament it is interpolated between cell centres, and constant from the last centre to the clamp.
    """
    X, Y = run.point[-run.mesh.through :].reshape(-1, 2).T
    stretch, curvature, height = (
        np.array([np.interp(X, data["X_cell"].values, frame) for frame in data[name].values])
        for name in ("stretch", "curvature", "thickness")
    )
    strain = np.log(stretch) - curvature * height / 2 * (Y / (thickness / 2))
    time = data["time"].values
    return ClampStrain(*(aligned(time, values, run.time) for values in (strain.mean(axis=1), strain.max(axis=1))))


@dataclass(frozen=True)
class Row:
    """One of ours beside the reference."""

    name: str  # ``filament`` for the scene's own effects, ``elements``, else which published theory
    midpoint: Floats  # shape (frames,); Height [m] at the reference's times; NaN after a run has ended early
    discrepancy: Discrepancy  # Its midpoint against that of the reference
    dofs: int  # Displacements and, with shear, section angles that are free in the half filament
    steps: int
    wall: float  # Seconds spent

    @property
    def key(self) -> str:
        """Its name as a key: ``published_material_closure``."""
        return self.name.replace(",", "").replace(" ", "_")

    def to_dict(self) -> dict[str, Any]:
        """What JSON holds of it, beside the midpoints."""
        return {"wall_s": self.wall, "dofs": self.dofs, "steps": self.steps}


@dataclass(frozen=True)
class FilamentRow(Row):
    """One filament theory, run and compared."""

    trajectory: Trajectory
    clamp_strain: ClampStrain | None = None  # Next to the clamp; None beside CalculiX, which has no such record

    def to_dict(self) -> dict[str, Any]:
        """What JSON holds of it, beside the midpoints."""
        summary = self.trajectory.summary
        names = ("outcome", "message", "regime", "closure", "cells", "solver", "energy_residual")
        found = {"solve_s": summary["wall_s"]["solve"], "effects": list(summary["effects"])}
        return super().to_dict() | found | {name: summary[name] for name in names}


@dataclass(frozen=True)
class Comparison:
    """A scene as finite elements, ours or CalculiX, and as filaments."""

    scene: Scene  # As asked
    reference: ElementRun | CalculixRun
    rows: tuple[Row, ...]  # The scene's own filament first
    warnings: tuple[str, ...]  # Why they might not be comparable

    @property
    def with_calculix(self) -> bool:
        """Whether the reference is CalculiX."""
        return isinstance(self.reference, CalculixRun)

    @property
    def elements(self) -> ElementRun:
        """Our elements as the reference."""
        if isinstance(self.reference, CalculixRun):
            raise TypeError("the reference is CalculiX")
        return self.reference

    @property
    def filaments(self) -> tuple[FilamentRow, ...]:
        """The rows of filament theories."""
        return tuple(row for row in self.rows if isinstance(row, FilamentRow))

    @property
    def filament(self) -> FilamentRow:
        """The row of the scene's own effects."""
        return self.filaments[0]

    @property
    def clamp_strains(self) -> dict[str, ClampStrain]:
        """Strain at the clamp by key, of our elements and of each theory beside them."""
        run = self.elements
        theories = {row.key: row.clamp_strain for row in self.filaments if row.clamp_strain is not None}
        return {"elements": ClampStrain(run.clamp_strain, run.clamp_strain_largest), **theories}

    def to_dict(self) -> dict[str, Any]:
        """What ``compare.json`` holds."""
        run, summary = self.reference, self.filament.trajectory.summary
        times = [float(run.time[frame]) for frame in moments(len(run.time))]

        def midpoints(midpoint: Floats) -> dict[str, float]:
            return {"midpoint_final_m": float(midpoint[-1]), "midpoint_mean_m": float(midpoint[late(run.time)].mean())}

        words = {"ours": "filament", "reference": "elements", "sagging": "the filament"}
        if self.with_calculix:
            words = {"ours": "ours", "reference": "CalculiX", "sagging": "ours"}
        reference: dict[str, Any] = {
            **midpoints(run.midpoint),
            "wall_s": run.wall,
            "dofs": run.dofs,
            "steps": run.steps,
            "along": run.mesh.along,
            "through": run.mesh.through,
            "clamp": run.clamp.name.lower(),
        }
        found: dict[str, Any] = {
            "title": self.scene.title,
            **{name: summary[name] for name in ("outcome", "advice", "message")},
            "warnings": list(self.warnings),
            "calculix" if self.with_calculix else "elements": reference,
            **{row.key: midpoints(row.midpoint) | row.to_dict() for row in self.rows},
            "errors": {
                "definition": _DEFINITION.format(**words),
                "time_s": times,
                "time_elastic": [time / run.elastic_time for time in times],
                **{row.key: row.discrepancy.to_dict() for row in self.rows},
            },
        }
        if self.with_calculix:
            return found | {"engine": "calculix"}
        reference["energy_error"] = self.elements.energy_error
        last = {
            key: {"mean": float(strain.mean[-1]), "largest": float(strain.largest[-1])}
            for key, strain in self.clamp_strains.items()
        }
        return found | {"clamp_strain_final": {"definition": _CLAMP_STRAIN_DEFINITION, **last}}

    def to_frame(self) -> pd.DataFrame:
        """Midpoints [m] of all, frame by frame; empty after a run has ended early."""
        name = "calculix_m" if self.with_calculix else "elements_m"
        columns = {"time_s": self.reference.time, name: self.reference.midpoint}
        return pd.DataFrame(columns | {f"{row.key}_m": row.midpoint for row in self.rows})

    def errors_frame(self) -> pd.DataFrame:
        """The error table: a column for each theory; a row for each moment, the mean and the largest error."""
        frames = moments(len(self.reference.time))
        what = [*("error" for _ in frames), "mean error", "largest error"]
        time = [*(float(self.reference.time[frame]) for frame in frames), np.nan, np.nan]
        found = {row.key: row.discrepancy for row in self.rows}
        errors = {key: [*one.at, one.mean, one.largest] for key, one in found.items()}
        return pd.DataFrame({"what": what, "time_s": time, **errors})

    def clamp_frame(self) -> pd.DataFrame:
        """Mean and largest axial true strain at the clamp, frame by frame."""
        strains = {
            f"{key}_{which}": getattr(strain, which)
            for key, strain in self.clamp_strains.items()
            for which in ("mean", "largest")
        }
        return pd.DataFrame({"time_s": self.elements.time, **strains})

    def figures(self) -> dict[str, Figure]:
        """Every picture by its name."""
        from softcat_sym.plotting.compare import figures

        return figures(self)


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
    theories, listening = _theories(scene), progress or _silence
    with folder_of(checkpoint), listening("elements") as listener:
        elements = run_elements(scene, mesh, clamp=clamp, checkpoint=checkpoint, progress=listener)
    rows = []
    for name, theory in theories.items():
        with listening(name) as listener:
            rows.append(_filament_row(name, simulated(theory, listener), elements))
    warnings = _too_wide(scene, "the elements are in plane stress, the limit of")
    if elements.energy_error > _BALANCED:
        warnings += (f"the energies of the elements miss the work of gravity by {elements.energy_error:.1g} of it",)
    return Comparison(scene, elements, tuple(rows), (*warnings, *rows[0].trajectory.summary["warnings"]))


def compare_with_calculix(
    scene: Scene,
    mesh: Mesh | None = None,
    *,
    clamp: Clamp = Clamp.THINNING,
    step: float = STEP,
    with_elements: bool = False,
    checkpoint: Path | None = None,
    progress: Listening | None = None,
) -> Comparison:
    """Run a scene in CalculiX, as a filament and, if requested, in our elements."""
    require_calculix()
    # Refuses what a filament cannot have before the long run.
    choose_effects(scene)
    listening = progress or _silence
    with listening("CalculiX") as listener:
        calculix = stored_calculix(scene, mesh or Mesh(), clamp, step, listener)
    others: list[Row] = []
    if with_elements:
        with folder_of(checkpoint), listening("elements") as listener:
            run = run_elements(scene, mesh, clamp=clamp, checkpoint=checkpoint, progress=listener)
        found = discrepancy(calculix.time, run.midpoint, calculix.midpoint)
        others.append(Row("elements", run.midpoint, found, run.dofs, run.steps, run.wall))
    with listening("filament") as listener:
        own = _filament_row("filament", simulated(scene, listener), calculix)
    warnings = _too_wide(scene, "one brick across the width is in plane stress only for")
    return Comparison(scene, calculix, (own, *others), (*warnings, *own.trajectory.summary["warnings"]))


def stored_calculix(scene: Scene, mesh: Mesh, clamp: Clamp, step: float, progress: Progress) -> CalculixRun:
    """Run a scene in CalculiX, or take it from the store."""
    numbers, arrays, file = ("elastic_time", "dofs", "steps", "wall"), ("time", "midpoint", "X", "x", "y"), "file "

    def written(run: CalculixRun) -> bytes:
        values = {name: np.asarray(getattr(run, name)) for name in (*numbers, *arrays)}
        return packed(values | {file + name: np.frombuffer(text, np.uint8) for name, text in run.files.items()})

    def read(content: bytes) -> CalculixRun:
        found = unpacked(content)
        values = {name: found[name].item() for name in numbers} | {name: found[name] for name in arrays}
        texts = {name.removeprefix(file): text.tobytes() for name, text in found.items() if name.startswith(file)}
        return CalculixRun(**values, mesh=mesh, clamp=clamp, files=texts)

    return stored(
        key_of("calculix", identity_of(scene), mesh, clamp, step),
        lambda: run_calculix(scene, mesh, clamp=clamp, step=step, progress=progress),
        Form(written, read),
    )


def _theories(scene: Scene) -> dict[str, Scene]:
    """The scene itself and, where the program chooses its effects, the published theory in both closures.

    A published theory that the program chose by itself is not run twice.
    """
    found = {"filament": scene}
    chosen = choose_effects(scene).names
    for closure in ("material", "printed") if scene.run.effects == "auto" else ():
        paper = scene.replace(
            {"run.effects": "paper", "run.closure": closure, "numerics.fibres": None, "numerics.order": None}
        )
        if (choose_effects(paper).names, closure) != (chosen, scene.run.closure):
            found[f"published, {closure} closure"] = paper
    return found


def _filament_row(name: str, run: Trajectory, reference: ElementRun | CalculixRun) -> FilamentRow:
    data, summary, cells = run.data, run.summary, int(run.summary["cells"])
    midpoint = aligned(data["time"].values, data["midpoint"].values, reference.time)
    strain = None
    if isinstance(reference, ElementRun):
        strain = filament_clamp_strain(data, reference, run.scene.filament.thickness)
    return FilamentRow(
        name=name,
        midpoint=midpoint,
        discrepancy=discrepancy(reference.time, midpoint, reference.midpoint),
        dofs=2 * cells - 1 + (cells - 1 if "shear" in summary["effects"] else 0),
        steps=summary["steps"],
        wall=summary["wall_s"]["total"],
        trajectory=run,
        clamp_strain=strain,
    )


def _too_wide(scene: Scene, limit: str) -> tuple[str, ...]:
    width, thickness = scene.filament.width, scene.filament.thickness
    if width <= _NARROW * thickness * (1 + 1e-9):
        return ()
    return (
        f"{limit} a width much less than the thickness; filament.width is {width / thickness:.2g} times the "
        f"thickness: to compare like with like set it to {1e3 * thickness / 20:.3g} mm",
    )


def _silence(what: str) -> AbstractContextManager[Progress]:
    del what
    return nullcontext(Silence())
