"""All features of one film at once: modulus and viscosity by weighted least squares, solved by IPOPT.

The features are unknowns too, measured with errors; the theory ties them to E and eta as equality constraints.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.equations import asymptotics, rheometry
from softcat_sym.equations.regimes import E_star, tau_star
from softcat_sym.equations.regimes import H as SAG
from softcat_sym.equations.symbols import L as SPAN
from softcat_sym.equations.symbols import eta, g, rho
from softcat_sym.errors import SoftcatError
from softcat_sym.inverse.closed_form.inversion import ClosedForm, Constants, closed_form
from softcat_sym.inverse.features import Features
from softcat_sym.inverse.features.reading import Floats
from softcat_sym.printing import CellFunction, evaluate

_NAMES = ("frequency", "decay", "sag", "B", "t_high")
_SETTINGS: dict[str, Any] = {"ipopt": {"print_level": 0, "sb": "yes", "tol": 1e-10}, "print_time": False}
_WIDEST = math.log(1e8)


@dataclass(frozen=True, eq=False)
class CombinedEstimate:
    """The features' common answer.

    Attributes
    ----------
    constants : Constants
        E, eta and their covariance, from the errors of reading and the tolerance for the theory.
    misfit : float
        Sum of squares: chi-squared of `freedom` degrees if the theory held within its tolerance.
    freedom : int
        Features used less two.
    residuals : dict of str to float
        (theory - measured)/measured of every feature used, as logarithms.
    """

    constants: Constants
    misfit: float
    freedom: int
    residuals: dict[str, float]


def combined_estimate(features: Features, density: float, theory_error: float = 0.05) -> CombinedEstimate:
    """Weigh frequency, decay, sag, B and t_high by their errors, under the theory of one held shape.

    Ties: R^2 + d^2 by the sag, d = 1/(2 tau), B = 1/(2 V), t_high by B. Those that the film does not show are left out.

    Parameters
    ----------
    features : Features
        As from :func:`softcat_sym.inverse.features.read_features`.
    density : float
        [kg/m^3].
    theory_error : float
        Relative error allowed to the theory of every feature, beside the error of reading it.

    Returns
    -------
    CombinedEstimate

    Raises
    ------
    SoftcatError
        If no oscillation is seen, if that gives no modulus, or if IPOPT finds no solution.
    """
    start = closed_form(features, density)
    first = start.from_sag
    if first is None:
        raise SoftcatError(f"features do not give a modulus: {_reason(start)}")
    measured, covariance = _measured(features, theory_error)
    used = [k for k in range(len(_NAMES)) if np.isfinite(measured[k])]
    root = np.linalg.inv(np.linalg.cholesky(covariance[np.ix_(used, used)]))
    unknown = ca.MX.sym("z", 2 + len(_NAMES))
    residual = ca.mtimes(ca.DM(root), unknown[[2 + k for k in used]] - ca.DM(measured[used]))
    ties = _ties(unknown)
    found, cost = _solved(unknown, residual, ties, _guess(first, features, density, measured))
    jacobians = ca.Function("jacobians", [unknown], [ca.jacobian(residual, unknown), ca.jacobian(ties, unknown)])
    of_residual, of_ties = (np.asarray(ca.DM(matrix), dtype=float) for matrix in jacobians(found))
    # What the ties leave free: the last rows of V in their singular value decomposition.
    free = np.linalg.svd(of_ties)[2][of_ties.shape[0] :].T
    spread = free @ np.linalg.inv(free.T @ of_residual.T @ of_residual @ free) @ free.T
    modulus, viscosity = _constants(found, features, density)
    return CombinedEstimate(
        constants=Constants("all features", modulus, viscosity, spread[:2, :2]),
        misfit=2 * cost,
        freedom=len(used) - 2,
        residuals={_NAMES[k]: float(found[2 + k] - measured[k]) for k in used},
    )


def _solved(unknown: ca.MX, residual: ca.MX, ties: ca.MX, guess: Floats) -> tuple[Floats, float]:
    """Where the sum of squares is least under the ties, and half of it."""
    problem: dict[str, Any] = {"x": unknown, "f": 0.5 * ca.sumsqr(residual), "g": ties}
    solver = ca.nlpsol("features", "ipopt", problem, _SETTINGS)
    answer = solver(x0=guess, lbg=0, ubg=0, lbx=guess - _WIDEST, ubx=guess + _WIDEST)
    if not solver.stats()["success"]:
        raise SoftcatError(f"IPOPT finds no common answer of the features: {solver.stats()['return_status']}")
    return np.asarray(answer["x"], dtype=float).ravel(), float(answer["f"])


def _reason(start: ClosedForm) -> str:
    return "; ".join(dict.fromkeys(start.refused.values()))


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


def _ties(unknown: ca.MX) -> ca.MX:
    """Logarithms of both sides of every equation, in log(E*, V) and the logarithms of the features."""
    values = {
        E_star: ca.exp(unknown[0]),
        tau_star: ca.exp(unknown[1] - unknown[0]),
        rheometry.R: ca.exp(unknown[2]),
        rheometry.d_R: ca.exp(unknown[3]),
        SAG: ca.exp(unknown[4]),
        SPAN: ca.MX(1.0),
        rheometry.B: ca.exp(unknown[5]),
        rheometry.alpha: ca.MX(float(asymptotics.TOLERANCE)),
    }
    sides = {
        "modulus": rheometry.MODULUS_FROM_SAG.right,
        "decay": rheometry.DECAY.right,
        "viscous": rheometry.VISCOUS_NUMBER.right,
        "onset": asymptotics.T_HIGH,
    }
    right = CellFunction(sides, tuple(values))(values)
    ties: ca.MX = ca.vertcat(
        # Not as a logarithm: on the way the right side may become negative.
        right["modulus"] / values[E_star] - 1,
        ca.log(right["decay"]) - unknown[3],
        ca.log(right["viscous"]) - unknown[1],
        ca.log(right["onset"]) - unknown[6],
    )
    return ties


def _guess(first: Constants, features: Features, density: float, measured: Floats) -> Floats:
    """Logarithms of E* and V by the sag-based formula, then of the features, measured or expected."""
    span, gravity = features.span, features.gravity
    load = evaluate(
        rheometry.B_FROM_VISCOSITY.right,
        {rho: density, g: gravity, SPAN: span, eta: first.viscosity},
    )
    modulus = math.log(first.youngs_modulus / (density * gravity * span))
    log_load = math.log(float(load[0]))
    relaxation = first.relaxation_time / math.sqrt(span / gravity)
    decay = float(evaluate(rheometry.DECAY.right, {tau_star: relaxation})[0])
    known = {rheometry.B: math.exp(log_load), rheometry.alpha: float(asymptotics.TOLERANCE)}
    onset = float(evaluate(asymptotics.T_HIGH, known)[0])
    expected = np.array([measured[0], math.log(decay), measured[2], log_load, math.log(onset)])
    number = float(evaluate(rheometry.VISCOUS_NUMBER.right, known)[0])
    return np.concatenate([[modulus, math.log(number)], np.where(np.isfinite(measured), measured, expected)])


def _constants(found: Floats, features: Features, density: float) -> tuple[float, float]:
    """E [Pa] and eta [Pa s] of log E* and log V."""
    span, gravity = features.span, features.gravity
    modulus = math.exp(found[0]) * density * gravity * span
    known = {rheometry.B: math.exp(found[5]), rho: density, g: gravity, SPAN: span}
    return modulus, float(evaluate(rheometry.VISCOSITY_FROM_B.right, known)[0])
