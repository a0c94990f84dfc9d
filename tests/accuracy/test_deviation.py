"""What is told of a long ringing is compared, not its phase; everything else is compared instant by instant."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.discretization.grid import Floats
from softcat_sym.error_control.estimate import Judge

PERIODS, FRAMES, ACCURACY = 200.0, 2001, 1e-2
TIME = np.linspace(0.0, 1.0, FRAMES)


def ringing(height: float = 1.0, amplitude: float = 1.0, frequency: float = PERIODS, decay: float = 0.0) -> Floats:
    """A midpoint that rings about a height, with a higher mode a tenth as large."""
    turn = 2 * np.pi * frequency * TIME
    swing = np.cos(turn) + 0.1 * np.cos(5.4 * turn + 1.0)
    return np.asarray(-height + amplitude * np.exp(-decay * TIME) * swing)


def test_a_phase_is_told_beside() -> None:
    answer = ringing()
    found = Judge.of(answer, PERIODS, ACCURACY).between(answer, ringing(frequency=1.003 * PERIODS))
    assert np.max(np.abs(answer - ringing(frequency=1.003 * PERIODS))) > 1.5
    assert found.size < 0.1 * ACCURACY
    assert found.phase == pytest.approx(0.6, abs=0.02)


@pytest.mark.parametrize("changed", [{"height": 1.02}, {"amplitude": 1.02}, {"height": 0.98, "frequency": 200.7}])
def test_height_and_amplitude_are_judged(changed: dict[str, float]) -> None:
    answer = ringing()
    found = Judge.of(answer, PERIODS, ACCURACY).between(answer, ringing(**changed))
    # Relative to the largest midpoint, 2.1.
    assert found.size == pytest.approx(0.02 / np.max(np.abs(answer)), rel=0.1)


def test_an_amplitude_that_fades_otherwise_is_an_error() -> None:
    answer = ringing()
    found = Judge.of(answer, PERIODS, ACCURACY).between(answer, ringing(decay=0.05))
    assert found.size == pytest.approx((1 - np.exp(-0.05)) / np.max(np.abs(answer)), rel=0.1)


@pytest.mark.parametrize(
    ("answer", "periods"), [(ringing(frequency=8.0), 8.0), (ringing(decay=20.0), PERIODS), (ringing(), 0.0)]
)
def test_what_comes_to_rest_or_hardly_rings_is_compared_instant_by_instant(answer: Floats, periods: float) -> None:
    judge = Judge.of(answer, periods, ACCURACY)
    other = np.roll(answer, 1)
    found = judge.between(answer, other)
    assert found.size == pytest.approx(np.max(np.abs(answer - other)) / np.max(np.abs(answer)))
    assert found.phase is None
