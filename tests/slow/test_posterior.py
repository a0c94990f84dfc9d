"""Are draws those of the posterior: against exact ones, and beside profiles."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from scipy import stats

import softcat_sym as sc
from softcat_sym.fitting.free_parameters import FreeParameter
from softcat_sym.fitting.identifiability import ResidualNoise
from softcat_sym.fitting.measurements import Measurements, Series
from softcat_sym.fitting.posterior import Posterior, PosteriorOutcome, posterior_of, sample
from softcat_sym.fitting.priors import read_priors
from tests.common.draws import RARE, draws, errors_away
from tests.common.table import show

pytestmark = pytest.mark.slow
pytest.importorskip("nutpie", reason="pip install softcat_sym[bayes]", exc_type=ImportError)

PLACES = np.linspace(0.0, 3.0, 12)
COLUMNS = np.stack([np.ones_like(PLACES), PLACES], axis=1)


@dataclass
class Line:
    """Offset and slope of a straight line, whose posterior is known."""

    data: np.ndarray
    noise_known: bool
    beyond: float = np.inf
    names: tuple[str, ...] = ("offset", "slope")

    @property
    def free(self) -> tuple[FreeParameter, ...]:
        return tuple(FreeParameter(name, name, "m", 0.0, False, 1.0, (-60.0, 60.0)) for name in self.names)

    @property
    def lower(self) -> np.ndarray:
        return np.full(2, -60.0)

    @property
    def upper(self) -> np.ndarray:
        return np.full(2, 60.0)

    def residuals(self, q: np.ndarray) -> np.ndarray:
        return COLUMNS @ q - self.data if q[1] < self.beyond else np.full(12, np.nan)

    def linearised(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return self.residuals(q), COLUMNS


def drawn(known: bool, **priors: str) -> tuple[Posterior, np.ndarray, np.ndarray]:
    """Draws, best fit, and the covariance of the exact posterior's normal or Student distribution without priors."""
    data = COLUMNS @ np.array([1.0, 2.0]) + 0.7 * draws(1).standard_normal(12)
    best, squares, *_ = np.linalg.lstsq(COLUMNS, data, rcond=None)
    problem = Line(data, known)
    scale = 1.0 if known else float(squares[0]) / (12 - 2)
    found = sample(problem, best, read_priors(priors, problem.free), draws=2000, tune=200, seed=3)
    return found, best, scale * np.linalg.inv(COLUMNS.T @ COLUMNS)


def agrees(found: Posterior, name: str, exact: stats.rv_continuous) -> None:
    """Thinned until they are independent, the draws have the distribution."""
    values = found.data.posterior[name].values[:, ::5].ravel()
    assert found.outcome is PosteriorOutcome.sampled
    assert stats.kstest(values, exact.cdf).pvalue > RARE, name
    # The 2.5 % quantile of n independent draws is off by sqrt(0.025 0.975/n)/f(-1.96) = 2.7/sqrt(n) deviations of a
    # normal distribution, half as much again of Student's with ten degrees of freedom.
    far = errors_away() * 4 / values.size**0.5
    assert found.parameters[name]["eti95"] == pytest.approx(exact.interval(0.95), abs=far * exact.std())


@pytest.mark.statistical
@pytest.mark.parametrize("known", [True, False], ids=["known noise", "unknown noise"])
def test_a_line_has_its_exact_posterior(known: bool) -> None:
    found, best, covariance = drawn(known)
    for k, name in enumerate(("offset", "slope")):
        error = float(covariance[k, k] ** 0.5)
        agrees(found, name, stats.norm(best[k], error) if known else stats.t(12 - 2, best[k], error))


