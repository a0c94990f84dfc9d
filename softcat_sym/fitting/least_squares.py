"""Bounded nonlinear least squares in scaled unknowns, from many starts: IPOPT, then damped Gauss-Newton steps."""

from __future__ import annotations

import math
import tempfile
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, Protocol

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import Fault, SoftcatError

Floats = NDArray[np.float64]


class LeastSquares(Protocol):
    """What can be fitted: residuals of m data in k unknowns q.

    An unknown is the logarithm of a positive parameter over its typical value, or a parameter of any sign over its
    typical value: a step of one is a large one in every unknown.
    """

    @property
    def names(self) -> tuple[str, ...]:
        """The k unknowns."""

    @property
    def lower(self) -> Floats:
        """Least possible q, shape (k,), finite."""

    @property
    def upper(self) -> Floats:
        """Largest possible q, shape (k,), finite."""

    def residuals(self, q: Floats) -> Floats:
        """(model - datum)/standard error, shape (m,); NaN where the model has no answer."""

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals, shape (m,), and their derivatives with respect to q, shape (m, k)."""


def has_answer(problem: LeastSquares, q: Floats) -> bool:
    """Whether the model has an answer, and derivatives, at q: the cheaper question first."""
    if not np.isfinite(problem.residuals(q)).all():
        return False
    return all(bool(np.isfinite(part).all()) for part in problem.linearised(q))


@dataclass(frozen=True)
class Loss:
    """rho in the sum 1/2 sum rho(r^2) that is minimised, with z = (r/scale)^2.

    ``"linear"``: rho = r^2. ``"soft-l1"``: rho = 2 scale^2 (sqrt(1 + z) - 1). ``"cauchy"``: rho = scale^2 log(1 + z).
    Outliers beyond `scale` weigh less (Triggs et al. 2000, section 3; the forms are those of SciPy).
    """

    kind: Literal["linear", "soft-l1", "cauchy"] = "linear"  # One of the three
    scale: float = 1.0  # Residual from which on a point counts as an outlier, in the unit of the residuals

    def __post_init__(self) -> None:
        if self.kind not in ("linear", "soft-l1", "cauchy"):
            raise SoftcatError(f"no loss {self.kind!r}; accepted: linear, soft-l1, cauchy")
        if not 0 < self.scale < math.inf:
            raise SoftcatError(f"the scale of a loss is {self.scale!r}; accepted: a positive number")

    def value(self, residuals: Floats) -> float:
        """1/2 sum rho(r^2)."""
        if self.kind == "linear":
            return 0.5 * float(residuals @ residuals)
        z = (residuals / self.scale) ** 2
        # Without the difference of nearly equal numbers that small residuals would make.
        rho = 2 * z / (np.sqrt(1 + z) + 1) if self.kind == "soft-l1" else np.log1p(z)
        return 0.5 * self.scale**2 * float(rho.sum())

    def weights(self, residuals: Floats) -> Floats:
        """Weight rho'(r^2) of each squared residual in the gradient, shape (m,), at most one."""
        z = (residuals / self.scale) ** 2
        return {"linear": np.ones_like(z), "soft-l1": 1 / np.sqrt(1 + z), "cauchy": 1 / (1 + z)}[self.kind]

    def slopes(self, residuals: Floats) -> Floats:
        """Derivative rho' + 2 r^2 rho'' of psi(r) = rho'(r^2) r, shape (m,); of Cauchy's outliers negative."""
        z = (residuals / self.scale) ** 2
        if self.kind == "cauchy":
            return np.asarray((1 - z) / (1 + z) ** 2, dtype=np.float64)
        return np.asarray((1 + z) ** -1.5 if self.kind == "soft-l1" else np.ones_like(z), dtype=np.float64)

    def curvatures(self, residuals: Floats) -> Floats:
        """Weight of each squared derivative in the Gauss-Newton Hessian, shape (m,).

        The slopes of psi, cut at zero where the loss of an outlier curves downwards and would make the Hessian
        indefinite.
        """
        return np.maximum(self.slopes(residuals), 0.0)


LINEAR = Loss()


