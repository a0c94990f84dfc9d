"""Profile likelihoods at an optimum, and a verdict on each unknown."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from softcat_sym.fitting.identifiability import (
    MAX_ERROR,
    Information,
    information,
    is_identified,
    noise_of,
    span_text,
    two_sided_quantile,
)
from softcat_sym.fitting.least_squares import (
    SAME_FIT,
    Fixed,
    Floats,
    LeastSquares,
    Method,
    MultiStartResult,
    Optimum,
    StartResult,
    minimise,
    multi_start,
    on_bound,
)
from softcat_sym.interrupts import TimeLimitError

Flag = Literal["crosses", "reaches the bound", "the model has no answer beyond", "too many steps"]

TOO_MANY: Flag = "too many steps"

# Roots of the increase at which steps aim, as shares of the threshold's root; the second lies beyond the crossing, so
# that a plot shows the profile cross the threshold.
_AIMS = (0.5, 1.05)
_FIRST_AIM_UNTIL = 0.3
# Largest step, as a share of the box and as a multiple of the step before.
_MAX_STEP, _GROWTH = 1 / 8, 3.0
_MAX_STEPS = 30
# Maximum evaluations of the model for one point: a warm start needs four; where nothing is identified a search may not
# end.
_MAX_EVALUATIONS = 30
_HALVINGS = 4
# A point that is better than the optimum by this share of the threshold, or 0.6 standard errors, belongs to another
# optimum; a smaller difference may be discretization error.
_BETTER = 0.1
# Relative accuracy of the root of the increase at a crossing, which is interpolated from there.
_ACCURACY = 0.01
# Tolerance of the increase, as a share of the threshold; the relative error of its root is half of that.
_GAIN = 3e-3
# If evaluations are limited, a point is not re-optimised where the root of the increase is below this.
_SUFFICIENT = 0.3


@dataclass(frozen=True, eq=False)
class Side:
    """One branch of a profile."""

    crossing: float | None  # q at the threshold
    flag: Flag  # How the branch ends
    # Other unknowns that lie on a bound at the crossing though not at the optimum: with wider bounds for them, this
    # one's interval would be wider.
    held_back: tuple[str, ...] = ()
    # Whether the evaluations sufficed to optimise the other unknowns there; if not, the crossing may lie further out.
    certain: bool = True


@dataclass(frozen=True, eq=False)
class Profile:
    """The profile of one unknown."""

    name: str
    optimum: float  # Its q in the best fit
    q: Floats  # shape (points,); Values at which the unknown was held, increasing, the optimum among them
    # shape (points,); (RSS(q) - RSS)/s^2, the others re-optimised; s = 1 if the noise is known, sqrt(RSS/(m - k))
    # otherwise.
    increase: Floats
    others: Floats  # shape (points, k - 1); The other unknowns there
    threshold: float  # Of `increase`: the 95 % quantile of chi^2 with one degree of freedom, 3.84, or of F(1, m - k)
    lower: Side
    upper: Side
    unconverged: int  # Points at which the other unknowns did not converge: the profile may be lower there
    # shape (k,); A point of the profile that is better than the optimum, which is a local one then.
    better: Floats | None


@dataclass(frozen=True, eq=False)
class _Held:
    """The best fit with the unknown held at q."""

    q: float
    others: Floats
    slope: Floats  # Derivative of the others along the path
    increase: float
    root: float  # Of the increase over that of the threshold, nearly a straight line in q
    converged: bool


def profile(
    problem: LeastSquares,
    q: Floats,
    index: int,
    *,
    noise_known: bool,
    systematic: float = 0.0,
    max_evaluations: int | None = None,
    best: Floats | None = None,
) -> Profile:
    """Follow the profile of one unknown from an optimum outwards, to the threshold or the bounds.

    The increase is counted from that optimum, or from a better one, `best`.
    """
    start = np.array(q, dtype=np.float64)
    path = _Path(problem, start, index, noise_known, systematic, max_evaluations, best)
    (below, lower), (above, upper) = (path.branch(bound) for bound in (problem.lower[index], problem.upper[index]))
    points = sorted([*below, path.start, *above], key=lambda held: held.q)
    lowest = min(points, key=lambda held: held.increase)
    return Profile(
        name=problem.names[index],
        optimum=path.start.q,
        q=np.array([held.q for held in points]),
        increase=np.array([held.increase for held in points]),
        others=np.array([held.others for held in points]),
        threshold=path.threshold,
        lower=lower,
        upper=upper,
        unconverged=sum(not held.converged for held in points),
        better=np.insert(lowest.others, index, lowest.q) if lowest.increase < -_BETTER * path.threshold else None,
    )


def _joined(one: Profile, other: Profile) -> Profile:
    """The lower of two profiles through different optima; the interval reaches from the first end to the last."""

    def lower_part(mine: Profile, theirs: Profile) -> NDArray[np.bool_]:
        return mine.increase <= np.interp(mine.q, theirs.q, theirs.increase, left=math.inf, right=math.inf)

    pairs = (one, lower_part(one, other)), (other, lower_part(other, one))
    q, increase, others = (
        np.concatenate([getattr(each, name)[kept] for each, kept in pairs]) for name in ("q", "increase", "others")
    )
    order = np.argsort(q)
    return replace(
        one,
        q=q[order],
        increase=increase[order],
        others=others[order],
        lower=min((one.lower, other.lower), key=lambda side: -math.inf if side.crossing is None else side.crossing),
        upper=max((one.upper, other.upper), key=lambda side: math.inf if side.crossing is None else side.crossing),
        unconverged=one.unconverged + other.unconverged,
    )


class _Path:
    """The problem with one unknown held, compared with the optimum."""

    def __init__(
        self,
        problem: LeastSquares,
        q: Floats,
        index: int,
        noise_known: bool,
        systematic: float,
        max_evaluations: int | None,
        best: Floats | None,
    ) -> None:
        self.problem, self.index = problem, index
        self.left = self.budget = math.inf if max_evaluations is None else max_evaluations // 2
        residuals, jacobian = problem.linearised(q)
        lowest = (residuals, jacobian) if best is None or np.array_equal(best, q) else problem.linearised(best)
        noise = noise_of(*lowest, noise_known=noise_known, systematic=systematic)
        self.threshold = two_sided_quantile(noise.freedom) ** 2
        self.variance = noise.variance
        self.minimum = float(lowest[0] @ lowest[0])
        value = float(residuals @ residuals)
        others = np.delete(jacobian, index, axis=1)
        slope = -np.asarray(np.linalg.lstsq(others, jacobian[:, index], rcond=1e-8)[0], dtype=np.float64)
        increase, root = self._increase(value), self._root(value)
        self.start = _Held(float(q[index]), np.delete(q, index), slope, increase, root, True)
        alone = float(np.linalg.norm(jacobian[:, index] + others @ slope))
        # Distance at which the quadratic approximation crosses the threshold.
        self.distance = math.sqrt(noise.deviation**2 * self.threshold) / alone if alone > 0 else math.inf

    def branch(self, bound: float) -> tuple[list[_Held], Side]:
        """Step from the optimum towards a bound, until the threshold is crossed."""
        sign = 1.0 if bound > self.start.q else -1.0
        box = float(self.problem.upper[self.index] - self.problem.lower[self.index])
        here, points, self.left = self.start, list[_Held](), self.budget
        length = min(_AIMS[0] * self.distance, _MAX_STEP * box)
        while abs(bound - here.q) > 1e-9 * box:
            if len(points) == _MAX_STEPS or self.left <= 0:
                return points, Side(None, TOO_MANY)
            # The step is halved where the model has no answer.
            lengths = (min(length, abs(bound - here.q)) / 2**halving for halving in range(_HALVINGS + 1))
            ahead = next((held for step in lengths if (held := self._held(here, here.q + sign * step))), None)
            if ahead is None:
                return points, Side(None, "the model has no answer beyond")
            points.append(ahead)
            if ahead.root >= 1:
                return self._crossed(points, here, ahead)
            done = abs(ahead.q - here.q)
            rise = (ahead.root - here.root) / done
            aim = _AIMS[0] if ahead.root < _FIRST_AIM_UNTIL else _AIMS[1]
            length = min((aim - ahead.root) / rise if rise > 0 else math.inf, _GROWTH * done, _MAX_STEP * box)
            here = ahead
        return points, Side(None, "reaches the bound")

    def _crossed(self, points: list[_Held], inside: _Held, outside: _Held) -> tuple[list[_Held], Side]:
        """Find where the root of the increase is that of the threshold, by Brent's method."""
        near = [inside, outside]

        def excess(q: float) -> float:
            nearest = min(near, key=lambda held: abs(held.q - q))
            if nearest.q != q:
                held = self._held(nearest, q) if self.left > 0 else None
                if held is None:
                    # A zero ends Brent's search; the present bracket is used.
                    return 0.0
                near.append(held)
                nearest = held
            return 0.0 if abs(nearest.root - 1) <= _ACCURACY else nearest.root - 1

        brentq(excess, inside.q, outside.q, maxiter=_MAX_STEPS, disp=False)
        inside = max((held for held in near if held.root < 1), key=lambda held: held.root)
        outside = min((held for held in near if held.root >= 1), key=lambda held: held.root)
        crossing = inside.q + (1 - inside.root) / (outside.root - inside.root) * (outside.q - inside.q)
        others = Fixed(self.problem, self.index, outside.q)
        stuck = on_bound(others, outside.others) & ~on_bound(others, self.start.others)
        names = tuple(name for name, held_back in zip(others.names, stuck, strict=True) if held_back)
        certain = self.budget == math.inf or outside.converged
        return points + near[2:], Side(crossing, "crosses", names, certain)

    def _held(self, near: _Held, q: float) -> _Held | None:
        """Best fit with the unknown at q, started from a neighbour along the path; None where there is no answer."""
        low, high = self.problem.lower[self.index], self.problem.upper[self.index]
        fixed = Fixed(self.problem, self.index, float(np.clip(q, low, high)))
        ahead = np.clip(near.others + near.slope * (fixed.at - near.q), fixed.lower, fixed.upper)
        for start in (ahead, near.others):
            found = self._optimised(fixed, start)
            if found is not None:
                others, value, converged = found
                slope = (others - near.others) / (fixed.at - near.q)
                return _Held(fixed.at, others, slope, self._increase(value), self._root(value), converged)
        return None

    def _increase(self, value: float) -> float:
        return (value - self.minimum) / self.variance

    def _root(self, value: float) -> float:
        increase = self._increase(value)
        return math.copysign(math.sqrt(abs(increase) / self.threshold), increase)

    def _optimised(self, fixed: Fixed, start: Floats) -> tuple[Floats, float, bool] | None:
        """The other unknowns optimised, twice the loss, and whether it is certain; None without an answer at start."""
        if not start.size or self.budget < math.inf:
            residuals = fixed.residuals(start)
            self.left -= 1
            if not np.isfinite(residuals).all():
                return None
            value = float(residuals @ residuals)
            # Along an undetermined direction a point that fits well is not re-optimised.
            if not start.size or abs(self._root(value)) < _SUFFICIENT:
                return start, value, True
        if not np.isfinite(fixed.linearised(start)[1]).all() or not np.isfinite(fixed.residuals(start)).all():
            self.left -= 1
            return None
        allowed = int(max(min(self.left, _MAX_EVALUATIONS), 1))
        gain = _GAIN * self.threshold * self.variance
        found = minimise(fixed, start, gain=gain, max_evaluations=allowed)
        self.left -= found.evaluations
        # A search that got stuck is good enough where even the predicted decrease leaves it beyond the threshold.
        predicted = 2 * found.value * max(1 - found.offset**2 / found.residuals.size, 0.0)
        return found.q, 2 * found.value, found.converged or self._root(predicted) >= 1


