"""Fits of films whose truth is known: outcomes, effects, the run that is judged, pictures and words."""

from __future__ import annotations

import io
import itertools
import json
import math
import time
from collections.abc import Callable
from dataclasses import replace
from html import escape
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rich.console import Console

import softcat_sym as sc
from softcat_sym import drawing, store
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.files import json_bytes
from softcat_sym.fitting import fit as fit_module
from softcat_sym.fitting.fit import fit
from softcat_sym.fitting.flow_curve import fit_flow_curve, fitted_scene
from softcat_sym.fitting.identifiability import Statistic
from softcat_sym.fitting.least_squares import MultiStartResult
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.problem import FilmReadings
from softcat_sym.fitting.result import Fit, FitOutcome, FittedParameter
from softcat_sym.plotting.fit import fit_page, fitted_toml
from softcat_sym.plotting.fit_figures import (
    JOINT,
    model_bands,
    smooth,
    unit_ellipse,
)
from softcat_sym.plotting.fit_words import (
    display_unit,
    parameter_texts,
    with_error,
)
from softcat_sym.results import run as run_module
from softcat_sym.results import verdict
from softcat_sym.solvers.compiled import CModel
from tests.common.draws import draws, misses, shares
from tests.common.filmed import TRUTH, film, scene
from tests.common.fitting import METHODS_AGREE, methods_apart
from tests.common.flow_curves import curve_of

NECK = "the cell at X/L = 0.49 carries 60%"


def fitted(*free: str, wave: float = 0.0) -> Fit:
    time, height = film()
    height = height + wave * np.sin(40 * time / time[-1])
    return fit(Measurements.of(time, height), scene(), free or ["viscosity"], starts=0, profiles=False)


def test_a_run_that_is_solved_changes_nothing() -> None:
    found = fitted()
    assert (found.outcome, found.message) == (FitOutcome.solved, "")


@pytest.mark.compiled
@pytest.mark.parametrize(
    ("name", "share"), [("maxwell-fast", 0.03), ("continual-descent", 0.2), ("continual-descent", 0.4)]
)
def test_both_methods_find_one_optimum(name: str, share: float) -> None:
    assert methods_apart(name, share, seed=0) < METHODS_AGREE


def test_an_unknown_method_is_refused() -> None:
    with pytest.raises(SoftcatError, match="no method 'gauss-newton'; accepted: least-squares, ipopt"):
        fit(Measurements.of(*film()), scene(), ["viscosity"], method="gauss-newton")  # type: ignore[arg-type]


