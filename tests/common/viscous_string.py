"""The viscous catenary without inertia, bending and surface tension, at any sag, from one unknown: a separate judge.

An element of rest length dX carries the weight of what hangs below it: with the horizontal pull H(t) and X from midspan
T = sqrt(H^2 + (rho g A0 X)^2), whatever the shape is. An incompressible viscous element of tensile viscosity eta (three
times the shear viscosity) has T = eta A0 s_t/s^2, so that 1/s = 1 - int T dt/(eta A0), and H follows from the span,
int s H/T dX = L. With xi = X/L, h = H/(rho g A0 L) and time in eta/(rho g L)::

    (1/s)_t = -sqrt(h^2 + xi^2),    int_0^1/2 s h/sqrt(h^2 + xi^2) dxi = 1/2,    sag = int_0^1/2 s xi/sqrt(h^2 + xi^2)

Derived here; it is the stretching regime of Teichman & Mahadevan, J. Fluid Mech. 478, 71 (2003). For small t it gives
h = (36 t)^(-1/3), sag^3 = 9 t/128, the t^(1/3) of Brochard-Wyart & de Gennes, EPL 2007; the element at the
support becomes infinitely long in a finite time of the order of one.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

Array = npt.NDArray[np.float64]

START, ELEMENTS, TAUTEST = 1e-9, 120, 1e6


@dataclass(frozen=True, slots=True)
class ViscousString:
    """Sags over L, and stretches at the support, at times in eta/(rho g L)."""

    sag: Array
    end_stretch: Array


class _HalfString:
    """Gauss points along half of it, and the support itself, of no weight: it is where the string breaks."""

    def __init__(self, elements: int) -> None:
        nodes, weights = np.polynomial.legendre.leggauss(elements)
        self.xi, self.weight = np.append((nodes + 1) / 4, 0.5), np.append(weights / 4, 0.0)
        self.start = np.full(self.xi.size, 1 - 1.5 * START ** (2 / 3) / 36 ** (1 / 3))

    def pull(self, slack: Array) -> float:
        """h for which the filament with stretches 1/slack spans its supports."""
        # Trial stages may reach before the start or past the breaking; the step that made them is refused.
        slack = np.maximum(slack, 1e-6)
        if np.sum(self.weight / slack) <= 0.5:
            return TAUTEST

        def excess(log_h: float) -> float:
            h = np.exp(log_h)
            return float(np.sum(self.weight * h / np.hypot(h, self.xi) / slack) - 0.5)

        return float(np.exp(brentq(excess, np.log(1e-8), np.log(TAUTEST), xtol=1e-14, rtol=1e-14)))

    def rates(self, t: float, slack: Array) -> Array:
        return -np.hypot(self.pull(slack), self.xi)

    def sag(self, slack: Array) -> float:
        return float(np.sum(self.weight * self.xi / np.hypot(self.pull(slack), self.xi) / slack))


def viscous_string(times: Array, elements: int = ELEMENTS) -> ViscousString:
    """Follow the string through `times`, rising and later than 1e-9, by DOP853."""
    half = _HalfString(elements)
    found = solve_ivp(half.rates, (START, times[-1]), half.start, t_eval=times, method="DOP853", rtol=1e-10, atol=1e-12)
    if not found.success:
        raise RuntimeError(found.message)
    return ViscousString(np.array([half.sag(slack) for slack in found.y.T]), 1 / found.y[-1])


def breaking_time(elements: int = ELEMENTS) -> float:
    """Time at which the element at the support is infinitely long, in eta/(rho g L)."""
    half = _HalfString(elements)

    def left(t: float, slack: Array) -> float:
        return float(slack[-1] - 1e-3)

    left.terminal = True  # type: ignore[attr-defined]
    found = solve_ivp(half.rates, (START, 2.0), half.start, events=left, method="DOP853", rtol=1e-10, atol=1e-12)
    # 1/s goes to zero linearly: the last thousandth at the rate of then.
    slack = found.y[:, -1]
    return float(found.t[-1] + slack[-1] / -half.rates(0.0, slack)[-1])