Word = Literal["identified", "poorly determined", "one-sided", "not identified", "at a bound"]


@dataclass(frozen=True)
class ParameterVerdict:
    """Verdict on one unknown, in q."""

    name: str
    # ``"identified"``: the 95 % interval ends on both sides, within the bounds, and its ends differ by less than a
    # factor of two (`is_identified`). ``"poorly determined"``: they differ by more. ``"one-sided"``: it ends on one
    # side. ``"not identified"``: it ends on no side, or says next to nothing: a standard error of more than a factor e.
    # ``"at a bound"``: the best value lies on a bound and the data pull it further: the bound or the model is wrong.
    word: Word
    value: float | None  # The best q; None where a number would mislead: not identified, or one-sided
    best: float  # The q of the best fit, identified or not
    standard_error: float | None  # Of q from the Fisher information; None with the value
    # Ends of the 95 % interval of q; None where it has no end within the bounds. The probability that q lies beyond a
    # single end is at most 5 %.
    lower: float | None
    upper: float | None
    reason: str  # One sentence why; empty for an identified unknown


def verdicts(
    problem: LeastSquares,
    optimum: Optimum,
    known: Information,
    profiles: Sequence[Profile] | None = None,
) -> tuple[ParameterVerdict, ...]:
    """Judge every unknown, by its profile or by the curvature alone."""
    if not optimum.converged:
        reason = "the fit did not converge, so that its last values have no meaning"
        last = zip(known.names, optimum.q.tolist(), strict=False)
        return tuple(ParameterVerdict(name, "not identified", None, q, None, None, None, reason) for name, q in last)
    scores = _score_statistics(optimum, known)
    found = []
    for k in range(len(known.names)):
        one = profiles[k] if profiles else None
        pulled = bool(optimum.at_bound[k]) and scores[k] > known.quantile
        verdict = _verdict(k, float(optimum.q[k]), _ends(k, problem, optimum, known, one), known, pulled=pulled)
        sides = () if one is None else (one.lower, one.upper)
        if verdict.word != "identified" and any(not side.certain or side.flag == TOO_MANY for side in sides):
            cut_short = "; its profile was not followed to its end, which would have taken too long"
            verdict = replace(verdict, reason=verdict.reason + cut_short)
        found.append(verdict)
    return tuple(found)


