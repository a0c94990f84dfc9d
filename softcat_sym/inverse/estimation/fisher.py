"""Fisher information of a least-squares fit: covariance, what the data determine, and in which combinations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from softcat_sym.inverse.estimation.combinations import Combination, combinations
from softcat_sym.inverse.estimation.confidence import two_sided_quantile
from softcat_sym.inverse.estimation.least_squares import LINEAR, Floats, Loss
from softcat_sym.inverse.estimation.noise import Noise, noise_of

LARGEST_ERROR = 1.0
"""Standard error of q from which on the data do not determine it: a factor e, or the whole of a typical value."""

DERIVATIVE_ACCURACY = 1e-6
"""Of the largest singular value: a smaller one is what the derivatives' own errors leave of zero."""


@dataclass(frozen=True, eq=False)
class Information:
    """What the curvature of the sum of squares at the optimum says.

    A direction of the unknowns is determined if its standard error is less than `LARGEST_ERROR` and its singular value
    is more than `DERIVATIVE_ACCURACY` of the largest. Along the others the linear theory has no meaning beyond the
    bounds: their standard error is at most the half-length of the box.

    Attributes
    ----------
    names : tuple of str
        The k unknowns.
    spread : Noise
        Of the residuals.
    matrix : ndarray, shape (k, k)
        J^T J/s^2, s being `noise`.
    covariance : ndarray, shape (k, k)
        Its inverse, with the errors of undetermined directions cut as above.
    standard_errors : ndarray, shape (k,)
        Square roots of its diagonal, of q.
    singular_values : ndarray, shape (k,)
        Of J/s, the largest first: reciprocal standard errors of the directions.
    directions : ndarray, shape (k, k)
        In columns.
    determined : ndarray of bool, shape (k,)
        Which directions are.
    combinations : tuple of Combination
        What is determined of the others; empty if every unknown and every direction is identified.
    """

    names: tuple[str, ...]
    spread: Noise
    matrix: Floats
    covariance: Floats
    standard_errors: Floats
    singular_values: Floats
    directions: Floats
    determined: NDArray[np.bool_]
    combinations: tuple[Combination, ...]

    @property
    def noise(self) -> float:
        """Standard deviation s of the residuals, one if it is known; of a robust loss that of its M-estimator, tau."""
        return self.spread.deviation

    @property
    def freedom(self) -> int | None:
        """Degrees m - k; None where the noise is known."""
        return self.spread.freedom

    @property
    def correlation(self) -> Floats:
        """Normalised covariance, shape (k, k)."""
        normalised: Floats = self.covariance / np.outer(self.standard_errors, self.standard_errors)
        return normalised

    @property
    def identified(self) -> NDArray[np.bool_]:
        """Which single unknowns are determined, shape (k,): those with a standard error below `LARGEST_ERROR`."""
        below: NDArray[np.bool_] = self.standard_errors < LARGEST_ERROR
        return below

    @property
    def rank(self) -> int:
        """How many directions are determined."""
        return int(self.determined.sum())

    @property
    def quantile(self) -> float:
        """The number of standard errors in half a 95 % interval."""
        return two_sided_quantile(self.freedom)


def information(
    names: tuple[str, ...],
    q: Floats,
    residuals: Floats,
    jacobian: Floats,
    box: tuple[Floats, Floats],
    *,
    noise_known: bool,
    logarithmic: tuple[bool, ...] | None = None,
    loss: Loss = LINEAR,
) -> Information:
    """Judge an optimum by its Jacobian.

    Parameters
    ----------
    names : tuple of str
        The k unknowns.
    q, residuals, jacobian : ndarray, shape (k,), (m,), (m, k)
        At the optimum.
    box : (ndarray, ndarray)
        Bounds of q.
    noise_known : bool
        Whether the residuals are in standard errors that were measured.
    logarithmic : tuple of bool or None
        Which unknowns are logarithms; None: all.
    loss : Loss
        What was minimised.

    Raises
    ------
    SoftcatError
        If the noise has to be estimated and there are no more data than unknowns.
    """
    spread = noise_of(residuals, jacobian, noise_known=noise_known, loss=loss)
    noise, freedom = spread.deviation, spread.freedom
    directions, singular, errors, determined = _spectrum(jacobian / noise, box)
    root, flags = directions * errors, logarithmic or (True,) * len(names)
    standard = np.linalg.norm(root, axis=1)
    found = combinations(names, q, root, directions[:, determined], two_sided_quantile(freedom), flags)
    return Information(
        names=names,
        spread=spread,
        matrix=jacobian.T @ jacobian / noise**2,
        covariance=root @ root.T,
        standard_errors=standard,
        singular_values=singular,
        directions=directions,
        determined=determined,
        combinations=() if determined.all() and np.all(standard < LARGEST_ERROR) else found,
    )


def _spectrum(scaled: Floats, box: tuple[Floats, Floats]) -> tuple[Floats, Floats, Floats, NDArray[np.bool_]]:
    """Directions in columns, their singular values, their errors, at most as long as the box, and which are known."""
    unknowns = scaled.shape[1]
    # Rows of zeros, so that there are as many singular values as unknowns even for fewer data.
    _, singular, rows = np.linalg.svd(np.vstack([scaled, np.zeros((unknowns, unknowns))]), full_matrices=False)
    significant = singular > DERIVATIVE_ACCURACY * singular[0]
    half_lengths = _half_lengths(rows.T, box)
    raw = 1 / np.where(significant, singular, np.nan)
    errors = np.where(significant, np.fmin(raw, half_lengths), half_lengths)
    return rows.T, singular, errors, significant & (raw < LARGEST_ERROR)


def _half_lengths(directions: Floats, box: tuple[Floats, Floats]) -> Floats:
    """Half-length of the box along each direction, shape (k,), through its middle."""
    width = (box[1] - box[0])[:, None]
    with np.errstate(divide="ignore"):
        lengths: Floats = (0.5 * width / np.abs(directions)).min(axis=0)
    return lengths
