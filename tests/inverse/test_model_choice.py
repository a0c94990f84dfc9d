"""The ranking of laws: criteria by hand, and how often the true law wins."""

from __future__ import annotations

import math

import numpy as np
import pytest

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.model_selection import FittedLaw, choose_model


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
