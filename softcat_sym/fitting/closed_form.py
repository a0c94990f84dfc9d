"""Modulus and viscosity of a Maxwell filament from features of its film: one problem for IPOPT, without any run."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from scipy.optimize import brentq

from softcat_sym.discretization.casadi_printer import CellFunction, evaluate
from softcat_sym.drawing import Drawable
from softcat_sym.errors import SoftcatError
from softcat_sym.estimates.scaling import beam_of, section_of
from softcat_sym.fitting.features import FEWEST, Features, Floats, Oscillation, read_features
from softcat_sym.fitting.measurements import Series
from softcat_sym.fitting.plausibility import Films, own_scene, taken
from softcat_sym.physics import closed_forms, rheometry
from softcat_sym.physics.beams import CLAMPED
from softcat_sym.physics.regimes import E_star
from softcat_sym.physics.regimes import H as SAG
from softcat_sym.physics.symbols import L as SPAN
from softcat_sym.scene.reading import Changes, SceneLike, as_scene
from softcat_sym.scene.scene import Scene, is_symmetric, rest_length
from softcat_sym.solvers.initial_state import is_straight

# Errors of the theory, as logarithms, on films of the full model (tests/studies/closed_form.py): of R and d of small
# oscillations, of B, of t_high.
_OF_R, _OF_D, _OF_B, _OF_ONSET = 0.02, 0.07, 0.025, 0.2
# An oscillation of amplitude A about a sag H is slower by this share of (A/H)^2 where elasticity gives less than 0.7 of
# its stiffness, and by this share of (H/L)^2; error of either, as a share of it; error of d over (A/H)^2.
_SOFTENING, _SOFT_BELOW, _SOFT_WIDTH, _DEEP, _UNSURE, _OF_LARGE_D = 2.0, 0.70, 0.06, 1.5, 0.4, 8.0
# Standard deviation of the logarithm of a constant before the film is seen, and the largest of one that is reported.
_UNKNOWN, _LARGEST = 7.0, 1.0
_QUIET = {"print_time": False, "show_eval_warnings": False}
_SETTINGS: dict[str, Any] = {"ipopt": {"print_level": 0, "sb": "yes", "tol": 1e-7, "acceptable_tol": 1e-6}, **_QUIET}


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
class ClosedForm(Drawable):
    """Constants from all features of a film together.

    Attributes
    ----------
    youngs_modulus, viscosity : Determined
        E [Pa], and the extensional eta [Pa s].
    covariance : ndarray, shape (2, 2)
        Of log E and log eta; NaN where one of them is not in the problem.
    misfit : float
        Sum of squares over the errors of reading and theory.
    residuals : dict of str to float
        log(theory/measured) of every feature used.
    film : Series
        The film, and what was read from it.
    features : Features
    """

    youngs_modulus: Determined
    viscosity: Determined
    covariance: Floats
    misfit: float
    residuals: dict[str, float]
    film: Series
    features: Features

    def to_dict(self) -> dict[str, Any]:
        """Content of ``closed_form`` in ``fit.json``: SI."""
        constants = {"youngs_modulus": self.youngs_modulus, "viscosity": self.viscosity}
        return {
            name: {"value": one.value, "log_std": one.log_error, "ci95": one.interval, "reason": one.reason}
            for name, one in constants.items()
        } | {"misfit": self.misfit, "residuals": self.residuals}

    def __repr__(self) -> str:
        lines = ["ClosedForm"]
        for name, unit in (("youngs_modulus", "Pa"), ("viscosity", "Pa*s")):
            one = getattr(self, name)
            ends = "" if one.interval is None else f" ({one.interval[0]:.3g} to {one.interval[1]:.3g}) {unit}"
            lines.append(f"{name} = {'not known: ' + one.reason if one.value is None else f'{one.value:.3g}{ends}'}")
        return "\n  ".join(lines)


def closed_form(film: Films, scene: SceneLike, changes: Changes = ()) -> ClosedForm:
    """Modulus and viscosity of a Maxwell filament from its film by formulas, without running the model.

    IPOPT weighs the frequency R, the decay rate d, the sag H, B and t_high by their errors of reading and of theory,
    under the equations of :mod:`softcat_sym.physics.rheometry`: (2.21), (2.22) for a hanging beam under tension, and
    the 1/3 law (2.20) with bending.

    Parameters
    ----------
    film : Measurements or path
        One film, as :func:`softcat_sym.fit` takes it.
    scene : Scene, str, path or dict
        The filament; its modulus and viscosity are not used.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.

    Returns
    -------
    ClosedForm
        Both constants with 95 % intervals, or the reasons why the film does not tell them.

    Raises
    ------
    SoftcatError
        If the scene is not of a straight Maxwell or Newtonian filament between level clamps, or the film shows neither
        an oscillation nor the 1/3 law.
    """
    given = as_scene(scene, changes)
    measured = taken(film, given).series
    if len(measured) > 1:
        raise SoftcatError(f"closed form: {len(measured)} films; accepted: one")
    features = features_of(measured[0], own_scene(measured[0], given))
    if features is None:
        raise SoftcatError(f"closed form: accepted: a film of {FEWEST} frames or more, in steady gravity")
    return constants_of(measured[0], features, own_scene(measured[0], given))


def features_of(film: Series, scene: Scene) -> Features | None:
    """Features of a film; None if it is too short, or gravity not steady."""
    if np.count_nonzero(film.time > 0) < FEWEST or not scene.load.gravity > 0 or scene.load.shake > 0:
        return None
    return read_features(film.time, film.midpoint, film.std, scene.load.gravity, rest_length(scene))


class _Problem:
    """Logarithms of unknowns, equations among them, and what is known of them."""

    def __init__(self) -> None:
        self.unknowns: dict[str, ca.SX] = {}
        self.start, self.equations = list[float](), list[ca.SX]()
        self.known, self.covariance = dict[str, float](), np.zeros((0, 0))

    def add(self, **start: float) -> list[ca.SX]:
        """Unknowns, and the values at which their search starts."""
        new = {name: ca.SX.sym(name) for name in start}
        self.unknowns |= new
        self.start += [math.log(value) for value in start.values()]
        return [ca.exp(symbol) for symbol in new.values()]

    def know(self, covariance: Floats, **values: float) -> None:
        """Measured values, and the covariance of their logarithms."""
        size = len(self.covariance)
        self.known |= {name: math.log(value) for name, value in values.items()}
        self.covariance = np.pad(self.covariance, (0, len(values)))
        self.covariance[size:, size:] = covariance

    def at_start(self, expression: ca.SX) -> Floats:
        """Value of an expression where the search starts."""
        function = ca.Function("at_start", list(self.unknowns.values()), [expression])
        return np.asarray(ca.DM(function(*self.start)), dtype=float).ravel()

    def solve(self) -> tuple[dict[str, float], Floats, float]:
        """Minimise the squares under the equations: the unknowns, their covariance, and the sum of squares."""
        x, equations = ca.vertcat(*self.unknowns.values()), ca.vertcat(*self.equations)
        root = np.linalg.inv(np.linalg.cholesky(self.covariance))
        misfit = ca.vertcat(*(self.unknowns[name] - value for name, value in self.known.items()))
        residual = ca.mtimes(ca.DM(root), misfit)
        solver = ca.nlpsol("closed_form", "ipopt", {"x": x, "f": ca.sumsqr(residual) / 2, "g": equations}, _SETTINGS)
        answer = solver(x0=self.start, lbg=0, ubg=0)
        if not solver.stats()["success"]:
            ending = solver.stats()["return_status"]
            raise SoftcatError(f"closed form: no constants explain all features of the film together (IPOPT: {ending})")
        jacobians = ca.Function("jacobians", [x], [ca.jacobian(residual, x), ca.jacobian(equations, x)])
        of_residual, of_equations = (np.asarray(ca.DM(matrix), dtype=float) for matrix in jacobians(answer["x"]))
        # Directions along the equations: the last rows of V in the singular value decomposition of their Jacobian.
        free = np.linalg.svd(of_equations)[2][len(of_equations) :].T
        try:
            spread = free @ np.linalg.inv(free.T @ of_residual.T @ of_residual @ free) @ free.T
        except np.linalg.LinAlgError:
            raise SoftcatError("closed form: the features leave a combination of constants open") from None
        found = dict(zip(self.unknowns, np.asarray(answer["x"], dtype=float).ravel().tolist(), strict=True))
        return found, spread, 2 * float(answer["f"])


def constants_of(film: Series, features: Features, scene: Scene) -> ClosedForm:
    """Constants from features that were read from a film; refused where the theory does not hold."""
    clamped = is_straight(scene) and is_symmetric(scene) and beam_of(scene) == CLAMPED
    if not (clamped and scene.material.spec.is_linear_fluid):
        raise SoftcatError("closed form: accepted: a Maxwell or Newtonian filament, straight between level clamps")
    ringing, late, load = features.ringing, features.late, features.prefactor
    if ringing is None and load.value is None:
        raise SoftcatError(f"closed form: {features.frequency.reason}; {load.reason}")
    unit = math.sqrt(features.span / features.gravity)
    slimness = math.sqrt(section_of(scene).gyration) * scene.filament.thickness / features.span
    problem, modulus, viscous = _Problem(), math.nan, math.nan
    if ringing is not None:
        modulus = _first_modulus(ringing, features, slimness)
        viscous = modulus / (2 * unit * max(ringing.decay, 0.02 * ringing.frequency))
    shape = 1.0
    if load.value is not None and late is not None:
        # In the middle of the frames that show the law.
        sag = float(late.sag(np.array([0.5 * (late.first + late.last)]))[0]) / features.span
        known = {rheometry.r_T: _boundary_layer(sag, slimness), SAG: sag, SPAN: 1.0}
        shape = float(evaluate(rheometry.late_prefactor(), known)[0])
        viscous = shape / (2 * load.value)
    [V] = problem.add(V=viscous)
    problem.know(np.array([[_UNKNOWN**2]]), V=viscous)
    if load.value is not None:
        _add_late_law(problem, V, load.value, features, shape)
    if ringing is not None:
        _add_ringing(problem, V, modulus, ringing, features, slimness)
    found, spread, misfit = problem.solve()
    places = [list(found).index(name) if name in found else -1 for name in ("E", "V")]
    covariance = np.array([[np.nan if -1 in (i, j) else spread[i, j] for j in places] for i in places])
    pressure = scene.filament.density * features.gravity * features.span

    def determined(number: int, size: float, reason: str) -> Determined:
        variance = covariance[number, number]
        if not variance < _LARGEST**2:
            return Determined(None, None, reason or f"known to a factor of {math.exp(math.sqrt(variance)):.2g} only")
        return Determined(size * math.exp(list(found.values())[places[number]]), math.sqrt(variance))

    return ClosedForm(
        determined(0, pressure, features.frequency.reason),
        determined(1, pressure * unit, load.reason),
        covariance,
        misfit,
        {name: found[name] - value for name, value in problem.known.items() if name not in ("E", "V")},
        film,
        features,
    )


def _boundary_layer(sag: float, slimness: float) -> float:
    """r_T at a sag; lengths over the span."""

    def excess(log_r: float) -> float:
        known = {rheometry.r_T: math.exp(log_r), SAG: sag, SPAN: 1.0, rheometry.k_g: slimness}
        return math.log(evaluate(rheometry.LAYER.left, known)[0] / evaluate(rheometry.LAYER.right, known)[0])

    shallowest, deepest = math.log(0.1), math.log(1e6)
    if not excess(shallowest) < 0 < excess(deepest):
        found = f"a sag of {sag / slimness:.2g} radii of gyration of the section"
        raise SoftcatError(f"closed form: {found}; accepted: 0.07 or more, where tension can be told from bending")
    return math.exp(brentq(excess, shallowest, deepest))


def _add_late_law(problem: _Problem, V: ca.SX, load: float, features: Features, shape: float) -> None:
    [B], onset = problem.add(B=load), features.t_high
    problem.equations.append(ca.log(2 * V * B / shape))
    problem.know(np.array([[features.prefactor.log_variance + _OF_B**2]]), B=load)
    if onset.value is not None:
        clock = onset.value / math.sqrt(features.span / features.gravity)
        [t_high] = problem.add(t_high=clock)
        values = {rheometry.B: 1 / (2 * V), rheometry.alpha: float(closed_forms.TOLERANCE)}
        problem.equations.append(ca.log(CellFunction({"": closed_forms.T_HIGH}, tuple(values))(values)[""] / t_high))
        problem.know(np.array([[onset.log_variance + _OF_ONSET**2]]), t_high=clock)


_OF_VIBRATION = (E_star, rheometry.Omega, rheometry.r_T, SAG, SPAN, rheometry.k_g)


def _first_modulus(ringing: Oscillation, features: Features, slimness: float) -> float:
    """E/(rho g L) from the frequency alone, on a grid: the largest with a mode there, which is the lowest mode's."""
    sag, unit = ringing.sag / features.span, math.sqrt(features.span / features.gravity)
    layer = _boundary_layer(sag, slimness)
    at_rest = float(evaluate(rheometry.SAG_SHARE, {rheometry.r_T: layer})[0]) / (sag * (layer * slimness) ** 2)
    grid = np.geomspace(at_rest, 1e6 * at_rest, 1200)
    values = (math.hypot(ringing.frequency, ringing.decay) * unit, layer, sag, 1.0, slimness)
    rows = dict(zip(_OF_VIBRATION, (grid, *(np.full_like(grid, value) for value in values)), strict=True))
    sign = np.sign(evaluate(rheometry.vibration(), rows))
    crossings = np.flatnonzero(sign[1:] != sign[:-1])
    return float(grid[crossings[-1]] if crossings.size else grid[0])


