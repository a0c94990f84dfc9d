"""Fits of films that this program did not make, or that a camera falsified: the plain oracle, elements, wild points.

What fits once said wrongly with a narrow interval is fitted by default, and its intervals hold the truth now.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.fit import fit
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.result import FitOutcome
from softcat_sym.scene.scene import Scene, elastic_time, groups_of
from tests.common import element_films, rk4_filament
from tests.common.draws import draws, misses
from tests.common.elements import Floats
from tests.common.filaments import scene as paper_filament
from tests.common.fitting import CONSTANTS, FITTED, WRONG, beside, constants, film, is_sound, noisy, rows_of
from tests.common.table import show

pytestmark = pytest.mark.slow

FRAMES = 200
EXACT: dict[str, Any] = {"calibrated": True, "discrepancy": False}
"""Camera and theory are those of the data, or it is to be seen that they are not."""
DESCENT, ARREST = "continual-descent", "arrested-overdamped"


def by_oracle(scene: Scene, law: rk4_filament.Law) -> tuple[Floats, Floats]:
    """Times [s] and heights [m] of the oracle: 40 equal cells, section integrals and steps of its own."""
    groups, unit = groups_of(scene), elastic_time(scene)
    assert groups.V is not None and groups.E_star is not None
    G, end = groups.G or 1.0, scene.run.duration / unit
    outputs = np.linspace(0, end, FRAMES + 1)[1:].tolist()
    ramp, strain = {"g_on": scene.load.ramp / unit, "outputs": outputs}, 1 / (G * groups.E_star)
    found = rk4_filament.run(groups.delta, G, groups.V, strain, law, "material", 40, end, **ramp)
    return found.times * unit, found.midpoint * scene.filament.span


@pytest.mark.parametrize(("name", "noise"), [("Maxwell", 0.0), (ARREST, 0.0), (DESCENT, 1e-3)])
def test_constants_of_the_oracle_are_recovered(name: str, noise: float) -> None:
    """Within 1 %, of what is identified; of the descent the modulus is known to 3 % with this noise.

    The model's cells are 40 and equal too, for what equal cells err by are some parts in a thousand.
    """
    law: rk4_filament.Law = "maxwell" if name == "Maxwell" else "bingham"
    if law == "maxwell":  # It rings some ten times, and creeps five relaxation times.
        string = {"span": 0.2, "thickness": 0.006, "density": 1900.0, "gravity": 9.81, "E": 4e6, "eta": 5e5}
        scene, free = paper_filament(**string, ramp=0.04, duration=0.8, grading=1.0), CONSTANTS[:2]
    else:
        changes = {"run.effects": "paper", "numerics.cells": 40, "numerics.grading": 1.0}
        scene, free = sc.load_scene(name, changes), CONSTANTS
    time, exact = by_oracle(scene, law)
    midpoint, std = noisy(exact, noise)
    # Without noise a thousandth is stated as well: estimated from what is left it would be that of the integrators.
    data = Measurements.of(time, midpoint, std if noise else 1e-3 * float(np.max(np.abs(exact))))
    start = beside(scene, {key: WRONG[key] for key in free})
    found = fit(data, start, free, starts=0, profiles=False, **EXACT)
    truth = constants(scene, free)
    show(f"{name} of the oracle; {found.outcome.name}", FITTED, rows_of(f"{noise:.1%}", found, truth))
    assert found.outcome.converged
    for key, one in found.parameters.items():
        if key != "youngs_modulus" or not noise:
            assert abs(one.best / truth[key] - 1) < 0.01, key


def test_elements_are_no_filament_and_the_fit_says_so() -> None:
    """Without noise, and with a theory taken for exact; viscosity and yield stress are within 5 % all the same."""
    scene, time, heights = element_films.film(DESCENT)
    truth = constants(scene, CONSTANTS[1:])
    start = beside(scene, {name: WRONG[name] for name in truth})
    found = fit(Measurements.of(time, heights), start, tuple(truth), starts=0, profiles=False, **EXACT)
    show(found.outcome.name, FITTED, rows_of("elements", found, truth))
    assert all(abs(one.best / truth[key] - 1) < 0.05 for key, one in found.parameters.items())
    assert found.outcome is FitOutcome.model_error


@dataclass(frozen=True)
class Seen:
    """A film of which the truth is known, and how it is fitted."""

    scene: Scene
    data: Measurements
    profiles: bool = False  # Where the curvature at the optimum does not tell how flat the likelihood is


def _ink() -> Seen:
    """Once eta was 43.0 +- 1.2 for 30, "identified"."""
    scene = sc.load_scene("ink-bridge")
    run = sc.simulate(scene).data
    heights = run.midpoint.values[1:]
    noise = 1.5e-6 * draws(0).standard_normal(heights.size)
    return Seen(scene, Measurements.of(run.time.values[1:], heights + noise), profiles=True)


def _of_oracle(name: str) -> Seen:
    """Without noise; once eta was off by +1.1 to +3.6 %, sY by -0.4 to -1.5 %."""
    scene = sc.load_scene(name, {"run.effects": "paper"})
    return Seen(scene, Measurements.of(*by_oracle(scene, "bingham")))


def _by_camera(scale: float, shift: float) -> Seen:
    scene = sc.load_scene(DESCENT, {"run.effects": "paper"})
    clean = film(scene, FRAMES, 0.005, seed=1).series[0]
    largest = float(np.max(np.abs(clean.midpoint)))
    return Seen(scene, Measurements.of(clean.time, scale * clean.midpoint - shift * largest))


def _wild() -> Seen:
    """One reading of ten is up to half of the largest sag too low."""
    scene = sc.load_scene(DESCENT, {"run.effects": "paper"})
    clean, random = film(scene, FRAMES, 0.01, seed=2).series[0], draws(3)
    wild, midpoint = random.choice(FRAMES, FRAMES // 10, replace=False), clean.midpoint.copy()
    midpoint[wild] -= 0.5 * np.max(np.abs(midpoint)) * random.random(wild.size)
    return Seen(scene, Measurements.of(clean.time, midpoint))


CASES: dict[str, Callable[[], Seen]] = {
    "oracle, arrested-overdamped": lambda: _of_oracle(ARREST),
    "scaled by 2 %": lambda: _by_camera(1.02, 0.0),
    "shifted by 2 % of the sag": lambda: _by_camera(1.0, 0.02),
    "10 % wild": _wild,
    "ink-bridge, 1.5 um": _ink,
}


@pytest.mark.statistical
@pytest.mark.parametrize("name", CASES)
def test_intervals_hold_the_truth_or_it_is_said(name: str) -> None:
    seen, asked = CASES[name](), CONSTANTS[1:]
    start = beside(seen.scene, {key: WRONG[key] for key in asked})
    found = fit(seen.data, start, asked, profiles=seen.profiles)
    truth = constants(seen.scene, asked)
    show(f"{name}: {found.outcome.word}", FITTED, rows_of(name, found, truth))
    if name.endswith("wild"):
        # Twenty readings are off by up to fifty standard deviations.
        assert found.outcome is FitOutcome.outliers
        return
    for key, one in found.parameters.items():
        # Where nothing is drawn the interval itself holds it.
        low, high = one.ci95
        within = (low is None or low <= truth[key]) and (high is None or truth[key] <= high)
        assert within if name.startswith("oracle") else not misses(one.best, one.ci95, truth[key], FRAMES - 6), key
    # Residuals that are noise are called otherwise once in a hundred.
    sound = found.outcome is FitOutcome.model_error and is_sound(found)
    assert sound or found.outcome in (FitOutcome.solved, FitOutcome.not_identified, FitOutcome.discretization_error)
