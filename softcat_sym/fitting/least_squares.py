"""Bounded nonlinear least squares in scaled unknowns, from many starts, by SciPy or IPOPT."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, Protocol

import casadi as ca
import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares, lsq_linear
from scipy.stats import qmc

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.interrupts import TimeLimitError

Floats = NDArray[np.float64]
Method = Literal["least-squares", "ipopt"]
METHODS: tuple[Method, ...] = ("least-squares", "ipopt")


class LeastSquares(Protocol):
    """Residuals of m data in k unknowns q.

    An unknown is the logarithm of a positive parameter over its typical value, or a parameter of any sign over its
    typical value: a step of one is a large one in every unknown.
    """

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the k unknowns."""

    @property
    def lower(self) -> Floats:
        """Lower bounds of q, shape (k,), finite."""

    @property
    def upper(self) -> Floats:
        """Upper bounds of q, shape (k,), finite."""

    def residuals(self, q: Floats) -> Floats:
        """(model - datum)/standard error, shape (m,); NaN where the model has no answer."""

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals, shape (m,), and their derivatives with respect to q, shape (m, k)."""


class Fixed:
    """A problem with one unknown held at a value of q."""

    def __init__(self, whole: LeastSquares, index: int, at: float) -> None:
        self.whole, self.index, self.at = whole, index, at
        self.names = whole.names[:index] + whole.names[index + 1 :]
        self.lower, self.upper = np.delete(whole.lower, index), np.delete(whole.upper, index)

    def residuals(self, q: Floats) -> Floats:
        """Residuals of the whole problem."""
        return self.whole.residuals(np.insert(q, self.index, self.at))

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals of the whole problem, and their derivatives by the other unknowns."""
        residuals, jacobian = self.whole.linearised(np.insert(q, self.index, self.at))
        return residuals, np.delete(jacobian, self.index, axis=1)


AT_BOUND = 1e-4
"""An unknown this close to a bound, as a share of the box, lies on it."""

REACHED = 0.2
"""Largest offset of a converged optimum, in standard errors (Bates and Watts 1981)."""

SOLVED = "Solve_Succeeded"
STUCK = "Search_Direction_Becomes_Too_Small"
_CUT_SHORT = "Maximum_Evaluations_Exceeded"
OUT_OF_TIME = "Time_Limit_Exceeded"

# Default tolerance: predicted decrease of twice the loss in the next step, as a share of the residuals' variance.
_GAIN = 1e-12
# Damping of a step of one in q, as a share of the residuals' variance, for directions that hardly change the residuals.
_DAMPING = 1e-6
# The search ends if so many accepted steps lower twice the loss by less than this share of the residuals' variance.
_PATIENCE, _LITTLE = 6, 0.25
# Tolerances of SciPy: relative decrease of the loss, and relative length of a step; and of IPOPT.
_FTOL, _XTOL, _IPOPT_TOLERANCE = 1e-14, 1e-8, 1e-7
# Share of the loss at the start below which a loss is rounding error.
_ROUNDING = 1e-18


@dataclass(frozen=True, eq=False)
class Optimum:
    """Result of one optimisation."""

    q: Floats  # shape (k,); The unknowns
    value: float  # 1/2 |r|^2
    residuals: Floats  # shape (m,); At `q`
    jacobian: Floats  # shape (m, k); Their derivatives
    iterations: int  # Steps of the method, and evaluations of the model with or without derivatives
    evaluations: int
    status: str  # Why the search ended
    converged: bool  # Whether the search succeeded and `offset` is small
    at_bound: NDArray[np.bool_]  # shape (k,); Which unknowns lie on a bound
    # Norm of that part of the residuals that a step of at most one inside the box would remove to first order, over the
    # root mean square residual (Bates and Watts 1981): the distance from the optimum in standard errors. It has no
    # meaning where the residuals are rounding errors.
    offset: float
    begun: float  # Norm of the residuals at the start


@dataclass(frozen=True, eq=False)
class _Point:
    """The model at one point; `value` is NaN where the model has no answer."""

    q: Floats
    value: float
    residuals: Floats
    jacobian: Floats


