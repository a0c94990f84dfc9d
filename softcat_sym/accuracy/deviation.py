"""By how much one run differs from another: in what is told of it, which of a long ringing is not the phase.

A filament that loses nothing rings for hundreds of periods. Frequencies that differ by a thousandth are out of phase
after half as many, and midpoints compared instant by instant then differ by the whole swing, though both runs tell the
same: about which height the filament rings, and how far. Where an answer rings on to its end, and for ten periods or
more, height and amplitude are compared, window by window; the phase is told beside, in periods at the end of the run.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from softcat_sym.graph.grid import Floats
from softcat_sym.trajectory.settling import FEWEST_PERIODS

WINDOW_PERIODS, WINDOW_FRAMES = 5.0, 20
"""Least length of a window."""

_FINER = 16
"""Frequencies looked at per frequency that a window resolves."""


@dataclass(frozen=True, slots=True)
class Deviation:
    """Of one midpoint from another.

    Attributes
    ----------
    size : float
        Largest difference over the run, relative to the largest midpoint.
    phase : float or None
        Periods by which the one is ahead of the other at the end; None where midpoints are compared instant by instant.
    """

    size: float
    phase: float | None


@dataclass(frozen=True)
class Judge:
    """Compares midpoints with those of an answer.

    Attributes
    ----------
    answer : ndarray, shape (frames,)
        Midpoint that the others are compared with.
    windows : tuple of slice
        Stretches over which height and amplitude are taken; none where it is compared instant by instant.
    """

    answer: Floats
    windows: tuple[slice, ...]

    @classmethod
    def of(cls, answer: Floats, periods: float, accuracy: float) -> Judge:
        """Judge by an answer.

        Parameters
        ----------
        answer : ndarray, shape (frames,)
            Its midpoint.
        periods : float
            Periods of the lowest mode in the run; zero of a filament that does not ring.
        accuracy : float
            Asked: what swings by less at the end has come to rest.
        """
        frames, scale = len(answer), float(np.max(np.abs(answer)))
        if periods < FEWEST_PERIODS or scale == 0:
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
