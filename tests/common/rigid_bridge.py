"""The rigid-viscoplastic bridge at small slope: a Bingham strip between two supports, without elasticity and inertia.

That problem, a viscoplastic liquid bridge that falls while its curvature is small, is the first of Balmforth & Hewitt,
"Viscoplastic sheets and threads", J. Non-Newtonian Fluid Mech. 193, 28 (2013). Of their text only abstract and
introduction could be had; the equations here are derived independently and none of their numbers is used.

A fibre zeta = 2 z/h of a rectangle extends at the rate e + k zeta and carries sigma = sY sign(rate) + eta rate. With
rates in sY/eta, n = T/(A sY), m = 2 M/(A h sY) and the neutral fibre at zeta = -a, a = e/k, its means are

    0 <= a < 1:  n = a (1 + k),  m = (1 - a^2)/2 + k/3;      a >= 1:  n = 1 + e,  m = k/3;

the section is rigid below m = (1 - n^2)/2. Statics at small slope: m = Gamma (1/4 - xi^2) - 2 n W - m_0, with W the
sag over h, Gamma = (rho g L/sY)/(h/L) and m_0 the moment of a clamp, zero at a pin; n is the same everywhere.
Kinematics, with time in eta (h/L)^2/sY: W_xixi_t = -2 k, and supports that stay apart, int e = 2 int W k; a clamp adds
int k = 0.
So Gamma is the only group. It falls if Gamma > 2 (pins) or 4 (clamps), at first, between pins, with
W_t = Gamma b^3 (2 - 3 b/2), b^2 = 1/4 - 1/(2 Gamma); it stops as a string near W = Gamma/8.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

Array = npt.NDArray[np.float64]

POINTS = 240


def section_rates(n: float, m: Array) -> tuple[Array, Array]:
    """Rates (e, k) in sY/eta of sections under the tension n >= 0 and the moments m."""
    size = np.abs(m)
    a = _neutral(n, size)
    bent = 3 * (size - (1 - a**2) / 2)
    through = a >= 1
    e = np.where(through, n - 1, a * bent)
    k = np.where(through, 3 * size, bent)
    flows = np.where(through, n > 1, bent > 0)
    return np.where(flows, e, 0.0), np.where(flows, np.sign(m) * k, 0.0)


def _neutral(n: float, m: Array) -> Array:
    """Root of f = 3/2 a^3 + (3 m - 1/2) a - n, no more than 1; below yield whatever it gives is not used.

    Where the section flows, m > (1 - n^2)/2, it is the largest root, to which Newton's method falls from a = 1.
    """
    a = np.ones_like(m)
    for _ in range(14):
        value = a * (1.5 * a**2 + 3 * m - 0.5) - n
        slope = np.maximum(4.5 * a**2 + 3 * m - 0.5, 1e-9)
        a = np.clip(a - value / slope, 0.0, 1.0)
    return a


class Bridge:
    """One bridge on the midpoints of equal cells over half its span."""

    def __init__(self, gamma: float, clamped: bool, points: int = POINTS) -> None:
        self.gamma, self.clamped = gamma, clamped
        self._cell = 0.5 / points
        self.xi = (np.arange(points) + 0.5) * self._cell

    def rates(self, t: float, W: Array) -> Array:
        """W_t at the points: the tension, and the moment of a clamp, are those that fit the kinematics."""

        def held_apart(n: float) -> float:
            e, k = self._section(n, W)
            return float(np.sum(e) - 2 * np.sum(W * k))

        _, k = self._section(brentq(held_apart, 0.0, 4.0, xtol=1e-13), W)
        # Slopes on the edges of the cells from midspan outwards, their means; then the sag from the support inwards.
        slope = -2 * self._cell * np.cumsum(k)
        mean = slope + self._cell * k
        return -self._cell * (np.cumsum(mean[::-1])[::-1] - mean / 2)

    def _section(self, n: float, W: Array) -> tuple[Array, Array]:
        free = self.gamma * (0.25 - self.xi**2) - 2 * n * W

        def turned(clamp: float) -> float:
            return float(np.sum(section_rates(n, free - clamp)[1]))

        clamp = brentq(turned, free.min() - 1, free.max() + 1, xtol=1e-13) if self.clamped else 0.0
        return section_rates(n, free - clamp)

    def sag(self, times: Array) -> Array:
        """W at midspan at rising times after zero, from a straight start."""
        start = np.zeros_like(self.xi)
        found = solve_ivp(self.rates, (0, times[-1]), start, t_eval=times, rtol=1e-7, atol=1e-9, method="RK45")
        if not found.success:
            raise RuntimeError(found.message)
        # Even about midspan: a parabola through the two points next to it.
        first, second = found.y[0], found.y[1]
        return first + (first - second) / 8


def first_speed(gamma: float) -> float:
    """W_t at midspan of a straight bridge between pins, in closed form."""
    b = np.sqrt(0.25 - 0.5 / gamma)
    return float(gamma * b**3 * (2 - 1.5 * b))
