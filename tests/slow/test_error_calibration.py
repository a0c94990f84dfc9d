"""Estimated errors are the true ones within a factor of three, and what is called accurate is: some scenes and inks.

What ends by its modes of vibration ends where the integrated run does.

True errors are those against twice the cells and fibres and a tenth of the tolerance. ``python -m
tests.studies.error_calibration`` looks at 140 scenes.
"""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.error_control.control import frames_of_first
from softcat_sym.error_control.estimate import Judge
from softcat_sym.results.fields import midpoint_heights
from softcat_sym.results.observed import DISPLACEMENT, Series, Watched
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence
from tests.common.table import show
from tests.common.true_error import true_error
from tests.studies.error_calibration import LEAST, MOST, NOTHING, users_inks

pytestmark = pytest.mark.slow

NAMES = ("cold-honey", "gelatin-strand", "no-yield", "curled-rod")
INKS = 3


@pytest.mark.parametrize("which", [*NAMES, *range(INKS)])
def test_estimates_are_right_within_a_factor_of_three(which: str | int) -> None:
    name, scene = (which, sc.load_scene(which)) if isinstance(which, str) else users_inks(INKS)[which]
    run = sc.simulate(scene)
    assert run.outcome.is_success
    total, accuracy = run.summary["error_estimate"]["total"], scene.run.accuracy
    true, why_not = true_error(scene, run)
    show(name, ("accuracy", "estimate", "true"), [[f"{accuracy:g}", f"{total:.1e}", f"{true:.1e}"]])
    assert not why_not and true <= 1.5 * accuracy
    nothing = NOTHING * accuracy
    assert LEAST <= true / total <= MOST or max(true, total) < nothing


@pytest.mark.parametrize("number", [3, 7])
def test_modes_end_where_the_integrated_run_does(number: int) -> None:
    """A ceramic and a gel that never yield, and a chocolate that grazes its yield surface for fifty periods."""
    name, scene = users_inks()[number - 1]
    effects = choose_effects(scene)
    scene = scene.replace({"numerics.cells": 20, "run.frames": frames_of_first(scene, effects)})
    heights, steps = dict[str, Series](), dict[str, int]()
    for tail in ("integrate", "auto"):
        prepared = build(scene.replace({"numerics.tail": tail}), effects)
        solution = prepared.solve(Silence())
        assert (solution.tail_from is not None) == (tail == "auto")
        heights[tail], steps[tail] = {DISPLACEMENT: midpoint_heights(prepared.graph, solution)[:, None]}, solution.steps
    largest = float(np.max(np.abs(heights["integrate"][DISPLACEMENT])))
    watched, period = Watched({DISPLACEMENT: 0.0}, {DISPLACEMENT: largest}), prepared.settings.lasting
    assert period is not None
    judge = Judge.of(heights["integrate"], watched, scene.run.duration / period, scene.run.accuracy)
    apart = judge.between(*heights.values())
    show(
        name,
        ("apart", "phase", "error told", "steps", "of"),
        [
            [
                f"{apart.size:.1e}",
                f"{apart.phase:.2g}",
                f"{solution.tail_error:.1e}",
                str(steps["auto"]),
                str(steps["integrate"]),
            ]
        ],
    )
    assert apart.size < scene.run.accuracy / 10
    assert steps["auto"] < steps["integrate"] / 5
