"""Static curves that the package did not compute: catenaries, strings, elasticas, beams; by quadrature, collocation.

Supports at (0, 0) and (span, -drop); X runs along the unstrained filament from the left one. Force on a section
(H, V), V_X = weight per unit X; angle theta, theta_X = curvature - M s^3/EI, M_X = s (V cos theta - H sin theta).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_bvp, solve_ivp
from scipy.optimize import brentq
from scipy.special import lambertw

Array = npt.NDArray[np.float64]
Along = Callable[[Array], Array]
End = tuple[str, float]
"""How a beam is held: ``("clamped", angle)``, ``("pinned", 0.0)`` or ``("free", 0.0)``."""


@dataclass(frozen=True)
class Catenary:
    """Inextensible chain (Bernoulli, Leibniz and Huygens 1691): y = a cosh((x - x_low)/a) + constant."""

    a: float
    x_low: float
    tensions: tuple[float, float]

    def at(self, arc: Array) -> tuple[Array, Array]:
        """Shape (x, y) at arc lengths from the left support."""
        start = np.sinh(-self.x_low / self.a)
        x = self.x_low + self.a * np.arcsinh(arc / self.a + start)
        return x, self.a * (np.cosh((x - self.x_low) / self.a) - np.hypot(1.0, start))


def catenary(span: float, drop: float, length: float) -> Catenary:
    """The chain of a length; length^2 - drop^2 = (2 a sinh(span/2a))^2."""
    if length <= np.hypot(span, drop):
        raise ValueError("the chain is too short")
    ratio = np.sqrt(length**2 - drop**2) / span
    q = float(brentq(lambda q: np.sinh(q) / q - ratio, 1e-9, 50.0, xtol=1e-15, rtol=1e-15))
    a = span / (2 * q)
    x_low = span / 2 + a * float(np.arcsinh(drop / (2 * a * np.sinh(q))))
    ends = a * np.cosh(x_low / a), a * np.cosh((span - x_low) / a)
    return Catenary(a, x_low, (float(ends[0]), float(ends[1])))


def linear_stretch(EA: float) -> Along:
    """s of a tension T = EA (s - 1)."""
    return lambda tension: 1 + tension / EA


def true_strain_stretch(EA: float) -> Along:
    """s of a tension T = EA log(s)/s (constant volume), below its largest, EA/e at s = e."""
    # at the branch point itself SciPy returns NaN
    return lambda tension: np.exp(-lambertw(-np.minimum(tension / EA, (1 - 1e-14) * np.exp(-1))).real)


@dataclass(frozen=True)
class String:
    """A string at rest: positions at the X asked for, and the force (H, V) at the left support."""

    x: Array
    y: Array
    horizontal: float
    vertical: float

    def tension(self, X: Array, weight: float) -> Array:
        """T at X."""
        return np.hypot(self.horizontal, self.vertical + weight * X)


def hanging_string(
    stretch: Along, weight: float, length: float, span: float, X: Array, *, drop: float = 0.0, guess: float = 1.0
) -> String:
    """A string without bending under its weight: x_X = s(T) H/T, y_X = s(T) V/T, H constant, V = V_0 + weight X."""
    edges = np.unique(np.concatenate([np.linspace(0, length, 201), X]))
    nodes, weights = np.polynomial.legendre.leggauss(8)
    at = edges[:-1, None] + np.diff(edges)[:, None] * (nodes + 1) / 2

    def pieces(H: float, V0: float) -> tuple[Array, Array]:
        V = V0 + weight * at
        T = np.hypot(H, V)
        per_tension = stretch(T) / T * weights * np.diff(edges)[:, None] / 2
        return (H * per_tension).sum(1), (V * per_tension).sum(1)

    def foot(H: float) -> float:
        reach = weight * length + 4 * H * (1 + abs(drop) / span)
        return float(brentq(lambda V0: pieces(H, V0)[1].sum() + drop, -reach, reach, xtol=1e-16 * reach, rtol=1e-15))

    def miss(H: float) -> float:
        return float(pieces(H, foot(H))[0].sum()) - span

    low = high = guess * weight * length
    while miss(low) > 0:
        low /= 2
    while miss(high) < 0:
        high *= 2
    H = float(brentq(miss, low, high, xtol=1e-15 * high, rtol=1e-14))
    x, y = (np.concatenate([[0.0], np.cumsum(part)]) for part in pieces(H, foot(H)))
    chosen = np.searchsorted(edges, X)
    return String(x[chosen], y[chosen], H, foot(H))


@dataclass(frozen=True)
class Elastic:
    """Elastic section of constant volume, true strain: Q = EA log(s)/s - (3/2) M^2 s^2/EI, Q the force along it."""

    EA: Along
    EI: Along
    curvature: float = 0.0

    def deform(self, X: Array, Q: Array, M: Array) -> tuple[Array, Array]:
        """Stretch and theta_X, by Newton's method."""
        EA, EI = self.EA(X), self.EI(X)
        strain = np.zeros_like(Q)
        for _ in range(40):
            s = np.exp(strain)
            bent = 1.5 * (M * s) ** 2 / EI
            step = (strain / s - (Q + bent) / EA) / ((1 - strain) / s - 2 * bent / EA)
            strain = np.clip(strain - step, -0.8, 0.8)
            if np.abs(step).max() < 1e-15:
                break
        s = np.exp(strain)
        return s, self.curvature - M * s**3 / EI