@dataclass(frozen=True, eq=False)
class Fixed:
    """A problem with one unknown held at a value."""

    whole: LeastSquares  # The problem
    index: int  # Which unknown is held
    at: float  # Its q

    @property
    def names(self) -> tuple[str, ...]:
        """The other unknowns."""
        return tuple(name for k, name in enumerate(self.whole.names) if k != self.index)

    @property
    def lower(self) -> Floats:
        """Least possible q of the others."""
        return np.delete(self.whole.lower, self.index)

    @property
    def upper(self) -> Floats:
        """Largest possible q of the others."""
        return np.delete(self.whole.upper, self.index)

    def filled(self, q: Floats) -> Floats:
        """All unknowns, shape (k,), from the others, shape (k - 1,)."""
        return np.insert(q, self.index, self.at)

    def residuals(self, q: Floats) -> Floats:
        """As of the whole problem."""
        return self.whole.residuals(self.filled(q))

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """As of the whole problem, without the column of the unknown that is held."""
        residuals, jacobian = self.whole.linearised(self.filled(q))
        return residuals, np.delete(jacobian, self.index, axis=1)


REACHED = 1e-4
"""Offset of an optimum that is reached as far as data can tell (Bates and Watts 1981)."""

AT_BOUND = 1e-4
"""An unknown this close to a bound, as a share of the box, lies on it."""

NOISE = "Stopped_At_Noise_Of_Model"
"""Said of an optimum around which the model's own noise leaves nothing to gain."""

# So many points in a row without a lower value, where the step that Gauss and Newton would still make is less than a
# tenth of the standard errors, or a hundred-thousandth: the model's arithmetic is too noisy for a line search.
_PATIENCE, _SMALL_OFFSET, _SMALL_STEP = 6, 0.1, 1e-5
_GAIN = 1e-8
# Of the value: a rise that is noise where the step left to do is small and has become ten times smaller.
_RISE, _SMALLER = 1e-5, 0.1


@dataclass(frozen=True, eq=False)
class Point:
    """The model at one point; the value is NaN where it has no answer."""

    q: Floats  # shape (k,); The unknowns
    value: float  # 1/2 sum rho(r^2)
    residuals: Floats  # shape (m,); Before the loss
    jacobian: Floats  # shape (m, k); Their derivatives


