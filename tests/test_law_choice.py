"""Which law: ranking by hand, rough constants, laws that contain others, fits of several."""

from __future__ import annotations

import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.fitting.fit import FitOutcome
from softcat_sym.fitting.free_parameters import free_parameters
from softcat_sym.fitting.least_squares import Loss
from softcat_sym.fitting.measurements import Measurements, Series, Shapes
from softcat_sym.fitting.model_selection import (
    FITTED,
    LIMITS,
    FittedLaw,
    LawComparison,
    choose_model,
    fit_law,
    fit_laws,
    rough_constants,
    scene_of_law,
    widened,
)
from softcat_sym.scene.material import CONSTANTS
from tests.marks import few


def test_criteria_by_hand_with_known_noise() -> None:
    choice = choose_model([FittedLaw("two", 2, 60.0), FittedLaw("three", 3, 50.0)], 50, noise_known=True)
    best, other = choice.table
    assert (best.law.name, other.law.name) == ("three", "two")
    assert best.aic == 56.0
    assert best.aicc == pytest.approx(56.0 + 24 / 46)
    assert best.bic == pytest.approx(50 + 3 * math.log(50))
    assert other.difference == pytest.approx(64 + 12 / 47 - best.aicc)
    assert best.weight + other.weight == pytest.approx(1.0)
    assert other.weight / best.weight == pytest.approx(math.exp(-0.5 * other.difference))
    assert choice.verdict == "three"


def test_estimated_noise_is_one_constant_more() -> None:
    (one,) = choose_model([FittedLaw("law", 2, 0.5)], 50, noise_known=False).table
    assert one.aic == pytest.approx(50 * math.log(0.01) + 6)
    assert one.bic == pytest.approx(50 * math.log(0.01) + 3 * math.log(50))


def test_close_laws_cannot_be_told_apart() -> None:
    choice = choose_model([FittedLaw("a", 2, 50.0), FittedLaw("b", 2, 51.9)], 50, noise_known=True)
    assert (choice.verdict, choice.close) == ("cannot tell", ("a", "b"))
    choice = choose_model([FittedLaw("a", 2, 50.0), FittedLaw("b", 2, 52.1)], 50, noise_known=True)
    assert (choice.verdict, choice.close) == ("a", ("a",))


def test_failures_come_last_with_their_reason() -> None:
    laws = [FittedLaw("broken", 1, math.nan, "no optimum was found"), FittedLaw("poor", 2, 1e6)]
    choice = choose_model(laws, 50, noise_known=True)
    assert [row.law.name for row in choice.table] == ["poor", "broken"]
    assert choice.table[-1].law.failure == "no optimum was found"
    assert choice.table[-1].weight == 0.0
    assert choice.verdict == "poor"
    none = choose_model(laws[:1], 50, noise_known=True)
    assert (none.verdict, none.close) == ("cannot tell", ())
    with pytest.raises(SoftcatError, match="one or more"):
        choose_model([], 50, noise_known=True)


def test_too_few_data_for_aicc_are_ranked_by_bic_and_cannot_tell() -> None:
    """Five data: AICc of three constants and the noise is infinite, whatever their fit."""
    laws = [FittedLaw("poor", 1, 300.0), FittedLaw("good", 3, 1.0)]
    choice = choose_model(laws, 5, noise_known=False)
    assert [row.law.name for row in choice.table] == ["good", "poor"]
    assert math.isinf(choice.table[0].aicc) and math.isfinite(choice.table[1].aicc)
    assert choice.table[1].difference == pytest.approx(5 * math.log(300) - 2 * math.log(5))
    assert sum(row.weight for row in choice.table) == pytest.approx(1)
    assert (choice.verdict, choice.criterion, choice.close) == ("cannot tell", "BIC", ("good", "poor"))
    assert choice.reason.startswith("5 data are too few to weigh good by AICc")
    enough = choose_model(laws, 50, noise_known=False)
    assert (enough.verdict, enough.criterion, enough.reason) == ("good", "AICc", "")


def test_exact_data_choose_the_fewest_constants() -> None:
    choice = choose_model([FittedLaw("a", 3, 1e-30), FittedLaw("b", 2, 1e-28)], 50, noise_known=False)
    assert choice.verdict == "b"


def test_the_true_law_is_hardly_ever_ruled_out() -> None:
    x = np.linspace(-1, 1, 60)
    random = np.random.default_rng(7)
    verdicts = []
    for _ in range(300):
        data = 1 + 2 * x + 0.1 * random.standard_normal(60)
        laws = [
            FittedLaw(f"degree {n}", n + 1, float(np.sum((np.polyval(np.polyfit(x, data, n), x) - data) ** 2)))
            for n in (0, 1, 2)
        ]
        verdicts.append(choose_model(laws, 60, noise_known=False).verdict)
    assert verdicts.count("degree 0") == 0
    assert verdicts.count("degree 2") < 0.08 * 300
    assert verdicts.count("degree 1") > 0.3 * 300