def test_a_neck_that_the_grid_decides(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(verdict, "neck_that_the_grid_decides", lambda stretch, length, neck, yields: NECK)
    found = fitted()
    assert found.parameters["viscosity"].verdict == "identified"
    assert found.outcome is FitOutcome.localised
    assert found.outcome.converged
    assert "localised" in found.message and NECK in found.message


def test_lost_energy(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run_module, "energy_residual", lambda fields, least: 0.5)
    found = fitted()
    assert found.outcome is FitOutcome.run_in_doubt
    assert "energy residual 0.5" in found.message
    # A graver word stays; the complaint is told beside it.
    other = fitted(wave=2e-3)
    assert other.outcome is FitOutcome.model_error
    assert "energy residual 0.5" in other.message


@pytest.mark.compiled
@pytest.mark.statistical
@pytest.mark.parametrize("cells", [4, 16])
def test_a_grid_that_is_fixed_too_coarsely_is_neither_the_law_nor_outliers(cells: int) -> None:
    """A film of 48 cells with little noise; the intervals are widened by what the grid moves, and hold the truth."""
    true = scene().replace({"numerics.cells": 48})
    run = sc.simulate(true.replace({"run.frames": 61})).data
    time, height = run.time.values[1:], run.midpoint.values[1:]
    height = height + 1e-3 * np.abs(height).max() * draws(0).standard_normal(60)
    exact = {"calibrated": True, "discrepancy": False, "starts": 0, "profiles": False}
    found = fit(Measurements.of(time, height), scene().replace({"numerics.cells": cells}), ["viscosity"], **exact)  # type: ignore[arg-type]
    assert found.outcome is FitOutcome.discretization_error
    one = found.parameters["viscosity"]
    assert None not in one.ci95 and not misses(one.best, one.ci95, TRUTH["viscosity"], 59)


def test_the_run_is_that_of_the_fit(monkeypatch: pytest.MonkeyPatch) -> None:
    """With the fitted value, the effects of the fit, and for as long as it was filmed."""
    from softcat_sym.fitting import fit as fitted_run

    asked: list[sc.Scene] = []

    def simulate(one: sc.Scene) -> sc.Run:
        asked.append(one)
        return sc.simulate(one)

    monkeypatch.setattr(fitted_run, "recalled", simulate)
    found = fitted("viscosity", "time_offset")
    (one,) = asked
    assert one.material.viscosity == pytest.approx(found.parameters["viscosity"].best)
    assert tuple(one.run.effects) == found.effects
    offset = found.parameters["time_offset"].best
    assert offset != 0
    assert one.run.duration == pytest.approx(float(film()[0].max()) - offset)


def test_a_filament_that_cannot_begin(monkeypatch: pytest.MonkeyPatch) -> None:
    from softcat_sym.fitting import fit as fitted_run

    def refused(one: sc.Scene) -> sc.Run:
        raise sc.SceneError([])

    monkeypatch.setattr(fitted_run, "recalled", refused)
    assert fitted().outcome is FitOutcome.run_in_doubt


FIT = fit_flow_curve(curve_of(12.0, 3.4, 0.43, noise=0.02, seed=5))


@pytest.mark.parametrize("name", sc.bundled_names())
@pytest.mark.parametrize("law", ["bingham", "power-law", "herschel-bulkley"])
def test_every_scene_takes_every_law_and_reads_back(name: str, law: str) -> None:
    base = sc.load_scene(name)
    if base.model != "filament":
        return
    modulus = [] if base.material.youngs_modulus else ["material.youngs_modulus=1 kPa"]
    scene = fitted_scene(FIT, name, law, modulus)
    tensile = FIT.candidate(law).tensile
    material = scene.material
    assert material.law == law
    assert material.yield_stress == (tensile.yield_stress and pytest.approx(tensile.yield_stress, rel=1e-9))
    assert material.viscosity == pytest.approx(tensile.viscosity, rel=1e-9)
    if tensile.index is not None:
        assert material.index == pytest.approx(tensile.index, rel=1e-9)
    # Of chains the storage modulus is a third of Young's, of other laws by Poisson's ratio.
    if base.material.youngs_modulus and not base.material.spec.has_chains:
        assert material.youngs_modulus == base.material.youngs_modulus
        assert fitted_scene(FIT, base, law) == scene
    assert (scene.filament, scene.run) == (base.filament, base.run)
    # The shear data are stated.
    shear = [note for note in material.notes if "in shear" in note]
    assert len(shear) == (1 if law == "power-law" else 2)
    assert all(note in scene.to_toml() for note in material.notes)


def test_what_is_set_wins_over_the_fit() -> None:
    changes = ["material.youngs_modulus=40 kPa", "material.shear_yield_stress=7 Pa"]
    scene = fitted_scene(FIT, "no-yield", "bingham", changes)
    assert scene.material.youngs_modulus == 40e3
    assert scene.material.yield_stress == pytest.approx(7 * math.sqrt(3))
    # Given in tension, it takes the place of the fitted one in shear.
    scene = fitted_scene(FIT, "no-yield", "bingham", ["material.yield_stress=7 Pa"])
    assert scene.material.yield_stress == 7
    # What is not of the material is set before the scene is read, its groups included.
    scene = fitted_scene(FIT, "no-yield", "power-law", ["groups.duration=10"])
    assert scene.run == sc.load_scene("no-yield", ["groups.duration=10"]).run
    with pytest.raises(SceneError, match="sets nothing"):
        fitted_scene(FIT, "no-yield", "bingham", ["material.yield_stress"])


@pytest.fixture(scope="module")
def exactly_fitted() -> sc.Fit:
    """Camera and theory known exactly, so that bands are of the constants alone."""
    how: dict[str, Any] = {"starts": 0, "profiles": False, "calibrated": True, "discrepancy": False}
    return sc.fit(sc.Measurements.of(*film(), std=5e-4), scene(), ["yield_stress", "viscosity"], **how)


@pytest.fixture(scope="module")
def two_fitted() -> sc.Fit:
    return sc.fit(sc.Measurements.of(*film(), std=5e-4), scene(), ["yield_stress", "viscosity"], starts=2)


@pytest.mark.slow
def test_a_fit_gives_the_pictures_of_its_files(two_fitted: sc.Fit, tmp_path: Path) -> None:
    written = {path.stem for path in two_fitted.write(tmp_path) if path.suffix == ".png"}
    assert written == set(two_fitted.figures()) >= {"fit", "starts", "correlation"}


def test_the_band_is_what_the_covariance_makes_of_the_model(exactly_fitted: sc.Fit) -> None:
    """The half-width is 1.96 standard deviations of what the model says.

    They are those of two curves for each column of a root of the covariance, one standard deviation to either side. It
    is exact where the model is linear, whatever the root, so that nothing need be drawn.
    """
    best, noise = exactly_fitted.starts.best, exactly_fitted.information.noise
    root = np.linalg.cholesky(noise**2 * np.linalg.inv(best.jacobian.T @ best.jacobian))
    sides = [[exactly_fitted.problem.films[0].values(best.q + sign * column) for sign in (1, -1)] for column in root.T]
    deviation = np.sqrt(sum(((one - other) / 2) ** 2 for one, other in sides))
    (band,) = model_bands(exactly_fitted)
    # Before it flows the model does not depend on them: what the curves differ by there is the time steps.
    telling = band > 0.1 * band.max()
    assert np.count_nonzero(telling) >= len(band) - 3
    # The rest of 3 % is for time steps and for what is not linear, 1.5 % here.
    np.testing.assert_allclose(band[telling], (exactly_fitted.information.quantile * deviation)[telling], rtol=0.03)


def test_the_curve_of_a_profile_goes_through_its_points(two_fitted: sc.Fit) -> None:
    for one in two_fitted.profiles:
        q, increase = smooth(one)
        for at, value in zip(one.q, one.increase, strict=True):
            assert increase[np.argmin(np.abs(q - at))] == pytest.approx(value, rel=1e-6, abs=1e-9)
        assert np.all(np.diff(q) > 0)


@pytest.mark.statistical
@pytest.mark.parametrize("r", [-0.999, -0.4, 0.0, 0.7])
def test_the_ellipse_is_that_of_the_correlation(r: float) -> None:
    x, y = unit_ellipse(r)
    np.testing.assert_allclose((x**2 - 2 * r * x * y + y**2) / (1 - r**2), 1, rtol=1e-9)
    one, apart = draws(1).standard_normal((2, 20_000))
    other = r * one + math.sqrt(1 - r**2) * apart
    inside = (one**2 - 2 * r * one * other + other**2) / (1 - r**2) < JOINT
    # A binomial of 20 000: 95 +- 0.8 %.
    least, most = shares(20_000, 0.95)
    assert least <= inside.mean() <= most


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (13851.77, 243.4, "13850 ± 240"),
        (1957.417, 18.6, "1957 ± 19"),
        (1957.417, 0.996, "1957.4 ± 1.0"),
        (0.43012, 0.0023, "0.4301 ± 0.0023"),
        (-0.0001, 0.0012, "−0.0001 ± 0.0012"),
        (3.222e-5, 3.4e-7, "3.222e-5 ± 3.4e-7"),
        (5.0, 80.0, "5 ± 80"),
    ],
)
def test_as_many_digits_as_the_error_has_meaning(value: float, error: float, text: str) -> None:
    assert with_error(value, error) == text


