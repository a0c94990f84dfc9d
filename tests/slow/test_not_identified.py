"""What films cannot tell is called so: a verdict and, where there is one, the combination; never a number alone.

Films of the overdamped limit (no inertia), in which the groups that the motion depends on are known exactly.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError
from softcat_sym.fitting.fit import fit
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.result import Fit, FitOutcome
from tests.common.draws import draws, misses
from tests.common.fitting import is_noise
from tests.common.table import show

OVERDAMPED = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow"]
YIELDING = [*OVERDAMPED, "yielding", "gravity-ramp"]
FRAMES, NOISE = 60, 0.01

pytestmark = pytest.mark.slow


@dataclass(frozen=True)
class Case:
    """A film, what is asked of it, and what it can tell."""

    scene: str
    effects: list[str]
    free: tuple[str, ...]
    words: tuple[str, ...]
    combination: Mapping[str, float]
    begin: float = 0.0


IS, ONE, NOT = "identified", "one-sided", "not identified"

CASES = {
    # The film begins 100 relaxation times after the release, in the 1/3 law.
    "E of a relaxed filament": Case(
        "maxwell-fast", OVERDAMPED, ("youngs_modulus", "viscosity"), (ONE, IS), {}, begin=0.2
    ),
    # A low yield stress is hardly ruled out where the viscosity may be so large that nothing flows in time.
    "eta and sY below yield": Case(
        "no-yield", YIELDING, ("youngs_modulus", "viscosity", "yield_stress"), (IS, NOT, f"{ONE} or {NOT}"), {}
    ),
    "sY of one that never yields": Case("no-yield", YIELDING, ("yield_stress",), (ONE,), {}),
    "eta, density and gravity": Case(
        "continual-descent",
        YIELDING,
        ("viscosity", "density", "gravity"),
        (IS, NOT, NOT),
        {"density": 1, "gravity": 1},
    ),
    # Too dense a filament would show its elasticity, so that there is a largest one. Whether both profiles get that far
    # within their evaluations differs by where along the flat direction the optimum of the draws lies.
    "eta and density, creeping": Case(
        "maxwell-fast",
        OVERDAMPED,
        ("viscosity", "density"),
        (f"{ONE} or {NOT}", f"{ONE} or {NOT}"),
        {"viscosity": 1, "density": -1},
        begin=0.2,
    ),
}


@cache
def _scene(name: str, effects: tuple[str, ...]) -> sc.Scene:
    return sc.load_scene(name, {"run.effects": list(effects), "run.frames": 401})


@cache
def _fit(name: str) -> Fit:
    case = CASES[name]
    scene = _scene(case.scene, tuple(case.effects))
    run, random = sc.simulate(scene).data, draws(5)
    time = np.linspace(case.begin, 1.0, FRAMES + 1)[1:] * scene.run.duration
    exact = np.interp(time, run.time.values, run.midpoint.values)
    film = Measurements.of(time, exact + NOISE * np.max(np.abs(exact)) * random.standard_normal(FRAMES))
    return fit(film, scene, case.free, starts=0, calibrated=True, discrepancy=False)


@pytest.mark.statistical
@pytest.mark.parametrize("name", CASES)
def test_what_a_film_cannot_tell_is_said(name: str) -> None:
    case, found = CASES[name], _fit(name)
    rows = [
        [name, one.name, one.verdict, one.value, f"{one.typical:.4g}", *one.ci95, "; ".join(found.combinations)]
        for one in found.parameters.values()
    ]
    show("", ["film", "free", "verdict", "value", "true", "least", "largest", "identified instead"], rows)
    for one, words in zip(found.parameters.values(), case.words, strict=True):
        assert one.verdict in words.split(" or "), one.name
    assert is_noise(found)
    # By where the optimum of the draws lies, the grid may be worth a third of a standard error.
    outcomes = FitOutcome.not_identified, FitOutcome.discretization_error
    assert found.outcome in outcomes or found.checks.verdict != "white"
    for one in found.parameters.values():
        low, high = one.ci95
        assert (one.value is not None) == (one.verdict == IS)
        assert (low is None) + (high is None) == {IS: 0, ONE: 1, NOT: 2}[one.verdict]
        # Whatever ends are given, the truth lies within.
        assert not misses(one.best, one.ci95, one.typical, FRAMES - 2)
        assert bool(one.reason) == (one.verdict != IS)


@pytest.mark.statistical
@pytest.mark.parametrize("name", CASES)
def test_the_combination_that_is_identified(name: str) -> None:
    case, found = CASES[name], _fit(name)
    combined = found.information.combinations
    if not case.combination:
        # How little the flow feels of E differs by where along the flat direction the optimum of the draws lies.
        assert all(min(map(abs, one.exponents)) < 0.02 for one in combined)
        return
    assert len(combined) == 1
    # Beside the flow there is still some elasticity, at most a hundredth between the ends of the intervals.
    exponents = dict(zip(combined[0].names, combined[0].exponents, strict=True))
    assert exponents == pytest.approx(case.combination, abs=0.02)
    typical = {one.name: one.typical for one in found.parameters.values()}
    truth = float(np.prod([typical[key] ** power for key, power in exponents.items()]))
    value, low, high = combined[0].product([typical[key] for key in combined[0].names])
    assert not misses(value, (low, high), truth, FRAMES - 2)
    assert high < 1.05 * low
    assert combined[0].text in found.combinations[0]
    for key in case.combination:
        assert combined[0].text in found.parameters[key].reason


@pytest.mark.parametrize("name", ["poisson", "width"])
def test_what_does_nothing_is_refused(name: str) -> None:
    scene = _scene("continual-descent", tuple(YIELDING))
    time = np.linspace(0.1, scene.run.duration, FRAMES)
    film = Measurements.of(time, -0.02 * np.cbrt(time))
    with pytest.raises(SceneError, match=f"free {name}: makes no difference with the effects in force"):
        fit(film, scene, ["viscosity", name], starts=0)