PLAIN = {"run.effects": "paper", "numerics.cells": 6}
TIME = np.linspace(0.05, 2.0, 40)
FILM = Measurements.of(TIME, -0.012 * np.cbrt(TIME))


def _scene(law: str, **more: object) -> sc.Scene:
    own = {"youngs_modulus": "4 MPa", "second_modulus": "1 MPa", "viscosity": "9 kPa*s", "yield_stress": "8 kPa"}
    changes: dict[str, object] = {f"material.{name}": None for name in own} | {"material.law": law}
    changes |= {f"material.{name}": own[name] for name in CONSTANTS[law]}
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
    names = [*CONSTANTS[law], *(["index"] if law in ("power-law", "herschel-bulkley") else [])]
    # What a fit frees exists, and is positive; what the law does not use is gone.
    assert [one.name for one in free_parameters(after, names)] == names
    unused = {"youngs_modulus", "second_modulus", "viscosity", "yield_stress"} - {*CONSTANTS[law]}
    assert all(getattr(after.material, name) is None for name in unused)
    for name in CONSTANTS[law]:
        own = getattr(before.material, name)
        if own is not None and (name != "viscosity" or before.material.index == after.material.index):
            assert getattr(after.material, name) == pytest.approx(own)


@pytest.mark.parametrize("law", FITTED)
def test_shear_data_modes_and_formulas_go(law: str) -> None:
    for name in ("polyethylene-melt", "transient-gel", "cold-honey", "toothpaste"):
        after = scene_of_law(sc.load_scene(name), law, FILM)
        assert after.material.law == law
        assert after.material.modes == ()
        assert after.material.flow == ""


def test_rough_constants_are_of_the_right_order() -> None:
    """Of scenes whose constants are known, from what their own runs show: within the factor of the default bounds."""
    for name, law in (("maxwell-slow", "maxwell"), ("maxwell-fast", "maxwell"), ("continual-descent", "bingham")):
        scene = sc.load_scene(name, PLAIN | {"run.frames": 41})
        run = sc.simulate(scene).data
        film = Measurements.of(run.time.values[1:], run.midpoint.values[1:])
        rough = rough_constants(scene, film, law)
        for constant in CONSTANTS[law]:
            assert 1 / 100 < rough[constant] / getattr(scene.material, constant) < 100, (name, constant)
    # The viscosity of what nothing else holds is within a factor of two.
    assert 0.5 < rough_constants(scene, film, "newtonian")["viscosity"] / scene.material.viscosity < 2


def test_rough_constants_of_a_string_and_of_a_beam() -> None:
    """Both limits by hand."""
    slender, stout = _scene("newtonian", **{"filament.thickness": "1 um"}), _scene("newtonian")
    film = Measurements.of(TIME, -1e-3 * TIME)
    span, weight = 0.2, 1900 * 9.81 * 0.2
    string = 3 / 64 * weight * (span / 2e-3) ** 3
    beam = weight * span**3 / (32 * 0.006**2 * 2e-3)
    assert rough_constants(slender, film, "elastic")["youngs_modulus"] == pytest.approx(string, rel=1e-3)
    both = rough_constants(stout, film, "elastic")["youngs_modulus"]
    assert both == pytest.approx(1 / (1 / string + 1 / beam), rel=1e-3)
    assert rough_constants(stout, film, "newtonian")["viscosity"] == pytest.approx(2 * both, rel=1e-12)


def test_without_weight_or_midpoints_there_are_rough_constants_too() -> None:
    shapes = Shapes(TIME, np.linspace(-0.1, 0.1, 40), -0.01 * TIME)
    only_shapes = Measurements((Series(np.empty(0), np.empty(0), None, shapes, {}),))
    weightless = _scene("maxwell", **{"load.gravity": "0 m/s^2"})
    for law in FITTED:
        assert all(0 < value < math.inf for value in rough_constants(weightless, only_shapes, law).values())
    midpoints = Measurements.of(TIME, -0.01 * TIME)
    assert rough_constants(weightless, only_shapes, "bingham") == rough_constants(weightless, midpoints, "bingham")


