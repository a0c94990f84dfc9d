"""What a fit of three constants to 200 points costs, beside SciPy's `least_squares` around SciPy's Radau.

``python -m pytest -m slow -s tests/slow/test_fit_speed.py`` prints the table.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.fitting.least_squares import minimise
from softcat_sym.fitting.problem import FilamentProblem
from softcat_sym.single_run import build
from tests.common.fitting import CONSTANTS, WRONG, Floats, beside, film, timed
from tests.common.radau_fit import RadauFit, Tolerances
from tests.common.table import show

SEEDS = (0, 1, 2)

# Of those tried, "lm" and "trf", rtol in 1e-2, 3e-3, 1e-3, 3e-4, differences of 3e-2 and 1e-2, gains of 1e-2 and 1e-3:
# the cheapest whose sums of squares are within 0.01 of the least ones (a tenth of a standard error), and one within
# 0.001. Ours come within 2e-5 by themselves.
RIVALS = {
    "SciPy, to a tenth of a standard error": ("lm", Tolerances(3e-3, 3e-5, 3e-2, 1e-3)),
    "SciPy, to a thirtieth": ("lm", Tolerances(3e-4, 3e-6, 3e-2, 1e-3)),
}
LOOSE, CLOSE = 1e-2, 1e-3

# What is asserted leaves room for a machine that others use; the goals are in the docstring.
SECONDS, TIMES = 1.0, 6.0
HEADER = ("", "ms", "ms of processor", "times ours", "evaluations", "sums of squares", "above the least")

Fitted = tuple[Floats, int]


@pytest.mark.slow
def test_three_constants_from_two_hundred_points() -> None:
    """Goals: under 1 s after compiling, 20 times faster than the rival, at no worse optimum; three films.

    Measured: 0.3 s, and 13 times, 11 if the rival need not be as exact: 20 is missed. A run of ours costs a fifteenth
    of one of the rival's, but derivatives by neighbours on both sides cost ours two to four more at each point (two
    cores or one), and its rtol is a tenth of the rival's where that is loose.

    Both have the same scheme on the same 40 cells, the same data, start and unknowns. Sums of squares are all of one
    model, ours with a relative tolerance of 1e-7.
    """
    truth = sc.load_scene("continual-descent", {"run.effects": "paper", "numerics.cells": 40})
    start = beside(truth, WRONG)
    prepared = build(start, choose_effects(start))
    spent: dict[str, list[list[float]]] = {}
    for seed in SEEDS:
        data = film(truth, 200, 0.01, seed)
        tight = FilamentProblem(start, data, CONSTANTS, rtol=1e-7)
        sides = {"ours": _ours(FilamentProblem(start, data, CONSTANTS))} | _rivals(
            RadauFit(prepared, data.series[0], CONSTANTS)
        )
        found = {title: timed(side) for title, side in sides.items()}
        least = 2 * minimise(tight, found["ours"][0][0]).value
        for title, ((q, count), time) in found.items():
            squares = float(np.sum(tight.residuals(q) ** 2))
            spent.setdefault(title, []).append([time.wall, time.processor, count, squares, squares - least])
    # By the clock: ours spreads its derivatives over the cores.
    base = sum(one[0] for one in spent["ours"])
    rows, times = [], {}
    for title, films in spent.items():
        wall, processor, _, _, _ = np.mean(films, axis=0) * 1e3
        times[title] = sum(one[0] for one in films) / base
        counts, squares = (", ".join(f"{one[k]:.{digits}f}" for one in films) for k, digits in ((2, 0), (3, 3)))
        above = ", ".join(f"{one[4]:.0e}" for one in films)
        rows.append([title, f"{wall:.0f}", f"{processor:.0f}", f"{times[title]:.1f}", counts, squares, above])
    show(f"continual-descent, paper's physics, N = 40, 200 points, 1 % noise; means of films {SEEDS}", HEADER, rows)
    worst = {title: max(one[4] for one in films) for title, films in spent.items()}
    loose, close = RIVALS
    assert worst["ours"] < min(worst[loose], worst[close], CLOSE)
    assert worst[loose] < LOOSE
    assert worst[close] < CLOSE
    assert base / len(SEEDS) < SECONDS
    assert times[close] > TIMES


def _ours(problem: FilamentProblem) -> Callable[[], Fitted]:
    # Compiled, and the limit of steps known, before the clock starts; evaluated elsewhere, so that nothing is kept.
    problem.linearised(problem.typical + 0.01)

    def fit() -> Fitted:
        found = minimise(problem, problem.typical)
        assert found.converged
        return found.q, found.evaluations

    return fit


def _rivals(rival: RadauFit) -> dict[str, Callable[[], Fitted]]:
    def fit(method: str, tolerances: Tolerances) -> Fitted:
        found = rival.fit(np.zeros(len(CONSTANTS)), tolerances, method)
        return found.q, found.runs

    return {title: lambda how=how: fit(*how) for title, how in RIVALS.items()}  # type: ignore[misc]
