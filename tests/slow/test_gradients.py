"""Derivatives of the midpoint by what is unknown: compiled, interpreted, and by finite differences.

``python -m pytest -m slow -s tests/slow/test_gradients.py`` prints the tables.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import free_parameters
from tests.common.table import show

pytestmark = pytest.mark.slow

_CAMERA = ("time_offset", "initial_sag")


@dataclass(frozen=True)
class Case:
    """A filament, what is free, and how much of its run is looked at."""

    scene: str
    free: tuple[str, ...]
    share: float
    rtol: float
    physics: str = "paper"


CASES = {
    "Maxwell": Case("maxwell-fast", ("youngs_modulus", "viscosity", "thickness", "density", *_CAMERA), 0.2, 1e-8),
    "Bingham": Case(
        "continual-descent",
        ("youngs_modulus", "viscosity", "yield_stress", "thickness", "density", *_CAMERA),
        1.0,
        1e-8,
    ),
    "Herschel-Bulkley": Case("toothpaste", ("youngs_modulus", "viscosity", "yield_stress", "index"), 0.3, 1e-8),
    "with shear, fibres": Case(
        "continual-descent", ("youngs_modulus", "viscosity", "yield_stress", *_CAMERA), 1.0, 1e-8, "fibres"
    ),
}


@lru_cache(maxsize=16)
def _model(name: str, backend: str) -> ForwardModel:
    case = CASES[name]
    over: dict[str, object] = {"numerics.cells": 10, "run.effects": "paper"}
    if case.physics == "fibres":
        published = choose_effects(sc.load_scene(case.scene, over)).names
        over |= {"run.effects": [*published, "shear", "fibres"], "numerics.fibres": 4}
    scene = sc.load_scene(case.scene, over)
    free = free_parameters(scene, case.free)
    # None at the instant of the start, where the clock's derivative has a corner.
    times = np.linspace(0.02, 1.0, 30) * case.share * scene.run.duration
    return ForwardModel(scene, free, times, backend, case.rtol)


def _point(model: ForwardModel) -> np.ndarray:
    """Somewhere near the typical values, but not there; the camera's clock before the first of its times."""
    return model.typical + 0.01 * np.cos(np.arange(len(model.names)))


def _size(model: ForwardModel) -> float:
    return float(np.max(np.abs(model.midpoints(_point(model)))))


@pytest.mark.parametrize("name", CASES)
def test_both_solvers_and_differences(name: str) -> None:
    """Each derivative three ways, over the largest: in C, by whole runs of the interpreted backend, by differences."""
    compiled, interpreted = _model(name, "compiled"), _model(name, "interpreted")
    q = _point(compiled)
    slopes, interpreted_slopes = compiled.with_derivatives(q)[1], interpreted.with_derivatives(q)[1]
    differences = np.stack([_richardson(compiled, q, unit) for unit in np.eye(len(q))], axis=1)
    largest = np.max(np.abs(slopes), axis=0)
    between = np.max(np.abs(slopes - interpreted_slopes), axis=0) / largest
    against = np.max(np.abs(slopes - differences), axis=0) / largest
    rows = [
        [one, *(f"{value:.1e}" for value in (size / _size(compiled), *errors))]
        for one, size, *errors in zip(compiled.names, largest, between, against, strict=True)
    ]
    header = ("unknown", "derivative / sag", "compiled - interpreted", "compiled - differences")
    show(f"{name}, rtol {CASES[name].rtol:g}", header, rows)
    # Of the largest sag: the modulus of a filament that flows down hardly matters, and fibres yield at kinks.
    # The interpreted backend has differences of whole runs, which carry the error of its steps.
    assert np.all(between * largest < 1e-3 * _size(compiled))
    assert np.all(against * largest < 1e-5 * _size(compiled))


def _richardson(model: ForwardModel, q: np.ndarray, unit: np.ndarray) -> np.ndarray:
    """Central differences extrapolated from two steps."""
    coarse, fine = ((model.midpoints(q + h * unit) - model.midpoints(q - h * unit)) / (2 * h) for h in (2e-3, 1e-3))
    return np.asarray((4 * fine - coarse) / 3)
