"""What is left of an error as the thickness goes to zero: a fit of known order, and how far it can be trusted."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from softcat_sym.graph.grid import Floats

_LEAST_LINE, _LEAST_PARABOLA = 3, 5


@dataclass(frozen=True)
class Limit:
    """The intercept of an error fitted by e0 + a delta (+ b delta^2, from five values on).

    Attributes
    ----------
    intercept : float
        e0, the error of the slender limit.
    coefficients : tuple of float
        e0, a and, if fitted, b.
    leaving_out : float
        Largest change of the intercept when one value is left out.
    mesh : float
        Change of the intercept when the coarser elements judge instead of the finer.
    order : float
        Power of delta that the error itself follows, by its two smallest values; NaN where the sign changes.
    """

    intercept: float
    coefficients: tuple[float, ...]
    leaving_out: float
    mesh: float
    order: float

    @property
    def uncertainty(self) -> float:
        """Leaving out and mesh together."""
        return math.hypot(self.leaving_out, self.mesh)

    def at(self, delta: Floats) -> Floats:
        """The fitted error; same shape as `delta`."""
        return np.asarray(np.polynomial.polynomial.polyval(delta, self.coefficients), dtype=np.float64)


def slender_limit(delta: Floats, error: Floats, mesh: Floats) -> Limit | None:
    """Extrapolate an error to delta = 0.

    Parameters
    ----------
    delta : ndarray, shape (n,)
        h0/L, positive.
    error : ndarray, shape (n,)
        Error of a theory against the finer elements; NaN where there is none, which is left out.
    mesh : ndarray, shape (n,)
        By how much that error would change with the coarser elements.

    Returns
    -------
    Limit or None
        None where fewer than three errors are known.

    Notes
    -----
    A beam theory is left with the first power of the thickness, since the layers at its clamps are as long as it is
    thick and hold a finite share of what yields.
    """
    known = np.isfinite(error) & np.isfinite(mesh)
    x, y, m = delta[known], error[known], mesh[known]
    if len(x) < _LEAST_LINE:
        return None
    degree = 2 if len(x) >= _LEAST_PARABOLA else 1
    fitted = _fit(x, y, degree)
    without = (np.delete(np.arange(len(x)), k) for k in range(len(x)))
    shifts = [abs(_fit(x[kept], y[kept], degree)[0] - fitted[0]) for kept in without]
    return Limit(
        intercept=float(fitted[0]),
        coefficients=tuple(map(float, fitted)),
        leaving_out=float(max(shifts)),
        # A fit is linear in what it fits.
        mesh=float(abs(_fit(x, m, degree)[0])),
        order=_order(x, y),
    )


def _fit(x: Floats, y: Floats, degree: int) -> Floats:
    scale = float(x.max())
    found = np.linalg.lstsq(np.vander(x / scale, degree + 1, increasing=True), y, rcond=None)[0]
    return np.asarray(found / scale ** np.arange(degree + 1), dtype=np.float64)


def _order(x: Floats, y: Floats) -> float:
    thin = np.argsort(x)[:2]
    ratio = y[thin[1]] / y[thin[0]] if y[thin[0]] else math.nan
    return float(math.log(ratio) / math.log(x[thin[1]] / x[thin[0]])) if ratio > 0 else math.nan
