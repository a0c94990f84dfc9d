"""Whole scenes drawn at random: every answer is right as far as invariants can tell, or an honest refusal.

The ranges stand in ``scene_strategies.py`` and were fixed, like the seeds, before any scene was run.
"""

from __future__ import annotations

import itertools
import json
from collections import Counter
from dataclasses import asdict, replace
from typing import Any

import pytest
from hypothesis import HealthCheck, Phase, given, seed, settings

from tests.acceptance.kept_answers import fingerprint, kept
from tests.acceptance.table import show
from tests.limited_process import Ask, side_by_side

from .limited import answer_within, is_late, serve
from .scene_runs import REFUSED, Answer
from .scene_strategies import scenes

SEED = 20261121
FEW, MANY = 20, 2000
LIMIT, PATIENCE = 60.0, 300.0  # s of the processor, for one scene, and for one that is asked once more
DEAR = "dear"

UNANSWERED = 0.05
"""Share of scenes that may be refused or end without success."""


def drawn(number: int, quick: bool) -> list[dict[str, Any]]:
    """Raw scenes, always the same: drawn first, so that they can be run side by side.

    From the eleventh example on, Hypothesis mostly varies what it has drawn; a fresh seed for every ten keeps the
    scenes independent. The first of each seed is the same simplest scene.
    """
    tables: list[dict[str, Any]] = []
    for one in itertools.count(SEED):
        tables += _ten(one, quick)[1 if tables else 0 :]
        if len(tables) >= number:
            return tables[:number]
    raise AssertionError


def _ten(one: int, quick: bool) -> list[dict[str, Any]]:
    tables: list[dict[str, Any]] = []

    @seed(one)
    @settings(
        max_examples=10,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(scenes(quick))
    def draw(table: dict[str, Any]) -> None:
        tables.append(table)

    draw()
    return tables


class NoAnswerError(Exception):
    """A run that hung or died: perhaps for want of memory or time, so that its answer is not kept."""

    def __init__(self, answer: Answer) -> None:
        self.answer = answer


def ended(ask: Ask, table: dict[str, Any], limit: float) -> dict[str, Any]:
    """Answer as a table; raises NoAnswerError."""
    found = answer_within(ask, table, limit)
    if not found.outcome:
        raise NoAnswerError(found)
    return asdict(found)


def answers(tables: list[dict[str, Any]]) -> list[Answer]:
    """Answer every scene; what an interrupted check has found is kept."""
    found = _all(tables, LIMIT)
    late = [k for k, answer in enumerate(found) if is_late(answer)]
    for k, answer in zip(late, _all([compiled(tables[k]) for k in late], PATIENCE), strict=True):
        found[k] = answer
    late = [k for k in late if is_late(found[k])]
    for k, answer in zip(late, _all([unestimated(tables[k]) for k in late], PATIENCE), strict=True):
        found[k] = dear(answer) if answer.outcome == "solved" else answer
    return found


def _all(tables: list[dict[str, Any]], limit: float) -> list[Answer]:
    sources = fingerprint(__file__)

    def one(ask: Ask, table: dict[str, Any]) -> Answer:
        try:
            found = kept(("property", json.dumps(table)), sources, lambda: ended(ask, table, limit))
        except NoAnswerError as none:
            return none.answer
        return Answer(**{**found, "broken": tuple(found["broken"])})

    return side_by_side(serve, one, tables)


def compiled(table: dict[str, Any]) -> dict[str, Any]:
    """The same scene by the backend that the program chooses: what takes the interpreted one minutes is no fault."""
    return table | {"numerics": table["numerics"] | {"backend": "auto"}}


def unestimated(table: dict[str, Any]) -> dict[str, Any]:
    """The same scene run once: that it takes long to be as accurate as asked is no hanging."""
    return table | {"numerics": table["numerics"] | {"backend": "auto", "estimate": False}}


def dear(answer: Answer) -> Answer:
    """What one run answers, and the accuracy asked does not within the patience: without an answer."""
    return replace(answer, outcome=DEAR, reason=f"not as accurate as asked within {PATIENCE:g} s")


def report(found: list[Answer]) -> None:
    """Print what was drawn, what was not answered and why, and the extremes."""
    laws = sorted({one.law for one in found})
    rows = []
    for law in laws:
        mine = [one for one in found if one.law == law]
        ends = Counter(one.outcome for one in mine)
        failed = ", ".join(f"{name} {count}" for name, count in sorted(ends.items()) if name not in ("solved", REFUSED))
        worst = max((one.residual for one in mine if one.residual is not None), default=0.0)
        slowest = max(one.seconds for one in mine)
        rows.append((law, len(mine), ends["solved"], ends[REFUSED], failed, f"{worst:.1e}", f"{slowest:.1f}"))
    header = ("law", "drawn", "solved", "refused", "failed", "worst energy residual", "slowest [s]")
    show("drawn scenes", header, rows)
    refused = Counter(one.reason.splitlines()[-1].strip()[:110] for one in found if one.outcome == REFUSED)
    show("refused", ("times", "reason"), [(count, reason) for reason, count in refused.most_common()])
    failed_runs = [(one.outcome, one.law, one.reason[:100]) for one in found if one.outcome not in ("solved", REFUSED)]
    show("without success", ("outcome", "law", "message"), sorted(failed_runs))
    for one in found:
        if one.broken:
            print(f"\nbroken: {'; '.join(one.broken)}\n{one.scene}")
    share = sum(one.outcome != "solved" for one in found) / len(found)
    print(f"\n{len(found)} scenes, {share:.1%} without an answer, {sum(one.seconds for one in found):.0f} s of running")


def check(found: list[Answer]) -> None:
    """Assert what was promised."""
    report(found)
    assert not [one.broken for one in found if one.broken]
    assert sum(one.outcome != "solved" for one in found) <= UNANSWERED * len(found)


def test_twenty_scenes_keep_every_property() -> None:
    tables = drawn(FEW, quick=True)
    assert len(tables) == FEW
    check(answers(tables))


@pytest.mark.slow
def test_two_thousand_scenes_keep_every_property() -> None:
    tables = drawn(MANY, quick=False)
    assert len(tables) == MANY
    check(answers(tables))
