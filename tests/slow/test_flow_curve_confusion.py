"""Which law a flow curve is given: some hundred curves of five fluids, with three kinds of error."""

from __future__ import annotations

from collections import Counter
from itertools import product

import numpy as np
import pytest

from softcat_sym.fitting.flow_curve import FITTED, FlowCurve, FlowCurveFit, fit_flow_curve
from tests.common.draws import draws, shares
from tests.common.table import show

pytestmark = pytest.mark.slow

NAMES = TRUTHS = [law.name for law in FITTED]
YIELDS = {law.name: law.yields for law in FITTED}
ERRORS = ("of each stress", "of its logarithm", "of the least stress")
EACH = 24


def _curve(truth: str, error: str, random: np.random.Generator) -> FlowCurve:
    """6 to 40 points over 1 to 5 decades with errors of 0.3 to 10 %; a yield stress of a third to three of the flow."""
    points, decades = int(random.integers(6, 41)), random.uniform(1, 5)
    noise, scale = np.exp(random.uniform(np.log([0.003, 0.1]), np.log([0.1, 1e4])))
    flow, n = 10 ** random.uniform(-0.5, 0.5), random.uniform(0.3, 0.8)
    # Counted from the middle of the decades.
    g = np.geomspace(10 ** (-decades / 2), 10 ** (decades / 2), points)
    stress = {
        "newtonian": g,
        "power-law": g**n,
        "bingham": 1 + flow * g,
        "herschel-bulkley": 1 + flow * g**n,
        "casson": (1 + np.sqrt(flow * g)) ** 2,
    }[truth]
    deviate = noise * random.standard_normal(points)
    noisy = {
        "of each stress": stress * (1 + deviate),
        "of its logarithm": stress * np.exp(deviate),
        "of the least stress": stress + stress.min() * deviate,
    }[error]
    return FlowCurve(scale * g, scale * noisy)


def _is_told(fit: FlowCurveFit) -> bool:
    """Whether nothing warns of another law, or of a yield stress that may be zero."""
    return not any("fit about equally well" in text or "yield stress" in text for text in fit.warnings)


def _yielding(counts: dict[str, Counter[str]]) -> float:
    """Share of the curves of fluids without a yield stress that are given one."""
    return sum(counts[truth][name] for truth in TRUTHS if not YIELDS[truth] for name in NAMES if YIELDS[name]) / (
        EACH * sum(not YIELDS[truth] for truth in TRUTHS)
    )


@pytest.mark.statistical
@pytest.mark.parametrize("error", ERRORS)
def test_confusion_of_flow_curves(error: str) -> None:
    random = draws(len(error))
    chosen: dict[str, Counter[str]] = {truth: Counter() for truth in TRUTHS}
    told: dict[str, Counter[str]] = {truth: Counter() for truth in TRUTHS}
    worst, clear = 0.0, []
    for truth, _ in product(TRUTHS, range(EACH)):
        fit = fit_flow_curve(_curve(truth, error, random))
        best = fit.best
        chosen[truth][best.law] += 1
        told[truth][best.law] += _is_told(fit)
        if not YIELDS[best.law]:
            worst = max(worst, *(best.relative_rms / one.relative_rms for one in fit.candidates if YIELDS[one.law]))
        if YIELDS[truth] and fit.curve.decades > 2 and fit.curve.shear_rate.size >= 10:
            clear.append(YIELDS[best.law])
    cells = [
        [truth, *(f"{chosen[truth][name]} ({told[truth][name]})" for name in NAMES), f"{sum(told[truth].values())}"]
        for truth in TRUTHS
    ]
    title = f"{EACH * len(TRUTHS)} curves, errors {error}: law chosen (of these without a warning of another)"
    show(title, ["truth", *NAMES, "without a warning"], cells)
    print(f"\nlargest rms of a law without a yield stress that was chosen, over one with: {worst:.2f}")
    print(f"given a yield stress that they have not: {_yielding(chosen):.1%}, without a warning {_yielding(told):.1%}")
    print(f"yield stress found, over two decades or more by ten points or more: {sum(clear)} of {len(clear)}")
    # One constant more is worth a factor of 1.47 with six points, two are worth 1.95.
    assert worst < 2
    # 2 in 1250 are missed, by what eight other sets of draws had.
    assert np.mean(clear) >= 1 - shares(len(clear), 2e-3)[1]
    # Constant errors, unlike the relative ones that are assumed, are those of a few points at the lowest rates.
    if error != "of the least stress":
        # 8.0 and 2.1 % of the 1280 in those sets; a binomial of 48.
        for counts, share in ((chosen, 0.09), (told, 0.025)):
            assert _yielding(counts) <= shares(2 * EACH, share)[1]
