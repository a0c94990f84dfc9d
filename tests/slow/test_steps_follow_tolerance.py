"""Steps and true errors of the compiled solver over its tolerance: a tighter one takes more steps and errs less."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.simulate import without_estimate
from softcat_sym.solvers.outcome import Outcome
from tests.common.table import show

pytestmark = [pytest.mark.slow, pytest.mark.compiled]

TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5)
REFERENCE = 1e-7
NOTHING = 1e-5
"""Error below which it is chance where a step meets the time at which a fibre yields."""
# Creeping to rest at the yield stress, flowing on, swinging with a loss: what the method and its tolerances differ by.
SCENES = (
    *("arrested-overdamped", "ink-bridge", "printed-lintel", "continual-descent", "bread-dough", "cold-honey"),
    *("polymer-thread", "gelatin-strand", "agar-bar", "maxwell-fast"),
)


def run(name: str, rtol: float) -> tuple[int, np.ndarray]:
    """Steps, and the midpoint over time; the loosest steps need not balance the energy."""
    changes = {"numerics.rtol": rtol, "numerics.cells": 20, "run.frames": 51}
    found = sc.simulate(without_estimate(sc.load_scene(name, changes)))
    assert found.outcome in (Outcome.solved, Outcome.energy_drift), (name, rtol, found.outcome)
    return found.summary["steps"], np.asarray(found.fields["midpoint"])


@pytest.mark.parametrize("name", SCENES)
def test_a_tighter_tolerance_takes_more_steps_and_errs_less(name: str) -> None:
    _, exact = run(name, REFERENCE)
    runs = [run(name, rtol) for rtol in TOLERANCES]
    steps = [count for count, _ in runs]
    errors = [float(np.max(np.abs(seen - exact)) / np.max(np.abs(exact))) for _, seen in runs]
    rows = [
        [f"{rtol:g}", str(count), f"{error:.1e}"] for rtol, count, error in zip(TOLERANCES, steps, errors, strict=True)
    ]
    show(name, ("rtol", "steps", "error"), rows)
    assert np.all(np.diff(steps) > 0), steps
    assert all(b < a or b < NOTHING for a, b in pairwise(errors)), errors
