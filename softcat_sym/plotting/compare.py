"""A comparison with finite elements: pictures, tables, terminal and files."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from softcat_sym.discretization.grid import Floats
from softcat_sym.files import write_all
from softcat_sym.plotting import style
from softcat_sym.plotting.section import node_angles
from softcat_sym.plotting.style import HEADING, axes_in_inches, head, new_figure, png
from softcat_sym.plotting.units import Unit, length_unit, significant, time_unit
from softcat_sym.studies import compare
from softcat_sym.studies.compare import SHARES, late, moments

if TYPE_CHECKING:
    from softcat_sym.reference.calculix import Deck
    from softcat_sym.reference.elements import ElementRun
    from softcat_sym.scene.scene import Scene
    from softcat_sym.studies.compare import CalculixComparison, CalculixRow, Comparison, FilamentRow

LEFT, RIGHT = 0.85, 0.3
"""Margins of the pictures [inch]."""

ELEMENTS: dict[str, Any] = {"color": style.BLACK, "linewidth": 2.6, "alpha": 0.45}
"""The line of the elements: wide and pale, so that a filament that agrees is seen on it."""

_COMPARE_AXES_LINES: dict[str, dict[str, Any]] = {
    "filament": {"color": style.BLUE, "linewidth": 1.3},
    "published, material closure": {"color": style.ORANGE, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
    "published, printed closure": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": (0, (1.5, 1.2))},
}


def elements_name(comparison: Comparison) -> str:
    """``elements 64 x 4``."""
    mesh = comparison.elements.mesh
    return f"elements {mesh.along} × {mesh.through}"


def line_of(row: FilamentRow) -> dict[str, Any]:
    """How to draw a filament, named for the legend."""
    return {"label": row.name, **_COMPARE_AXES_LINES[row.name]}


def plain_numbers(axes: Axes) -> None:
    """Write each number of the vertical axis whole: a common power of ten would stand in the way of what is above."""
    axes.yaxis.set_major_formatter("{x:.3g}")


def trusted_extent(reference: Floats, own: Floats, *, trusted: bool) -> float:
    """How far a picture reaches, in magnitude; whatever runs away beyond leaves it.

    Twice as far as the elements, and as far as the scene's own filament if its answer may be trusted.
    """
    far = 2 * float(np.abs(reference).max())
    return max(far, 1.05 * float(np.nanmax(np.abs(own)))) if trusted else far


def clock_of(comparison: Comparison) -> Unit:
    """The unit of time of the bottom axis."""
    return time_unit(float(comparison.elements.time[-1]))


def share_time(panels: Sequence[Axes], comparison: Comparison) -> None:
    """Give panels below one another one time axis: labelled under the last, in L sqrt(rho/E) above the first."""
    clock = clock_of(comparison)
    end = float(clock.of(comparison.elements.time[-1]))
    for axes in panels:
        axes.set_xlim(0.0, end)
        axes.grid(True)
        style.lighten(axes)
        plain_numbers(axes)
        axes.tick_params(labelbottom=axes is panels[-1])
    panels[-1].set_xlabel(f"time [{clock.symbol}]")
    factor = clock.size / comparison.elements.elastic_time
    top = panels[0].secondary_xaxis(
        "top", functions=(lambda values: np.asarray(values) * factor, lambda values: np.asarray(values) / factor)
    )
    top.set_xlabel("time in L √(ρ/E)")


def legend_row(figure: Figure, axes: Axes, top: float) -> None:
    """One row of names under the heading, where no curve can run."""
    width, height = figure.get_size_inches()
    handles, labels = axes.get_legend_handles_labels()
    place = (LEFT / width, top / height)
    figure.legend(
        handles,
        labels,
        loc="upper left",
        bbox_to_anchor=place,
        ncols=len(labels),
        borderaxespad=0.0,
        columnspacing=1.1,
        handlelength=1.9,
        handletextpad=0.5,
        fontsize=7.5,
    )


_MIDPOINT_HEIGHT, _MIDPOINT_BOTTOM, _MIDPOINT_GAP, _MIDPOINT_RESIDUAL, _MIDPOINT_ABOVE = 5.6, 0.55, 0.2, 1.5, 0.72
_MIDPOINT_ROOM = 1.15

# A published theory may run away: beyond this many per cent, and this multiple of the filament's own error, it leaves
# the picture.
_WORST, _TIMES_OWN = 5.0, 3.0


def midpoint_figure(comparison: Comparison) -> Figure:
    """Draw midpoints above, (filament - elements)/max |elements| below."""
    own = comparison.filament.trajectory
    with style.styled():
        figure = new_figure(style.WIDTH, _MIDPOINT_HEIGHT)
        head(figure, "midpoint, filament against elements", own.summary, comparison.scene, LEFT)
        legend_top = _MIDPOINT_HEIGHT - HEADING
        width = style.WIDTH - LEFT - RIGHT
        bottom = _MIDPOINT_BOTTOM + _MIDPOINT_RESIDUAL + _MIDPOINT_GAP
        above = axes_in_inches(figure, LEFT, bottom, width, legend_top - _MIDPOINT_ABOVE - bottom)
        below = axes_in_inches(figure, LEFT, _MIDPOINT_BOTTOM, width, _MIDPOINT_RESIDUAL)
        _heights(above, comparison)
        _differences(below, comparison)
        share_time((above, below), comparison)
        legend_row(figure, above, legend_top)
    return figure


def _heights(axes: Axes, comparison: Comparison) -> None:
    elements = comparison.elements
    clock, ruler = (
        clock_of(comparison),
        length_unit(float(np.abs(elements.midpoint).max()), comparison.scene.filament.span),
    )
    time = clock.of(elements.time)
    axes.plot(time, ruler.of(elements.midpoint), label=elements_name(comparison), **ELEMENTS)
    for row in comparison.filaments:
        axes.plot(time, ruler.of(row.midpoint), **line_of(row))
    every = np.concatenate([elements.midpoint, *(row.midpoint for row in comparison.filaments)])
    own = comparison.filament
    far = trusted_extent(elements.midpoint, own.midpoint, trusted=own.trajectory.outcome.is_success)
    far = far or comparison.scene.filament.span
    low, high = (float(np.clip(bound, -far, far)) for bound in (np.nanmin(every), np.nanmax(every)))
    room = (_MIDPOINT_ROOM - 1) * max(high - low, 0.1 * far)
    axes.set_ylim(float(ruler.of(min(low, 0.0) - room)), float(ruler.of(max(high, 0.0) + room / 2)))
    axes.set_ylabel(f"midpoint height [{ruler.symbol}]")


def _differences(axes: Axes, comparison: Comparison) -> None:
    time = clock_of(comparison).of(comparison.elements.time)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6)
    for row in comparison.filaments:
        axes.plot(time, 100 * row.discrepancy.error, **line_of(row))
    known = np.nan_to_num([100 * row.discrepancy.largest for row in comparison.filaments])
    shown = min(float(known.max()), max(_TIMES_OWN * float(known[0]), _WORST)) or 1.0
    axes.set_ylim(-_MIDPOINT_ROOM * shown, _MIDPOINT_ROOM * shown)
    axes.set_ylabel("(filament − elements)\n/ max |elements| [%]", fontsize=8.0)


_CLAMP_HEIGHT, _CLAMP_BOTTOM, _CLAMP_GAP, _CLAMP_ABOVE = 5.4, 0.9, 0.2, 0.72
_CLAMP_NOTE = (
    "Over the Gauss points of the elements at the clamp ({column} of a thickness long): log |F e_X| of the elements, "
    "log s − θ_s z of the filament in its fibres through the same material points."
)


def clamp_figure(comparison: Comparison) -> Figure:
    """Draw the largest strain above, the mean below."""
    with style.styled():
        figure = new_figure(style.WIDTH, _CLAMP_HEIGHT)
        head(figure, "axial true strain at the clamp", comparison.filament.trajectory.summary, comparison.scene, LEFT)
        legend_top = _CLAMP_HEIGHT - HEADING
        width, height = style.WIDTH - LEFT - RIGHT, (legend_top - _CLAMP_ABOVE - _CLAMP_BOTTOM - _CLAMP_GAP) / 2
        above = axes_in_inches(figure, LEFT, _CLAMP_BOTTOM + height + _CLAMP_GAP, width, height)
        below = axes_in_inches(figure, LEFT, _CLAMP_BOTTOM, width, height)
        time = clock_of(comparison).of(comparison.elements.time)
        for axes, which in ((above, "largest"), (below, "mean")):
            reference = getattr(comparison.clamp_strain, which)
            axes.plot(time, reference, label=elements_name(comparison), **ELEMENTS)
            for row in comparison.filaments:
                axes.plot(time, getattr(row.clamp_strain, which), **line_of(row))
            own = getattr(comparison.filament.clamp_strain, which)
            far = trusted_extent(reference, own, trusted=comparison.filament.trajectory.outcome.is_success) or 1e-3
            low = min(float(np.nanmin([reference, own])), 0.0)
            axes.set_ylim(max(low - 0.05 * far, -far), min(axes.get_ylim()[1], far))
            axes.set_ylabel(f"{which} strain")
        share_time((above, below), comparison)
        legend_row(figure, above, legend_top)
        X, thickness = comparison.elements.X, comparison.scene.filament.thickness
        note = fill(_CLAMP_NOTE.format(column=f"{(X[-1] - X[-3]) / thickness:.2g}"), 108)
        figure.text(LEFT / style.WIDTH, 0.1 / _CLAMP_HEIGHT, note, fontsize=7.5, color=style.GREY, parse_math=False)
    return figure


_SHAPES_RIGHT, _SHAPES_BOTTOM, _SHAPES_GAP, _BELOW, _LEGEND = 1.25, 0.55, 0.55, 1.5, 0.42
_LOWEST, _SHAPES_TALLEST = 1.1, 4.5
_COLOURS = (style.SKY, style.GREEN, style.ORANGE, style.VERMILLION)


@dataclass(frozen=True)
class ShapePair:
    """Half a centreline, 0 <= X <= L/2, of elements and filament at one time."""

    time: float  # [s]
    X: Floats  # shape (columns,); Material positions [m]
    elements: Floats  # shape (columns, 2); Where they are [m]
    filament: Floats

    @property
    def distance(self) -> Floats:
        """Distance between the two places of each material point [m]."""
        return np.asarray(np.linalg.norm(self.filament - self.elements, axis=1))


def shape_pairs(comparison: Comparison) -> list[ShapePair]:
    """Both centrelines at the moments of the error table that the filament reached."""
    run, data = comparison.elements, comparison.filament.trajectory.data
    nodes, reached = data["X_node"].values, data.sizes["time"]
    return [
        ShapePair(
            float(run.time[frame]),
            run.X,
            np.column_stack([run.x[frame], run.y[frame]]),
            np.column_stack([np.interp(run.X, nodes, data[name].values[frame]) for name in ("x", "y")]),
        )
        for frame in sorted({*moments(len(run.time))})
        if frame < reached
    ]


def shapes_figure(comparison: Comparison) -> Figure:
    """Draw centrelines above, the distance of equal material points below."""
    pairs, span = shape_pairs(comparison), comparison.scene.filament.span
    deepest = max((float(np.abs(pair.elements[:, 1]).max()) for pair in pairs), default=0.0) or 0.01 * span
    width = style.WIDTH - LEFT - _SHAPES_RIGHT
    true = 1.12 * deepest / (1.04 * span) * width
    tall = min(max(true, _LOWEST), _SHAPES_TALLEST)
    height = _SHAPES_BOTTOM + _BELOW + _SHAPES_GAP + tall + _LEGEND + HEADING
    ruler = length_unit(span)
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        head(figure, "centrelines", comparison.filament.trajectory.summary, comparison.scene, LEFT)
        above = axes_in_inches(figure, LEFT, _SHAPES_BOTTOM + _BELOW + _SHAPES_GAP, width, tall)
        below = axes_in_inches(figure, LEFT, _SHAPES_BOTTOM, width, _BELOW)
        _centrelines(above, pairs, comparison, ruler)
        above.set_xlim(*(float(ruler.of(side * 0.52 * span)) for side in (-1, 1)))
        above.set_ylim(float(ruler.of(-1.08 * deepest)), float(ruler.of(0.04 * deepest)))
        scale = "" if abs(tall / true - 1) < 1e-9 else f"; vertical scale × {tall / true:.3g}"
        above.set_xlabel(f"x [{ruler.symbol}]{scale}", labelpad=1.0)
        above.set_ylabel(f"y [{ruler.symbol}]")
        style.lighten(above)
        _distances(below, pairs, span)
        _shapes_explain(figure, comparison, height - HEADING)
    return figure


def _centrelines(axes: Axes, pairs: list[ShapePair], comparison: Comparison, ruler: Unit) -> None:
    clock = clock_of(comparison)
    for pair, colour in zip(pairs, _COLOURS, strict=False):
        for side in (-1, 1):
            x, y = ruler.of(pair.filament).T
            label = f"t = {clock.text(pair.time)}" if side > 0 else None
            axes.plot(side * x, y, color=colour, linewidth=2.4, label=label, solid_capstyle="butt")
            x, y = ruler.of(pair.elements).T
            axes.plot(side * x, y, color=style.BLACK, linewidth=0.9, linestyle=(0, (4, 3)), zorder=3)
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0, handlelength=1.4)


def _distances(axes: Axes, pairs: list[ShapePair], span: float) -> None:
    for pair, colour in zip(pairs, _COLOURS, strict=False):
        axes.plot(pair.X / span, 100 * pair.distance / span, color=colour, linewidth=1.3)
    axes.set_xlim(0.0, 0.5)
    largest = max((float(pair.distance.max()) for pair in pairs), default=0.0)
    axes.set_ylim(0.0, 115 * largest / span or 1.0)
    axes.set_xlabel("X / L, midspan to clamp")
    axes.set_ylabel("distance / L [%]")
    axes.grid(True)
    plain_numbers(axes)
    style.lighten(axes)


def _shapes_explain(figure: Figure, comparison: Comparison, top: float) -> None:
    height = figure.get_size_inches()[1]
    figure.legend(
        handles=[
            Line2D([], [], color=style.GREY, linewidth=2.4, label="filament (coloured by time)"),
            Line2D([], [], color=style.BLACK, linewidth=0.9, linestyle=(0, (4, 3)), label=elements_name(comparison)),
        ],
        loc="upper left",
        bbox_to_anchor=(LEFT / style.WIDTH, top / height),
        ncols=2,
        borderaxespad=0.0,
    )


_RATE_RIGHT, _RATE_BOTTOM, _RATE_GAP, _BETWEEN, _BAR = 0.25, 1.4, 0.42, 0.55, 0.12
_CLOSE_WIDTH, _LEAST, _RATE_TALLEST, _TITLE = 1.75, 1.0, 2.2, 0.2

# Length of strip drawn next to the clamp, in thicknesses; decades of rate told apart.
_CLOSE = 2.5
_DECADES = 4.0
_RESTING = "#dcdcdc"
_RATE_NOTE = (
    "√3 times the equivalent tensile rate, at the Gauss points; grey: no flow, or slower than the scale.\n"
    "Sections are drawn plane, normal to the centreline averaged over half a thickness, thinned as stretch^(−1/2)."
)


@dataclass(frozen=True)
class RateField:
    """Plastic shear rate at one time, each Gauss point on its quarter of an element."""

    time: float  # [s]
    x: Floats  # shape (2 along + 1, 2 through + 1); Corners of the quarters in the plane [m]
    y: Floats
    X: Floats  # shape (2 along, 2 through); Reference positions of the Gauss points [m]
    Y: Floats
    # shape (2 along, 2 through); sqrt(3) times the equivalent tensile plastic rate: the shear rate of the paper
    # [1/s].
    rate: Floats


def rate_fields(run: ElementRun, thickness: float) -> list[RateField]:
    """The fields kept nearest to the moments of the error table, and the one that flows fastest.

    Of those before the last only what flows is worth a picture: a filament that is held early needs no four of them.
    """
    largest = run.rate.max(axis=(1, 2))
    moments = {int(np.abs(run.rate_time - share * run.time[-1]).argmin()) for share in SHARES}
    last = len(largest) - 1
    wanted = {field for field in {*moments, int(largest.argmax())} if largest[field] > 0} | {last}
    return [_field(run, thickness, field) for field in sorted(wanted)]


def _field(run: ElementRun, thickness: float, field: int) -> RateField:
    frame = int(np.abs(run.time - run.rate_time[field]).argmin())
    rows = np.linspace(-thickness / 2, thickness / 2, 2 * run.mesh.through + 1)
    points = run.point.reshape(-1, 2)
    # Columns of nodes lie on the edges and in the middles of the elements: one Gauss point to each quarter.
    column, row = np.searchsorted(run.X, points[:, 0]) - 1, np.searchsorted(rows, points[:, 1]) - 1
    placed = np.empty((len(run.X) - 1, len(rows) - 1, 3))
    placed[column, row, :2], placed[column, row, 2] = points, np.sqrt(3) * run.rate[field].ravel()
    x, y = run.x[frame], run.y[frame]
    angle = _section_angles(run.X, x, y, thickness)
    stretch = np.hypot(np.gradient(x, run.X), np.gradient(y, run.X))
    offset = rows / np.sqrt(stretch)[:, None]
    return RateField(
        float(run.rate_time[field]),
        x[:, None] - offset * np.sin(angle)[:, None],
        y[:, None] + offset * np.cos(angle)[:, None],
        *(placed[..., k] for k in range(3)),
    )


def _section_angles(X: Floats, x: Floats, y: Floats, thickness: float) -> Floats:
    """Angle of the centreline, averaged over half a thickness: next to a clamp true normals would cross.

    It is odd about the midspan and about the clamp, where sections stay vertical.
    """
    angle = node_angles(x, y)
    angle[[0, -1]] = 0.0
    places = np.concatenate([X - X[-1], X[1:], X[1:] + X[-1]])
    mirrored = -angle[::-1]
    turned = np.concatenate([mirrored, angle[1:], mirrored[1:]])
    area = np.concatenate([[0.0], np.cumsum((turned[1:] + turned[:-1]) / 2 * np.diff(places))])
    ends = (np.interp(X + side * thickness / 4, places, area) for side in (1, -1))
    return np.asarray((next(ends) - next(ends)) / (thickness / 2))


def rate_figure(comparison: Comparison) -> Figure:
    """Draw the fields below one another, the whole half span on the left, the clamp on the right."""
    span, thickness = comparison.scene.filament.span, comparison.scene.filament.thickness
    fields = rate_fields(comparison.elements, thickness)
    width = style.WIDTH - LEFT - _RATE_RIGHT - _BETWEEN - _CLOSE_WIDTH
    # One scale for all: that of the width, or of the deepest shape where that would be taller than a page allows.
    scale = min([width / (0.54 * span), *(_RATE_TALLEST / (np.ptp(field.y) + thickness) for field in fields)])
    heights = [max(_LEAST, scale * (float(np.ptp(field.y)) + thickness)) for field in fields]
    flows = any((field.rate > 0).any() for field in fields)
    bottom = _RATE_BOTTOM if flows else _RATE_BOTTOM - 0.5
    height = bottom + sum(heights) + _RATE_GAP * (len(heights) - 1) + _TITLE + HEADING
    ruler, norm, clock = length_unit(span), _scale(fields), clock_of(comparison)
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        head(figure, "plastic shear rate in the elements", {}, comparison.scene, LEFT)
        top, drawn = height - HEADING - _TITLE, None
        for field, tall in zip(fields, heights, strict=True):
            whole = axes_in_inches(figure, LEFT, top - tall, width, tall)
            close = axes_in_inches(figure, LEFT + width + _BETWEEN, top - tall, _CLOSE_WIDTH, tall)
            drawn = _strip(whole, field, norm, ruler)
            _strip(close, field, norm, ruler)
            _window(whole, (0.25 * span, float(field.y.min() + field.y.max()) / 2), (width, tall), 1 / scale, ruler)
            beside = span / 2 - 0.45 * _CLOSE * thickness
            level = float(np.interp(beside, field.x[:, len(field.x[0]) // 2], field.y[:, len(field.x[0]) // 2]))
            _window(close, (beside, level), (_CLOSE_WIDTH, tall), _CLOSE * thickness / _CLOSE_WIDTH, ruler)
            whole.set_title(f"t = {clock.text(field.time)}", loc="left", fontsize=8.5, pad=3.0)
            close.set_title("at the clamp", loc="left", fontsize=8.5, pad=3.0)
            whole.set_ylabel(f"y [{ruler.symbol}]")
            top -= tall + _RATE_GAP
        figure.axes[-2].set_xlabel(f"x [{ruler.symbol}]", labelpad=1.0)
        figure.axes[-1].set_xlabel(f"x [{ruler.symbol}]", labelpad=1.0)
        _rate_explain(figure, drawn, flows=flows)
    return figure


def _scale(fields: list[RateField]) -> LogNorm:
    top = max(float(field.rate.max()) for field in fields) or 1.0
    return LogNorm(top * 10**-_DECADES, top)


def _strip(axes: Axes, field: RateField, norm: LogNorm, ruler: Unit) -> QuadMesh:
    colours = matplotlib.colormaps["viridis"].with_extremes(bad=_RESTING, under=_RESTING)
    rate = np.ma.masked_less_equal(field.rate, 0.0)
    style.lighten(axes)
    # The outline hides the stairs of the quads, which are not anti-aliased lest hairlines show between them.
    x, y = (np.concatenate([c[:, 0], c[-1], c[::-1, -1], c[0, ::-1]]) for c in (ruler.of(field.x), ruler.of(field.y)))
    axes.plot(x, y, color=style.BLACK, linewidth=0.5, zorder=3)
    return axes.pcolormesh(ruler.of(field.x), ruler.of(field.y), rate, norm=norm, cmap=colours, rasterized=True)


def _window(axes: Axes, centre: tuple[float, float], size: tuple[float, float], metre: float, ruler: Unit) -> None:
    """Limits about a point at equal scale; `size` in inches, `metre` metres to the inch."""
    low, high = (
        [float(ruler.of(c + side * metre * i / 2)) for c, i in zip(centre, size, strict=True)] for side in (-1, 1)
    )
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])


def _rate_explain(figure: Figure, drawn: QuadMesh | None, *, flows: bool) -> None:
    width, height = figure.get_size_inches()
    if drawn is not None and flows:
        bar = axes_in_inches(figure, LEFT, 0.74, width - LEFT - _RATE_RIGHT - 1.7, _BAR)
        figure.colorbar(drawn, cax=bar, orientation="horizontal", extend="min")
        place = (width - _RATE_RIGHT - 1.6) / width
        figure.text(place, 0.8 / height, "plastic shear rate [1/s]", va="center", fontsize=8.5)
    note = _RATE_NOTE if flows else "Nothing flows, at none of the times at which the field was kept."
    figure.text(LEFT / width, 0.1 / height, note, fontsize=7.5, color=style.GREY, linespacing=1.35)


def midpoint_csv(comparison: Comparison) -> bytes:
    """Midpoints [m] of all, frame by frame; empty after a run has ended early."""
    columns = {"time_s": comparison.elements.time, "elements_m": comparison.elements.midpoint}
    return _csv(columns | {f"{_key(row)}_m": row.midpoint for row in comparison.filaments})


def clamp_csv(comparison: Comparison) -> bytes:
    """Mean and largest axial true strain at the clamp, of all, frame by frame."""
    rows = [("elements", comparison.clamp_strain)] + [(_key(row), row.clamp_strain) for row in comparison.filaments]
    strains = {f"{name}_{which}": getattr(strain, which) for name, strain in rows for which in ("mean", "largest")}
    return _csv({"time_s": comparison.elements.time, **strains})


def errors_csv(comparison: Comparison) -> bytes:
    """The error table: a column for each theory; a row for each moment, the mean and the largest error."""
    frames = compare.moments(len(comparison.elements.time))
    what = [*("error" for _ in frames), "mean error", "largest error"]
    time = [*(float(comparison.elements.time[frame]) for frame in frames), math.nan, math.nan]
    found = {_key(row): row.discrepancy for row in comparison.filaments}
    return _csv({"what": what, "time_s": time, **{key: [*d.at, d.mean, d.largest] for key, d in found.items()}})


def shapes_csv(comparison: Comparison) -> bytes:
    """Half centrelines of elements and filament at the moments of the error table [m]."""
    pairs = shape_pairs(comparison)
    places = {"X_m": [pair.X for pair in pairs]}
    for who in ("elements", "filament"):
        places |= {f"{who}_{axis}_m": [getattr(pair, who)[:, k] for pair in pairs] for k, axis in enumerate("xy")}
    time = [np.full(len(pair.X), pair.time) for pair in pairs]
    return _csv({name: np.concatenate(parts) for name, parts in {"time_s": time, **places}.items()})


def rate_csv(comparison: Comparison) -> bytes:
    """Plastic shear rate [1/s] of the elements at their Gauss points, at the moments that are drawn."""
    fields = rate_fields(comparison.elements, comparison.scene.filament.thickness)
    parts = {
        "time_s": [np.full(field.rate.size, field.time) for field in fields],
        "X_m": [field.X.ravel() for field in fields],
        "Y_m": [field.Y.ravel() for field in fields],
        "plastic_shear_rate_per_s": [field.rate.ravel() for field in fields],
    }
    return _csv({name: np.concatenate(values) for name, values in parts.items()})


def document(comparison: Comparison) -> dict[str, Any]:
    """What ``compare.json`` holds; every number finite or null.

    ``elements`` and each filament state ``midpoint_final_m``, ``midpoint_mean_m`` (over the last 6/7), ``wall_s`` and
    ``dofs``.
    """
    own, run = comparison.filament, comparison.elements
    summary = own.trajectory.summary
    frames = compare.moments(len(run.time))
    times = [float(run.time[frame]) for frame in frames]
    found = {
        "title": comparison.scene.title,
        "outcome": summary["outcome"],
        "advice": summary["advice"],
        "message": summary["message"],
        "warnings": list(comparison.warnings),
        "elements": {
            **_midpoints(run.time, run.midpoint),
            "wall_s": run.wall,
            "dofs": run.dofs,
            "along": run.mesh.along,
            "through": run.mesh.through,
            "clamp": run.clamp.name.lower(),
            "steps": run.steps,
            "energy_error": run.energy_error,
        },
        **{_key(row): _filament(row, run.time) for row in comparison.filaments},
        "errors": {
            "definition": compare.DEFINITION,
            "time_s": times,
            "time_elastic": [time / run.elastic_time for time in times],
            **{_key(row): _errors(row) for row in comparison.filaments},
        },
        "clamp_strain_final": {
            "definition": compare.CLAMP_STRAIN_DEFINITION,
            "elements": _last(comparison.clamp_strain),
            **{_key(row): _last(row.clamp_strain) for row in comparison.filaments},
        },
    }
    return dict(_finite(found))


def _key(row: FilamentRow) -> str:
    return row.name.replace(",", "").replace(" ", "_")


def _midpoints(time: Floats, midpoint: Floats) -> dict[str, float]:
    return {"midpoint_final_m": float(midpoint[-1]), "midpoint_mean_m": float(midpoint[compare.late(time)].mean())}


def _filament(row: FilamentRow, time: Floats) -> dict[str, Any]:
    summary = row.trajectory.summary
    names = ("outcome", "message", "regime", "closure", "cells", "solver", "steps", "energy_residual")
    return {
        **_midpoints(time, row.midpoint),
        "wall_s": summary["wall_s"]["total"],
        "solve_s": summary["wall_s"]["solve"],
        "dofs": row.dofs,
        "effects": list(summary["effects"]),
        **{name: summary[name] for name in names},
    }


def _errors(row: FilamentRow) -> dict[str, Any]:
    return {"at": list(row.discrepancy.at), "mean": row.discrepancy.mean, "largest": row.discrepancy.largest}


def _last(strain: compare.ClampStrain) -> dict[str, float]:
    return {"mean": float(strain.mean[-1]), "largest": float(strain.largest[-1])}


def _finite(value: Any) -> Any:
    """The same with null in place of what JSON cannot say."""
    if isinstance(value, Mapping):
        return {name: _finite(part) for name, part in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(part) for part in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _csv(columns: Mapping[str, Sequence[str] | Iterable[float] | Floats]) -> bytes:
    """Columns under their names; every number reads back exactly, what is not there is empty."""
    lists = [values.tolist() if isinstance(values, np.ndarray) else list(values) for values in columns.values()]
    rows = [",".join(_cell(value) for value in row) for row in zip(*lists, strict=True)]
    return "\n".join([",".join(columns), *rows, ""]).encode()


def _cell(value: object) -> str:
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else ""
    return str(value)


def comparison_columns(comparison: Comparison) -> list[tuple[str, ...]]:
    """One column for the elements, one for each filament, as texts below the names in `row_names`."""
    span, run = comparison.scene.filament.span, comparison.elements
    none = ("",) * (len(SHARES) + 2)
    columns = [
        (elements_name(comparison), _ratio(run.midpoint[-1] / span), *none, str(run.dofs), significant(run.wall))
    ]
    for row in comparison.filaments:
        found = row.discrepancy
        errors = (_percent(error) for error in (*found.at, found.mean, found.largest))
        wall = significant(row.trajectory.summary["wall_s"]["total"])
        columns.append((row.name, _ratio(row.midpoint[-1] / span), *errors, str(row.dofs), wall))
    return columns


def row_names(comparison: Comparison) -> tuple[str, ...]:
    """What stands left of the columns; the first is the name of the column."""
    run = comparison.elements
    times = (run.time[frame] / run.elastic_time for frame in moments(len(run.time)))
    errors = (f"error at t = {time:.4g}" for time in times)
    return ("", "final midpoint / L", *errors, "mean error", "largest error", "unknowns", "wall time [s]")


def comparison_table(comparison: Comparison) -> Table:
    """Lay the columns out below the names of the theories."""
    note = "errors in %: (filament − elements)/max |elements|, midpoint; t in L √(ρ/E)"
    table = Table(
        title=Text(comparison.scene.title or "Filament", style="bold"),
        title_justify="left",
        caption=Text(note, style="dim"),
        caption_justify="left",
        box=box.SIMPLE_HEAD,
    )
    columns = [row_names(comparison), *comparison_columns(comparison)]
    for column in columns:
        name = column[0].replace("elements ", "elements\n").replace(", ", ",\n").replace(" closure", "\nclosure")
        table.add_column(Text(name), justify="left" if column is columns[0] else "right", no_wrap=True)
    for row in list(zip(*columns, strict=True))[1:]:
        table.add_row(*(Text(text) for text in row))
    return table


def remarks(comparison: Comparison) -> list[str]:
    """What a reader must know beside the numbers: each run that is not to be trusted, and every warning."""
    rows = ((row.name, row.trajectory) for row in comparison.filaments)
    bad = [f"{name}: {run.outcome.name}; {run.outcome.value}" for name, run in rows if not run.outcome.is_success]
    return [*bad, *(f"warning: {text}" for text in comparison.warnings)]


def print_comparison(comparison: Comparison, console: Console | None = None) -> None:
    """Print the table and the remarks."""
    screen = console or Console()
    screen.print(comparison_table(comparison))
    for text in remarks(comparison):
        screen.print(Text(text))


def _ratio(value: float) -> str:
    return f"{value:.5f}" if math.isfinite(value) else "–"


def _percent(error: float) -> str:
    if not math.isfinite(error):
        return "–"
    return f"{100 * error:+.2f}" if abs(error) < 1 else f"{100 * error:+.3g}"


def write_comparison(comparison: Comparison, directory: str | Path) -> list[Path]:
    """Write ``compare.json``, ``scene.toml``, four pictures and their tables.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    contents = {
        "compare.json": (json.dumps(document(comparison), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": comparison.scene.to_toml().encode(),
        "compare_midpoint.png": png(midpoint_figure(comparison)),
        "compare_shapes.png": png(shapes_figure(comparison)),
        "compare_plastic_rate.png": png(rate_figure(comparison)),
        "compare_clamp_strain.png": png(clamp_figure(comparison)),
        "compare_errors.csv": errors_csv(comparison),
        "compare_midpoint.csv": midpoint_csv(comparison),
        "compare_shapes.csv": shapes_csv(comparison),
        "compare_plastic_rate.csv": rate_csv(comparison),
        "compare_clamp_strain.csv": clamp_csv(comparison),
    }
    return write_all(directory, contents)


_CALCULIX_HEIGHT, _CALCULIX_BOTTOM, _CALCULIX_GAP, _CALCULIX_RESIDUAL, _CALCULIX_ABOVE, _CALCULIX_ROOM = (
    5.6,
    0.55,
    0.2,
    1.5,
    0.72,
    1.15,
)

_REFERENCE: dict[str, Any] = {"color": style.BLACK, "linewidth": 2.6, "alpha": 0.45}
_CALCULIX_LINES: dict[str, dict[str, Any]] = {
    "filament": {"color": style.BLUE, "linewidth": 1.3},
    "elements": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
}


def calculix_figure(comparison: CalculixComparison) -> Figure:
    """Draw midpoints above, (ours - CalculiX)/max |CalculiX| below."""
    run, span = comparison.calculix, comparison.scene.filament.span
    clock = time_unit(float(run.time[-1]))
    ruler = length_unit(float(np.abs(run.midpoint).max()), span)
    time = clock.of(run.time)
    with style.styled():
        figure = new_figure(style.WIDTH, _CALCULIX_HEIGHT)
        head(figure, "midpoint, ours against CalculiX", comparison.trajectory.summary, comparison.scene, LEFT)
        width, bottom = style.WIDTH - LEFT - RIGHT, _CALCULIX_BOTTOM + _CALCULIX_RESIDUAL + _CALCULIX_GAP
        above = axes_in_inches(figure, LEFT, bottom, width, _CALCULIX_HEIGHT - HEADING - _CALCULIX_ABOVE - bottom)
        below = axes_in_inches(figure, LEFT, _CALCULIX_BOTTOM, width, _CALCULIX_RESIDUAL)
        name = f"CalculiX {run.mesh.along} × {run.mesh.through}"
        above.plot(time, ruler.of(run.midpoint), label=name, **_REFERENCE)
        below.axhline(0.0, color=style.GREY, linewidth=0.6)
        for row in comparison.rows:
            above.plot(time, ruler.of(row.midpoint), label=row.name, **_CALCULIX_LINES[row.name])
            below.plot(time, 100 * row.discrepancy.error, **_CALCULIX_LINES[row.name])
        far = 2 * float(ruler.of(np.abs(run.midpoint).max())) or 1.0
        low, high = above.get_ylim()
        above.set_ylim(max(low, -far), min(high, far))
        known = np.nan_to_num([100 * row.discrepancy.largest for row in comparison.rows])
        shown = float(known.max()) or 1.0
        below.set_ylim(-_CALCULIX_ROOM * shown, _CALCULIX_ROOM * shown)
        above.set_ylabel(f"midpoint height [{ruler.symbol}]")
        below.set_ylabel("(ours − CalculiX)\n/ max |CalculiX| [%]", fontsize=8.0)
        for axes in (above, below):
            axes.set_xlim(0.0, float(time[-1]))
            axes.grid(True)
            style.lighten(axes)
            plain_numbers(axes)
        above.tick_params(labelbottom=False)
        below.set_xlabel(f"time [{clock.symbol}]")
        factor = clock.size / run.elastic_time
        top = above.secondary_xaxis(
            "top", functions=(lambda t: np.asarray(t) * factor, lambda t: np.asarray(t) / factor)
        )
        top.set_xlabel("time in L √(ρ/E)")
        legend_row(figure, above, _CALCULIX_HEIGHT - HEADING)
    return figure


FOLDER = "calculix"
"""Where deck and print-outs go, in the folder of a comparison."""

_DEFINITION = (
    "(ours - CalculiX)/max |CalculiX| of the midpoint's height: positive where ours sags less; mean: over the frames "
    "of the last 6/7 of the duration; largest: in magnitude, over all frames"
)


def write_deck(scene: Scene, deck: Deck, directory: str | Path) -> list[Path]:
    """Write ``scene.toml`` and ``calculix/deck.inp``."""
    folder = Path(directory)
    written = write_all(folder / FOLDER, {"deck.inp": deck.text.encode("ascii")})
    return [*written, *write_all(folder, {"scene.toml": scene.to_toml().encode()})]


def write_calculix_comparison(comparison: CalculixComparison, directory: str | Path) -> list[Path]:
    """Write ``compare.json``, ``compare_midpoint.png`` and ``.csv``, ``scene.toml``, and ``calculix/`` with the deck.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    folder = Path(directory)
    contents = {
        "compare.json": (json.dumps(calculix_document(comparison), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": comparison.scene.to_toml().encode(),
        "compare_midpoint.png": png(calculix_figure(comparison)),
        "compare_midpoint.csv": _midpoint_csv(comparison),
    }
    return [*write_all(folder, contents), *write_all(folder / FOLDER, comparison.calculix.files)]


def calculix_document(comparison: CalculixComparison) -> dict[str, Any]:
    """What ``compare.json`` holds; every number finite or null."""
    run, summary = comparison.calculix, comparison.trajectory.summary
    times = [float(run.time[frame]) for frame in moments(len(run.time))]
    return {
        "title": comparison.scene.title,
        "engine": "calculix",
        "outcome": summary["outcome"],
        "advice": summary["advice"],
        "message": summary["message"],
        "warnings": list(comparison.warnings),
        "calculix": {
            **_calculix_midpoints(run.time, run.midpoint),
            "wall_s": run.wall,
            "dofs": run.dofs,
            "steps": run.steps,
            "along": run.mesh.along,
            "through": run.mesh.through,
            "clamp": run.clamp.name.lower(),
        },
        **{
            row.name: {
                **_calculix_midpoints(run.time, row.midpoint),
                "wall_s": row.wall,
                "dofs": row.dofs,
                "steps": row.steps,
            }
            for row in comparison.rows
        },
        "errors": {
            "definition": _DEFINITION,
            "time_s": times,
            "time_elastic": [time / run.elastic_time for time in times],
            **{row.name: _calculix_errors(row) for row in comparison.rows},
        },
    }


def calculix_table(comparison: CalculixComparison) -> Table:
    """The table that is printed: CalculiX and ours side by side."""
    run, span = comparison.calculix, comparison.scene.filament.span
    frames = moments(len(run.time))
    note = "errors in %: (ours − CalculiX)/max |CalculiX|, midpoint; t in L √(ρ/E)"
    table = Table(box=box.SIMPLE, caption=note, caption_justify="left")
    table.add_column("")
    for name in (f"CalculiX {run.mesh.along} × {run.mesh.through}", *(row.name for row in comparison.rows)):
        table.add_column(name, justify="right")
    rows = comparison.rows
    table.add_row("final midpoint / L", *(f"{y[-1] / span:.5f}" for y in (run.midpoint, *(r.midpoint for r in rows))))
    for k, frame in enumerate(frames):
        at = f"error at t = {run.time[frame] / run.elastic_time:.4g}"
        table.add_row(at, "", *(f"{100 * row.discrepancy.at[k]:+.2f}" for row in rows))
    table.add_row("mean error", "", *(f"{100 * row.discrepancy.mean:+.2f}" for row in rows))
    table.add_row("largest error", "", *(f"{100 * row.discrepancy.largest:.2f}" for row in rows))
    table.add_row("unknowns", str(run.dofs), *(str(row.dofs) for row in rows))
    table.add_row("steps", str(run.steps), *(str(row.steps) for row in rows))
    table.add_row("wall time [s]", f"{run.wall:.3g}", *(f"{row.wall:.3g}" for row in rows))
    return table


def _midpoint_csv(comparison: CalculixComparison) -> bytes:
    """Midpoints [m], frame by frame; empty after a run has ended early."""
    run = comparison.calculix
    columns = [run.time, run.midpoint, *(row.midpoint for row in comparison.rows)]
    names = ["time_s", "calculix_m", *(f"{row.name}_m" for row in comparison.rows)]
    lines = [",".join(repr(float(v)) if math.isfinite(v) else "" for v in row) for row in zip(*columns, strict=True)]
    return "\n".join([",".join(names), *lines, ""]).encode()


def _calculix_midpoints(time: Floats, midpoint: Floats) -> dict[str, float | None]:
    return {"midpoint_final_m": _or_null(midpoint[-1]), "midpoint_mean_m": _or_null(np.mean(midpoint[late(time)]))}


def _calculix_errors(row: CalculixRow) -> dict[str, Any]:
    found = row.discrepancy
    return {"at": [_or_null(v) for v in found.at], "mean": _or_null(found.mean), "largest": _or_null(found.largest)}


def _or_null(value: float | np.floating[Any]) -> float | None:
    return float(value) if math.isfinite(value) else None
