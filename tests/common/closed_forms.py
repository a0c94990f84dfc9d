"""Truths that the package did not compute: closed forms, and boundary-value problems solved by SciPy.

Straight filament of length L between level supports, weight w = rho g A0 per unit undeformed length.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from scipy.integrate import quad, solve_bvp
from scipy.optimize import brentq

Array = npt.NDArray[np.float64]

GYRATION = {"rectangle": 1 / 12, "circle": 1 / 16}
"""I/(A h^2): second moment of area over area and thickness squared."""

BEAM_CONSTANT = {("clamped", "clamped"): 384.0, ("clamped", "pinned"): 192.0, ("pinned", "pinned"): 384 / 5}
"""C in: midpoint sag of a linear beam = w L^4/(C E I)."""

FIRST_EIGENVALUE = {("clamped", "clamped"): 4.730041, ("pinned", "pinned"): np.pi}
"""beta L of the first mode; its angular frequency is (beta L)^2 sqrt(E I/(rho A L^4))."""


def von_karman_sag(E: float, I_over_A: float, weight: float, L: float = 1.0) -> float:
    """Clamped beam that stretches, small slope and strain: E I w'''' - T w'' = q, T = E A/(2L) int w'^2."""
    nodes, weights = np.polynomial.legendre.leggauss(60)
    a = L / 2
    x, dx = a * nodes, a * weights

    def curve(tension: float) -> tuple[Array, float]:
        """Slopes at x and midpoint sag under a given mean stress."""
        k = np.sqrt(tension / (E * I_over_A))
        c = weight * a / (tension * k * np.sinh(k * a))
        return c * k * np.sinh(k * x) - weight * x / tension, weight * a**2 / (2 * tension) - c * (np.cosh(k * a) - 1)

    def excess(tension: float) -> float:
        slope, _ = curve(tension)
        return float(E / (2 * L) * np.sum(dx * slope**2)) - tension

    root = brentq(excess, 1e-3 * weight * L, 10 * weight * L, xtol=1e-13 * weight * L, rtol=1e-14)
    return float(curve(root)[1])


def soft_catenary_sag(E_star: float) -> float:
    """Sag/L of a string without bending that thins and is measured in true strain: T = E A0 log(s)/s."""

    def stretch(tension: float) -> float:
        return float(brentq(lambda s: E_star * np.log(s) / s - tension, 1.0, np.e, xtol=1e-15, rtol=1e-15))

    def across(H: float) -> float:
        return quad(lambda X: H * stretch(np.hypot(H, X)) / np.hypot(H, X), 0, 0.5, epsabs=1e-13)[0]

    H = brentq(lambda H: across(H) - 0.5, 1e-3, 0.3 * E_star, xtol=1e-15)
    return quad(lambda X: X * stretch(np.hypot(H, X)) / np.hypot(H, X), 0, 0.5, epsabs=1e-13)[0]


def soft_beam_sag(E_star: float, delta: float, gyration: float) -> float:
    """Sag/L of the whole static elastic theory between clamps, as a boundary-value problem on half the span.

    Stretch s and turning theta_X follow from (Q, M): M = -E I0 theta_X/s^3, Q = E A0 log(s)/s + (3/2) M theta_X/s.
    Forces are over rho g A0 L, moments over rho g A0 L^2. Below E* of about 6 there is no smooth solution: the clamps
    kink, because a bent section softens as it stretches (3 M^2 s^3/(E^2 I0 A0) > 1 - log s).
    """
    X = np.linspace(0, 0.5, 201)
    # Soft filaments are reached from a stiff one, whose shape is the linear beam's.
    stiff = 1 / (gyration * delta**2)
    bump = 16 * X**4 - 8 * X**2 + 1
    sag = 1 / 384
    shape = np.array([X, -sag * bump, sag * (16 * X - 64 * X**3), (12 * X**2 - 1) / 24, 0 * X + sag])
    for modulus in np.geomspace(max(stiff, E_star), E_star, 12):
        X, shape = _equilibrium(float(modulus), modulus / stiff, X, shape)
    return -float(shape[1, 0])


def _equilibrium(E_star: float, rigidity: float, X: Array, guess: Array) -> tuple[Array, Array]:
    """Solve for (x, y, theta, M, horizontal force) over X in [0, 1/2]."""

    def section(Q: Array, M: Array) -> tuple[Array, Array]:
        strain = np.zeros_like(Q)
        for _ in range(60):
            s = np.exp(strain)
            bent = 1.5 * (M * s) ** 2 / rigidity
            slope = E_star * (1 - strain) / s - 2 * bent
            strain = np.clip(strain - (E_star * strain / s - bent - Q) / slope, -0.8, 0.8)
        s = np.exp(strain)
        return s, -M * s**3 / rigidity

    def rates(X: Array, u: Array) -> Array:
        _, _, theta, M, horizontal = u
        cos, sin = np.cos(theta), np.sin(theta)
        s, turning = section(horizontal * cos + X * sin, M)
        return np.array([s * cos, s * sin, turning, s * (X * cos - horizontal * sin), 0 * X])

    def ends(left: Array, right: Array) -> Array:
        return np.array([left[0], left[2], right[0] - 0.5, right[1], right[2]])

    solution = solve_bvp(rates, ends, X, guess, tol=1e-8, max_nodes=20000)
    assert solution.success, solution.message
    return solution.x, solution.y


def viscous_string_sag(t: float, E: float, eta: float, weight: float, L: float = 1.0) -> float:
    """Shallow Maxwell string without inertia: (128/9)(H^3 - H0^3)/(rho g L^4) + log(H/H0)/E = t/eta.

    From the parabola, tension rho g A L^2/8H and mean strain (8/3)(H/L)^2; it starts as the elastic cable, H0.
    """
    start = (3 * weight * L**4 / (64 * E)) ** (1 / 3)

    def late(H: float) -> float:
        return 128 / 9 * (H**3 - start**3) / (weight * L**4) + np.log(H / start) / E - t / eta

    return float(brentq(late, start, 100 * L, xtol=1e-15 * L, rtol=1e-14))
