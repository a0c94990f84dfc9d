"""Sweeps: axes and marks of their pictures, files and the terminal."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt

from softcat_sym.files import write_all
from softcat_sym.plotting import style
from softcat_sym.plotting.phase_diagram import AXES, LOOKS
from softcat_sym.plotting.style import length_unit, png, stress_unit, time_unit

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D
    from rich.console import Console

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
    from matplotlib.lines import Line2D

    handles = []
    for name, (marker, colour) in looks_of(regimes.tolist()).items():
        words = LOOKS[name].words if name in LOOKS else name
        label = f"{words} ({int(np.sum(regimes == name))})"
        edge, face, width = (style.BLACK, "white", 0.6) if hollow else (colour, colour, 1.0)
        handles.append(
            Line2D(
                [],
                [],
                linestyle="",
                marker=marker,
                markersize=5,
                markeredgecolor=edge,
                markerfacecolor=face,
                markeredgewidth=width,
                label=label,
            )
        )
    for outcome in sorted(set(outcomes[regimes == ""].tolist())):
        label = f"no answer: {outcome} ({int(np.sum(outcomes[regimes == ''] == outcome))})"
        handles.append(Line2D([], [], linestyle="", marker=NONE[0], color=NONE[1], markersize=4.5, label=label))
    return handles


def frame(figure: Figure, title: str, handles: list[Line2D], left: float) -> None:
    """Write the title along the top, and a key along the bottom; `left` is its edge [inch]."""
    width, height = figure.get_size_inches()
    top = 1 - 0.14 / height
    figure.text(0.2 / width, top, title, va="top", fontsize=10.5, fontweight="bold", parse_math=False)
    settings: dict[str, Any] = {"borderaxespad": 0.0, "columnspacing": 1.2, "handletextpad": 0.3}
    place = (left / width, 0.08 / height)
    figure.legend(handles=handles, loc="lower left", bbox_to_anchor=place, ncols=3, **settings)


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
    from rich import box
    from rich.console import Console as Terminal
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE, show_header=False, padding=(0, 1, 0, 0), title_justify="left")
    table.title = Text(sweep.plan.scene.title or "sweep", style="bold")
    for name, text in sweep_rows(sweep):
        table.add_row(Text(name), Text(text))
    (console or Terminal()).print(table)


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
    """Write ``sweep.json``, ``scene.toml``, ``sweep.png`` and, with shapes, ``sliders.html``.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    contents = {
        "sweep.json": (json.dumps(sweep.summary(), indent=2, allow_nan=False) + "\n").encode(),
        "scene.toml": sweep.plan.scene.to_toml().encode(),
    }
    picture = sweep_picture(sweep)
    if picture is not None:
        contents[PICTURE] = picture
    if sweep.plan.shapes and sweep.counts.outcomes.get("solved"):
        from softcat_sym.plotting.sliders import sliders_page

        contents[PAGE] = sliders_page(sweep.data, _title(sweep)).encode()
    return write_all(directory, contents)


def sweep_picture(sweep: Sweep) -> bytes | None:
    """A line over one key, a map over two on a grid, pairs of more; None if no key takes two values."""
    from softcat_sym.plotting.sweep_line import line_figure
    from softcat_sym.plotting.sweep_map import map_figure
    from softcat_sym.plotting.sweep_pairs import pairs_figure

    data, title = sweep.data, f"{_title(sweep)}: {len(sweep)} filaments"
    axes = drawn_axes(data)
    if not axes:
        return None
    if len(axes) == 1:
        return png(line_figure(data, title))
    whole = all(np.all(np.isfinite(axis.values)) for axis in axes)
    if len(axes) == 2 and sweep.plan.mode == "grid" and len(sweep.plan.axes) == 2 and whole:
        return png(map_figure(data, title))
    return png(pairs_figure(data, title))


def _title(sweep: Sweep) -> str:
    return style.printable(sweep.plan.scene.title, 64) or "Sweep"