class _Model:
    """A problem; it counts evaluations, keeps the best point, and knows when a search is over."""

    def __init__(self, problem: LeastSquares, start: Floats, gain: float | None, max_evaluations: int) -> None:
        self.problem, self.gain, self.evaluations = problem, gain, 0
        self.max_evaluations, self._accepted = max_evaluations, list[float]()
        self.last = self.first = self.best = self._evaluated(check_in_box(problem, start))
        if not math.isfinite(self.first.value):
            raise SoftcatError("the model has no answer where the fit starts; accepted: another starting point")

    def at(self, q: Floats) -> _Point:
        """Evaluate with derivatives, in the box."""
        q = np.clip(q, self.problem.lower, self.problem.upper)
        if not np.array_equal(q, self.last.q):
            self.last = self._evaluated(q)
            if self.last.value < self.best.value:
                self.best = self.last
        return self.last

    def _evaluated(self, q: Floats) -> _Point:
        self.evaluations += 1
        residuals, jacobian = self.problem.linearised(q.copy())
        finite = np.isfinite(residuals).all() and np.isfinite(jacobian).all()
        return _Point(q, 0.5 * float(residuals @ residuals) if finite else math.nan, residuals, jacobian)

    def accepts(self) -> bool:
        """Count the best point as a step; whether it is the last one, as the next would gain too little."""
        variance = self.variance(self.best)
        self._accepted.append(self.best.value)
        if len(self._accepted) > _PATIENCE and self.gain is not None:
            together = 2 * (self._accepted[-1 - _PATIENCE] - self.best.value)
            if together < _LITTLE * variance:
                # The accepted steps follow the model's integration error.
                return True
        return self._predicted_decrease() <= (_GAIN * variance if self.gain is None else self.gain)

    def is_at_optimum(self) -> bool:
        """Whether the next step of Gauss and Newton would be far below what `REACHED` allows."""
        return self._predicted_decrease() < (2e-4 * REACHED) ** 2 * self.variance(self.best)

    def is_hidden_by_noise(self) -> bool:
        """Whether a step that fails does so by the model's integration error: no search could come closer."""
        return self.gain is not None and self._predicted_decrease() < REACHED**2 * self.variance(self.best)

    def _predicted_decrease(self) -> float:
        return _gauss_newton_step(self.problem, self.best, self.variance(self.best))[1]

    def variance(self, point: _Point) -> float:
        """Mean square of the residuals, at least that of rounding errors."""
        least = float(np.finfo(float).tiny) + _ROUNDING * self.first.value
        return 2 * max(point.value, least) / point.residuals.size

    def optimum(self, status: str) -> Optimum:
        """Return the result of a search that has ended."""
        point = self.best
        variance = self.variance(point)
        fall = max(_gauss_newton_step(self.problem, point, variance)[1], 0.0)
        offset = math.sqrt(fall / variance)
        # A point is an optimum, too, where the next step gains too little, or where the residuals are rounding errors.
        met = offset < REACHED or fall <= (self.gain or 0.0) or point.value <= 1e4 * _ROUNDING * self.first.value
        return Optimum(
            q=point.q,
            value=point.value,
            residuals=point.residuals,
            jacobian=point.jacobian,
            iterations=len(self._accepted),
            evaluations=self.evaluations,
            status=STUCK if status == SOLVED and not met else status,
            converged=status == SOLVED and met,
            at_bound=on_bound(self.problem, point.q),
            offset=offset,
            begun=float(np.linalg.norm(self.first.residuals)),
        )


def minimise(
    problem: LeastSquares,
    start: Floats,
    *,
    method: Method = "least-squares",
    gain: float | None = None,
    max_evaluations: int = 100,
) -> Optimum:
    """Minimise 1/2 |r|^2 in the box of the problem, from one start.

    The method is SciPy's ``least_squares`` (dogbox: Gauss-Newton steps in a rectangular trust region), or IPOPT
    (``method="ipopt"``), which takes three times as many evaluations. The search ends where the next step would lower
    twice the loss by less than `gain`, by default 1e-12 of the residuals' variance, so that it does not follow
    undetermined unknowns to their bounds.
    """
    model = _Model(problem, start, gain, max_evaluations)
    try:
        status = (_by_ipopt if method == "ipopt" else _by_scipy)(model)
    except _EndOfSearchError:
        status = SOLVED
    except TimeLimitError:
        status = OUT_OF_TIME
    return model.optimum(status)


