"""Flow curves: what is read and refused; the fit against exact data, SciPy and its own claim of 95 %; the command."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
from scipy.optimize import least_squares

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.flow_curve import (
    FITTED,
    INDEX_BOUNDS,
    Candidate,
    FlowCurve,
    fit_flow_curve,
    read_flow_curve,
)
from softcat_sym.scene.laws import LAWS as SPECS
from tests.common.draws import shares
from tests.common.flow_curves import MATERIALS, RATE, curve_of, write_csv
from tests.common.in_process import Softcat, sets

LAWS = [law.name for law in FITTED]
ROWS = "1,14\n10,20\n100,40\n1000,90\n"
HEADER = "shear_rate_1_s,shear_stress_Pa\n"

REFUSED = [
    ("shear_rate_1_s,sheer_stress_Pa\n" + ROWS, r"no column shear stress .*called 'sheer_stress_Pa'"),
    ("shear_rate_rpm,shear_stress_Pa\n" + ROWS, "rpm is a rotational speed"),
    ("Sample,shear_rate_1_s,shear_stress_Pa\nink,1,2\nclay,1,3\n", "2 samples; accepted: --sample with .* ink, clay"),
    ("shear_rate_s,shear_stress\n" + ROWS, "2 faults.*'s' is a time, not a shear rate.*no unit in its name"),
    (HEADER + ROWS.replace("20", "").replace("40", "n/a"), r"2 of 4 rows without a positive number \(line 3, line 4\)"),
    (
        HEADER + ROWS.replace("20", "-20").replace("40", "0"),
        r"2 of 4 rows without a positive number \(line 3, line 4\)",
    ),
    (HEADER + ROWS.replace("20", "2e20"), "2e.20 is beyond anything measured"),
    (HEADER + ROWS.replace("1000,", "100.00000001,") + "1,15\n10,21\n", "3 distinct shear rates"),
]


def test_one_of_several_samples(tmp_path: Path, softcat: Softcat) -> None:
    path = tmp_path / "inks.csv"
    rows = "".join(f"{name},{row}\n" for row in ROWS.split() for name in ("a", "b"))
    path.write_text("sample_id,shear_rate_1/s,stress_Pa\n" + rows.replace("b,1,14", "b,1,19"))
    assert read_flow_curve(path, "b").shear_stress.tolist() == [19, 20, 40, 90]
    with pytest.raises(SoftcatError, match="no sample 'c'; accepted: --sample with one of a, b"):
        fit_flow_curve(path, "c")
    assert softcat("flow-curve", str(path), "--sample", "b", "-o", str(tmp_path / "out"), "-q").status == 0
    path.write_text(HEADER + ROWS)
    with pytest.raises(SoftcatError, match=r"no sample 'b'.*one of a column sample_id"):
        fit_flow_curve(path, "b")


def test_bad_files_and_points_are_one_clear_refusal(tmp_path: Path) -> None:
    path = tmp_path / "curve.csv"
    for text, message in REFUSED:
        path.write_text(text)
        with pytest.raises(SoftcatError, match=rf"(?s)flow curve {path}: .*{message}"):
            fit_flow_curve(str(path))
    points = [
        ([1, 2, 3, 4], [1, 2, 3], r"shape \(4,\).*shape \(3,\)"),
        ([[1, 2], [3, 4]], [[1, 2], [3, 4]], "lists of the same length"),
        ([1, 2, 3, "x"], [1, 2, 3, 4], "shear_rate: not a list of numbers"),
        ([1, 2, 3, 4], [1, 2, float("nan"), 4], r"shear_stress\[2\]: nan is not finite"),
        ([1, 2, 3, -4], [1, 2, 3, 0], "2 faults"),
        ([], [], "0 distinct"),
    ]
    for rate, stress, message in points:
        with pytest.raises(SoftcatError, match=rf"(?s){message}"):
            FlowCurve(rate, stress)  # type: ignore[arg-type]


def constants(one: Candidate) -> list[float]:
    """tau_Y, k and n of a candidate, as far as it has them."""
    return [estimate.value for estimate in (one.tau_Y, one.k, one.n) if estimate is not None]


def oracle(curve: FlowCurve, law: str) -> tuple[np.ndarray, float]:
    """Constants and sum of squares from SciPy's trust region, the best of many starts; k is fitted by its logarithm."""
    rate, stress = curve.shear_rate, curve.shear_stress
    has_yield, has_index, p = SPECS[law].yields, SPECS[law].has_index, SPECS[law].shear_exponent

    def unpack(x: np.ndarray) -> tuple[float, float, float]:
        rest = list(x)
        tau_Y = rest.pop(0) * stress.min() if has_yield else 0.0
        return tau_Y, math.exp(rest.pop(0)), rest.pop(0) if has_index else 1.0

    def residual(x: np.ndarray) -> np.ndarray:
        tau_Y, k, n = unpack(x)
        return (tau_Y**p + (k * rate**n) ** p) ** (1 / p) / stress - 1

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


