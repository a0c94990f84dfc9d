"""A comparison with finite elements: pictures, tables, terminal and files."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import matplotlib
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from numpy.typing import ArrayLike
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Report, TextTable
from softcat_sym.plotting import style
from softcat_sym.plotting.style import legend, plain_log, styled, titled_figure
from softcat_sym.plotting.time_axis import TimeAxis
from softcat_sym.plotting.units import length_unit, significant, time_unit
from softcat_sym.reference.elements import ElementRun, Snapshot, snapshot, strip_of
from softcat_sym.studies.compare import SHARES, Comparison, ComparisonRow, moments

_REFERENCE: dict[str, Any] = {"color": style.BLACK, "linewidth": 2.6, "alpha": 0.45}
"""The line of the reference: wide and pale, so that a filament that agrees is seen on it."""

_LINES: dict[str, dict[str, Any]] = {
    "filament": {"color": style.BLUE, "linewidth": 1.3},
    "published, material closure": {"color": style.ORANGE, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
    "published, printed closure": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": (0, (1.5, 1.2))},
}

_WORST, _TIMES_OWN, _ROOM = 5.0, 3.0, 1.15
"""A theory that runs away leaves the picture: beyond so many per cent, and so many times the filament's own error."""


def meshed(comparison: Comparison) -> str:
    """The elements with their mesh: ``elements 64 × 4``."""
    mesh = comparison.elements.mesh
    return f"elements {mesh.along} × {mesh.through}"


drawing.plot.register(Comparison, lambda of, what="compare_midpoint.png": drawing.figure_by_name(DRAWERS, what, of))


def _extent(reference: Floats, comparison: Comparison, own: Floats) -> float:
    """Largest magnitude shown: twice the reference's, and as far as the filament goes if its answer may be trusted."""
    far = 2 * float(np.abs(reference).max())
    trusted = comparison.filament.trajectory.outcome.is_success
    return max(far, 1.05 * float(np.nanmax(np.abs(own)))) if trusted else far


@styled()
def midpoint_figure(comparison: Comparison) -> Figure:
    """Draw midpoints above, (filament - elements)/max |elements| below."""
    run, rows, span = comparison.elements, comparison.rows, comparison.scene.filament.span
    ruler, what = length_unit(float(np.abs(run.midpoint).max()), span), "midpoint, filament against elements"
    figure, body = titled_figure(comparison.scene, what, comparison.filament.trajectory.summary, height=4.9)
    above, below = body.subplots(2, 1, height_ratios=[2, 1])
    axis = TimeAxis.of(run.time, run.midpoint)
    for axes in (above, below):
        axis.dress(axes, label=axis.label if axes is below else "")
        axes.grid(True)
        axes.yaxis.set_major_formatter("{x:.3g}")
    above.tick_params(labelbottom=False)
    time = axis.unit.of(run.time)
    above.plot(time, ruler.of(run.midpoint), label=meshed(comparison), **_REFERENCE)
    below.axhline(0.0, color=style.GREY, linewidth=0.6)
    for row in rows:
        above.plot(time, ruler.of(row.midpoint), label=row.name, **_LINES[row.name])
        below.plot(time, 100 * row.discrepancy.error, **_LINES[row.name])
    heights = np.concatenate([run.midpoint, *(row.midpoint for row in rows)])
    far = _extent(run.midpoint, comparison, rows[0].midpoint) or span
    low, high = np.clip([np.nanmin(heights), np.nanmax(heights)], -far, far)
    room = (_ROOM - 1) * max(high - low, 0.1 * far)
    above.set_ylim(float(ruler.of(min(low, 0.0) - room)), float(ruler.of(max(high, 0.0) + room / 2)))
    above.set_ylabel(f"midpoint height [{ruler.symbol}]")
    errors = np.nan_to_num([100 * row.discrepancy.largest for row in rows])
    shown = min(float(errors.max()), max(_TIMES_OWN * float(errors[0]), _WORST)) or 1.0
    below.set_ylim(-_ROOM * shown, _ROOM * shown)
    below.set_ylabel("(filament − elements)\n/ max |elements| [%]", fontsize=8.0)
    legend(body, "upper left", of=above, ncols=4)
    return figure


def shape_tables(comparison: Comparison) -> list[pd.DataFrame]:
    """Half a centreline, 0 <= X <= L/2, of elements and filament at each moment of the error table that both reach."""
    run, data = comparison.elements, comparison.filament.trajectory.data
    tables = []
    for frame in (frame for frame in sorted({*moments(len(run.time))}) if frame < data.sizes["time"]):
        own = {f"filament_{n}_m": np.interp(run.X, data["X_node"].values, data[n].values[frame]) for n in ("x", "y")}
        theirs = {"elements_x_m": run.x[frame], "elements_y_m": run.y[frame]}
        tables.append(pd.DataFrame({"time_s": float(run.time[frame]), "X_m": run.X, **theirs, **own}))
    return tables


