"""How far one midpoint curve lies from another."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softcat_sym.graph.grid import Floats

SHARES = (0.10, 0.25, 0.50, 1.00)
"""Moments that are tabulated, as shares of the duration: t L^-1 sqrt(E/rho) = 46, 115, 230, 460 in the paper's runs."""

MEAN_SINCE = 1 / 7
"""The mean leaves out this share of the duration, in which a filament falls into place."""

DEFINITION = (
    "(filament - elements)/max |elements| of the midpoint's height: positive where the filament sags less; "
    "mean: over the frames of the last 6/7 of the duration; largest: in magnitude, over all frames"
)


@dataclass(frozen=True)
class Discrepancy:
    """Differences of two midpoint curves over the largest magnitude of the reference.

    NaN where there is nothing to compare: after a filament's run has ended early, or with a reference that never moves.

    Attributes
    ----------
    error : ndarray, shape (frames,)
        (filament - elements)/max |elements|.
    at : tuple of float
        The error at `SHARES` of the duration.
    mean : float
        Mean error over the last 6/7.
    largest : float
        Largest magnitude over the frames that were reached.
    """

    error: Floats
    at: tuple[float, ...]
    mean: float
    largest: float


def moments(frames: int) -> tuple[int, ...]:
    """The frames nearest to `SHARES` of the duration."""
    return tuple(round(share * (frames - 1)) for share in SHARES)


def late(time: Floats) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    """Which frames belong to the last 6/7; a frame that is there but for rounding does."""
    return np.asarray(time >= MEAN_SINCE * time[-1] * (1 - 1e-12))


def aligned(time: Floats, values: Floats, wanted: Floats) -> Floats:
    """Values at other times, linear between frames, NaN after the last.

    Parameters
    ----------
    time, values : ndarray, shape (n,)
        A curve.
    wanted : ndarray, shape (frames,)
        Times; those of the curve, up to rounding, where it is complete.
    """
    slack = 1e-9 * float(wanted[-1])
    return np.where(wanted <= time[-1] + slack, np.interp(wanted, time, values), np.nan)


def discrepancy(time: Floats, filament: Floats, elements: Floats) -> Discrepancy:
    """Compare two midpoint curves.

    Parameters
    ----------
    time : ndarray, shape (frames,)
        Evenly spaced from 0 [s].
    filament, elements : ndarray, shape (frames,)
        Heights [m]; NaN where the filament's run did not come so far.
    """
    scale = float(np.abs(elements).max())
    error = (filament - elements) / scale if scale > 0 else np.full(time.shape, np.nan)
    known = np.abs(error[np.isfinite(error)])
    return Discrepancy(
        error=error,
        at=tuple(float(error[frame]) for frame in moments(len(time))),
        mean=float(error[late(time)].mean()),
        largest=float(known.max()) if known.size else float("nan"),
    )
