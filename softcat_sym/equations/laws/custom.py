"""A flow rule of one's own: a formula phi(sigma) with named parameters becomes a law like any other."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol, TypeVar

import sympy as sp

from softcat_sym.equations.law import Branch, Constant, Flow, Law
from softcat_sym.equations.symbols import sigma, sigma_Y

Folded = TypeVar("Folded")


class Formula(Protocol):
    """A parsed formula, of which nothing is asked but to be built up again from its leaves."""

    def fold(
        self,
        number: Callable[[float], Folded],
        name: Callable[[str], Folded],
        operation: Callable[[str, Sequence[Folded]], Folded],
    ) -> Folded:
        """Value of the formula, given what a number, a name and an operation on values are."""
        ...


def _asinh(size: sp.Expr) -> sp.Expr:
    """By its logarithm, for size >= 0: of a negative one the sum would lose its digits."""
    return sp.log(size + sp.sqrt(size**2 + 1))


OPERATIONS: dict[str, Callable[..., sp.Expr]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "pow": lambda a, b: a**b,
    "neg": lambda a: -a,
    "exp": sp.exp,
    "log": sp.log,
    "sqrt": sp.sqrt,
    "sinh": sp.sinh,
    "cosh": sp.cosh,
    "tanh": sp.tanh,
    "asinh": lambda a: sp.Piecewise((_asinh(a), a >= 0), (-_asinh(-a), True)),
    "atan": sp.atan,
    "sin": sp.sin,
    "cos": sp.cos,
    "abs": sp.Abs,
    "sign": sp.sign,
    "min": sp.Min,
    "max": sp.Max,
}


def custom_law(formula: Formula, *, yields: bool) -> Law:
    """The law whose plastic strain rate is a formula in ``sigma`` and parameters.

    Parameters
    ----------
    formula : Formula
        phi(sigma) [1/s], odd and nowhere decreasing; every name in it but ``sigma`` is a constant of the law.
    yields : bool
        Whether it is zero up to a stress, which the law then has as its yield stress. The rule knows its threshold by
        itself: it is the same with yielding and without.

    Raises
    ------
    ValueError
        If the formula asks for an operation that is not among :data:`OPERATIONS`.
    """
    constants: dict[str, sp.Symbol] = {}

    def named(name: str) -> sp.Expr:
        if name == sigma.name:
            return sigma
        # The prefix keeps a user's "s" or "eta" apart from the theory's.
        return constants.setdefault(name, sp.Symbol(f"custom_{name}", real=True))

    rate = formula.fold(_number, named, _operation)
    flow = Flow(rate, sigma_Y if yields else sp.S.Zero)
    branch = Branch(flow=flow, flow_beyond_yield=flow if yields else None)
    return Law(
        "custom", branches=(branch,), constants=tuple(Constant(name, symbol) for name, symbol in constants.items())
    )


def _number(value: float) -> sp.Expr:
    """A whole number as it is, so that x^2 stays a product; any other to all its digits."""
    return sp.Integer(int(value)) if float(value).is_integer() else sp.Float(value, 17)


def _operation(name: str, values: Sequence[sp.Expr]) -> sp.Expr:
    if name not in OPERATIONS:
        raise ValueError(f"no operation {name}: there are {', '.join(sorted(OPERATIONS))}")
    return OPERATIONS[name](*values)
