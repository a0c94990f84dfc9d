"""Modulus and viscosity of a Maxwell filament from features of its film, without running a model."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.casadi_printer import CellFunction, evaluate
from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.fitting.features import Features, Floats, modulus_of
from softcat_sym.physics import closed_forms, rheometry
from softcat_sym.physics.regimes import E_star, tau_star
from softcat_sym.physics.regimes import H as SAG
from softcat_sym.physics.symbols import L as SPAN
from softcat_sym.physics.symbols import eta, g, rho


@dataclass(frozen=True, eq=False)
class Constants:
    """Modulus and viscosity."""

    youngs_modulus: float  # E [Pa] and the extensional eta [Pa s]
    viscosity: float

    @property
    def relaxation_time(self) -> float:
        """eta/E [s]."""
        return self.viscosity / self.youngs_modulus


def first_guess(features: Features, density: float) -> Constants:
    """Constants by frequency, decay rate and sag, as a fit starts from them.

    The modulus is that of a cable, whose shape changes with its stiffness (Irvine and Caughey 1974); outside of a
    cable's lowest mode, by R^2 + d^2 and the sag with the shape held. The viscosity follows from B, or from the decay
    rate where there is no B.
    """
    if not (math.isfinite(density) and density > 0):
        raise SoftcatError(f"closed form:\n  {Fault('density', f'{density:g}', 'a positive number')}")
    ringing, load = features.ringing, features.prefactor.value
    if ringing is None:
        raise SoftcatError(f"features do not give a modulus: {features.frequency.reason}")
    if load is None and features.decay.value is None:
        found = "neither B nor a decay rate gives the viscosity"
        raise SoftcatError(f"features do not give a viscosity: {found}: {features.prefactor.reason}")
    decay, span, gravity = max(ringing.decay, 0.0), features.span, features.gravity
    cable = modulus_of(ringing.frequency, decay, ringing.sag, gravity, span)
    if cable is None:
        unit = math.sqrt(span / gravity)
        known = {rheometry.R: ringing.frequency * unit, rheometry.d_R: decay * unit, SAG: ringing.sag, SPAN: span}
        number = float(evaluate(rheometry.MODULUS_FROM_SAG.right, known)[0])
    else:
        number = cable.modulus
    if number <= 0:
        found = "the frequency is lower than that of a filament under its weight alone"
        raise SoftcatError(f"features do not give a modulus: {found}")
    modulus = number * density * gravity * span
    if load is None:
        return Constants(modulus, modulus / (2 * ringing.decay))
    return Constants(modulus, _viscosity(features, density, load))


def _viscosity(features: Features, density: float, load: float) -> float:
    known = {rheometry.B: load, rho: density, g: features.gravity, SPAN: features.span}
    return float(evaluate(rheometry.VISCOSITY_FROM_B.right, known)[0])


_NAMES = ("frequency", "decay", "sag", "B", "t_high")
_SETTINGS: dict[str, Any] = {"ipopt": {"print_level": 0, "sb": "yes", "tol": 1e-10}, "print_time": False}
_WIDEST = math.log(1e8)


@dataclass(frozen=True, eq=False)
class CombinedEstimate:
    """Constants from all features together."""

    constants: Constants  # E and eta
    # shape (2, 2); Of log E and log eta, from the errors of reading and the tolerance for the theory
    covariance: Floats
    misfit: float  # Sum of squares: chi-squared of `freedom` degrees if the theory held within its tolerance
    freedom: int  # Features used less two
    residuals: dict[str, float]  # (theory - measured)/measured of every feature used, as logarithms


def combined_estimate(features: Features, density: float, theory_error: float = 0.05) -> CombinedEstimate:
    """Weigh frequency, decay, sag, B and t_high by their errors, under the theory of one fixed shape.

    The constraints are: R^2 + d^2 by the sag, d = 1/(2 tau), B = 1/(2 V), t_high by B. Features that the film does not
    show are left out.
    """
    first = first_guess(features, density)
    measured, covariance = _measured(features, theory_error)
    used = [k for k in range(len(_NAMES)) if np.isfinite(measured[k])]
    root = np.linalg.inv(np.linalg.cholesky(covariance[np.ix_(used, used)]))
    unknown = ca.MX.sym("z", 2 + len(_NAMES))
    residual = ca.mtimes(ca.DM(root), unknown[[2 + k for k in used]] - ca.DM(measured[used]))
    constraints = _constraints(unknown)
    found, cost = _solved(unknown, residual, constraints, _guess(first, features, density, measured))
    jacobians = ca.Function("jacobians", [unknown], [ca.jacobian(residual, unknown), ca.jacobian(constraints, unknown)])
    of_residual, of_constraints = (np.asarray(ca.DM(matrix), dtype=float) for matrix in jacobians(found))
    # Directions along the constraints: the last rows of V in the singular value decomposition of their Jacobian.
    free = np.linalg.svd(of_constraints)[2][of_constraints.shape[0] :].T
    spread = free @ np.linalg.inv(free.T @ of_residual.T @ of_residual @ free) @ free.T
    modulus = math.exp(found[0]) * density * features.gravity * features.span
    return CombinedEstimate(
        constants=Constants(modulus, _viscosity(features, density, math.exp(found[5]))),
        covariance=spread[:2, :2],
        misfit=2 * cost,
        freedom=len(used) - 2,
        residuals={_NAMES[k]: float(found[2 + k] - measured[k]) for k in used},
    )


def _solved(unknown: ca.MX, residual: ca.MX, constraints: ca.MX, guess: Floats) -> tuple[Floats, float]:
    """Unknowns that minimise the sum of squares under the constraints, and half of that sum."""
    problem: dict[str, Any] = {"x": unknown, "f": 0.5 * ca.sumsqr(residual), "g": constraints}
    solver = ca.nlpsol("features", "ipopt", problem, _SETTINGS)
    answer = solver(x0=guess, lbg=0, ubg=0, lbx=guess - _WIDEST, ubx=guess + _WIDEST)
    if not solver.stats()["success"]:
        raise SoftcatError(f"IPOPT finds no constants for all features together: {solver.stats()['return_status']}")
    return np.asarray(answer["x"], dtype=float).ravel(), float(answer["f"])


def _measured(features: Features, theory_error: float) -> tuple[Floats, Floats]:
    """Logarithms of the dimensionless features, NaN where unread, and their covariance."""
    unit = math.sqrt(features.span / features.gravity)
    scales = (unit, unit, 1 / features.span, 1.0, 1 / unit)
    readings = (features.frequency, features.decay, features.sag, features.prefactor, features.t_high)
    measured = np.array(
        [math.nan if one.value is None else math.log(one.value * s) for one, s in zip(readings, scales, strict=True)]
    )
    covariance = np.diag([0.0, 0.0, 0.0, features.prefactor.log_variance, features.t_high.log_variance])
    covariance[:3, :3] = features.ringing_covariance
    return measured, covariance + theory_error**2 * np.eye(len(_NAMES))


def _constraints(unknown: ca.MX) -> ca.MX:
    """Logarithms of both sides of every equation, in log(E*, V) and the logarithms of the features."""
    values = {
        E_star: ca.exp(unknown[0]),
        tau_star: ca.exp(unknown[1] - unknown[0]),
        rheometry.R: ca.exp(unknown[2]),
        rheometry.d_R: ca.exp(unknown[3]),
        SAG: ca.exp(unknown[4]),
        SPAN: ca.MX(1.0),
        rheometry.B: ca.exp(unknown[5]),
        rheometry.alpha: ca.MX(float(closed_forms.TOLERANCE)),
    }
    sides = {
        "modulus": rheometry.MODULUS_FROM_SAG.right,
        "decay": rheometry.DECAY.right,
        "viscous": rheometry.VISCOUS_NUMBER.right,
        "onset": closed_forms.T_HIGH,
    }
    right = CellFunction(sides, tuple(values))(values)
    constraints: ca.MX = ca.vertcat(
        # Not as a logarithm, as the right side may become negative during the search.
        right["modulus"] / values[E_star] - 1,
        ca.log(right["decay"]) - unknown[3],
        ca.log(right["viscous"]) - unknown[1],
        ca.log(right["onset"]) - unknown[6],
    )
    return constraints


def _guess(first: Constants, features: Features, density: float, measured: Floats) -> Floats:
    """Logarithms of E* and V, then of the features, measured or expected."""
    span, gravity = features.span, features.gravity
    load = evaluate(
        rheometry.B_FROM_VISCOSITY.right,
        {rho: density, g: gravity, SPAN: span, eta: first.viscosity},
    )
    modulus = math.log(first.youngs_modulus / (density * gravity * span))
    log_load = math.log(float(load[0]))
    relaxation = first.relaxation_time / math.sqrt(span / gravity)
    decay = float(evaluate(rheometry.DECAY.right, {tau_star: relaxation})[0])
    known = {rheometry.B: math.exp(log_load), rheometry.alpha: float(closed_forms.TOLERANCE)}
    onset = float(evaluate(closed_forms.T_HIGH, known)[0])
    expected = np.array([measured[0], math.log(decay), measured[2], log_load, math.log(onset)])
    number = float(evaluate(rheometry.VISCOUS_NUMBER.right, known)[0])
    return np.concatenate([[modulus, math.log(number)], np.where(np.isfinite(measured), measured, expected)])
