"""Films whose truth is known, and fits of them, as acceptance checks share them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

import softcat_sym as sc
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.problem import FilamentProblem
from softcat_sym.fitting.result import Fit, FitOutcome
from softcat_sym.scene.scene import Scene
from tests.common.draws import RARE, draws

Floats = npt.NDArray[np.float64]

CONSTANTS = ("youngs_modulus", "viscosity", "yield_stress")
UNITS = {"youngs_modulus": "Pa", "viscosity": "Pa*s", "yield_stress": "Pa"}
WRONG = {"youngs_modulus": 1.5, "viscosity": 1 / 1.4, "yield_stress": 1.3}
"""Factors from the truth to where fits start."""


def constants(scene: Scene, names: Sequence[str] = CONSTANTS) -> dict[str, float]:
    """What a scene says of its material [SI]."""
    return {name: float(getattr(scene.material, name)) for name in names}


def beside(scene: Scene, factors: Mapping[str, float]) -> Scene:
    """The scene with constants of its material times factors."""
    values = constants(scene, tuple(factors))
    return scene.replace({f"material.{name}": f"{values[name] * factors[name]!r} {UNITS[name]}" for name in factors})


def noisy(midpoint: Floats, noise: float, seed: int = 0) -> tuple[Floats, float]:
    """Heights with white noise, and its standard deviation: a share of the largest height."""
    std = noise * float(np.max(np.abs(midpoint)))
    return midpoint + std * draws(seed).standard_normal(midpoint.size), std


def film(scene: Scene, frames: int, noise: float, seed: int = 0) -> Measurements:
    """A run of the scene, seen through noise; the start, which has none of it to tell, is left out."""
    run = sc.simulate(scene.replace({"run.frames": frames + 1})).data
    midpoint, std = noisy(run.midpoint.values[1:], noise, seed)
    return Measurements.of(run.time.values[1:], midpoint, std)


METHODS_AGREE = 1e-3
"""Of a standard error, between the optima of both methods."""


def methods_apart(name: str, share: float, seed: int, rtol: float = 1e-8) -> float:
    """Largest distance between the fits of one film by both methods, in standard errors: the camera's and all."""
    whole = sc.load_scene(name, {"run.effects": "paper", "numerics.cells": 10})
    scene = whole.replace({"run.duration": f"{share * whole.run.duration!r} s"})
    free = CONSTANTS[:2] if scene.material.yield_stress is None else CONSTANTS[1:]
    data, start = film(scene, 60, 0.01, seed), beside(scene, {key: WRONG[key] for key in free})
    data = Measurements.of(data.series[0].time, data.series[0].midpoint)
    how: dict[str, Any] = {"starts": 0, "profiles": False, "rtol": rtol}
    one, other = (sc.fit(data, start, free, method=method, **how) for method in ("least-squares", "ipopt"))
    errors = one.information.standard_errors
    found = [np.array([each.parameters[key].best for key in free]) for each in (one, other)]
    return float(np.max(np.abs(np.log(found[0] / found[1])) / errors))


def values(problem: FilamentProblem, q: Floats) -> dict[str, float]:
    """The constants [SI] that unknowns stand for."""
    return {one.name: one.value(float(x)) for one, x in zip(problem.free, q, strict=True)}


def is_noise(found: Fit) -> bool:
    """Whether residuals are noise, of which one set in a hundred is accused."""
    tests = found.checks.tests
    return found.checks.verdict == "white" or min(one.p_value for one in tests) > RARE / len(tests)


def is_sound(found: Fit) -> bool:
    """Whether a fit is solved, or but accuses residuals that are noise."""
    return found.outcome is FitOutcome.solved or (found.outcome is FitOutcome.model_error and is_noise(found))


def rows_of(title: str, found: Fit, truth: Mapping[str, float]) -> list[list[object]]:
    """Rows of a table: what a fit says of each constant, beside the truth."""
    rows: list[list[object]] = []
    for name, one in found.parameters.items():
        off = 100 * (one.best / truth[name] - 1)
        share = "" if one.std is None else f"{100 * one.std / one.best:.3f} %"
        rows.append([title, name, f"{truth[name]:.6g}", f"{one.best:.6g}", f"{off:+.3f} %", share, one.verdict])
    return rows


FITTED = ("film", "", "truth", "fitted", "off by", "standard error", "verdict")
"""The header of those rows."""
