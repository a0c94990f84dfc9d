"""Curves against time: an axis on which the part in which something happens is seen, and what lies between frames."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import FuncFormatter, MaxNLocator, NullLocator
from numpy.typing import NDArray

from softcat_sym.plotting.style import plain
from softcat_sym.plotting.units import Unit, nice_floor, time_unit

Floats = NDArray[np.float64]

EARLY: Final = 0.08
"""An axis is logarithmic if half of all motion lies within this share of the time."""

_LONGEST: Final = 100.0
"""Unit of a logarithmic axis [s]: its first numbers would be too small in minutes."""

STEPS: Final = (1, 2, 2.5, 5, 10)
"""Between ticks, times a power of ten."""

_COLUMNS: Final = 600
"""Points of a curve and columns of a map, evenly along the axis: more would be finer than a pixel."""


@dataclass(frozen=True, slots=True)
class TimeAxis:
    """How time runs along an axis: evenly, or logarithmically from some time on (Matplotlib's asinh scale)."""

    start: float  # [s]
    end: float
    unit: Unit
    even: float = math.inf  # Time up to which it runs evenly [s]

    @classmethod
    def of(cls, time: Floats, *curves: Floats) -> TimeAxis:
        """The axis of what moves most: logarithmic after the first quarter of a motion of which half lies early."""
        start, end = float(time.min()), float(time.max())
        ways = [np.append(0.0, np.cumsum(np.abs(np.diff(curve)))) for curve in curves]
        way = sum((one / one[-1] for one in ways if one[-1] > 0), np.zeros(time.size))
        if way[-1] > 0 and end > start >= 0:
            quarter, half = np.interp([0.25 * way[-1], 0.5 * way[-1]], way, time)
            if half - start < EARLY * (end - start) and start < quarter:
                return cls(start, end, time_unit(min(end, _LONGEST)), nice_floor(float(quarter)))
        return cls(start, end, time_unit(max(abs(start), abs(end))))

    @property
    def is_even(self) -> bool:
        """Whether it is linear."""
        return math.isinf(self.even)

    @property
    def label(self) -> str:
        """Name, unit, and from when on it is logarithmic."""
        symbol = self.unit.symbol
        return f"time [{symbol}]" + (
            "" if self.is_even else f", logarithmic after {self.even / self.unit.size:g} {symbol}"
        )

    def _along(self, time: Any) -> Floats:
        return np.asarray(time if self.is_even else np.arcsinh(np.divide(time, self.even)), dtype=float)

    def place(self, time: Any) -> Floats:
        """Where times stand along the axis, which goes from 0 to 1."""
        start, end = self._along([self.start, self.end])
        return np.asarray((self._along(time) - start) / ((end - start) or 1.0))

    def times(self, places: Floats) -> Floats:
        """Times [s] at places along the axis."""
        start, end = self._along([self.start, self.end])
        at = start + (end - start) * places
        return np.asarray(at if self.is_even else self.even * np.sinh(at))

    def dress(self, axes: Axes, ticks: int = 8, size: float | None = None, label: str | None = None) -> None:
        """Limits that are never empty, scale, a few round numbers, and the label; numbers of this size [s]."""
        size = size or self.unit.size
        start, end = self.start / size, self.end / size
        axes.set_xlim(start, end if end > start else start + max(1.0, abs(start)))
        axes.set_xlabel(self.label if label is None else label)
        if self.is_even:
            axes.xaxis.set_major_locator(MaxNLocator(ticks, steps=STEPS))
            return
        axes.set_xscale("asinh", linear_width=self.even / size)
        axes.set_xticks(self.ticks(ticks, size), minor=False)
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_major_formatter(FuncFormatter(plain))

    def ticks(self, count: int, size: float) -> list[float]:
        """About so many round numbers that can be read: the start, powers of ten, then their fives and twos."""
        first, last = math.floor(math.log10(self.even / size)) - 1, math.floor(math.log10(self.end / size))
        chosen, apart = [self.start / size], 0.7 / count
        for digit in (1.0, 5.0, 2.0):
            for value in (digit * 10.0**power for power in range(first, last + 1)):
                free = np.abs(self.place(value * size) - self.place(np.array(chosen) * size)).min()
                if self.start < value * size <= self.end and free >= apart:
                    chosen.append(value)
        return sorted(chosen)

    def between(self, time: Floats, values: Floats, turns: Floats | None = None) -> tuple[Floats, Floats]:
        """Times [s] and values of curves, shape (frames, curves), from frame to frame by cubics: lines without corners.

        A single one that turns at known times and heights, shape (turns, 2), passes there, too, and is level.
        """
        if time.size < 3:
            return time, values
        level = np.zeros(time.size, dtype=bool)
        if turns is not None and len(turns):
            kept = turns[~np.isin(turns[:, 0], time) & (turns[:, 0] > time[0]) & (turns[:, 0] < time[-1])]
            order = np.argsort(np.append(time, kept[:, 0]), kind="stable")
            time, values = np.append(time, kept[:, 0])[order], np.concatenate([values, kept[:, 1:]])[order]
            level = np.append(level, np.ones(len(kept), dtype=bool))[order]
        at = np.union1d(self.times(np.linspace(0.0, 1.0, _COLUMNS)), time)
        step = np.diff(time)
        rise = np.diff(values, axis=0) / step[:, None]
        # SciPy's PCHIP would take longer to load than a run to draw.
        # Slopes of parabolas through three neighbours, no steeper than keeps a rise a rise (Fritsch and Carlson 1980).
        share = (step[1:] / (step[1:] + step[:-1]))[:, None]
        most = 3.0 * np.minimum(np.abs(rise[1:]), np.abs(rise[:-1]))
        inside = np.clip(share * rise[:-1] + (1 - share) * rise[1:], -most, most)
        ends = rise[[0, -1]] + (rise[[0, -1]] - rise[[1, -2]]) * np.array([1 - share[0], share[-1]])
        ends = np.clip(ends, np.minimum(3 * rise[[0, -1]], 0.0), np.maximum(3 * rise[[0, -1]], 0.0))
        slope = np.concatenate([ends[:1], inside, ends[1:]])
        slope[level] = 0.0
        k = np.clip(np.searchsorted(time, at, side="right") - 1, 0, time.size - 2)
        u, h = ((at - time[k]) / step[k])[:, None], step[k][:, None]
        begin = (1 + 2 * u) * values[k] + u * h * slope[k]
        end = (3 - 2 * u) * values[k + 1] - (1 - u) * h * slope[k + 1]
        return at, (1 - u) ** 2 * begin + u**2 * end

    def columns(self, time: Floats, values: Floats) -> Floats:
        """Values, shape (frames, rows), at even places along the axis, linear between frames; shape (columns, rows)."""
        at = self.times((np.arange(_COLUMNS) + 0.5) / _COLUMNS)
        return values if time.size == 1 else between(time, values, at)


def between(time: Floats, values: Floats, at: Floats) -> Floats:
    """Values, shape (frames, ...), at other times, linear between frames."""
    if time.size == 1:
        return np.repeat(values, at.size, axis=0)
    k = np.clip(np.searchsorted(time, at, side="right") - 1, 0, time.size - 2)
    part = ((at - time[k]) / (time[k + 1] - time[k])).reshape(-1, *(1,) * (values.ndim - 1))
    return np.asarray((1 - part) * values[k] + part * values[k + 1])
