"""A linear ordinary differential equation of any order, with coefficients that depend on time."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from softcat_sym.equations.symbols import Expr, Symbol
from softcat_sym.graph.grid import Floats
from softcat_sym.printing import CellFunction


def fundamental_solutions(coefficients: Sequence[Expr], time: Symbol, times: Floats) -> Floats:
    """Solutions of c_0 f^(n) + ... + c_(n-1) f' = 0 that start from each unit vector of (f, f', ..., f^(n-1)).

    Parameters
    ----------
    coefficients : sequence of sympy.Expr, length n
        Highest derivative first, that of f' last; functions of `time` alone.
    time : sympy.Symbol
        The variable.
    times : ndarray, shape (frames,)
        Where the solutions are wanted; they start at the first.

    Returns
    -------
    ndarray, shape (n, frames)
        f of each solution.
    """
    order = len(coefficients)
    t, state = ca.SX.sym("t"), ca.SX.sym("f", order)
    names = {f"c{k}": c for k, c in enumerate(coefficients)}
    c = CellFunction(names, (time,))({time: t})
    highest = -sum(c[f"c{k}"] * state[order - k] for k in range(1, order)) / c["c0"]
    dae = {"t": t, "x": state, "ode": ca.vertcat(state[1:], highest)}
    options = {"reltol": 1e-8, "abstol": 1e-12, "max_num_steps": 1_000_000}
    call = ca.integrator("linear", "rosenbrock", dae, float(times[0]), times.tolist(), options)
    return np.array([np.asarray(call(x0=start)["xf"], dtype=float)[0] for start in np.eye(order)])