def polished(problem: LeastSquares, optimum: Optimum) -> Optimum:
    """The point to which the last linearisation leads from a converged optimum, without an evaluation of the model.

    A search ends where its next step, of a few hundredths of a standard error, would gain too little.
    """
    point = _Point(optimum.q, optimum.value, optimum.residuals, optimum.jacobian)
    step, fall = _gauss_newton_step(problem, point, 2 * optimum.value / optimum.residuals.size)
    if not optimum.converged or optimum.status != SOLVED or fall <= 0:
        return optimum
    q = np.clip(optimum.q + step, problem.lower, problem.upper)
    return replace(
        optimum,
        q=q,
        value=optimum.value - 0.5 * fall,
        residuals=optimum.residuals + optimum.jacobian @ step,
        at_bound=on_bound(problem, q),
    )


class _EndOfSearchError(Exception):
    """Raised by a callback to end a search."""


def _by_scipy(model: _Model) -> str:
    """Dogbox steps of SciPy; the status."""

    def residuals(q: Floats) -> Floats:
        # SciPy shortens its step where the model has no answer or no derivatives.
        point = model.at(q)
        if point is not model.best and model.is_hidden_by_noise():
            raise _EndOfSearchError
        found: Floats = np.where(np.isfinite(point.value), point.residuals, np.nan)
        return found

    def jacobian(q: Floats) -> Floats:
        # At the point that SciPy has accepted, which is the best.
        if model.accepts():
            raise _EndOfSearchError
        return model.best.jacobian

    how: dict[str, Any] = {"method": "dogbox"} | {
        "ftol": _FTOL,
        "xtol": _XTOL,
        "gtol": None,
        "max_nfev": model.max_evaluations,
    }
    bounds = model.problem.lower, model.problem.upper
    return SOLVED if least_squares(residuals, model.first.q, jacobian, bounds, **how).success else _CUT_SHORT


def _gauss_newton_step(problem: LeastSquares, point: _Point, variance: float) -> tuple[Floats, float]:
    """Step inside the box, of at most one, and the decrease of twice the loss that it predicts to second order."""
    damped = np.vstack([point.jacobian, math.sqrt(_DAMPING * variance) * np.eye(point.q.size)])
    low = np.maximum(problem.lower - point.q, -1.0)
    high = np.minimum(problem.upper - point.q, 1.0)
    step = lsq_linear(damped, np.append(-point.residuals, np.zeros(point.q.size)), (low, high), method="bvls").x
    moved = point.jacobian @ step
    return step, -float(2 * point.residuals @ moved + moved @ moved)


def on_bound(problem: LeastSquares, q: Floats) -> NDArray[np.bool_]:
    """Find the unknowns that lie on a bound, shape (k,)."""
    room = np.minimum(q - problem.lower, problem.upper - q)
    near: NDArray[np.bool_] = room <= AT_BOUND * (problem.upper - problem.lower)
    return near


def check_in_box(problem: LeastSquares, q: Floats) -> Floats:
    """Return a copy of a point that has the right length and lies in the box."""
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


