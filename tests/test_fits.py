"""Fits of films whose truth is known: outcomes, effects, the run that is judged, pictures and words."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting import fit as fit_module
from softcat_sym.fitting.fit import fit
from softcat_sym.fitting.flow_curve import fit_flow_curve, fitted_scene
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.problem import FilmReadings
from softcat_sym.fitting.result import Fit, FitOutcome
from softcat_sym.plotting.fit_figures import (
    model_bands,
)
from tests.common.draws import draws, misses
from tests.common.filmed import TRUTH, film, scene
from tests.common.fitting import METHODS_AGREE, methods_apart
from tests.common.flow_curves import curve_of


def fitted(*free: str, wave: float = 0.0) -> Fit:
    time, height = film()
    height = height + wave * np.sin(40 * time / time[-1])
    return fit(Measurements.of(time, height), scene(), free or ["viscosity"], starts=0, profiles=False)


@pytest.mark.compiled
@pytest.mark.parametrize(
    ("name", "share"), [("maxwell-fast", 0.03), ("continual-descent", 0.2), ("continual-descent", 0.4)]
)
def test_both_methods_find_one_optimum(name: str, share: float) -> None:
    assert methods_apart(name, share, seed=0) < METHODS_AGREE


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


@pytest.fixture(scope="module")
def exactly_fitted() -> sc.Fit:
    """Camera and theory known exactly, so that bands are of the constants alone."""
    how: dict[str, Any] = {"starts": 0, "profiles": False, "calibrated": True, "discrepancy": False}
    return sc.fit(sc.Measurements.of(*film(), std=5e-4), scene(), ["yield_stress", "viscosity"], **how)


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


@pytest.mark.parametrize("seconds", [1e-9, 0.05])
def test_a_time_limit_ends_in_an_answer_or_in_words(seconds: float) -> None:
    try:
        found = sc.fit(Measurements.of(*film()), scene(), ["viscosity", "yield_stress"], time_limit=seconds)
    except SoftcatError as error:
        assert "the time limit passed before the first start" in str(error)
    else:
        assert found.late


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
