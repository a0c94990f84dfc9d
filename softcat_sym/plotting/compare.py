"""A comparison with finite elements: pictures, the table of the terminal, files."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from rich.console import Console
from rich.text import Text

from softcat_sym.discretization.grid import Floats
from softcat_sym.files import write_all
from softcat_sym.plotting import style
from softcat_sym.plotting.files import write_results
from softcat_sym.plotting.section import node_angles
from softcat_sym.plotting.style import headed, legend, secondary_scale
from softcat_sym.plotting.terminal import text_table
from softcat_sym.plotting.units import length_unit, significant, time_unit
from softcat_sym.studies.compare import SHARES, Comparison, moments

if TYPE_CHECKING:
    from softcat_sym.reference.elements import ElementRun

document = Comparison.to_dict

# The reference is wide and pale, so that a filament that agrees is seen on it.
_REFERENCE: dict[str, Any] = {"color": style.BLACK, "linewidth": 2.6, "alpha": 0.45}
_DASHES = (0, (5, 1.5))
_LINES: dict[str, dict[str, Any]] = {
    "filament": {"color": style.BLUE, "linewidth": 1.3},
    "elements": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": _DASHES},
    "published_material_closure": {"color": style.ORANGE, "linewidth": 1.2, "linestyle": _DASHES},
    "published_printed_closure": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": (0, (1.5, 1.2))},
}
_COLOURS = (style.SKY, style.GREEN, style.ORANGE, style.VERMILLION)


def figures(comparison: Comparison) -> dict[str, Figure]:
    """Every picture by its name."""
    found = {"compare_midpoint": midpoint_figure(comparison)}
    if not comparison.with_calculix:
        found["compare_shapes"] = shapes_figure(comparison)
        found["compare_plastic_rate"] = rate_figure(comparison)
        found["compare_clamp_strain"] = clamp_figure(comparison)
    return found


def write_comparison(comparison: Comparison, directory: str | Path) -> list[Path]:
    """Write ``compare.json``, ``scene.toml``, pictures and tables; of CalculiX its deck and what it prints."""
    tables = {"compare_midpoint": comparison.to_frame()}
    if not comparison.with_calculix:
        tables["compare_errors"] = comparison.errors_frame()
        tables["compare_shapes"] = shapes_frame(comparison)
        tables["compare_plastic_rate"] = rate_frame(comparison)
        tables["compare_clamp_strain"] = comparison.clamp_frame()
    contents: dict[str, object] = {"compare.json": comparison.to_dict(), "scene.toml": comparison.scene.to_toml()}
    contents |= {f"{name}.png": figure for name, figure in comparison.figures().items()}
    contents |= {f"{name}.csv": table.to_csv(index=False, lineterminator="\n") for name, table in tables.items()}
    written = write_results(directory, contents)
    files = getattr(comparison.reference, "files", {})
    return [*written, *(write_all(Path(directory) / "calculix", files) if files else [])]


def _reference_name(comparison: Comparison) -> str:
    mesh = comparison.reference.mesh
    return f"{'CalculiX' if comparison.with_calculix else 'elements'} {mesh.along} × {mesh.through}"


def _extent(reference: Floats, comparison: Comparison, own: Floats) -> float:
    """How far a picture reaches, in magnitude; whatever runs away beyond leaves it."""
    far = 2 * float(np.abs(reference).max())
    trusted = comparison.filament.trajectory.outcome.is_success
    return max(far, 1.05 * float(np.nanmax(np.abs(own)))) if trusted else far


def _share_time(panels: Sequence[Axes], comparison: Comparison) -> None:
    """Give panels below one another one time axis, in L sqrt(rho/E) above the first."""
    run = comparison.reference
    clock = time_unit(float(run.time[-1]))
    for axes in panels:
        axes.set_xlim(0.0, float(clock.of(run.time[-1])))
        axes.tick_params(labelbottom=axes is panels[-1])
        _dress(axes)
    panels[-1].set_xlabel(f"time [{clock.symbol}]")
    top = panels[0].secondary_xaxis("top", functions=secondary_scale(clock.size / run.elastic_time))
    top.set_xlabel("time in L √(ρ/E)")


def _dress(axes: Axes) -> None:
    axes.grid(True)
    # A common power of ten would stand in the way of what is above.
    axes.yaxis.set_major_formatter("{x:.3g}")
    style.lighten(axes)


def midpoint_figure(comparison: Comparison) -> Figure:
    """Draw midpoints above, their differences over the reference's largest below."""
    run, rows, span = comparison.reference, comparison.rows, comparison.scene.filament.span
    ours, theirs = ("ours", "CalculiX") if comparison.with_calculix else ("filament", "elements")
    ruler = length_unit(float(np.abs(run.midpoint).max()), span)
    time = time_unit(float(run.time[-1])).of(run.time)
    with style.styled():
        summary = comparison.filament.trajectory.summary
        figure, body = headed(comparison.scene, f"midpoint, {ours} against {theirs}", summary, height=4.9)
        above, below = body.subplots(2, 1, height_ratios=[2, 1])
        above.plot(time, ruler.of(run.midpoint), label=_reference_name(comparison), **_REFERENCE)
        below.axhline(0.0, color=style.GREY, linewidth=0.6)
        for row in rows:
            above.plot(time, ruler.of(row.midpoint), label=row.name, **_LINES[row.key])
            below.plot(time, 100 * row.discrepancy.error, **_LINES[row.key])
        far = float(ruler.of(_extent(run.midpoint, comparison, comparison.filament.midpoint) or span))
        low, high = above.get_ylim()
        above.set_ylim(max(low, -far), min(high, far))
        # A published theory may run away: beyond 5 %, and three times the filament's own error, it leaves the picture.
        known = np.nan_to_num([100 * row.discrepancy.largest for row in rows])
        shown = min(float(known.max()), max(3 * float(known[0]), 5.0)) or 1.0
        below.set_ylim(-1.15 * shown, 1.15 * shown)
        above.set_ylabel(f"midpoint height [{ruler.symbol}]")
        below.set_ylabel(f"({ours} − {theirs})\n/ max |{theirs}| [%]", fontsize=8.0)
        _share_time((above, below), comparison)
        legend(body, "upper left", handles=above.get_legend_handles_labels()[0], ncols=4)
    return figure


