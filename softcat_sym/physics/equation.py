"""An equation of the theory as data, and written as text and LaTeX."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.printing.latex import LatexPrinter
from sympy.printing.str import StrPrinter

from softcat_sym.physics.symbols import table


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
