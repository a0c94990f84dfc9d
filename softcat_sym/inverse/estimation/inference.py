"""What data tell at an optimum: information, profiles, verdicts; begun again from a better optimum met on the way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from softcat_sym.inverse.estimation.fisher import Information, information
from softcat_sym.inverse.estimation.least_squares import Floats, LeastSquares, Loss
from softcat_sym.inverse.estimation.multi_start import Fall, Waterfall, multi_start
from softcat_sym.inverse.estimation.optimise import Optimum
from softcat_sym.inverse.estimation.profiles import Profile, profile
from softcat_sym.inverse.estimation.verdicts import Verdict, verdicts

MOST_RESTARTS = 2
"""Better optima that are followed; beyond them the waterfall tells how rugged the problem is."""

# Where directions are undetermined: a profile may take as many evaluations as the starts did together, at least these.
_FEWEST_EVALUATIONS = 100

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
    """What is known of the unknowns.

    Attributes
    ----------
    starts : Waterfall
        As it was, or with the better optima in front.
    information : Information
        At the best of them.
    profiles : tuple of Profile
        From there; empty if they were not asked for.
    verdicts : tuple of Verdict
        On every unknown.
    restarts : int
        How many better optima the profiles led to.
    """

    starts: Waterfall
    information: Information
    profiles: tuple[Profile, ...]
    verdicts: tuple[Verdict, ...]
    restarts: int


def infer(
    problem: Judged,
    starts: Waterfall,
    loss: Loss,
    *,
    profiles: bool = True,
    told: Callable[[int, int], None] = lambda done, total: None,
) -> Inference:
    """Judge the best of several optima, and whichever better one its profiles come upon.

    Parameters
    ----------
    problem : Judged
        What was minimised.
    starts : Waterfall
        With this loss.
    loss : Loss
        What was minimised, and what profiles minimise.
    profiles : bool
        Whether intervals come from profiles; otherwise from the curvature.
    told : callable
        Hears of each profile: how many are done, of how many.

    Raises
    ------
    SoftcatError
        If the noise has to be estimated and there are no more data than unknowns.
    """
    restarts = 0
    while True:
        best = starts.best
        known = _information(problem, best, loss)
        most, traced = _most(starts, known), list[Profile]()
        for k in range(len(problem.names) if profiles and best.converged else 0):
            told(k, len(problem.names))
            traced.append(profile(problem, best.q, k, noise_known=problem.noise_known, loss=loss, most=most))
        better = _improved(problem, starts, traced, loss) if restarts < MOST_RESTARTS else None
        if better is None:
            judged = verdicts(problem, best, known, traced or None, loss)
            return Inference(starts, known, tuple(traced), judged, restarts)
        starts, restarts = better, restarts + 1


def _most(starts: Waterfall, known: Information) -> int | None:
    """Evaluations for a profile; no limit where every direction and unknown is determined, where few are needed."""
    if known.determined.all() and known.identified.all():
        return None
    return max(_FEWEST_EVALUATIONS, sum(fall.optimum.evaluations for fall in starts.falls))


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