def clamp_figure(comparison: Comparison) -> Figure:
    """Draw the largest strain above, the mean below."""
    run, strains = comparison.elements, comparison.clamp_strains
    notes = (
        "Over the Gauss points of the elements at the clamp "
        f"({(run.X[-1] - run.X[-3]) / comparison.scene.filament.thickness:.2g} of a thickness long): "
        "log |F e_X| of the elements, log s − θ_s z of the filament in its fibres through the same material points."
    )
    time = time_unit(float(run.time[-1])).of(run.time)
    with style.styled():
        summary = comparison.filament.trajectory.summary
        figure, body = headed(comparison.scene, "axial true strain at the clamp", summary, height=4.4, notes=notes)
        panels = body.subplots(2, 1)
        for axes, which in zip(panels, ("largest", "mean"), strict=True):
            reference, own = (getattr(strains[key], which) for key in ("elements", comparison.filament.key))
            axes.plot(time, reference, label=_reference_name(comparison), **_REFERENCE)
            for row in comparison.filaments:
                axes.plot(time, getattr(strains[row.key], which), label=row.name, **_LINES[row.key])
            far = _extent(reference, comparison, own) or 1e-3
            low = min(float(np.nanmin([reference, own])), 0.0)
            axes.set_ylim(max(low - 0.05 * far, -far), min(axes.get_ylim()[1], far))
            axes.set_ylabel(f"{which} strain")
        _share_time(panels, comparison)
        legend(body, "upper left", handles=panels[0].get_legend_handles_labels()[0], ncols=4)
    return figure


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


def shapes_frame(comparison: Comparison) -> pd.DataFrame:
    """Half centrelines of elements and filament at the moments of the error table [m]."""
    pairs = shape_pairs(comparison)
    columns = {"time_s": [np.full(len(pair.X), pair.time) for pair in pairs], "X_m": [pair.X for pair in pairs]}
    for who in ("elements", "filament"):
        columns |= {f"{who}_{axis}_m": [getattr(pair, who)[:, k] for pair in pairs] for k, axis in enumerate("xy")}
    return pd.DataFrame({name: np.concatenate(parts) for name, parts in columns.items()})


