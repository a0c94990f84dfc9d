"""Noise of a reading: a length, or a share of how far the filament sags while it is filmed."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softcat_sym.inverse.design.variables import read_positive, read_share
from softcat_sym.inverse.estimation.least_squares import Floats


@dataclass(frozen=True, slots=True)
class Noise:
    """Standard deviation of one reading.

    Attributes
    ----------
    value : float
        [m], or a share of the largest sag within the film.
    of_sag : bool
        Which of them.
    """

    value: float
    of_sag: bool = False

    def of(self, sag: float) -> float:
        """Standard deviation [m] in a film in which the filament sags so far [m]."""
        return self.value * sag if self.of_sag else self.value

    def of_each(self, sags: Floats) -> Floats:
        """The same for several films, shape (m,)."""
        return np.array([self.of(sag) for sag in sags.tolist()])


def read_noise(value: object) -> Noise:
    """Read a length such as ``"10 um"``, a number in m, or a share of the sag such as ``"1 %"``.

    Raises
    ------
    NotAQuantity
        Its text says what was found.
    """
    share = read_share(value)
    return Noise(read_positive(value, "length", "m")) if share is None else Noise(share, of_sag=True)
