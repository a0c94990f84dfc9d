"""Many starts of one least-squares problem, and the waterfall of the optima that they end in."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.inverse.estimation.least_squares import LINEAR, Floats, LeastSquares, Loss, has_answer
from softcat_sym.inverse.estimation.optimise import Optimum, check_in_box, minimise

# Two fits whose residuals differ by less than this share of a standard deviation are one fit.
_SAME = 0.1
# Of the residuals of the starts: less is rounding.
_ROUNDING = 1e-6


@dataclass(frozen=True, eq=False)
class Fall:
    """Where one start ended.

    Attributes
    ----------
    start : ndarray, shape (k,)
        Where it started.
    optimum : Optimum
        Where it ended.
    cluster : int
        Which fit that is, 0 the best: starts that end in the same curve through the data share it, even where their
        unknowns differ because the data do not determine them.
    """

    start: Floats
    optimum: Optimum
    cluster: int


@dataclass(frozen=True, eq=False)
class Waterfall:
    """All starts, the best first.

    Attributes
    ----------
    falls : tuple of Fall
        Sorted by value, those that converged first.
    rejected : int
        Starts at which the model has no answer.
    """

    falls: tuple[Fall, ...]
    rejected: int

    @property
    def best(self) -> Optimum:
        """The least optimum."""
        return self.falls[0].optimum

    @property
    def values(self) -> Floats:
        """Values of the optima, shape (starts,), in the order of `falls`."""
        return np.array([fall.optimum.value for fall in self.falls])

    @property
    def reached_best(self) -> int:
        """How many starts end in the best fit: one of many is a warning."""
        return sum(fall.cluster == 0 for fall in self.falls)

    def spread(self, cluster: int = 0) -> Floats:
        """Largest difference of each unknown within a cluster, shape (k,): large where the data do not determine it."""
        spread: Floats = np.ptp([fall.optimum.q for fall in self.falls if fall.cluster == cluster], axis=0)
        return spread


_MOST_OF_DRAWN = 60
_NEARER = "bounds or starting values for which it can be solved"


def latin_hypercube(lower: Floats, upper: Floats, count: int, seed: int) -> Floats:
    """Points of which each unknown has one in each of `count` equal slices of its range (McKay et al. 1979).

    Parameters
    ----------
    lower, upper : ndarray, shape (k,)
        The box.
    count : int
        How many points.
    seed : int
        The same seed gives the same points.

    Returns
    -------
    ndarray, shape (count, k)
    """
    random = np.random.default_rng(seed)
    slices = np.stack([random.permutation(count) for _ in lower], axis=1)
    points: Floats = lower + (upper - lower) * (slices + random.random((count, lower.size))) / max(count, 1)
    return points


def multi_start(
    problem: LeastSquares,
    given: Sequence[Floats],
    *,
    count: int = 0,
    seed: int = 0,
    loss: Loss = LINEAR,
    max_evaluations: int = 300,
    told: Callable[[int, int], None] | None = None,
) -> Waterfall:
    """Minimise from the given starts and from a Latin hypercube of the box.

    Parameters
    ----------
    problem : LeastSquares
        The problem.
    given : sequence of ndarray, shape (k,)
        Starts that are tried first, such as closed forms.
    count : int
        How many further starts.
    seed : int
        Of the hypercube.
    loss : Loss
        What residuals are charged.
    max_evaluations : int
        Of the model, for each start; for one of the hypercube, which may lie decades away, 60 at the most.
    told : callable, optional
        Told how many of how many starts are done.

    Raises
    ------
    SoftcatError
        If a given start lies outside the box, or the model has an answer at none of the starts.
    """
    drawn = latin_hypercube(problem.lower, problem.upper, count, seed)
    starts = [*(check_in_box(problem, one) for one in given), *drawn]
    ended, sizes = [], []
    for number, start in enumerate(starts):
        (told or _nobody)(number, len(starts))
        if not has_answer(problem, start):
            continue  # a hypercube has many corners that no filament survives
        sizes.append(float(np.linalg.norm(problem.residuals(start))))
        most = max_evaluations if number < len(given) else min(max_evaluations, _MOST_OF_DRAWN)
        ended.append((start, minimise(problem, start, loss=loss, max_evaluations=most)))
    if not ended:
        raise SoftcatError(f"the model has no answer at any of {len(starts)} starts; accepted: {_NEARER}")
    ended.sort(key=lambda one: (not one[1].converged, one[1].value))
    clusters = _clusters([one.residuals for _, one in ended], _ROUNDING * max(sizes))
    falls = (Fall(start, one, cluster) for (start, one), cluster in zip(ended, clusters, strict=True))
    return Waterfall(tuple(falls), len(starts) - len(ended))


def _nobody(done: int, total: int) -> None:
    """Tell nobody."""


def _clusters(residuals: Sequence[Floats], rounding: float) -> list[int]:
    """Number fits by the first one in the list that agrees with them."""
    near = max(_SAME * float(np.sqrt(np.mean(residuals[0] ** 2))), rounding)
    leaders: list[Floats] = []
    numbers = []
    for one in residuals:
        found = next((k for k, leader in enumerate(leaders) if np.linalg.norm(one - leader) < near), None)
        if found is None:
            found = len(leaders)
            leaders.append(one)
        numbers.append(found)
    return numbers
