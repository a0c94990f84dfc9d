"""Profile likelihood: how much worse the best fit becomes as one unknown is held away from its optimum."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from softcat_sym.inverse.estimation.confidence import two_sided_quantile
from softcat_sym.inverse.estimation.gauss_newton import on_bound
from softcat_sym.inverse.estimation.least_squares import LINEAR, Fixed, Floats, LeastSquares, Loss, has_answer
from softcat_sym.inverse.estimation.levenberg_marquardt import settle
from softcat_sym.inverse.estimation.noise import noise_of
from softcat_sym.inverse.estimation.optimise import minimise

Flag = Literal["crosses", "reaches the bound", "the model has no answer beyond", "too many steps"]

TOO_MANY: Flag = "too many steps"

# Roots of the increase, as shares of the threshold's, that the steps aim at; the last one lies beyond the crossing, so
# that a picture shows the curve go through the line.
_AIMS = (0.5, 1.05)
_FIRST_AIM_UNTIL = 0.3
# A step is at most this share of the box, and this many times the one before.
_WIDEST, _GROWTH = 1 / 8, 3.0
_MOST_STEPS = 30
# Of the model for each point: a warm start needs five, and where nothing is identified it may go on for ever.
_MOST_EVALUATIONS = 30
_HALVINGS = 4
# A crossing is found when the root of the increase is the threshold's to this share: a two-hundredth of the interval.
_ACCURACY = 0.005
# Of the others' gradient in standard errors: the increase is wrong by its square.
_TOLERANCE = 1e-4
# Where evaluations are counted: a point that fits this well, as a share of the root of the threshold's increase, is
# taken as it is; a crossing is found to this share; and others are settled when a step gains this share of it.
_AS_IT_IS, _ROUGH, _GAIN = 0.3, 0.02, 1e-5
# A fit better than the optimum by this share of the threshold is another optimum.
_BETTER = 0.01


@dataclass(frozen=True, eq=False)
class Side:
    """One branch of a profile.

    Attributes
    ----------
    crossing : float or None
        q at the threshold.
    flag : str
        How the branch ends.
    held_back : tuple of str
        Other unknowns that lie on a bound at the crossing though not at the optimum: with wider bounds for them, this
        one's interval would be wider.
    certain : bool
        Whether counted evaluations sufficed to settle the others there: otherwise it may lie further out.
    """

    crossing: float | None
    flag: Flag
    held_back: tuple[str, ...] = ()
    certain: bool = True


@dataclass(frozen=True, eq=False)
class Profile:
    """The profile of one unknown.

    Attributes
    ----------
    name : str
        The unknown.
    optimum : float
        Its q in the best fit.
    q : ndarray, shape (points,)
        Where it was held, increasing, with the optimum among them.
    increase : ndarray, shape (points,)
        (RSS(q) - RSS)/s^2, the others re-optimised; s = 1 if the noise is known, sqrt(RSS/(m - k)) otherwise. Of a
        robust loss the rise of sum rho over :attr:`softcat_sym.inverse.estimation.noise.Noise.per_chi_square`.
    others : ndarray, shape (points, k - 1)
        The other unknowns there.
    threshold : float
        Of `increase`: the 95 % quantile of chi^2 with one degree of freedom, 3.84, or of F(1, m - k).
    lower, upper : Side
        The branches.
    unconverged : int
        Points at which the others were not found with certainty: the profile may be lower there.
    better : ndarray, shape (k,), or None
        A fit better than the optimum that was met on the way: the optimum was a local one.
    """

    name: str
    optimum: float
    q: Floats
    increase: Floats
    others: Floats
    threshold: float
    lower: Side
    upper: Side
    unconverged: int
    better: Floats | None


@dataclass(frozen=True, eq=False)
class _Held:
    """The best fit with the unknown held at q.

    `root` is the root of the increase over that of the threshold, nearly a straight line in q; `slope` the derivative
    of the others along the path.
    """

    q: float
    others: Floats
    slope: Floats
    increase: float
    root: float
    converged: bool


def profile(
    problem: LeastSquares, q: Floats, index: int, *, noise_known: bool, loss: Loss = LINEAR, most: int | None = None
) -> Profile:
    """Follow the profile of one unknown from the optimum outwards, to the threshold or the bounds.

    Parameters
    ----------
    problem : LeastSquares
        The problem.
    q : ndarray, shape (k,)
        Its optimum.
    index : int
        Which unknown.
    noise_known, loss : bool, Loss
        Whether the residuals are in standard errors that were measured; what was minimised.
    most : int, optional
        Evaluations of the model, for problems with undetermined directions, along which there is no end to minimising:
        then points that fit about as well as the optimum are taken as they are, which the profile is at most, and a
        branch whose half of them is spent ends with "too many steps".

    Returns
    -------
    Profile
        Raue et al. (2009); with estimated noise, Bates and Watts (1988), section 6.1; of a robust loss the test of
        Schrader and Hettmansperger (1980).

    Raises
    ------
    SoftcatError
        If the noise has to be estimated and there are no more data than unknowns.
    """
    path = _Path(problem, np.array(q, dtype=np.float64), index, noise_known=noise_known, loss=loss, most=most)
    branches = [path.branch(bound) for bound in (problem.lower[index], problem.upper[index])]
    points = sorted([*branches[0][0], path.start, *branches[1][0]], key=lambda one: one.q)
    best = min(points, key=lambda one: one.increase)
    better = np.insert(best.others, index, best.q) if best.increase < -_BETTER * path.threshold else None
    return Profile(
        name=problem.names[index],
        optimum=path.start.q,
        q=np.array([one.q for one in points]),
        increase=np.array([one.increase for one in points]),
        others=np.array([one.others for one in points]),
        threshold=path.threshold,
        lower=branches[0][1],
        upper=branches[1][1],
        unconverged=sum(not one.converged for one in points),
        better=better,
    )


class _Path:
    """The problem with one unknown held, measured against its optimum."""

    def __init__(
        self, problem: LeastSquares, q: Floats, index: int, *, noise_known: bool, loss: Loss, most: int | None
    ) -> None:
        self.problem, self.loss = problem, loss
        self.most, self.spent = None if most is None else most // 2, 0
        self.index = index
        residuals, jacobian = problem.linearised(q)
        noise = noise_of(residuals, jacobian, noise_known=noise_known, loss=loss)
        self.threshold = two_sided_quantile(noise.freedom) ** 2
        self.variance = noise.per_chi_square
        self.least = 2 * loss.value(residuals)
        others = np.delete(jacobian, index, axis=1)
        slope = -np.asarray(np.linalg.lstsq(others, jacobian[:, index], rcond=1e-8)[0], dtype=np.float64)
        self.start = _Held(float(q[index]), np.delete(q, index), slope, 0.0, 0.0, True)
        alone = float(np.linalg.norm(jacobian[:, index] + others @ slope))
        # Where the parabola crosses.
        self.distance = math.sqrt(noise.deviation**2 * self.threshold) / alone if alone > 0 else math.inf

    def branch(self, bound: float) -> tuple[list[_Held], Side]:
        """Steps from the optimum towards a bound, until the threshold is crossed."""
        sign = 1.0 if bound > self.start.q else -1.0
        box = float(self.problem.upper[self.index] - self.problem.lower[self.index])
        here, points, self.spent = self.start, list[_Held](), 0
        length = min(_AIMS[0] * self.distance, _WIDEST * box)
        while abs(bound - here.q) > 1e-9 * box:
            if len(points) == _MOST_STEPS or (self.most is not None and self.spent >= self.most):
                return points, Side(None, TOO_MANY)
            ahead = self._step(here, sign, min(length, abs(bound - here.q)))
            if ahead is None:
                return points, Side(None, "the model has no answer beyond")
            points.append(ahead)
            if ahead.root >= 1:
                inner, crossing = self._cross(here, ahead)
                beyond = min((one for one in [ahead, *inner] if one.root >= 1), key=lambda one: one.root)
                certain = self.most is None or beyond.converged
                return points + inner, Side(crossing, "crosses", self._held_back(beyond), certain)
            done = abs(ahead.q - here.q)
            rise = (ahead.root - here.root) / done
            aim = _AIMS[0] if ahead.root < _FIRST_AIM_UNTIL else _AIMS[1]
            wanted = (aim - ahead.root) / rise if rise > 0 else math.inf
            here, length = ahead, min(wanted, _GROWTH * done, _WIDEST * box)
        return points, Side(None, "reaches the bound")

    def _held_back(self, nearest: _Held) -> tuple[str, ...]:
        others = Fixed(self.problem, self.index, nearest.q)
        stuck = on_bound(others, nearest.others) & ~on_bound(others, self.start.others)
        return tuple(name for name, here in zip(others.names, stuck, strict=True) if here)

    def _step(self, here: _Held, sign: float, length: float) -> _Held | None:
        """Hold the unknown further out, less far where the model has no answer."""
        for halving in range(_HALVINGS + 1):
            held = self._held(here, here.q + sign * length / 2**halving)
            if held is not None:
                return held
        return None

    def _cross(self, inside: _Held, outside: _Held) -> tuple[list[_Held], float]:
        """Find where the root is one by false position, in Illinois' form (Dowell and Jarratt 1971)."""
        found: list[_Held] = []
        at_inside, at_outside = inside.root - 1, outside.root - 1
        nearest = outside
        accuracy = _ACCURACY if self.most is None else _ROUGH
        while abs(nearest.root - 1) > accuracy and len(found) < _MOST_STEPS:
            if self.most is not None and self.spent >= self.most:
                return found, outside.q
            q = (inside.q * at_outside - outside.q * at_inside) / (at_outside - at_inside)
            held = self._held(inside if abs(q - inside.q) < abs(q - outside.q) else outside, q)
            if held is None:
                break
            found.append(held)
            if held.root >= 1:
                at_inside *= 0.5 if nearest.root >= 1 else 1.0
                outside, at_outside = held, held.root - 1
            else:
                at_outside *= 0.5 if nearest.root < 1 else 1.0
                inside, at_inside = held, held.root - 1
            nearest = held
        share = (1 - inside.root) / (outside.root - inside.root)
        return found, inside.q + share * (outside.q - inside.q)

    def _held(self, near: _Held, q: float) -> _Held | None:
        """Best fit with the unknown at q, started from a neighbour along the path; None where there is no answer."""
        low, high = self.problem.lower[self.index], self.problem.upper[self.index]
        fixed = Fixed(self.problem, self.index, float(np.clip(q, low, high)))
        ahead = np.clip(near.others + near.slope * (fixed.at - near.q), fixed.lower, fixed.upper)
        for start in (ahead, near.others):
            found = self._refined(fixed, start) if self.most is None else self._settled(fixed, start, self.most)
            if found is None:
                continue
            others, value, converged = found
            slope = (others - near.others) / (fixed.at - near.q)
            return _Held(fixed.at, others, slope, self._increase(value), self._root(value), converged)
        return None

    def _increase(self, value: float) -> float:
        return (value - self.least) / self.variance

    def _root(self, value: float) -> float:
        increase = self._increase(value)
        return math.copysign(math.sqrt(abs(increase) / self.threshold), increase)

    def _refined(self, fixed: Fixed, start: Floats) -> tuple[Floats, float, bool] | None:
        """The others minimised, twice the loss, and whether that is certain; None without an answer at the start."""
        if not start.size:
            residuals = fixed.residuals(start)
            return (start, 2 * self.loss.value(residuals), True) if np.isfinite(residuals).all() else None
        if not has_answer(fixed, start):
            return None
        optimum = minimise(
            fixed, start, loss=self.loss, warm=True, tolerance=_TOLERANCE, max_evaluations=_MOST_EVALUATIONS
        )
        return optimum.q, 2 * self.loss.value(optimum.residuals), optimum.converged

    def _settled(self, fixed: Fixed, start: Floats, most: int) -> tuple[Floats, float, bool] | None:
        """The same with evaluations counted, at least as good as the start and no better than it need be."""
        residuals = fixed.residuals(start)
        self.spent += 1
        if not np.isfinite(residuals).all():
            return None
        value = 2 * self.loss.value(residuals)
        if not start.size or abs(self._root(value)) < _AS_IT_IS:
            return start, value, True
        left, gain = max(most - self.spent, 1), _GAIN * self.threshold
        found = settle(fixed, start, self.loss, unit=self.variance, gain=gain, most=left)
        self.spent += found.evaluations if found is not None else 1
        return None if found is None else (found.q, found.value, found.converged)
