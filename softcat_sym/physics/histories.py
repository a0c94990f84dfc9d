"""Quantities that change in time as expressions of t, in symbols for their numbers: no number stands in the graph."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from softcat_sym.physics.laws import OPERATIONS, Constant
from softcat_sym.physics.symbols import t
from softcat_sym.scene.formula import Formula
from softcat_sym.scene.history import TIME_NAME, History


@dataclass(frozen=True, slots=True)
class Varying:
    """An expression of the time, its rate, and the symbols of its numbers."""

    value: sp.Expr
    rate: sp.Expr
    constants: tuple[Constant, ...]  # By the names that `named_numbers` of the scene gives their values


def varying(history: History, name: str) -> Varying:
    """What a history is in symbols.

    Parameters
    ----------
    history : History
        Of a constant.
    name : str
        What its numbers are named by, such as ``yield_stress``.

    Returns
    -------
    Varying
        The same for every history of the same form: a table of so many times, or a formula of other quantities.
    """
    formula = history.formula
    return _of_table(name, len(history.table)) if formula is None else _of_formula(name, formula, len(history.numbers))


def _constants(name: str, count: int) -> tuple[Constant, ...]:
    return tuple(Constant(f"{name}_{k}", sp.Symbol(f"{name}_{k}", real=True)) for k in range(count))


@lru_cache(maxsize=64)
def _of_table(name: str, rows: int) -> Varying:
    """Monotone cubics between the rows, in Hermite's form; constant before and behind."""
    constants = _constants(name, 3 * rows)
    symbols = [one.symbol for one in constants]
    times, values, slopes = symbols[:rows], symbols[rows : 2 * rows], symbols[2 * rows :]
    pieces, rates = [(values[0], t < times[0])], [(sp.S.Zero, t < times[0])]
    for k in range(rows - 1):
        width, rise = times[k + 1] - times[k], values[k + 1] - values[k]
        u, first, last = (t - times[k]) / width, slopes[k], slopes[k + 1]
        cubic = rise * u**2 * (3 - 2 * u) + width * u * (1 - u) * (first * (1 - u) - last * u)
        slope = 6 * rise / width * u * (1 - u) + first * (1 - u) * (1 - 3 * u) - last * u * (2 - 3 * u)
        pieces.append((values[k] + cubic, t < times[k + 1]))
        rates.append((slope, t < times[k + 1]))
    return Varying(
        sp.Piecewise(*pieces, (values[-1], True), evaluate=False),
        sp.Piecewise(*rates, (sp.S.Zero, True), evaluate=False),
        constants,
    )


@lru_cache(maxsize=64)
def _of_formula(name: str, formula: Formula, count: int) -> Varying:
    constants = _constants(name, count)
    symbols = {TIME_NAME: t, **{f"quantity_{k}": one.symbol for k, one in enumerate(constants)}}
    value = formula.fold(_number, symbols.__getitem__, lambda operation, values: OPERATIONS[operation](*values))
    # Cases instead of functions whose slope would have a jump in it.
    rate = sp.diff(value.rewrite([sp.Min, sp.Max, sp.Abs, sp.sign], sp.Piecewise), t)
    return Varying(value, rate, constants)


def _number(value: float) -> sp.Expr:
    return sp.Integer(int(value)) if value.is_integer() else sp.Float(value, 17)
