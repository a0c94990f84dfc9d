"""Fits of the same film by the compiled and by the interpreted solver, by least squares and by IPOPT.

``python -m pytest -m slow -s tests/slow/test_fit_agreement.py`` prints the tables.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.least_squares import Optimum, minimise
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.problem import FilamentProblem
from softcat_sym.scene.scene import Scene
from tests.common.fitting import CONSTANTS, METHODS_AGREE, beside, film, methods_apart, values
from tests.common.table import show

pytestmark = pytest.mark.slow

WAYS = {
    "compiled": ("compiled", "least-squares"),
    "interpreted": ("interpreted", "least-squares"),
    "IPOPT": ("compiled", "ipopt"),
}
"""Backend and method; whether both backends have the same derivatives of a flow that yields, `test_gradients` says."""
AGREE = {"interpreted": 1e-6, "IPOPT": 1e-5}
"""Of every constant, relative, with what is compiled."""


@dataclass(frozen=True)
class Case:
    """A filament, what is free and from which factors a fit starts, share of its run, the solvers' tolerance, ways."""

    scene: str
    start: dict[str, float]
    share: float
    rtol: float
    ways: tuple[str, ...] = ("compiled", "IPOPT")


CASES = {
    "Maxwell": Case("maxwell-fast", {"youngs_modulus": 1.3, "viscosity": 0.75}, 0.2, 1e-8, tuple(WAYS)),
    "Bingham": Case("continual-descent", dict(zip(CONSTANTS, (1.3, 0.75, 1.2), strict=True)), 0.1, 1e-9),
}


@cache
def _filmed(name: str) -> tuple[Scene, Measurements]:
    """The truth, on ten cells, and a film of it."""
    case = CASES[name]
    whole = sc.load_scene(case.scene, {"numerics.cells": 10, "run.effects": "paper"})
    scene = whole.replace({"run.duration": f"{case.share * whole.run.duration!r} s"})
    return scene, film(scene, 60, 0.01)


@cache
def _problem(name: str, backend: str) -> FilamentProblem:
    scene, data = _filmed(name)
    case = CASES[name]
    return FilamentProblem(beside(scene, case.start), data, tuple(case.start), backend=backend, rtol=case.rtol)


@pytest.mark.parametrize("name", CASES)
def test_all_ways_find_the_same_constants(name: str) -> None:
    found: dict[str, Optimum] = {}
    rows = []
    for way in CASES[name].ways:
        backend, method = WAYS[way]
        problem = _problem(name, backend)
        one = found[way] = minimise(problem, problem.typical, method=method)
        numbers = [f"{value:.9g}" for value in values(problem, one.q).values()]
        rows.append([way, *numbers, f"{2 * one.value:.9g}", one.evaluations, f"{one.offset:.0e}"])
    header = ("", *CASES[name].start, "sum of squares", "evaluations", "offset")
    show(f"{name}, 60 points, 1 % noise, rtol {CASES[name].rtol:g}", header, rows)
    assert all(one.converged for one in found.values())
    for way in CASES[name].ways[1:]:
        assert np.all(np.abs(np.expm1(found["compiled"].q - found[way].q)) < AGREE[way]), way


FILMS = [(name, seed) for name in ("maxwell-fast", "continual-descent") for seed in range(5)]


def test_ten_films_have_one_optimum_by_both_methods() -> None:
    shares = {"maxwell-fast": 0.2, "continual-descent": 0.5}
    apart = [methods_apart(name, shares[name], seed) for name, seed in FILMS]
    show(
        "IPOPT less SciPy",
        ["film", "seed", "standard errors"],
        [[*one, f"{far:.1e}"] for one, far in zip(FILMS, apart, strict=True)],
    )
    # One noisy film has so flat an optimum that either method stops within the model's integration error.
    assert sorted(apart)[7] < METHODS_AGREE and max(apart) < 0.1
