"""Comparison of a filament, and of the published theory, with finite elements of the same scene, ours or CalculiX."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Drawable
from softcat_sym.effects.selection import choose_effects
from softcat_sym.reference.element_loop import Clamp, Mesh, problem_of
from softcat_sym.reference.elements import ElementRun, recalled_elements
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.simulate import simulated
from softcat_sym.solvers.solution import Progress, Silence

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.results.run import Run
    from softcat_sym.scene.scene import Scene

SHARES = (0.10, 0.25, 0.50, 1.00)
"""Tabulated times, as shares of the duration: t L^-1 sqrt(E/rho) = 46, 115, 230, 460 in the paper's runs."""

MEAN_SINCE = 1 / 7
"""First share of the duration, the initial fall, which the mean leaves out."""

DEFINITION = (
    "(filament - elements)/max |elements| of the midpoint's height: positive where the filament sags less; "
    "mean: over the frames of the last 6/7 of the duration; largest: in magnitude, over all frames"
)

CLAMP_STRAIN_DEFINITION = (
    "axial true strain, mean and largest over the Gauss points of the elements at the clamp: log |F e_X| of the "
    "elements; log s - theta_s z of the filament [2.6, objective form], in its fibres through the same material points"
)

Listening = Callable[[str], AbstractContextManager[Progress]]
"""From the name of the next run, a context whose value receives progress reports."""

_NARROW = 0.2  # Width over thickness above which plane stress is a poor approximation
_BALANCED = 1e-4  # Energy error of the elements over the work of gravity above which a warning is given


@dataclass(frozen=True)
class CurveDifference:
    """Differences of two midpoint curves over the largest magnitude of the reference.

    The values are NaN after a filament's run has ended early, and with a reference that never moves.
    """

    error: Floats  # shape (frames,); (filament - elements)/max |elements|
    at: tuple[float, ...]  # The error at `SHARES` of the duration
    mean: float  # Mean error over the last 6/7
    largest: float  # Largest magnitude over the frames that were reached


@dataclass(frozen=True)
class ClampStrain:
    """Axial true strain at the points of the elements at the clamp; NaN after a run has ended early."""

    mean: Floats  # shape (frames,)
    largest: Floats  # shape (frames,)


@dataclass(frozen=True)
class ComparisonRow:
    """A filament theory compared with the elements."""

    name: str  # ``filament`` for the scene's own effects, or the name of a published theory
    trajectory: Run
    midpoint: Floats  # shape (frames,); Height [m] at the elements' output times; NaN after a run has ended early
    discrepancy: CurveDifference
    clamp_strain: ClampStrain
    dofs: int  # Displacements that are free in the half filament, with shear the section angles too
    steps: int
    wall: float  # [s]

    @property
    def key(self) -> str:
        """Name of the row in JSON and CSV."""
        return self.name.replace(",", "").replace(" ", "_")


@dataclass(frozen=True)
class Comparison(Drawable):
    """A scene as finite elements and as filaments."""

    scene: Scene
    elements: ElementRun
    rows: tuple[ComparisonRow, ...]  # The filament with the scene's own effects first
    warnings: tuple[str, ...]  # Why filament and elements might not be comparable

    @property
    def filament(self) -> ComparisonRow:
        """The row of the scene's own effects."""
        return self.rows[0]

    def to_dict(self) -> dict[str, Any]:
        """Content of ``compare.json``."""
        run, summary = self.elements, self.filament.trajectory.summary
        times = [float(run.time[frame]) for frame in moments(len(run.time))]
        strains = {"elements": ClampStrain(run.clamp_strain, run.clamp_strain_largest)}
        strains |= {row.key: row.clamp_strain for row in self.rows}
        return {
            "title": self.scene.title,
            **{name: summary[name] for name in ("outcome", "advice", "message")},
            "warnings": list(self.warnings),
            "elements": {
                **_midpoints(run.time, run.midpoint),
                **{"wall_s": run.wall, "dofs": run.dofs, "steps": run.steps},
                **{"along": run.mesh.along, "through": run.mesh.through, "clamp": run.clamp.name.lower()},
                "energy_error": run.energy_error,
            },
            "clamp_strain_final": {
                "definition": CLAMP_STRAIN_DEFINITION,
                **{
                    key: {"mean": float(strain.mean[-1]), "largest": float(strain.largest[-1])}
                    for key, strain in strains.items()
                },
            },
            "errors": {
                "definition": DEFINITION,
                "time_s": times,
                "time_elastic": [time / run.elastic_time for time in times],
                **{row.key: {n: getattr(row.discrepancy, n) for n in ("at", "mean", "largest")} for row in self.rows},
            },
            **{row.key: _row_dict(row, run.time) for row in self.rows},
        }

    def to_frame(self) -> pd.DataFrame:
        """The error table: a column for each theory; a row for each moment, the mean and the largest error."""
        frames = moments(len(self.elements.time))
        return pd.DataFrame(
            {
                "what": [*("error" for _ in frames), "mean error", "largest error"],
                "time_s": [*(float(self.elements.time[frame]) for frame in frames), np.nan, np.nan],
                **{row.key: [*row.discrepancy.at, row.discrepancy.mean, row.discrepancy.largest] for row in self.rows},
            }
        )