class Model:
    """A problem with its loss, whose last point and best point are kept."""

    def __init__(self, problem: LeastSquares, loss: Loss, most: int) -> None:
        self.problem = problem
        self.loss = loss
        self.evaluations = 0
        self.stopped: str | None = None
        self._most = most
        self._last: Point | None = None
        self._best: Point | None = None
        self._mark, self._marked_at = np.inf, 0

    @property
    def best(self) -> Point:
        """The point of the least value so far; among those that noise alone tells apart, the one nearest an optimum."""
        if self._best is None:
            raise SoftcatError("the model has no answer where the fit starts; accepted: another starting point")
        return self._best

    def at(self, q: Floats) -> Point:
        """Evaluate, unless this is the last or the best point."""
        for known in (self._last, self._best):
            if known is not None and np.array_equal(known.q, q):
                return known
        self.evaluations += 1
        residuals, jacobian = self.problem.linearised(q)
        finite = bool(np.isfinite(residuals).all() and np.isfinite(jacobian).all())
        value = self.loss.value(residuals) if finite else np.nan
        self._last = Point(q.copy(), value, residuals, jacobian)
        if finite and (self._best is None or value < self._best.value):
            self._best = self._last
        self._judge_progress()
        return self._last

    def step(self, point: Point) -> tuple[Floats, float]:
        """What Gauss and Newton would still do."""
        step = np.zeros(point.q.size)
        free = ~on_bound(self.problem, point.q)
        size = float(np.sqrt(np.mean(point.residuals**2)))
        if size == 0 or not free.any():
            return step, 0.0
        root = np.sqrt(self.loss.weights(point.residuals))
        columns = root[:, None] * point.jacobian[:, free]
        step[free] = -np.linalg.lstsq(columns, root * point.residuals, rcond=1e-8)[0]
        return step, float(np.linalg.norm(columns @ step[free])) / size

    def _judge_progress(self) -> None:
        if self._best is not None and self._best.value < self._mark * (1 - _GAIN):
            self._mark, self._marked_at = self._best.value, self.evaluations
        elif self._last is not None and self._is_nearer(self._last):
            # Derivatives of the discrete solution have far less noise than its value: this point is the better one.
            if self._last.value > self.best.value * (1 + _GAIN):
                self.stopped = NOISE
            # What rose by less is as low as the other, and a line search may go on from there.
            self._last = replace(self._last, value=self.best.value)
            self._best = self._last
        elif self._best is not None and (self.evaluations - self._marked_at) % _PATIENCE == 0:
            step, offset = self.step(self._best)
            if offset < _SMALL_OFFSET or np.abs(step).max() < _SMALL_STEP:
                self.stopped = NOISE
        if self.evaluations >= self._most and self.stopped is None:
            self.stopped = "Maximum_Evaluations_Exceeded"

    def _is_nearer(self, last: Point) -> bool:
        """Whether a point is nearer to an optimum than the best one, though by noise its value is not lower."""
        best = self._best
        if best is None or last is best or not last.value <= best.value * (1 + _RISE):
            return False
        offset = self.step(best)[1]
        return offset < _SMALL_OFFSET and self.step(last)[1] < _SMALLER * offset

    def gradient(self, point: Point) -> Floats:
        """Of the value with respect to q, shape (k,)."""
        gradient: Floats = point.jacobian.T @ (self.loss.weights(point.residuals) * point.residuals)
        return gradient

    def hessian(self, point: Point) -> Floats:
        """Gauss-Newton's, shape (k, k)."""
        hessian: Floats = point.jacobian.T @ (self.loss.curvatures(point.residuals)[:, None] * point.jacobian)
        return hessian


def on_bound(problem: LeastSquares, q: Floats) -> NDArray[np.bool_]:
    """Which unknowns lie within `AT_BOUND` of the box of one of their bounds; shape (k,)."""
    room = np.minimum(q - problem.lower, problem.upper - q)
    near: NDArray[np.bool_] = room <= AT_BOUND * (problem.upper - problem.lower)
    return near


# In units of chi^2 for a step of one in q: directions that matter less hardly move.
_DAMPING = 1e-3
_MIN_DAMPING, _LESS, _MORE, _MAX_DAMPING = 1e-6, 0.1, 10.0, 1e4


@dataclass(frozen=True, eq=False)
class Settled:
    """Where the steps ended."""

    q: Floats  # shape (k,); The unknowns, in the box
    value: float  # Twice the loss there
    evaluations: int  # Of the model, with derivatives or without
    converged: bool  # Whether a further step would gain less than asked


def settle(problem: LeastSquares, start: Floats, loss: Loss, *, unit: float, gain: float, most: int) -> Settled | None:
    """Improve a start until a step would gain next to nothing (Levenberg 1944, Marquardt 1963).

    An optimum of undetermined unknowns is a valley, along which a method that asks for a vanishing gradient walks for
    long and gains nothing. These steps end by what they would gain.
    """
    here, damping, used = np.array(start, dtype=np.float64), _DAMPING, 1
    residuals, jacobian = problem.linearised(here)
    if not (np.isfinite(residuals).all() and np.isfinite(jacobian).all()):
        return None
    value = 2 * loss.value(residuals)
    while True:
        step, expected = _step(problem, here, residuals, jacobian, loss, damping * unit)
        if expected < gain * unit:
            return Settled(here, value, used, True)
        if used >= most or damping > _MAX_DAMPING:
            return Settled(here, value, used, False)
        ahead = np.clip(here + step, problem.lower, problem.upper)
        tried, used = problem.residuals(ahead), used + 1
        lower = 2 * loss.value(tried) if np.isfinite(tried).all() else np.inf
        if lower >= value:
            damping *= _MORE
            continue
        found, slopes = problem.linearised(ahead)
        used += 1
        if not np.isfinite(slopes).all():
            return Settled(here, value, used, False)
        here, residuals, jacobian, value = ahead, found, slopes, 2 * loss.value(found)
        damping = max(damping * _LESS, _MIN_DAMPING)