def _add_ringing(
    problem: _Problem, V: ca.SX, modulus: float, ringing: Oscillation, features: Features, slimness: float
) -> None:
    unit = math.sqrt(features.span / features.gravity)
    sag, swing = ringing.sag / features.span, ringing.amplitude(ringing.middle) / ringing.sag
    seen = {"R": ringing.frequency * unit, "d": max(ringing.decay, 1e-3 * ringing.frequency) * unit, "H": sag}
    E, Omega, r, R, d, H = problem.add(
        E=modulus, Omega=math.hypot(seen["R"], seen["d"]), r=_boundary_layer(sag, slimness), **seen
    )
    values = dict(zip(_OF_VIBRATION, (E, Omega, r, H, 1.0, slimness), strict=True))
    stated = {"vibration": rheometry.vibration(), "left": rheometry.LAYER.left, "right": rheometry.LAYER.right}
    theory = CellFunction(stated, _OF_VIBRATION)(values)
    slopes = [ca.gradient(theory["vibration"], problem.unknowns[name]) for name in ("E", "Omega")]
    # The elastic share p = d log Omega^2/d log E of the stiffness relaxes: imaginary and real part of
    # s^2 + (1 - p) Omega^2 + p Omega^2 s/(s + 1/tau) are zero for s = -d + i R.
    p, rate = -2 * slopes[0] / slopes[1], E / V
    softer = _SOFTENING * swing**2 / (1 + ca.exp((p - _SOFT_BELOW) / _SOFT_WIDTH)) + _DEEP * H**2
    small = R / (1 - softer)
    problem.equations += [
        ca.log(theory["left"] / theory["right"]),
        theory["vibration"] / np.linalg.norm(problem.at_start(ca.vertcat(*slopes))),
        (small**2 - 3 * d**2 + 2 * d * rate) / Omega**2 - 1,
        (3 * d * small**2 - d**3 + (d**2 - small**2) * rate) / Omega**2 - d + (1 - p) * rate,
    ]
    share, slower = problem.at_start(ca.vertcat(p, softer))
    of_d = math.hypot(_OF_D, _OF_LARGE_D * swing**2) / float(np.clip(share, 0.02, 1.0)) ** 2
    covariance = features.ringing_covariance + np.diag([_OF_R**2 + (_UNSURE * slower) ** 2, of_d**2, 0.0])
    used = [k for k, name in enumerate(seen) if name != "d" or features.decay.value is not None]
    problem.know(covariance[np.ix_(used, used)], **{name: seen[name] for k, name in enumerate(seen) if k in used})
    problem.know(np.array([[_UNKNOWN**2]]), E=modulus)
