"""Independent oracle: a soft filament that shears, fibre by fibre, in NumPy; two-node elements in space, RK4 in time.

Nothing here comes from the library under test. Kinematics: Reissner (1972), in the plane, with the section's mean
shear; flow: von Mises, of (3.1)-(3.8) of Kamrin & Mahadevan, "Soft catenaries" (2012), under an axial and a shear
stress. Units: length ``L``, stress ``E``, time ``L sqrt(rho/E)`` (the paper's ``t~``), forces per ``E A0``, moments per
``E A0 L``; gravity is ``g~ = rho g L/E = G eps_Y`` and the relaxation time ``tau~ = V sqrt(g~)``.

The plane of the filament is the complex plane, ``z = x + i y``. Nodes carry ``z``, ``z_t`` and the section angle
``psi``; a cell carries all of a section, at its middle, with ``p`` the mean of the two ``psi``::

    Lam + i Gam = (z_X) exp(-i p),  k = psi_X,  A = 1/Lam,  h = delta Lam^(-1/2)
    eps = log Lam - (k/Lam)(h/2) zeta,  gam = Gam/Lam           of the material fibre zeta in [-1, 1]
    sigma = eps - eps_p,  tau = c (gam - gam_p),  c = kappa_s/(2 (1 + nu))
    eps_p_t = phi sigma/q,  gam_p_t = 3 phi tau/q,  q = sqrt(sigma^2 + 3 tau^2),  phi = <q - eps_Y>/tau~

The forces are derivatives of the stored energy of a cell, ``W = <sigma^2>/2 + <tau^2>/(2 c)`` per unit ``X``, at fixed
plastic strains. With ``s0 = <sigma>, s1 = <sigma zeta>, t0 = <tau>, B = (h/2)/Lam = (delta/2) Lam^(-3/2)``::

    n1 = W_Lam = (s0 + (3/2) k B s1 - t0 Gam/Lam)/Lam,   n2 = W_Gam = t0/Lam,   m = W_k = -B s1.

The sections have no rotary inertia: ``psi`` makes the stored energy stationary, ``m_X + Lam n2 - Gam n1 = 0``, and is
solved for by Newton's method in every right-hand side. Optional is the gradient term of a neck (Audoly & Hutchinson,
JMPS 2016): ``n1`` gains ``-(b Lam_X)_X``, ``b = beta delta^2 T+/Lam^4``, ``T = s0/Lam``, with ``b Lam_X`` on the nodes
between two cells, ``b`` their mean, and zero at both ends. Its power is ``sum b Lam_X Lam_Xt dX``. Optional is surface
tension: its energy is ``2 surface s^(1/2)`` per unit ``X``, ``s = |z_X|``, ``surface`` = gamma P0/(2 A0 E), so that the
force gains ``surface s^(-1/2)`` along ``z_X``. The section is a rectangle or, with its own weights, a circle.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dgtsv

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

E_STAR = 4e6 / (1900 * 9.81 * 0.2)  # E/(rho g L) of the paper's section 3
REACH = 2.61  # RK4 is stable in the left half of the disc of this radius
SAFETY = 0.9  # fraction of that used for the step
SETTLED = 1e-9  # last Newton update of psi; the error left is its square, or 1e-3 of it with the gradient term


@dataclass(frozen=True)
class Result:
    """One oracle run; lengths in ``L``, energies in ``E A0 L`` and of the span that ``nodes`` covers."""

    times: Array
    midpoint: Array  # y of the first node: half span
    z: Complex  # (times, nodes)
    psi: Array  # (times, nodes)
    energies: dict[str, Array]  # (times,): kinetic, elastic, surface, dissipated, gradient, work
    rhs_microseconds: float  # each includes a quarter of an RK4 update
    steps: int


class Section(NamedTuple):
    """Strains, section means of the stresses and conjugate forces, each ``(cells,)``."""

    Lam: Array
    Gam: Array
    k: Array
    s0: Array
    s1: Array
    t0: Array
    B: Array
    n1: Array
    n2: Array
    m: Array


class State(NamedTuple):
    """Views of the flat state vector."""

    z: Complex  # (nodes,)
    v: Complex  # (nodes,)
    eps_p: Array  # (fibres, cells)
    gam_p: Array  # (fibres, cells)
    sums: Array  # (2,): work of gravity, dissipation


class Filament:
    """Semi-discrete filament; ``g`` and ``tau`` are ``g~`` and ``tau~``, the other arguments those of `run`.

    ``nodes`` end in a clamp. They begin with one too, unless they begin at 0: that is a symmetry plane.
    """

    def __init__(self, nodes: Array, delta: float, g: float, tau: float, eps_Y: float, fibres: int, ramp: float = 10.0,
                 beta: float | None = None, kappa_s: float = 5 / 6, nu: float = 0.45, surface: float = 0.0,
                 circle: bool = False) -> None:  # fmt: skip
        self.X, self.dX = np.asarray(nodes, float), np.diff(nodes)
        if self.X.size < 4 or self.dX.min() <= 0.0 or fibres < 2:
            raise ValueError("needs three cells of positive length and two fibres")
        self.delta, self.g, self.tau, self.eps_Y, self.ramp, self.beta = delta, g, tau, eps_Y, ramp, beta
        self.c = kappa_s / (2 * (1 + nu))
        if circle:  # Chebyshev points of the second kind: the width is a semicircle
            angle = np.pi * np.arange(fibres, 0, -1) / (fibres + 1)
            self.zeta, self.mean = np.cos(angle), 2 / (fibres + 1) * np.sin(angle) ** 2
        else:
            self.zeta, weight = np.polynomial.legendre.leggauss(fibres)
            self.mean = 0.5 * weight
        self.moment = self.mean * self.zeta
        self.spread = float(self.moment @ self.zeta)  # <zeta^2>
        self.surface = surface
        self.symmetric = bool(self.X[0] == 0.0)
        self.n, self.fibres = self.X.size, fibres
        self.mass = np.zeros(self.n)
        self.mass[:-1] += 0.5 * self.dX
        self.mass[1:] += 0.5 * self.dX
        self.apart = 0.5 * (self.dX[1:] + self.dX[:-1])  # middles of neighbouring cells
        self.psi = np.zeros(self.n)
        self.slope = self.double_force = np.zeros(self.n - 2)  # Lam_X and b Lam_X on the inner nodes
        self.audited = self.slope, self.double_force  # when gradient_work last grew
        self.gradient_work = 0.0

    def initial(self) -> Array:
        """Straight, at rest, stress free."""
        Y = np.zeros(4 * self.n + 2 * self.fibres * (self.n - 1) + 2)
        self.views(Y).z[:] = self.X
        return Y

    def views(self, Y: Array) -> State:
        """Split a flat vector."""
        n2, shape = 2 * self.n, (self.fibres, self.n - 1)
        p = 2 * n2 + shape[0] * shape[1]
        eps_p, gam_p = Y[2 * n2 : p].reshape(shape), Y[p:-2].reshape(shape)
        return State(Y[:n2].view(complex), Y[n2 : 2 * n2].view(complex), eps_p, gam_p, Y[-2:])

    def gravity(self, t: float) -> float:
        """Quintic smooth step from 0 to ``g~`` over ``0 < t~ < ramp``."""
        if t >= self.ramp:
            return self.g
        q = t / self.ramp
        return self.g * q * q * q * (10.0 - q * (15.0 - 6.0 * q))

    def section(self, z_X: Complex, psi: Array, P: tuple[Array, Array, Array]) -> Section:
        """All of a section; ``P`` are ``<eps_p>, <eps_p zeta>, <gam_p>`` of the cells."""
        turned = z_X * np.exp(-0.5j * (psi[1:] + psi[:-1]))
        Lam, Gam, k = turned.real, turned.imag, (psi[1:] - psi[:-1]) / self.dX
        B = 0.5 * self.delta * Lam**-1.5
        gam = Gam / Lam
        s0, s1, t0 = np.log(Lam) - P[0], -k * B * self.spread - P[1], self.c * (gam - P[2])
        n1 = (s0 + 1.5 * k * B * s1 - t0 * gam) / Lam
        return Section(Lam, Gam, k, s0, s1, t0, B, n1, t0 / Lam, -B * s1)

    def add_gradient(self, q: Section) -> Section:
        """``n1`` with the gradient term of a neck, if there is one."""
        if self.beta is None:
            return q
        b = self.beta * self.delta**2 * np.maximum(q.s0, 0.0) / q.Lam**5  # T = s0/Lam
        self.slope = (q.Lam[1:] - q.Lam[:-1]) / self.apart
        self.double_force = 0.5 * (b[1:] + b[:-1]) * self.slope
        ends = np.concatenate(([0.0], self.double_force, [0.0]))
        return q._replace(n1=q.n1 - (ends[1:] - ends[:-1]) / self.dX)

    def hessian(self, q: Section) -> tuple[Array, Array, Array]:
        """Second derivatives of a cell's energy by ``(p, p)``, ``(p, k)``, ``(k, k)``, the gradient term left out."""
        Lam, Gam, k, _, s1, t0, B, n1, n2, _ = q
        gam = Gam / Lam
        W_LL = (
            (1.0 + 0.75 * k * B * (3.0 * self.spread * k * B - 3.0 * s1) + gam * (self.c * gam + t0)) / Lam - n1
        ) / Lam
        W_LG, W_GG = -(self.c * gam + t0) / Lam**2, self.c / Lam**2
        W_Lk = 0.5 * B * (3.0 * s1 - 3.0 * self.spread * k * B) / Lam
        W_pp = Gam * Gam * W_LL - 2.0 * Lam * Gam * W_LG + Lam * Lam * W_GG - Lam * n1 - Gam * n2
        return W_pp, Gam * W_Lk, B * B * self.spread

    def solve_angles(self, z: Complex, P: tuple[Array, Array, Array]) -> Section:
        """Section angles that balance moments, from those of the last call; ``psi = 0`` at both ends."""
        z_X, dX = (z[1:] - z[:-1]) / self.dX, self.dX
        psi = self.psi
        for _ in range(40):
            q = self.add_gradient(self.section(z_X, psi, P))
            turning = 0.5 * dX * (q.Lam * q.n2 - q.Gam * q.n1)
            residual = q.m[1:] - q.m[:-1] + turning[1:] + turning[:-1]  # minus the energy's derivative by psi
            W_pp, W_pk, W_kk = self.hessian(q)
            pp, kk = 0.25 * dX * W_pp, W_kk / dX
            diagonal = (pp + kk + W_pk)[:-1] + (pp + kk - W_pk)[1:]
            beside = (pp - kk)[1:-1]
            step = dgtsv(beside, diagonal, beside, residual)[3]
            psi[1:-1] += step
            if np.abs(step).max() < SETTLED:
                return self.add_gradient(self.section(z_X, psi, P))
        raise FloatingPointError("the section angles do not settle: the filament is broken or the step too long")

    def means(self, state: State) -> tuple[Array, Array, Array]:
        """``<eps_p>, <eps_p zeta>, <gam_p>`` of the cells."""
        return self.mean @ state.eps_p, self.moment @ state.eps_p, self.mean @ state.gam_p

    def fibre_stresses(self, q: Section, state: State) -> tuple[Array, Array]:
        """``sigma, tau`` of ``(fibres, cells)``."""
        sigma = np.log(q.Lam) - np.multiply.outer(self.zeta, q.k * q.B) - state.eps_p
        return sigma, self.c * (q.Gam / q.Lam - state.gam_p)

    def rhs(self, t: float, Y: Array) -> Array:
        """Time derivative of the state."""
        out = np.empty_like(Y)
        state, rate = self.views(Y), self.views(out)
        q = self.solve_angles(state.z, self.means(state))
        force = (q.n1 + 1j * q.n2) * np.exp(0.5j * (self.psi[1:] + self.psi[:-1]))
        z_X = (state.z[1:] - state.z[:-1]) / self.dX
        force += self.surface * np.abs(z_X) ** -1.5 * z_X
        rate.z[:] = state.v
        rate.v[1:-1] = (force[1:] - force[:-1]) / self.mass[1:-1] - 1j * self.gravity(t)
        rate.v[-1] = 0.0
        rate.v[0] = 1j * (force[0].imag / self.mass[0] - self.gravity(t)) if self.symmetric else 0.0
        sigma, tau = self.fibre_stresses(q, state)
        equivalent = np.sqrt(sigma * sigma + 3.0 * tau * tau)
        flow = np.maximum(equivalent - self.eps_Y, 0.0) / self.tau
        over = flow / np.maximum(equivalent, 1e-200)
        np.multiply(over, sigma, out=rate.eps_p)
        np.multiply(3.0 * over, tau, out=rate.gam_p)
        rate.sums[0] = -self.gravity(t) * (self.mass @ state.v.imag)
        rate.sums[1] = self.dX @ (self.mean @ (flow * equivalent))
        return out

    def energies(self, Y: Array) -> dict[str, float]:
        """Kinetic and elastic energy, and what went to and from the filament since the start."""
        state = self.views(Y)
        q = self.solve_angles(state.z, self.means(state))
        sigma, tau = self.fibre_stresses(q, state)
        return {
            "kinetic": float(0.5 * self.mass @ np.abs(state.v) ** 2),
            "elastic": float(0.5 * self.dX @ (self.mean @ (sigma**2 + tau**2 / self.c))),
            "surface": float(2 * self.surface * self.dX @ (np.abs(np.diff(state.z) / self.dX) ** 0.5 - 1)),
            "dissipated": float(state.sums[1]),
            "gradient": self.gradient_work,
            "work": float(state.sums[0]),
        }

    def stable_step(self) -> float:
        """RK4's limit times `SAFETY`.

        The fastest wave of the straight grid is axial, ``w = 2/dX``: without rotary inertia flexural waves end as shear
        waves, slower by ``sqrt(c)``. Relaxation, ``lambda^2 + lambda/tau~ + w^2 = 0``, has ``1/tau~`` from slow waves.
        The gradient term quickens an axial wave by ``1 + 2 b/dX^2``, which is left to the margin.
        """
        return SAFETY * REACH / max(2.0 / self.dX.min(), 1.0 / self.tau)

    def advance(self, Y: Array, t: float, t_end: float, dt_max: float) -> int:
        """Integrate ``Y`` in place from ``t`` to ``t_end`` by classical RK4; return the number of (equal) steps.

        The work of the gradient term is summed by the trapezoidal rule in ``Lam_X``, so it is of second order.
        """
        steps = max(1, int(np.ceil((t_end - t) / dt_max - 1e-9)))
        dt, t0 = (t_end - t) / steps, t
        for i in range(steps + 1):
            t = t0 + i * dt
            k1 = self.rhs(t, Y)
            slope, double_force = self.audited
            self.gradient_work += float(0.5 * self.apart @ ((self.double_force + double_force) * (self.slope - slope)))
            self.audited = self.slope, self.double_force
            if i < steps:
                k2 = self.rhs(t + 0.5 * dt, Y + 0.5 * dt * k1)
                k3 = self.rhs(t + 0.5 * dt, Y + 0.5 * dt * k2)
                k4 = self.rhs(t + dt, Y + dt * k3)
                Y += dt / 6.0 * (k1 + 2.0 * (k2 + k3) + k4)
        return steps