def _step(
    problem: LeastSquares, q: Floats, residuals: Floats, jacobian: Floats, loss: Loss, damping: float
) -> tuple[Floats, float]:
    """A damped step inside the box, and by how much twice the loss would fall to first order."""
    gradient = jacobian.T @ (loss.weights(residuals) * residuals)
    hessian = jacobian.T @ (loss.curvatures(residuals)[:, None] * jacobian)
    low = q - problem.lower < problem.upper - q
    free = ~(on_bound(problem, q) & np.where(low, gradient > 0, gradient < 0))
    step = np.zeros(q.size)
    while free.any():
        # What is not free has its step, as far as its bound.
        pull = gradient[free] + hessian[np.ix_(free, ~free)] @ step[~free]
        step[free] = -np.linalg.solve(hessian[np.ix_(free, free)] + damping * np.eye(int(free.sum())), pull)
        inside = np.clip(q + step, problem.lower, problem.upper) - q
        beyond = free & (inside != step) & (np.abs(inside - step) > 1e-12 * np.abs(step))
        step = inside
        if not beyond.any():
            break
        free &= ~beyond
    return step, float(-2 * gradient @ step - step @ hessian @ step)


SUCCESS = ("Solve_Succeeded", "Solved_To_Acceptable_Level")
"""What IPOPT says of a problem that it has solved."""

# Per kind of callback: names of its inputs and outputs, as CasADi's nlpsol expects them.
_INPUTS = {"value": ("x",), "gradient": ("x", "p"), "hessian": ("x", "p", "lam_f", "lam_g")}
_OUTPUTS = {"value": ("f",), "gradient": ("f", "grad_f_x"), "hessian": ("triu_hess_gamma_x_x",)}


@dataclass(frozen=True, eq=False)
class Run:
    """How one run of IPOPT ended.

    Attributes
    ----------
    q : ndarray, shape (k,)
        Its last point.
    status : str
        Its own word, or that of the model that stopped it.
    iterations : int
        Of its own.
    """

    q: Floats
    status: str
    iterations: int

    @property
    def success(self) -> bool:
        """Whether the word is one of success."""
        return self.status in SUCCESS


def run(model: Model, start: Floats, units: Floats, scale: float, options: Mapping[str, object]) -> Run:
    """Let IPOPT minimise scale * value in x = (q - start)/units, within the box."""
    shared = _Shared(model, start, units, scale)
    value, gradient, hessian = (_Callback(shared, kind) for kind in _INPUTS)
    x = ca.MX.sym("x", start.size)
    # The model is not asked outside the box, and its units are those of the caller.
    own = {"print_level": 0, "sb": "yes", "bound_relax_factor": 0.0, "nlp_scaling_method": "none", **options}
    settings: dict[str, Any] = {
        "grad_f": gradient,
        "hess_lag": hessian,
        "print_time": False,
        "show_eval_warnings": False,
        "error_on_fail": False,
        "calc_lam_p": False,
        "no_nlp_grad": True,
        "ipopt": own,
    }
    solver = ca.nlpsol("fit", "ipopt", {"x": x, "f": value(x)}, settings)
    lower, upper = (model.problem.lower - start) / units, (model.problem.upper - start) / units
    try:
        solution = solver(x0=np.zeros(start.size), lbx=lower, ubx=upper)
    except (RuntimeError, KeyboardInterrupt):
        # CasADi wraps what a callback raised.
        if shared.raised is not None:
            raise shared.raised from None
        raise
    if shared.raised is not None:
        raise shared.raised
    stats = solver.stats()
    return Run(shared.q(solution["x"]), model.stopped or str(stats["return_status"]), int(stats["iter_count"]))


