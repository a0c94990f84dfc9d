"""Sweeps: pictures, files and the terminal."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from rich import box
from rich.console import Console

from softcat_sym.plotting import style
from softcat_sym.plotting.files import write_results
from softcat_sym.plotting.phase import AXES, LOOKS
from softcat_sym.plotting.sliders import sliders_page
from softcat_sym.plotting.style import legend
from softcat_sym.plotting.terminal import text_table
from softcat_sym.plotting.units import length_unit, stress_unit, time_unit

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.discretization.grid import Floats
    from softcat_sym.studies.sweep import Sweep

_UNITS: Final = {"Pa": stress_unit, "m": length_unit, "s": time_unit}
_OTHERS: Final = (("D", style.SKY), ("P", style.PURPLE), ("*", style.BLACK))
NONE: Final = ("x", style.GREY)
"""Of members that are no answer."""

MAX_DRAWN: Final = 4000
"""Members that a picture shows one by one; of more, so many evenly from the first to the last."""


@dataclass(frozen=True)
class DrawnAxis:
    """A varied key as it is drawn."""

    key: str  # Which
    label: str  # With its unit
    values: Floats  # shape (members,); In that unit; of text, the place of each word
    words: tuple[str, ...]  # Of text, in the order of their places
    is_log: bool  # Whether it is drawn over its logarithm

    def dress(self, axes: Axes, which: str = "x") -> None:
        """Give the axes its scale, limits, ticks and, along x, its label."""
        axis: Axis = axes.xaxis if which == "x" else axes.yaxis
        known = self.values[np.isfinite(self.values)]
        if self.words:
            axis.set_ticks(range(len(self.words)), [style.printable(word, 18) for word in self.words])
        elif self.is_log:
            axes.set(**{f"{which}scale": "log"})
            axis.set_major_formatter(lambda value, _: f"{value:g}")
            few = len(known) and float(np.max(known) / np.min(known)) < 30
            axis.set_minor_formatter((lambda value, _: f"{value:g}" if leads(value, (2, 5)) else "") if few else "")
        if len(known) and not self.words:
            axes.set(**{f"{which}lim": _room(float(np.min(known)), float(np.max(known)), log=self.is_log)})
        axes.set(**{f"{which}label": self.label})


def drawn_axes(data: xr.Dataset) -> list[DrawnAxis]:
    """Every varied key that takes two values or more."""
    found = [_drawn(str(key), data[key]) for key in data.data_vars if data[key].attrs.get("varied")]
    return [axis for axis in found if len(np.unique(axis.values[np.isfinite(axis.values)])) > 1]


def looks_of(marks: Sequence[str]) -> dict[str, tuple[str, str]]:
    """Marker and colour of each regime that occurs: those of a phase diagram, and some more."""
    known = {name: (LOOKS[name].marker, LOOKS[name].colour) for name in LOOKS if name in marks}
    others = [mark for mark in sorted(set(marks)) if mark and mark not in known]
    return known | {mark: _OTHERS[k % len(_OTHERS)] for k, mark in enumerate(others)}


def regimes_of(data: xr.Dataset) -> npt.NDArray[np.str_]:
    """The regime of each member, an empty text if it is no answer."""
    return np.asarray(data.regime.values).astype(np.str_)


def shown_members(data: xr.Dataset) -> npt.NDArray[np.int_]:
    """Which members are drawn one by one."""
    count = data.sizes["member"]
    return np.unique(np.linspace(0, count - 1, min(count, MAX_DRAWN)).round().astype(int))


def scatter(axes: Axes, x: Floats, y: Floats, regimes: npt.NDArray[np.str_], size: float) -> None:
    """A mark for each member, by its regime."""
    for name, (marker, colour) in looks_of(regimes.tolist()).items():
        there = regimes == name
        edge: dict[str, Any] = {} if marker in "x+" else {"edgecolors": "white", "linewidths": 0.3}
        axes.scatter(x[there], y[there], s=size, marker=marker, c=colour, zorder=3, **edge)


def key_of(regimes: npt.NDArray[np.str_], outcomes: npt.NDArray[np.str_], *, hollow: bool = False) -> list[Line2D]:
    """Handles of a legend: each regime with its members, in colour or hollow, then what is no answer."""
    handles = []
    for name, (marker, colour) in looks_of(regimes.tolist()).items():
        words = LOOKS[name].words if name in LOOKS else name
        look: dict[str, Any] = {"color": colour}
        if hollow:
            look = {"markeredgecolor": style.BLACK, "markerfacecolor": "white", "markeredgewidth": 0.6}
        label = f"{words} ({int(np.sum(regimes == name))})"
        handles.append(Line2D([], [], linestyle="", marker=marker, markersize=5, label=label, **look))
    for outcome in sorted(set(outcomes[regimes == ""].tolist())):
        label = f"no answer: {outcome} ({int(np.sum(outcomes[regimes == ''] == outcome))})"
        handles.append(Line2D([], [], linestyle="", marker=NONE[0], color=NONE[1], markersize=4.5, label=label))
    return handles


def _drawn(key: str, variable: xr.DataArray) -> DrawnAxis:
    if variable.dtype.kind not in "fi":
        words, places = np.unique(variable.values.astype(np.str_), return_inverse=True)
        return DrawnAxis(key, key, places.astype(float), tuple(words.tolist()), False)
    values, unit = variable.values.astype(float), str(variable.attrs.get("units", "1"))
    known = np.abs(values[np.isfinite(values)])
    largest = float(np.max(known)) if len(known) else 1.0
    name = AXES.get(key.removeprefix("groups."), key) if key.startswith("groups.") else _named(key)
    if unit in _UNITS:
        shown = _UNITS[unit](largest)
        values, unit = shown.of(values), shown.symbol
    unit = unit.replace("^2", "²").replace("^3", "³").replace("*", "·")
    label = name if unit == "1" else f"{name} [{unit}]"
    is_log = variable.attrs.get("scale") == "log" and bool(len(known)) and bool(np.nanmin(values) > 0)
    return DrawnAxis(key, style.printable(label, 60), values, (), is_log)


def _named(key: str) -> str:
    """``material.yield_stress`` as a reader says it."""
    return key.rpartition(".")[2].replace("_", " ")


def leads(value: float, digits: tuple[int, ...]) -> bool:
    """Whether a number is one of the digits times a power of ten."""
    return any(abs(value / 10.0 ** np.floor(np.log10(value)) - digit) < 1e-6 for digit in digits)


def _room(low: float, high: float, *, log: bool) -> tuple[float, float]:
    """Limits a little beyond the ends."""
    if low == high:
        return (low / 2, high * 2) if log else (low - 0.5, high + 0.5)
    if log:
        room = (high / low) ** 0.03
        return low / room, high * room
    return low - 0.03 * (high - low), high + 0.03 * (high - low)


def sweep_rows(sweep: Sweep) -> list[tuple[str, str]]:
    """Name and text of each row, in the order of reading."""
    counts = sweep.counts
    rows = [("members", _members(sweep))]
    rows += [(f"  {name}", _share(count, len(sweep))) for name, count in counts.outcomes.most_common()]
    if counts.regimes:
        rows.append(("regimes", ""))
        rows += [
            (f"  {LOOKS[name].words if name in LOOKS else name}", _share(count, len(sweep)))
            for name, count in counts.regimes.most_common()
        ]
    ran = len(sweep) - sweep.resumed
    if ran:
        rows.append(("time", f"{sweep.wall_s:.1f} s, {ran / sweep.wall_s:.0f} members/s; {sweep.place}"))
    if sweep.peak_memory:
        rows.append(("peak memory", f"{sweep.peak_memory:.0f} MB"))
    return rows


def print_sweep(sweep: Sweep, console: Console | None = None) -> None:
    """Print them as a table."""
    title = sweep.plan.scene.title or "sweep"
    table = text_table(("", ""), sweep_rows(sweep), title=title, box=box.SIMPLE, padding=(0, 1, 0, 0))
    (console or Console()).print(table)


def _members(sweep: Sweep) -> str:
    axes = " x ".join(str(len(axis.values)) for axis in sweep.plan.axes)
    how = {
        "grid": f"{axes} grid" if len(sweep.plan.axes) > 1 else "one axis",
        "zip": "values side by side",
        "lhs": f"Latin hypercube, seed {sweep.plan.seed}",
        "table": "rows of a table",
    }[sweep.plan.mode]
    before = f", {sweep.resumed} of them from before" if sweep.resumed else ""
    return f"{len(sweep)} ({how}){before}"


def _share(count: int, of: int) -> str:
    return f"{count} ({count / of:.0%})"


PICTURE, PAGE = "sweep.png", "sliders.html"


def write_sweep(sweep: Sweep, directory: str | Path) -> list[Path]:
    """Write ``sweep.json``, ``scene.toml``, ``sweep.png`` and, with shapes, ``sliders.html``."""
    has_page = sweep.plan.shapes and sweep.counts.outcomes.get("solved")
    contents = {
        "sweep.json": sweep.summary(),
        "scene.toml": sweep.plan.scene.to_toml(),
        PICTURE: sweep_figure(sweep),
        PAGE: sliders_page(sweep.data, _title(sweep)) if has_page else None,
    }
    return write_results(directory, contents)


def sweep_figure(sweep: Sweep) -> Figure | None:
    """A line over one key, a map over two on a grid, pairs of more; None if no key takes two values."""
    data, title = sweep.data, f"{_title(sweep)}: {len(sweep)} filaments"
    axes = drawn_axes(data)
    if len(axes) < 2:
        return line_figure(data, title) if axes else None
    whole = all(np.all(np.isfinite(axis.values)) for axis in axes)
    is_map = len(axes) == 2 and sweep.plan.mode == "grid" and len(sweep.plan.axes) == 2 and whole
    return map_figure(data, title) if is_map else pairs_figure(data, title)


def _title(sweep: Sweep) -> str:
    return style.printable(sweep.plan.scene.title, 64) or "Sweep"


def line_figure(data: xr.Dataset, title: str) -> Figure:
    """Draw largest sag over span, time to 90 % and largest stretch against the one key that varies."""
    axis = drawn_axes(data)[0]
    members = shown_members(data)
    regimes, outcomes = regimes_of(data), data.outcome.values.astype(np.str_)
    known = data.time_to_90.values[np.isfinite(data.time_to_90.values)]
    clock = time_unit(float(np.max(known)) if len(known) else 1.0)
    rows = (
        ("largest sag / span", data.sag_over_span.values),
        (f"time to 90 % [{clock.symbol}]", clock.of(data.time_to_90.values)),
        ("largest stretch", data.largest_stretch.values),
    )
    with style.styled():
        figure, body = style.sheet(title, height=6.2)
        for axes, (label, values) in zip(body.subplots(3, 1, height_ratios=[2.2, 1, 1]), rows, strict=True):
            _line_panel(axes, axis, values[members], axis.values[members], regimes[members])
            axes.set_ylabel(label)
            if values is not rows[-1][1]:
                _undress(axes, across=True, upwards=False)
        legend(body, handles=key_of(regimes, outcomes), ncols=3)
    return figure


def _line_panel(axes: Axes, axis: DrawnAxis, values: Floats, x: Floats, regimes: npt.NDArray[np.str_]) -> None:
    order = np.argsort(x, kind="stable")
    if not axis.words:
        axes.plot(x[order], values[order], color=style.GREY, linewidth=0.7, zorder=2)
    size = float(np.clip(1800 / max(len(x), 1), 5, 20))
    scatter(axes, x, values, regimes, size)
    axis.dress(axes)
    known = values[np.isfinite(values)]
    if len(known):
        low, high = float(np.min(known)), float(np.max(known))
        room = 0.08 * (high - low) or 0.05 * abs(high) or 1.0
        axes.set_ylim(low - room, high + room)
    nothing = regimes == ""
    marker, colour = NONE
    foot = axes.get_xaxis_transform()
    axes.scatter(
        x[nothing],
        np.full(int(nothing.sum()), 0.03),
        s=14,
        marker=marker,
        c=colour,
        linewidths=0.8,
        transform=foot,
        zorder=3,
    )
    axes.grid(True)
    style.lighten(axes)


_NOTHING = "#e6e6e6"
_FACTOR = 6.0
_NARROW = 0.2


def map_figure(data: xr.Dataset, title: str) -> Figure:
    """Draw largest sag over span over the plane of two keys, the first across."""
    across, upwards = drawn_axes(data)
    x, y = np.unique(across.values), np.unique(upwards.values)
    regimes, outcomes = regimes_of(data), data.outcome.values.astype(np.str_)
    places = (np.searchsorted(y, upwards.values), np.searchsorted(x, across.values))
    sag = np.full((len(y), len(x)), np.nan)
    sag[places] = data.sag_over_span.values
    marks = np.full((len(y), len(x)), "", dtype=regimes.dtype if regimes.dtype.itemsize else "<U1")
    marks[places] = regimes
    edges = (_edges(x, log=across.is_log), _edges(y, log=upwards.is_log))
    with style.styled():
        figure, body = style.sheet(title, height=5.0)
        axes = body.subplots()
        axes.set_facecolor(_NOTHING)
        shown = np.ma.masked_invalid(sag)
        picture = axes.pcolormesh(*edges, shown, cmap="cividis", norm=_norm(sag), rasterized=True, zorder=1)
        across.dress(axes, "x")
        upwards.dress(axes, "y")
        axes.set_xlim(edges[0][0], edges[0][-1])
        axes.set_ylim(edges[1][0], edges[1][-1])
        _boundaries(axes, edges, marks)
        _names(axes, (across, upwards), (x, y), marks)
        scale = body.colorbar(picture, ax=axes, label="largest sag / span", aspect=25, pad=0.02)
        if isinstance(picture.norm, LogNorm):
            scale.ax.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
            scale.ax.yaxis.set_minor_formatter(lambda value, _: f"{value:g}" if leads(value, (2, 5)) else "")
            scale.ax.tick_params(which="both", labelsize=8)
        legend(body, handles=key_of(regimes, outcomes, hollow=True), ncols=3)
    return figure


def _norm(sag: Floats) -> Normalize:
    """Colours by the logarithm where the sag goes over more than a factor."""
    known = sag[np.isfinite(sag)]
    if len(known) and float(np.min(known)) > 0 and float(np.max(known) / np.min(known)) > _FACTOR:
        return LogNorm(float(np.min(known)), float(np.max(known)))
    return Normalize()


def _edges(values: Floats, *, log: bool) -> Floats:
    """Edges of the pixels around values, half a step beyond the first and the last."""
    at = np.log(values) if log else values
    middles = (at[1:] + at[:-1]) / 2
    edges = np.concatenate([[2 * at[0] - middles[0]], middles, [2 * at[-1] - middles[-1]]])
    return np.asarray(np.exp(edges) if log else edges)


def _boundaries(axes: Axes, edges: tuple[Floats, Floats], marks: npt.NDArray[np.str_]) -> None:
    """A line along each edge between pixels of different regimes, light under dark: seen on every colour."""
    x, y = edges
    lines = [[(x[i + 1], y[j]), (x[i + 1], y[j + 1])] for j, i in np.argwhere(marks[:, 1:] != marks[:, :-1])]
    lines += [[(x[i], y[j + 1]), (x[i + 1], y[j + 1])] for j, i in np.argwhere(marks[1:] != marks[:-1])]
    for colour, width in (("white", 2.6), (style.BLACK, 1.2)):
        axes.add_collection(
            LineCollection(lines, colors=colour, linewidths=width, zorder=3, capstyle="round"), autolim=False
        )


def _names(
    axes: Axes, drawn: tuple[DrawnAxis, DrawnAxis], values: tuple[Floats, Floats], marks: npt.NDArray[np.str_]
) -> None:
    """Marks of the regimes in every pixel of a small map, its names in the midst of their regions on every map."""
    x, y = np.meshgrid(*values)
    if marks.size <= 900:
        size = float(np.clip(2600 / marks.size, 3, 16))
        for name, (marker, _) in looks_of(marks.ravel().tolist()).items():
            there = marks == name
            axes.scatter(
                x[there], y[there], s=size, marker=marker, c="white", edgecolors=style.BLACK, linewidths=0.4, zorder=2
            )
    nothing = marks == ""
    axes.scatter(
        x[nothing],
        y[nothing],
        s=float(np.clip(4000 / marks.size, 2, 18)),
        marker=NONE[0],
        c=NONE[1],
        linewidths=0.7,
        zorder=2,
    )
    scales = [np.log if one.is_log else np.asarray for one in drawn]
    places = np.stack([_shares(scale(at)) for scale, at in zip(scales, (x, y), strict=True)], axis=-1)
    for name in looks_of(marks.ravel().tolist()):
        there = marks == name
        if there.sum() < 0.03 * marks.size:
            continue
        j, i = _midst(places, there)
        wide, tall = np.ptp(places[there], axis=0)
        words_up = 90.0 if wide < _NARROW and tall > 2 * wide else 0.0
        words = LOOKS[name].words if name in LOOKS else name
        box = {"boxstyle": "round,pad=0.2", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}
        axes.text(
            x[j, i],
            y[j, i],
            words if words_up else words.replace(", ", ",\n"),
            ha="center",
            va="center",
            rotation=words_up,
            fontsize=7.5,
            bbox=box,
            zorder=4,
            clip_on=True,
        )


def _shares(values: Floats) -> Floats:
    return np.asarray((values - values.min()) / ((values.max() - values.min()) or 1.0))


def _midst(places: Floats, there: npt.NDArray[np.bool_]) -> tuple[int, int]:
    """The pixel of a region that is farthest from everything else, the frame included."""
    inside = np.argwhere(there)
    apart = np.min(np.minimum(places[there], 1 - places[there]), axis=1) * 1.5
    outside = places[~there]
    if len(outside):
        step = max(1, len(outside) // 400)
        gaps = places[there][:, None, :] - outside[None, ::step, :]
        apart = np.minimum(apart, np.min(np.hypot(gaps[..., 0], gaps[..., 1]), axis=1))
    j, i = inside[int(np.argmax(apart))]
    return int(j), int(i)


_MOST = 5


def pairs_figure(data: xr.Dataset, title: str) -> Figure:
    """Draw a triangle: the sag in the top row, below it each key over those before it; of more keys the first five."""
    drawn = drawn_axes(data)[:_MOST]
    members = shown_members(data)
    regimes, outcomes = regimes_of(data), data.outcome.values.astype(np.str_)
    count = len(drawn)
    with style.styled():
        figure, body = style.sheet(title, height=0.8 + count * (1.6 if count > 2 else 2.4))
        for (row, column), axes in np.ndenumerate(body.subplots(count, count, squeeze=False)):
            if row and column >= row:
                axes.remove()
                continue
            values = drawn[row].values if row else data.sag_over_span.values
            _pairs_panel(axes, drawn[column].values[members], values[members], regimes[members])
            drawn[column].dress(axes)
            if row:
                drawn[row].dress(axes, "y")
            # The first panel of a row and the lowest of a column carry their labels.
            _undress(axes, across=row < (count - 1 if column < count - 1 else 0), upwards=column > 0)
            if not row and not column:
                axes.set_ylabel("largest sag / span")
        legend(body, handles=key_of(regimes, outcomes), ncols=3)
    return figure


def _pairs_panel(axes: Axes, x: Floats, y: Floats, regimes: npt.NDArray[np.str_]) -> None:
    """The members; one that is no answer where it has both values."""
    size, nothing = float(np.clip(2500 / max(len(x), 1), 3, 16)), regimes == ""
    axes.scatter(x[nothing], y[nothing], s=size, marker=NONE[0], c=NONE[1], linewidths=0.6, zorder=2)
    scatter(axes, x, y, regimes, size)
    axes.grid(True)
    style.lighten(axes)


def _undress(axes: Axes, *, across: bool, upwards: bool) -> None:
    """Take away the labels of an axis that another panel carries."""
    if across:
        axes.set_xlabel("")
        axes.tick_params(labelbottom=False, which="both")
    if upwards:
        axes.set_ylabel("")
        axes.tick_params(labelleft=False, which="both")
