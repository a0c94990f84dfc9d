"""One number read from a film, or why it cannot be read."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Reading:
    """A number with its standard error, or none with the reason.

    Attributes
    ----------
    value : float or None
        In SI units, None if it cannot be read.
    error : float or None
        Standard error, in the same unit; None with the value.
    reason : str
        Why there is no value; empty if there is one.
    """

    value: float | None
    error: float | None
    reason: str = ""

    @property
    def log_variance(self) -> float:
        """Variance of the logarithm to first order; infinite without a value."""
        if self.value is None or self.error is None:
            return math.inf
        return (self.error / self.value) ** 2


def unread(reason: str) -> Reading:
    """A number that cannot be read."""
    return Reading(None, None, reason)
