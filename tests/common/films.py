"""Films made from formulas: a trend, a damped oscillation of known frequency, white noise."""

from __future__ import annotations

import numpy as np

from tests.common.draws import draws

GRAVITY, SPAN = 9.81, 0.2
UNIT = (SPAN / GRAVITY) ** 0.5
FREQUENCY, DECAY, STIFFENING, AMPLITUDE = 60.0, 2.0, 1 / 3, 3e-4
SLOPE = 1e-7


def third_law(time: np.ndarray) -> np.ndarray:
    """Sag of a viscous string [m]; it has left free fall at 20 ms."""
    return np.cbrt(SLOPE * time)


def frequency_at(time: float) -> float:
    """True frequency [rad/s] of the oscillation below."""
    return FREQUENCY * (time / 0.5) ** STIFFENING


def oscillation(time: np.ndarray) -> np.ndarray:
    """A ringing whose frequency grows as t^(1/3) [m]."""
    phase = FREQUENCY * 0.5 / (1 + STIFFENING) * (time / 0.5) ** (1 + STIFFENING)
    return AMPLITUDE * np.exp(-DECAY * (time - 0.5)) * np.cos(phase)


def film(frames: int, noise: float, seed: int, *, rings: bool) -> tuple[np.ndarray, np.ndarray]:
    """Times [s] and midpoints [m], noise over the final sag."""
    time = np.linspace(0.0, 3.0, frames)
    sag = third_law(time) + (oscillation(time) if rings else 0.0)
    sag[0] = 0.0
    scatter = draws(seed).standard_normal(frames)
    return time, -(sag + noise * third_law(time[-1:])[0] * scatter)
