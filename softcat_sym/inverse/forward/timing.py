"""From times of the camera's clock to times at which the filament is integrated."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from softcat_sym.graph.grid import Floats

_AT_START = 1e-12  # of the longest time
_BESIDE = 1e-6  # of the longest time, to either side, where no unknown is the velocity


@dataclass(frozen=True)
class Timing:
    """Where the times of the data are among those of the integrator.

    Attributes
    ----------
    model : ndarray, shape (m,)
        Increasing and positive, in units of the time scale.
    after : ndarray of bool, shape (n,)
        Which data were taken after the filament began to move.
    row : ndarray of int, shape (sum(after),)
        Number of their time in `model`.
    sooner, later : ndarray of int, shape (sum(after),)
        Numbers of the times beside them, for the velocity; the same as `row` where it is an unknown.
    """

    model: Floats
    after: NDArray[np.bool_]
    row: NDArray[np.int64]
    sooner: NDArray[np.int64]
    later: NDArray[np.int64]


def timing_of(times: Floats, *, beside: bool) -> Timing:
    """Sort the times of the data.

    Parameters
    ----------
    times : ndarray, shape (n,)
        On the filament's clock, in units of the time scale; in any order, also twice.
    beside : bool
        Whether times beside them are wanted too.
    """
    longest = float(np.max(np.abs(times), initial=0.0))
    after = times > _AT_START * longest
    asked = times[after]
    if not beside:
        model, row = np.unique(asked, return_inverse=True)
        return Timing(model, after, row, row, row)
    step = np.minimum(_BESIDE * longest, asked / 2)
    model, number = np.unique(np.concatenate([asked, asked - step, asked + step]), return_inverse=True)
    row, sooner, later = number.reshape(3, -1)
    return Timing(model, after, row, sooner, later)
