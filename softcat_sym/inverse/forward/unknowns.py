"""What a model with free parameters says of its unknowns q."""

from __future__ import annotations

import numpy as np

from softcat_sym.graph.grid import Floats
from softcat_sym.inverse.forward.free import FreeParameter


class Unknowns:
    """Names, bounds and typical values of q.

    Attributes
    ----------
    free : tuple of FreeParameter
        The k unknowns.
    """

    free: tuple[FreeParameter, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """Of the k unknowns."""
        return tuple(one.name for one in self.free)

    @property
    def lower(self) -> Floats:
        """Least possible q, shape (k,)."""
        return np.array([one.lower for one in self.free])

    @property
    def upper(self) -> Floats:
        """Largest possible q, shape (k,)."""
        return np.array([one.upper for one in self.free])

    @property
    def typical(self) -> Floats:
        """The unknowns at the scene's own values, shape (k,)."""
        return np.array([one.scaled(one.typical) for one in self.free])