def test_units_have_prefixes_where_they_are_known() -> None:
    assert display_unit("Pa*s", 13.8e3).symbol == "kPa·s"
    assert display_unit("Pa", 1.6e8).text(1.6e8) == "160 MPa"
    assert display_unit("kg/m^3", 1900).symbol == "kg/m³"
    assert display_unit("s", 5e-3).symbol == "ms"
    assert display_unit("m", 0.0).symbol == "nm"


KNOWN = FittedParameter(
    "viscosity", "Pa*s", 13.85e3, 13.85e3, 243.0, (13.4e3, 14.3e3), "identified", "", 13e3, (1, 1e6)
)


@pytest.mark.parametrize(
    ("changes", "value", "interval"),
    [
        ({}, "13.85 ± 0.24", "13.40 to 14.30"),
        ({"verdict": "one-sided", "value": None, "std": None, "ci95": (None, 14.3e3)}, "–", "< 14.3"),
        ({"verdict": "one-sided", "value": None, "std": None, "ci95": (13.4e3, None)}, "–", "> 13.4"),
        ({"verdict": "not identified", "value": None, "std": None, "ci95": (None, None)}, "–", "–"),
        ({"verdict": "not identified", "value": None, "std": None, "ci95": (1e3, 2e6)}, "–", "1.00 to 2000"),
        ({"verdict": "at a bound", "std": None, "ci95": (13.4e3, None)}, "13.8 (bound)", "> 13.4"),
    ],
)
def test_no_number_stands_for_what_is_not_known(changes: dict[str, object], value: str, interval: str) -> None:
    one = replace(KNOWN, **changes)  # type: ignore[arg-type]
    assert parameter_texts(one) == ("viscosity [kPa·s]", value, interval, one.verdict, "13.0")


