"""The error of an answer, split by where it comes from, by companion runs on other grids, steps and fibres."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from softcat_sym.discretization.grid import Floats
from softcat_sym.error_control.resolution import Resolution
from softcat_sym.results.motion import MIN_PERIODS

WINDOW_PERIODS, WINDOW_FRAMES = 5.0, 20
"""Least length of a window."""

_FINER = 16
"""Frequencies looked at per frequency that a window resolves."""


@dataclass(frozen=True, slots=True)
class Deviation:
    """Of one midpoint from another."""

    size: float  # Largest difference over the run, relative to the largest midpoint
    # Periods by which the one is ahead of the other at the end; None where midpoints are compared instant by instant.
    phase: float | None


@dataclass(frozen=True)
class Judge:
    """Compares midpoints with those of an answer."""

    answer: Floats  # shape (frames,); Midpoint that the others are compared with
    # Stretches over which height and amplitude are taken; none where it is compared instant by instant.
    windows: tuple[slice, ...]

    @classmethod
    def of(cls, answer: Floats, periods: float, accuracy: float) -> Judge:
        """Judge by an answer."""
        frames, scale = len(answer), float(np.max(np.abs(answer)))
        if periods < MIN_PERIODS or scale == 0:
            return cls(answer, ())
        number = int(min(periods / WINDOW_PERIODS, frames / WINDOW_FRAMES))
        if number < 2:
            return cls(answer, ())
        edges = np.linspace(0, frames, number + 1).astype(int)
        windows = tuple(slice(int(a), int(b)) for a, b in pairwise(edges))
        rings = _swing(answer[windows[-1]])[1] > accuracy * scale
        return cls(answer, windows if rings else ())

    def between(self, one: Floats, other: Floats) -> Deviation:
        """Deviation of two runs of the same scene at other resolutions, relative to the answer's largest midpoint."""
        scale = float(np.max(np.abs(self.answer)))
        if not self.windows:
            return Deviation(float(np.max(np.abs(one - other))) / scale, None)
        ours, theirs = (np.array([_swing(run[window]) for window in self.windows]) for run in (one, other))
        apart = np.abs(ours[:, :2] - theirs[:, :2])
        turned = np.unwrap(ours[:, 2] - theirs[:, 2]) / (2 * np.pi)
        return Deviation(float(np.max(apart)) / scale, abs(float(turned[-1])))


def _swing(heights: Floats) -> tuple[float, float, float]:
    """Height, amplitude and phase in the middle of a window.

    A constant, a drift and one oscillation are fitted by least squares, weighted towards the middle of the window, so
    that it matters little where in their swing other modes are cut off. What they leave counts as amplitude too.
    """
    count = len(heights)
    along, weight = np.arange(count) - (count - 1) / 2, np.hanning(count + 2)[1:-1]
    base = np.vstack([np.ones(count), along]).T
    flat = heights - base @ _fitted(base, heights, weight)
    spectrum = np.abs(np.fft.rfft(flat * weight, _FINER * count))
    # Less than a cycle a window is drift.
    spectrum[:_FINER] = 0.0
    turn = 2 * np.pi * int(np.argmax(spectrum)) / (_FINER * count) * along
    columns = np.hstack([base, np.cos(turn)[:, None], np.sin(turn)[:, None]])
    found = _fitted(columns, heights, weight)
    left = float(np.average((heights - columns @ found) ** 2, weights=weight))
    return (
        float(found[0]),
        float(np.sqrt(found[2] ** 2 + found[3] ** 2 + 2 * left)),
        float(np.arctan2(-found[3], found[2])),
    )


def _fitted(columns: Floats, heights: Floats, weight: Floats) -> Floats:
    """Coefficients by weighted least squares."""
    root = np.sqrt(weight)
    return np.asarray(np.linalg.lstsq(columns * root[:, None], heights * root, rcond=None)[0])


Runner = Callable[[Resolution], Floats | None]
"""Midpoint over the run at a resolution, shape (frames,); None where that run has no answer."""

ORDER = 2
"""Of the grid: differences and averages are central."""

LOOSER = 8.0
"""Factor of the tolerance; the error of the time steps grows by five to twenty times with it, so about as much."""

TIGHTER = 1 / 3
"""Factor of the tolerance, of a filament that rings on. Looser steps tell nothing there: they lose all that there is of
the higher modes, as the judged ones may have done. Of six strands that ring for 300 to 600 periods the error is 0.9 to
1.5 times what is found so; an eightfold tolerance misses it by factors of 0.7 to 10, whatever order is supposed."""

RINGING_ORDER = 2
"""Power of the tolerance by which that is extrapolated."""

MORE = 1.5
"""Factor of the fibres: fewer than half as many again may be as wrong in the same direction."""

FIBRE_NUMBERS = (8, 12, 16, 24, 32, 48, 64, 96)
"""Numbers of fibres that are tried."""

SECTION_ORDER = 2
"""Of the fibres: where a section yields from its surface inwards, the edge lies between two of them."""

SMALL = 0.2
"""Share of the accuracy below which an error of the time steps is not looked at again when they have become shorter."""

_MIN_CELLS = 4


