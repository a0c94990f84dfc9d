"""Rates of a filament and their sparse Jacobian as Python functions, for integrators of others."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import numpy as np
from scipy.sparse import csc_matrix

from softcat_sym.codegen.right_hand_side import JACOBIAN
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import Fault, SceneError
from softcat_sym.solvers.interpreted import External
from softcat_sym.solvers.solution import Start

_STIFF = 1e9
"""Relaxation rate of algebraic unknowns towards the solution of their equation, in units of the time scale; for large
rates a stiffly accurate method solves that equation itself (Hairer & Wanner 1996, VI.1)."""


class Rates:
    """Rates of all unknowns, differential ones first, and their Jacobian, from the C of the filament."""

    def __init__(self, external: External, start: Start, p: Floats) -> None:
        jacobian = ca.external(JACOBIAN, str(external.library))
        self.start = np.concatenate([start.x, start.z])
        pace = np.zeros(0)
        if len(start.z):
            towards = np.asarray(ca.diag(jacobian(0, start.x, start.z, p)[5])).ravel()
            if np.any(towards == 0):
                fault = Fault("run.effects", "algebraic unknowns without an equation of their own", "others")
                raise SceneError([fault])
            pace = -_STIFF / towards
        t, y = ca.MX.sym("t"), ca.MX.sym("y", len(self.start))
        given = t, y[: len(start.x)], y[len(start.x) :], ca.DM(p)
        ode, alg = external.rhs(*given)
        _, ode_x, ode_z, _, alg_x, alg_z = jacobian(*given)
        scaled = ca.diag(ca.DM(pace))
        whole = ca.blockcat([[ode_x, ode_z], [scaled @ alg_x, scaled @ alg_z]])
        self.rates = _buffered(ca.Function("rates", [t, y], [ca.vertcat(ode, scaled @ alg)]))
        self._entries = _buffered(ca.Function("jacobian", [t, y], [whole]))
        self._pattern = whole.sparsity()

    def jacobian(self, t: float, state: Floats) -> Any:
        """The Jacobian as a ``scipy.sparse.csc_matrix``."""
        pattern = self._pattern
        return csc_matrix((self._entries(t, state), pattern.row(), pattern.colind()), shape=pattern.shape)


def _buffered(function: ca.Function) -> Callable[[float, Floats], Floats]:
    """Entries of a function of time and state; memory is shared with CasADi, so that a call costs its arithmetic."""
    buffer, evaluate = function.buffer()
    time, state, result = np.zeros(1), np.zeros(function.size1_in(1)), np.zeros(function.nnz_out(0))
    buffer.set_arg(0, memoryview(time.data))  # type: ignore[call-arg]
    buffer.set_arg(1, memoryview(state.data))  # type: ignore[call-arg]
    buffer.set_res(0, memoryview(result.data))  # type: ignore[call-arg]

    def entries(at: float, values: Floats) -> Floats:
        time[0], state[:] = at, values
        evaluate()
        if buffer.ret():
            raise ArithmeticError(f"{function.name()} of a filament: not defined at t = {at:g}")
        return result.copy()

    return entries