def _by_ipopt(model: _Model) -> str:
    """Minimise by IPOPT within the box, with the Hessian of Gauss and Newton; the status."""
    size, raised = model.first.q.size, list[BaseException]()
    # The loss in units of half the number of data at the start.
    scale = 1 / model.variance(model.first)

    def at(q: ca.DM) -> _Point:
        if model.evaluations >= model.max_evaluations:
            raise _EndOfSearchError
        return model.at(np.asarray(q, dtype=float).ravel())

    def value(q: ca.DM) -> ca.DM:
        return ca.DM(scale * at(q).value)

    def gradient(q: ca.DM, *_: ca.DM) -> list[ca.DM]:
        point = at(q)
        return [ca.DM(scale * point.value), ca.DM(scale * (point.jacobian.T @ point.residuals))]

    def hessian(q: ca.DM, _: ca.DM, factor: ca.DM, *__: ca.DM) -> ca.DM:
        columns = at(q).jacobian
        return ca.triu(ca.DM(scale * float(factor) * (columns.T @ columns)))

    def is_over(*_: ca.DM) -> ca.DM:
        return ca.DM(model.accepts())

    q, one, none = ca.Sparsity.dense(size, 1), ca.Sparsity.dense(1, 1), ca.Sparsity(0, 0)
    x = ca.MX.sym("x", size)
    objective = _Callback("objective", value, [q], [one], raised)
    of_gradient = _Callback("gradient", gradient, [q, none], [one, q], raised)
    of_hessian = _Callback("hessian", hessian, [q, none, one, none], [ca.Sparsity.upper(size)], raised)
    steps = _Callback("steps", is_over, [q, one, none, q, none, none], [one], raised)
    # The model is not evaluated outside the box, and the loss is already scaled.
    own = {"print_level": 0, "sb": "yes", "bound_relax_factor": 0.0, "nlp_scaling_method": "none", "max_soc": 0}
    own |= {"tol": _IPOPT_TOLERANCE, "max_iter": model.max_evaluations, "mu_init": 1e-2}
    settings: dict[str, Any] = {"grad_f": of_gradient, "hess_lag": of_hessian, "iteration_callback": steps}
    settings |= {"ipopt": own, "calc_lam_p": False, "no_nlp_grad": True, "print_time": False}
    settings |= {"show_eval_warnings": False, "error_on_fail": False}
    solver = ca.nlpsol("fit", "ipopt", {"x": x, "f": objective(x)}, settings)
    try:
        solver(x0=model.first.q, lbx=model.problem.lower, ubx=model.problem.upper)
    except (RuntimeError, KeyboardInterrupt):
        # CasADi wraps what a callback raised.
        if not raised:
            raise
    if raised and not isinstance(raised[0], _EndOfSearchError):
        raise raised[0]
    status = str(solver.stats()["return_status"])
    ends = {"Solve_Succeeded", "Solved_To_Acceptable_Level", "User_Requested_Stop"}
    # In the noise of the model's integration IPOPT's line search goes on, without a step that it accepts.
    ends |= {status} if model.is_at_optimum() else set()
    return SOLVED if status in ends else _CUT_SHORT if raised else status


class _Callback(ca.Callback):
    """A function of Python as one of CasADi; what it raises is kept for the caller of IPOPT, as CasADi swallows it."""

    def __init__(
        self,
        name: str,
        function: Callable[..., ca.DM | list[ca.DM]],
        given: Sequence[ca.Sparsity],
        found: Sequence[ca.Sparsity],
        raised: list[BaseException],
    ) -> None:
        ca.Callback.__init__(self)
        self._function, self._given, self._found, self._raised = function, given, found, raised
        self.construct(name, {})

    def get_n_in(self) -> int:
        return len(self._given)

    def get_n_out(self) -> int:
        return len(self._found)

    def get_sparsity_in(self, k: int) -> ca.Sparsity:
        return self._given[k]

    def get_sparsity_out(self, k: int) -> ca.Sparsity:
        return self._found[k]

    def eval(self, arguments: Sequence[ca.DM]) -> list[ca.DM]:
        if not self._raised:
            try:
                answer = self._function(*arguments)
                return answer if isinstance(answer, list) else [answer]
            except BaseException as error:  # noqa: BLE001 - the caller of IPOPT raises it
                self._raised.append(error)
        # IPOPT shortens its step at NaN, and ends soon if every further value is NaN.
        return [ca.DM(one, np.nan) for one in self._found]


SAME_FIT = 0.1
"""Two fits whose residuals differ by less than this share of a standard deviation are one fit."""

# Share of the residuals at the starts below which a difference of two fits is rounding error.
_SAME_OPTIMUM = 1e-6
# Maximum evaluations of a drawn start: one that has not converged by then lies in an unrealistic corner of the box.
_MAX_OF_DRAWN = 40
# After so many evaluations the search from a drawn start ends if its loss is so many times that of the best.
_FIRST_LOOK, _HOPELESS = 10, 10.0
# An unknown has no effect if a unit step changes the sum of squares by less than this share of the residuals' variance.
_FLAT, _HALVINGS = 1e-3, 3


@dataclass(frozen=True, eq=False)
class StartResult:
    """Result of one start."""

    start: Floats  # shape (k,)
    optimum: Optimum
    # Number of the fit, 0 for the best: starts that end in the same curve through the data share it, even where their
    # unknowns differ because the data do not determine them.
    cluster: int


@dataclass(frozen=True, eq=False)
class MultiStartResult:
    """Results of all starts, the best first."""

    results: tuple[StartResult, ...]  # Sorted by value, those that converged first
    rejected: int  # Starts at which the model has no answer

    @property
    def best(self) -> Optimum:
        """The optimum with the smallest loss."""
        return self.results[0].optimum

    @property
    def reached_best(self) -> int:
        """Number of starts that end in the best fit; only one of many suggests that a better optimum exists."""
        return sum(result.cluster == 0 for result in self.results)