@dataclass(frozen=True)
class Differences:
    """Estimated errors of one run, as in `ErrorEstimate`, and what could not be had."""

    space: float | None  # Relative to the largest midpoint
    time: float | None
    section: float | None
    phase: float | None  # Periods by which a ringing may be ahead or late at its end
    failed: tuple[str, ...]  # Companions that have no answer

    @property
    def total(self) -> float:
        """Of all that is known."""
        return sum(part for part in (self.space, self.time, self.section) if part is not None)


@dataclass(frozen=True)
class Before:
    """Errors found at an earlier resolution of the same scene."""

    at: Resolution
    found: Differences


def differences(
    answer: Floats, at: Resolution, run: Runner, judge: Judge, accuracy: float, before: Before | None = None
) -> Differences:
    """Estimate the errors of an answer from its companions."""
    coarser = replace(at, cells=max(_MIN_CELLS, at.cells // 2))
    beside = run(coarser)
    if beside is None or not np.any(answer) or coarser.cells == at.cells:
        return Differences(None, None, None, None, (f"{coarser.cells} cells",))
    failed: list[str] = []

    def change(resolution: Resolution, called: str, share: float) -> Deviation | None:
        found = run(resolution)
        if found is None:
            failed.append(called)
            return None
        deviation = judge.between(found, beside)
        return Deviation(deviation.size / abs(share), None if deviation.phase is None else deviation.phase / abs(share))

    apart = judge.between(answer, beside)
    space = 1 / ((at.cells / coarser.cells) ** ORDER - 1)
    parts = [Deviation(apart.size * space, None if apart.phase is None else apart.phase * space)]
    time = _time_known(at, before, accuracy)
    if time is None:
        factor, order = (TIGHTER, RINGING_ORDER) if judge.windows else (LOOSER, 1)
        stepped = replace(coarser, rtol=min(factor * at.rtol, 0.5))
        late = change(stepped, f"a tolerance of {stepped.rtol:.2g}", (stepped.rtol / at.rtol) ** order - 1)
        time = None if late is None else late.size
        parts += [late] if late is not None else []
    section = _section_known(at, before)
    if section is None and (other := _other_fibres(coarser, before)) != coarser:
        ratio = (other.fibres or 1) / (coarser.fibres or 1) if other.order is None else MORE
        across = change(other, f"{other.fibres or other.order} fibres", 1 - ratio**-SECTION_ORDER)
        section = None if across is None else across.size
    phases = [part.phase for part in parts if part.phase is not None]
    return Differences(parts[0].size, time, section, sum(phases) if phases else None, tuple(failed))


def _time_known(at: Resolution, before: Before | None, accuracy: float) -> float | None:
    """Error of the time steps by an earlier one, where it was small; it falls at least as fast as the tolerance."""
    if before is None or before.found.time is None or before.found.time > SMALL * accuracy:
        return None
    return before.found.time * at.rtol / before.at.rtol


def _section_known(at: Resolution, before: Before | None) -> float | None:
    """Error of the same fibres on another grid."""
    same = before is not None and (before.at.fibres, before.at.order) == (at.fibres, at.order)
    return before.found.section if before is not None and same else None


def _other_fibres(coarser: Resolution, before: Before | None) -> Resolution:
    """More fibres; or else fewer, those of an earlier answer: their library is there, and runs fast."""
    if before is not None and before.at.fibres is not None and coarser.order is None:
        return replace(coarser, fibres=before.at.fibres)
    return with_more_fibres(coarser, MORE)


def with_more_fibres(resolution: Resolution, factor: float) -> Resolution:
    """More fibres by about a factor, or a higher order; the same where the section has neither.

    Fibres come in few numbers, so that scenes share what is compiled for them.
    """
    if resolution.order is not None:
        return replace(resolution, order=max(resolution.order + 1, round(factor * resolution.order)))
    if resolution.fibres is not None:
        wanted = factor * resolution.fibres
        return replace(resolution, fibres=next((n for n in FIBRE_NUMBERS if n >= wanted), 2 * round(wanted / 2)))
    return resolution


@dataclass(frozen=True, slots=True)
class ErrorEstimate:
    """Largest error of the midpoint over the run, relative to the largest midpoint; None where it was not found.

    Of a filament that rings on to the end for ten periods or more it is that of the height about which it rings and of
    the amplitude, over every five periods: see :mod:`softcat_sym.error_control.estimate`.
    """

    space: float | None  # Of the grid, by Richardson's extrapolation from a coarser one
    # Of the time steps, from a run at a looser tolerance, or at a tighter one of a filament that rings on.
    time: float | None
    # Of the fibres (or of the order k) through the thickness, from a run with more of them; None also where a section
    # has nothing to resolve.
    section: float | None
    # What the effects that were left out would change, as the finished run measures them. It is no part of the total:
    # the answer is held to the accuracy asked with the effects in force.
    effects: float
    # Of a filament that rings on: periods by which its ringing may be ahead or late at the end of the run, which is
    # no part of the total either. None where the midpoint is compared instant by instant.
    phase: float | None = None

    @property
    def total(self) -> float | None:
        """Of grid, time steps and section together; None unless grid and time steps were both looked at."""
        if self.space is None or self.time is None:
            return None
        return self.space + self.time + (self.section or 0.0)

    def as_table(self) -> dict[str, float | None]:
        """What ``summary.json`` holds."""
        return {
            "total": self.total,
            "space": self.space,
            "time": self.time,
            "section": self.section,
            "effects": self.effects,
            "phase": self.phase,
        }