def test_exact_data_give_back_their_law_and_constants() -> None:
    for law, tau_Y, k, n in MATERIALS:
        best = fit_flow_curve(curve_of(tau_Y, k, n)).best
        assert best.law == law and best.relative_rms < 1e-10
        expected = [tau_Y] * (law != "power-law") + [k] + [n] * (law != "bingham")
        np.testing.assert_allclose(constants(best), expected, rtol=1e-6)
        assert all(one.verdict == "determined" for one in (best.tau_Y, best.k, best.n) if one is not None)


@pytest.mark.statistical
def test_noisy_data_are_fitted_as_scipy_fits_them() -> None:
    for seed, (_, tau_Y, k, n) in enumerate([*MATERIALS, *MATERIALS]):
        curve = curve_of(tau_Y, k, n, noise=0.03, seed=seed)
        for one in fit_flow_curve(curve).candidates:
            expected, squares = oracle(curve, one.law)
            # Never worse than the best of SciPy's starts; equal constants wherever SciPy has found the same optimum.
            assert one.relative_rms**2 * RATE.size <= squares * (1 + 1e-9)
            if one.tau_Y is None or one.tau_Y.verdict == "determined":
                np.testing.assert_allclose(constants(one), expected, rtol=1e-6)


@pytest.mark.statistical
def test_the_95_percent_intervals_hold_the_truth_in_95_percent_of_all_sets() -> None:
    truth, held = (12.0, 3.4, 0.43), np.zeros(3)
    for seed in range(200):
        one = fit_flow_curve(curve_of(*truth, noise=0.03, seed=1000 + seed)).candidate("herschel-bulkley")
        for k, (estimate, value) in enumerate(zip((one.tau_Y, one.k, one.n), truth, strict=True)):
            assert estimate is not None and estimate.interval is not None
            held[k] += estimate.interval[0] <= value <= estimate.interval[1]
    # A binomial of 200 draws: 85 % at least. All 200 would be one in 28 000, which is no alarm.
    assert np.all(held / 200 >= shares(200, 0.95)[0]), held / 200


def test_tension_follows_from_shear_by_von_mises() -> None:
    fit = fit_flow_curve(curve_of(12.0, 3.4, 0.43))
    one = fit.candidate("herschel-bulkley")
    tensile = one.tensile
    assert (tensile.yield_stress, tensile.viscosity) == pytest.approx((math.sqrt(3) * 12, 3**0.715 * 3.4))
    # A bar drawn at the rate e has the shear rate sqrt(3) e and the tensile stress sqrt(3) tau.
    rate = np.array([0.01, 0.3, 20.0])
    pulled = tensile.yield_stress + tensile.viscosity * rate**tensile.index
    np.testing.assert_allclose(pulled, math.sqrt(3) * one.stress(math.sqrt(3) * rate), rtol=1e-12)
    bingham = fit.candidate("bingham")
    assert bingham.tensile.viscosity == pytest.approx(3 * bingham.k.value)
    assert bingham.tensile.index is None and fit.candidate("power-law").tensile.yield_stress is None
    assert fit.overrides() == {
        "material.law": "herschel-bulkley",
        "material.shear_yield_stress": "12 Pa",
        "material.shear_consistency": "3.4 Pa*s^0.43",
        "material.index": 0.43,
    }
    assert set(fit.overrides("power-law")) == {"material.law", "material.shear_consistency", "material.index"}
    with pytest.raises(SoftcatError, match=r"no law 'powerlaw' is fitted .did you mean 'power-law'.*bingham"):
        fit.overrides("powerlaw")