@pytest.fixture(scope="module")
def one_fitted() -> sc.Fit:
    time, height = film()
    # Out of order, and one frame is missing: both are corrected, and said.
    height = np.where(np.arange(time.size) == 7, np.nan, height)
    return sc.fit(sc.Measurements.of(time[::-1], height[::-1]), scene(), ["viscosity"], starts=0)


def unknown(fit: sc.Fit) -> sc.Fit:
    """The same fit, had it told nothing."""
    lost = {"value": None, "std": None, "ci95": (None, None), "verdict": "not identified", "reason": "<no & why>"}
    return replace(
        fit,
        parameters={"viscosity": replace(fit.parameters["viscosity"], **lost)},  # type: ignore[arg-type]
        outcome=FitOutcome.not_identified,
        correlation=np.array([[math.nan]]),
        combinations=("viscosity^1 * density^-1 = 7.3 (7 to 7.6), SI",),
        noise=math.inf,
        repeats=("the one_fitted values call for <shear>",),
    )


def test_the_document_has_what_the_contract_says_and_no_nan(one_fitted: sc.Fit) -> None:
    for each in (one_fitted, unknown(one_fitted)):
        found = json.loads(json_bytes(each.to_dict()), parse_constant=lambda name: pytest.fail(name))
        assert {"parameters", "correlation", "features", "outcome", "starts", "advice"} <= set(found)
        assert set(found["parameters"]["viscosity"]) >= {"value", "std", "ci95", "verdict", "unit", "best", "bounds"}
        assert len(found["notes"]) == 1 and len(found["features"]) == 1
    assert found["correlation"] == [[None]] and found["noise_m"] is None
    assert found["parameters"]["viscosity"]["value"] is None and found["parameters"]["viscosity"]["best"] > 0
    assert one_fitted.to_dict()["features"][0]["prefactor"]["value"] == pytest.approx(0.007, rel=0.1)


