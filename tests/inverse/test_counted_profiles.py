"""Profiles whose evaluations are counted: the same words and nearly the same ends, for less."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.fitting.identifiability import information
from softcat_sym.fitting.inference import Profile, profile, verdicts
from softcat_sym.fitting.least_squares import LINEAR, Loss, minimise, settle
from tests.inverse.problems import Problem, decay, problem, product, saturation


class Counted(Problem):
    """Counts evaluations of either kind."""

    spent = 0

    def residuals(self, q: np.ndarray) -> np.ndarray:
        self.spent += 1
        return super().residuals(q)

    def linearised(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        self.spent += 1
        return super().linearised(q)


def counted(p: Problem) -> Counted:
    return Counted(p.names, p.lower, p.upper, p.model, p.data, p.std)


def traced(p: Counted, most: int | None) -> tuple[list[Profile], int]:
    best = minimise(p, np.zeros(len(p.names)))
    p.spent = 0
    return [profile(p, best.q, k, noise_known=True, most=most) for k in range(len(p.names))], p.spent


def test_what_is_not_identified_is_found_so_for_a_fraction() -> None:
    p = counted(problem("A a b", product, [0.5, 0.2, 0.8], 0.01))
    full, spent = traced(p, None)
    quick, less = traced(p, 200)
    assert less < 0.4 * spent
    best = minimise(p, np.zeros(3))
    known = information(p.names, best.q, best.residuals, best.jacobian, (p.lower, p.upper), noise_known=True)
    words = [[one.word for one in verdicts(p, best, known, found)] for found in (full, quick)]
    assert words[0] == words[1] == ["identified", "not identified", "not identified"]
    assert quick[0].lower.crossing == pytest.approx(full[0].lower.crossing, abs=1e-4)
    assert quick[0].upper.crossing == pytest.approx(full[0].upper.crossing, abs=1e-4)


@pytest.mark.parametrize("model", [decay, saturation])
def test_ends_are_those_of_the_full_profile(model) -> None:
    p = counted(problem("one two", model, [0.5, 0.2], 0.2))
    for full, quick in zip(traced(p, None)[0], traced(p, 200)[0], strict=True):
        width = full.upper.crossing - full.lower.crossing
        assert quick.lower.crossing == pytest.approx(full.lower.crossing, abs=0.02 * width)
        assert quick.upper.crossing == pytest.approx(full.upper.crossing, abs=0.02 * width)
        assert quick.lower.certain and quick.upper.certain


def test_one_side_is_found() -> None:
    p = counted(problem("A k", decay, [0.5, 5.0], 0.3))
    full, quick = traced(p, None)[0][1], traced(p, 200)[0][1]
    assert (quick.lower.flag, quick.upper.flag) == ("crosses", "reaches the bound")
    assert quick.lower.crossing == pytest.approx(full.lower.crossing, abs=0.03)


def test_a_spent_budget_is_said() -> None:
    p = counted(problem("A a b", product, [0.5, 0.2, 0.8], 0.01))
    found, spent = traced(p, 6)
    assert spent < 3 * 12
    assert "too many steps" in (found[1].lower.flag, found[1].upper.flag)
    best = minimise(p, np.zeros(3))
    known = information(p.names, best.q, best.residuals, best.jacobian, (p.lower, p.upper), noise_known=True)
    one = verdicts(p, best, known, found)[1]
    assert (one.word, one.value) == ("not identified", None)
    assert "not followed to its end" in one.reason


@pytest.mark.parametrize("loss", [LINEAR, Loss("soft-l1", 1.0), Loss("cauchy", 2.4)], ids=str)
def test_settling_ends_in_the_optimum(loss: Loss) -> None:
    p = problem("v K", saturation, [0.5, 0.2], 0.03)
    best = minimise(p, np.zeros(2), loss=loss)
    found = settle(p, np.array([0.45, 0.15]), loss, unit=1.0, gain=1e-8, most=60)
    assert found is not None and found.converged
    assert found.value == pytest.approx(2 * best.value, abs=1e-6)
    np.testing.assert_allclose(found.q, best.q, atol=1e-4)


def test_settling_keeps_to_the_box_and_to_its_evaluations() -> None:
    p = counted(problem("A k", decay, [0.5, 0.2], 0.01))
    p.upper = np.array([6.0, 0.0])
    found = settle(p, np.array([-1.0, -1.0]), LINEAR, unit=1.0, gain=1e-6, most=60)
    assert found is not None and found.converged
    assert found.q[1] == 0.0
    np.testing.assert_allclose(found.q, minimise(p, np.array([-1.0, -1.0])).q, atol=1e-3)
    p.spent = 0
    cut = settle(p, np.array([-1.0, -1.0]), LINEAR, unit=1.0, gain=1e-6, most=3)
    assert cut is not None and not cut.converged
    assert p.spent <= 4 and cut.evaluations == p.spent
