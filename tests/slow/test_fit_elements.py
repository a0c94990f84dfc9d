"""Fits, as anybody gets them, of films that finite elements made: how often 95 % intervals hold the constants.

Intervals are those of the curvature, and for `TRACED` also those of profiles, which take a minute a film. The films are
clean of a camera's errors, of which the fits do not know. Not covered is the published theory of an elastic film, which
rings without end: its higher modes lack shear, so that they err by a pace of their own.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cache
from itertools import product

import numpy as np
import pytest

from softcat_sym.fitting.fit import fit
from softcat_sym.fitting.measurements import Measurements
from tests.common.draws import misses, shares
from tests.common.element_films import HELD, KNOWN, film
from tests.common.fitting import CONSTANTS, WRONG, beside, noisy
from tests.common.kept_answers import fingerprint, kept
from tests.common.table import show

pytestmark = pytest.mark.slow

THEORIES: Mapping[str, Mapping[str, object]] = {"default": {}, "published": {"run.effects": "paper"}}
NOISE, SEEDS = (1e-2, 1e-3), (0,)
HOLD = 0.90
"""Of intervals: 93.8 and 90.1 % did, 17 and 16 of the 18 of films kept back."""
TIME_LIMIT = 600.0
"""Of a fit [s]: that of the ringing film at 0.1 % noise was not at its end after an hour beside other work."""

TRACED = (("held descent", "default"), ("held Maxwell", "published"))

BEFORE = {
    ("arrested-overdamped", "default"): "eta -9 %, sY +2.7 %",
    ("arrested-overdamped", "published"): "eta -51 %",
    ("continual-descent", "default"): "eta -5.6 %, sY +3.4 %",
}
"""Fits that knew of noise alone."""


@dataclass(frozen=True)
class Said:
    """What a fit says of one film; constants over the truth."""

    outcome: str
    constants: dict[str, float]
    ends: dict[str, tuple[float | None, float | None]]
    verdicts: dict[str, str]
    resolution: str
    seconds: float

    def holds(self, name: str) -> bool:
        low, high = self.ends[name]
        return (low is None or low <= 1) and (high is None or high >= 1)


@cache
def said(name: str, theory: str, noise: float, seed: int, *, profiles: bool = False) -> Said:
    """The default fit of a film, begun away from the truth; a fit of unchanged code is not made twice."""
    question = [name, theory, str(noise), str(seed), str(profiles)]
    return Said(**kept(question, fingerprint(__file__), lambda: asdict(_fitted(name, theory, noise, seed, profiles))))


def _fitted(name: str, theory: str, noise: float, seed: int, profiles: bool) -> Said:
    scene, times, heights = film(name)
    scene = scene.replace(dict(THEORIES[theory]))
    truth = {key: float(value) for key in CONSTANTS if (value := getattr(scene.material, key)) is not None}
    data = Measurements.of(times, noisy(heights, noise, seed)[0])
    begin = time.perf_counter()
    start = beside(scene, {key: WRONG[key] for key in truth})
    found = fit(data, start, tuple(truth), profiles=profiles, time_limit=TIME_LIMIT)
    spent, moved, parameters = time.perf_counter() - begin, found.resolution, found.parameters
    return Said(
        outcome=found.outcome.word,
        constants={key: one.best / truth[key] for key, one in parameters.items()},
        ends={key: (_over(one.ci95[0], truth[key]), _over(one.ci95[1], truth[key])) for key, one in parameters.items()},
        verdicts={key: one.verdict for key, one in parameters.items()},
        resolution="" if moved is None else f"{moved.at.cells}, {moved.at.fibres or 0}, {moved.shares.total or 0:.2f}",
        seconds=spent,
    )


def _over(end: float | None, truth: float) -> float | None:
    return None if end is None else end / truth


def _cell(one: Said, name: str) -> str:
    """Error and interval in per cent; a star where it does not hold the truth."""
    if name not in one.constants:
        return ""
    ends = ["-" if end is None else f"{100 * (end - 1):+.2g}" for end in one.ends[name]]
    star = "" if one.holds(name) else " *"
    return f"{100 * (one.constants[name] - 1):+.2f} ({' to '.join(ends)}){star}"


@pytest.mark.statistical
@pytest.mark.parametrize("theory", THEORIES)
def test_intervals_hold_the_constants_of_the_elements(theory: str) -> None:
    rows, outcomes, seconds = list[list[object]](), list[str](), 0.0
    within, held = list[bool](), list[bool]()
    for seed, name, noise in product(SEEDS, (*HELD, *KNOWN), NOISE):
        one = said(name, theory, noise, seed)
        cells = [_cell(one, key) for key in CONSTANTS]
        before = BEFORE.get((name, theory), "") if not seed else ""
        rows.append([name, f"{100 * noise:g} %", *cells, one.outcome, one.resolution, f"{one.seconds:.1f}", before])
        print(rows[-1], flush=True)
        # What has no end on either side says nothing, and holds everything.
        said_of = [key for key in one.constants if any(end is not None for end in one.ends[key])]
        (held if name in HELD else within).extend(one.holds(key) for key in said_of)
        outcomes.append(one.outcome)
        seconds += one.seconds
    every, kept_from = np.mean([*within, *held]), np.mean(held)
    good = np.mean([word in ("solved", "not identified") for word in outcomes])
    title = f"{theory} physics, curvature: {100 * every:.1f} % of {len(within) + len(held)} intervals hold the truth, "
    title += f"{100 * kept_from:.1f} % of {len(held)} of the films kept back; {100 * good:.0f} % solved or not "
    title += f"identified; {seconds:.0f} s"
    header = ["film", "noise", "E, %", "eta, %", "sY, %", "outcome", "cells, fibres, moved", "s", "noise alone had"]
    show(title, header, rows)
    # Binomials, as if the errors of the theory were drawn too: 70 % of 91, and 7 of 18. Intervals half as wide would
    # hold 64 %.
    for found in ([*within, *held], held):
        assert np.mean(found) >= shares(len(found), HOLD)[0]


@pytest.mark.statistical
@pytest.mark.parametrize(("name", "theory"), TRACED)
def test_profiles_hold_them_too(name: str, theory: str) -> None:
    one = said(name, theory, NOISE[0], 0, profiles=True)
    show(f"{name}, {theory}, profiles: {one.seconds:.0f} s", CONSTANTS, [[_cell(one, key) for key in CONSTANTS]])
    assert not any(misses(one.constants[key], one.ends[key], 1.0) for key in one.constants)