def uniform(EA: float, EI: float, curvature: float = 0.0) -> Elastic:
    """The same section everywhere."""
    return Elastic(lambda X: np.full_like(X, EA), lambda X: np.full_like(X, EI), curvature)


@dataclass(frozen=True)
class Shape:
    """A bent filament at the X asked for: centreline, tangent angle, moment, and the force at the left end."""

    x: Array
    y: Array
    theta: Array
    M: Array
    force: tuple[float, float] = (0.0, 0.0)


def held(
    section: Elastic, weight: float, length: float, span: float, X: Array, left: End, right: End, *, drop: float = 0.0
) -> Shape:
    """A heavy filament between two supports, or cantilevered, by a boundary-value solver.

    Weight, angles and natural curvature grow from small ones. A free right end makes it the heavy elastica (Bickley
    1934); span and drop then say nothing.
    """
    mesh = np.linspace(0, length, 801)
    free = right[0] == "free"
    chord = left[1] if free else -np.arctan2(drop, span)
    straight = length * np.array([np.cos(chord), np.sin(chord)])
    reach = np.array([span, -drop])
    state = np.array([mesh * np.cos(chord), mesh * np.sin(chord), 0 * mesh + chord, 0 * mesh])
    force = np.zeros(2)
    reached, pace = 0.0, 0.1
    while reached < 1:
        share = min(1.0, reached + pace)
        here = replace(section, curvature=share * section.curvature)

        def rates(at: Array, u: Array, p: Array, here: Elastic = here, load: float = share * weight) -> Array:
            _, _, theta, M = u
            H, V, cos, sin = p[0], p[1] + load * at, np.cos(theta), np.sin(theta)
            s, turning = here.deform(at, H * cos + V * sin, M)
            return np.array([s * cos, s * sin, turning, s * (V * cos - H * sin)])

        def ends(a: Array, b: Array, p: Array, share: float = share) -> Array:
            turned = [
                u[2] - chord - share * (end[1] - chord) if end[0] == "clamped" else u[3]
                for u, end in ((a, left), (b, right))
            ]
            far = (
                p + np.array([0.0, share * weight * length])
                if free
                else b[:2] - straight - share**2 * (reach - straight)
            )
            return np.array([a[0], a[1], *far, *turned])

        done = solve_bvp(rates, ends, mesh, state, force, tol=1e-7, max_nodes=4000)
        if done.success:
            mesh, state, force, reached, pace = done.x, done.y, done.p, share, 1.5 * pace
        else:
            pace /= 2
        if pace < 1e-4:
            raise ArithmeticError(done.message)
    x, y, theta, M = done.sol(X)
    return Shape(x, y, theta, M, (float(force[0]), float(force[1])))


def linear_beam(
    EI: Along, weight: Along, length: float, X: Array, left: End, right: End, *, point_load: float = 0.0
) -> Array:
    """Deflection of a beam of small slope and varying section (Euler and Bernoulli); a load at midspan.

    v' = theta, theta' = -M/EI, M' = V, V' = weight: a solution with zero start, and those of unit theta, M and V.
    """

    def rates(at: float, flat: Array) -> Array:
        v = flat.reshape(4, 4)
        here = np.array([at])
        load = np.array([float(weight(here)[0]), 0, 0, 0])
        return np.array([v[1], -v[2] / float(EI(here)[0]), v[3], load]).ravel()

    start = np.zeros((4, 4))
    start[1:, 1:] = np.eye(3)
    half, rest = X[X <= length / 2], X[X > length / 2]

    def integrate(begin: float, end: float, state: Array) -> Any:
        # short steps, since a section may have kinks
        return solve_ivp(
            rates, (begin, end), state, "DOP853", rtol=1e-11, atol=1e-14, max_step=length / 50, dense_output=True
        )

    first = integrate(0, length / 2, start.ravel())
    middle = first.y[:, -1].copy()
    middle[12] += point_load
    second = integrate(length / 2, length, middle)
    conditions = {"clamped": (0, 1), "pinned": (0, 2), "free": (2, 3)}
    angles = [(start.ravel(), left), (second.y[:, -1], right)]
    rows = [(v.reshape(4, 4)[k], end[1] if k == 1 else 0.0) for v, end in angles for k in conditions[end[0]]]
    # v(0) = 0 is in the ansatz: its row is empty
    system = [(row[1:], wanted - row[0]) for row, wanted in rows if np.any(row[1:])]
    amounts = np.linalg.solve(np.array([row for row, _ in system]), np.array([value for _, value in system]))
    v = np.concatenate([first.sol(half)[:4], second.sol(rest)[:4]], axis=1)
    return v[0] + amounts @ v[1:]
