"""Numbers from SymPy expressions: the same printer, on NumPy arrays."""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np
import numpy.typing as npt
import sympy as sp

from softcat_sym.printing.casadi_printer import CellFunction

Floats = npt.NDArray[np.float64]


def evaluate(expression: sp.Expr, values: Mapping[sp.Symbol, float | Floats]) -> Floats:
    """Value of an expression, elementwise.

    Parameters
    ----------
    expression : sympy.Expr
        What to evaluate.
    values : mapping of sympy.Symbol to float or ndarray, shape (n,)
        One value for each symbol that occurs.

    Returns
    -------
    ndarray, shape (n,) or (1,)

    Raises
    ------
    PrintingError
        If a symbol has no value, or a function is outside the printer's whitelist.
    """
    function = CellFunction({"value": expression}, tuple(values))
    columns = {symbol: ca.DM(np.atleast_1d(np.asarray(value, dtype=float))) for symbol, value in values.items()}
    return np.asarray(ca.DM(function(columns)["value"]), dtype=float).ravel()