# Length of strip drawn next to the clamp, in thicknesses; decades of rate told apart.
_CLOSE = 2.5
_DECADES = 4.0
_RESTING = "#dcdcdc"
_RATE_NOTE = "√3 times the equivalent tensile rate, at the Gauss points; grey: no flow, or slower than the scale."


def rate_snapshots(comparison: Comparison) -> list[Snapshot]:
    """The strips kept nearest to the moments of the error table, and the one that flows fastest.

    Of those before the last only what flows is worth a picture: a filament that is held early needs no four of them.
    """
    run, strip = comparison.elements, strip_of(comparison.scene, comparison.elements)
    largest = run.rate.max(axis=(1, 2))
    tabulated = {int(np.abs(run.rate_time - share * run.time[-1]).argmin()) for share in SHARES}
    flowing = {field for field in {*tabulated, int(largest.argmax())} if largest[field] > 0}
    moved = run.displacement / comparison.scene.filament.span
    kept = sorted(flowing | {len(largest) - 1})
    return [snapshot(strip, float(run.rate_time[field]), moved[field], run.rate[field]) for field in kept]


def boundary(shot: Snapshot, through: int) -> Floats:
    """Outline of the half strip of elements, along the bottom and back along the top; shape (points, 2)."""
    columns = shot.outline.reshape(-1, through, 8, 2)
    bottom, top = columns[:, 0, :3].reshape(-1, 2), columns[:, -1, 4:7][:, ::-1].reshape(-1, 2)
    return np.concatenate([bottom, top[::-1], bottom[:1]])


def draw_strip(axes: Axes, shot: Snapshot, through: int, scale: ArrayLike, **colours: Any) -> PolyCollection:
    """Draw the half strip, its lengths times a scale, in the colours of its plastic shear rate."""
    # Anti-aliasing would leave hairlines between neighbouring quarters; the outline hides their stairs.
    quads: dict[str, Any] = {"edgecolors": "none", "antialiaseds": False, "rasterized": True}
    rate = np.ma.masked_less_equal(shot.rate, 0.0)
    field = PolyCollection(list(np.asarray(scale) * shot.quarter), array=rate, **quads, **colours)
    axes.add_collection(field, autolim=False)
    axes.plot(*(np.asarray(scale) * boundary(shot, through)).T, color=style.BLACK, linewidth=0.5)
    return field


@styled()
def rate_figure(comparison: Comparison) -> Figure:
    """Draw the fields below one another, the whole half span on the left, the clamp on the right."""
    span, thickness = comparison.scene.filament.span, comparison.scene.filament.thickness
    shots, mesh = rate_snapshots(comparison), comparison.elements.mesh
    corners = [span * shot.outline.reshape(-1, 2) for shot in shots]
    # Of panels four inches wide; the deepest shape is no taller than a page allows.
    heights = [float(np.clip(4.0 / (0.54 * span) * (np.ptp(at[:, 1]) + thickness), 1.0, 2.2)) for at in corners]
    top = max(float(shot.rate.max()) for shot in shots)
    norm = LogNorm((top or 1.0) * 10**-_DECADES, top or 1.0)
    colours = matplotlib.colormaps["viridis"].with_extremes(bad=_RESTING, under=_RESTING)
    ruler, clock = length_unit(span), time_unit(float(comparison.elements.time[-1]))
    notes = _RATE_NOTE if top > 0 else "Nothing flows, at none of the times at which the field was kept."
    what, height = "plastic shear rate in the elements", sum(heights) + 0.35 * len(heights) + 0.9
    figure, body = titled_figure(comparison.scene, what, {}, height=height, notes=notes)
    panels = body.subplots(len(shots), 2, squeeze=False, height_ratios=heights, width_ratios=[4.0, 1.75])
    for shot, at, (whole, close) in zip(shots, corners, panels, strict=True):
        low, high = float(at[:, 1].min()) - thickness / 2, float(at[:, 1].max()) + thickness / 2
        beside, half = span / 2 - 0.45 * _CLOSE * thickness, _CLOSE * thickness / 2
        level = float(at[np.abs(at[:, 0] - beside) <= half, 1].mean())
        for axes, x, y, name in (
            (whole, (-0.02 * span, 0.52 * span), (low, high), f"t = {clock.text(shot.time)}"),
            (close, (beside - half, beside + half), (level - half / 2, level + half / 2), "at the clamp"),
        ):
            drawn = draw_strip(axes, shot, mesh.through, span / ruler.size, norm=norm, cmap=colours)
            axes.set_xlim(*ruler.of(x), auto=True)
            axes.set_ylim(*ruler.of(y), auto=True)
            axes.set_aspect("equal", adjustable="datalim")
            axes.set_title(name, loc="left", fontsize=8.5, pad=3.0)
        whole.set_ylabel(f"y [{ruler.symbol}]")
    for axes in panels[-1]:
        axes.set_xlabel(f"x [{ruler.symbol}]", labelpad=1.0)
    if top > 0:
        bar = body.colorbar(drawn, ax=panels, location="bottom", extend="min", aspect=50, fraction=0.04, pad=0.02)
        bar.set_label("plastic shear rate [s⁻¹]")
        plain_log(bar.ax.xaxis)
    return figure


