"""A comparison with finite elements: pictures, tables, terminal and files."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
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
from softcat_sym.plotting.files import columns_csv, write_results
from softcat_sym.plotting.section import node_angles
from softcat_sym.plotting.style import headed, legend, secondary_scale
from softcat_sym.plotting.terminal import text_table
from softcat_sym.plotting.units import Unit, length_unit, significant, time_unit
from softcat_sym.studies import compare
from softcat_sym.studies.compare import SHARES, moments

if TYPE_CHECKING:
    from softcat_sym.reference.calculix import CalculixRun, Deck
    from softcat_sym.reference.elements import ElementRun
    from softcat_sym.scene.scene import Scene
    from softcat_sym.studies.compare import CalculixComparison, CalculixRow, Comparison, FilamentRow

ELEMENTS: dict[str, Any] = {"color": style.BLACK, "linewidth": 2.6, "alpha": 0.45}
"""The line of the elements: wide and pale, so that a filament that agrees is seen on it."""

_LINES: dict[str, dict[str, Any]] = {
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
    return {"label": row.name, **_LINES[row.name]}


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


def share_time(panels: Sequence[Axes], run: ElementRun | CalculixRun) -> None:
    """Give panels below one another one time axis: labelled under the last, in L sqrt(rho/E) above the first."""
    clock = time_unit(float(run.time[-1]))
    for axes in panels:
        axes.set_xlim(0.0, float(clock.of(run.time[-1])))
        axes.grid(True)
        style.lighten(axes)
        plain_numbers(axes)
        axes.tick_params(labelbottom=axes is panels[-1])
    panels[-1].set_xlabel(f"time [{clock.symbol}]")
    top = panels[0].secondary_xaxis("top", functions=secondary_scale(clock.size / run.elastic_time))
    top.set_xlabel("time in L √(ρ/E)")


# A published theory may run away: beyond this many per cent, and this multiple of the filament's own error, it leaves
# the picture.
_WORST, _TIMES_OWN, _ROOM = 5.0, 3.0, 1.15


def midpoint_figure(comparison: Comparison) -> Figure:
    """Draw midpoints above, (filament - elements)/max |elements| below."""
    summary = comparison.filament.trajectory.summary
    with style.styled():
        figure, body = headed(comparison.scene, "midpoint, filament against elements", summary, height=4.9)
        above, below = body.subplots(2, 1, height_ratios=[2, 1])
        _heights(above, comparison)
        _differences(below, comparison)
        share_time((above, below), comparison.elements)
        legend(body, "upper left", handles=above.get_legend_handles_labels()[0], ncols=4)
    return figure


def _heights(axes: Axes, comparison: Comparison) -> None:
    elements = comparison.elements
    ruler = length_unit(float(np.abs(elements.midpoint).max()), comparison.scene.filament.span)
    time = clock_of(comparison).of(elements.time)
    axes.plot(time, ruler.of(elements.midpoint), label=elements_name(comparison), **ELEMENTS)
    for row in comparison.filaments:
        axes.plot(time, ruler.of(row.midpoint), **line_of(row))
    every = np.concatenate([elements.midpoint, *(row.midpoint for row in comparison.filaments)])
    own = comparison.filament
    far = trusted_extent(elements.midpoint, own.midpoint, trusted=own.trajectory.outcome.is_success)
    far = far or comparison.scene.filament.span
    low, high = (float(np.clip(bound, -far, far)) for bound in (np.nanmin(every), np.nanmax(every)))
    room = (_ROOM - 1) * max(high - low, 0.1 * far)
    axes.set_ylim(float(ruler.of(min(low, 0.0) - room)), float(ruler.of(max(high, 0.0) + room / 2)))
    axes.set_ylabel(f"midpoint height [{ruler.symbol}]")


def _differences(axes: Axes, comparison: Comparison) -> None:
    time = clock_of(comparison).of(comparison.elements.time)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6)
    for row in comparison.filaments:
        axes.plot(time, 100 * row.discrepancy.error, **line_of(row))
    known = np.nan_to_num([100 * row.discrepancy.largest for row in comparison.filaments])
    shown = min(float(known.max()), max(_TIMES_OWN * float(known[0]), _WORST)) or 1.0
    axes.set_ylim(-_ROOM * shown, _ROOM * shown)
    axes.set_ylabel("(filament − elements)\n/ max |elements| [%]", fontsize=8.0)


def clamp_figure(comparison: Comparison) -> Figure:
    """Draw the largest strain above, the mean below."""
    summary, X = comparison.filament.trajectory.summary, comparison.elements.X
    notes = (
        "Over the Gauss points of the elements at the clamp "
        f"({(X[-1] - X[-3]) / comparison.scene.filament.thickness:.2g} of a thickness long): "
        "log |F e_X| of the elements, log s − θ_s z of the filament in its fibres through the same material points."
    )
    time = clock_of(comparison).of(comparison.elements.time)
    with style.styled():
        figure, body = headed(comparison.scene, "axial true strain at the clamp", summary, height=4.4, notes=notes)
        panels = body.subplots(2, 1)
        for axes, which in zip(panels, ("largest", "mean"), strict=True):
            reference = getattr(comparison.clamp_strain, which)
            axes.plot(time, reference, label=elements_name(comparison), **ELEMENTS)
            for row in comparison.filaments:
                axes.plot(time, getattr(row.clamp_strain, which), **line_of(row))
            own = getattr(comparison.filament.clamp_strain, which)
            far = trusted_extent(reference, own, trusted=comparison.filament.trajectory.outcome.is_success) or 1e-3
            low = min(float(np.nanmin([reference, own])), 0.0)
            axes.set_ylim(max(low - 0.05 * far, -far), min(axes.get_ylim()[1], far))
            axes.set_ylabel(f"{which} strain")
        share_time(panels, comparison.elements)
        legend(body, "upper left", handles=panels[0].get_legend_handles_labels()[0], ncols=4)
    return figure


_LOWEST, _TALLEST = 1.1, 4.5
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
    # Of axes that are five inches wide, drawn true; what is flat or deep is stretched.
    true = 5.0 * 1.12 * deepest / (1.04 * span)
    tall = min(max(true, _LOWEST), _TALLEST)
    ruler = length_unit(span)
    with style.styled():
        summary = comparison.filament.trajectory.summary
        figure, body = headed(comparison.scene, "centrelines", summary, height=tall + 3.0)
        above, below = body.subplots(2, 1, height_ratios=[tall, 1.5])
        _centrelines(above, pairs, comparison, ruler)
        above.set_xlim(*ruler.of([-0.52 * span, 0.52 * span]))
        above.set_ylim(*ruler.of([-1.08 * deepest, 0.04 * deepest]))
        above.set_box_aspect(tall / 5.0)
        scale = "" if abs(tall / true - 1) < 1e-9 else f"; vertical scale × {tall / true:.3g}"
        above.set_xlabel(f"x [{ruler.symbol}]{scale}", labelpad=1.0)
        above.set_ylabel(f"y [{ruler.symbol}]")
        style.lighten(above)
        _distances(below, pairs, span)
        both = [
            Line2D([], [], color=style.GREY, linewidth=2.4, label="filament (coloured by time)"),
            Line2D([], [], color=style.BLACK, linewidth=0.9, linestyle=(0, (4, 3)), label=elements_name(comparison)),
        ]
        legend(body, "upper left", handles=both, ncols=2)
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
    # Of panels four inches wide; the deepest shape is no taller than a page allows.
    heights = [float(np.clip(4.0 / (0.54 * span) * (np.ptp(field.y) + thickness), 1.0, 2.2)) for field in fields]
    flows = any((field.rate > 0).any() for field in fields)
    ruler, norm, clock = length_unit(span), _scale(fields), clock_of(comparison)
    notes = _RATE_NOTE if flows else "Nothing flows, at none of the times at which the field was kept."
    what, height = "plastic shear rate in the elements", sum(heights) + 0.35 * len(heights) + 0.9
    with style.styled():
        figure, body = headed(comparison.scene, what, {}, height=height, notes=notes)
        panels = body.subplots(len(fields), 2, squeeze=False, height_ratios=heights, width_ratios=[4.0, 1.75])
        for field, (whole, close) in zip(fields, panels, strict=True):
            drawn = _strip(whole, field, norm, ruler)
            _strip(close, field, norm, ruler)
            low, high = float(field.y.min()) - thickness / 2, float(field.y.max()) + thickness / 2
            _window(whole, ruler, (-0.02 * span, 0.52 * span), (low, high))
            beside, half = span / 2 - 0.45 * _CLOSE * thickness, _CLOSE * thickness / 2
            level = float(np.interp(beside, field.x[:, len(field.x[0]) // 2], field.y[:, len(field.x[0]) // 2]))
            _window(close, ruler, (beside - half, beside + half), (level - half / 2, level + half / 2))
            whole.set_title(f"t = {clock.text(field.time)}", loc="left", fontsize=8.5, pad=3.0)
            close.set_title("at the clamp", loc="left", fontsize=8.5, pad=3.0)
            whole.set_ylabel(f"y [{ruler.symbol}]")
        for axes in panels[-1]:
            axes.set_xlabel(f"x [{ruler.symbol}]", labelpad=1.0)
        if flows:
            bar = body.colorbar(drawn, ax=panels, location="bottom", extend="min", aspect=50, fraction=0.04, pad=0.02)
            bar.set_label("plastic shear rate [1/s]")
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


def _window(axes: Axes, ruler: Unit, x: tuple[float, float], y: tuple[float, float]) -> None:
    """Limits [m], widened to where lengths are equal along both axes."""
    axes.set_xlim(*ruler.of(x), auto=True)
    axes.set_ylim(*ruler.of(y), auto=True)
    axes.set_aspect("equal", adjustable="datalim")


def midpoint_csv(comparison: Comparison) -> bytes:
    """Midpoints [m] of all, frame by frame; empty after a run has ended early."""
    columns = {"time_s": comparison.elements.time, "elements_m": comparison.elements.midpoint}
    return columns_csv(columns | {f"{_key(row)}_m": row.midpoint for row in comparison.filaments})


def clamp_csv(comparison: Comparison) -> bytes:
    """Mean and largest axial true strain at the clamp, of all, frame by frame."""
    rows = [("elements", comparison.clamp_strain)] + [(_key(row), row.clamp_strain) for row in comparison.filaments]
    strains = {f"{name}_{which}": getattr(strain, which) for name, strain in rows for which in ("mean", "largest")}
    return columns_csv({"time_s": comparison.elements.time, **strains})


def errors_csv(comparison: Comparison) -> bytes:
    """The error table: a column for each theory; a row for each moment, the mean and the largest error."""
    frames = compare.moments(len(comparison.elements.time))
    what = [*("error" for _ in frames), "mean error", "largest error"]
    time = [*(float(comparison.elements.time[frame]) for frame in frames), math.nan, math.nan]
    found = {_key(row): row.discrepancy for row in comparison.filaments}
    return columns_csv({"what": what, "time_s": time, **{key: [*d.at, d.mean, d.largest] for key, d in found.items()}})


def shapes_csv(comparison: Comparison) -> bytes:
    """Half centrelines of elements and filament at the moments of the error table [m]."""
    pairs = shape_pairs(comparison)
    places = {"X_m": [pair.X for pair in pairs]}
    for who in ("elements", "filament"):
        places |= {f"{who}_{axis}_m": [getattr(pair, who)[:, k] for pair in pairs] for k, axis in enumerate("xy")}
    time = [np.full(len(pair.X), pair.time) for pair in pairs]
    return columns_csv({name: np.concatenate(parts) for name, parts in {"time_s": time, **places}.items()})


def rate_csv(comparison: Comparison) -> bytes:
    """Plastic shear rate [1/s] of the elements at their Gauss points, at the moments that are drawn."""
    fields = rate_fields(comparison.elements, comparison.scene.filament.thickness)
    parts = {
        "time_s": [np.full(field.rate.size, field.time) for field in fields],
        "X_m": [field.X.ravel() for field in fields],
        "Y_m": [field.Y.ravel() for field in fields],
        "plastic_shear_rate_per_s": [field.rate.ravel() for field in fields],
    }
    return columns_csv({name: np.concatenate(values) for name, values in parts.items()})


def document(comparison: Comparison) -> dict[str, Any]:
    """What ``compare.json`` holds; every number finite or null.

    ``elements`` and each filament state ``midpoint_final_m``, ``midpoint_mean_m`` (over the last 6/7), ``wall_s`` and
    ``dofs``.
    """
    own, run = comparison.filament, comparison.elements
    summary = own.trajectory.summary
    frames = compare.moments(len(run.time))
    times = [float(run.time[frame]) for frame in frames]
    return {
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


def _errors(row: FilamentRow | CalculixRow) -> dict[str, Any]:
    return {"at": list(row.discrepancy.at), "mean": row.discrepancy.mean, "largest": row.discrepancy.largest}


def _last(strain: compare.ClampStrain) -> dict[str, float]:
    return {"mean": float(strain.mean[-1]), "largest": float(strain.largest[-1])}


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
    header, *rows = zip(row_names(comparison), *comparison_columns(comparison), strict=True)
    for old, new in (("elements ", "elements\n"), (", ", ",\n"), (" closure", "\nclosure")):
        header = tuple(name.replace(old, new) for name in header)
    caption = "errors in %: (filament − elements)/max |elements|, midpoint; t in L √(ρ/E)"
    title = comparison.scene.title or "Filament"
    return text_table(header, rows, title=title, caption=caption, right=range(1, len(header)), whole=range(9))


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
    """Write ``compare.json``, ``scene.toml``, four pictures and their tables."""
    contents: dict[str, object] = {
        "compare.json": document(comparison),
        "scene.toml": comparison.scene.to_toml(),
        "compare_midpoint.png": midpoint_figure(comparison),
        "compare_shapes.png": shapes_figure(comparison),
        "compare_plastic_rate.png": rate_figure(comparison),
        "compare_clamp_strain.png": clamp_figure(comparison),
        "compare_errors.csv": errors_csv(comparison),
        "compare_midpoint.csv": midpoint_csv(comparison),
        "compare_shapes.csv": shapes_csv(comparison),
        "compare_plastic_rate.csv": rate_csv(comparison),
        "compare_clamp_strain.csv": clamp_csv(comparison),
    }
    return write_results(directory, contents)


_CALCULIX_LINES: dict[str, dict[str, Any]] = {
    "filament": _LINES["filament"],
    "elements": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
}


def calculix_figure(comparison: CalculixComparison) -> Figure:
    """Draw midpoints above, (ours - CalculiX)/max |CalculiX| below."""
    run, span = comparison.calculix, comparison.scene.filament.span
    ruler = length_unit(float(np.abs(run.midpoint).max()), span)
    time, summary = time_unit(float(run.time[-1])).of(run.time), comparison.trajectory.summary
    with style.styled():
        figure, body = headed(comparison.scene, "midpoint, ours against CalculiX", summary, height=4.9)
        above, below = body.subplots(2, 1, height_ratios=[2, 1])
        name = f"CalculiX {run.mesh.along} × {run.mesh.through}"
        above.plot(time, ruler.of(run.midpoint), label=name, **ELEMENTS)
        below.axhline(0.0, color=style.GREY, linewidth=0.6)
        for row in comparison.rows:
            above.plot(time, ruler.of(row.midpoint), label=row.name, **_CALCULIX_LINES[row.name])
            below.plot(time, 100 * row.discrepancy.error, **_CALCULIX_LINES[row.name])
        far = 2 * float(ruler.of(np.abs(run.midpoint).max())) or 1.0
        low, high = above.get_ylim()
        above.set_ylim(max(low, -far), min(high, far))
        shown = float(np.nan_to_num([100 * row.discrepancy.largest for row in comparison.rows]).max()) or 1.0
        below.set_ylim(-_ROOM * shown, _ROOM * shown)
        above.set_ylabel(f"midpoint height [{ruler.symbol}]")
        below.set_ylabel("(ours − CalculiX)\n/ max |CalculiX| [%]", fontsize=8.0)
        share_time((above, below), run)
        legend(body, "upper left", handles=above.get_legend_handles_labels()[0], ncols=4)
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
    """Write ``compare.json``, ``compare_midpoint.png`` and ``.csv``, ``scene.toml``, ``calculix/`` with the deck."""
    folder = Path(directory)
    contents: dict[str, object] = {
        "compare.json": calculix_document(comparison),
        "scene.toml": comparison.scene.to_toml(),
        "compare_midpoint.png": calculix_figure(comparison),
        "compare_midpoint.csv": _midpoint_csv(comparison),
    }
    return [*write_results(folder, contents), *write_all(folder / FOLDER, comparison.calculix.files)]


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
            **_midpoints(run.time, run.midpoint),
            "wall_s": run.wall,
            "dofs": run.dofs,
            "steps": run.steps,
            "along": run.mesh.along,
            "through": run.mesh.through,
            "clamp": run.clamp.name.lower(),
        },
        **{
            row.name: {
                **_midpoints(run.time, row.midpoint),
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
            **{row.name: _errors(row) for row in comparison.rows},
        },
    }


def calculix_table(comparison: CalculixComparison) -> Table:
    """The table that is printed: CalculiX and ours side by side."""
    run, rows, span = comparison.calculix, comparison.rows, comparison.scene.filament.span
    times = (run.time[frame] / run.elastic_time for frame in moments(len(run.time)))
    every: list[Any] = [run, *rows]
    lines = [("final midpoint / L", *(f"{y[-1] / span:.5f}" for y in (run.midpoint, *(row.midpoint for row in rows))))]
    lines += [
        (f"error at t = {time:.4g}", "", *(f"{100 * row.discrepancy.at[k]:+.2f}" for row in rows))
        for k, time in enumerate(times)
    ]
    lines += [
        ("mean error", "", *(f"{100 * row.discrepancy.mean:+.2f}" for row in rows)),
        ("largest error", "", *(f"{100 * row.discrepancy.largest:.2f}" for row in rows)),
        ("unknowns", *(str(one.dofs) for one in every)),
        ("steps", *(str(one.steps) for one in every)),
        ("wall time [s]", *(f"{one.wall:.3g}" for one in every)),
    ]
    header = ("", f"CalculiX {run.mesh.along} × {run.mesh.through}", *(row.name for row in rows))
    caption = "errors in %: (ours − CalculiX)/max |CalculiX|, midpoint; t in L √(ρ/E)"
    return text_table(header, lines, caption=caption, right=range(1, len(header)), box=box.SIMPLE)


def _midpoint_csv(comparison: CalculixComparison) -> bytes:
    """Midpoints [m], frame by frame; empty after a run has ended early."""
    columns = {"time_s": comparison.calculix.time, "calculix_m": comparison.calculix.midpoint}
    return columns_csv(columns | {f"{row.name}_m": row.midpoint for row in comparison.rows})
