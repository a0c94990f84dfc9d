"""Axes and marks of the pictures of a sweep: a varied key in a unit that reads well, a look for each ending."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt

from softcat_sym.report import style
from softcat_sym.report.phase_diagram import AXES, LOOKS
from softcat_sym.report.units import length_unit, stress_unit, time_unit

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

    from softcat_sym.graph.grid import Floats

_UNITS: Final = {"Pa": stress_unit, "m": length_unit, "s": time_unit}
_OTHERS: Final = (("D", style.SKY), ("P", style.PURPLE), ("*", style.BLACK))
NONE: Final = ("x", style.GREY)
"""Of members that are no answer."""

MOST_DRAWN: Final = 4000
"""Members that a picture shows one by one; of more, so many evenly from the first to the last."""


@dataclass(frozen=True)
class DrawnAxis:
    """A varied key as it is drawn.

    Attributes
    ----------
    key : str
        Which.
    label : str
        With its unit.
    values : ndarray, shape (members,)
        In that unit; of text, the place of each word.
    words : tuple of str
        Of text, in the order of their places.
    is_log : bool
        Whether it is drawn over its logarithm.
    """

    key: str
    label: str
    values: Floats
    words: tuple[str, ...]
    is_log: bool

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
    return np.unique(np.linspace(0, count - 1, min(count, MOST_DRAWN)).round().astype(int))


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
