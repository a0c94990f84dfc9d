"""Standard errors from Fisher information, for whole rows of experiments at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from softcat_sym.inverse.estimation.fisher import DERIVATIVE_ACCURACY
from softcat_sym.inverse.estimation.least_squares import Floats
from softcat_sym.inverse.forward.free import FreeParameter

# Components of a direction that no experiment sees, below which an unknown does not take part in it.
_TAKES_PART = 1e-4


@dataclass(frozen=True, eq=False)
class Unknowns:
    """What a film is to tell.

    Attributes
    ----------
    free : tuple of FreeParameter
        All that is estimated together.
    counted : ndarray of bool, shape (k,)
        Which count: not the camera's own, nor other nuisance.
    """

    free: tuple[FreeParameter, ...]
    counted: NDArray[np.bool_]

    @property
    def names(self) -> tuple[str, ...]:
        """Of all that is estimated."""
        return tuple(one.name for one in self.free)

    @property
    def scales(self) -> Floats:
        """Relative error over the error of q, shape (k,); of what is typically zero, the error itself in SI."""
        scales = [1.0 if one.logarithmic else one.scale / (abs(one.typical) or 1.0) for one in self.free]
        return np.array(scales)

    def worst(self, errors: Floats) -> Floats:
        """Largest error of what counts; shape (..., k) to (...)."""
        return np.asarray(errors[..., self.counted].max(axis=-1), dtype=float)


def relative_errors(matrices: Floats, unknowns: Unknowns) -> Floats:
    """Relative standard errors by the Cramer-Rao bound, sqrt((F^-1)_ii).

    Parameters
    ----------
    matrices : ndarray, shape (..., k, k)
        Fisher information F of q; NaN where there is no film.

    Returns
    -------
    ndarray, shape (..., k)
        Infinite for an unknown that takes part in a direction whose singular value is below `DERIVATIVE_ACCURACY` of
        the largest.
    """
    present = np.asarray(np.isfinite(matrices).all(axis=(-1, -2), keepdims=True))
    values, directions = np.linalg.eigh(np.where(present, matrices, 0.0))
    floor = np.maximum(DERIVATIVE_ACCURACY**2 * values[..., -1:], np.finfo(float).tiny)
    seen = (values > floor)[..., None, :]
    variance = 1 / np.maximum(values, floor)[..., None, :]
    parts = directions**2 * np.where(seen, variance, 0.0)
    hidden = (~seen & (np.abs(directions) > _TAKES_PART)).any(axis=-1)
    errors = np.sqrt(parts.sum(axis=-1)) * unknowns.scales
    return np.where(hidden | ~present[..., 0], np.inf, errors)


def strongest(matrices: Sequence[Floats]) -> int:
    """Number of the information with the largest smallest eigenvalue relative to its largest."""
    values = [np.linalg.eigvalsh(np.nan_to_num(matrix)) for matrix in matrices]
    return int(np.argmax([row[0] / row[-1] if row[-1] > 0 else -1.0 for row in values]))
