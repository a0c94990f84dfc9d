"""What a fit may say of each unknown: identified, one-sided, not identified, or at a bound; and its interval."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from softcat_sym.inverse.estimation.fisher import LARGEST_ERROR, Information
from softcat_sym.inverse.estimation.least_squares import LINEAR, Floats, LeastSquares, Loss
from softcat_sym.inverse.estimation.optimise import Optimum
from softcat_sym.inverse.estimation.profiles import TOO_MANY, Profile

Word = Literal["identified", "one-sided", "not identified", "at a bound"]


@dataclass(frozen=True)
class Verdict:
    """What is known of one unknown, in q.

    Attributes
    ----------
    name : str
        The unknown.
    word : str
        ``"identified"``: the 95 % interval ends on both sides, within its own bounds and with less than a factor e for
        a standard error. ``"one-sided"``: it ends on one side. ``"not identified"``: it ends on no side, or says next
        to nothing. ``"at a bound"``: the best value lies on a bound and the data pull it beyond: the bound or the model
        is wrong.
    value : float or None
        The best q; None where a number would mislead: not identified, or one-sided.
    best : float
        The q of the best fit, whatever it is worth.
    standard_error : float or None
        Of q from the Fisher information; None unless identified.
    lower, upper : float or None
        Ends of the 95 % interval of q; None where it has no end within the bounds. A single end is exceeded with a
        probability of at most 5 %.
    reason : str
        One sentence why; empty for an identified unknown.
    """

    name: str
    word: Word
    value: float | None
    best: float
    standard_error: float | None
    lower: float | None
    upper: float | None
    reason: str


def verdicts(
    problem: LeastSquares,
    optimum: Optimum,
    information: Information,
    profiles: Sequence[Profile] | None = None,
    loss: Loss = LINEAR,
) -> tuple[Verdict, ...]:
    """Judge every unknown.

    Parameters
    ----------
    problem : LeastSquares
        The problem.
    optimum : Optimum
        Its best fit.
    information : Information
        There.
    profiles : sequence of Profile or None
        Of the unknowns in their order; without them the intervals are those of the linear theory.
    loss : Loss
        What was minimised.

    Returns
    -------
    tuple of Verdict, length k
    """
    if not optimum.converged:
        reason = "the fit did not converge, so that nothing follows from where it ended"
        last = zip(information.names, optimum.q.tolist(), strict=True)
        return tuple(Verdict(name, "not identified", None, q, None, None, None, reason) for name, q in last)
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


def _as_far_as_followed(verdict: Verdict, profile: Profile) -> Verdict:
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
) -> Verdict:
    lower, upper = ends
    if pulled:
        reason = "the best value lies on a bound, and the data pull it further: widen the bound, or doubt the model"
        return Verdict(name, "at a bound", best, best, None, lower, upper, reason)
    if lower is None and upper is None:
        reason = "every value between the bounds fits the data about equally well" + _in_combination(name, information)
        return Verdict(name, "not identified", None, best, None, None, None, reason)
    if lower is None or upper is None:
        side = "largest" if lower is None else "least"
        reason = f"the data tell only the {side} possible value" + _in_combination(name, information)
        return Verdict(name, "one-sided", None, best, None, lower, upper, reason)
    if upper - lower > 2 * information.quantile * LARGEST_ERROR:
        reason = "its 95 % interval is wider than a standard error of a factor e would make it"
        return Verdict(
            name, "not identified", None, best, None, lower, upper, reason + _in_combination(name, information)
        )
    # The profile knows better than the curvature at the optimum, if it closes where that does not.
    known = error if information.identified[index] else 0.5 * (upper - lower) / information.quantile
    return Verdict(name, "identified", best, best, known, lower, upper, "")


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
        if length * LARGEST_ERROR > information.noise:
            pulls[k] = abs(float(alone @ charged)) / (length * information.spread.score)
    return pulls
