"""A shear-free half filament of fourth order: Galerkin with cubic B-splines, in plain CasADi.

The scheme of the package is staggered and of second order. This one has control points in place of nodes, with
continuous curvature, and the whole section at two Gauss points of each cell, where both strains are superconvergent.
Forces are the derivative of the discrete energy and the mass is that of the same splines, so that energy is kept.
Clamp and plane of symmetry are conditions on the first control points; nothing is one-sided.

Source: Hughes, Cottrell & Bazilevs, Comput. Methods Appl. Mech. Engrg. 194 (2005) 4135; de Boor, A Practical Guide to
Splines (1978).
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any, Literal

import casadi as ca
import numpy as np
import numpy.typing as npt
from scipy.interpolate import BSpline

Floats = npt.NDArray[np.float64]
Law = Literal["bingham", "maxwell"]

_DEGREE = 3
_POINTS, _MASS_POINTS = 2, 4
_NOTHING = 1e-30
_MAX_STEPS = 1_000_000


@dataclass(frozen=True)
class Constants:
    """A half filament without units: lengths in rest lengths, stresses in Young's modulus, time in any scale T."""

    law: Law
    half_thickness: float
    yield_strain: float
    flow: float
    gravity: float
    ramp: float
    wave_speed_squared: float


@dataclass(frozen=True)
class Answer:
    """Of one run."""

    midpoint: Floats
    residual: Floats
    energy: float
    seconds: float
    steps: int


class SplineFilament:
    """The filament on cells between `nodes`, from the plane of symmetry to the clamp."""

    def __init__(self, nodes: Floats, constants: Constants) -> None:
        self._constants = constants
        knots = np.concatenate([[nodes[0]] * _DEGREE, nodes, [nodes[-1]] * _DEGREE])
        places = np.array([knots[i + 1 : i + 1 + _DEGREE].mean() for i in range(len(knots) - _DEGREE - 1)])
        count = len(places)
        # x = 0 and y' = 0 at midspan; x = 1/2, y = 0 and y' = 0 at the clamp.
        self._free = np.eye(count)[:, 1:-1], np.eye(count)[:, 1:-2]
        self._free[1][0, 0] = 1.0
        self._held = places[-1]
        points, self._weight = _gauss(nodes, _POINTS)
        self._slope, self._bend = (_splines(knots, points, order) for order in (1, 2))
        points, weight = _gauss(nodes, _MASS_POINTS)
        shapes = _splines(knots, points, 0)
        mass = shapes.T @ (weight[:, None] * shapes)
        self._mass = tuple(_sparse(free.T @ mass @ free) for free in self._free)
        self._load = self._free[1].T @ (shapes.T @ weight)
        self._start = places[1:-1]
        self.size = 0
        self._dae, self._audit = self._system()

    def _system(self) -> tuple[dict[str, ca.SX], ca.Function]:
        """dc/dt = v, dp/dt = force, 0 = M v - p, and the plastic strains at the Gauss points; the energies."""
        nx, ny = (free.shape[1] for free in self._free)
        points = len(self._weight)
        t, cx, cy = ca.SX.sym("t"), ca.SX.sym("cx", nx), ca.SX.sym("cy", ny)
        px, py = ca.SX.sym("px", nx), ca.SX.sym("py", ny)
        vx, vy = ca.SX.sym("vx", nx), ca.SX.sym("vy", ny)
        a_0, a_1 = ca.SX.sym("a_0", points), ca.SX.sym("a_1", points)
        at = (_sparse(self._slope @ self._free[0]), _sparse(self._bend @ self._free[0]))
        up = (_sparse(self._slope @ self._free[1]), _sparse(self._bend @ self._free[1]))
        held = self._slope[:, -1] * self._held, self._bend[:, -1] * self._held
        strains = (at[0] @ cx + held[0], at[1] @ cx + held[1], up[0] @ cy, up[1] @ cy, a_0, a_1)
        cell = point_function(self._constants)
        outputs = zip(*(cell(*(strain[i] for strain in strains)) for i in range(points)), strict=True)
        *stress, rate_0, rate_1, energy, dissipation = (ca.vertcat(*values) for values in outputs)
        c2, weight = self._constants.wave_speed_squared, ca.DM(self._weight)
        pulled = [weight * one for one in stress]
        gravity, growing = self._gravity(t)
        lifted = ca.dot(self._load, cy)
        force_x = -c2 * (at[0].T @ pulled[0] + at[1].T @ pulled[1])
        force_y = -c2 * (up[0].T @ pulled[2] + up[1].T @ pulled[3]) - gravity * self._load
        x, z = ca.vertcat(cx, cy, px, py, a_0, a_1), ca.vertcat(vx, vy)
        self.size = x.numel() + z.numel()
        dae = {"t": t, "x": x, "z": z, "ode": ca.vertcat(vx, vy, force_x, force_y, rate_0, rate_1)}
        dae["alg"] = ca.vertcat(self._mass[0] @ vx - px, self._mass[1] @ vy - py)
        dae["quad"] = ca.vertcat(c2 * ca.dot(weight, dissipation), growing * lifted)
        stored = [(ca.dot(px, vx) + ca.dot(py, vy)) / 2, c2 * ca.dot(weight, energy), gravity * lifted]
        return dae, ca.Function("energies", [t, x, z], [ca.vertcat(*stored)])

    def _gravity(self, t: ca.SX) -> tuple[ca.SX, ca.SX]:
        """g(t) and its rate."""
        full, ramp = self._constants.gravity, self._constants.ramp
        if ramp == 0:
            return ca.SX(full), ca.SX(0)
        r = ca.fmin(ca.fmax(t / ramp, 0), 1)
        return full * r**3 * (10 + r * (6 * r - 15)), full / ramp * 30 * (r * (1 - r)) ** 2

    def solve(self, times: Floats, rtol: float, atol: float) -> Answer:
        """Integrate by CasADi's Rosenbrock method, which the package's scheme is given too."""
        options = {"reltol": rtol, "abstol": atol, "max_num_steps": _MAX_STEPS}
        integrator = ca.integrator("spline", "rosenbrock", self._dae, float(times[0]), times.tolist(), options)
        velocities, momenta = (sum(free.shape[1] for free in self._free) for _ in range(2))
        rest = momenta + self._free[1].shape[1] + 2 * len(self._weight)
        start: dict[str, Any] = {"x0": np.concatenate([self._start, np.zeros(rest)]), "z0": np.zeros(velocities)}
        began = time.process_time()
        found = integrator(**start)
        seconds = time.process_time() - began
        x, z, work = (np.asarray(found[name]) for name in ("xf", "zf", "qf"))
        stored = np.asarray(self._audit.map(len(times))(times.reshape(1, -1), x, z))
        residual = stored.sum(axis=0) + work[0] - work[1]
        largest = max(float(np.max(np.abs(stored))), float(np.max(np.abs(work))))
        height = x[self._free[0].shape[1]]
        return Answer(height, residual - residual[0], largest, seconds, int(integrator.stats()["n_steps"]))


