"""Quantities that change in time as expressions of t, in symbols for their numbers: no number stands in the graph."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from softcat_sym.physics import symbols as sy
from softcat_sym.physics.constitutive_laws import SYMBOLS, Constant, Law, expression_of, growth_of
from softcat_sym.physics.symbols import t
from softcat_sym.physics.terms import Course
from softcat_sym.physics.time_dependent_constants import Clock
from softcat_sym.scene.formula import Formula, parse_formula
from softcat_sym.scene.history import TIME_NAME


@dataclass(frozen=True, slots=True)
class Varying:
    """An expression of the time, its rate, and the symbols of its numbers."""

    value: sp.Expr
    rate: sp.Expr
    constants: tuple[Constant, ...]  # By the names that `named_numbers` of the scene gives their values


def varying(course: Course) -> Varying:
    """What a quantity of this form is in symbols: of a table of times, or a formula of other quantities."""
    if not course.formula:
        return _of_table(course.name, course.rows)
    return _of_formula(course.name, parse_formula(course.formula), course.numbers)


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
    value = expression_of(formula, symbols.__getitem__)
    # Cases instead of functions whose slope would have a jump in it.
    rate = sp.diff(value.rewrite([sp.Min, sp.Max, sp.Abs, sp.sign], sp.Piecewise), t)
    return Varying(value, rate, constants)


def curing_clock(courses: tuple[Course, ...], law: Law) -> Clock:
    """Constants of the material that change in time; a modulus that grows does so by springs without stress."""
    replaces, constants, grows = list[tuple[sp.Symbol, sp.Expr]](), list[Constant](), []
    symbols = SYMBOLS | {one.name: one.symbol for one in law.constants}
    moduli = {branch.modulus for branch in law.branches}
    for course in courses:
        symbol, found = symbols[course.name], varying(course)
        replaces.append((symbol, found.value))
        constants += found.constants
        if symbol in moduli:
            growth = growth_of(symbol)
            replaces.append((growth, sp.Max(found.rate, 0) / found.value))
            grows.append((symbol, growth))
    return Clock("curing", tuple(replaces), tuple(constants), tuple(grows))


# Of the strain at the top less that at the bottom the top has half, beyond the mean.
_STRAINS = (("natural_strain", sy.n_0, sy.n_0_t, 1), ("natural_strain_difference", sy.n_1, sy.n_1_t, sp.Rational(1, 2)))


def natural_clock(courses: tuple[Course, ...]) -> Clock:
    """Strains without stress that change in time."""
    given = {course.name: varying(course) for course in courses}
    replaces, constants = list[tuple[sp.Symbol, sp.Expr]](), list[Constant]()
    for name, strain, rate, share in _STRAINS:
        if name in given:
            replaces += [(strain, share * given[name].value), (rate, share * given[name].rate)]
            constants += given[name].constants
        else:
            replaces += [(strain, sp.S.Zero), (rate, sp.S.Zero)]
    return Clock("natural-strain", tuple(replaces), tuple(constants))