def _ends(
    k: int, problem: LeastSquares, optimum: Optimum, known: Information, one: Profile | None
) -> tuple[float | None, float | None]:
    """Ends of the 95 % interval within the bounds."""
    if one is not None:
        # For an undetermined unknown, not those that bounds of other unknowns or the limit on evaluations cause.
        sides = [(side, side.certain and not side.held_back) for side in (one.lower, one.upper)]
        low, high = (side.crossing if sure or known.identified[k] else None for side, sure in sides)
        return low, high
    half = known.quantile * float(known.standard_errors[k]) if known.identified[k] else math.inf
    lower, upper = float(optimum.q[k]) - half, float(optimum.q[k]) + half
    return (lower if lower > problem.lower[k] else None), (upper if upper < problem.upper[k] else None)


def _verdict(
    k: int, best: float, ends: tuple[float | None, float | None], known: Information, *, pulled: bool
) -> ParameterVerdict:
    name, (lower, upper) = known.names[k], ends
    texts = [one.text for one in known.combinations if name in one.names]
    combined = f"; what is identified is {', '.join(texts)}" if texts else ""
    if pulled:
        reason = "the best value lies on a bound, and the data pull it further: widen the bound, or doubt the model"
        return ParameterVerdict(name, "at a bound", best, best, None, lower, upper, reason)
    if lower is None and upper is None:
        reason = "every value between the bounds fits the data about equally well" + combined
        return ParameterVerdict(name, "not identified", None, best, None, None, None, reason)
    if lower is None or upper is None:
        reason = f"the data determine only its {'upper' if lower is None else 'lower'} limit" + combined
        return ParameterVerdict(name, "one-sided", None, best, None, lower, upper, reason)
    if upper - lower > 2 * known.quantile * MAX_ERROR:
        reason = "its 95 % interval is wider than that of a standard error of a factor e" + combined
        return ParameterVerdict(name, "not identified", None, best, None, lower, upper, reason)
    # Where the curvature at the optimum does not identify the unknown, the profile gives the standard error.
    error = float(known.standard_errors[k]) if known.identified[k] else 0.5 * (upper - lower) / known.quantile
    return judged(ParameterVerdict(name, "identified", best, best, error, lower, upper, ""), known.logarithmic[k])


