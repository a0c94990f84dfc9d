"""Damped Gauss-Newton steps that come to rest where data leave directions undetermined."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softcat_sym.inverse.estimation.gauss_newton import on_bound
from softcat_sym.inverse.estimation.least_squares import Floats, LeastSquares, Loss

# In units of chi^2 for a step of one in q: directions that matter less hardly move.
_DAMPING = 1e-3
_LEAST_DAMPING, _LESS, _MORE, _MOST_DAMPING = 1e-6, 0.1, 10.0, 1e4


@dataclass(frozen=True, eq=False)
class Settled:
    """Where the steps ended.

    Attributes
    ----------
    q : ndarray, shape (k,)
        The unknowns, in the box.
    value : float
        Twice the loss there.
    evaluations : int
        Of the model, with derivatives or without.
    converged : bool
        Whether a further step would gain less than asked.
    """

    q: Floats
    value: float
    evaluations: int
    converged: bool


def settle(problem: LeastSquares, start: Floats, loss: Loss, *, unit: float, gain: float, most: int) -> Settled | None:
    """Improve a start until a step would gain next to nothing (Levenberg 1944, Marquardt 1963).

    An optimum of undetermined unknowns is a valley, along which a method that asks for a vanishing gradient walks for
    long and gains nothing. These steps end by what they would gain.

    Parameters
    ----------
    problem : LeastSquares
        The problem.
    start : ndarray, shape (k,)
        In the box.
    loss : Loss
        What residuals are charged.
    unit : float
        Of twice the loss, for one of chi^2.
    gain : float
        In those units: a step that would gain less is not made.
    most : int
        Evaluations.

    Returns
    -------
    Settled or None
        None where the model has no answer at the start.
    """
    here, damping, used = np.array(start, dtype=np.float64), _DAMPING, 1
    residuals, jacobian = problem.linearised(here)
    if not (np.isfinite(residuals).all() and np.isfinite(jacobian).all()):
        return None
    value = 2 * loss.value(residuals)
    while True:
        step, expected = _step(problem, here, residuals, jacobian, loss, damping * unit)
        if expected < gain * unit:
            return Settled(here, value, used, True)
        if used >= most or damping > _MOST_DAMPING:
            return Settled(here, value, used, False)
        ahead = np.clip(here + step, problem.lower, problem.upper)
        tried, used = problem.residuals(ahead), used + 1
        lower = 2 * loss.value(tried) if np.isfinite(tried).all() else np.inf
        if lower >= value:
            damping *= _MORE
            continue
        found, slopes = problem.linearised(ahead)
        used += 1
        if not np.isfinite(slopes).all():
            return Settled(here, value, used, False)
        here, residuals, jacobian, value = ahead, found, slopes, 2 * loss.value(found)
        damping = max(damping * _LESS, _LEAST_DAMPING)


def _step(
    problem: LeastSquares, q: Floats, residuals: Floats, jacobian: Floats, loss: Loss, damping: float
) -> tuple[Floats, float]:
    """A damped step inside the box, and by how much twice the loss would fall to first order."""
    gradient = jacobian.T @ (loss.weights(residuals) * residuals)
    hessian = jacobian.T @ (loss.curvatures(residuals)[:, None] * jacobian)
    low = q - problem.lower < problem.upper - q
    free = ~(on_bound(problem, q) & np.where(low, gradient > 0, gradient < 0))
    step = np.zeros(q.size)
    while free.any():
        # What is not free has its step, as far as its bound.
        pull = gradient[free] + hessian[np.ix_(free, ~free)] @ step[~free]
        step[free] = -np.linalg.solve(hessian[np.ix_(free, free)] + damping * np.eye(int(free.sum())), pull)
        inside = np.clip(q + step, problem.lower, problem.upper) - q
        beyond = free & (inside != step) & (np.abs(inside - step) > 1e-12 * np.abs(step))
        step = inside
        if not beyond.any():
            break
        free &= ~beyond
    return step, float(-2 * gradient @ step - step @ hessian @ step)