class _Shared:
    """What the three callbacks have in common."""

    def __init__(self, model: Model, start: Floats, units: Floats, scale: float) -> None:
        self.model = model
        self.start = start
        self.units = units
        self.scale = scale
        self.raised: BaseException | None = None

    def q(self, x: ca.DM) -> Floats:
        """Unknowns of the problem; rounding may not take them out of the box."""
        q = self.start + self.units * np.asarray(x, dtype=np.float64).ravel()
        clipped: Floats = np.clip(q, self.model.problem.lower, self.model.problem.upper)
        return clipped

    def outputs(self, kind: str, arguments: Sequence[ca.DM]) -> list[ca.DM]:
        """What a callback returns; raises what the model raises."""
        point = self.model.at(self.q(arguments[0]))
        if kind == "hessian":
            curved = np.outer(self.units, self.units) * self.model.hessian(point)
            return [ca.triu(ca.DM(self.scale * float(arguments[2]) * curved))]
        value = ca.DM(self.scale * point.value)
        return [value] if kind == "value" else [value, ca.DM(self.scale * self.units * self.model.gradient(point))]


class _Callback(ca.Callback):
    """Value, gradient or Hessian as CasADi calls it."""

    def __init__(self, shared: _Shared, kind: str) -> None:
        ca.Callback.__init__(self)
        self._shared = shared
        self._kind = kind
        self.construct(f"model_{kind}", {})

    def get_n_in(self) -> int:
        return len(_INPUTS[self._kind])

    def get_n_out(self) -> int:
        return len(_OUTPUTS[self._kind])

    def get_name_in(self, k: int) -> str:
        return _INPUTS[self._kind][k]

    def get_name_out(self, k: int) -> str:
        return _OUTPUTS[self._kind][k]

    def get_sparsity_in(self, k: int) -> ca.Sparsity:
        unknowns = self._shared.start.size
        shapes = {"x": (unknowns, 1), "p": (0, 0), "lam_f": (1, 1), "lam_g": (0, 0)}
        return ca.Sparsity.dense(*shapes[_INPUTS[self._kind][k]])

    def get_sparsity_out(self, k: int) -> ca.Sparsity:
        unknowns = self._shared.start.size
        if self._kind == "hessian":
            return ca.Sparsity.upper(unknowns)
        return ca.Sparsity.dense(1 if k == 0 else unknowns, 1)

    def eval(self, arguments: Sequence[ca.DM]) -> list[ca.DM]:
        shared = self._shared
        if shared.raised is None and shared.model.stopped is None:
            try:
                return shared.outputs(self._kind, arguments)
            except BaseException as error:  # noqa: BLE001 - CasADi would swallow it; the caller of IPOPT raises it
                shared.raised = error
        # IPOPT steps back from what is not a number, and soon gives up when nothing else comes.
        return [ca.DM(self.get_sparsity_out(k), np.nan) for k in range(self.get_n_out())]


# Of the first value: less is rounding, in which a further run would lose its way.
_ROUNDING = 1e-18
_ROUNDS = 3


@dataclass(frozen=True, eq=False)
class Optimum:
    """Where the optimisation ended; the best point seen, if IPOPT failed."""

    q: Floats  # shape (k,); The unknowns
    value: float  # 1/2 sum rho(r^2)
    residuals: Floats  # shape (m,); At `q`, before the loss
    jacobian: Floats  # shape (m, k); Their derivatives
    iterations: int  # Of IPOPT; of the model with derivatives
    evaluations: int
    # IPOPT's own word for how it ended; or that it was stopped, because the noise of the model's own arithmetic left
    # nothing to gain around an optimum that is reached as far as the data can tell, or after too many evaluations.
    status: str
    converged: bool  # Whether IPOPT ended with success, or was stopped for the first of these reasons
    at_bound: NDArray[np.bool_]  # shape (k,); Which unknowns lie on a bound
    # Norm of that part of the residuals that a step of the unknowns inside the box would remove to first order, over
    # the root mean square residual (Bates and Watts 1981): the distance from the optimum in standard errors. Means
    # nothing where the data are met to rounding.
    offset: float


@dataclass(frozen=True)
class DerivativeCheck:
    """What IPOPT's first-order derivative checker found."""

    clean: bool  # Whether it found no error
    text: str  # What it wrote


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
    """Compare the gradient with differences of the value, by IPOPT's own derivative checker."""
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


