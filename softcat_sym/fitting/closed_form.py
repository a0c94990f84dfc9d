"""Modulus and viscosity of a Maxwell filament from features of its film, without running a model."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Literal

import casadi as ca
import numpy as np

from softcat_sym.discretization.casadi_printer import CellFunction, evaluate
from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.fitting.features import SLACKEST, Features, Floats, mode_number, modulus_of
from softcat_sym.physics import closed_forms, rheometry
from softcat_sym.physics.regimes import E_star, tau_star
from softcat_sym.physics.regimes import H as SAG
from softcat_sym.physics.symbols import L as SPAN
from softcat_sym.physics.symbols import eta, g, rho

Root = Literal["ringing", "fading"]

PAPER, SAG_BASED, CABLE = "(2.22)", "frequency, decay and sag", "cable"


@dataclass(frozen=True, eq=False)
class Constants:
    """Modulus and viscosity by one formula."""

    formula: str  # Name of the formula
    youngs_modulus: float  # E [Pa] and the extensional eta [Pa s]
    viscosity: float

    @property
    def relaxation_time(self) -> float:
        """eta/E [s]."""
        return self.viscosity / self.youngs_modulus


@dataclass(frozen=True, eq=False)
class ClosedForm:
    """Constants by every formula from one film."""

    ringing: Constants | None  # Both roots of (2.22), squared: the longer and the shorter relaxation time
    fading: Constants | None
    # The root whose decay rate 1/(2 tau) is nearer to the measured one; None where that is unknown: both are possible.
    picked: Root | None
    from_sag: Constants | None  # E by R^2 + d^2 and the sag about which it rings, the shape held
    # E by the lowest mode of a cable, whose shape changes with its stiffness (Irvine and Caughey 1974).
    from_cable: Constants | None
    refused: dict[str, str] = field(default_factory=dict)  # Why a formula has no result

    @property
    def paper(self) -> Constants | None:
        """The root of (2.22) that agrees with the decay rate."""
        return {"ringing": self.ringing, "fading": self.fading, None: None}[self.picked]

    @property
    def first_guess(self) -> Constants | None:
        """Initial guess of a fit: by the cable, else by the sag, else by the paper; each is biased."""
        return self.from_cable or self.from_sag or self.paper


def closed_form(features: Features, density: float) -> ClosedForm:
    """Invert the features of one film."""
    if not (math.isfinite(density) and density > 0):
        raise SoftcatError(f"closed form:\n  {Fault('density', f'{density:g}', 'a positive number')}")
    refused: dict[str, str] = {}
    load = features.prefactor.value
    roots = _roots(features, density, load, refused)
    return ClosedForm(
        ringing=roots.get("ringing"),
        fading=roots.get("fading"),
        picked=_picked(features, roots),
        from_sag=_from_ringing(features, density, load, SAG_BASED, _modulus_from_sag, refused),
        from_cable=_from_ringing(features, density, load, CABLE, _modulus_of_cable, refused),
        refused=refused,
    )


def _roots(features: Features, density: float, load: float | None, refused: dict[str, str]) -> dict[Root, Constants]:
    """Both roots; t_high is the time on the clock at which R is read."""
    if features.ringing is None or load is None:
        refused[PAPER] = features.frequency.reason or features.prefactor.reason
        return {}
    unit = math.sqrt(features.span / features.gravity)
    known = {
        rheometry.R: features.ringing.frequency * unit,
        rheometry.t_high: features.ringing.middle / unit,
        rheometry.B: load,
    }
    most = float(evaluate(rheometry.LARGEST_FREQUENCY.right, known)[0])
    if known[rheometry.R] > most:
        refused[PAPER] = (
            "no relaxation time gives so high a frequency at that time: R exceeds 6 (3 t^2/B)^(1/3) by "
            f"{100 * (known[rheometry.R] / most - 1):.2g} %"
        )
        return {}
    viscosity, both = _viscosity(features, density, load), rheometry.relaxation_times()
    relaxations = (float(evaluate(root, known)[0]) for root in (both.ringing, both.fading))
    ringing, fading = (Constants(PAPER, _modulus(features, viscosity, one), viscosity) for one in relaxations)
    return {"ringing": ringing, "fading": fading}


def _viscosity(features: Features, density: float, load: float) -> float:
    known = {rheometry.B: load, rho: density, g: features.gravity, SPAN: features.span}
    return float(evaluate(rheometry.VISCOSITY_FROM_B.right, known)[0])


def _modulus(features: Features, viscosity: float, relaxation: float) -> float:
    known = {eta: viscosity, tau_star: relaxation, SPAN: features.span, g: features.gravity}
    return float(evaluate(rheometry.MODULUS.right, known)[0])


def _picked(features: Features, roots: dict[Root, Constants]) -> Root | None:
    if not roots or features.decay.value is None:
        return None
    measured = math.log(features.decay.value)
    away = {name: abs(math.log(_decay(one.relaxation_time, features)) - measured) for name, one in roots.items()}
    return min(away, key=lambda name: away[name])


def _decay(relaxation_time: float, features: Features) -> float:
    """1/(2 tau) [1/s] of tau [s]."""
    unit = math.sqrt(features.span / features.gravity)
    return float(evaluate(rheometry.DECAY.right, {tau_star: relaxation_time / unit})[0]) / unit


def _modulus_from_sag(frequency: float, decay: float, sag: float, features: Features) -> float | str:
    unit = math.sqrt(features.span / features.gravity)
    known = {rheometry.R: frequency * unit, rheometry.d_R: decay * unit, SAG: sag, SPAN: features.span}
    value = float(evaluate(rheometry.MODULUS_FROM_SAG.right, known)[0])
    return value if value > 0 else "the frequency is lower than that of a filament under its weight alone"


def _modulus_of_cable(frequency: float, decay: float, sag: float, features: Features) -> float | str:
    found = modulus_of(frequency, decay, sag, features.gravity, features.span)
    if found is not None:
        return found.modulus
    mode = mode_number(frequency, sag, features.gravity)
    return f"R (8 H/g)^(1/2) = {mode:.3g} is outside of a cable's lowest mode, 3.14 (taut) to {SLACKEST:.3g} (slack)"


def _from_ringing(
    features: Features,
    density: float,
    load: float | None,
    name: str,
    formula: Callable[[float, float, float, Features], float | str],
    refused: dict[str, str],
) -> Constants | None:
    """E/(rho g L) by a formula in (R, d, H), eta by B, or by the decay rate where there is no B."""
    ringing = features.ringing
    if ringing is None:
        refused[name] = features.frequency.reason
        return None
    value = formula(ringing.frequency, max(ringing.decay, 0.0), ringing.sag, features)
    if isinstance(value, str):
        refused[name] = value
        return None
    weight = {E_star: value, rho: density, g: features.gravity, SPAN: features.span}
    modulus = float(evaluate(E_star * rho * g * SPAN, weight)[0])
    if load is not None:
        return Constants(name, modulus, _viscosity(features, density, load))
    if features.decay.value is None:
        refused[name] = f"neither B nor a decay rate gives the viscosity: {features.prefactor.reason}"
        return None
    return Constants(f"{name}, decay for B", modulus, modulus / (2 * ringing.decay))


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
    start = closed_form(features, density)
    first = start.from_sag
    if first is None:
        raise SoftcatError(f"features do not give a modulus: {_reason(start)}")
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
    modulus, viscosity = _constants(found, features, density)
    return CombinedEstimate(
        constants=Constants("all features", modulus, viscosity),
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
    known = {rheometry.B: math.exp(log_load), rheometry.alpha: float(closed_forms.TOLERANCE)}
    onset = float(evaluate(closed_forms.T_HIGH, known)[0])
    expected = np.array([measured[0], math.log(decay), measured[2], log_load, math.log(onset)])
    number = float(evaluate(rheometry.VISCOUS_NUMBER.right, known)[0])
    return np.concatenate([[modulus, math.log(number)], np.where(np.isfinite(measured), measured, expected)])


def _constants(found: Floats, features: Features, density: float) -> tuple[float, float]:
    """E [Pa] and eta [Pa s] of log E* and log V."""
    span, gravity = features.span, features.gravity
    modulus = math.exp(found[0]) * density * gravity * span
    known = {rheometry.B: math.exp(found[5]), rho: density, g: gravity, SPAN: span}
    return modulus, float(evaluate(rheometry.VISCOSITY_FROM_B.right, known)[0])
