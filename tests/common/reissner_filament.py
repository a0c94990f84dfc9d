"""Independent oracle: a soft filament that shears, fibre by fibre, in NumPy; two-node elements in space, RK4 in time.

Nothing here comes from the library under test. Kinematics: Reissner (1972), in the plane, with the section's mean
shear; elasticity and flow: (3.1)-(3.8) of Kamrin & Mahadevan, "Soft catenaries" (2012), for deformations that keep the
volume and the section plane, lower triangular in the frame of the section: ``exp(eps)`` and ``exp(-eps/2)`` on the
diagonal, ``exp(eps) gam`` below it. Both factors of ``F = F_e F_p`` are such. Units: length ``L``, stress ``E``, time
``L sqrt(rho/E)`` (the paper's ``t~``), forces per ``E A0``, moments per ``E A0 L``; gravity is
``g~ = rho g L/E = G eps_Y`` and the relaxation time ``tau~ = V sqrt(g~)``.

The plane of the filament is the complex plane, ``z = x + i y``. Nodes carry ``z``, ``z_t`` and the section angle
``psi``; a cell carries all of a section, at its middle, with ``p`` the mean of the two ``psi``::

    Lam + i Gam = (z_X) exp(-i p),  k = psi_X,  A = 1/Lam,  h = delta Lam^(-1/2)
    eps = log Lam - (k/Lam)(h/2) zeta,  gam = c Gam/Lam,  c^2 = kappa_s     of the material fibre zeta in [-1, 1]
    e = eps - eps_p,  u = exp(-3 e/2),  y = gam - u gam_p                    elastic strains, from F_e = F F_p^-1
    w = (e + y^2/4)^2/2 + mu y^2/2,  mu = 1/(2 (1 + nu))                     Hencky's energy to third order
    sigma = w_e = e + y^2/4,  tau = w_y = (mu + sigma/2) y,  d = u tau
    q = sqrt(sigma^2 + 3 d^2),  phi = <q - eps_Y>/tau~
    eps_p_t = phi sigma/q,  gam_p_t + (3/2) gam_p eps_p_t = 3 phi d/q

The left sides of the last line are the two components of ``2 sym(F_p_t F_p^-1)`` that are free. The forces are
derivatives of the stored energy of a cell, ``W = <w>`` per unit ``X``, at fixed plastic strains. By ``eps`` that of a
fibre is ``along = sigma + (3/2) gam_p d``. With ``s0 = <along>, s1 = <along zeta>, t0 = <tau>``,
``B = (h/2)/Lam = (delta/2) Lam^(-3/2)``::

    n1 = W_Lam = (s0 + (3/2) k B s1 - t0 gam)/Lam,   n2 = W_Gam = c t0/Lam,   m = W_k = -B s1.

The sections have no rotary inertia: ``psi`` makes the stored energy stationary, ``m_X + Lam n2 - Gam n1 = 0``, and is
solved for by Newton's method in every right-hand side. Optional is the gradient term of a neck (Audoly & Hutchinson,
JMPS 2016): ``n1`` gains ``-(b Lam_X)_X``, ``b = beta delta^2 T+/Lam^4``, ``T = s0/Lam``, with ``b Lam_X`` on the nodes
between two cells, ``b`` their mean, and zero at both ends. Its power is ``sum b Lam_X Lam_Xt dX``. Optional is surface
tension: its energy is ``2 surface s^(1/2)`` per unit ``X``, ``s = |z_X|``, ``surface`` = gamma P0/(2 A0 E), so that the
force gains ``surface s^(-1/2)`` along ``z_X``; of a circle also ``surface (delta/2)^2 s_X^2/(4 s^(9/2))`` at the inner
nodes, ``s`` their mean. The section is a narrow rectangle or, with its own weights, a circle.
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


class Fibres(NamedTuple):
    """Elastic strains and stresses, each ``(fibres, cells)``."""

    y: Array
    lag: Array  # y_e = (3/2) u gam_p
    sigma: Array
    tau: Array
    driving: Array


class Section(NamedTuple):
    """Strains, section means of the stresses and conjugate forces, each ``(cells,)``, and its fibres."""

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
    fibres: Fibres


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
        self.c, self.mu = kappa_s**0.5, 1 / (2 * (1 + nu))
        if circle:  # Chebyshev points of the second kind: the width is a semicircle
            angle = np.pi * np.arange(fibres, 0, -1) / (fibres + 1)
            self.zeta, self.mean = np.cos(angle), 2 / (fibres + 1) * np.sin(angle) ** 2
        else:
            self.zeta, weight = np.polynomial.legendre.leggauss(fibres)
            self.mean = 0.5 * weight
        self.moment = self.mean * self.zeta
        self.square = self.moment * self.zeta
        self.surface, self.sloping = surface, surface * delta**2 / 16 if circle else 0.0
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

    def section(self, z_X: Complex, psi: Array, state: State) -> Section:
        """All of a section."""
        turned = z_X * np.exp(-0.5j * (psi[1:] + psi[:-1]))
        Lam, Gam, k = turned.real, turned.imag, (psi[1:] - psi[:-1]) / self.dX
        B = 0.5 * self.delta * Lam**-1.5
        gam = self.c * Gam / Lam
        e = np.log(Lam) - np.multiply.outer(self.zeta, k * B) - state.eps_p
        u = np.exp(-1.5 * e)
        y = gam - u * state.gam_p
        sigma = e + 0.25 * y * y
        tau = (self.mu + 0.5 * sigma) * y
        lag = 1.5 * u * state.gam_p
        along = sigma + lag * tau
        s0, s1, t0 = self.mean @ along, self.moment @ along, self.mean @ tau
        n1 = (s0 + 1.5 * k * B * s1 - t0 * gam) / Lam
        return Section(Lam, Gam, k, s0, s1, t0, B, n1, self.c * t0 / Lam, -B * s1, Fibres(y, lag, sigma, tau, u * tau))

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
        Lam, Gam, k, s0, s1, t0, B, n1, n2, _, (y, lag, sigma, _, _) = q
        # Of w(eps, gam) first; y_e = lag, y_ee = -(3/2) lag, and l = sigma is e + y^2/4.
        bend = -1.5 * lag
        w_ee = (1 + 0.5 * y * lag) ** 2 + sigma * 0.5 * (lag * lag + y * bend) + self.mu * (lag * lag + y * bend)
        w_eg = (1 + 0.5 * y * lag) * 0.5 * y + (0.5 * sigma + self.mu) * lag
        w_gg = self.mean @ (0.25 * y * y + 0.5 * sigma + self.mu)
        ee = [weights @ w_ee for weights in (self.mean, self.moment, self.square)]
        eg = [weights @ w_eg for weights in (self.mean, self.moment)]
        gam, p = self.c * Gam / Lam, 1.5 * k * B
        beside = eg[0] + p * eg[1]
        W_LL = ee[0] + p * (2 * ee[1] + p * ee[2]) - gam * (2 * beside - gam * w_gg - 2 * t0) - s0 - 2.5 * p * s1
        W_LG = self.c * (beside - gam * w_gg - t0)
        W_Lk = B * (1.5 * s1 - ee[1] - p * ee[2] + gam * eg[1])
        W_Gk = -self.c * B * eg[1]
        W_pp = (gam / self.c) ** 2 * W_LL - 2.0 * gam / self.c * W_LG + self.c**2 * w_gg - Lam * n1 - Gam * n2
        return W_pp, gam / self.c * W_Lk - W_Gk, B * B * ee[2]

    def solve_angles(self, state: State) -> Section:
        """Section angles that balance moments, from those of the last call; ``psi = 0`` at both ends."""
        z_X, dX = (state.z[1:] - state.z[:-1]) / self.dX, self.dX
        psi = self.psi
        for _ in range(40):
            q = self.add_gradient(self.section(z_X, psi, state))
            turning = 0.5 * dX * (q.Lam * q.n2 - q.Gam * q.n1)
            residual = q.m[1:] - q.m[:-1] + turning[1:] + turning[:-1]  # minus the energy's derivative by psi
            W_pp, W_pk, W_kk = self.hessian(q)
            pp, kk = 0.25 * dX * W_pp, W_kk / dX
            diagonal = (pp + kk + W_pk)[:-1] + (pp + kk - W_pk)[1:]
            beside = (pp - kk)[1:-1]
            step = dgtsv(beside, diagonal, beside, residual)[3]
            psi[1:-1] += step
            if np.abs(step).max() < SETTLED:
                return self.add_gradient(self.section(z_X, psi, state))
        raise FloatingPointError("the section angles do not settle: the filament is broken or the step too long")

    def joints(self, s: Array) -> tuple[Array, Array]:
        """Stretch and its slope at the inner nodes."""
        return (self.dX[1:] * s[1:] + self.dX[:-1] * s[:-1]) / (2 * self.apart), np.diff(s) / self.apart

    def pull(self, s: Array) -> Array:
        """Derivative of the surface's energy by the stretch of each cell, over its length."""
        at, D = self.joints(s)
        by_slope = np.pad(2 * self.sloping * D * at**-4.5, 1)
        by_stretch = np.pad(-4.5 * self.sloping * D**2 * at**-5.5, 1)
        return self.surface * s**-0.5 - np.diff(by_slope) / self.dX + (by_stretch[1:] + by_stretch[:-1]) / 2

    def surface_energy(self, s: Array) -> float:
        """What the surface has gained since the start."""
        at, D = self.joints(s)
        return float(2 * self.surface * self.dX @ (s**0.5 - 1) + self.sloping * self.apart @ (D**2 * at**-4.5))

    def rhs(self, t: float, Y: Array) -> Array:
        """Time derivative of the state."""
        out = np.empty_like(Y)
        state, rate = self.views(Y), self.views(out)
        q = self.solve_angles(state)
        force = (q.n1 + 1j * q.n2) * np.exp(0.5j * (self.psi[1:] + self.psi[:-1]))
        z_X = (state.z[1:] - state.z[:-1]) / self.dX
        if self.surface:
            force += self.pull(np.abs(z_X)) * z_X / np.abs(z_X)
        rate.z[:] = state.v
        rate.v[1:-1] = (force[1:] - force[:-1]) / self.mass[1:-1] - 1j * self.gravity(t)
        rate.v[-1] = 0.0
        rate.v[0] = 1j * (force[0].imag / self.mass[0] - self.gravity(t)) if self.symmetric else 0.0
        sigma, driving = q.fibres.sigma, q.fibres.driving
        equivalent = np.sqrt(sigma * sigma + 3.0 * driving * driving)
        flow = np.maximum(equivalent - self.eps_Y, 0.0) / self.tau
        over = flow / np.maximum(equivalent, 1e-200)
        np.multiply(over, sigma, out=rate.eps_p)
        np.multiply(3.0 * over, driving, out=rate.gam_p)
        rate.gam_p[:] -= 1.5 * state.gam_p * rate.eps_p
        rate.sums[0] = -self.gravity(t) * (self.mass @ state.v.imag)
        rate.sums[1] = self.dX @ (self.mean @ (flow * equivalent))
        return out

    def energies(self, Y: Array) -> dict[str, float]:
        """Kinetic and elastic energy, and what went to and from the filament since the start."""
        state = self.views(Y)
        q = self.solve_angles(state)
        return {
            "kinetic": float(0.5 * self.mass @ np.abs(state.v) ** 2),
            "elastic": float(0.5 * self.dX @ (self.mean @ (q.fibres.sigma**2 + self.mu * q.fibres.y**2))),
            "surface": self.surface_energy(np.abs(np.diff(state.z) / self.dX)),
            "dissipated": float(state.sums[1]),
            "gradient": self.gradient_work,
            "work": float(state.sums[0]),
        }

    def stable_step(self) -> float:
        """RK4's limit times `SAFETY`.

        The fastest wave of the straight grid is axial, ``w = 2/dX``: without rotary inertia flexural waves end as shear
        waves, slower by ``c sqrt(mu)``. Relaxation, ``lambda^2 + lambda/tau~ + w^2 = 0``, has ``1/tau~`` from slow
        waves. The gradient term quickens an axial wave by ``1 + 2 b/dX^2``, which is left to the margin.
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
