"""An equation of the theory as data: written as text and LaTeX, collected, checked for its dimensions."""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.printing.latex import LatexPrinter
from sympy.printing.str import StrPrinter

import softcat_sym.physics
from softcat_sym.physics.symbols import entry, field_entry, table


@dataclass(frozen=True, slots=True)
class Equation:
    """Two sides, left = right, in the symbols of :mod:`softcat_sym.physics.symbols`."""

    name: str  # In words
    left: sp.Expr  # Both sides; every term of them has one dimension
    right: sp.Expr
    source: str  # Equation numbers of the paper, or section of the theory

    def residual(self) -> sp.Expr:
        """Left side minus right side, zero where the equation holds."""
        return self.left - self.right


class Equations(Sequence[Equation]):
    """Equations that are derived when first looked at: SymPy takes its time, and a run needs none of them."""

    def __init__(self, derive: Callable[[], Iterable[Equation]]) -> None:
        self._derive = derive

    @cached_property
    def _all(self) -> tuple[Equation, ...]:
        return tuple(self._derive())

    def __getitem__(self, at: Any) -> Any:
        return self._all[at]

    def __len__(self) -> int:
        return len(self._all)


class Mean(sp.Function):  # type: ignore[misc]  # SymPy has no types
    """<f>, the mean over the section, to be shown and not evaluated."""


class Rate(sp.Function):  # type: ignore[misc]
    """Derivative of a symbol by one coordinate, so many times over, to be shown and not evaluated."""


class _Text(StrPrinter):  # type: ignore[misc]
    """As one would type it."""

    def _print_Mean(self, expr: sp.Expr) -> str:
        return f"<{self._print(expr.args[0])}>"

    def _print_Rate(self, expr: sp.Expr) -> str:
        of, by, order = expr.args
        inner = self._print(of)
        body = inner if of.is_Symbol else f"({inner})"
        times = "" if order == 1 else str(order)
        return f"d{times}{body}/d{self._print(by)}{times}" if of.is_Symbol else f"d/d{self._print(by)} {body}"

    def _print_Piecewise(self, expr: sp.Expr) -> str:
        cases = [(self._print(value), condition) for value, condition in expr.args]
        return "; ".join(
            f"{value} otherwise" if on == sp.true else f"{value} if {self._print(on)}" for value, on in cases
        )

    def _print_Integral(self, expr: sp.Expr) -> str:
        place, low, high = expr.limits[0]
        return f"integral of {self._print(expr.function)} d{place} from {self._print(low)} to {self._print(high)}"


class _Latex(LatexPrinter):  # type: ignore[misc]
    """With the symbols of the table."""

    def _print_Mean(self, expr: sp.Expr) -> str:
        return rf"\left\langle {self._print(expr.args[0])} \right\rangle"

    def _print_Rate(self, expr: sp.Expr) -> str:
        of, by, order = expr.args
        power = "" if order == 1 else f"^{{{order}}}"
        below = rf"\partial {self._print(by)}{power}"
        if of.is_Symbol:
            return rf"\frac{{\partial{power} {self._print(of)}}}{{{below}}}"
        return rf"\frac{{\partial{power}}}{{{below}}} \left( {self._print(of)} \right)"


@dataclass(frozen=True, slots=True)
class Stated:
    """One equation, to be read."""

    name: str  # In words
    source: str  # Equation numbers of the paper, or author and year
    text: str  # The equation as a line of text, and as LaTeX for a display
    latex: str


def stated(name: str, left: sp.Expr, right: sp.Expr, source: str) -> Stated:
    """Write an equation out."""
    names = {row.symbol: row.latex for row in table()}
    free = (left.free_symbols | right.free_symbols) - names.keys()
    # A user's own constants are named custom_<name> inside.
    own = {found: rf"\mathrm{{{_spelled(found.name)}}}" for found in free}
    plain = {found: sp.Symbol(found.name.removeprefix("custom_")) for found in free}
    printer = _Latex({"symbol_names": names | own, "mul_symbol": r"\,"})
    text = f"{_text(left.xreplace(plain))} = {_text(right.xreplace(plain))}"
    return Stated(name, source, text, f"{printer.doprint(left)} = {printer.doprint(right)}")


def _text(expression: sp.Expr) -> str:
    return str(_Text({"abbrev": False}).doprint(expression)).replace("**", "^")


def _spelled(name: str) -> str:
    return name.removeprefix("custom_").replace("_", r"\_")


def all_equations() -> dict[str, Sequence[Equation]]:
    """The ``EQUATIONS`` and ``..._EQUATIONS`` of every module of :mod:`softcat_sym.physics`, by module and name.

    Importing them all also completes the table of symbols.
    """
    found: dict[str, Sequence[Equation]] = {}
    for info in pkgutil.iter_modules(softcat_sym.physics.__path__):
        module = importlib.import_module(f"{softcat_sym.physics.__name__}.{info.name}")
        for name, equations in vars(module).items():
            if name.endswith("EQUATIONS"):
                found[f"{info.name}.{name}"] = equations
    return found


