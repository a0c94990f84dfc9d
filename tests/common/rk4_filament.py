"""Independent oracle: the soft filament of Kamrin & Mahadevan (2012) in NumPy, staggered in space, RK4 in time.

Nothing here comes from the library under test. Numbers in brackets are the paper's equations; ``X`` is its ``x0``,
``s`` its ``s_x0``. Units: length ``L``, stress ``E``, time ``L sqrt(rho/E)`` (the paper's ``t~``), forces per ``E
A0``, moments per ``E A0 L``; gravity is then ``g~ = 1/E* = G eps_Y`` and the relaxation time ``tau~ = V/sqrt(E*)``.

Half span ``0 <= X <= 1/2``: symmetry plane at node 0 (``x = 0, theta = 0, N = 0``), support at node ``N``. The plane of
the filament is the complex plane: ``z = x + i y``, ``t = exp(i theta)``, ``n = i t``, so that (2.1)-(2.3) read ::

    z_tt = d/dX[(Q + i N) t] - i g~(t),        N = M_X / s.

Nodes carry position, velocity, ``theta_X``, ``M``, bending plastic state; cells ``s``, ``Q``, axial plastic state. A
ghost cell at each end mirrors its neighbour's chord (conjugate): at midspan this is exact, at a clamp it states
``theta = 0``. The stress in a section is ``sigma_0 + sigma_1 zeta``, ``zeta = 2 z/h`` in [-1, 1] (2.23); ``k2 =
<zeta^2>`` is 1/3 (rectangle) or 1/4 (circle). The elastic material scheme is the exact gradient of its discrete
energy (see `energy`).

The printed closure has no energy: Q and M do not derive from a potential, and where the filament is bent to a
curvature kappa (per L) axial and flexural waves that run equally fast (wave number 2/(delta sqrt(k2)), wavelength 1.8
delta) feed on it at a rate of order kappa^2 delta sqrt(k2)/2. RK4 damps such waves near its stability limit as (w
dt)^6/144 a step: enough at N = 40, too little at N = 80, where the run is lost by t~ = 230 unless
``short_wave_damping`` (0.5, say) is asked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from time import perf_counter
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Law = Literal["elastic", "maxwell", "bingham"]
Closure = Literal["printed", "material"]
Ends = Literal["clamped", "pinned"]
Section = Literal["rectangle", "circle"]

E_STAR = 4e6 / (1900 * 9.81 * 0.2)  # E/(rho g L) of the paper's section 3
SAFETY = 0.9  # fraction of RK4's stability limit used for the step


@dataclass(frozen=True)
class Result:
    """One oracle run; lengths in ``L``. Each ``rhs_microseconds`` includes a quarter of an RK4 update."""

    times: Array
    midpoint: Array
    x: Array  # (times, N + 1), from the symmetry plane to the support; the last row is the final shape; y likewise
    y: Array
    stretch: Array  # final, on the cells
    rhs_microseconds: float
    steps: int
    wall_seconds: float


def overstress_means(S: Array, eps_Y: float, rate: float, work: Array, out: Array) -> None:
    """Section means of the Bingham-Norton overstress, rectangle: (2.26)-(2.27) without dividing by the stress slope.

    With ``S = |sigma_0|``, ``B = |sigma_1|`` (the rest is odd symmetry) the overstress is ``u = S + B - eps_Y`` at the
    more stressed edge and ``u = B - S - eps_Y``, of the other sign, at the opposite one. From an edge the yielded zone
    reaches a depth ``l = min(u/B, 2)`` in ``zeta``, so ``int = l (u - B l/2)`` and, the arm being ``1 - l'``,
    ``int zeta = int - l^2 (u/2 - B l/3)``. ``l = 2`` when all of the section yields; ``B = 0`` needs no case.
    """
    a, u, l, r, q = work  # noqa: E741
    np.abs(S, out=a)
    np.add(a[1], a[0], out=u[0])
    np.subtract(a[1], a[0], out=u[1])
    np.maximum(np.subtract(u, eps_Y, out=u), 0.0, out=u)
    np.multiply(u, 0.5, out=q)  # u/2
    np.add(np.maximum(q, a[1], out=r), 1e-200, out=r)
    np.divide(u, r, out=l)  # min(u/B, 2)
    np.multiply(a[1], l, out=r)  # B l
    np.subtract(u, np.multiply(r, 0.5, out=a), out=a)
    np.multiply(a, l, out=a)  # int = l (u - B l/2)
    np.subtract(q, np.multiply(r, 1.0 / 3.0, out=r), out=q)
    np.multiply(np.multiply(q, l, out=q), l, out=q)  # l^2 (u/2 - B l/3)
    np.subtract(a, q, out=q)
    np.subtract(a[0], a[1], out=r[0])
    np.add(q[0], q[1], out=r[1])
    np.copysign(np.multiply(r, 0.5 * rate, out=r), S, out=out)


class Filament:
    """Semi-discrete filament; ``g`` and ``tau`` are ``g~`` and ``tau~``, the other arguments those of `run`.

    State, one flat vector: ``z``, ``z_t`` (complex, nodes), plastic state on cells, on nodes ((a_0, a_1) or (P, C)).
    """

    def __init__(self, delta: float, g: float, tau: float, eps_Y: float, law: Law, closure: Closure, N: int,
                 g_on: float = 10.0, ends: Ends = "clamped", section: Section = "rectangle",
                 short_wave_damping: float = 0.0) -> None:  # fmt: skip
        known = ((law, Law), (closure, Closure), (ends, Ends), (section, Section))
        if any(value not in get_args(kind) for value, kind in known):
            raise ValueError(f"unknown choice among {law!r}, {closure!r}, {ends!r}, {section!r}")
        if law == "bingham" and section == "circle":
            raise ValueError("the closed forms (2.26)-(2.27) are for a rectangle")
        self.delta, self.g, self.tau, self.eps_Y, self.g_on = delta, g, tau, eps_Y, g_on
        self.law, self.closure, self.pinned, self.N, self.dX = law, closure, ends == "pinned", N, 0.5 / N
        self.k2 = 1.0 / 3.0 if section == "rectangle" else 0.25
        self.size = 4 * (N + 1) + 2 * N + 1
        self.stage, self.K = np.zeros(self.size), np.zeros((4, self.size))
        self._in, self._out = self.views(self.stage), [self.views(k) for k in self.K]
        self.d, self.dc, self.t, self.F = (np.zeros(N + 2, complex) for _ in range(4))  # cells with ghosts
        self.s, self.s0, self.l = np.ones(N + 2), np.zeros(N + 2), np.ones(N + 2)
        self.turn = np.zeros(N + 1, complex)
        self.theta_X, self.sn, self.r, self.M, self.m, self.c = (np.zeros(N + 1) for _ in range(6))  # nodes
        self.S, self.means, self.work = np.zeros((2, 2 * N + 1)), np.zeros((2, 2 * N + 1)), np.zeros((5, 2, 2 * N + 1))
        k_c = 2.0 / (delta * self.k2**0.5)  # v_t = -damping (k/k_c)^4 v, support and midspan stencils left out
        D = np.diff(np.eye(N + 1), 2, axis=0) / (k_c * self.dX) ** 2
        self.damping = short_wave_damping * D.T @ D if short_wave_damping else None
        self.d_in, self.s_in, self.s0_in = self.d[1:-1], self.s[1:-1], self.s0[1:-1]
        self.t_in, self.F_in, self.Q, self.shear = self.t[1:-1], self.F[1:-1], self.F.real[1:-1], self.F.imag[1:-1]
        self.l_in, self.turn_re, self.turn_im = self.l[1:-1], self.turn.real, self.turn.imag

    def views(self, Y: Array) -> tuple[NDArray[np.complex128], NDArray[np.complex128], Array, Array]:
        """Split a flat vector into z, z_t, plastic state on cells, on nodes."""
        n = 2 * (self.N + 1)
        p = Y[2 * n :]
        return Y[:n].view(complex), Y[n : 2 * n].view(complex), p[: self.N], p[self.N :]

    def initial(self) -> Array:
        """Straight, at rest, stress free."""
        Y = np.zeros(self.size)
        self.views(Y)[0][:] = np.arange(self.N + 1) * self.dX
        return Y

    def gravity(self, t: float) -> float:
        """Quintic smooth step from 0 to ``g~`` over ``0 < t~ < g_on``."""
        if t >= self.g_on:
            return self.g
        q = t / self.g_on
        return self.g * q * q * q * (10.0 - q * (15.0 - 6.0 * q))

    def stresses(self) -> None:
        """Kinematics and the stresses of the stage: sigma_0 on cells, sigma_1 on nodes, both averaged to the other."""
        N, S, r, sn = self.N, self.S, self.r, self.sn
        z, _, axial, bending = self._in
        np.subtract(z[1:], z[:-1], out=self.d_in)
        np.conjugate(self.d[1 : N + 1 : N - 1], out=self.d[:: N + 1])  # ghosts
        np.abs(self.d, out=self.l)
        np.divide(self.l, self.dX, out=self.s)  # (2.5)
        np.multiply(self.d[1:], np.conjugate(self.d, out=self.dc)[:-1], out=self.turn)
        np.divide(np.arctan2(self.turn_im, self.turn_re, out=self.theta_X), self.dX, out=self.theta_X)  # (cross, dot)
        np.multiply(np.add(self.s[1:], self.s[:-1], out=sn), 0.5, out=sn)
        np.multiply(np.sqrt(sn, out=r), sn, out=r)  # s^(3/2)
        np.log(self.s_in, out=self.s0_in)
        s1 = S[1, N:]
        if self.closure == "material":  # sigma = log s - theta_s (h/2) zeta - a_0 - a_1 zeta
            np.subtract(self.s0_in, axial, out=self.s0_in)
            np.multiply(np.divide(self.theta_X, r, out=s1), -0.5 * self.delta, out=s1)
            np.subtract(s1, bending, out=s1)
        else:  # T/A = log s - P/A and M(h/2)/I = -(h/2)(theta_X + C/I), (2.11)
            np.subtract(self.s0_in, np.multiply(self.s_in, axial, out=S[0, :N]), out=self.s0_in)
            np.multiply(np.multiply(bending, r, out=s1), 4.0 / (self.k2 * self.delta**2), out=s1)  # (C/I) s^(-1/2)
            np.add(s1, np.divide(self.theta_X, np.sqrt(sn, out=self.c), out=self.c), out=s1)
            np.multiply(s1, -0.5 * self.delta, out=s1)
        if self.pinned:
            s1[N] = 0.0
        self.s0[:: N + 1] = self.s0[1 : N + 1 : N - 1]

    def rhs(self, t: float, k: int) -> None:
        """Time derivative of ``self.stage`` into ``self.K[k]``."""
        N, S, velocity = self.N, self.S, self._in[1]
        dz, dv, d_axial, d_bending = self._out[k]
        self.stresses()
        # T = A <sigma>, M = A (h/2) <sigma zeta>; N = M_X/s
        np.divide(self.s0_in, self.s_in, out=self.Q)
        np.multiply(np.divide(S[1, N:], self.r, out=self.M), 0.5 * self.delta * self.k2, out=self.M)
        np.divide(np.subtract(self.M[1:], self.M[:-1], out=self.shear), self.l_in, out=self.shear)
        if self.closure == "material":  # Q = T + (3/2) M theta_s
            np.divide(np.multiply(self.M, self.theta_X, out=self.m), self.sn, out=self.m)
            np.multiply(self.m, 0.75, out=self.m)
            np.add(np.add(self.Q, self.m[1:], out=self.Q), self.m[:-1], out=self.Q)
        np.multiply(self.F_in, np.divide(self.d_in, self.l_in, out=self.t_in), out=self.F_in)  # (Q + i N) t
        self.F[0] = self.F[1].conjugate()
        dz[:] = velocity
        np.divide(np.subtract(self.F[1:-1], self.F[:-2], out=dv[:-1]), self.dX, out=dv[:-1])  # the support rests
        np.subtract(dv[:-1], 1j * self.gravity(t), out=dv[:-1])
        if self.law == "elastic":
            return
        if self.law == "maxwell":  # (2.12): phi linear, so the mean over the section needs no coupling
            np.multiply(self.s0_in, 1.0 / self.tau, out=d_axial)
            np.multiply(S[1, N:], 1.0 / self.tau, out=d_bending)
        else:  # (2.24), (2.26), (2.27), at cells and nodes in one sweep
            S[0, :N] = self.s0_in
            np.multiply(np.add(self.s0[1:], self.s0[:-1], out=S[0, N:]), 0.5, out=S[0, N:])
            np.multiply(np.add(S[1, N + 1 :], S[1, N:-1], out=S[1, :N]), 0.5, out=S[1, :N])
            overstress_means(S, self.eps_Y, 1.0 / self.tau, self.work, self.means)
            d_axial[:] = self.means[0, :N]
            np.divide(self.means[1, N:], self.k2, out=d_bending)
        if self.closure == "printed":  # P_t = A <phi>, C_t = A (h/2) <phi zeta>
            np.divide(d_axial, self.s_in, out=d_axial)
            np.multiply(np.divide(d_bending, self.r, out=d_bending), 0.5 * self.delta * self.k2, out=d_bending)

    def energy(self, Y: Array, t: float) -> tuple[float, float, float]:
        """Kinetic, elastic (material closure) and potential energy of the half span, per ``E A0 L``."""
        self.stage[:] = Y
        self.stresses()
        z, v, *_ = self._in
        w = np.full(self.N + 1, self.dX)
        w[[0, -1]] *= 0.5
        elastic = 0.5 * self.dX * np.sum(self.s0_in**2) + 0.5 * self.k2 * np.sum(w * self.S[1, self.N :] ** 2)
        return float(0.5 * np.sum(w * np.abs(v) ** 2)), float(elastic), float(self.gravity(t) * np.sum(w * z.imag))

    def stable_step(self) -> float:
        """RK4's limit times `SAFETY`.

        Fastest waves of the straight grid: axial ``2/dX``, flexural ``4 (delta/2) sqrt(k2)/dX^2`` (it rules from N = 29
        at delta = 0.03). With relaxation a mode obeys ``lambda^2 + lambda/tau~ + w^2 = 0``: RK4 reaches 2.83 on the
        imaginary axis (elastic) and 2.79 on the real one (``1/tau~``); between them, scan ``|R(lambda dt)| <= 1``.
        """
        fastest = max(2.0 / self.dX, 2.0 * self.delta * self.k2**0.5 / self.dX**2)
        w = fastest * np.linspace(0.0, 1.0, 201)[1:]
        b = 0.0 if self.law == "elastic" else 0.5 / self.tau
        root = np.sqrt(b * b - w * w + 0j)
        lam = np.concatenate([-b + root, -b - root])
        dts = np.linspace(1e-3, 1.0, 1000) * 2.8284 / np.abs(lam).max()
        q = dts[:, None] * lam
        ok = (np.abs(1 + q * (1 + q / 2 * (1 + q / 3 * (1 + q / 4)))) <= 1 + 1e-9).all(axis=1)
        return SAFETY * float(dts[ok.argmin() - 1] if not ok.all() else dts[-1])

    def advance(self, Y: Array, t: float, t_end: float, dt_max: float) -> int:
        """Integrate ``Y`` in place from ``t`` to ``t_end`` by classical RK4; return the number of (equal) steps."""
        steps = max(1, int(np.ceil((t_end - t) / dt_max - 1e-9)))
        dt, stage, K, rhs = (t_end - t) / steps, self.stage, self.K, self.rhs
        weights, total, t0 = dt / 6 * np.array([1.0, 2.0, 2.0, 1.0]), np.empty(self.size), t
        velocity = self.views(Y)[1]
        for i in range(steps):
            t = t0 + i * dt
            np.copyto(stage, Y)
            rhs(t, 0)
            np.add(np.multiply(K[0], 0.5 * dt, out=stage), Y, out=stage)
            rhs(t + 0.5 * dt, 1)
            np.add(np.multiply(K[1], 0.5 * dt, out=stage), Y, out=stage)
            rhs(t + 0.5 * dt, 2)
            np.add(np.multiply(K[2], dt, out=stage), Y, out=stage)
            rhs(t + dt, 3)
            np.add(Y, np.matmul(weights, K, out=total), out=Y)
            if self.damping is not None:
                velocity[:-1] -= dt * (self.damping @ velocity)[:-1]
        return steps


def run(delta: float, G: float, V: float, eps_Y: float | None, law: Law, closure: Closure, N: int,
        t_end_elastic: float, g_on: float = 10.0, outputs: Sequence[float] = (46, 115, 230, 460),
        ends: Ends = "clamped", section: Section = "rectangle", short_wave_damping: float = 0.0) -> Result:  # fmt: skip
    """Drop a straight filament under ramped gravity."""
    eps_Y = 1.0 / (G * E_STAR) if eps_Y is None else eps_Y
    g = G * eps_Y
    f = Filament(delta, g, V * g**0.5, eps_Y, law, closure, N, g_on, ends, section, short_wave_damping)
    dt = f.stable_step()
    times = np.array(sorted({float(o) for o in outputs if o < t_end_elastic} | {float(t_end_elastic)}))
    Y, t, steps, wall, shapes = f.initial(), 0.0, 0, 0.0, []
    for t_next in times:
        start = perf_counter()
        steps += f.advance(Y, t, t_next, dt)
        wall += perf_counter() - start
        t = float(t_next)
        if not np.isfinite(Y).all():
            raise FloatingPointError(f"the solution is lost before t~ = {t:g}: unstable step or a broken filament")
        shapes.append(f.views(Y)[0].copy())
    z = np.array(shapes)
    stretch = np.abs(np.diff(z[-1])) / f.dX
    return Result(times, z[:, 0].imag, z.real, z.imag, stretch, 1e6 * wall / (4 * steps), steps, wall)