@pytest.fixture
def paste(tmp_path: Path) -> Path:
    return write_csv(tmp_path / "paste.csv", curve_of(12.0, 3.4, 0.43, noise=0.02, seed=6))


def test_files_table_and_document(paste: Path, softcat: Softcat, tmp_path: Path) -> None:
    output, files = tmp_path / "deep" / "out", {"flow_curve.json", "flow_curve.csv", "flow_curve.png"}
    done = softcat("flow-curve", str(paste), "-o", str(output))
    assert done.status == 0 and {path.name for path in output.iterdir()} == files
    assert all(text in done.out for text in ("paste.csv", "herschel-bulkley", "criterion"))
    fit, found = fit_flow_curve(paste), json.loads((output / "flow_curve.json").read_text())
    assert (found["best"], found["handed_on"], found["points"]) == ("herschel-bulkley", "herschel-bulkley", RATE.size)
    assert found["overrides"] == fit.overrides() and set(found["candidates"]) == set(LAWS)
    assert found["candidates"]["herschel-bulkley"]["above_best"] == 0
    best = found["candidates"]["herschel-bulkley"]["parameters"]
    assert set(best) == {"shear_yield_stress", "shear_consistency", "index"}
    assert best["index"]["ci95"][0] < 0.43 < best["index"]["ci95"][1]
    assert set(found["candidates"]["bingham"]["parameters"]) == {"shear_yield_stress", "shear_viscosity"}
    table = pd.read_csv(output / "flow_curve.csv", dtype=str).astype(float)
    np.testing.assert_array_equal(table["shear_rate_1_s"], fit.curve.shear_rate)
    for one in fit.candidates:
        name = one.law.replace("-", "_")
        np.testing.assert_array_equal(table[f"{name}_Pa"], one.fitted)
        np.testing.assert_array_equal(table[f"{name}_relative_residual"], one.residuals)


def test_a_scene_gets_the_material(paste: Path, softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "out"
    choice = ("--scene", "no-yield", "--law", "bingham", *sets("material.youngs_modulus=40 kPa"), "-q")
    done = softcat("flow-curve", str(paste), "-o", str(output), *choice)
    assert (done.status, done.out, done.err) == (0, "", "")
    scene, tensile = sc.load_scene(str(output / "scene.toml")), fit_flow_curve(paste).candidate("bingham").tensile
    assert scene.material.youngs_modulus == 40e3
    found = (scene.material.yield_stress, scene.material.viscosity)
    assert found == pytest.approx((tensile.yield_stress, tensile.viscosity), rel=1e-9)
    assert json.loads((output / "flow_curve.json").read_text())["handed_on"] == "bingham"


def test_bad_input_is_one_message_and_leaves_nothing(paste: Path, softcat: Softcat, tmp_path: Path) -> None:
    falling = str(write_csv(tmp_path / "falling.csv", FlowCurve(RATE, 10 * RATE**-0.2)))
    scene = (str(paste), "--scene", "no-yield", "--law", "bingham")
    for arguments, message in (
        (("nowhere.csv",), "no such file"),
        ((str(paste), "--law", "binham"), "did you mean 'bingham'"),
        ((str(paste), "--scene", "no-such-scene"), "no-such-scene"),
        ((str(paste), *sets("run.duration=1 s")), "--scene"),
        ((*scene, *sets("material.visosity=1 Pa*s")), "material.visosity"),
        ((falling, "--scene", "no-yield"), "cannot be handed on"),
    ):
        done = softcat("flow-curve", *arguments, "-o", str(tmp_path / "out"))
        assert done.status == 2 and message in done.err, arguments
        assert not (tmp_path / "out").exists()
