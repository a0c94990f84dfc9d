"""Films of known materials with drawn noise, fitted again and again: how often intervals contain the truth.

Published theory on a few cells, and data by the same model on the same grid: what is tested are the statistics, not
the grid. Everything that is drawn comes from seeds that are the numbers of scene and film.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from multiprocessing import get_context

import numpy as np

import softcat_sym as sc
from softcat_sym.fitting.fit import FilamentProblem, Fit, fit
from softcat_sym.fitting.free_parameters import free_parameters, with_values
from softcat_sym.fitting.inference import profile
from softcat_sym.fitting.measurements import Measurements, Series
from tests.common.kept_answers import fingerprint, kept

CELLS = 10
"""Per half span."""

NOISE = 0.01
"""Standard deviation of a reading over the largest sag; the fit is not told."""

FRAMES = (60, 200)
"""The least and the most frames of a film."""

ASTRAY = 0.1
"""Largest logarithm of a rough value, from which the fit starts, over the true one."""

SETS, PROFILED = 200, 20
"""Films for each scene, and how many of them get profiles too."""


_TOGETHER = 10  # films in one job


@dataclass(frozen=True)
class Case:
    """One material, and what of it is free."""

    scene: str
    free: tuple[str, ...]
    share: float = 1.0
    rtol: float | None = None
    curved: tuple[str, ...] = ()


CASES = (
    Case("maxwell-slow", ("youngs_modulus", "viscosity"), 0.1, 5e-4),
    Case("maxwell-fast", ("youngs_modulus", "viscosity"), 0.1, 5e-4),
    Case("arrested-overdamped", ("youngs_modulus", "viscosity", "yield_stress"), curved=("youngs_modulus",)),
    Case("continual-descent", ("viscosity", "yield_stress")),
)


@dataclass(frozen=True)
class Fitted:
    """One film."""

    frames: int
    error: list[float]
    interval: list[tuple[float, float]]
    profiled: dict[str, tuple[float, float]]
    words: list[str]
    white: str
    noise: float
    seconds: float


def study(sets: int = SETS, profiled: int = PROFILED, workers: int | None = None) -> dict[str, list[Fitted]]:
    """All films of all cases, on all cores."""
    jobs = [
        (number, list(range(begin, min(begin + _TOGETHER, sets))), profiled)
        for begin in range(0, sets, _TOGETHER)
        for number in range(len(CASES))
    ]
    found: dict[str, list[Fitted]] = {case.scene: [] for case in CASES}
    with ProcessPoolExecutor(max_workers=workers or os.cpu_count(), mp_context=get_context("spawn")) as pool:
        for job, rows in zip(jobs, pool.map(_several, jobs), strict=True):
            found[CASES[job[0]].scene] += rows
    return found


def _several(job: tuple[int, Sequence[int], int]) -> list[Fitted]:
    number, films, profiled = job
    question = [f"{number} {one} {one < profiled}" for one in films]
    rows = kept(
        question,
        fingerprint(__file__),
        lambda: [asdict(fitted(number, one, profiles=one < profiled)) for one in films],
    )
    return [Fitted(**row) for row in rows]


def fitted(number: int, film: int, *, profiles: bool) -> Fitted:
    """Draw one film, and fit it."""
    case, random = CASES[number], np.random.default_rng([number, film])
    true = sc.load_scene(case.scene, {"run.effects": "paper", "numerics.cells": CELLS})
    true = true.replace({"run.duration": f"{true.run.duration * case.share!r} s"})
    known = free_parameters(true, case.free)
    truth = [one.typical for one in known]
    rough = with_values(true, known, np.array(truth) * np.exp(random.uniform(-ASTRAY, ASTRAY, len(truth))))
    frames = int(random.integers(FRAMES[0], FRAMES[1], endpoint=True))
    time = np.linspace(0.0, true.run.duration, frames + 1)[1:]
    # The grid is chosen for the rough values.
    exact = _exact(rough, case, time, truth)
    noise = NOISE * float(np.max(np.abs(exact)))
    drawn = Series(time=time, midpoint=exact + noise * random.standard_normal(frames), std=None, overrides={})
    found = fit(Measurements((drawn,)), rough, case.free, starts=0, profiles=False, rtol=case.rtol)
    estimates = list(zip(found.parameters.values(), truth, strict=True))
    return Fitted(
        frames=frames,
        error=[math.log(one.best / value) for one, value in estimates],
        interval=[tuple(_logarithm(end, value) for end in one.ci95) for one, value in estimates],
        profiled=_profiled(found, truth, case.free if profiles else case.curved),
        words=[one.verdict for one, _ in estimates],
        white=found.checks.verdict,
        noise=found.noise / noise,
        seconds=found.seconds,
    )


def _exact(scene: sc.Scene, case: Case, time: np.ndarray, values: Sequence[float]) -> np.ndarray:
    """Heights of the midpoint with these values of what is free, on the grid that the scene's own values get."""
    nothing = Series(time=time, midpoint=-time, std=None, overrides={})
    problem = FilamentProblem(scene, Measurements((nothing,)), case.free, rtol=case.rtol)
    q = np.array([one.scaled(value) for one, value in zip(problem.free, values, strict=True)])
    return problem.curves(q)[0]


def _logarithm(end: float | None, value: float) -> float:
    return math.nan if end is None else math.log(end / value)


def _profiled(found: Fit, truth: Sequence[float], names: Sequence[str]) -> dict[str, tuple[float, float]]:
    """Ends of the profile intervals, as logarithms over the truth."""
    problem, q = found.problem, found.starts.best.q
    ends = {}
    for k, (free, value) in enumerate(zip(problem.free, truth, strict=True)):
        if free.name in names:
            traced = profile(problem, q, k, noise_known=False)
            low, high = (
                math.nan if side.crossing is None else side.crossing - free.scaled(value)
                for side in (traced.lower, traced.upper)
            )
            ends[free.name] = (low, high)
    return ends


def covered(intervals: Sequence[tuple[float, float]]) -> float:
    """Share of the intervals that contain the truth."""
    ends = np.array(intervals)
    return float(np.mean(~(ends[:, 0] > 0) & ~(ends[:, 1] < 0)))