DRAWERS: dict[str, Callable[[Comparison], Figure]] = {
    "compare_midpoint.png": midpoint_figure,
    "compare_plastic_rate.png": rate_figure,
}
"""Pictures of a comparison, and what draws each."""


def tables(comparison: Comparison) -> dict[str, pd.DataFrame]:
    """Tables by their file names; what a run that ended early did not reach is empty."""
    run, rows = comparison.elements, comparison.rows
    midpoints = {"time_s": run.time, "elements_m": run.midpoint}
    found = {
        "compare_errors.csv": comparison.to_frame(),
        "compare_midpoint.csv": pd.DataFrame(midpoints | {f"{row.key}_m": row.midpoint for row in rows}),
    }
    strains = {"elements_mean": run.clamp_strain, "elements_largest": run.clamp_strain_largest}
    for row in rows:
        strains |= {f"{row.key}_{which}": getattr(row.clamp_strain, which) for which in ("mean", "largest")}
    found["compare_clamp_strain.csv"] = pd.DataFrame({"time_s": run.time, **strains})
    found["compare_shapes.csv"] = pd.concat(shape_tables(comparison))
    X, Y = run.point.reshape(-1, 2).T
    order = np.lexsort((Y, np.round(X / comparison.scene.filament.span, 9)))
    points = {"X_m": X[order], "Y_m": Y[order]}
    found["compare_plastic_rate.csv"] = pd.concat(
        pd.DataFrame({"time_s": shot.time, **points, "plastic_shear_rate_per_s": shot.rate[order]})
        for shot in rate_snapshots(comparison)
    )
    return found


@drawing.report.register(Comparison)
def comparison_report(comparison: Comparison) -> Report:
    """The table of errors and costs, each run that is not to be trusted, and every warning."""
    run, rows = comparison.elements, comparison.rows
    times = [run.time[frame] / run.elastic_time for frame in moments(len(run.time))]
    names = [*(f"error at t = {time:.4g}" for time in times), "mean error", "largest error"]
    errors = [
        [percent(e) for e in (*row.discrepancy.at, row.discrepancy.mean, row.discrepancy.largest)] for row in rows
    ]
    every: list[ElementRun | ComparisonRow] = [run, *rows]
    finals = [curve.midpoint[-1] / comparison.scene.filament.span for curve in every]
    lines = [
        ("final midpoint / L", *(f"{final:.5f}" if math.isfinite(final) else "–" for final in finals)),
        *((name, "", *values) for name, *values in zip(names, *errors, strict=True)),
        ("unknowns", *(str(curve.dofs) for curve in every)),
        ("steps", *(str(curve.steps) for curve in every)),
        ("wall time [s]", *(significant(curve.wall) for curve in every)),
    ]
    heads = [row.name.replace(", ", ",\n").replace(" closure", "\nclosure") for row in rows]
    header = ["", meshed(comparison).replace(" ", "\n", 1), *heads]
    caption = "errors in %: (filament − elements)/max |elements|, midpoint; t in L √(ρ/E)"
    title, columns = comparison.scene.title or "Filament", range(len(header))
    shown = TextTable(header, lines, columns[1:], title=title, caption=caption, whole=columns)
    runs = [(row.name, row.trajectory.outcome) for row in rows]
    remarks = [f"{name}: {outcome.name}; {outcome.value}" for name, outcome in runs if not outcome.is_success]
    remarks += [f"warning: {text}" for text in comparison.warnings]
    files: dict[str, object] = {"compare.json": comparison.to_dict, "scene.toml": comparison.scene.to_toml}
    files |= {name: partial(draw, comparison) for name, draw in DRAWERS.items()}
    files |= tables(comparison)
    return Report(files, [shown, *map(Text, remarks)])


def percent(error: float) -> str:
    """A share as a signed percentage without its sign of per cent."""
    if not math.isfinite(error):
        return "–"
    return f"{100 * error:+.2f}" if abs(error) < 1 else f"{100 * error:+.3g}"
