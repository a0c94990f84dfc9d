"""The fit of a flow curve against exact data, against SciPy, and against its own claim of 95 %."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.stats import t as student

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.flow_curve import INDEX_BOUNDS, Candidate, FlowCurve, fit_flow_curve, linear_part
from softcat_sym.fitting.identifiability import standard_errors, student_quantile
from tests.inverse.curves import MATERIALS, RATE, curve_of

LAWS = ("bingham", "power-law", "herschel-bulkley")


def constants(one: Candidate) -> list[float]:
    """tau_Y, k and n of a candidate, as far as it has them."""
    return [estimate.value for estimate in (one.tau_Y, one.k, one.n) if estimate is not None]


def oracle(curve: FlowCurve, law: str) -> tuple[np.ndarray, float]:
    """Constants and sum of squares from SciPy's trust region, the best of many starts; k is fitted by its logarithm."""
    rate, stress = curve.shear_rate, curve.shear_stress
    has_yield, has_index = law != "power-law", law != "bingham"

    def unpack(x: np.ndarray) -> tuple[float, float, float]:
        rest = list(x)
        tau_Y = rest.pop(0) * stress.min() if has_yield else 0.0
        return tau_Y, math.exp(rest.pop(0)), rest.pop(0) if has_index else 1.0

    def residual(x: np.ndarray) -> np.ndarray:
        tau_Y, k, n = unpack(x)
        return (tau_Y + k * rate**n) / stress - 1

    low = [0.0] * has_yield + [-60.0] + [INDEX_BOUNDS[0]] * has_index
    high = [np.inf] * has_yield + [60.0] + [INDEX_BOUNDS[1]] * has_index
    found = []
    for share in (0.1, 0.9) if has_yield else (0.0,):
        for n in (0.1, 0.4, 1.0, 2.0) if has_index else (1.0,):
            middle = len(rate) // 2
            k = math.log((1 - 0.9 * share) * stress[middle] / rate[middle] ** n)
            start = [share] * has_yield + [k] + [n] * has_index
            found.append(least_squares(residual, start, bounds=(low, high), xtol=1e-15, ftol=1e-15, gtol=1e-15))
    best = min(found, key=lambda one: one.cost)
    tau_Y, k, n = unpack(best.x)
    return np.array([tau_Y] * has_yield + [k] + [n] * has_index), 2 * best.cost


@pytest.mark.parametrize(("law", "tau_Y", "k", "n"), MATERIALS)
def test_exact_data_give_back_their_law_and_constants(law: str, tau_Y: float, k: float, n: float) -> None:
    fit = fit_flow_curve(curve_of(tau_Y, k, n))
    assert fit.best.law == law
    expected = [tau_Y] * (law != "power-law") + [k] + [n] * (law != "bingham")
    np.testing.assert_allclose(constants(fit.best), expected, rtol=1e-6)
    assert fit.best.relative_rms < 1e-10
    assert all(one.verdict == "determined" for one in (fit.best.tau_Y, fit.best.k, fit.best.n) if one is not None)


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize(("law", "tau_Y", "k", "n"), MATERIALS)
def test_noisy_data_are_fitted_as_scipy_fits_them(law: str, tau_Y: float, k: float, n: float, seed: int) -> None:
    curve = curve_of(tau_Y, k, n, noise=0.03, seed=seed)
    fit = fit_flow_curve(curve)
    assert {one.law for one in fit.candidates} == set(LAWS)
    for one in fit.candidates:
        expected, squares = oracle(curve, one.law)
        found = one.relative_rms**2 * RATE.size
        # Never worse than the best of SciPy's starts; equal constants wherever SciPy has found the same optimum.
        assert found <= squares * (1 + 1e-9)
        if one.tau_Y is None or one.tau_Y.verdict == "determined":
            np.testing.assert_allclose(constants(one), expected, rtol=1e-6)


def test_the_linear_part_solves_its_normal_equations() -> None:
    curve = curve_of(12.0, 3.4, 0.43, noise=0.1, seed=3)
    index = np.array([0.2, 0.43, 1.5])
    part = linear_part(RATE, curve.shear_stress, index, yields=True)
    for k, n in enumerate(index):
        columns = np.column_stack([np.ones_like(RATE), RATE**n]) / curve.shear_stress[:, None]
        best = np.linalg.lstsq(columns, np.ones_like(RATE), rcond=None)[0]
        np.testing.assert_allclose([part.tau_Y[k], part.k[k]], best, rtol=1e-9)
        np.testing.assert_allclose(part.squares[k], np.sum((columns @ best - 1) ** 2), rtol=1e-9)


def test_the_95_percent_intervals_hold_the_truth_in_95_percent_of_all_sets() -> None:
    truth = (12.0, 3.4, 0.43)
    held = np.zeros(3)
    for seed in range(200):
        fit = fit_flow_curve(curve_of(*truth, noise=0.03, seed=1000 + seed))
        one = fit.candidate("herschel-bulkley")
        for k, (estimate, value) in enumerate(zip((one.tau_Y, one.k, one.n), truth, strict=True)):
            assert estimate is not None and estimate.interval is not None
            held[k] += estimate.interval[0] <= value <= estimate.interval[1]
    # Three standard deviations of a binomial with 200 draws are 4.6 %.
    assert np.all((held / 200 > 0.904) & (held / 200 < 0.996)), held / 200


def test_bingham_data_prefer_bingham_to_a_third_constant() -> None:
    chosen = [fit_flow_curve(curve_of(12.0, 0.5, 1.0, noise=0.02, seed=seed)).best.law for seed in range(40)]
    # A third constant that means nothing gains more than it costs in about one set of eight.
    assert chosen.count("bingham") >= 30
    assert set(chosen) <= {"bingham", "herschel-bulkley"}


