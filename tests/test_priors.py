"""Priors as text: what they mean, and one clear refusal for each fault."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

import softcat_sym as sc
from softcat_sym.fitting.free_parameters import FreeParameter
from softcat_sym.fitting.priors import read_priors, refuse_excluded
from tests.common.draws import RARE, draws

FREE = (
    FreeParameter("viscosity", "material.viscosity", "Pa*s", 20.0, True, 20.0, (0.02, 2e4)),
    FreeParameter("initial_sag", "initial_sag", "m", 0.0, False, 1e-3, (-0.05, 0.05)),
    FreeParameter("index", "material.index", "1", 0.5, True, 0.5, (0.02, 5.0)),
)
WRITTEN = {
    "viscosity": ("lognorm(s=0.5, scale=30 Pa*s)", stats.lognorm(0.5, scale=30.0)),
    "initial_sag": ("norm(1 mm, 2 mm)", stats.norm(1e-3, 2e-3)),
    "index": ("beta(2, 3)", stats.beta(2, 3)),
}


@pytest.mark.statistical
def test_without_text_the_prior_is_flat_between_the_bounds() -> None:
    for prior in read_priors({}, FREE):
        assert (prior.lower, prior.upper) == (prior.free.lower, prior.free.upper)
        assert prior.log_density(prior.lower) == prior.log_density(prior.upper) == prior.slope(0.0) == 0.0
        share = (prior.draw(draws(1), 4000) - prior.lower) / (prior.upper - prior.lower)
        assert stats.kstest(share, "uniform").pvalue > RARE  # A probability, which is uniform where nothing is wrong


@pytest.mark.statistical
@pytest.mark.parametrize("number", range(3), ids=lambda number: FREE[number].name)
def test_density_is_of_the_unknown(number: int) -> None:
    """Its integral over q is the probability of the values, and its slope the derivative of its logarithm."""
    text, law = WRITTEN[FREE[number].name]
    prior = read_priors({FREE[number].name: text}, FREE)[number]
    q = np.linspace(prior.lower, prior.upper, 801)[1:-1]
    density = np.exp([prior.log_density(one) for one in q.tolist()])
    ends = law.cdf([prior.free.value(one) for one in (prior.lower, prior.upper)])
    assert np.trapezoid(density, q) == pytest.approx(ends[1] - ends[0], rel=1e-4)
    value = float(law.ppf(0.3))
    at = prior.free.scaled(value)
    step = 1e-3 * value
    by_value = (law.logpdf(value + step) - law.logpdf(value - step)) / (2 * step)
    exact = by_value * prior.free.slope(at) + (1.0 if prior.free.logarithmic else 0.0)
    assert prior.slope(at) == pytest.approx(exact, rel=1e-5, abs=1e-5)
    drawn = [prior.free.value(one) for one in prior.draw(draws(2), 4000).tolist()]
    share = (law.cdf(drawn) - ends[0]) / (ends[1] - ends[0])
    assert stats.kstest(share, "uniform").pvalue > RARE  # A probability, which is uniform where nothing is wrong


def test_bounds_are_cut_to_where_there_is_density() -> None:
    prior = read_priors({"viscosity": "loguniform(10 Pa*s, 1 kPa*s)"}, FREE)[0]
    assert (prior.free.value(prior.lower), prior.free.value(prior.upper)) == pytest.approx((10.0, 1000.0))
    assert prior.slope(0.5) == pytest.approx(0.0, abs=1e-9)


FAULTS = {
    "lognrm(0.5, scale=3 Pa*s)": "no distribution 'lognrm' (did you mean 'lognorm'?)",
    "lognorm": "'lognorm' is not a distribution with arguments; accepted: NAME=DISTRIBUTION",
    "lognorm(0.5, scale=3)": "'3' has no unit",
    "lognorm(0.5, scale=3 Pa)": "'3 Pa' is not",
    "lognorm(0.5 Pa*s, scale=3 Pa*s)": "'0.5 Pa*s' is not a number without a unit",
    "lognorm(scale=3 Pa*s)": "lognorm without s",
    "lognorm(0.5)": "lognorm without scale",
    "lognorm(0.5, 0 Pa*s, 3 Pa*s, 4)": "too many positional arguments",
    "lognorm(0.5, scle=3 Pa*s)": "unexpected keyword argument 'scle'",
    "lognorm(0.5, s=0.5, scale=3 Pa*s)": "multiple values for argument 's'",
    "lognorm(-1, scale=3 Pa*s)": "not defined for s = -1",
    "norm(inf Pa*s, 1 Pa*s)": "not finite",
    "uniform(1e9 Pa*s, 1 Pa*s)": "outside of the bounds",
}


@pytest.mark.parametrize("text", FAULTS)
def test_each_fault_is_said(text: str) -> None:
    with pytest.raises(sc.SceneError) as refusal:
        read_priors({"viscosity": text}, FREE)
    assert FAULTS[text] in str(refusal.value).partition("prior of viscosity: ")[2]
    assert len(refusal.value.faults) == 1
    assert refusal.value.faults[0].accepted


def test_a_prior_that_excludes_the_best_fit_is_refused() -> None:
    priors = read_priors({"viscosity": "uniform(30 Pa*s, 10 Pa*s)"}, FREE)
    with pytest.raises(sc.SceneError, match="no finite density at the best fit, 20 Pa"):
        refuse_excluded(priors, np.zeros(3))
    refuse_excluded(priors, np.array([0.5, 0.0, 0.0]))
