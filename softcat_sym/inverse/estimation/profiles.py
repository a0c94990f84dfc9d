"""Profile likelihood: how much worse the best fit becomes as one unknown is held away from its optimum."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from softcat_sym.inverse.estimation.confidence import two_sided_quantile
from softcat_sym.inverse.estimation.fisher import noise_of
from softcat_sym.inverse.estimation.gauss_newton import on_bound
from softcat_sym.inverse.estimation.least_squares import Fixed, Floats, LeastSquares, has_answer
from softcat_sym.inverse.estimation.optimise import minimise

Flag = Literal["crosses", "reaches the bound", "the model has no answer beyond", "too many steps"]

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
# Of the re-optimised unknowns' gradient in standard errors: the increase is wrong by its square.
_TOLERANCE = 1e-4
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
    """

    crossing: float | None
    flag: Flag
    held_back: tuple[str, ...] = ()


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
        (RSS(q) - RSS)/s^2, the others re-optimised; s = 1 if the noise is known, sqrt(RSS/(m - k)) otherwise.
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


def profile(problem: LeastSquares, q: Floats, index: int, *, noise_known: bool) -> Profile:
    """Follow the profile of one unknown from the optimum outwards, to the threshold or the bounds.

    Parameters
    ----------
    problem : LeastSquares
        The problem.
    q : ndarray, shape (k,)
        Its optimum.
    index : int
        Which unknown.
    noise_known : bool
        Whether the residuals are in standard errors that were measured.

    Returns
    -------
    Profile
        Raue et al. (2009); with estimated noise, Bates and Watts (1988), section 6.1.

    Raises
    ------
    SoftcatError
        If the noise has to be estimated and there are no more data than unknowns.
    """
    path = _Path(problem, np.array(q, dtype=np.float64), index, noise_known=noise_known)
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

    def __init__(self, problem: LeastSquares, q: Floats, index: int, *, noise_known: bool) -> None:
        self.problem = problem
        self.index = index
        residuals, jacobian = problem.linearised(q)
        noise, freedom = noise_of(residuals, jacobian, noise_known=noise_known)
        self.threshold = two_sided_quantile(freedom) ** 2
        self.variance = noise**2
        self.least = float(residuals @ residuals)
        others = np.delete(jacobian, index, axis=1)
        slope = -np.asarray(np.linalg.lstsq(others, jacobian[:, index], rcond=1e-8)[0], dtype=np.float64)
        self.start = _Held(float(q[index]), np.delete(q, index), slope, 0.0, 0.0, True)
        alone = float(np.linalg.norm(jacobian[:, index] + others @ slope))
        # Where the parabola crosses.
        self.distance = math.sqrt(self.variance * self.threshold) / alone if alone > 0 else math.inf

    def branch(self, bound: float) -> tuple[list[_Held], Side]:
        """Steps from the optimum towards a bound, until the threshold is crossed."""
        sign = 1.0 if bound > self.start.q else -1.0
        box = float(self.problem.upper[self.index] - self.problem.lower[self.index])
        here, points = self.start, list[_Held]()
        length = min(_AIMS[0] * self.distance, _WIDEST * box)
        while abs(bound - here.q) > 1e-9 * box:
            if len(points) == _MOST_STEPS:
                return points, Side(None, "too many steps")
            ahead = self._step(here, sign, min(length, abs(bound - here.q)))
            if ahead is None:
                return points, Side(None, "the model has no answer beyond")
            points.append(ahead)
            if ahead.root >= 1:
                inner, crossing = self._cross(here, ahead)
                return points + inner, Side(crossing, "crosses", self._held_back([ahead, *inner]))
            done = abs(ahead.q - here.q)
            rise = (ahead.root - here.root) / done
            aim = _AIMS[0] if ahead.root < _FIRST_AIM_UNTIL else _AIMS[1]
            wanted = (aim - ahead.root) / rise if rise > 0 else math.inf
            here, length = ahead, min(wanted, _GROWTH * done, _WIDEST * box)
        return points, Side(None, "reaches the bound")

    def _held_back(self, points: list[_Held]) -> tuple[str, ...]:
        nearest = min((one for one in points if one.root >= 1), key=lambda one: one.root)
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
        while abs(nearest.root - 1) > _ACCURACY and len(found) < _MOST_STEPS:
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
            residuals, others, converged = fixed.residuals(start), start, True
            if not (has_answer(fixed, start) if start.size else np.isfinite(residuals).all()):
                continue
            if start.size:
                optimum = minimise(fixed, start, warm=True, tolerance=_TOLERANCE, max_evaluations=_MOST_EVALUATIONS)
                others, residuals, converged = optimum.q, optimum.residuals, optimum.converged
            increase = (float(residuals @ residuals) - self.least) / self.variance
            root = math.copysign(math.sqrt(abs(increase) / self.threshold), increase)
            slope = (others - near.others) / (fixed.at - near.q)
            return _Held(fixed.at, others, slope, increase, root, converged)
        return None
