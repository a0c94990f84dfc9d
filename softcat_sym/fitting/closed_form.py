"""Modulus and viscosity of a Maxwell filament from features of its film: one problem for IPOPT, without any run."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from scipy.optimize import brentq

from softcat_sym.discretization.casadi_printer import CellFunction, evaluate
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.features import Features, Floats, Oscillation
from softcat_sym.physics import closed_forms, rheometry
from softcat_sym.physics.regimes import E_star
from softcat_sym.physics.regimes import H as SAG
from softcat_sym.physics.symbols import L as SPAN

# Errors of the theory, as logarithms, on films of the full model: of R and d of small oscillations, of B, of t_high.
_OF_R, _OF_D, _OF_B, _OF_ONSET = 0.02, 0.07, 0.025, 0.2
# An oscillation of amplitude A about a sag H is slower by this share of (A/H)^2, where elasticity gives less than 0.7 of
# its stiffness, and by this share of (H/L)^2; the error of either, as a share of it; and the error of d over (A/H)^2.
_SOFTENING, _SOFT_BELOW, _SOFT_WIDTH, _DEEP, _UNSURE, _OF_LARGE_D = 2.0, 0.70, 0.06, 1.5, 0.4, 8.0
# Standard deviation of the logarithms of both constants before the film is seen, and the largest that is reported.
_UNKNOWN, _LARGEST = 7.0, 1.0
_SETTINGS: dict[str, Any] = {"ipopt": {"print_level": 0, "sb": "yes", "tol": 1e-7, "acceptable_tol": 1e-6}, "print_time": False}


@dataclass(frozen=True)
class Determined:
    """A constant, or the reason why the features do not determine it."""

    value: float | None  # In SI units
    log_error: float | None  # Standard error of its logarithm, from reading and theory
    reason: str = ""

    @property
    def interval(self) -> tuple[float, float] | None:
        """95 % interval."""
        if self.value is None or self.log_error is None:
            return None
        factor = math.exp(1.96 * self.log_error)
        return self.value / factor, self.value * factor


@dataclass(frozen=True, eq=False)
class ClosedForm:
    """Constants from all features of a film together."""

    youngs_modulus: Determined  # E
    viscosity: Determined  # The extensional eta
    covariance: Floats  # shape (2, 2); Of log E and log eta
    misfit: float  # Sum of squares over errors of reading and theory
    residuals: dict[str, float]  # (theory - measured)/measured of every feature used, as logarithms


class _Problem:
    """Unknown logarithms, equations among them, and what is known of them."""

    def __init__(self) -> None:
        self.unknowns: dict[str, ca.SX] = {}
        self.start, self.equations = list[float](), list[ca.SX]()
        self.known, self.covariance = dict[str, float](), np.zeros((0, 0))

    def add(self, **start: float) -> list[ca.SX]:
        """Unknowns whose logarithms start at these."""
        new = {name: ca.SX.sym(name) for name in start}
        self.unknowns |= new
        self.start += start.values()
        return [ca.exp(symbol) for symbol in new.values()]

    def know(self, covariance: Floats, **values: float) -> None:
        """Measured logarithms and their covariance."""
        self.known |= values
        size = len(self.covariance)
        grown = np.zeros((size + len(values),) * 2)
        grown[:size, :size], grown[size:, size:] = self.covariance, covariance
        self.covariance = grown

    def solve(self) -> tuple[dict[str, float], Floats, float]:
        """Minimise the squares under the equations: unknowns, covariance of all of them, and the sum of squares."""
        x, equations = ca.vertcat(*self.unknowns.values()), ca.vertcat(*self.equations)
        root = np.linalg.inv(np.linalg.cholesky(self.covariance))
        misfit = ca.vertcat(*(self.unknowns[name] - value for name, value in self.known.items()))
        residual = ca.mtimes(ca.DM(root), misfit)
        solver = ca.nlpsol("closed_form", "ipopt", {"x": x, "f": ca.sumsqr(residual) / 2, "g": equations}, _SETTINGS)
        answer = solver(x0=self.start, lbg=0, ubg=0)
        if not solver.stats()["success"]:
            raise SoftcatError(f"IPOPT finds no constants for all features: {solver.stats()['return_status']}")
        jacobians = ca.Function("jacobians", [x], [ca.jacobian(residual, x), ca.jacobian(equations, x)])
        of_residual, of_equations = (np.asarray(ca.DM(matrix), dtype=float) for matrix in jacobians(answer["x"]))
        # Directions along the equations: the last rows of V in the singular value decomposition of their Jacobian.
        free = np.linalg.svd(of_equations)[2][len(of_equations) :].T
        spread = free @ np.linalg.inv(free.T @ of_residual.T @ of_residual @ free) @ free.T
        found = dict(zip(self.unknowns, np.asarray(answer["x"], dtype=float).ravel().tolist(), strict=True))
        return found, spread, 2 * float(answer["f"])


def closed_form(features: Features, density: float, gyration: float) -> ClosedForm:
    """Constants of a Maxwell filament that fell from rest between level clamps, straight at first.

    IPOPT weighs R, d, H, B and t_high by their errors of reading and by those of the theory, with the constraints of
    :mod:`softcat_sym.physics.rheometry`: the frequency of a hanging beam under tension, Maxwell's relaxation of its
    elastic share, and the 1/3 law with bending.

    Parameters
    ----------
    features : Features
        As read from the film.
    density, gyration : float
        Density [kg/m^3], and the section's radius of gyration sqrt(I/A) [m].

    Raises
    ------
    SoftcatError
        If the film shows neither an oscillation nor the 1/3 law.
    """
    unit, slimness = math.sqrt(features.span / features.gravity), gyration / features.span
    pressure = density * features.gravity * features.span
    problem, ringing = _Problem(), features.ringing
    late = None if features.late is None else _late_load(features, slimness)
    if ringing is None and late is None:
        raise SoftcatError(f"features: {features.frequency.reason}; {features.prefactor.reason}")
    first = None if ringing is None else _first_modulus(ringing, features, slimness)
    if late is None:
        assert first is not None
        viscous = first / (2 * unit * max(ringing.decay, 0.02 * ringing.frequency))
    else:
        viscous = late / (2 * features.prefactor.value)
    [V] = problem.add(V=math.log(viscous))
    problem.know(np.array([[_UNKNOWN**2]]), V=math.log(viscous))
    if late is not None:
        _add_late_law(problem, V, features, late)
    if first is not None:
        _add_ringing(problem, V, first, ringing, features, slimness)
    found, spread, misfit = problem.solve()
    names = list(problem.unknowns)

    def determined(name: str, unit: float, reason: str) -> Determined:
        if name not in names:
            return Determined(None, None, reason)
        error = math.sqrt(spread[names.index(name), names.index(name)])
        if error > _LARGEST:
            return Determined(None, None, f"known to a factor of {math.exp(min(error, 99)):.2g} only")
        return Determined(unit * math.exp(found[name]), error)

    places = [names.index(name) if name in names else None for name in ("E", "V")]
    covariance = np.array([[np.nan if i is None or j is None else spread[i, j] for j in places] for i in places])
    return ClosedForm(
        determined("E", pressure, features.frequency.reason),
        determined("V", pressure * unit, features.prefactor.reason),
        covariance,
        misfit,
        {name: found[name] - value for name, value in problem.known.items() if name not in ("E", "V")},
    )


def _boundary_layer(sag: float, slimness: float) -> float:
    """r_T at a sag, both over the span."""

    def excess(log_r: float) -> float:
        known = {rheometry.r_T: math.exp(log_r), SAG: sag, SPAN: 1.0, rheometry.k_g: slimness}
        return math.log(float(evaluate(rheometry.LAYER.left, known)[0] / evaluate(rheometry.LAYER.right, known)[0]))

    return math.exp(brentq(excess, math.log(0.1), math.log(1e6)))


def _late_load(features: Features, slimness: float) -> float:
    """Ratio of B as it is read, from the slope of sag^3, to 1/(2 V)."""
    law = features.late
    sag = float(law.sag(np.array([0.5 * (law.first + law.last)]))[0]) / features.span
    known = {rheometry.r_T: _boundary_layer(sag, slimness), SAG: sag, SPAN: 1.0}
    return float(evaluate(rheometry.late_prefactor(), known)[0])


def _add_late_law(problem: _Problem, V: ca.SX, features: Features, late: float) -> None:
    seen, onset = features.prefactor, features.t_high
    [B] = problem.add(B=math.log(seen.value))
    problem.equations.append(ca.log(2 * V * B / late))
    problem.know(np.array([[seen.log_variance + _OF_B**2]]), B=math.log(seen.value))
    if onset.value is not None:
        clock = math.log(onset.value / math.sqrt(features.span / features.gravity))
        [t_high] = problem.add(t_high=clock)
        values = {rheometry.B: 1 / (2 * V), rheometry.alpha: float(closed_forms.TOLERANCE)}
        theory = CellFunction({"": closed_forms.T_HIGH}, tuple(values))(values)[""]
        problem.equations.append(ca.log(theory / t_high))
        problem.know(np.array([[onset.log_variance + _OF_ONSET**2]]), t_high=clock)


_VIBRATION = (E_star, rheometry.Omega, rheometry.r_T, SAG, SPAN, rheometry.k_g)


def _first_modulus(ringing: Oscillation, features: Features, slimness: float) -> float:
    """E/(rho g L) of the lowest frequency, on a grid: of all moduli with a mode at that frequency, the largest."""
    sag, unit = ringing.sag / features.span, math.sqrt(features.span / features.gravity)
    layer = _boundary_layer(sag, slimness)
    at_rest = float(evaluate(rheometry.SAG_SHARE, {rheometry.r_T: layer})[0]) / (sag * (layer * slimness) ** 2)
    grid = np.geomspace(at_rest, 1e6 * at_rest, 1200)
    values = (grid, math.hypot(ringing.frequency, ringing.decay) * unit, layer, sag, 1.0, slimness)
    rows = {symbol: np.broadcast_to(value, grid.shape) for symbol, value in zip(_VIBRATION, values, strict=True)}
    sign = np.sign(evaluate(rheometry.vibration(), rows))
    crossings = np.flatnonzero(sign[1:] != sign[:-1])
    return float(grid[crossings[-1]] if len(crossings) else grid[0])


def _add_ringing(
    problem: _Problem, V: ca.SX, first: float, ringing: Oscillation, features: Features, slimness: float
) -> None:
    unit = math.sqrt(features.span / features.gravity)
    sag, share = ringing.sag / features.span, ringing.amplitude(ringing.middle) / ringing.sag
    layer, frequency = _boundary_layer(sag, slimness), ringing.frequency * unit
    decay = max(ringing.decay * unit, 1e-3 * frequency)
    start = {"E": first, "Omega": math.hypot(frequency, decay), "r": layer, "R": frequency, "d": decay, "H": sag}
    E, Omega, r, R, d, H = problem.add(**{name: math.log(value) for name, value in start.items()})
    values = dict(zip(_VIBRATION, (E, Omega, r, H, 1.0, slimness), strict=True))
    cell = CellFunction(
        {"vibration": rheometry.vibration(), "left": rheometry.LAYER.left, "right": rheometry.LAYER.right},
        _VIBRATION,
    )(values)
    x = [problem.unknowns[name] for name in start]
    slope = ca.gradient(cell["vibration"], ca.vertcat(*x))
    size = float(np.linalg.norm(np.asarray(ca.Function("size", x, [slope])(*(problem.start[-6:])))))
    # Of the stiffness Omega^2 the share p relaxes: s^2 + (1 - p) Omega^2 + p Omega^2 s/(s + 1/tau) = 0.
    p = -2 * slope[0] / slope[1]
    at_start = ca.Function("share", x, [p])(*problem.start[-6:])
    elastic = float(np.clip(float(at_start), 0.02, 1.0))
    soft = _SOFTENING * share**2 / (1 + ca.exp((p - _SOFT_BELOW) / _SOFT_WIDTH)) + _DEEP * H**2
    small, rate = R / (1 - soft), E / V
    problem.equations += [
        ca.log(cell["left"] / cell["right"]),
        cell["vibration"] / size,
        (small**2 - 3 * d**2 + 2 * d * rate) / Omega**2 - 1,
        (3 * d * small**2 - d**3 + (d**2 - small**2) * rate) / Omega**2 - d + (1 - p) * rate,
    ]
    softening = float(ca.Function("soft", x, [soft])(*problem.start[-6:]))
    theory = np.diag([math.hypot(_OF_R, _UNSURE * softening), math.hypot(_OF_D, _OF_LARGE_D * share**2) / elastic**2, 0])
    names = ["R", "d", "H"] if features.decay.value is not None else ["R", "H"]
    used = [("R", "d", "H").index(name) for name in names]
    covariance = (features.ringing_covariance + theory**2)[np.ix_(used, used)]
    problem.know(covariance, **{name: math.log(start[name]) for name in names})
    problem.know(np.array([[_UNKNOWN**2]]), E=math.log(first))