class Bent(Line):
    """A straight line in noise of unknown size, whitened together with systematic errors of a known covariance."""

    def __init__(self, data: np.ndarray, errors: np.ndarray, noise: float) -> None:
        super().__init__(data, False)
        self.root = np.linalg.inv(np.linalg.cholesky(noise**2 * np.eye(12) + errors))

    def residuals(self, q: np.ndarray) -> np.ndarray:
        return self.root @ super().residuals(q)

    def linearised(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return self.residuals(q), self.root @ COLUMNS


@pytest.mark.statistical
def test_systematic_errors_do_not_shrink_with_the_noise() -> None:
    """With a noise that few readings tell, intervals are Student's of its degrees of freedom."""
    errors = 4.0 * np.exp(-0.5 * np.subtract.outer(PLACES, PLACES) ** 2)
    data = COLUMNS @ np.array([1.0, 2.0]) + draws(2).multivariate_normal(np.zeros(12), errors + 0.09 * np.eye(12))
    bent = Bent(data, errors, 0.3)
    rows = bent.root @ COLUMNS
    best = np.linalg.lstsq(rows, bent.root @ data, rcond=None)[0]
    noise, covariance = ResidualNoise(1.0, 6), np.linalg.inv(rows.T @ rows)
    found = sample(bent, best, read_priors({}, bent.free), draws=2000, tune=200, seed=3, noise=noise)
    for k, name in enumerate(("offset", "slope")):
        agrees(found, name, stats.t(6, best[k], float(covariance[k, k] ** 0.5)))


@pytest.mark.statistical
def test_a_normal_prior_counts_as_a_reading() -> None:
    found, best, covariance = drawn(True, slope="norm(1 m, 0.2 m)")
    precision = np.linalg.inv(covariance)
    both = np.linalg.inv(precision + np.diag([0.0, 0.2**-2]))
    mean = both @ (precision @ best + np.array([0.0, 1.0 / 0.2**2]))
    for k, name in enumerate(("offset", "slope")):
        agrees(found, name, stats.norm(mean[k], both[k, k] ** 0.5))


def test_where_the_model_has_no_answer_is_said(tmp_path: Path) -> None:
    problem = Line(COLUMNS @ np.array([1.0, 2.0]), True, beyond=2.1)
    found = sample(problem, np.array([1.0, 2.0]), read_priors({}, problem.free), observed={"height": problem.data})
    assert found.divergences > 0
    assert not found.outcome.is_success
    assert float(found.data.posterior.slope.max()) < 2.1
    found.to_netcdf(tmp_path / "posterior.nc")
    import arviz

    kept = arviz.from_netcdf(tmp_path / "posterior.nc")
    assert set(kept.groups()) >= {"posterior", "sample_stats", "prior"}
    assert np.array_equal(kept.observed_data.height, problem.data)
    assert kept.posterior.slope.attrs["units"] == "m"


@pytest.mark.statistical
def test_profiles_and_posterior_agree() -> None:
    """One percent of noise, not stated; a flat prior in the logarithms."""
    scene = sc.load_scene("continual-descent", {"run.effects": "paper", "numerics.cells": 6})
    fall = sc.simulate(scene).data
    instants = np.linspace(0.0, scene.run.duration, 41)[1:]
    height = np.interp(instants, fall.time.values, fall.midpoint.values)
    height += 0.01 * np.abs(height).max() * draws(4).standard_normal(height.size)
    film = Measurements((Series(time=instants, midpoint=height, std=None, overrides={}),))
    fitted = sc.fit(film, scene, ["viscosity", "yield_stress"], starts=0)
    found = posterior_of(fitted)
    assert found.outcome is PosteriorOutcome.sampled, found.message
    rows = []
    for name, one in fitted.parameters.items():
        low, high = one.ci95
        assert low is not None and high is not None
        away = np.abs(np.array(found.parameters[name]["eti95"]) - [low, high]).max() / (high - low)
        interval = "{:.5g} to {:.5g}".format(*found.parameters[name]["eti95"])
        rows.append([name, f"{low:.5g} to {high:.5g}", interval, f"{away:.1%}"])
        # Both intervals approximate differently, by up to a tenth; to what draws tell of an end, as above.
        independent = float(found.parameters[name]["ess_tail"])
        assert away < 0.1 + errors_away() * 2.7 / independent**0.5 / 4, rows
    show("95 % intervals", ["parameter", "profile", "posterior", "ends apart, of the width"], rows)
    print(f"\n{found.message}; {found.evaluations} evaluations, {found.seconds:.0f} s")