def point_function(constants: Constants) -> ca.Function:
    """One Gauss point: (x', x'', y', y'', a_0, a_1) to stresses, plastic rates, energy and dissipation.

    The section is a rectangle with the strain S_0 + S_1 zeta, log s less a_0 and -h0/2 theta_X s^-3/2 less a_1
    (Kamrin & Mahadevan 2012, 2.17 and 2.25 to 2.27).
    """
    given = [ca.SX.sym(name) for name in ("x1", "x2", "y1", "y2", "a_0", "a_1")]
    x1, x2, y1, y2, a_0, a_1 = given
    stretch = ca.sqrt(x1**2 + y1**2)
    turning = (x1 * y2 - y1 * x2) / stretch**2
    mean, bending = ca.log(stretch) - a_0, -constants.half_thickness * turning / stretch**1.5 - a_1
    energy = mean**2 / 2 + bending**2 / 6
    rates = _bingham(constants, mean, bending) if constants.law == "bingham" else (mean, bending)
    rate_0, rate_1 = (constants.flow * rate for rate in rates)
    forces = [ca.gradient(energy, strain) for strain in given[:4]]
    return ca.Function("point", given, [*forces, rate_0, rate_1, energy, mean * rate_0 + bending * rate_1 / 3])


def _bingham(constants: Constants, mean: ca.SX, bending: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Mean and slope of what exceeds the yield strain over the thickness, fibre by fibre, in closed form."""
    a, b, limit = ca.fabs(mean), ca.fabs(bending), constants.yield_strain
    pulled, pushed = ca.fmax(b + a - limit, 0), ca.fmax(b - a - limit, 0)
    near, far = pulled / (ca.fmax(b, pulled / 2) + _NOTHING), pushed / (b + _NOTHING)
    over_0 = near * (pulled - b * near / 2) / 2 - pushed * far / 4
    slope = near * (pulled - b * near / 2 - near * (pulled / 2 - b * near / 3))
    over_1 = 1.5 * slope + pushed * far * (0.75 - 0.25 * far)
    return ca.sign(mean) * over_0, ca.sign(bending) * over_1


def _gauss(nodes: Floats, points: int) -> tuple[Floats, Floats]:
    """Places and weights of Gauss points in every cell, shape (cells * points,)."""
    at, weight = np.polynomial.legendre.leggauss(points)
    length = np.diff(nodes)[:, None]
    return (nodes[:-1, None] + length * (at + 1) / 2).ravel(), (length * weight / 2).ravel()


def _splines(knots: Floats, places: Floats, order: int) -> Floats:
    """Derivatives of all basis functions, shape (places, control points)."""
    every = BSpline(knots, np.eye(len(knots) - _DEGREE - 1), _DEGREE)
    return np.asarray((every.derivative(order) if order else every)(places))


def _sparse(matrix: Floats) -> ca.DM:
    return ca.sparsify(ca.DM(matrix))
