"""Work-precision diagrams: the error of an answer against the time it took, for several programs or settings.

A program has many settings (cells and tolerance, elements and step). All measured points are shown; the line joins
those that no other point of the same program beats in both time and error, its Pareto front: it is judged at its best.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isclose, isfinite, log10
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING

from softcat_sym.files import write_all
from softcat_sym.plotting import style
from softcat_sym.plotting.style import HEADING, axes_in_inches, new_figure, png

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_COLOURS = (
    *(style.BLUE, style.VERMILLION, style.ORANGE, style.GREEN, style.PURPLE),
    *(style.SKY, style.BLACK, style.GREY),
)
_MARKS = ("o", "s", "^", "D", "v", "P", "X")
_LEFT, _RIGHT, _ACROSS, _DOWN, _PANEL, _BOTTOM, _LINE = 0.72, 0.15, 0.55, 0.72, 2.0, 0.5, 0.145
_ALONE, _IN_A_ROW, _LEGEND = 3.4, 4, 0.16
_USELESS = 0.3
"""A relative error that no axis is stretched for."""

_COLUMNS, _LETTERS = 2, 122
_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True, slots=True)
class WorkPoint:
    """One run."""

    seconds: float  # What it took, above zero [s]
    error: float  # Relative error of the answer, above zero; not finite for a run that failed, which is not drawn
    setting: str = ""  # What was set, such as ``"40 cells, rtol 1e-3"``; for the table


@dataclass(frozen=True, slots=True)
class WorkCurve:
    """All runs of one program; that of a rival is dashed."""

    name: str
    points: tuple[WorkPoint, ...]
    is_rival: bool = False


@dataclass(frozen=True, slots=True)
class WorkPanel:
    """Programs on one problem."""

    title: str
    curves: tuple[WorkCurve, ...]


def front(points: Sequence[WorkPoint]) -> tuple[WorkPoint, ...]:
    """Runs that no other run beats in both time and error, by growing time and falling error."""
    best: list[WorkPoint] = []
    for point in sorted(points, key=lambda p: (p.seconds, p.error)):
        if isfinite(point.error) and (not best or point.error < best[-1].error):
            best.append(point)
    return tuple(best)


def seconds_for(points: Sequence[WorkPoint], error: float) -> float | None:
    """Time of the quickest run with at most this error [s]; None if there is none."""
    return min((point.seconds for point in points if point.error <= error), default=None)


def work_precision_figure(
    panels: Sequence[WorkPanel], title: str, caption: str = "", floor: float | None = None
) -> Figure:
    """Draw one panel a problem, two in a row, all on the same axes."""
    drawn = [p for panel in panels for curve in panel.curves for p in curve.points if isfinite(p.error)]
    if not drawn:
        raise ValueError("there is no run with an error to draw")
    columns = min(_COLUMNS, len(panels))
    rows = -(-len(panels) // columns)
    lines = wrap(caption, _LETTERS)
    foot = _BOTTOM + 0.12 + _LINE * len(lines)
    panel_height = _ALONE if len(panels) == 1 and floor else _PANEL
    width = (style.WIDTH - _LEFT - _RIGHT - (columns - 1) * _ACROSS) / columns
    names = list(dict.fromkeys(curve.name for panel in panels for curve in panel.curves))
    legend = _LEGEND * ((len(names) - 1) // _IN_A_ROW)
    height = HEADING + 0.18 + legend + rows * panel_height + (rows - 1) * _DOWN + foot
    errors = [p.error for p in drawn if p.error <= _USELESS] or [p.error for p in drawn]
    limits = _limits([p.seconds for p in drawn]), _limits(errors + ([floor] if floor else []))
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        for number, panel in enumerate(panels):
            row, column = divmod(number, columns)
            bottom = foot + (rows - 1 - row) * (panel_height + _DOWN)
            axes = axes_in_inches(figure, _LEFT + column * (width + _ACROSS), bottom, width, panel_height)
            _draw_panel(axes, panel, names, limits)
            if floor:
                axes.axhspan(limits[1][0], floor, color=style.FILAMENT, lw=0, zorder=0)
            axes.set_ylabel("relative error" if column == 0 else "")
            axes.set_xlabel("seconds")
        _write_around(figure, title, lines, len(names))
    return figure


def _write_around(figure: Figure, title: str, caption: Sequence[str], names: int) -> None:
    """Title and legend along the top, caption below."""
    height, left = figure.get_size_inches()[1], 0.2 / style.WIDTH
    head = style.printable(title, 90)
    figure.text(left, 1 - 0.12 / height, head, va="top", fontsize=10.5, fontweight="bold", parse_math=False)
    handles, place = figure.axes[0].get_legend_handles_labels(), (left, 1 - 0.3 / height)
    across = min(names, _IN_A_ROW)
    figure.legend(*handles, loc="upper left", bbox_to_anchor=place, ncols=across, borderaxespad=0.0)
    figure.text(left, 0.1 / height, "\n".join(caption), va="bottom", fontsize=7.5, parse_math=False)


def work_precision_csv(panels: Sequence[WorkPanel]) -> bytes:
    """One row a run: problem, program, setting, seconds, error; empty where a run failed."""
    rows = ["problem,program,setting,seconds,relative_error,on_front\n"]
    for panel in panels:
        for curve in panel.curves:
            best = set(front(curve.points))
            for point in curve.points:
                error = repr(float(point.error)) if isfinite(point.error) else ""
                cells = [f'"{text.replace(chr(34), chr(39))}"' for text in (panel.title, curve.name, point.setting)]
                rows.append(",".join([*cells, repr(float(point.seconds)), error, str(int(point in best))]) + "\n")
    return "".join(rows).encode()


def draw(panels: Sequence[WorkPanel], path: str | Path, title: str, caption: str = "") -> list[Path]:
    """Write the picture to `path`, a PNG, and its numbers beside it as CSV."""
    place = Path(path)
    picture = png(work_precision_figure(panels, title, caption))
    return write_all(place.parent, {place.name: picture, f"{place.stem}.csv": work_precision_csv(panels)})


def power_of_ten(value: float, place: float = 0) -> str:
    """Tick label of a decade without Mathtext, whose fonts not every machine has; other values are not labelled."""
    del place
    power = round(log10(value))
    return f"10{str(power).translate(_SUPERSCRIPT)}" if isclose(value, 10.0**power, rel_tol=1e-9) else ""


def _draw_panel(
    axes: Axes, panel: WorkPanel, names: Sequence[str], limits: tuple[tuple[float, float], tuple[float, float]]
) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(*limits[0])
    axes.set_ylim(*limits[1])
    axes.grid(True)
    axes.minorticks_off()
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(power_of_ten)
    for name in names:
        named = [curve for curve in panel.curves if curve.name == name]
        points = [point for curve in named for point in curve.points]
        line = "--" if any(curve.is_rival for curve in named) else "-"
        number = names.index(name)
        colour, mark = _COLOURS[number % len(_COLOURS)], _MARKS[number % len(_MARKS)]
        shown = [point for point in points if isfinite(point.error)]
        axes.plot(
            [p.seconds for p in shown], [p.error for p in shown], mark, color=colour, markersize=3, alpha=0.3, mew=0
        )
        best = front(points)
        axes.plot(
            [p.seconds for p in best],
            [p.error for p in best],
            f"{line}{mark}",
            color=colour,
            markersize=4,
            label=style.printable(name, 50),
        )
    axes.set_title(style.printable(panel.title), fontsize=9, loc="left", parse_math=False)
    style.lighten(axes)


def _limits(values: Sequence[float]) -> tuple[float, float]:
    """A little more than the range of positive numbers on a logarithmic axis."""
    low, high = min(values), max(values)
    room = max((high / low) ** 0.06, 1.3)
    return low / room, high * room