@pytest.mark.parametrize(("points", "needs"), [(26, {}), (7, {}), (5, {"herschel-bulkley"}), (4, set(LAWS))])
def test_the_criterion_is_aicc(points: int, needs: set[str]) -> None:
    data = curve_of(12.0, 3.4, 0.43, noise=0.05)
    thin = np.linspace(0, RATE.size - 1, points).astype(int)
    fit = fit_flow_curve(FlowCurve(data.shear_rate[thin], data.shear_stress[thin]))
    for one in fit.candidates:
        p = len(constants(one)) + 1
        aic = points * math.log(np.mean(one.residuals**2)) + 2 * p
        assert one.aic == pytest.approx(aic)
        assert one.aicc == (math.inf if one.law in needs else pytest.approx(aic + 2 * p * (p + 1) / (points - p - 1)))
    assert [one.aicc for one in fit.candidates] == sorted(one.aicc for one in fit.candidates)
    # Five points or fewer never speak for three constants.
    assert points > 5 or fit.best.law != "herschel-bulkley"
    assert any("too few" in text for text in fit.warnings) == (points < 6)


def test_tension_follows_from_shear_by_von_mises() -> None:
    fit = fit_flow_curve(curve_of(12.0, 3.4, 0.43))
    tensile = fit.candidate("herschel-bulkley").tensile
    assert tensile.yield_stress == pytest.approx(math.sqrt(3) * 12)
    assert tensile.viscosity == pytest.approx(3**0.715 * 3.4)
    assert tensile.index == pytest.approx(0.43)
    # A bar drawn at the rate e has the shear rate sqrt(3) e and the tensile stress sqrt(3) tau.
    stretching = np.array([0.01, 0.3, 20.0])
    pulled = tensile.yield_stress + tensile.viscosity * stretching**tensile.index
    sheared = fit.candidate("herschel-bulkley").stress(math.sqrt(3) * stretching)
    np.testing.assert_allclose(pulled, math.sqrt(3) * sheared, rtol=1e-12)
    bingham = fit.candidate("bingham")
    assert bingham.tensile.viscosity == pytest.approx(3 * bingham.k.value)
    assert bingham.tensile.index is None and fit.candidate("power-law").tensile.yield_stress is None


def test_a_scene_gets_shear_data_with_their_units() -> None:
    fit = fit_flow_curve(curve_of(12.0, 3.4, 0.43))
    assert fit.overrides() == {
        "material.law": "herschel-bulkley",
        "material.shear_yield_stress": "12 Pa",
        "material.shear_consistency": "3.4 Pa*s^0.43",
        "material.index": 0.43,
    }
    assert list(fit.overrides("power-law")) == ["material.law", "material.shear_consistency", "material.index"]
    bingham = fit.overrides("bingham")
    assert bingham["material.shear_viscosity"].endswith(" Pa*s") and "material.index" not in bingham
    with pytest.raises(SoftcatError, match=r"no law 'powerlaw' is fitted .did you mean 'power-law'.*bingham"):
        fit.overrides("powerlaw")


def test_a_newtonian_fluid_is_handed_on_as_a_power_law() -> None:
    fit = fit_flow_curve(curve_of(0.0, 2.0, 1.0))
    assert fit.overrides() == {
        "material.law": "power-law",
        "material.shear_consistency": "2 Pa*s^1",
        "material.index": 1,
    }
    bingham = fit.candidate("bingham")
    assert bingham.tau_Y is not None and bingham.tau_Y.verdict == "on a bound" and bingham.tau_Y.interval is None
    with pytest.raises(SoftcatError, match="yield stress is zero: take power-law"):
        fit.overrides("bingham")


def test_a_falling_curve_is_warned_of_and_not_handed_on() -> None:
    fit = fit_flow_curve(FlowCurve(RATE, 10 * RATE**-0.2))
    assert any("falls" in text for text in fit.warnings)
    assert fit.candidate("power-law").n.verdict == "on a bound"  # type: ignore[union-attr]
    yielding = fit.candidate("herschel-bulkley")
    assert yielding.k.value == 0 and yielding.k.verdict == "on a bound"
    assert yielding.n is not None and yielding.n.verdict == "undetermined"
    with pytest.raises(SoftcatError, match="does not rise"):
        fit.overrides("herschel-bulkley")


def test_a_narrow_range_hardly_determines_a_yield_stress() -> None:
    rate = np.geomspace(20, 90, 8)
    error = 1 + 0.03 * np.random.default_rng(4).standard_normal(8)
    fit = fit_flow_curve(FlowCurve(rate, (1.0 + 3.4 * rate**0.43) * error))
    assert any("less than a decade" in text for text in fit.warnings)
    one = fit.candidate("herschel-bulkley")
    assert one.tau_Y is not None and one.tau_Y.verdict != "determined"
    wide = fit_flow_curve(curve_of(1.0, 3.4, 0.43, noise=0.03))
    assert not any("decade" in text for text in wide.warnings)


@pytest.mark.parametrize("freedom", [1, 2, 3, 4, 5, 10, 23, 200, 5001])
def test_students_quantile(freedom: int) -> None:
    assert student_quantile(freedom) == pytest.approx(student.ppf(0.975, freedom), rel=1e-12)


def test_standard_errors_of_a_line_are_the_textbooks() -> None:
    x = np.arange(5.0)
    errors = standard_errors(np.column_stack([np.ones(5), x]), 0.3)
    spread = 0.3 / 3
    np.testing.assert_allclose(errors, np.sqrt([spread * (1 / 5 + 4 / 10), spread / 10]))
    assert np.all(np.isinf(standard_errors(np.column_stack([np.ones(5), 2 * np.ones(5)]), 0.3)))