def run(delta: float, G: float, V: float, nodes: int | Array, fibres: int = 6, duration: float = 460.0,
        ramp: float = 10.0, beta: float | None = None, kappa_s: float = 5 / 6, nu: float = 0.45,
        times: Sequence[float] = (46.0, 115.0, 230.0, 460.0), step: float = 1.0, surface: float = 0.0,
        circle: bool = False, stiffness: float = E_STAR) -> Result:  # fmt: skip
    """Drop a straight Bingham filament, clamped at both ends, under ramped gravity."""
    X = np.linspace(0.0, 0.5, nodes + 1) if isinstance(nodes, int) else nodes
    g = 1.0 / stiffness
    f = Filament(X, delta, g, V * g**0.5, g / G, fibres, ramp, beta, kappa_s, nu, surface, circle)
    ends = np.array(sorted({float(o) for o in times if o < duration} | {float(duration)}))
    dt, Y, t, steps, wall = step * f.stable_step(), f.initial(), 0.0, 0, 0.0
    shapes, angles, table = [], [], []
    for end in ends:
        start = perf_counter()
        steps += f.advance(Y, t, end, dt)
        wall += perf_counter() - start
        t = float(end)
        if not np.isfinite(Y).all():
            raise FloatingPointError(f"the solution is lost before t~ = {t:g}: unstable step or a broken filament")
        shapes.append(f.views(Y).z.copy())
        angles.append(f.psi.copy())
        table.append(f.energies(Y))
    z = np.array(shapes)
    energies = {name: np.array([row[name] for row in table]) for name in table[0]}
    return Result(ends, z[:, 0].imag, z, np.array(angles), energies, 1e6 * wall / (4 * steps), steps)
