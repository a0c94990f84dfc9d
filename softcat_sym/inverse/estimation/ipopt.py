"""IPOPT on a least-squares problem: callbacks that evaluate the model once a point and lose no exception."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.inverse.estimation.gauss_newton import Model
from softcat_sym.inverse.estimation.least_squares import Floats

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
    """Let IPOPT minimise scale * value in x = (q - start)/units, within the box.

    Parameters
    ----------
    model : Model
        The model.
    start : ndarray, shape (k,)
        Where it starts, in the box.
    units : ndarray, shape (k,)
        Of the unknowns.
    scale : float
        Of the value.
    options : mapping
        IPOPT's own, beside those that keep it quiet.

    Raises
    ------
    Exception
        What the model raises, KeyboardInterrupt included, as it was raised.
    """
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
