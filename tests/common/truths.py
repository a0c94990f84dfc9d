"""Answers that the package did not compute: closed forms, lengths in L and stresses in rho g L."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from scipy.integrate import cumulative_simpson, simpson
from scipy.optimize import brentq

Array = npt.NDArray[np.float64]

_MODES = 12


def beam_let_go(times: Array, E: float, delta: float) -> Array:
    """Midpoint of a linear clamped beam under a weight that comes at once: its symmetric modes (Rayleigh)."""
    return beam_shaken(times, E, delta, 0.0, 1.0)


def beam_shaken(times: Array, E: float, delta: float, a: float, frequency: float) -> Array:
    """The same under the weight 1 + a sin(2 pi f t): Duhamel's integral of each mode (Rayleigh 1877)."""
    drive = 2 * np.pi * frequency
    height = np.zeros_like(times)
    for omega, share in _symmetric_modes(E, delta):
        forced = (np.sin(drive * times) - drive / omega * np.sin(omega * times)) / (omega**2 - drive**2)
        height -= share * ((1 - np.cos(omega * times)) / omega**2 + a * forced)
    return height


def _symmetric_modes(E: float, delta: float) -> Iterator[tuple[float, float]]:
    """Frequency, and what an even load of one makes of the midpoint's acceleration."""
    x = np.linspace(-0.5, 0.5, 20001)
    for k in range(_MODES):
        # tan(b/2) + tanh(b/2) = 0
        low = (k + 0.5) * np.pi + 1e-9
        half = brentq(lambda b: np.tan(b) + np.tanh(b), low, low + np.pi / 2)
        # cosh(b x)/cosh(b/2) - cos(b x)/cos(b/2), without overflow
        grown = np.exp(2 * half * (np.abs(x) - 0.5)) + np.exp(-2 * half * (np.abs(x) + 0.5))
        mode = grown / (1 + np.exp(-2 * half)) - np.cos(2 * half * x) / np.cos(half)
        omega = (2 * half) ** 2 * np.sqrt(delta**2 * E / 12)
        yield omega, simpson(mode, x=x) / simpson(mode**2, x=x) * mode[len(x) // 2]


def beam_of_modes(times: Array, modes: Sequence[tuple[float, float]], delta: float) -> Array:
    """Midpoint of a clamped beam that creeps, J(t)/(32 delta^2), with the compliance of Maxwell modes (E, tau) abreast.

    By the correspondence principle J has a pole between every two relaxation rates.
    """

    def modulus(s: float) -> float:
        return sum(E * tau / (1 + s * tau) for E, tau in modes)

    rates = sorted(1 / tau for _, tau in modes)
    compliance = 1 / sum(E for E, _ in modes) + times / sum(E * tau for E, tau in modes)
    for slow, fast in pairwise(rates):
        # On a logarithmic scale, close to both ends.
        low, high = np.log(slow) + 1e-12, np.log(fast) - 1e-12
        rate = float(np.exp(brentq(lambda r: modulus(-float(np.exp(r))), low, high, xtol=1e-14, rtol=1e-14)))
        slope = -sum(E * tau**2 / (1 - rate * tau) ** 2 for E, tau in modes)
        compliance = compliance - (1 - np.exp(-rate * times)) / (rate**2 * slope)
    return -compliance / (32 * delta**2)


def hanging_chain_sag(length: float) -> float:
    """Sag of an inextensible catenary of a length over a span of one: 2 a sinh(1/2a) = length."""
    a = brentq(lambda a: 2 * a * np.sinh(0.5 / a) - length, 1e-3, 1e3)
    return float(a * (np.cosh(0.5 / a) - 1))


def uneven_beam_sag(E: float, delta: float, profile: Sequence[float]) -> float:
    """Midpoint sag of a linear clamped beam of symmetric thickness h(X): rectangle, weight ~ h, stiffness ~ h^3."""
    x = np.linspace(0.0, 0.5, 200001)
    h = np.interp(x, np.linspace(-0.5, 0.5, len(profile)), profile)
    # Shear grows from midspan, M = M0 + int int h; level at X = 0 and at the clamp: int M/h^3 = 0.
    bending = cumulative_simpson(cumulative_simpson(h, x=x, initial=0), x=x, initial=0)
    middle = -simpson(bending / h**3, x=x) / simpson(1 / h**3, x=x)
    slope = cumulative_simpson((middle + bending) / h**3, x=x, initial=0)
    return float(abs(simpson(slope, x=x))) * 12 / (E * delta**2)