Exponents = tuple[Fraction | sp.Expr, ...]
"""Exponents of (kg, m, s): numbers, or expressions in a material constant, as the n in the Pa s^n of a consistency."""

PURE: Exponents = (Fraction(0),) * 3
_OF_PURE = (
    sp.log,
    sp.exp,
    sp.sin,
    sp.cos,
    sp.tan,
    sp.acos,
    sp.asin,
    sp.atan,
    sp.sinh,
    sp.cosh,
    sp.tanh,
    sp.asinh,
    sp.acosh,
)
_SAME = (sp.Add, sp.Max, sp.Min, Relational)


class DimensionError(ValueError):
    """Terms that cannot be added, or a function of something that has a dimension: the equation is wrong."""


def dimension(expr: sp.Basic) -> Exponents | None:  # noqa: C901 - one branch a kind of node
    """Exponents of (kg, m, s) of an expression; None for zero, which agrees with anything."""
    if expr == 0:
        return None
    if isinstance(expr, sp.Symbol):
        return tuple(map(_exact, entry(expr).dimension))
    if expr.is_number:
        return PURE
    if isinstance(expr, sp.Mul):
        return _product([dimension(a) for a in expr.args])
    if isinstance(expr, sp.Pow):
        return _power(*expr.args)
    if isinstance(expr, sp.Piecewise):
        return _branches(expr)
    if isinstance(expr, sp.Derivative | sp.Integral | AppliedUndef | sp.Subs):
        return _of_field(expr)
    inner = [dimension(a) for a in expr.args]
    if isinstance(expr, _SAME):
        return _agree(expr, inner)
    if isinstance(expr, sp.atan2):
        _agree(expr, inner)
        return PURE
    if isinstance(expr, sp.Abs):
        return inner[0]
    if isinstance(expr, sp.sign | sp.Heaviside | sp.Or | sp.And):
        return PURE
    if isinstance(expr, _OF_PURE):
        _agree(expr, [*inner, PURE])
        return PURE
    raise DimensionError(f"no rule for {type(expr).__name__}")


def check(equation: Equation) -> Exponents | None:
    """The dimension that both sides of an equation share."""
    return _agree(equation.residual(), [dimension(sp.expand(side)) for side in (equation.left, equation.right)])


def _of_field(expr: sp.Basic) -> Exponents | None:
    if isinstance(expr, AppliedUndef):
        return tuple(map(Fraction, field_entry(expr.func.__name__).dimension))
    if isinstance(expr, sp.Subs):
        return dimension(expr.expr)
    inner = dimension(expr.expr) if isinstance(expr, sp.Derivative) else dimension(expr.function)
    if inner is None:
        return None
    sign = -1 if isinstance(expr, sp.Derivative) else 1
    counts = expr.variable_count if isinstance(expr, sp.Derivative) else [(limit[0], 1) for limit in expr.limits]
    for variable, count in counts:
        step = dimension(variable) or PURE
        inner = tuple(a + sign * int(count) * b for a, b in zip(inner, step, strict=True))
    return inner


def _branches(expr: sp.Piecewise) -> Exponents | None:
    for _, condition in expr.args:
        if condition != sp.true:
            dimension(condition)
    return _agree(expr, [dimension(branch) for branch, _ in expr.args])


def _product(parts: list[Exponents | None]) -> Exponents | None:
    known = [part for part in parts if part is not None]
    if len(known) < len(parts):
        return None
    return tuple(_exact(sum(column, Fraction(0))) for column in zip(*known, strict=True))


def _power(base: sp.Expr, exponent: sp.Expr) -> Exponents | None:
    inner = dimension(base)
    if not exponent.is_Rational:
        _agree(base**exponent, [dimension(exponent), PURE])
        return PURE if inner is None else tuple(_exact(exponent * part) for part in inner)
    return None if inner is None else tuple(_exact(Fraction(exponent.p, exponent.q) * part) for part in inner)


def _exact(exponent: int | Fraction | sp.Expr) -> Fraction | sp.Expr:
    """An exponent in the one form in which equal ones are the same."""
    if not isinstance(exponent, sp.Basic):
        return Fraction(exponent)
    settled = sp.cancel(exponent)
    return Fraction(int(settled.p), int(settled.q)) if settled.is_Rational else settled


def _agree(expr: sp.Basic, parts: list[Exponents | None]) -> Exponents | None:
    known = {part for part in parts if part is not None}
    if len(known) > 1:
        raise DimensionError(f"{sorted(known, key=str)} in {expr}")
    return known.pop() if known else None
