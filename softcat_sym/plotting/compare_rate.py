"""The plastic shear rate in the elements, on the deformed strip: the whole half span, and next to the clamp."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import matplotlib
import numpy as np
from matplotlib.colors import LogNorm

from softcat_sym.discretization.grid import Floats
from softcat_sym.plotting import style
from softcat_sym.plotting.compare_axes import LEFT, clock_of
from softcat_sym.plotting.section import node_angles
from softcat_sym.plotting.style import HEADING, Unit, axes_in_inches, head, length_unit, new_figure
from softcat_sym.studies.compare import SHARES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.collections import QuadMesh
    from matplotlib.figure import Figure

    from softcat_sym.reference.elements import ElementRun
    from softcat_sym.studies.compare import Comparison

_RIGHT, _BOTTOM, _GAP, _BETWEEN, _BAR = 0.25, 1.4, 0.42, 0.55, 0.12
_CLOSE_WIDTH, _LEAST, _TALLEST, _TITLE = 1.75, 1.0, 2.2, 0.2

# Length of strip drawn next to the clamp, in thicknesses; decades of rate told apart.
_CLOSE = 2.5
_DECADES = 4.0
_RESTING = "#dcdcdc"
_NOTE = (
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
    width = style.WIDTH - LEFT - _RIGHT - _BETWEEN - _CLOSE_WIDTH
    # One scale for all: that of the width, or of the deepest shape where that would be taller than a page allows.
    scale = min([width / (0.54 * span), *(_TALLEST / (np.ptp(field.y) + thickness) for field in fields)])
    heights = [max(_LEAST, scale * (float(np.ptp(field.y)) + thickness)) for field in fields]
    flows = any((field.rate > 0).any() for field in fields)
    bottom = _BOTTOM if flows else _BOTTOM - 0.5
    height = bottom + sum(heights) + _GAP * (len(heights) - 1) + _TITLE + HEADING
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
            top -= tall + _GAP
        figure.axes[-2].set_xlabel(f"x [{ruler.symbol}]", labelpad=1.0)
        figure.axes[-1].set_xlabel(f"x [{ruler.symbol}]", labelpad=1.0)
        _explain(figure, drawn, flows=flows)
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


def _explain(figure: Figure, drawn: QuadMesh | None, *, flows: bool) -> None:
    width, height = figure.get_size_inches()
    if drawn is not None and flows:
        bar = axes_in_inches(figure, LEFT, 0.74, width - LEFT - _RIGHT - 1.7, _BAR)
        figure.colorbar(drawn, cax=bar, orientation="horizontal", extend="min")
        place = (width - _RIGHT - 1.6) / width
        figure.text(place, 0.8 / height, "plastic shear rate [1/s]", va="center", fontsize=8.5)
    note = _NOTE if flows else "Nothing flows, at none of the times at which the field was kept."
    figure.text(LEFT / width, 0.1 / height, note, fontsize=7.5, color=style.GREY, linespacing=1.35)
