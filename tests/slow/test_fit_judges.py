"""Fits of films that this program did not make: the plain oracle, the finite elements, wild points.

``python -m pytest -m slow -s tests/slow/test_fit_judges.py`` prints the tables.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.fit import fit
from softcat_sym.fitting.least_squares import LINEAR, Loss
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.result import Fit, FitOutcome
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.scene.scene import Scene, elastic_time, groups_of
from tests.common import rk4_filament
from tests.common.draws import draws, errors_away
from tests.common.elements import elements, name_of, plane
from tests.common.filaments import scene as paper_filament
from tests.common.fitting import CONSTANTS, FITTED, WRONG, beside, constants, film, noisy, rows_of
from tests.common.table import show

pytestmark = pytest.mark.slow

FRAMES = 200
EXACT: dict[str, Any] = {"calibrated": True, "discrepancy": False}
"""Camera and theory are those of the data, or it is to be seen that they are not."""
MESH = Mesh(96, 6)
ROBUST = Loss("soft-l1", 1.0), Loss("cauchy", 1.0)
WITHIN = 0.01
"""Of the truth: what is asked where the data are those of the same equations."""


@dataclass(frozen=True)
class Told:
    """A filament of which the oracle tells: the law, its constants that are asked for, and its scene."""

    law: rk4_filament.Law
    asked: tuple[str, ...]
    scene: Scene


def _told(name: str) -> Told:
    changes: dict[str, object] = {"run.effects": "paper", "numerics.cells": 40, "numerics.grading": 1.0}
    if name in ("arrested-overdamped", "continual-descent"):
        return Told("bingham", CONSTANTS, sc.load_scene(name, changes))
    # It rings some ten times, and creeps five relaxation times.
    string = {"span": 0.2, "thickness": 0.006, "density": 1900.0, "gravity": 9.81, "E": 4e6, "eta": 5e5}
    return Told("maxwell", CONSTANTS[:2], paper_filament(**string, ramp=0.04, duration=0.8, grading=1.0))


def _oracle(told: Told) -> tuple[np.ndarray, np.ndarray]:
    """Times [s] and heights [m] of the oracle, on 40 equal cells."""
    scene, groups = told.scene, groups_of(told.scene)
    assert groups.V is not None
    assert groups.E_star is not None
    unit = elastic_time(scene)
    G = groups.G or 1.0
    end = scene.run.duration / unit
    found = rk4_filament.run(
        groups.delta,
        G,
        groups.V,
        1 / (G * groups.E_star),
        told.law,
        "material",
        40,
        end,
        g_on=scene.load.ramp / unit,
        outputs=np.linspace(0, end, FRAMES + 1)[1:].tolist(),
    )
    return found.times * unit, found.midpoint * scene.filament.span


def _fit(told: Told, time: np.ndarray, midpoint: np.ndarray, std: float) -> Fit:
    data = Measurements.of(time, midpoint, std)
    start = beside(told.scene, {name: WRONG[name] for name in told.asked})
    return fit(data, start, told.asked, starts=0, profiles=False, **EXACT)


@pytest.mark.parametrize("noise", [0.0, 1e-3])
@pytest.mark.parametrize("name", ["Maxwell", "arrested-overdamped", "continual-descent"])
def test_constants_of_the_oracle_are_recovered(name: str, noise: float) -> None:
    """Goal: within 1 %, of what is identified.

    Another program with section integrals of its own and steps that are all alike; its cells are 40 and equal, and so
    are the model's, for what equal cells err by are some parts in a thousand. The modulus of the filament that flows
    down is known to 3 % only if a thousandth of its sag is noise: there it is not asked for.
    """
    told = _told(name)
    time, exact = _oracle(told)
    midpoint, std = noisy(exact, noise)
    # Without noise a thousandth is stated as well: estimated from what is left it would be that of the integrators.
    found = _fit(told, time, midpoint, std if noise else 1e-3 * float(np.max(np.abs(exact))))
    truth = constants(told.scene, told.asked)
    rows = rows_of(f"{100 * noise:g} %", found, truth)
    left = float(np.max(np.abs(found.films[0].model - exact)) / np.max(np.abs(exact)))
    show(
        f"{name} of the oracle, {FRAMES} points; model apart from it by {left:.1e}; {found.outcome.name}", FITTED, rows
    )
    assert found.outcome.converged
    for key, one in found.parameters.items():
        # What noise alone throws about by more than half of the goal is not asked for.
        if one.std is None or (noise and one.std / one.best > WITHIN / 2):
            continue
        assert abs(one.best / truth[key] - 1) < WITHIN, key
    asked_for = [one for one in told.asked if one != "youngs_modulus"]
    assert all(abs(found.parameters[key].best / truth[key] - 1) < WITHIN for key in asked_for)


@pytest.mark.parametrize("noise", [0.0, 1e-4, 1e-2])
def test_elements_give_viscosity_and_yield_stress(noise: float) -> None:
    """Goal: eta and sY of continual-descent within 5 %, E known; and "model error" where noise does not hide it.

    The filament has the physics that the program chooses, shear and fibres among them; the elements are the plane
    continuum.
    """
    scene = plane("continual-descent")
    run = elements(scene, MESH)
    midpoint, std = noisy(run.midpoint[1:], noise)
    truth = constants(scene, CONSTANTS[1:])
    start = beside(scene, {name: WRONG[name] for name in truth})
    found = fit(
        Measurements.of(run.time[1:], midpoint, std if noise else None),
        start,
        tuple(truth),
        starts=0,
        profiles=False,
        **EXACT,
    )
    smallest = min((one.p_value for one in found.checks.tests), default=math.nan)
    said = (
        f"{found.outcome.name}, residuals {found.checks.verdict} (p = {smallest:.0e}), rms {found.noise * 1e6:.3g} um"
    )
    show(
        f"elements {name_of(MESH)}, {100 * noise:g} % noise, {', '.join(found.effects)}: {said}",
        FITTED,
        rows_of(f"{100 * noise:g} %", found, truth),
    )
    for key, one in found.parameters.items():
        assert abs(one.best / truth[key] - 1) < 0.05, key
    if noise < 1e-3:
        assert found.outcome is FitOutcome.model_error


@pytest.mark.statistical
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_robust_losses_withstand_wild_points(seed: int) -> None:
    """One point of twenty is up to half of the largest sag too low: within what noise does."""
    scene = sc.load_scene("continual-descent", {"run.effects": "paper", "numerics.cells": 40})
    clean = film(scene, FRAMES, 0.01, seed).series[0]
    random = draws(100 + seed)
    wild = random.choice(clean.time.size, clean.time.size // 20, replace=False)
    midpoint = clean.midpoint.copy()
    midpoint[wild] -= 0.5 * np.max(np.abs(midpoint)) * random.random(wild.size)
    data = Measurements.of(clean.time, midpoint, clean.std)
    asked = CONSTANTS[1:]
    truth = constants(scene, asked)
    start = beside(scene, {name: WRONG[name] for name in asked})
    rows, far, outcome = [], {}, {}
    for loss in (LINEAR, *ROBUST):
        found = fit(data, start, asked, loss=loss, starts=0, profiles=False, **EXACT)
        rows += rows_of(loss.kind, found, truth)
        outcome[loss.kind] = found.outcome
        far[loss.kind] = max(
            abs(np.log(one.best / truth[key])) * one.best / one.std for key, one in found.parameters.items() if one.std
        )
    show(f"continual-descent, 1 % noise, {wild.size} of {FRAMES} points wild", FITTED, rows)
    # By 0.05 E psi(wild)/(0.95 E psi') wild points, which lie to one side, move all readings alike; of that a constant
    # takes up sqrt(n)/(sqrt(E psi^2)/E psi') standard errors at most: 1.2 with soft-l1, 0.1 with cauchy.
    for loss in ROBUST:
        assert far[loss.kind] < errors_away() + _one_sided(loss), loss
    # Linear, how far constants are off is chance. That it is said is not: two outliers are enough, and with each of ten
    # beyond six deviations nine times in ten, fewer are found once in 2e7 films.
    assert outcome["linear"] is FitOutcome.outliers


def _one_sided(loss: Loss) -> float:
    """Standard errors of a shift of all readings that one wild point of twenty, up to 50 deviations off, is worth."""
    z, off = np.linspace(-10, 10, 20001), np.linspace(0, 50, 20001)
    density = np.exp(-0.5 * z**2) / np.sqrt(2 * np.pi)
    psi = loss.weights(z) * z
    wild = np.mean(loss.weights(off) * off)
    return float(0.05 / 0.95 * wild * np.sqrt(FRAMES / np.trapezoid(psi**2 * density, z)))