# Two fits whose residuals differ by less than this share of a standard deviation are one fit.
_SAME = 0.1
# Of the residuals of the starts: less is rounding.
_SAME_OPTIMUM = 1e-6


@dataclass(frozen=True, eq=False)
class Fall:
    """Where one start ended."""

    start: Floats  # shape (k,); Where it started
    optimum: Optimum  # Where it ended
    # Which fit that is, 0 the best: starts that end in the same curve through the data share it, even where their
    # unknowns differ because the data do not determine them.
    cluster: int


@dataclass(frozen=True, eq=False)
class Waterfall:
    """All starts, the best first."""

    falls: tuple[Fall, ...]  # Sorted by value, those that converged first
    rejected: int  # Starts at which the model has no answer

    @property
    def best(self) -> Optimum:
        """The least optimum."""
        return self.falls[0].optimum

    @property
    def values(self) -> Floats:
        """Values of the optima, shape (starts,), in the order of `falls`."""
        return np.array([fall.optimum.value for fall in self.falls])

    @property
    def reached_best(self) -> int:
        """How many starts end in the best fit: one of many is a warning."""
        return sum(fall.cluster == 0 for fall in self.falls)

    def spread(self, cluster: int = 0) -> Floats:
        """Largest difference of each unknown within a cluster, shape (k,): large where the data do not determine it."""
        spread: Floats = np.ptp([fall.optimum.q for fall in self.falls if fall.cluster == cluster], axis=0)
        return spread


_MAX_OF_DRAWN = 60
_NEARER = "bounds or starting values for which it can be solved"


def latin_hypercube(lower: Floats, upper: Floats, count: int, seed: int) -> Floats:
    """Points of which each unknown has one in each of `count` equal slices of its range (McKay et al. 1979)."""
    random = np.random.default_rng(seed)
    slices = np.stack([random.permutation(count) for _ in lower], axis=1)
    points: Floats = lower + (upper - lower) * (slices + random.random((count, lower.size))) / max(count, 1)
    return points


def multi_start(
    problem: LeastSquares,
    given: Sequence[Floats],
    *,
    count: int = 0,
    seed: int = 0,
    loss: Loss = LINEAR,
    max_evaluations: int = 300,
    told: Callable[[int, int], None] | None = None,
) -> Waterfall:
    """Minimise from the given starts and from a Latin hypercube of the box."""
    drawn = latin_hypercube(problem.lower, problem.upper, count, seed)
    starts = [*(check_in_box(problem, one) for one in given), *drawn]
    ended, sizes = [], []
    for number, start in enumerate(starts):
        (told or _nobody)(number, len(starts))
        if not has_answer(problem, start):
            continue  # a hypercube has many corners that no filament survives
        sizes.append(float(np.linalg.norm(problem.residuals(start))))
        most = max_evaluations if number < len(given) else min(max_evaluations, _MAX_OF_DRAWN)
        ended.append((start, minimise(problem, start, loss=loss, max_evaluations=most)))
    if not ended:
        raise SoftcatError(f"the model has no answer at any of {len(starts)} starts; accepted: {_NEARER}")
    ended.sort(key=lambda one: (not one[1].converged, one[1].value))
    clusters = _clusters([one.residuals for _, one in ended], _SAME_OPTIMUM * max(sizes))
    falls = (Fall(start, one, cluster) for (start, one), cluster in zip(ended, clusters, strict=True))
    return Waterfall(tuple(falls), len(starts) - len(ended))


def _nobody(done: int, total: int) -> None:
    """Tell nobody."""


def _clusters(residuals: Sequence[Floats], rounding: float) -> list[int]:
    """Number fits by the first one in the list that agrees with them."""
    near = max(_SAME * float(np.sqrt(np.mean(residuals[0] ** 2))), rounding)
    leaders: list[Floats] = []
    numbers = []
    for one in residuals:
        found = next((k for k, leader in enumerate(leaders) if np.linalg.norm(one - leader) < near), None)
        if found is None:
            found = len(leaders)
            leaders.append(one)
        numbers.append(found)
    return numbers
