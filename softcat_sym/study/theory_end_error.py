"""Error of a midpoint curve relative to the sag at the same instant, at the moments of a study."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softcat_sym.graph.grid import Floats
from softcat_sym.study.discrepancy import late, moments

DEFINITION = (
    "filament/elements - 1 of the midpoint's height at that instant: positive where the filament sags more; mean: of "
    "the means over the last 6/7 of the duration; largest: with its sign, over all frames from a tenth of the duration"
)


@dataclass(frozen=True)
class RelativeError:
    """How much more one curve sags than another.

    NaN where there is nothing to compare.

    Attributes
    ----------
    at : tuple of float
        At 10, 25, 50 and 100 % of the duration.
    mean : float
        Of the means over the last 6/7 of the duration.
    largest : float
        Of largest magnitude from the first of the moments on, with its sign.
    trusted : bool
        Whether the runs behind it are.
    """

    at: tuple[float, ...]
    mean: float
    largest: float
    trusted: bool = True

    @property
    def values(self) -> tuple[float, ...]:
        """All of them: the moments, the mean, the largest."""
        return (*self.at, self.mean, self.largest)


def relative_error(time: Floats, curve: Floats, reference: Floats) -> RelativeError:
    """Compare two midpoint curves.

    Parameters
    ----------
    time : ndarray, shape (frames,)
        Evenly spaced from 0 [s].
    curve, reference : ndarray, shape (frames,)
        Heights [m]; NaN where a run did not come so far.

    Notes
    -----
    The sag itself is the scale, not the largest sag: a filament that runs away in the end would hide every error
    before.
    """
    frames = moments(len(time))
    with np.errstate(divide="ignore", invalid="ignore"):
        error = np.where(reference == 0, np.nan, curve / reference - 1)
    since = error[frames[0] :]
    known = since[np.isfinite(since)]
    settled = late(time)
    average = float(reference[settled].mean())
    return RelativeError(
        at=tuple(float(error[frame]) for frame in frames),
        mean=float(curve[settled].mean()) / average - 1 if average else float("nan"),
        largest=float(known[np.abs(known).argmax()]) if known.size else float("nan"),
    )
