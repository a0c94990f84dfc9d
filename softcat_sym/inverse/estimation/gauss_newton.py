"""A least-squares problem with its loss: value, gradient, Gauss-Newton Hessian and step, evaluated once a point."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import SoftcatError
from softcat_sym.inverse.estimation.least_squares import Floats, LeastSquares, Loss

REACHED = 1e-4
"""Offset of an optimum that is reached as far as data can tell (Bates and Watts 1981)."""

AT_BOUND = 1e-4
"""An unknown this close to a bound, as a share of the box, lies on it."""

NOISE = "Stopped_At_Noise_Of_Model"
"""Said of an optimum around which the model's own noise leaves nothing to gain."""

# So many points in a row without a lower value, where the step that Gauss and Newton would still make is less than a
# tenth of the standard errors, or a hundred-thousandth: the model's arithmetic is too noisy for a line search.
_PATIENCE, _SMALL_OFFSET, _SMALL_STEP = 6, 0.1, 1e-5
_GAIN = 1e-8
# Of the value: a rise that is noise where the step left to do is small and has become ten times smaller.
_RISE, _SMALLER = 1e-5, 0.1


@dataclass(frozen=True, eq=False)
class Point:
    """The model at one point; the value is NaN where it has no answer.

    Attributes
    ----------
    q : ndarray, shape (k,)
        The unknowns.
    value : float
        1/2 sum rho(r^2).
    residuals : ndarray, shape (m,)
        Before the loss.
    jacobian : ndarray, shape (m, k)
        Their derivatives.
    """

    q: Floats
    value: float
    residuals: Floats
    jacobian: Floats


class Model:
    """A problem with its loss, whose last point and best point are kept.

    Attributes
    ----------
    evaluations : int
        How often the problem was asked for residuals and derivatives.
    stopped : str or None
        Why it is to be asked no more.
    """

    def __init__(self, problem: LeastSquares, loss: Loss, most: int) -> None:
        self.problem = problem
        self.loss = loss
        self.evaluations = 0
        self.stopped: str | None = None
        self._most = most
        self._last: Point | None = None
        self._best: Point | None = None
        self._mark, self._marked_at = np.inf, 0

    @property
    def best(self) -> Point:
        """The point of the least value so far; among those that noise alone tells apart, the one nearest an optimum.

        Raises
        ------
        SoftcatError
            If the model had no answer anywhere.
        """
        if self._best is None:
            raise SoftcatError("the model has no answer where the fit starts; accepted: another starting point")
        return self._best

    def at(self, q: Floats) -> Point:
        """Evaluate, unless this is the last or the best point."""
        for known in (self._last, self._best):
            if known is not None and np.array_equal(known.q, q):
                return known
        self.evaluations += 1
        residuals, jacobian = self.problem.linearised(q)
        finite = bool(np.isfinite(residuals).all() and np.isfinite(jacobian).all())
        value = self.loss.value(residuals) if finite else np.nan
        self._last = Point(q.copy(), value, residuals, jacobian)
        if finite and (self._best is None or value < self._best.value):
            self._best = self._last
        self._judge_progress()
        return self._last

    def step(self, point: Point) -> tuple[Floats, float]:
        """What Gauss and Newton would still do.

        Returns
        -------
        step : ndarray, shape (k,)
            Of the unknowns; zero for those that lie on a bound, and along directions that do not matter.
        offset : float
            Norm of the part of the residuals that the step removes to first order, over the root mean square residual:
            the length of the step in standard errors (Bates and Watts 1981).
        """
        step = np.zeros(point.q.size)
        free = ~on_bound(self.problem, point.q)
        size = float(np.sqrt(np.mean(point.residuals**2)))
        if size == 0 or not free.any():
            return step, 0.0
        root = np.sqrt(self.loss.weights(point.residuals))
        columns = root[:, None] * point.jacobian[:, free]
        step[free] = -np.linalg.lstsq(columns, root * point.residuals, rcond=1e-8)[0]
        return step, float(np.linalg.norm(columns @ step[free])) / size

    def _judge_progress(self) -> None:
        if self._best is not None and self._best.value < self._mark * (1 - _GAIN):
            self._mark, self._marked_at = self._best.value, self.evaluations
        elif self._last is not None and self._is_nearer(self._last):
            # Derivatives of the discrete solution have far less noise than its value: this point is the better one.
            if self._last.value > self.best.value * (1 + _GAIN):
                self.stopped = NOISE
            # What rose by less is as low as the other, and a line search may go on from there.
            self._last = replace(self._last, value=self.best.value)
            self._best = self._last
        elif self._best is not None and (self.evaluations - self._marked_at) % _PATIENCE == 0:
            step, offset = self.step(self._best)
            if offset < _SMALL_OFFSET or np.abs(step).max() < _SMALL_STEP:
                self.stopped = NOISE
        if self.evaluations >= self._most and self.stopped is None:
            self.stopped = "Maximum_Evaluations_Exceeded"

    def _is_nearer(self, last: Point) -> bool:
        """Whether a point is nearer to an optimum than the best one, though by noise its value is not lower."""
        best = self._best
        if best is None or last is best or not last.value <= best.value * (1 + _RISE):
            return False
        offset = self.step(best)[1]
        return offset < _SMALL_OFFSET and self.step(last)[1] < _SMALLER * offset

    def gradient(self, point: Point) -> Floats:
        """Of the value with respect to q, shape (k,)."""
        gradient: Floats = point.jacobian.T @ (self.loss.weights(point.residuals) * point.residuals)
        return gradient

    def hessian(self, point: Point) -> Floats:
        """Gauss-Newton's, shape (k, k)."""
        hessian: Floats = point.jacobian.T @ (self.loss.curvatures(point.residuals)[:, None] * point.jacobian)
        return hessian


def on_bound(problem: LeastSquares, q: Floats) -> NDArray[np.bool_]:
    """Which unknowns lie within `AT_BOUND` of the box of one of their bounds; shape (k,)."""
    room = np.minimum(q - problem.lower, problem.upper - q)
    near: NDArray[np.bool_] = room <= AT_BOUND * (problem.upper - problem.lower)
    return near