def test_terminal_page_and_scene_say_what_is_not_known(one_fitted: sc.Fit) -> None:
    fit = unknown(one_fitted)
    screen = Console(file=io.StringIO(), width=80, color_system=None)
    drawing.report(fit).print(screen)
    printed = " ".join(screen.file.getvalue().split())  # type: ignore[attr-defined]
    page = fit_page(fit, {}, "softcat fit 'a <b>.csv'").decode()
    assert "<no & why>" in printed and "&lt;no &amp; why&gt;" in page and "<no" not in page and "<shear" not in page
    assert "&#39;a &lt;b&gt;.csv&#39;" in page and " doubtful" in page
    for words in [*fit.combinations, *fit.repeats, *fit.notes]:
        assert words in printed and escape(words) in page
    assert "…" not in printed
    # Neither says where the optimum lies.
    assert f"{fit.parameters['viscosity'].best:.4g}"[:4] not in printed
    toml = fitted_toml(fit)
    assert "# viscosity: not identified; <no & why>" in toml
    assert toml.splitlines()[0] == "# Fitted: not identified."


def test_what_a_reader_has_to_know_first_is_a_warning(one_fitted: sc.Fit) -> None:
    assert one_fitted.warnings == []
    large = replace(one_fitted, checks=replace(one_fitted.checks, size=Statistic("chi-square", 700.0, 1e-9)))
    assert "larger than the stated errors (chi-square 700 for 59 readings, p = 1e-09)" in large.warnings[0]
    best = one_fitted.starts.results[0]
    lonely = MultiStartResult((best, replace(best, cluster=1), replace(best, cluster=2)), 0)
    assert "only one start" in replace(one_fitted, starts=lonely).warnings[0]
    doubtful = replace(one_fitted.profiles[0], unconverged=2, better=best.start)
    assert len(replace(one_fitted, profiles=(doubtful,)).warnings) == 2


@pytest.mark.parametrize("seconds", [1e-9, 0.05])
def test_a_time_limit_ends_in_an_answer_or_in_words(seconds: float) -> None:
    try:
        found = sc.fit(Measurements.of(*film()), scene(), ["viscosity", "yield_stress"], time_limit=seconds)
    except SoftcatError as error:
        assert "the time limit passed before the first start" in str(error)
    else:
        assert found.late


@pytest.mark.compiled
@pytest.mark.parametrize("evaluations", [0, 9])
def test_a_time_limit_reaches_into_an_evaluation(evaluations: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """After some evaluations one takes a minute unless it is stopped: the fit has its result so far, or says why."""
    integrate, sensitivities, begun = CModel.integrate, CModel.sensitivities, itertools.count()

    def slow(stop: Any) -> None:
        end = time.monotonic() + (60 if next(begun) >= evaluations else 0)
        while time.monotonic() < end and not stop.value:
            time.sleep(0.01)

    def slowly(own: Callable[..., Any], at: int) -> Callable[..., Any]:
        def called(model: CModel, *given: Any) -> Any:
            slow(given[at])
            return own(model, *given)

        return called

    monkeypatch.setattr(CModel, "integrate", slowly(integrate, 2))
    monkeypatch.setattr(CModel, "sensitivities", slowly(sensitivities, 3))
    start = time.monotonic()
    try:
        with store.fresh(True):
            found = sc.fit(Measurements.of(*film()), scene(), ["viscosity", "yield_stress"], time_limit=3.0)
    except SoftcatError as error:
        assert evaluations == 0 and "the time limit passed before the first start" in str(error)
    else:
        assert evaluations and found.late
    # What is not stopped takes a minute; half of it is what a busy machine may take to notice the limit.
    assert time.monotonic() - start < 33


def test_a_fit_starts_elsewhere_if_the_model_has_no_answer_at_the_measured_frequency(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    ringing, heights, asked = (
        SimpleNamespace(frequency=SimpleNamespace(value=30.0, error=0.1)),
        FilmReadings.values,
        list[object](),
    )

    def once_without_answer(film: FilmReadings, q: np.ndarray) -> np.ndarray:
        asked.append(q)
        return np.full(film.data.size, np.nan) if len(asked) == 1 else heights(film, q)

    monkeypatch.setattr(fit_module, "features_of", lambda *_: ringing)
    monkeypatch.setattr(FilmReadings, "values", once_without_answer)
    assert fitted("youngs_modulus", "yield_stress").outcome.converged and asked