@pytest.mark.parametrize(
    ("laws", "said"),
    [
        ([], "nothing to compare"),
        (["maxwell"], "nothing to compare"),
        (["maxwell", "maxwell"], "one is named twice"),
        (["maxwell", "maxwel"], "law maxwel: none that can be fitted.*did you mean 'maxwell'"),
        (["maxwell", "custom"], "law custom: none that can be fitted"),
        (["maxwell", "multimode-maxwell"], "law multimode-maxwell: none that can be fitted"),
        (["Bingham"], "(?s)2 faults.*law Bingham.*nothing to compare"),
    ],
)
def test_laws_that_cannot_be_compared(laws: list[str], said: str) -> None:
    with pytest.raises(SceneError, match=said):
        fit_laws(FILM, _scene("bingham"), laws)


def test_what_is_wrong_with_the_films_is_said_once() -> None:
    far = Measurements.of(TIME, 1e3 * FILM.series[0].midpoint)
    with pytest.raises(SoftcatError, match="wrong unit") as caught:
        fit_laws(far, _scene("bingham"), ["newtonian", "maxwell"])
    assert str(caught.value).count("wrong unit") == 1


def test_what_also_is_free_must_be_a_name() -> None:
    with pytest.raises(SoftcatError, match=r"(?s)none of the laws.*newtonian: .*free tmie_offset: unknown.*maxwell: "):
        fit_laws(FILM, _scene("bingham"), ["newtonian", "maxwell"], also_free=["tmie_offset"])


def test_the_sentence() -> None:
    def said(*rows: FittedLaw, points: int = 50) -> str:
        failures = {row.name: row.failure for row in rows if row.failure}
        fits = {
            row.name: SimpleNamespace(checks=SimpleNamespace(verdict="white"), outcome=FitOutcome.solved)
            for row in rows
            if not row.failure
        }
        choice = choose_model(rows, points, noise_known=False)
        return LawComparison(fits, failures, choice).sentence  # type: ignore[arg-type]

    maxwell, newtonian = FittedLaw("maxwell", 2, 1.0), FittedLaw("newtonian", 1, 1.0)
    assert said(maxwell, replace(newtonian, squares=2.0)) == "the films speak for maxwell"
    assert said(maxwell, replace(newtonian, squares=1.04)) == "cannot tell: newtonian, maxwell fit about equally well"
    assert "too few readings" in said(maxwell, newtonian, points=3)
    assert said(maxwell, replace(newtonian, failure="no")) == "only maxwell could be fitted; no fit of newtonian"


@pytest.mark.parametrize("law", FITTED)
@pytest.mark.parametrize("former", FITTED)
def test_a_list_of_effects_follows_the_law(former: str, law: str) -> None:
    """Of published theory without inertia: what the one law has of its own goes, what the other has comes."""
    effects = [name for name in choose_effects(_scene(former)).names if name != "inertia"]
    listed = _scene(former, **{"run.effects": effects})
    found = choose_effects(scene_of_law(listed, law, FILM)).names
    assert {*found} == {*choose_effects(_scene(law)).names} - {"inertia"}


def _fallen(law: str, noise: float, outliers: int = 0) -> tuple[sc.Scene, Measurements]:
    scene = _scene(law, **{"run.frames": 61})
    # The overdamped limit is quick to follow.
    effects = [name for name in choose_effects(scene).names if name != "inertia"]
    scene = scene.replace({"run.effects": effects})
    run, random = sc.simulate(scene).data, np.random.default_rng(3)
    height = run.midpoint.values[1:]
    height = height + noise * np.max(np.abs(height)) * random.standard_normal(height.size)
    height[random.choice(height.size, outliers, replace=False)] *= 0.6
    return scene, Measurements.of(run.time.values[1:], height)


@pytest.mark.slow
def test_a_film_of_a_bingham_filament() -> None:
    scene, film = _fallen("bingham", 0.01)
    found = fit_laws(film, scene, ["newtonian", "bingham"], starts=0)
    assert found.choice.verdict == "bingham"
    assert found.sentence.startswith("the films speak for bingham")
    assert not found.failures
    # The criterion by hand, from the residuals in units of the largest height.
    best = found.choice.table[0]
    unit = float(np.max(np.abs(film.series[0].midpoint)))
    residuals = (found.fits["bingham"].films[0].model - film.series[0].midpoint) / unit
    aic = 60 * math.log(float(residuals @ residuals) / 60) + 2 * 4
    assert best.aic == pytest.approx(aic, rel=1e-9)
    assert best.aicc == pytest.approx(aic + 2 * 4 * 5 / 55, rel=1e-9)


