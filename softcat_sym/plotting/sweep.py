"""Sweeps: pictures, files and the terminal."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import cycle
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D

from softcat_sym import drawing
from softcat_sym.batch.sweep import Sweep
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Report, TextTable
from softcat_sym.plotting import style
from softcat_sym.plotting.phase import AXES, LOOKS
from softcat_sym.plotting.units import Unit, length_unit, stress_unit, time_unit, typeset

if TYPE_CHECKING:
    import xarray as xr


MAX_DRAWN: Final = 4000
"""Members that a picture shows one by one; of more, so many evenly from the first to the last."""

_UNITS: Final[dict[str, Callable[[float], Unit]]] = {"Pa": stress_unit, "m": length_unit, "s": time_unit}
_OTHER_LOOKS: Final = (("D", style.SKY), ("P", style.PURPLE), ("*", style.BLACK))
_NO_ANSWER: Final[dict[str, Any]] = {"marker": "x", "c": style.GREY, "linewidths": 0.7, "zorder": 2}
_MAX_PAIRS, _MAX_MARKS, _LOG_SAG = 5, 30, 6.0
"""Keys of a triangle, marks along an axis of a map, and ratio of the sags from which on colours follow a logarithm."""


@dataclass(frozen=True)
class DrawnAxis:
    """A varied key as it is drawn."""

    label: str  # With its unit
    values: Floats  # shape (members,); In that unit; of text, the place of each word
    words: tuple[str, ...]  # Of text, in the order of their places
    is_log: bool

    @property
    def varies(self) -> bool:
        """Whether it takes two values or more."""
        return len(np.unique(self.values[np.isfinite(self.values)])) > 1

    def dress(self, axes: Axes, which: str = "x") -> None:
        """Give the axes its scale, ticks and label."""
        axis: Axis = axes.xaxis if which == "x" else axes.yaxis
        if self.words:
            axis.set_ticks(range(len(self.words)), [style.printable(word, 18) for word in self.words])
        elif self.is_log:
            axes.set(**{f"{which}scale": "log"})
            style.plain_log(axis)
        axes.set(**{f"{which}label": self.label})


def drawn_axes(data: xr.Dataset) -> list[DrawnAxis]:
    """Every varied key that takes two values or more."""
    axes = [_drawn(str(key), data[key]) for key in data.data_vars if data[key].attrs.get("varied")]
    return [axis for axis in axes if axis.varies]


def _drawn(key: str, variable: xr.DataArray) -> DrawnAxis:
    if variable.dtype.kind not in "fi":
        words, places = np.unique(variable.values.astype(np.str_), return_inverse=True)
        return DrawnAxis(key, places.astype(float), tuple(words.tolist()), False)
    values, unit = variable.values.astype(float), str(variable.attrs.get("units", "1"))
    known = values[np.isfinite(values)]
    group = key.removeprefix("groups.")
    name = key.rpartition(".")[2].replace("_", " ") if group == key else AXES.get(group, key)
    if unit in _UNITS:
        shown = _UNITS[unit](float(np.max(np.abs(known), initial=0.0)) or 1.0)
        values, unit = shown.of(values), shown.symbol
    label = style.printable(name if unit == "1" else f"{name} [{typeset(unit)}]", 60)
    return DrawnAxis(label, values, (), variable.attrs.get("scale") == "log" and bool(np.all(known > 0)))


@drawing.report.register(Sweep)
def sweep_report(sweep: Sweep) -> Report:
    """How the members ended, and a picture."""
    plan, ran = sweep.plan, len(sweep) - sweep.resumed
    sizes = [str(len(axis.values)) for axis in plan.axes]
    how = {
        "grid": f"{' x '.join(sizes)} grid" if len(sizes) > 1 else "one axis",
        "zip": "values side by side",
        "lhs": f"Latin hypercube, seed {plan.seed}",
        "table": "rows of a table",
    }[plan.mode]
    before = f", {sweep.resumed} of them from before" if sweep.resumed else ""

    def shares(found: Counter[str]) -> list[tuple[str, str]]:
        return [(f"  {_words(name)}", f"{n} ({n / len(sweep):.0%})") for name, n in found.most_common()]

    rows = [("members", f"{len(sweep)} ({how}){before}"), *shares(sweep.outcomes), ("grid", str(sweep.centre))]
    rows += [("regimes", ""), *shares(sweep.regimes)] if sweep.regimes else []
    if ran:
        rows.append(("time", f"{sweep.wall_s:.1f} s, {ran / sweep.wall_s:.0f} members/s; {sweep.place}"))
    table = TextTable(("", ""), rows, title=plan.scene.title or "sweep")
    files = sweep.files() | {
        "sweep.json": sweep.to_dict,
        "scene.toml": plan.scene.to_toml,
        "sweep.png": partial(sweep_figure, sweep),
    }
    return Report(files, [table])


def _title(sweep: Sweep) -> str:
    return style.printable(sweep.plan.scene.title, 64) or "Sweep"


def _words(regime: str) -> str:
    return LOOKS[regime].words if regime in LOOKS else regime


@dataclass(frozen=True)
class _Members:
    """How members are marked: by regime, or as no answer."""

    regimes: npt.NDArray[np.str_]  # Empty texts where there is no answer
    outcomes: npt.NDArray[np.str_]
    looks: dict[str, tuple[str, str]]  # Marker and colour of each regime that occurs

    @classmethod
    def of(cls, data: xr.Dataset) -> _Members:
        regimes, outcomes = (data[name].values.astype(np.str_) for name in ("regime", "outcome"))
        names = np.unique(regimes[regimes != ""]).tolist()
        looks = {name: (look.marker, look.colour) for name, look in LOOKS.items() if name in names}
        others = [name for name in names if name not in looks]
        return cls(regimes, outcomes, looks | dict(zip(others, cycle(_OTHER_LOOKS), strict=False)))

    def scatter(self, axes: Axes, x: Floats, y: Floats, size: float) -> None:
        """A mark for each member by its regime; of many, for so many evenly from the first to the last."""
        count = len(self.regimes)
        shown = np.unique(np.linspace(0, count - 1, min(count, MAX_DRAWN)).round().astype(int))
        x, y, regimes = x[shown], y[shown], self.regimes[shown]
        size = float(np.clip(size / max(len(x), 1), 4, 20))
        axes.scatter(x[regimes == ""], y[regimes == ""], s=size, **_NO_ANSWER)
        for name, (marker, colour) in self.looks.items():
            there = regimes == name
            edge: dict[str, Any] = {} if marker in "x+" else {"edgecolors": "white", "linewidths": 0.3}
            axes.scatter(x[there], y[there], s=size, marker=marker, c=colour, zorder=3, **edge)
        axes.margins(0.04)
        axes.grid(True)

    def legend(self, body: Any, *, hollow: bool = False) -> None:
        """Regimes with their members, in colour or hollow, then what is no answer."""
        handles = []
        for name, (marker, colour) in self.looks.items():
            edge = {"markeredgecolor": style.BLACK, "markerfacecolor": "white"}
            look: dict[str, Any] = edge if hollow else {"color": colour}
            label = f"{_words(name)} ({int(np.sum(self.regimes == name))})"
            handles.append(Line2D([], [], linestyle="", marker=marker, markersize=5, label=label, **look))
        for outcome, count in zip(*np.unique(self.outcomes[self.regimes == ""], return_counts=True), strict=True):
            label = f"no answer: {outcome} ({count})"
            handles.append(Line2D([], [], linestyle="", marker="x", color=style.GREY, markersize=4.5, label=label))
        style.legend(body, handles=handles, ncols=3)


def sweep_figure(sweep: Sweep) -> Figure | None:
    """A line over one key, a map over two on a grid, pairs of more; None if no key takes two values."""
    keys = drawn_axes(sweep.data)
    if not keys:
        return None
    whole = all(np.all(np.isfinite(key.values)) for key in keys)
    if len(keys) == 1:
        draw, height = _draw_line, 6.2
    elif len(keys) == 2 and sweep.plan.mode == "grid" and len(sweep.plan.axes) == 2 and whole:
        draw, height = _draw_map, 5.0
    else:
        draw, height = _draw_pairs, 0.8 + (min(len(keys), _MAX_PAIRS) * 1.6 if len(keys) > 2 else 4.8)
    with style.styled():
        figure, body = style.sheet(f"{_title(sweep)}: {len(sweep)} filaments", height=height)
        draw(body, sweep.data, keys, _Members.of(sweep.data))
    return figure


def _draw_line(body: SubFigure, data: xr.Dataset, keys: list[DrawnAxis], members: _Members) -> None:
    """Largest sag over span, time to 90 % and largest stretch against the one key that varies."""
    (key,), times = keys, data.time_to_90.values
    clock = time_unit(float(np.max(times[np.isfinite(times)], initial=0.0)) or 1.0)
    rows = (
        ("largest sag / span", data.sag_over_span.values),
        (f"time to 90 % [{clock.symbol}]", clock.of(times)),
        ("largest stretch", data.largest_stretch.values),
    )
    order, nothing = np.argsort(key.values, kind="stable"), key.values[members.regimes == ""]
    panels = body.subplots(3, 1, height_ratios=[2.2, 1, 1], sharex=True)
    for axes, (label, values) in zip(panels, rows, strict=True):
        if not key.words:
            axes.plot(key.values[order], values[order], color=style.GREY, linewidth=0.7, zorder=2)
        members.scatter(axes, key.values, values, 1800)
        axes.scatter(nothing, np.full(len(nothing), 0.03), s=14, transform=axes.get_xaxis_transform(), **_NO_ANSWER)
        key.dress(axes)
        axes.set_ylabel(label)
        axes.label_outer()
    members.legend(body)


def _draw_map(body: SubFigure, data: xr.Dataset, keys: list[DrawnAxis], members: _Members) -> None:
    """Largest sag over span over the plane of two keys, the first across; lines part the regimes."""
    across, upwards = keys
    x, y = np.unique(across.values), np.unique(upwards.values)
    places = (np.searchsorted(y, upwards.values), np.searchsorted(x, across.values))
    sag = np.full((len(y), len(x)), np.nan)
    marks = np.full(sag.shape, "", dtype="<U64")
    sag[places], marks[places] = data.sag_over_span.values, members.regimes
    edges = (style.pixel_edges(x, is_log=across.is_log), style.pixel_edges(y, is_log=upwards.is_log))
    known = sag[np.isfinite(sag)]
    spreads = len(known) and np.min(known) > 0 and np.max(known) > _LOG_SAG * np.min(known)
    axes = body.subplots()
    axes.set_facecolor("#e6e6e6")
    axes.spines[:].set_visible(True)
    look: dict[str, Any] = {"cmap": "cividis", "norm": LogNorm() if spreads else Normalize(), "rasterized": True}
    picture = axes.pcolormesh(*edges, np.ma.masked_invalid(sag), zorder=1, **look)
    across.dress(axes, "x")
    upwards.dress(axes, "y")
    _draw_boundaries(axes, edges, marks)
    _draw_marks(axes, (x, y), marks, members)
    axes.set(xlim=edges[0][[0, -1]], ylim=edges[1][[0, -1]])
    scale = body.colorbar(picture, ax=axes, label="largest sag / span", aspect=25, pad=0.02)
    if spreads:
        style.plain_log(scale.ax.yaxis)
    members.legend(body, hollow=True)


def _draw_boundaries(axes: Axes, edges: tuple[Floats, Floats], marks: npt.NDArray[np.str_]) -> None:
    """A line along each edge between pixels of different regimes, light under dark: seen on every colour."""
    x, y = edges
    lines = [[(x[i + 1], y[j]), (x[i + 1], y[j + 1])] for j, i in np.argwhere(marks[:, 1:] != marks[:, :-1])]
    lines += [[(x[i], y[j + 1]), (x[i + 1], y[j + 1])] for j, i in np.argwhere(marks[1:] != marks[:-1])]
    for colour, width in (("white", 2.6), (style.BLACK, 1.2)):
        look: dict[str, Any] = {"colors": colour, "linewidths": width, "capstyle": "round"}
        axes.add_collection(LineCollection(lines, zorder=3, **look), autolim=False)


def _draw_marks(axes: Axes, values: tuple[Floats, Floats], marks: npt.NDArray[np.str_], members: _Members) -> None:
    """Marks of the regimes in the pixels, on a large map in some of them evenly."""
    rows, columns = (slice(step // 2, None, step) for step in (-(-size // _MAX_MARKS) for size in marks.shape))
    x, y = np.meshgrid(values[0][columns], values[1][rows])
    marks = marks[rows, columns]
    size = float(np.clip(2600 / marks.size, 4, 16))
    axes.scatter(x[marks == ""], y[marks == ""], s=size, **_NO_ANSWER)
    for name, (marker, _) in members.looks.items():
        there = marks == name
        look: dict[str, Any] = {"marker": marker, "c": "white", "edgecolors": style.BLACK, "linewidths": 0.4}
        axes.scatter(x[there], y[there], s=size, zorder=2, **look)


def _draw_pairs(body: SubFigure, data: xr.Dataset, keys: list[DrawnAxis], members: _Members) -> None:
    """A triangle: the sag in the top row, below it each key over those before it; of more keys the first five."""
    count = len(keys := keys[:_MAX_PAIRS])
    for (row, column), axes in np.ndenumerate(body.subplots(count, count, squeeze=False)):
        if row and column >= row:
            axes.remove()
            continue
        members.scatter(axes, keys[column].values, keys[row].values if row else data.sag_over_span.values, 2500)
        keys[column].dress(axes)
        if row:
            keys[row].dress(axes, "y")
        else:
            axes.set_ylabel("largest sag / span")
        # The first panel of a row and the lowest of a column carry their labels.
        lowest = row == (count - 1 if column < count - 1 else 0)
        axes.tick_params(labelbottom=lowest, labelleft=column == 0, which="both")
        axes.xaxis.label.set_visible(lowest)
        axes.yaxis.label.set_visible(column == 0)
    members.legend(body)


drawing.plot.register(Sweep, lambda sweep, what="sag": drawing.figure_by_name({"sag": sweep_figure}, what, sweep))
