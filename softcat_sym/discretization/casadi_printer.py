"""SymPy to CasADi or NumPy: a whitelist of functions, exact numbers, and no symbol left unbound."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache, reduce
from typing import Any

import casadi as ca
import numpy as np
import numpy.typing as npt
import sympy as sp
from sympy.printing.printer import Printer

from softcat_sym.errors import PrintingError

_ELEMENTARY: dict[str, Callable[..., Any]] = {
    name: getattr(ca, name)
    for name in ("exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "sign")
} | {"Abs": ca.fabs}

_RELATIONS: dict[type, Callable[[Any, Any], Any]] = {
    sp.StrictGreaterThan: operator.gt,
    sp.GreaterThan: operator.ge,
    sp.StrictLessThan: operator.lt,
    sp.LessThan: operator.le,
    sp.Equality: operator.eq,
    sp.Unequality: operator.ne,
}


class CasadiPrinter(Printer):  # type: ignore[misc]  # SymPy has no types
    """Builds CasADi expressions from SymPy ones; symbols are looked up in `bindings`.

    Values may be scalars or column vectors (SX, MX, DM): every operation is elementwise, so one cell's expression,
    given vectors, is the expression of all cells.
    """

    def __init__(self, bindings: Mapping[sp.Symbol, Any]) -> None:
        super().__init__()
        self._bindings = dict(bindings)

    def bind(self, symbol: sp.Symbol, value: Any) -> None:
        """Give a symbol its value; common subexpressions are bound this way, one after the other."""
        self._bindings[symbol] = value

    def value(self, expr: sp.Expr) -> Any:
        """The CasADi value of an expression, under the present bindings."""
        return self._print(expr)

    def emptyPrinter(self, expr: sp.Basic) -> Any:
        """Refuse whatever has no rule below."""
        raise PrintingError(f"cannot print {type(expr).__name__} in {expr}: not in the whitelist of the CasADi printer")

    def _print_Symbol(self, expr: sp.Symbol) -> Any:
        try:
            return self._bindings[expr]
        except KeyError:
            raise PrintingError(f"symbol {expr} has no value; bound are {sorted(map(str, self._bindings))}") from None

    _print_Dummy = _print_Symbol

    def _print_Integer(self, expr: sp.Integer) -> float:
        return float(expr.p)

    def _print_Rational(self, expr: sp.Rational) -> float:
        return float(expr.p / expr.q)

    def _print_Float(self, expr: sp.Float) -> float:
        return float(expr)

    def _print_NumberSymbol(self, expr: sp.NumberSymbol) -> float:
        return float(expr.evalf(20))

    def _print_Add(self, expr: sp.Add) -> Any:
        return reduce(operator.add, map(self._print, expr.args))

    def _print_Mul(self, expr: sp.Mul) -> Any:
        # Factor by factor, numbers before vectors: what holds for all cells is then computed once and shared.
        return reduce(operator.mul, sorted(map(self._print, expr.args), key=_size))

    def _print_Pow(self, expr: sp.Pow) -> Any:
        base, exponent = expr.args
        if exponent.is_negative and exponent.is_Rational:
            return 1 / self._print(base**-exponent)
        if exponent.is_Integer and exponent.p <= 8:
            return _whole_power(self._print(base), exponent.p)
        if exponent.is_Rational and exponent.q == 2:
            value, whole = self._print(base), exponent.p // 2
            root = ca.sqrt(value)
            return root if whole == 0 else root * _whole_power(value, whole)
        return self._print(base) ** self._print(exponent)

    def _print_Function(self, expr: sp.Function) -> Any:
        name = type(expr).__name__
        if name not in _ELEMENTARY:
            raise PrintingError(f"function {name} in {expr} is not in the whitelist: {', '.join(sorted(_ELEMENTARY))}")
        return _ELEMENTARY[name](*(self._print(a) for a in expr.args))

    def _print_Max(self, expr: sp.Max) -> Any:
        return reduce(ca.fmax, map(self._print, sorted(expr.args, key=sp.default_sort_key)))

    def _print_Min(self, expr: sp.Min) -> Any:
        return reduce(ca.fmin, map(self._print, sorted(expr.args, key=sp.default_sort_key)))

    def _print_Relational(self, expr: sp.core.relational.Relational) -> Any:
        return _RELATIONS[type(expr)](self._print(expr.lhs), self._print(expr.rhs))

    def _print_Piecewise(self, expr: sp.Piecewise) -> Any:
        if expr.args[-1].cond != sp.true:
            raise PrintingError(f"{expr} says nothing about what remains: end it with (value, True)")
        value = self._print(expr.args[-1].expr)
        for branch, condition in reversed(expr.args[:-1]):
            value = ca.if_else(self._print(condition), self._print(branch), value)
        return value


def _size(value: Any) -> int:
    """Number of elements of a CasADi value, or of a plain number."""
    return int(value.numel()) if hasattr(value, "numel") else 0


def _whole_power(value: Any, exponent: int) -> Any:
    """Repeated squaring, so that x^2 and x^3 stay products."""
    if exponent == 1:
        return value
    half = _whole_power(value, exponent // 2)
    return half * half if exponent % 2 == 0 else half * half * value


_Shared = tuple[list[tuple[sp.Symbol, sp.Expr]], list[sp.Expr]]


@lru_cache(maxsize=1024)
def _common_parts(expressions: tuple[sp.Expr, ...]) -> _Shared:
    """Common subexpressions, sought once a process: a sweep prints the same cell again and again."""
    shared, reduced = sp.cse(list(expressions), symbols=sp.numbered_symbols("w_", cls=sp.Dummy))
    return shared, reduced


class CellFunction:
    """Several SymPy expressions of one cell, evaluated together on CasADi values with common parts shared."""

    def __init__(self, outputs: Mapping[str, sp.Expr], inputs: Sequence[sp.Symbol]) -> None:
        self.inputs = tuple(inputs)
        self.names = tuple(outputs)
        missing = set().union(*(sp.sympify(e).free_symbols for e in outputs.values())) - set(self.inputs)
        if missing:
            raise PrintingError(f"no input for {sorted(map(str, missing))} in {list(outputs)}")
        self._shared, self._reduced = _common_parts(tuple(sp.sympify(e) for e in outputs.values()))

    def __call__(self, values: Mapping[sp.Symbol, Any]) -> dict[str, Any]:
        """Evaluate on scalars or column vectors."""
        printer = CasadiPrinter({symbol: values[symbol] for symbol in self.inputs if symbol in values})
        for symbol, expression in self._shared:
            printer.bind(symbol, printer.value(expression))
        return {name: printer.value(e) for name, e in zip(self.names, self._reduced, strict=True)}


def printed(expression: sp.Expr, values: Mapping[sp.Symbol, Any]) -> ca.SX:
    """A SymPy expression as CasADi's, of what its symbols stand for."""
    needed = tuple(expression.free_symbols)
    return ca.SX(CellFunction({"value": expression}, needed)({symbol: values[symbol] for symbol in needed})["value"])


Floats = npt.NDArray[np.float64]


def evaluate(expression: sp.Expr, values: Mapping[sp.Symbol, float | Floats]) -> Floats:
    """Value of an expression, elementwise."""
    function = CellFunction({"value": expression}, tuple(values))
    columns = {symbol: ca.DM(np.atleast_1d(np.asarray(value, dtype=float))) for symbol, value in values.items()}
    return np.asarray(ca.DM(function(columns)["value"]), dtype=float).ravel()