def shapes_figure(comparison: Comparison) -> Figure:
    """Draw centrelines above, the distance of equal material points below."""
    pairs, span = shape_pairs(comparison), comparison.scene.filament.span
    deepest = max((float(np.abs(pair.elements[:, 1]).max()) for pair in pairs), default=0.0) or 0.01 * span
    # Of axes that are five inches wide, drawn true; what is flat or deep is stretched.
    true = 5.0 * 1.12 * deepest / (1.04 * span)
    tall = float(np.clip(true, 1.1, 4.5))
    ruler, clock = length_unit(span), time_unit(float(comparison.elements.time[-1]))
    dashed: dict[str, Any] = {"color": style.BLACK, "linewidth": 0.9, "linestyle": (0, (4, 3))}
    with style.styled():
        summary = comparison.filament.trajectory.summary
        figure, body = headed(comparison.scene, "centrelines", summary, height=tall + 3.0)
        above, below = body.subplots(2, 1, height_ratios=[tall, 1.5])
        for pair, colour in zip(pairs, _COLOURS, strict=False):
            for side in (-1, 1):
                x, y = ruler.of(pair.filament).T
                label = f"t = {clock.text(pair.time)}" if side > 0 else None
                above.plot(side * x, y, color=colour, linewidth=2.4, label=label, solid_capstyle="butt")
                x, y = ruler.of(pair.elements).T
                above.plot(side * x, y, zorder=3, **dashed)
            below.plot(pair.X / span, 100 * pair.distance / span, color=colour, linewidth=1.3)
        above.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0, handlelength=1.4)
        above.set_xlim(*ruler.of([-0.52 * span, 0.52 * span]))
        above.set_ylim(*ruler.of([-1.08 * deepest, 0.04 * deepest]))
        above.set_box_aspect(tall / 5.0)
        scale = "" if abs(tall / true - 1) < 1e-9 else f"; vertical scale × {tall / true:.3g}"
        above.set_xlabel(f"x [{ruler.symbol}]{scale}", labelpad=1.0)
        above.set_ylabel(f"y [{ruler.symbol}]")
        style.lighten(above)
        below.set_xlim(0.0, 0.5)
        below.set_ylim(bottom=0.0)
        below.set_xlabel("X / L, midspan to clamp")
        below.set_ylabel("distance / L [%]")
        _dress(below)
        both = [
            Line2D([], [], color=style.GREY, linewidth=2.4, label="filament (coloured by time)"),
            Line2D([], [], label=_reference_name(comparison), **dashed),
        ]
        legend(body, "upper left", handles=both, ncols=2)
    return figure


@dataclass(frozen=True)
class RateField:
    """Plastic shear rate at one time, each Gauss point on its quarter of an element."""

    time: float  # [s]
    x: Floats  # shape (2 along + 1, 2 through + 1); Corners of the quarters in the plane [m]
    y: Floats
    X: Floats  # shape (2 along, 2 through); Reference positions of the Gauss points [m]
    Y: Floats
    rate: Floats  # likewise; sqrt(3) times the equivalent tensile rate: the shear rate of the paper [1/s]


def rate_fields(run: ElementRun, thickness: float) -> list[RateField]:
    """The fields stored nearest to the moments of the error table, and the one that flows fastest.

    Of those before the last only what flows is worth a picture: a filament that is held early needs no four of them.
    """
    largest = run.rate.max(axis=(1, 2))
    near = {int(np.abs(run.rate_time - share * run.time[-1]).argmin()) for share in SHARES}
    flowing = {field for field in {*near, int(largest.argmax())} if largest[field] > 0}
    return [_field(run, thickness, field) for field in sorted(flowing | {len(largest) - 1})]


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
    after, before = (np.interp(X + side * thickness / 4, places, area) for side in (1, -1))
    return np.asarray((after - before) / (thickness / 2))


def rate_frame(comparison: Comparison) -> pd.DataFrame:
    """Plastic shear rate [1/s] of the elements at their Gauss points, at the moments that are drawn."""
    fields = rate_fields(comparison.elements, comparison.scene.filament.thickness)
    columns = {
        "time_s": [np.full(field.rate.size, field.time) for field in fields],
        "X_m": [field.X.ravel() for field in fields],
        "Y_m": [field.Y.ravel() for field in fields],
        "plastic_shear_rate_per_s": [field.rate.ravel() for field in fields],
    }
    return pd.DataFrame({name: np.concatenate(parts) for name, parts in columns.items()})


