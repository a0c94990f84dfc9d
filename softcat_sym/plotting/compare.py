"""A comparison with finite elements: pictures, tables, terminal and files."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import matplotlib
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Report
from softcat_sym.plotting import style
from softcat_sym.plotting.style import legend, plain_log, styled, titled_figure
from softcat_sym.plotting.terminal import TextTable
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


def _over_time(
    comparison: Comparison, what: str, height: float, ratios: Sequence[float], notes: str = ""
) -> tuple[Figure, SubFigure, list[Axes], TimeAxis]:
    """Panels below one another with one time axis: labelled under the last, in L sqrt(rho/E) above the first."""
    run, summary = comparison.elements, comparison.filament.trajectory.summary
    figure, body = titled_figure(comparison.scene, what, summary, height=height, notes=notes)
    panels = body.subplots(len(ratios), 1, height_ratios=ratios)
    axis = TimeAxis.of(run.time, run.midpoint)
    for axes in panels:
        axis.dress(axes, label=axis.label if axes is panels[-1] else "")
        axes.grid(True)
        axes.yaxis.set_major_formatter("{x:.3g}")
        axes.tick_params(labelbottom=axes is panels[-1])
    top = panels[0].twiny()
    axis.dress(top, size=run.elastic_time, label="time in L √(ρ/E)")
    top.spines["top"].set_visible(True)
    return figure, body, list(panels), axis


@styled()
def midpoint_figure(comparison: Comparison) -> Figure:
    """Draw midpoints above, (filament - elements)/max |elements| below."""
    run, rows, span = comparison.elements, comparison.rows, comparison.scene.filament.span
    ruler, what = length_unit(float(np.abs(run.midpoint).max()), span), "midpoint, filament against elements"
    figure, body, (above, below), axis = _over_time(comparison, what, 4.9, [2, 1])
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


@styled()
def clamp_figure(comparison: Comparison) -> Figure:
    """Draw the largest strain above, the mean below."""
    run = comparison.elements
    notes = (
        "Over the Gauss points of the elements at the clamp "
        f"({(run.X[-1] - run.X[-3]) / comparison.scene.filament.thickness:.2g} of a thickness long): "
        "log |F e_X| of the elements, log s − θ_s z of the filament in its fibres through the same material points."
    )
    figure, body, panels, axis = _over_time(comparison, "axial true strain at the clamp", 4.4, [1, 1], notes)
    references = {"largest": run.clamp_strain_largest, "mean": run.clamp_strain}
    for axes, (which, reference) in zip(panels, references.items(), strict=True):
        axes.plot(axis.unit.of(run.time), reference, label=meshed(comparison), **_REFERENCE)
        for row in comparison.rows:
            axes.plot(axis.unit.of(run.time), getattr(row.clamp_strain, which), label=row.name, **_LINES[row.name])
        own = getattr(comparison.filament.clamp_strain, which)
        far = _extent(reference, comparison, own) or 1e-3
        low = min(float(np.nanmin([reference, own])), 0.0)
        axes.set_ylim(max(low - 0.05 * far, -far), min(axes.get_ylim()[1], far))
        axes.set_ylabel(f"{which} strain")
    legend(body, "upper left", of=panels[0], ncols=4)
    return figure


_LOWEST, _TALLEST = 1.1, 4.5
_COLOURS = (style.SKY, style.GREEN, style.ORANGE, style.VERMILLION)


def shape_tables(comparison: Comparison) -> list[pd.DataFrame]:
    """Half a centreline, 0 <= X <= L/2, of elements and filament at each moment of the error table that both reach."""
    run, data = comparison.elements, comparison.filament.trajectory.data
    tables = []
    for frame in (frame for frame in sorted({*moments(len(run.time))}) if frame < data.sizes["time"]):
        own = {f"filament_{n}_m": np.interp(run.X, data["X_node"].values, data[n].values[frame]) for n in ("x", "y")}
        theirs = {"elements_x_m": run.x[frame], "elements_y_m": run.y[frame]}
        tables.append(pd.DataFrame({"time_s": float(run.time[frame]), "X_m": run.X, **theirs, **own}))
    return tables


@styled()
def shapes_figure(comparison: Comparison) -> Figure:
    """Draw centrelines above, the distance of equal material points below."""
    pairs, span = shape_tables(comparison), comparison.scene.filament.span
    deepest = max((float(pair.elements_y_m.abs().max()) for pair in pairs), default=0.0) or 0.01 * span
    # Of axes that are five inches wide, drawn true; what is flat or deep is stretched.
    true = 5.0 * 1.12 * deepest / (1.04 * span)
    tall = min(max(true, _LOWEST), _TALLEST)
    scale = "" if abs(tall / true - 1) < 1e-9 else f"; vertical scale × {tall / true:.3g}"
    ruler, clock = length_unit(span), time_unit(float(comparison.elements.time[-1]))
    wide: dict[str, Any] = {"color": style.GREY, "linewidth": 2.4}
    dashed: dict[str, Any] = {"color": style.BLACK, "linewidth": 0.9, "linestyle": (0, (4, 3))}
    summary = comparison.filament.trajectory.summary
    figure, body = titled_figure(comparison.scene, "centrelines", summary, height=tall + 3.0)
    above, below = body.subplots(2, 1, height_ratios=[tall, 1.5])
    largest = 0.0
    for pair, colour in zip(pairs, _COLOURS, strict=False):
        for side, label in ((-1, None), (1, f"t = {clock.text(pair.time_s[0])}")):
            x, y = ruler.of(side * pair.filament_x_m), ruler.of(pair.filament_y_m)
            above.plot(x, y, **{**wide, "color": colour}, label=label, solid_capstyle="butt")
            above.plot(ruler.of(side * pair.elements_x_m), ruler.of(pair.elements_y_m), **dashed, zorder=3)
        distance = np.hypot(pair.filament_x_m - pair.elements_x_m, pair.filament_y_m - pair.elements_y_m)
        below.plot(pair.X_m / span, 100 * distance / span, color=colour, linewidth=1.3)
        largest = max(largest, float(distance.max()))
    above.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0, handlelength=1.4)
    above.set(xlim=ruler.of([-0.52 * span, 0.52 * span]), ylim=ruler.of([-1.08 * deepest, 0.04 * deepest]))
    above.set_box_aspect(tall / 5.0)
    above.set_xlabel(f"x [{ruler.symbol}]{scale}", labelpad=1.0)
    above.set_ylabel(f"y [{ruler.symbol}]")
    below.set(xlim=(0.0, 0.5), ylim=(0.0, 115 * largest / span or 1.0))
    below.set(xlabel="X / L, midspan to clamp", ylabel="distance / L [%]")
    below.grid(True)
    below.yaxis.set_major_formatter("{x:.3g}")
    named = (("filament (coloured by time)", wide), (meshed(comparison), dashed))
    legend(body, "upper left", handles=[Line2D([], [], label=name, **look) for name, look in named], ncols=2)
    return figure


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
    "compare_shapes.png": shapes_figure,
    "compare_plastic_rate.png": rate_figure,
    "compare_clamp_strain.png": clamp_figure,
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
    table = TextTable(header, lines, range(1, len(header)))
    shown = table.printed(comparison.scene.title or "Filament", caption, whole=range(len(lines)), padding=(0, 1))
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
