"""Compiled runs are the interpreted ones, to the accuracy asked, for every bundled scene that has an answer."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.results.run import Run
from tests.common.table import show

RUPTURES = "edge-of-rupture"
NAMES = [name for name in sc.bundled_names() if name != RUPTURES]


def run(name: str, backend: str) -> Run:
    # At the first guess: the same grid for both; an interpreted estimate of hinges would take most of an hour.
    return sc.simulate(sc.load_scene(name, {"numerics.backend": backend, "numerics.estimate": False}))


def difference(one: Run, other: Run, field: str) -> float:
    """Largest at any time and place, over the largest way that anything has gone."""
    found, wanted = (run.data[field].values for run in (one, other))
    gone = max(float(np.max(np.abs(other.data[axis].values - other.data[axis].values[0]))) for axis in ("x", "y"))
    return float(np.max(np.abs(found - wanted))) / gone


@pytest.mark.slow
def test_trajectories_are_the_same_to_the_accuracy_asked() -> None:
    rows, worst = [], {}
    for name in NAMES:
        one, other = (run(name, backend) for backend in ("compiled", "interpreted"))
        assert one.outcome is other.outcome is sc.Outcome.solved, (name, one.summary["message"])
        assert one.summary["backend"] == "compiled", one.summary["backend_reason"]
        assert other.summary["backend"] == "interpreted"
        assert list(one.summary["effects"]) == list(other.summary["effects"]), name
        shares = [difference(one, other, field) / one.scene.run.accuracy for field in ("midpoint", "x", "y")]
        seconds = [done.summary["wall_s"]["solve"] for done in (one, other)]
        ratio = f"{seconds[1] / seconds[0]:.0f}"
        shown = [*(f"{second:.3f}" for second in seconds), ratio, *(f"{share:.2f}" for share in shares)]
        rows.append([name, other.summary["solver"], *shown])
        worst[name] = max(shares)
    header = ("scene", "interpreted by", "compiled [s]", "interpreted [s]", "ratio", "midpoint", "x", "y")
    show("solve stage, and differences over the accuracy asked (1e-3 of the way gone)", header, rows)
    for name, share in worst.items():
        assert share < 1, name


@pytest.mark.slow
def test_what_has_no_answer_has_none_compiled_either() -> None:
    one, other = (run(RUPTURES, backend) for backend in ("compiled", "interpreted"))
    assert one.outcome is other.outcome is sc.Outcome.localised
