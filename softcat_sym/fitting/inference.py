"""What data tell at an optimum: profile likelihoods, and what a fit may say of each unknown."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Literal, Protocol

import numpy as np

from softcat_sym.fitting.identifiability import MAX_ERROR, Information, information, noise_of, two_sided_quantile
from softcat_sym.fitting.least_squares import (
    LINEAR,
    Fall,
    Fixed,
    Floats,
    LeastSquares,
    Loss,
    Optimum,
    Waterfall,
    has_answer,
    minimise,
    multi_start,
    on_bound,
    settle,
)

Flag = Literal["crosses", "reaches the bound", "the model has no answer beyond", "too many steps"]

TOO_MANY: Flag = "too many steps"

# Roots of the increase, as shares of the threshold's, that the steps aim at; the last one lies beyond the crossing, so
# that a picture shows the curve go through the line.
_AIMS = (0.5, 1.05)
_FIRST_AIM_UNTIL = 0.3
# A step is at most this share of the box, and this many times the one before.
_WIDEST, _GROWTH = 1 / 8, 3.0
_MAX_STEPS = 30
# Of the model for each point: a warm start needs five, and where nothing is identified it may go on for ever.
_MAX_EVALUATIONS = 30
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
    """One branch of a profile."""

    crossing: float | None  # q at the threshold
    flag: Flag  # How the branch ends
    # Other unknowns that lie on a bound at the crossing though not at the optimum: with wider bounds for them, this
    # one's interval would be wider.
    held_back: tuple[str, ...] = ()
    # Whether counted evaluations sufficed to settle the others there: otherwise it may lie further out.
    certain: bool = True


@dataclass(frozen=True, eq=False)
class Profile:
    """The profile of one unknown."""

    name: str  # The unknown
    optimum: float  # Its q in the best fit
    q: Floats  # shape (points,); Where it was held, increasing, with the optimum among them
    # shape (points,); (RSS(q) - RSS)/s^2, the others re-optimised; s = 1 if the noise is known, sqrt(RSS/(m - k))
    # otherwise. Of a robust loss the rise of sum rho over
    # :attr:`softcat_sym.fitting.identifiability.Noise.per_chi_square`.
    increase: Floats
    others: Floats  # shape (points, k - 1); The other unknowns there
    threshold: float  # Of `increase`: the 95 % quantile of chi^2 with one degree of freedom, 3.84, or of F(1, m - k)
    lower: Side  # The branches
    upper: Side
    unconverged: int  # Points at which the others were not found with certainty: the profile may be lower there
    # shape (k,); A fit better than the optimum that was met on the way: the optimum was a local one.
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
    """Follow the profile of one unknown from the optimum outwards, to the threshold or the bounds."""
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
            if len(points) == _MAX_STEPS or (self.most is not None and self.spent >= self.most):
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
        while abs(nearest.root - 1) > accuracy and len(found) < _MAX_STEPS:
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
            fixed, start, loss=self.loss, warm=True, tolerance=_TOLERANCE, max_evaluations=_MAX_EVALUATIONS
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


Word = Literal["identified", "one-sided", "not identified", "at a bound"]


@dataclass(frozen=True)
class ParameterVerdict:
    """What is known of one unknown, in q."""

    name: str  # The unknown
    # ``"identified"``: the 95 % interval ends on both sides, within its own bounds and with less than a factor e for
    # a standard error. ``"one-sided"``: it ends on one side. ``"not identified"``: it ends on no side, or says next
    # to nothing. ``"at a bound"``: the best value lies on a bound and the data pull it beyond: the bound or the model
    word: Word
    value: float | None  # The best q; None where a number would mislead: not identified, or one-sided
    best: float  # The q of the best fit, whatever it is worth
    standard_error: float | None  # Of q from the Fisher information; None unless identified
    # Ends of the 95 % interval of q; None where it has no end within the bounds. A single end is exceeded with a
    # probability of at most 5 %.
    lower: float | None
    upper: float | None
    reason: str  # One sentence why; empty for an identified unknown


def verdicts(
    problem: LeastSquares,
    optimum: Optimum,
    information: Information,
    profiles: Sequence[Profile] | None = None,
    loss: Loss = LINEAR,
) -> tuple[ParameterVerdict, ...]:
    """Judge every unknown."""
    if not optimum.converged:
        reason = "the fit did not converge, so that nothing follows from where it ended"
        last = zip(information.names, optimum.q.tolist(), strict=True)
        return tuple(ParameterVerdict(name, "not identified", None, q, None, None, None, reason) for name, q in last)
    found = []
    pulls = _pulls(optimum, information, loss)
    for k, name in enumerate(information.names):
        bounds = float(problem.lower[k]), float(problem.upper[k])
        error = float(information.standard_errors[k])
        if profiles is None:
            half = information.quantile * error if information.identified[k] else math.inf
            ends = _linear_ends(float(optimum.q[k]), half, bounds)
        else:
            ends = _profile_ends(profiles[k], identified=bool(information.identified[k]))
        pulled = bool(optimum.at_bound[k]) and pulls[k] > information.quantile
        one = _judged(name, float(optimum.q[k]), error, ends, information, pulled=pulled, index=k)
        found.append(one if profiles is None else _as_far_as_followed(one, profiles[k]))
    return tuple(found)


def _as_far_as_followed(verdict: ParameterVerdict, profile: Profile) -> ParameterVerdict:
    """The verdict with what was not looked at said: an end that is not known may lie beyond."""
    sides = (profile.lower, profile.upper)
    if verdict.word == "identified" or all(side.certain and side.flag != TOO_MANY for side in sides):
        return verdict
    unseen = "; its profile was not followed to its end, which would have taken too long"
    return replace(verdict, reason=verdict.reason + unseen)


def _judged(
    name: str,
    best: float,
    error: float,
    ends: tuple[float | None, float | None],
    information: Information,
    *,
    pulled: bool,
    index: int,
) -> ParameterVerdict:
    lower, upper = ends
    if pulled:
        reason = "the best value lies on a bound, and the data pull it further: widen the bound, or doubt the model"
        return ParameterVerdict(name, "at a bound", best, best, None, lower, upper, reason)
    if lower is None and upper is None:
        reason = "every value between the bounds fits the data about equally well" + _in_combination(name, information)
        return ParameterVerdict(name, "not identified", None, best, None, None, None, reason)
    if lower is None or upper is None:
        side = "largest" if lower is None else "least"
        reason = f"the data tell only the {side} possible value" + _in_combination(name, information)
        return ParameterVerdict(name, "one-sided", None, best, None, lower, upper, reason)
    if upper - lower > 2 * information.quantile * MAX_ERROR:
        reason = "its 95 % interval is wider than a standard error of a factor e would make it"
        return ParameterVerdict(
            name, "not identified", None, best, None, lower, upper, reason + _in_combination(name, information)
        )
    # The profile knows better than the curvature at the optimum, if it closes where that does not.
    known = error if information.identified[index] else 0.5 * (upper - lower) / information.quantile
    return ParameterVerdict(name, "identified", best, best, known, lower, upper, "")


def _profile_ends(profile: Profile, *, identified: bool) -> tuple[float | None, float | None]:
    """Crossings; of an undetermined direction, not those that only bounds of other unknowns or haste make."""
    lower, upper = (
        None if (side.held_back or not side.certain) and not identified else side.crossing
        for side in (profile.lower, profile.upper)
    )
    return lower, upper


def _in_combination(name: str, information: Information) -> str:
    texts = [one.text for one in information.combinations if name in one.names]
    return f"; what is identified is {', '.join(texts)}" if texts else ""


def _linear_ends(best: float, half: float, bounds: tuple[float, float]) -> tuple[float | None, float | None]:
    lower, upper = best - half, best + half
    return (lower if lower > bounds[0] else None), (upper if upper < bounds[1] else None)


def _pulls(optimum: Optimum, information: Information, loss: Loss) -> Floats:
    """Score statistic of each unknown, shape (k,): charged residuals along its column, without the free others.

    Near zero where the optimum lies inside the box; large where a bound holds the unknown back (Rao 1948).
    """
    free = ~optimum.at_bound
    charged = optimum.residuals if loss.kind == "linear" else loss.weights(optimum.residuals) * optimum.residuals
    pulls = np.zeros(optimum.q.size)
    for k in np.flatnonzero(optimum.at_bound):
        others = optimum.jacobian[:, free]
        column = optimum.jacobian[:, k]
        alone = column - others @ np.linalg.lstsq(others, column, rcond=1e-8)[0]
        length = float(np.linalg.norm(alone))
        # Where the data hardly see the unknown, a pull is that of a single datum and moves nothing.
        if length * MAX_ERROR > information.noise:
            pulls[k] = abs(float(alone @ charged)) / (length * information.spread.score)
    return pulls


MAX_RESTARTS = 2
"""Better optima that are followed; beyond them the waterfall tells how rugged the problem is."""

# Where directions are undetermined: a profile may take as many evaluations as the starts did together, at least these.
_MIN_EVALUATIONS = 100

# Of the residuals' root mean square, as the waterfall tells fits apart.
_SAME = 0.1


class Judged(LeastSquares, Protocol):
    """A problem that also knows its noise and how its unknowns are scaled."""

    @property
    def noise_known(self) -> bool:
        """Whether the residuals are in standard errors that were measured."""

    @property
    def logarithmic(self) -> tuple[bool, ...]:
        """Which unknowns are logarithms."""


@dataclass(frozen=True, eq=False)
class Inference:
    """What is known of the unknowns."""

    starts: Waterfall  # As it was, or with the better optima in front
    information: Information  # At the best of them
    profiles: tuple[Profile, ...]  # From there; empty if they were not asked for
    verdicts: tuple[ParameterVerdict, ...]  # On every unknown
    restarts: int  # How many better optima the profiles led to


def infer(
    problem: Judged,
    starts: Waterfall,
    loss: Loss,
    *,
    profiles: bool = True,
    told: Callable[[int, int], None] = lambda done, total: None,
) -> Inference:
    """Judge the best of several optima, and whichever better one its profiles come upon."""
    restarts = 0
    while True:
        best = starts.best
        known = _information(problem, best, loss)
        most, traced = _most(starts, known), list[Profile]()
        for k in range(len(problem.names) if profiles and best.converged else 0):
            told(k, len(problem.names))
            traced.append(profile(problem, best.q, k, noise_known=problem.noise_known, loss=loss, most=most))
        better = _improved(problem, starts, traced, loss) if restarts < MAX_RESTARTS else None
        if better is None:
            judged = verdicts(problem, best, known, traced or None, loss)
            return Inference(starts, known, tuple(traced), judged, restarts)
        starts, restarts = better, restarts + 1


def _most(starts: Waterfall, known: Information) -> int | None:
    """Evaluations for a profile; no limit where every direction and unknown is determined, where few are needed."""
    if known.determined.all() and known.identified.all():
        return None
    return max(_MIN_EVALUATIONS, sum(fall.optimum.evaluations for fall in starts.falls))


def _information(problem: Judged, best: Optimum, loss: Loss) -> Information:
    residuals, jacobian = problem.linearised(best.q)
    return information(
        problem.names,
        best.q,
        residuals,
        jacobian,
        (problem.lower, problem.upper),
        noise_known=problem.noise_known,
        logarithmic=problem.logarithmic,
        loss=loss,
    )


def _improved(problem: Judged, starts: Waterfall, traced: list[Profile], loss: Loss) -> Waterfall | None:
    """Put the best optimum that profiles led to in front of the others; None if there is none."""
    met = [one for one in traced if one.better is not None]
    if not met:
        return None
    lowest = min(met, key=lambda one: float(one.increase.min()))
    start: Floats = np.clip(np.asarray(lowest.better), problem.lower, problem.upper)
    found = multi_start(problem, [start], loss=loss).best
    if not found.converged or found.value >= starts.best.value:
        return None
    near = _SAME * float(np.sqrt(np.mean(found.residuals**2)))
    same = float(np.linalg.norm(found.residuals - starts.best.residuals)) < near
    others = (Fall(one.start, one.optimum, one.cluster + (not same)) for one in starts.falls)
    return Waterfall((Fall(start, found, 0), *others), starts.rejected)
