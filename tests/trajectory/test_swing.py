"""Ringing faster than frames can show is noticed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from softcat_sym.results.motion import frames_a_period, swing_period, too_few_frames


def ringing(frequency: float, duration: float = 2.0, frames: int = 201, amplitude: float = 0.5):
    time = np.linspace(0, duration, frames)
    return time, -1 + amplitude * np.cos(2 * math.pi * frequency * time)


def test_the_period_is_that_of_the_swing() -> None:
    for frequency in [2.1, 3.7, 10.0, 20.0]:
        assert swing_period(*ringing(frequency)) == pytest.approx(1 / frequency, rel=0.03)


def test_what_hardly_swings_or_falls_does_not_ring():
    time = np.linspace(0, 2, 201)
    assert swing_period(time, -1 + np.exp(-time)) is None
    assert swing_period(*ringing(5.0, amplitude=0.004)) is None
    assert swing_period(time, 0 * time) is None
    assert swing_period(time[:1], -time[:1]) is None
    assert frames_a_period(time, -1 + np.exp(-time), 1e6) is None


def test_a_slow_swing_on_a_fall_is_found():
    time, swing = ringing(6.0, amplitude=0.1)
    assert swing_period(time, swing - 0.5 * time) == pytest.approx(1 / 6, rel=0.06)


def test_frames_too_far_apart_show_a_slower_swing_which_the_forecast_tells():
    """53.75 Hz in a hundred frames a second are seen as 46.25 Hz, in fifty as 3.75 Hz."""
    time, seen = ringing(53.75, frames=101)
    assert swing_period(time, seen) == pytest.approx(1 / 3.75, rel=0.05)
    per_period = frames_a_period(time, seen, 2 * math.pi * 55.0)
    assert per_period == pytest.approx(50 / 55.0, rel=1e-6)
    (warning,) = too_few_frames(time, per_period)
    assert "rings at about 55 Hz" in warning
    assert "run.frames = 889" in warning
    assert frames_a_period(*ringing(54.0, frames=888), 2 * math.pi * 54.0) > 4


def test_enough_frames_need_no_warning():
    time, seen = ringing(10.0)
    assert frames_a_period(time, seen, math.inf) == pytest.approx(10.0, rel=0.03)
    assert frames_a_period(time, seen, 2 * math.pi * 9.0) == pytest.approx(10.0, rel=0.03)
    assert too_few_frames(time, 10.0) == too_few_frames(time, None) == []
