"""Which law: ranking by hand, rough constants, laws that contain others, fits of several."""

from __future__ import annotations

import math

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.fitting.criterion import charge
from softcat_sym.fitting.free_parameters import free_parameters
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.model_selection import (
    FITTED,
    FittedLaw,
    choose_model,
    fit_laws,
    rough_constants,
    scene_of_law,
)
from softcat_sym.scene.laws import LAWS
from tests.common.draws import draws


def test_criteria_by_hand_with_known_noise() -> None:
    choice = choose_model([FittedLaw("two", 2, 70.0), FittedLaw("three", 3, 50.0)], 50, noise_known=True)
    best, other = choice.table
    assert (best.law.name, other.law.name) == ("three", "two")
    # Nothing is corrected for few data where the noise is known.
    assert best.criterion == best.aic == 56.0
    assert best.bic == pytest.approx(50 + 3 * math.log(50))
    assert other.difference == pytest.approx(74 - 56)
    assert best.weight + other.weight == pytest.approx(1.0)
    assert other.weight / best.weight == pytest.approx(math.exp(-0.5 * other.difference))
    assert choice.verdict == "three"


def test_close_laws_cannot_be_told_apart() -> None:
    def verdict(squares: float, independent: float = 1.0) -> str:
        laws = [FittedLaw("a", 2, 50.0), FittedLaw("b", 2, squares)]
        return choose_model(laws, 50, noise_known=True, independent=independent).verdict

    assert (verdict(59.9), verdict(60.1)) == ("cannot tell", "a")
    # Readings that go with their neighbours say less.
    assert (verdict(60.1, 0.5), verdict(69.9, 0.5), verdict(70.1, 0.5)) == ("cannot tell", "cannot tell", "a")


def test_exact_data_rank_the_fewest_constants_first() -> None:
    choice = choose_model([FittedLaw("a", 3, 1e-30), FittedLaw("b", 2, 1e-28)], 50, noise_known=False)
    assert choice.table[0].law.name == "b"


@pytest.mark.statistical
@pytest.mark.parametrize("points", [7, 60])
def test_the_true_law_is_hardly_ever_ruled_out(points: int) -> None:
    x = np.linspace(-1, 1, points)
    random = draws(7)
    names = ("newtonian", "maxwell", "bingham")  # Each contains the one before
    verdicts = []
    for _ in range(300):
        data = 1 + 2 * x + 0.1 * random.standard_normal(points)
        laws = [
            FittedLaw(name, n + 1, float(np.sum((np.polyval(np.polyfit(x, data, n), x) - data) ** 2)))
            for n, name in enumerate(names)
        ]
        verdicts.append(choose_model(laws, points, noise_known=False).verdict)
    # Of 6000 sets none was newtonian (a slope of 26 standard errors), 4 at most bingham, and 68.5 % maxwell, that a
    # third constant was not close to: the chance of six of 300 is (0.2)^6/6!, of less than half below 1e-10.
    assert verdicts.count("newtonian") == 0
    assert verdicts.count("bingham") < 0.02 * 300
    assert verdicts.count("maxwell") > 0.5 * 300


PLAIN = {"run.effects": "paper", "numerics.cells": 6}
TIME = np.linspace(0.05, 2.0, 40)
FILM = Measurements.of(TIME, -0.012 * np.cbrt(TIME))


def _scene(law: str, **more: object) -> sc.Scene:
    own = {"youngs_modulus": "4 MPa", "second_modulus": "1 MPa", "viscosity": "9 kPa*s", "yield_stress": "8 kPa"}
    changes: dict[str, object] = {f"material.{name}": None for name in own} | {"material.law": law}
    changes |= {f"material.{name}": own[name] for name in LAWS[law].constants}
    if law in ("power-law", "herschel-bulkley"):
        changes |= {"material.index": 0.6, "material.viscosity": "9 kPa*s^0.6"}
    return sc.load_scene("continual-descent", PLAIN).replace({**changes, **more})


@pytest.mark.parametrize("law", FITTED)
@pytest.mark.parametrize("former", FITTED)
def test_every_law_can_take_the_place_of_every_other(former: str, law: str) -> None:
    before = _scene(former)
    after = scene_of_law(before, law, FILM)
    assert after.material.law == law
    assert (after.filament, after.load, after.ends, after.run) == (
        before.filament,
        before.load,
        before.ends,
        before.run,
    )
    names = [*LAWS[law].constants, *(["index"] if LAWS[law].has_index else [])]
    # What a fit frees exists, and is positive; what the law does not use is gone.
    assert [one.name for one in free_parameters(after, names)] == names
    unused = {"youngs_modulus", "second_modulus", "viscosity", "yield_stress"} - {*LAWS[law].constants}
    assert all(getattr(after.material, name) is None for name in unused)
    for name in LAWS[law].constants:
        own = getattr(before.material, name)
        if own is not None and (name != "viscosity" or before.material.index == after.material.index):
            assert getattr(after.material, name) == pytest.approx(own)


def test_rough_constants_are_of_the_right_order() -> None:
    """Of scenes whose constants are known, from what their own runs show: within the factor of the default bounds."""
    for name, law in (("maxwell-slow", "maxwell"), ("maxwell-fast", "maxwell"), ("continual-descent", "bingham")):
        scene = sc.load_scene(name, PLAIN | {"run.frames": 41})
        run = sc.simulate(scene).data
        film = Measurements.of(run.time.values[1:], run.midpoint.values[1:])
        rough = rough_constants(scene, film, law)
        for constant in LAWS[law].constants:
            assert 1 / 100 < rough[constant] / getattr(scene.material, constant) < 100, (name, constant)
    # The viscosity of what nothing else holds is within a factor of two.
    assert 0.5 < rough_constants(scene, film, "newtonian")["viscosity"] / scene.material.viscosity < 2


def _fallen(law: str, noise: float, outliers: int = 0) -> tuple[sc.Scene, Measurements]:
    scene = _scene(law, **{"run.frames": 61})
    # The overdamped limit is quick to follow.
    effects = [name for name in choose_effects(scene).names if name != "inertia"]
    scene = scene.replace({"run.effects": effects})
    run, random = sc.simulate(scene).data, draws(3)
    height = run.midpoint.values[1:]
    height = height + noise * np.max(np.abs(height)) * random.standard_normal(height.size)
    height[random.choice(height.size, outliers, replace=False)] *= 0.6
    return scene, Measurements.of(run.time.values[1:], height)


@pytest.mark.slow
@pytest.mark.statistical
def test_a_film_of_a_bingham_filament() -> None:
    scene, film = _fallen("bingham", 0.01)
    # Without a camera and a theory that may err, which would count beside the residuals.
    found = fit_laws(film, scene, ["newtonian", "bingham"], starts=0, calibrated=True, discrepancy=False)
    assert found.choice.verdict == "bingham"
    assert found.sentence.startswith("the films speak for bingham")
    assert not found.failures
    # The criterion by hand, up to what is common to both laws; the noise is found to a thousandth.
    ranked = {row.law.name: row for row in found.choice.table}
    seen = film.series[0].midpoint
    squares = {name: float(np.sum((one.films[0].model - seen) ** 2)) for name, one in found.fits.items()}
    gained = 60 * math.log(squares["newtonian"] / squares["bingham"])
    assert ranked["newtonian"].aic - ranked["bingham"].aic == pytest.approx(gained - 4, rel=1e-3)
    charged = charge(60, 2) + charge(60, 3)
    assert ranked["newtonian"].criterion - ranked["bingham"].criterion == pytest.approx(gained - charged, rel=1e-3)
