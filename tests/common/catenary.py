"""A synthetic run: a catenary that grows under a stress field known in closed form."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import pytest

from softcat_sym.scene.bodies import Floor, Pillars
from softcat_sym.scene.ends import Ends
from softcat_sym.scene.extrusion import Extrusion

Fields = dict[str, np.ndarray]


@dataclass(frozen=True)
class Filament:
    span: float = 0.2
    thickness: float = 6e-3
    density: float = 1900.0


@dataclass(frozen=True)
class Material:
    law: str = "bingham"
    youngs_modulus: float | None = 4e6
    yield_stress: float | None = 9.32e3


@dataclass(frozen=True)
class Load:
    gravity: float = 9.81


@dataclass(frozen=True)
class Run:
    accuracy: float = 1e-3


@dataclass(frozen=True)
class Scene:
    title: str = "Growing catenary"
    filament: Filament = field(default_factory=Filament)
    material: Material = field(default_factory=Material)
    load: Load = field(default_factory=Load)
    ends: Ends = field(default_factory=lambda: Ends(left="pinned", right="pinned"))
    run: Run = field(default_factory=Run)
    floor: Floor = field(default_factory=Floor)
    pillars: Pillars = field(default_factory=Pillars)
    extrusion: Extrusion = field(default_factory=Extrusion)


def catenary(sag: float, span: float, x: np.ndarray) -> np.ndarray:
    """Heights of the catenary through the supports with this midpoint sag."""
    if sag <= 0:
        return np.zeros_like(x)
    low, high = 1e-6 * span, 1e6 * span
    for _ in range(200):
        middle = np.sqrt(low * high)
        deep = 2 * middle * np.sinh(min(span / (4 * middle), 300.0)) ** 2 > sag
        low, high = (middle, high) if deep else (low, middle)
    return 2 * high * (np.sinh(x / (2 * high)) ** 2 - np.sinh(span / (4 * high)) ** 2)


def run_of(scene: Scene, sags: np.ndarray, times: np.ndarray, cells: int = 160) -> Fields:
    """Nodes sink vertically along catenaries, thinning as h0 s^-1/2.

    The stress is yield * (u + 2 u c(X) zeta) with u the sag over the largest and c = 2 (2X/L)^6 - 0.4, so that the ends
    bend up and the middle down.
    """
    span, limit = scene.filament.span, scene.material.yield_stress or 1e4
    X = np.linspace(-span / 2, span / 2, cells + 1)
    Xc = 0.5 * (X[1:] + X[:-1])
    y = np.array([catenary(sag, span, X) for sag in sags])
    x = np.broadcast_to(X, y.shape)
    stretch = np.hypot(np.diff(x), np.diff(y)) / np.diff(X)
    share = (sags / max(float(sags.max()), 1e-300))[:, None] * np.ones_like(stretch)
    mean = limit * share
    bending = 2 * limit * share * (2 * (2 * Xc / span) ** 6 - 0.4)
    with np.errstate(divide="ignore", invalid="ignore"):
        lower, upper = (-limit - mean) / np.abs(bending), (limit - mean) / np.abs(bending)
    core = np.clip(upper, -1, 1) - np.clip(lower, -1, 1)
    fraction = np.where(bending == 0, np.abs(mean) > limit, 1 - 0.5 * core)
    potential, dissipated = -1e-3 * sags / span, 6e-4 * sags / span
    elastic, kinetic = 1e-4 * np.sqrt(sags / span), 3e-4 * sags / span * np.exp(-times / (times[-1] / 5 + 1e-30))
    residual = 1e-8 * np.sin(np.linspace(0, 9, sags.size))
    per_cell = {"thickness": scene.filament.thickness / np.sqrt(stretch), "stress_mean": mean}
    per_cell |= {"stress_bending": bending, "yielded_fraction": fraction, "plastic_rate": 1.0 * (fraction > 0)}
    energies = {"energy_kinetic": kinetic, "energy_elastic": elastic, "energy_potential": potential}
    energies |= {
        "energy_dissipated": dissipated,
        "energy_gradient": 0 * dissipated,
        "energy_surface": 0 * dissipated,
        "work_external": kinetic + elastic + potential + dissipated - residual,
    }
    places = {"time": times, "X_node": X, "X_cell": Xc, "x": x.copy(), "y": y, "midpoint": -sags.astype(float)}
    return {**places, "stretch": stretch, **per_cell, **energies}


@pytest.fixture
def scene() -> Scene:
    return Scene()


@pytest.fixture
def make_scene() -> Callable[..., Scene]:
    def make(
        title: str = "", span: float = 0.2, thickness: float = 6e-3, law: str = "bingham", limit: float | None = 9.32e3
    ) -> Scene:
        return Scene(title, Filament(span, thickness), Material(law, 4e6, limit))

    return make


@pytest.fixture
def make_run() -> Callable[..., Fields]:
    return run_of


@pytest.fixture
def descent(scene: Scene) -> Fields:
    """A quarter of the span in two seconds, slower and slower."""
    times = np.linspace(0, 2, 201)
    return run_of(scene, 0.25 * scene.filament.span * (1 - np.exp(-3 * times)) / (1 - np.exp(-6)), times)


@pytest.fixture
def summary() -> dict[str, object]:
    return {
        "outcome": "solved",
        "advice": "the whole run was integrated; no check refuses the answer",
        "regime": "descending",
        "midpoint_final_m": -0.05,
        "error_estimate": None,
        "energy_residual": 2.5e-5,
        "effects": {"inertia": "always", "yielding": "the law yields [at 9.32 kPa]"},
        "left_out": {"shear": 0.021},
        "cells": 80,
        "solver": "cvodes",
        "backend": "interpreted",
        "wall_s": {"build": 0.5, "compile": 0.0, "solve": 0.21, "estimate": 0.0, "write": 0.9, "total": 1.61},
        "warnings": ["surface tension: Ca = 0.3"],
    }
