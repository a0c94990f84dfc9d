"""Errors that are known are found, each in its own place."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from softcat_sym.discretization.grid import Floats
from softcat_sym.error_control.estimate import Before, Differences, Judge, differences, with_more_fibres
from softcat_sym.error_control.resolution import Resolution

from .known import FIRST, LINEAR, Known

ACCURACY = 1e-3


def test_each_error_is_found_in_its_place() -> None:
    for known in [Known(space=2.0), Known(time=3.0), Known(section=0.1), Known(space=2.0, time=3.0, section=0.1)]:
        answer = known(FIRST)
        assert answer is not None
        found = differences(answer, FIRST, known, Judge(answer, ()), ACCURACY)
        # Relative to the largest midpoint of the answer, which is itself off by no more than 1 %.
        assert (found.space, found.time, found.section) == pytest.approx(known.parts(FIRST), rel=1e-2, abs=1e-12)
        assert found.failed == ()


@pytest.mark.parametrize(("order", "least", "most"), [(1.0, 2.5, 3.5), (1.5, 1.4, 1.9), (3.0, 0.35, 0.5)])
def test_another_order_is_missed_by_a_known_factor(order: float, least: float, most: float) -> None:
    """True error over estimate, from 3/(2^p - 1): an estimate that supposes second order."""
    known = Known(space=2.0, order=order)
    answer = known(FIRST)
    assert answer is not None
    found = differences(answer, FIRST, known, Judge(answer, ()), ACCURACY)
    assert found.space is not None
    assert least < known.parts(FIRST)[0] / found.space < most


def test_what_steps_take_from_a_ringing_is_found_though_looser_ones_can_take_little_more() -> None:
    """Of a higher mode nearly all is lost in the end at this tolerance, and all of it at once at a looser one."""
    time = np.linspace(0.0, 1.0, 2001)
    asked = []

    def run(at: Resolution) -> Floats:
        asked.append(at)
        lost = 10 * (at.rtol / FIRST.rtol) ** 2
        return np.asarray(np.cos(400 * np.pi * time) - 1 + 0.03 * np.exp(-lost * time) * np.cos(2160 * np.pi * time))

    answer, exact = run(FIRST), run(replace(FIRST, rtol=1e-9))
    judge = Judge.of(answer, 200.0, ACCURACY)
    found = differences(answer, FIRST, run, judge, ACCURACY)
    assert found.time == pytest.approx(judge.between(answer, exact).size, rel=0.3)
    assert min(at.rtol for at in asked[2:]) > 0.1 * FIRST.rtol


def test_what_has_nothing_to_resolve_is_not_run() -> None:
    known = Known(space=2.0)
    answer = known(LINEAR)
    assert answer is not None
    found = differences(answer, LINEAR, known, Judge(answer, ()), ACCURACY)
    assert found.section is None
    assert len(known.asked) == 3


def test_a_companion_without_an_answer_is_told() -> None:
    known = Known(space=2.0, fails_below=30)
    answer = known(FIRST)
    assert answer is not None
    found = differences(answer, FIRST, known, Judge(answer, ()), ACCURACY)
    assert (found.space, found.failed) == (None, ("20 cells",))


def test_companions_lie_on_one_map() -> None:
    known = Known(space=2.0)
    answer = known(FIRST)
    assert answer is not None
    differences(answer, FIRST, known, Judge(answer, ()), ACCURACY)
    assert {one.grading for one in known.asked} == {FIRST.grading}


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (FIRST, replace(FIRST, fibres=12)),
        (replace(FIRST, fibres=None, order=2), replace(FIRST, fibres=None, order=3)),
        (LINEAR, LINEAR),
    ],
)
def test_more_fibres(before: Resolution, after: Resolution) -> None:
    assert with_more_fibres(before, 1.5) == after


def test_what_is_known_and_was_not_refined_is_not_run_again() -> None:
    """Of a finer grid and shorter steps only the grid is asked: the fibres are the same, the steps were good enough."""
    known = Known(space=2.0, time=1e-4, section=0.1)
    before = Before(FIRST, Differences(space=1e-2, time=1e-4 * FIRST.rtol, section=0.1 / 64, phase=None, failed=()))
    finer = replace(FIRST, cells=80, rtol=FIRST.rtol / 2)
    answer = known(finer)
    assert answer is not None
    known.asked.clear()
    found = differences(answer, finer, known, Judge(answer, ()), ACCURACY, before)
    assert known.asked == [replace(finer, cells=40)]
    assert (found.space, found.time, found.section) == pytest.approx(known.parts(finer), rel=1e-2)


def test_more_fibres_than_before_are_judged_by_those_before() -> None:
    """So that no library is compiled for a companion alone."""
    known = Known(space=2.0, section=0.1)
    before = Before(FIRST, Differences(space=1e-3, time=0.0, section=0.1 / 64, phase=None, failed=()))
    finer = replace(FIRST, fibres=12)
    answer = known(finer)
    assert answer is not None
    known.asked.clear()
    found = differences(answer, finer, known, Judge(answer, ()), ACCURACY, before)
    assert {one.fibres for one in known.asked} == {8, 12}
    assert found.section == pytest.approx(known.parts(finer)[2], rel=1e-2)


def test_steps_that_were_too_long_are_judged_again() -> None:
    known = Known(space=0.1, time=20.0)
    before = Before(FIRST, Differences(space=1e-4, time=20 * FIRST.rtol, section=0.0, phase=None, failed=()))
    tighter = replace(FIRST, rtol=FIRST.rtol / 8)
    answer = known(tighter)
    assert answer is not None
    known.asked.clear()
    differences(answer, tighter, known, Judge(answer, ()), ACCURACY, before)
    assert [one.rtol for one in known.asked] == [tighter.rtol, 8 * tighter.rtol]
