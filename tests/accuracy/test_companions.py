"""Errors that are known are found, each in its own place."""

from __future__ import annotations

from dataclasses import replace

import pytest

from softcat_sym.accuracy.companions import differences, with_more_fibres
from softcat_sym.accuracy.resolution import Resolution

from .known import FIRST, LINEAR, Known


@pytest.mark.parametrize(
    "known",
    [Known(space=2.0), Known(time=3.0), Known(section=0.1), Known(space=2.0, time=3.0, section=0.1)],
    ids=["space", "time", "section", "all"],
)
def test_each_error_is_found_in_its_place(known: Known) -> None:
    answer = known(FIRST)
    assert answer is not None
    found = differences(answer, FIRST, known)
    # Relative to the largest midpoint of the answer, which is itself off by no more than 1 %.
    assert (found.space, found.time, found.section) == pytest.approx(known.parts(FIRST), rel=1e-2, abs=1e-12)
    assert found.failed == ()


@pytest.mark.parametrize(("order", "least", "most"), [(1.0, 2.5, 3.5), (1.5, 1.4, 1.9), (3.0, 0.35, 0.5)])
def test_another_order_is_missed_by_a_known_factor(order: float, least: float, most: float) -> None:
    """True error over estimate, from 3/(2^p - 1): an estimate that supposes second order."""
    known = Known(space=2.0, order=order)
    answer = known(FIRST)
    assert answer is not None
    found = differences(answer, FIRST, known)
    assert found.space is not None
    assert least < known.parts(FIRST)[0] / found.space < most


def test_what_has_nothing_to_resolve_is_not_run() -> None:
    known = Known(space=2.0)
    answer = known(LINEAR)
    assert answer is not None
    found = differences(answer, LINEAR, known)
    assert found.section is None
    assert len(known.asked) == 3


def test_a_companion_without_an_answer_is_told() -> None:
    known = Known(space=2.0, fails_below=30)
    answer = known(FIRST)
    assert answer is not None
    found = differences(answer, FIRST, known)
    assert (found.space, found.failed) == (None, ("20 cells",))


def test_companions_lie_on_one_map() -> None:
    known = Known(space=2.0)
    answer = known(FIRST)
    assert answer is not None
    differences(answer, FIRST, known)
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
