"""Are draws those of the posterior: against exact ones, and beside profiles."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from scipy import stats

import softcat_sym as sc
from softcat_sym.fitting.free_parameters import FreeParameter, Unknowns
from softcat_sym.fitting.identifiability import noise_of, taken
from softcat_sym.fitting.least_squares import multi_start
from softcat_sym.fitting.measurements import Measurements, Series
from softcat_sym.fitting.posterior import Posterior, PosteriorOutcome, posterior_of, sample
from softcat_sym.fitting.priors import read_priors
from softcat_sym.fitting.problem import Marginal
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


BENDS = 24
"""Unknowns beside offset and slope, of which the deviation is known beforehand, as of a theory's error."""


class Bent(Unknowns):
    """Residuals of a line and bends in units of a noise, and those of the bends' priors."""

    asked, noise_known = 2, False

    def __init__(self, line: np.ndarray, bends: np.ndarray, data: np.ndarray, noise: float) -> None:
        self.line, self.bends, self.data, self.noise = line, bends, data, noise
        names = ("offset", "slope", *(f"bend_{k}" for k in range(BENDS)))
        self.free = tuple(FreeParameter(name, name, "m", 0.0, False, 1.0, (-60.0, 60.0)) for name in names)

    def residuals(self, q: np.ndarray) -> np.ndarray:
        return self.linearised(q)[0]

    def linearised(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        jacobian = np.vstack([np.hstack([self.line, self.bends]) / self.noise, np.eye(2 + BENDS)[2:]])
        return jacobian @ q - np.append(self.data / self.noise, np.zeros(BENDS)), jacobian


@pytest.mark.statistical
def test_priors_are_no_readings_of_the_noise() -> None:
    """Against the noise integrated out by quadrature, which leaves a sum of normal distributions."""
    random, places = draws(2), np.linspace(0.0, 3.0, 40)
    line, orders = np.stack([np.ones(40), places], axis=1), np.arange(1, BENDS + 1)
    bends = 2 * np.sin(np.outer(places, orders)) / orders
    data = line @ np.array([1.0, 2.0]) + bends @ random.standard_normal(BENDS) + 0.3 * random.standard_normal(40)
    unit = 0.3
    for _ in range(50):  # Residuals are in units of the noise that they have
        bent = Bent(line, bends, data, unit)
        found = multi_start(bent, [np.zeros(2 + BENDS)], count=0).best
        left = found.residuals[:40]
        unit *= float(np.sqrt(left @ left / (40 - taken(found.jacobian, 40))))
    noise = noise_of(found.residuals, found.jacobian, noise_known=False, readings=40)
    marginal = Marginal(bent, found)  # type: ignore[arg-type]
    best, priors = found.q[:2], read_priors({}, marginal.free)
    sampled = sample(marginal, best, priors, draws=2000, tune=200, seed=3, noise=noise)
    parts, logarithms = [], []
    for deviation in np.geomspace(0.03, 3.0, 400):
        inverse = np.linalg.inv(deviation**2 * np.eye(40) + bends @ bends.T)
        covariance = np.linalg.inv(line.T @ inverse @ line)
        mean = covariance @ line.T @ inverse @ data
        parts.append((mean, np.sqrt(np.diag(covariance))))
        of_all = np.linalg.slogdet(inverse)[1] + np.linalg.slogdet(covariance)[1]
        logarithms.append(0.5 * (of_all - (data - line @ mean) @ inverse @ data))
    shares = np.exp(np.array(logarithms) - max(logarithms))
    rows = []
    for k, name in enumerate(("offset", "slope")):
        grid = best[k] + np.linspace(-8, 8, 8001)
        below = sum(
            share * stats.norm(mean[k], error[k]).cdf(grid) for share, (mean, error) in zip(shares, parts, strict=True)
        )
        exact, ends = np.interp([0.025, 0.975], below / shares.sum(), grid), np.array(sampled.parameters[name]["eti95"])
        away = np.abs(ends - exact).max() / np.ptp(exact)
        rows.append([name, *(f"{end:.3f}" for end in (*exact, *ends)), f"{away:.1%}"])
        # As above, over a width of four deviations: independent are at least a fifth of the draws.
        independent = sampled.data.posterior[name].size / 5
        assert away < errors_away() * 2.7 / independent**0.5 / 4, rows
    show("95 % intervals", ["parameter", "exact from", "to", "drawn from", "to", "apart, of the width"], rows)


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
    found = posterior_of(fitted, time_limit=3600.0)
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