def _midpoints(time: Floats, midpoint: Floats) -> dict[str, Any]:
    return {"midpoint_final_m": float(midpoint[-1]), "midpoint_mean_m": float(midpoint[late(time)].mean())}


def _row_dict(row: ComparisonRow, time: Floats) -> dict[str, Any]:
    summary = row.trajectory.summary
    names = ("outcome", "message", "regime", "closure", "cells", "solver", "energy_residual")
    found: dict[str, Any] = _midpoints(time, row.midpoint)
    found |= {"wall_s": row.wall, "dofs": row.dofs, "steps": row.steps}
    found |= {"solve_s": summary["wall_s"]["solve"], "effects": list(summary["effects"])}
    return found | {name: summary[name] for name in names}


def moments(frames: int) -> tuple[int, ...]:
    """The frames nearest to `SHARES` of the duration."""
    return tuple(round(share * (frames - 1)) for share in SHARES)


def late(time: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Which frames belong to the last 6/7 of the duration, up to rounding."""
    return np.asarray(time >= MEAN_SINCE * time[-1] * (1 - 1e-12))


def aligned(time: Floats, values: Floats, instants: Floats) -> Floats:
    """Values at other times, linear between frames, NaN after the last."""
    slack = 1e-9 * float(instants[-1])
    return np.where(instants <= time[-1] + slack, np.interp(instants, time, values), np.nan)


def discrepancy(time: Floats, filament: Floats, elements: Floats) -> CurveDifference:
    """Compare two midpoint curves."""
    scale = float(np.abs(elements).max())
    error = (filament - elements) / scale if scale > 0 else np.full(time.shape, np.nan)
    finite = np.abs(error[np.isfinite(error)])
    return CurveDifference(
        error=error,
        at=tuple(float(error[frame]) for frame in moments(len(time))),
        mean=float(error[late(time)].mean()),
        largest=float(finite.max()) if finite.size else float("nan"),
    )


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


def compare(
    scene: Scene, mesh: Mesh | None = None, *, clamp: Clamp = Clamp.THINNING, progress: Listening | None = None
) -> Comparison:
    """Run a scene as finite elements, or take them from the store, and as a filament.

    With ``auto`` effects the published theories are rows, too.
    """
    progress = progress or (lambda _: nullcontext(Silence()))
    if not is_spatial(scene):
        # The elements move in a plane, and so does the filament that is compared with them.
        scene = scene.replace({"run.dimensions": 2})
    # The filament and the elements refuse an unsuitable scene before the long run.
    chosen = choose_effects(scene).names
    problem_of(scene)
    with progress("elements") as listener:
        elements = recalled_elements(scene, mesh, clamp=clamp, progress=listener)
    rows = []
    for name, theory in (("filament", scene), *_published(scene, chosen)):
        with progress(name) as listener:
            rows.append(_filament_row(name, simulated(theory, listener), elements))
    return Comparison(scene, elements, tuple(rows), tuple(_warnings(scene, elements, rows[0])))


def _published(scene: Scene, chosen: object) -> Iterator[tuple[str, Scene]]:
    """The published theory in both closures if the program chooses the effects, unless it chose the same."""
    if scene.run.effects != "auto":
        return
    for closure in ("material", "printed"):
        paper = scene.replace(
            {"run.effects": "paper", "run.closure": closure, "numerics.fibres": None, "numerics.order": None}
        )
        if (choose_effects(paper).names, closure) != (chosen, scene.run.closure):
            yield f"published, {closure} closure", paper


def _filament_row(name: str, trajectory: Run, elements: ElementRun) -> ComparisonRow:
    data, summary = trajectory.data, trajectory.summary
    cells = int(summary["cells"])
    midpoint = aligned(data["time"].values, data["midpoint"].values, elements.time)
    return ComparisonRow(
        name=name,
        trajectory=trajectory,
        midpoint=midpoint,
        discrepancy=discrepancy(elements.time, midpoint, elements.midpoint),
        clamp_strain=filament_clamp_strain(data, elements, trajectory.scene.filament.thickness),
        dofs=2 * cells - 1 + (cells - 1 if trajectory.terms.turns else 0),
        steps=int(summary["steps"]),
        wall=float(summary["wall_s"]["total"]),
    )


def _warnings(scene: Scene, elements: ElementRun, own: ComparisonRow) -> Iterator[str]:
    width, thickness = scene.filament.width, scene.filament.thickness
    if width > _NARROW * thickness * (1 + 1e-9):
        yield (
            "the elements are in plane stress, the limit of a width much less than the thickness; filament.width is "
            f"{width / thickness:.2g} times the thickness: for a comparison of the same problem set it to "
            f"{1e3 * thickness / 20:.3g} mm"
        )
    if elements.energy_error > _BALANCED:
        yield f"the energy balance of the elements has an error of {elements.energy_error:.1g} of the work of gravity"
    yield from own.trajectory.summary["warnings"]