@pytest.mark.slow
def test_a_law_with_too_many_constants_for_the_film_is_not_ruled_out() -> None:
    """With five readings the criterion of three constants is infinite, whatever their squares."""
    scene, film = _fallen("newtonian", 0.001)
    few = Measurements.of(film.series[0].time[::14], film.series[0].midpoint[::14])
    found = fit_laws(few, scene, ["newtonian", "kelvin-voigt"], also_free=["initial_sag"], starts=0)
    assert not found.failures
    assert {row.law.name for row in found.choice.table if math.isinf(row.aicc)} == {"kelvin-voigt"}
    assert found.choice.verdict == "cannot tell"
    both = ", ".join(found.choice.close)
    assert {*found.choice.close} == {"newtonian", "kelvin-voigt"}
    assert found.sentence == f"cannot tell: too few readings to weigh {both} against each other"


@pytest.mark.slow
def test_a_robust_comparison_does_not_follow_outliers() -> None:
    scene, film = _fallen("newtonian", 0.01, outliers=6)
    robust = fit_laws(film, scene, ["newtonian", "kelvin-voigt"], starts=0, loss=Loss("cauchy", 2.0))
    assert "newtonian" in robust.choice.close
    plain = robust.fits["newtonian"]
    # Charged alike: by the least of the scales, and not by the squares that the outliers make.
    assert robust.choice.table[0].law.squares < 0.5 * plain.squares


def test_corrections_are_noted_once() -> None:
    scene, film = _fallen("newtonian", 0.01)
    turned = Measurements.of(film.series[0].time, -film.series[0].midpoint)
    found = fit_laws(turned, scene, ["newtonian", "kelvin-voigt"], starts=0)
    for one in found.fits.values():
        assert len(one.notes) == 1
        assert "Turned the sign" in one.notes[0]


PAIRS = [(wider, narrower) for wider in FITTED for narrower in LIMITS.get(wider, {})]


def _oil(law: str) -> sc.Scene:
    """A filament that sags by a good tenth of its span and does not ring."""
    own = {"youngs_modulus": "4 MPa", "second_modulus": "1 MPa", "viscosity": "60 kPa*s", "yield_stress": "2 kPa"}
    changes: dict[str, object] = {f"material.{name}": None for name in own} | {"material.law": law}
    changes |= {f"material.{name}": own[name] for name in CONSTANTS[law]}
    if law in ("power-law", "herschel-bulkley"):
        changes |= {"material.index": 0.8, "material.viscosity": "60 kPa*s^0.8"}
    plain = {"run.effects": "paper", "numerics.cells": 6, "run.frames": 41}
    scene = sc.load_scene("continual-descent", plain).replace(changes)
    return scene.replace({"run.effects": [name for name in choose_effects(scene).names if name != "inertia"]})


def _film_of(scene: sc.Scene) -> tuple[np.ndarray, np.ndarray]:
    data = sc.simulate(scene).data
    return data.time.values[1:], data.midpoint.values[1:]


@pytest.mark.parametrize(("wider", "narrower"), few(PAIRS, *PAIRS[:2]))
def test_the_wider_law_falls_as_the_one_inside(wider: str, narrower: str) -> None:
    """Two percent of the sag: negligible constants are a hundredth of what would matter, not nothing."""
    scene = _oil(narrower)
    time, height = _film_of(scene)
    inside = widened(scene, wider, Measurements.of(time, height))
    assert inside.material.law == wider
    after, found = _film_of(inside)
    late = time > 0.2 * time[-1]
    scale = float(np.abs(height).max())
    assert np.abs(np.interp(time, after, found) - height)[late].max() < 0.02 * scale


@pytest.mark.slow
def test_a_wider_law_starts_again_from_the_one_inside() -> None:
    """A solid's modulus that is far too large cannot be left behind by its own starts, whose bounds lie about it."""
    scene = _oil("newtonian")
    time, height = _film_of(scene)
    film = Measurements.of(time, height + 1e-4 * np.random.default_rng(4).standard_normal(height.size))
    stiff = scene.replace(
        {"material.law": "kelvin-voigt", "material.youngs_modulus": "300 MPa", "run.effects": "paper"}
    ).replace({"run.effects": [name for name in choose_effects(_oil("kelvin-voigt")).names if name != "inertia"]})
    alone = fit_law(film, stiff, "kelvin-voigt", starts=0, profiles=False)
    found = fit_laws(film, stiff, ["kelvin-voigt", "newtonian"], starts=0)
    assert found.restarted == {"kelvin-voigt": "newtonian"}
    assert alone.squares > 10 * found.fits["kelvin-voigt"].squares
    # What has one constant more is no worse, but for how little its modulus may be made.
    assert found.fits["kelvin-voigt"].squares < 1.01 * found.fits["newtonian"].squares
    assert "newtonian" in found.choice.close


def test_the_narrower_comes_first() -> None:
    """Laws are fitted in the order of how many others they contain."""
    for law in FITTED:
        assert all(len(LIMITS.get(inside, {})) < len(LIMITS[law]) for inside in LIMITS.get(law, {}))