def rate_figure(comparison: Comparison) -> Figure:
    """Draw the fields below one another, the whole half span on the left, the clamp on the right."""
    span, thickness = comparison.scene.filament.span, comparison.scene.filament.thickness
    fields = rate_fields(comparison.elements, thickness)
    # Of panels four inches wide; the deepest shape is no taller than a page allows.
    heights = [float(np.clip(4.0 / (0.54 * span) * (np.ptp(field.y) + thickness), 1.0, 2.2)) for field in fields]
    top = max(float(field.rate.max()) for field in fields)
    ruler, clock = length_unit(span), time_unit(float(comparison.elements.time[-1]))
    notes = (
        "√3 times the equivalent tensile rate, at the Gauss points; grey: no flow, or slower than the scale.\n"
        "Sections are drawn plane, normal to the centreline averaged over half a thickness, thinned as stretch^(−1/2)."
        if top > 0
        else "Nothing flows, at none of the times at which the field was stored."
    )
    resting = matplotlib.colormaps["viridis"].with_extremes(bad="#dcdcdc", under="#dcdcdc")
    coloured = {"norm": LogNorm(1e-4 * (top or 1.0), top or 1.0), "cmap": resting, "rasterized": True}
    what, height = "plastic shear rate in the elements", sum(heights) + 0.35 * len(heights) + 0.9
    with style.styled():
        figure, body = headed(comparison.scene, what, {}, height=height, notes=notes)
        panels = body.subplots(len(fields), 2, squeeze=False, height_ratios=heights, width_ratios=[4.0, 1.75])
        for field, (whole, close) in zip(fields, panels, strict=True):
            x, y = ruler.of(field.x), ruler.of(field.y)
            low, high = float(field.y.min()) - thickness / 2, float(field.y.max()) + thickness / 2
            beside, middle = span / 2 - 1.125 * thickness, field.x.shape[1] // 2
            level = float(np.interp(beside, field.x[:, middle], field.y[:, middle]))
            windows = (
                ((-0.02 * span, 0.52 * span), (low, high)),
                (
                    (beside - 1.25 * thickness, beside + 1.25 * thickness),
                    (level - 0.6 * thickness, level + 0.6 * thickness),
                ),
            )
            for axes, (across, up) in zip((whole, close), windows, strict=True):
                style.lighten(axes)
                # The outline hides the stairs of the quads, not anti-aliased lest hairlines show between them.
                edges = (np.concatenate([c[:, 0], c[-1], c[::-1, -1], c[0, ::-1]]) for c in (x, y))
                axes.plot(*edges, color=style.BLACK, linewidth=0.5, zorder=3)
                drawn = axes.pcolormesh(x, y, np.ma.masked_less_equal(field.rate, 0.0), **coloured)
                axes.set_xlim(*ruler.of(across), auto=True)
                axes.set_ylim(*ruler.of(up), auto=True)
                axes.set_aspect("equal", adjustable="datalim")
            whole.set_title(f"t = {clock.text(field.time)}", loc="left", fontsize=8.5, pad=3.0)
            close.set_title("at the clamp", loc="left", fontsize=8.5, pad=3.0)
            whole.set_ylabel(f"y [{ruler.symbol}]")
        for axes in panels[-1]:
            axes.set_xlabel(f"x [{ruler.symbol}]", labelpad=1.0)
        if top > 0:
            bar = body.colorbar(drawn, ax=panels, location="bottom", extend="min", aspect=50, fraction=0.04, pad=0.02)
            bar.set_label("plastic shear rate [1/s]")
    return figure


def print_comparison(comparison: Comparison, console: Console | None = None) -> None:
    """Print the table, each run that is not to be trusted, and every warning."""
    screen, run, rows = console or Console(), comparison.reference, comparison.rows
    span, found = comparison.scene.filament.span, [row.discrepancy for row in rows]
    times = [run.time[frame] / run.elastic_time for frame in moments(len(run.time))]
    ratios = [f"{y[-1] / span:.5f}" if np.isfinite(y[-1]) else "–" for y in (run.midpoint, *(r.midpoint for r in rows))]
    lines = [
        ("final midpoint / L", *ratios),
        *((f"error at t = {t:.4g}", "", *(_percent(one.at[k]) for one in found)) for k, t in enumerate(times)),
        ("mean error", "", *(_percent(one.mean) for one in found)),
        ("largest error", "", *(_percent(one.largest) for one in found)),
        ("unknowns", *(str(one.dofs) for one in (run, *rows))),
        ("wall time [s]", *(significant(one.wall) for one in (run, *rows))),
    ]
    header = ["", _reference_name(comparison), *(row.name for row in rows)]
    for old, new in (("elements ", "elements\n"), (", ", ",\n"), (" closure", "\nclosure")):
        header = [name.replace(old, new) for name in header]
    ours, theirs = ("ours", "CalculiX") if comparison.with_calculix else ("filament", "elements")
    caption = f"errors in %: ({ours} − {theirs})/max |{theirs}|, midpoint; t in L √(ρ/E)"
    title, right = comparison.scene.title or "Filament", range(1, len(header))
    screen.print(text_table(header, lines, title=title, caption=caption, right=right, whole=range(9)))
    for row in comparison.filaments:
        outcome = row.trajectory.outcome
        if not outcome.is_success:
            screen.print(Text(f"{row.name}: {outcome.name}; {outcome.value}"))
    for warning in comparison.warnings:
        screen.print(Text(f"warning: {warning}"))


def _percent(error: float) -> str:
    if not math.isfinite(error):
        return "–"
    return f"{100 * error:+.2f}" if abs(error) < 1 else f"{100 * error:+.3g}"
