"""The estimated error of a run is its true error within a factor of three, nine times of ten.

The variable SOFTCAT_CALIBRATED names scenes to look at alone, such as ``cold-honey,random 7``.
"""

from __future__ import annotations

import os
from functools import cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.reading import load_scene

from .error_calibration import Calibrated, calibrations
from .random_scenes import SEED, random_scenes
from .table import show

pytestmark = pytest.mark.slow

LEAST, MOST, SHARE = 0.3, 3.0, 0.90
NUMBER = 60
"""Random scenes, the first of those that effects are judged by: all laws, sections, ends and starts."""

NOTHING = 1e-3
"""Share of the accuracy below which estimate and true error are both nothing, and their ratio is rounding."""


def _scenes() -> list[tuple[str, sc.Scene]]:
    bundled = [(name, load_scene(name)) for name in bundled_names()]
    drawn = [(f"random {number}", scene) for number, scene in enumerate(random_scenes(NUMBER, SEED))]
    every = [*bundled, *drawn]
    named = [name.strip() for name in os.environ.get("SOFTCAT_CALIBRATED", "").split(",") if name.strip()]
    return [(name, scene) for name, scene in every if name in named] if named else every


@cache
def _found() -> tuple[Calibrated, ...]:
    return tuple(calibrations(_scenes()))


def _answered() -> list[Calibrated]:
    return [one for one in _found() if not one.why_not]


def _is_calibrated(one: Calibrated) -> bool:
    nothing = NOTHING * one.accuracy
    return LEAST <= one.ratio <= MOST or (one.true < nothing and (one.estimate["total"] or 0.0) < nothing)


def test_estimates_are_right_within_a_factor_of_three() -> None:
    rows = []
    for one in _answered():
        parts = [f"{one.estimate[name] or 0:.1e}" for name in ("total", "space", "time", "section")]
        at = f"{one.resolution['cells']} x {one.resolution['fibres'] or one.resolution['order'] or '-'}"
        rows.append((one.name, f"{one.accuracy:g}", f"{one.true:.1e}", *parts, f"{one.ratio:.2f}", at))
    header = ("scene", "asked", "true", "estimated", "space", "time", "section", "true/estimated", "cells x fibres")
    show("errors, true and estimated", header, rows)
    silent = [one for one in _found() if one.why_not]
    show("nothing to compare", ("scene", "outcome", "why"), [(o.name, o.outcome, o.why_not[:90]) for o in silent])
    within = [_is_calibrated(one) for one in _answered()]
    print(f"\n{np.mean(within):.1%} of {len(within)} within a factor of three; median {_median():.2f}")
    assert len(within) > 0.85 * len(_found())
    assert np.mean(within) >= SHARE


def test_what_is_called_accurate_is() -> None:
    missed = [one for one in _answered() if one.true > 1.5 * one.accuracy]
    show(
        "true error beyond the accuracy asked",
        ("scene", "asked", "true"),
        [(o.name, o.accuracy, o.true) for o in missed],
    )
    within = np.mean([one.true <= one.accuracy for one in _answered()])
    print(f"\n{within:.1%} within the accuracy asked")
    assert within >= 0.95
    assert len(missed) <= 0.02 * len(_answered())


def test_what_control_costs() -> None:
    """Seconds of the estimate over those of the answer's own integration: told, not judged."""
    dearest = sorted(_answered(), key=lambda one: -one.estimating)[:10]
    rows = [(one.name, f"{one.seconds:.2f}", f"{one.estimating:.2f}") for one in dearest]
    show("the dearest estimates", ("scene", "solve [s]", "estimate [s]"), rows)
    assert np.median([one.estimating for one in _answered()]) < 10.0


def _median() -> float:
    return float(np.median([one.ratio for one in _answered()]))