def judged(verdict: ParameterVerdict, logarithmic: bool) -> ParameterVerdict:
    """The verdict on an unknown that is known on both sides, once its interval is: identified, or poorly determined."""
    low, high = verdict.lower, verdict.upper
    if verdict.word != "identified" or low is None or high is None or is_identified(low, high, logarithmic=logarithmic):
        return verdict
    reason = f"its 95 % interval {span_text(low, high, logarithmic=logarithmic)}"
    return replace(verdict, word="poorly determined", reason=reason)


def _score_statistics(optimum: Optimum, known: Information) -> Floats:
    """Score statistic of each unknown, shape (k,): residuals along its column, the free others projected out.

    It is near zero where the optimum lies inside the box, and large where a bound holds the unknown back (Rao 1948).
    """
    others = optimum.jacobian[:, ~optimum.at_bound]
    scores = np.zeros(optimum.q.size)
    for k in np.flatnonzero(optimum.at_bound):
        column = optimum.jacobian[:, k]
        alone = column - others @ np.linalg.lstsq(others, column, rcond=1e-8)[0]
        length = float(np.linalg.norm(alone))
        # Where the data hardly depend on the unknown, the score is that of a single datum, and is ignored.
        if length * MAX_ERROR > known.noise:
            scores[k] = abs(float(alone @ optimum.residuals)) / (length * known.noise)
    return scores


