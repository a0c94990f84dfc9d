"""Bounded nonlinear least squares: IPOPT with the Gauss-Newton Hessian, in units in which the noise is one."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.inverse.estimation.gauss_newton import NOISE, REACHED, Model, Point, on_bound
from softcat_sym.inverse.estimation.ipopt import Run, run
from softcat_sym.inverse.estimation.least_squares import LINEAR, Floats, LeastSquares, Loss

# Of the first value: less is rounding, in which a further run would lose its way.
_ROUNDING = 1e-18
_ROUNDS = 3


@dataclass(frozen=True, eq=False)
class Optimum:
    """Where the optimisation ended; the best point seen, if IPOPT failed.

    Attributes
    ----------
    q : ndarray, shape (k,)
        The unknowns.
    value : float
        1/2 sum rho(r^2).
    residuals : ndarray, shape (m,)
        At `q`, before the loss.
    jacobian : ndarray, shape (m, k)
        Their derivatives.
    iterations, evaluations : int
        Of IPOPT; of the model with derivatives.
    status : str
        IPOPT's own word for how it ended; or that it was stopped, because the noise of the model's own arithmetic left
        nothing to gain around an optimum that is reached as far as the data can tell, or after too many evaluations.
    converged : bool
        Whether IPOPT ended with success, or was stopped for the first of these reasons.
    at_bound : ndarray of bool, shape (k,)
        Which unknowns lie on a bound.
    offset : float
        Norm of that part of the residuals that a step of the unknowns inside the box would remove to first order, over
        the root mean square residual (Bates and Watts 1981): the distance from the optimum in standard errors. Means
        nothing where the data are met to rounding.
    """

    q: Floats
    value: float
    residuals: Floats
    jacobian: Floats
    iterations: int
    evaluations: int
    status: str
    converged: bool
    at_bound: NDArray[np.bool_]
    offset: float


@dataclass(frozen=True)
class DerivativeCheck:
    """What IPOPT's first-order derivative checker found.

    Attributes
    ----------
    clean : bool
        Whether it found no error.
    text : str
        What it wrote.
    """

    clean: bool
    text: str


def minimise(
    problem: LeastSquares,
    start: Floats,
    *,
    loss: Loss = LINEAR,
    warm: bool = False,
    tolerance: float = 1e-7,
    max_evaluations: int = 300,
) -> Optimum:
    """Minimise 1/2 sum rho(r^2) in the box of the problem, from one start.

    In IPOPT's units the residuals' root mean square and the unknowns' standard errors are about one, as the start tells
    them. Where the end is no optimum in its own units, IPOPT starts again from there.

    Parameters
    ----------
    problem : LeastSquares
        Evaluated once a point, always inside the box.
    start : ndarray, shape (k,)
        In the box.
    loss : Loss
        What residuals are charged.
    warm : bool
        Whether the start is close to the optimum.
    tolerance : float
        Of the gradient, in those units; a thousand times as much is accepted where no more is to be had.
    max_evaluations : int
        Of the model.

    Raises
    ------
    SoftcatError
        If the start lies outside the box, or the model has no answer there.
    Exception
        Whatever the model raises, KeyboardInterrupt included, as it was raised.
    """
    model = Model(problem, loss, max_evaluations)
    here = _checked_start(model, start)
    iterations, first = 0, here.value
    for count in range(_ROUNDS):
        before = here.value
        options = _options(tolerance, max_evaluations, warm=warm or count > 0)
        units, scale = _units(model, here)
        ended = run(model, here.q, units, scale, options)
        iterations += ended.iterations
        here = model.at(ended.q) if ended.success else model.best
        done = model.step(here)[1] < REACHED or not _ROUNDING * first < here.value < (1 - 1e-9) * before
        if model.stopped is not None or (done and ended.success):
            break
    return _optimum(model, here, ended, iterations)


def check_derivatives(
    problem: LeastSquares, q: Floats, *, step: float = 1e-6, tolerance: float = 1e-4, loss: Loss = LINEAR
) -> DerivativeCheck:
    """Compare the gradient with differences of the value, by IPOPT's own derivative checker.

    Parameters
    ----------
    problem : LeastSquares
        The problem.
    q : ndarray, shape (k,)
        Where; inside the box by more than the step.
    step : float
        Of the one-sided differences of q.
    tolerance : float
        Largest deviation, relative to the derivative or to the root mean square of all of them, the larger of the two.
    loss : Loss
        What residuals are charged.

    Raises
    ------
    SoftcatError
        If the point lies outside the box or on its edge, or the model has no answer there.
    """
    model = Model(problem, loss, 10 * len(problem.names) + 10)
    here = _checked_start(model, q)
    if np.any(np.minimum(here.q - problem.lower, problem.upper - here.q) <= step):
        raise SoftcatError("derivatives are checked at a bound; accepted: a point inside the box")
    size = float(np.sqrt(np.mean(model.gradient(here) ** 2)))
    with tempfile.TemporaryDirectory() as directory:
        output = Path(directory) / "ipopt.txt"
        options = {
            "derivative_test": "first-order",
            "derivative_test_perturbation": step,
            "derivative_test_tol": tolerance,
            "point_perturbation_radius": 0.0,
            "output_file": str(output),
            "file_print_level": 5,
            "max_iter": 0,
        }
        run(model, here.q, np.ones(here.q.size), 1 / size if size > 0 else 1.0, options)
        lines = output.read_text(encoding="utf-8").splitlines()
    begin = next((k for k, line in enumerate(lines) if "derivative checker" in line), 0)
    end = next((k for k, line in enumerate(lines) if line.startswith("Number of nonzeros")), len(lines))
    text = "\n".join(line for line in lines[begin:end] if line)
    return DerivativeCheck("No errors detected" in text, text)


def check_in_box(problem: LeastSquares, q: Floats) -> Floats:
    """Return a copy of a point that has the right length and lies in the box.

    Raises
    ------
    SoftcatError
        If it does not, with every unknown that is out.
    """
    at = np.array(q, dtype=np.float64)
    if at.shape != (len(problem.names),):
        raise SoftcatError(f"{at.size} starting values for {len(problem.names)} unknowns; accepted: one for each")
    rows = zip(problem.names, at.tolist(), problem.lower.tolist(), problem.upper.tolist(), strict=True)
    faults = [
        Fault(name, f"starts at q = {value:.6g}", f"between {low:.6g} and {high:.6g}")
        for name, value, low, high in rows
        if not low <= value <= high
    ]
    if faults:
        raise SoftcatError("\n".join(str(fault) for fault in faults))
    return at


def _optimum(model: Model, here: Point, ended: Run, iterations: int) -> Optimum:
    return Optimum(
        q=here.q,
        value=here.value,
        residuals=here.residuals,
        jacobian=here.jacobian,
        iterations=iterations,
        evaluations=model.evaluations,
        status=ended.status,
        converged=ended.success or ended.status == NOISE,
        at_bound=on_bound(model.problem, here.q),
        offset=model.step(here)[1],
    )


def _checked_start(model: Model, start: Floats) -> Point:
    model.at(check_in_box(model.problem, start))
    return model.best


def _options(tolerance: float, most: int, *, warm: bool) -> dict[str, object]:
    """IPOPT's; the barrier starts low, for few optima lie on the box, and lower when the start is one of them."""
    push = 1e-6 if warm else 1e-2
    return {
        "tol": tolerance,
        "acceptable_tol": 1e3 * tolerance,
        "acceptable_iter": 4,
        "max_iter": most,
        "mu_init": 1e-6 if warm else 1e-2,
        "bound_push": push,
        "bound_frac": push,
        "max_soc": 0,
    }


def _units(model: Model, point: Point) -> tuple[Floats, float]:
    """Units of the unknowns, their standard errors one by one, and the scale that makes the value m/2."""
    points = point.residuals.size
    # Residuals that a step of 1e-9 would change as much are met to rounding.
    least = 0.5e-18 * float(np.sum(point.jacobian**2)) / point.q.size
    scale = 0.5 * points / max(point.value, least, np.finfo(float).tiny)
    curvature = np.sqrt(scale * np.diag(model.hessian(point)))
    largest = float(curvature.max())
    if not largest > 0:
        return np.ones(curvature.size), scale
    # An unknown that does not matter here may matter elsewhere: its unit is not left to grow without bound.
    return 1 / np.maximum(curvature, 1e-3 * largest), scale
