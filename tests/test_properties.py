"""Whole scenes drawn at random: every answer is right as far as invariants can tell, or an honest refusal.

The ranges stand in ``common/scene_strategies.py`` and were fixed, like the seeds, before any scene was run.
"""

from __future__ import annotations

import dataclasses
import itertools
import json
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr
from hypothesis import HealthCheck, Phase, given, seed, settings

import softcat_sym as sc
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from tests.common import scene_runs
from tests.common.kept_answers import fingerprint, kept
from tests.common.limited_process import Ask, LimitedProcess, side_by_side
from tests.common.scene_runs import REFUSED, Answer, answer_within, is_balanced, is_late, messages, serve
from tests.common.scene_strategies import scenes
from tests.common.table import show

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


TABLE: dict[str, Any] = {
    "filament": {"span": "0.2 m", "thickness": "8 mm", "density": "1900 kg/m^3"},
    "material": {"law": "maxwell", "youngs_modulus": "2 MPa", "viscosity": "0.2 MPa*s"},
    "ends": {"motion": [["0 s", "0 m", "0 m"]]},
    "run": {"duration": "0.3 s", "frames": 4, "accuracy": 0.01},
    "numerics": {"cells": 8, "backend": "interpreted", "estimate": False},
}


def spoiled(data: xr.Dataset) -> Iterator[tuple[str, xr.Dataset]]:
    """What is to be said of the data, each with one thing in it broken."""
    for message, name, place, change in (
        ("moment is not finite", "moment", (2, 3), lambda _: np.nan),
        ("a stretch of 0", "stretch", (1, 0), lambda _: 0.0),
        ("the left support is off", "y", (3, 0), lambda y: y + 1e-6),
        ("the right support is off", "x", (2, -1), lambda x: x - 1e-6),
        ("an energy residual of", "energy_elastic", 2, lambda e: e + 0.02 * float(abs(data.energy_potential).max())),
        ("dissipation falls", "energy_dissipated", 3, lambda _: data.energy_dissipated.values[2] * (1 - 1e-3)),
        ("left and right differ", "y", (3, 4), lambda y: 1.05 * y),
    ):
        broken = data.copy(deep=True)
        broken[name][place] = change(float(broken[name][place]))
        yield message, broken
    yield "frames at", data.assign_coords(time=data.time * 1.01)


def test_what_is_broken_is_noticed() -> None:
    run = sc.simulate(Scene.model_validate(TABLE))
    assert run.outcome.is_success
    assert messages(run) == []
    for message, data in spoiled(run.data):
        fields = {str(name): variable.values for name, variable in data.variables.items()}
        assert any(message in text for text in messages(dataclasses.replace(run, fields=fields))), message


def test_a_foreign_exception_and_an_untrue_file_are_seen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(scene: Scene) -> Run:
        raise ZeroDivisionError("by zero")

    monkeypatch.setattr(scene_runs.sc, "simulate", fails)
    assert scene_runs.answer(TABLE, str(tmp_path)).broken == ("ZeroDivisionError: by zero",)
    other = Scene.model_validate({**TABLE, "title": "other"})
    monkeypatch.setattr(scene_runs.sc, "load_scene", lambda path: other)
    assert scene_runs._there_and_back(Scene.model_validate(TABLE), str(tmp_path))


def test_a_refusal_is_no_fault(tmp_path: Path) -> None:
    table = {**TABLE, "run": {"duration": "1 s", "effects": ["yielding"]}}
    found = scene_runs.answer(table, str(tmp_path))
    assert (found.outcome, found.broken) == (scene_runs.REFUSED, ())
    assert "run.effects" in found.reason


@pytest.mark.slow
def test_a_hang_and_a_death_are_seen_and_the_next_scene_is_answered() -> None:
    one = LimitedProcess(serve)
    try:
        assert answer_within(one.ask, TABLE, 0.01).broken == ("no answer within 0.01 s",)
        one._process.kill()
        one._process.join()
        assert answer_within(one.ask, TABLE, 60.0).broken == ("the process died with -9",)
        found = answer_within(one.ask, TABLE, 60.0)
        assert (found.outcome, found.broken) == ("solved", ())
    finally:
        one.close()


@pytest.mark.parametrize("thinning", [True, False])
def test_energy_is_audited_where_forces_and_store_belong_together(thinning: bool) -> None:
    """A cantilever whose section swells misses the same energy at any tolerance; one that thins misses none."""
    effects = ["inertia", "bending", "extensibility", "finite-stretch", "large-rotation", "viscous-stress"]
    table = TABLE | {
        "filament": {"span": "0.2 m", "thickness": "8 mm", "density": "1900 kg/m^3"},
        "material": {"law": "kelvin-voigt", "youngs_modulus": "0.2 MPa", "viscosity": "400 Pa*s"},
        "ends": {"left": "clamped", "right": "free"},
        "run": TABLE["run"]
        | {"effects": [*effects, *(["thinning"] if thinning else [])], "duration": "1 s", "accuracy": 1e-3},
    }
    residuals = []
    for rtol in (1e-6, 1e-8):
        changed = table | {"numerics": TABLE["numerics"] | {"rtol": rtol}}
        found = sc.simulate(Scene.model_validate(changed))
        residuals.append(found.summary["energy_residual"])
        assert is_balanced(found.scene, found) is thinning
        warned = any(warning.startswith("the energy residual") for warning in found.summary["warnings"])
        assert warned is not thinning
    if thinning:
        assert residuals[1] < 1e-6
    else:
        assert residuals[1] == pytest.approx(residuals[0], rel=0.1)
        assert residuals[1] > 1e-3