MAX_RESTARTS = 2
"""Largest number of restarts from a better optimum that a profile has found."""

# Where directions are undetermined, a profile may take as many evaluations as all starts together, and at least these.
_MIN_EVALUATIONS = 40


class Judged(LeastSquares, Protocol):
    """A problem with the properties of its noise and of its unknowns."""

    @property
    def noise_known(self) -> bool:
        """Whether the residuals are in standard errors that are stated with the data."""

    @property
    def logarithmic(self) -> tuple[bool, ...]:
        """Which unknowns are logarithms."""

    @property
    def systematic(self) -> float:
        """Degrees of freedom that systematic errors take from the readings, as :func:`noise_of` counts them."""


@dataclass(frozen=True, eq=False)
class Inference:
    """Information, profiles and verdicts at the best optimum."""

    starts: MultiStartResult  # All starts, with better optima that profiles found in front
    information: Information  # At the best optimum
    profiles: tuple[Profile, ...]  # From there; empty if they were not requested
    verdicts: tuple[ParameterVerdict, ...]
    restarts: int  # Number of better optima that profiles found
    alternatives: int = 0  # Number of former optima nearly as good, from which profiles were followed too
    late: bool = False  # Whether the time limit passed before all profiles


def information_at(problem: Judged, best: Optimum) -> Information:
    """Information of the unknowns at an optimum."""
    return information(
        problem.names,
        best.q,
        best.residuals,
        best.jacobian,
        (problem.lower, problem.upper),
        noise_known=problem.noise_known,
        logarithmic=problem.logarithmic,
        systematic=problem.systematic,
    )


