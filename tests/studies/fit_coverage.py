"""Films of known materials with drawn noise, fitted again and again: how often intervals contain the truth.

``python -m tests.studies.fit_coverage`` prints its tables, 1400 fits, an hour on two processors, or only those named:
``python -m tests.studies.fit_coverage elements`` fits the films of finite elements on record alone, some minutes;
``tests/slow/test_fit_coverage.py`` looks at some of the same films.

Published theory on a few cells, and data by the same model on the same grid and tolerance, both given to `fit`: what is
tested are the statistics, not the grid. Everything that is drawn comes from seeds that are the numbers of scene, film
and study.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from itertools import product
from multiprocessing import get_context
from typing import Any

import numpy as np

import softcat_sym as sc
from softcat_sym.fitting.fit import fit
from softcat_sym.fitting.free_parameters import free_parameters, with_values
from softcat_sym.fitting.likelihood import discrepancy
from softcat_sym.fitting.measurements import Measurements, Series
from softcat_sym.fitting.problem import FilamentProblem, camera_spread
from tests.common.draws import draws
from tests.common.element_films import film as element_film
from tests.common.element_films import record
from tests.common.fitting import CONSTANTS, FITTED, WRONG, beside, constants, noisy, rows_of
from tests.common.table import show

CELLS = 10
"""Per half span."""

NOISE = 0.01
"""Standard deviation of a reading over the largest sag; the fit is not told."""

FRAMES = (60, 200)
"""The least and the most frames of a film."""

ASTRAY = 0.1
"""Largest logarithm of a rough value, from which the fit starts, over the true one."""


@dataclass(frozen=True)
class Case:
    """One material, and what of it is free."""

    scene: str
    free: tuple[str, ...]
    share: float = 1.0
    rtol: float = 1e-3
    profiles: bool = False  # Intervals are those of profiles, where Student's fall short
    effects: str = "paper"  # What `run.effects` is, of the film and of the fit


CASES = (
    Case("maxwell-slow", ("youngs_modulus", "viscosity"), 0.1, 5e-4),
    Case("maxwell-fast", ("youngs_modulus", "viscosity"), 0.1, 5e-4),
    Case("arrested-overdamped", ("youngs_modulus", "viscosity", "yield_stress"), profiles=True),
    Case("continual-descent", ("viscosity", "yield_stress")),
    Case("arrested-overdamped", ("youngs_modulus", "viscosity", "yield_stress"), profiles=True, effects="auto"),
)


@dataclass(frozen=True)
class Study:
    """What films are made with beside white noise, and what fits of them are told."""

    name: str
    told: Mapping[str, Any]
    films: int  # For each case
    camera: bool = False  # Drawn from what is known of them, as
    theory: bool = False  # the theory's error
    correlation: float = 0.0  # Of the noise of neighbours
    cases: Sequence[int] = (0, 1, 2, 3)  # Numbers in `CASES`


EXACT: Mapping[str, Any] = {"calibrated": True, "discrepancy": False}
STUDIES = {
    one.name: one
    for one in (
        Study("noise alone, told so", EXACT, 100),
        Study("noise alone, default", {}, 40),
        Study("camera, default", {}, 40, camera=True),
        Study("camera, no theory's error", {"discrepancy": False}, 40, camera=True),
        Study("camera and theory, default", {}, 40, camera=True, theory=True, cases=(0, 1, 2, 3, 4)),
        Study("correlated by 0.5, camera and theory exact", EXACT, 40, correlation=0.5),
    )
}


@dataclass(frozen=True)
class Fitted:
    """One film: logarithms of estimates and of their intervals over the truth, and what is said of the residuals."""

    frames: int
    error: list[float]
    interval: list[tuple[float, float]]
    white: str
    noise: float  # Over the true one
    seconds: float


def fitted(name: str, number: int, film: int) -> Fitted:
    """Draw one film, and fit it."""
    case, asked, random = CASES[number], STUDIES[name], draws(number, film, len(name))
    true = sc.load_scene(case.scene, {"run.effects": case.effects, "numerics.cells": CELLS})
    true = true.replace({"run.duration": f"{true.run.duration * case.share!r} s"})
    known = free_parameters(true, case.free)
    truth = [one.typical for one in known]
    rough = with_values(true, known, (np.array(truth) * np.exp(random.uniform(-ASTRAY, ASTRAY, len(truth)))).tolist())
    frames = int(random.integers(FRAMES[0], FRAMES[1], endpoint=True))
    time = np.linspace(0.0, true.run.duration, frames + 1)[1:]
    # The grid is chosen for the rough values.
    exact = _drawn(rough, case, time, truth)
    noise = NOISE * float(np.max(np.abs(exact)))
    midpoint = _drawn(rough, case, time, truth, exact, random) if asked.camera else exact
    if asked.theory:
        model = FilamentProblem(rough, _film(time, exact), case.free).films[0].model
        error = discrepancy(true, model.effects, model.terms)
        size, vectors = np.linalg.eigh(error.covariance(time, midpoint, np.gradient(midpoint, time)))
        midpoint = midpoint + vectors @ (np.sqrt(np.maximum(size, 0)) * random.standard_normal(frames))
    midpoint = midpoint + noise * _noise(frames, asked.correlation, random)
    found = fit(_film(time, midpoint), rough, case.free, starts=0, profiles=case.profiles, rtol=case.rtol, **asked.told)
    estimates = list(zip(found.parameters.values(), truth, strict=True))
    return Fitted(
        frames=frames,
        error=[math.log(one.best / value) for one, value in estimates],
        interval=[(_logarithm(one.ci95[0], value), _logarithm(one.ci95[1], value)) for one, value in estimates],
        white=found.checks.verdict,
        noise=found.noise / noise,
        seconds=found.seconds,
    )


def _film(time: np.ndarray, midpoint: np.ndarray) -> Measurements:
    return Measurements((Series(time=time, midpoint=midpoint, std=None, overrides={}),))


def _noise(frames: int, correlation: float, random: np.random.Generator) -> np.ndarray:
    """Of unit variance, begun as it goes on."""
    white = random.standard_normal(frames)
    for k in range(1, frames):
        white[k] = correlation * white[k - 1] + math.sqrt(1 - correlation**2) * white[k]
    return white


def _drawn(
    scene: sc.Scene,
    case: Case,
    time: np.ndarray,
    values: Sequence[float],
    exact: np.ndarray | None = None,
    random: np.random.Generator | None = None,
) -> np.ndarray:
    """Heights of the midpoint with these values of what is free, on the grid that the scene's own values get.

    With a generator the camera's numbers are drawn from what is known of them for the heights without them: its clock
    and its zero as unknowns, its scale as a factor of the heights; a tilt moves the midpoint in second order only.
    """
    seen = _film(time, -time if exact is None else exact)
    spread = {} if random is None else camera_spread(seen.series[0])
    drawn = {name: size * random.standard_normal() for name, size in spread.items()} if random else {}
    factor = 1 + drawn.pop("scale", 0.0)
    drawn.pop("tilt", None)
    problem = FilamentProblem(scene, seen, (*case.free, *drawn), rtol=case.rtol)
    numbers = dict(zip(case.free, values, strict=True)) | drawn
    return factor * problem.films[0].values(np.array([one.scaled(numbers[one.name]) for one in problem.free]))


def _logarithm(end: float | None, value: float) -> float:
    return math.nan if end is None else math.log(end / value)


def covered(intervals: Sequence[tuple[float, float]]) -> float:
    """Share of the intervals that contain the truth."""
    ends = np.array(intervals)
    return float(np.mean(~(ends[:, 0] > 0) & ~(ends[:, 1] < 0)))


def print_study(name: str) -> None:
    """All films of a study, and how many of their intervals hold the truth."""
    asked, rows = STUDIES[name], list[list[object]]()
    with ProcessPoolExecutor(mp_context=get_context("spawn")) as pool:
        for number in asked.cases:
            case, films = CASES[number], asked.films
            found = list(pool.map(fitted, [name] * films, [number] * films, range(films)))
            for k, free in enumerate(case.free):
                errors, share = np.array([one.error[k] for one in found]), covered([one.interval[k] for one in found])
                bias = errors.mean() / errors.std(ddof=1)
                rows.append([case.scene, free, f"{share:.1%}", f"{bias:+.2f}", f"{errors.std(ddof=1):.2%}"])
                rows[-1] += [f"{np.mean([one.noise for one in found]):.3f}", sum(o.white == "not white" for o in found)]
    header = ["scene", "parameter", "holds the truth", "bias/std", "std", "noise", "not white"]
    show(f"{name}; {asked.films} films a scene, 1 % noise, {CELLS} cells", header, rows)


def print_elements() -> None:
    """Fits of the films of finite elements: how many intervals hold the constants of the elements."""
    for theory in ("auto", "paper"):
        rows, held = list[list[object]](), list[bool]()
        for name, noise in product(record()["films"], (1e-2, 1e-3)):
            plain, time, heights = element_film(name)
            scene = plain.replace({"run.effects": theory})
            free = tuple(key for key in CONSTANTS if getattr(scene.material, key) is not None)
            start, truth = beside(scene, {key: WRONG[key] for key in free}), constants(scene, free)
            found = fit(Measurements.of(time, noisy(heights, noise)[0]), start, free)
            rows += rows_of(f"{name}, {noise:.1%}: {found.outcome.word}", found, truth)
            for key, one in found.parameters.items():
                low, high = (_logarithm(end, truth[key]) for end in one.ci95)
                held.append(covered([(low, high)]) == 1)
        show(f"elements, {theory}: {np.mean(held):.0%} of {len(held)} intervals hold", FITTED, rows)


if __name__ == "__main__":
    for study_name in sys.argv[1:] or [*STUDIES, "elements"]:
        if study_name == "elements":
            print_elements()
        else:
            print_study(study_name)