def multi_start(
    problem: LeastSquares,
    given: Sequence[Floats],
    *,
    count: int = 0,
    seed: int = 0,
    method: Method = "least-squares",
    gain: float | None = None,
    enough: Callable[[Optimum], bool] = lambda best: False,
    on_progress: Callable[[int, int], None] = lambda done, total: None,
) -> MultiStartResult:
    """Minimise from the given starts and from a Latin hypercube of the box (McKay et al. 1979).

    No further start is tried once the best has converged and `enough` accepts it. The search from a drawn start ends
    early if its loss is still far above the best after some steps.
    """
    starts = [check_in_box(problem, start) for start in given]
    if count:
        drawn = qmc.LatinHypercube(problem.lower.size, seed=np.random.default_rng(seed)).random(count)
        starts += list(qmc.scale(drawn, problem.lower, problem.upper))
    ended, timed_out = list[tuple[Floats, Optimum]](), False
    how: dict[str, Any] = {"method": method, "gain": gain}
    for number, start in enumerate(starts):
        on_progress(number, len(starts))
        # A stuck search is limited by integration error, and continues with smaller time steps.
        reached = (one for _, one in ended if one.converged or one.status == STUCK)
        best = min(reached, key=lambda one: one.value, default=None)
        timed_out = timed_out or any(one.status == OUT_OF_TIME for _, one in ended)
        # A stuck search may be near a neighbouring optimum: the other given starts are tried then.
        if timed_out or (best is not None and (best.converged or number >= len(given)) and enough(best)):
            starts = starts[:number]
            break
        try:
            is_drawn = number >= len(given)
            found = _from_drawn(problem, start, best, how) if is_drawn else _from_start(problem, start, 300, how)
        except TimeLimitError:
            found, timed_out = None, True
        ended += [(start, found)] if found is not None else []
    if not ended:
        if timed_out:
            raise TimeLimitError
        remedy = "bounds or starting values for which it can be solved"
        raise SoftcatError(f"the model has no answer at any of {len(starts)} starts; accepted: {remedy}")
    ended.sort(key=lambda pair: (not pair[1].converged, pair[1].value))
    first = ended[0][1].residuals
    near = max(SAME_FIT * float(np.sqrt(np.mean(first**2))), _SAME_OPTIMUM * max(one.begun for _, one in ended))
    leaders, results = list[Floats](), []
    for start, optimum in ended:
        distances = [float(np.linalg.norm(optimum.residuals - leader)) for leader in leaders]
        cluster = next((k for k, distance in enumerate(distances) if distance < near), len(leaders))
        if cluster == len(leaders):
            leaders.append(optimum.residuals)
        results.append(StartResult(start, optimum, cluster))
    return MultiStartResult(tuple(results), len(starts) - len(ended))


def _from_start(problem: LeastSquares, start: Floats, max_evaluations: int, how: Mapping[str, Any]) -> Optimum | None:
    """The optimum reached from a start; None where the model has no answer at the start."""
    residuals = problem.residuals(start)
    if not (np.isfinite(residuals).all() and np.isfinite(problem.linearised(start)[1]).all()):
        return None
    return minimise(problem, start, **how, max_evaluations=max_evaluations)


def _from_drawn(problem: LeastSquares, start: Floats, best: Optimum | None, how: Mapping[str, Any]) -> Optimum | None:
    """The optimum reached from a drawn start; the search ends early if its loss stays far above the best."""
    found = _from_start(problem, _off_plateau(problem, start), _FIRST_LOOK, how)
    if found is None or found.converged or (best is not None and found.value > _HOPELESS * best.value):
        return found
    further = minimise(problem, found.q, **how, max_evaluations=_MAX_OF_DRAWN)
    return replace(further, begun=found.begun)


def _off_plateau(problem: LeastSquares, start: Floats) -> Floats:
    """Move a start towards the middle of the box until every unknown affects the residuals."""
    middle = 0.5 * (problem.lower + problem.upper)
    for _ in range(_HALVINGS):
        if not np.isfinite(problem.residuals(start)).all():
            break
        residuals, jacobian = problem.linearised(start)
        if not np.isfinite(jacobian).all() or np.all(np.sum(jacobian**2, axis=0) > _FLAT * np.mean(residuals**2)):
            break
        start = 0.5 * (start + middle)
    return start