def infer(
    problem: Judged,
    starts: MultiStartResult,
    *,
    profiles: bool = True,
    method: Method = "least-squares",
    gain: float | None = None,
    on_progress: Callable[[int, int], None] = lambda done, total: None,
) -> Inference:
    """Judge the best of several optima, or a better one that its profiles find.

    Former optima that are nearly as good have profiles too: intervals reach over all of them.
    """
    former, restarts = list[Optimum](), 0
    how: dict[str, Any] = {"method": method, "gain": gain}
    while True:
        best = starts.best
        known = information_at(problem, best)
        allowed, traced, better, also = None, list[Profile](), None, list[Optimum]()
        if not (known.determined.all() and known.identified.all()):
            allowed = max(_MIN_EVALUATIONS, sum(result.optimum.evaluations for result in starts.results))
        try:
            if profiles and best.converged:
                of_profiles = (how, allowed, on_progress, restarts < MAX_RESTARTS)
                traced, better = _traced(problem, starts, best, *of_profiles)
                also = [] if better else _nearly_as_good(former, best, known, traced)
                for other in also:
                    more, better = _traced(problem, starts, other, *of_profiles)
                    if better is not None:
                        break
                    traced = [_joined(one, another) for one, another in zip(traced, more, strict=True)]
        except TimeLimitError:
            return Inference(starts, known, (), verdicts(problem, best, known), restarts, late=True)
        if better is None:
            judged = verdicts(problem, best, known, traced or None)
            return Inference(starts, known, tuple(traced), judged, restarts, len(also))
        former, starts, restarts = [best, *former], better, restarts + 1


def _traced(
    problem: Judged,
    starts: MultiStartResult,
    optimum: Optimum,
    how: Mapping[str, Any],
    max_evaluations: int | None,
    on_progress: Callable[[int, int], None],
    may_restart: bool,
) -> tuple[list[Profile], MultiStartResult | None]:
    """Profiles through an optimum; up to one that finds a better optimum than the best, if the fit may restart."""
    found = list[Profile]()
    for k in range(len(problem.names)):
        on_progress(k, len(problem.names))
        found.append(
            profile(
                problem,
                optimum.q,
                k,
                noise_known=problem.noise_known,
                systematic=problem.systematic,
                max_evaluations=max_evaluations,
                best=starts.best.q,
            )
        )
        better = _improved(problem, starts, found[-1], how) if may_restart else None
        if better is not None:
            return found, better
    return found, None


def _nearly_as_good(
    former: Sequence[Optimum], best: Optimum, known: Information, traced: Sequence[Profile]
) -> list[Optimum]:
    """Former optima that are within the 95 % threshold of the best, and beyond an interval of its profiles."""

    def is_beyond(q: float, one: Profile) -> bool:
        low, high = one.lower.crossing, one.upper.crossing
        return (low is not None and q < low) or (high is not None and q > high)

    allowed = best.value + 0.5 * known.quantile**2 * known.spread.variance
    near = [one for one in former if one.value < allowed]
    return [one for one in near if any(is_beyond(float(q), each) for q, each in zip(one.q, traced, strict=False))]


def _improved(
    problem: Judged, starts: MultiStartResult, traced: Profile, how: Mapping[str, Any]
) -> MultiStartResult | None:
    """Put the better optimum that a profile found in front of the others; None if there is none."""
    if traced.better is None:
        return None
    start: Floats = np.clip(traced.better, problem.lower, problem.upper)
    found = multi_start(problem, [start], **how).best
    if not found.converged or found.value >= starts.best.value:
        return None
    near = SAME_FIT * float(np.sqrt(np.mean(found.residuals**2)))
    same = float(np.linalg.norm(found.residuals - starts.best.residuals)) < near
    others = (replace(result, cluster=result.cluster + (not same)) for result in starts.results)
    return MultiStartResult((StartResult(start, found, 0), *others), starts.rejected)
