"""Inertia: free fall, and the first frequency of beams."""

from __future__ import annotations

import numpy as np
import pytest

from .closed_forms import BEAM_CONSTANT, FIRST_EIGENVALUE, GYRATION
from .scenes import run, scene

GRAVITY = 10.0


@pytest.mark.parametrize("law", ["elastic", "maxwell", "bingham"])
def test_midpoint_falls_freely_until_the_ends_are_felt(law: str) -> None:
    """-g t^2/2: the news of the supports travels a half span at the axial wave speed sqrt(E/rho)."""
    E_star = 100.0
    before_the_news = 0.9 * 0.5 / np.sqrt(E_star)
    asked = scene(
        thickness=0.01,
        E=E_star * 1e4,
        eta=None if law == "elastic" else 1e5,
        yield_stress=1e4 if law == "bingham" else None,
        duration=before_the_news * np.sqrt(1 / GRAVITY),
        frames=21,
        cells=40,
        rtol=1e-6,
    )
    data = run(asked).data
    t, y = data["time"].values[1:], data["midpoint"].values[1:]
    error = np.max(np.abs(y / (-GRAVITY * t**2 / 2) - 1))
    print(f"{law}: falls {-y[-1]:.2e} m, largest relative error {error:.1e}")
    assert error < 1e-6


def test_midpoint_falls_freely_under_ramped_gravity() -> None:
    """Twice the integral of g(t) = g (10 u^3 - 15 u^4 + 6 u^5), u = t/ramp: g ramp^2 (u^5/2 - u^6/2 + u^7/7)."""
    ramp = 0.04
    asked = scene(thickness=0.01, E=1e6, ramp=ramp, duration=0.9 * 0.5 / np.sqrt(1e3), frames=11, cells=40, rtol=1e-8)
    data = run(asked).data
    t, y = data["time"].values[1:], data["midpoint"].values[1:]
    u = t / ramp
    assert u[-1] < 1
    expected = -GRAVITY * ramp**2 * (u**5 / 2 - u**6 / 2 + u**7 / 7)
    error = np.max(np.abs(y - expected)) / np.max(np.abs(expected))
    print(f"ramped: falls {-y[-1]:.2e} m, largest error {error:.1e}")
    assert error < 1e-6


def upward_crossings(t: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Times at which y rises through zero, by linear interpolation."""
    before = np.flatnonzero((y[:-1] <= 0) & (y[1:] > 0))
    return t[before] + (t[before + 1] - t[before]) * y[before] / (y[before] - y[before + 1])


@pytest.mark.parametrize("ends", list(FIRST_EIGENVALUE), ids="-".join)
def test_first_frequency_of_a_beam(ends: tuple[str, str]) -> None:
    """Gravity at once: the midpoint swings about the static sag, between zero and about twice it."""
    thickness, density, static = 0.01, 1000.0, 1e-4
    E = density * GRAVITY / (BEAM_CONSTANT[ends] * GYRATION["rectangle"] * thickness**2 * static)
    rigidity = E * GYRATION["rectangle"] * thickness**2 / density
    period = 2 * np.pi / (FIRST_EIGENVALUE[ends] ** 2 * np.sqrt(rigidity))
    asked = scene(thickness=thickness, E=E, ends=ends, duration=10.5 * period, frames=801, cells=40, rtol=3e-4)
    done = run(asked)
    assert done.outcome.is_success
    t, y = done.data["time"].values, done.data["midpoint"].values
    crossings = upward_crossings(t, y + static)
    found = (crossings[-1] - crossings[0]) / (len(crossings) - 1)
    print(f"{'-'.join(ends)}: frequency {period / found - 1:+.1e}, mean sag {-np.mean(y) / static - 1:+.1e}")
    assert len(crossings) == 10
    assert found == pytest.approx(period, rel=2e-3)
    assert -np.mean(y[t < 10 * period]) == pytest.approx(static, rel=5e-3)
    assert -np.min(y) == pytest.approx(2 * static, rel=0.03)
