"""Clocks of a material: constants of its law that change in time or with its structure, in symbols for all numbers.

A structure is one parameter at every point, which rest builds up and flow destroys: d lambda/dt = (1 - lambda - lambda
(tau |rate|)^c)/t_b (Moore 1959, with the power of de Souza Mendes & Thompson 2013); yield stress and viscosity are
linear in lambda (Houska 1981). Without a limit, d lambda/dt = (1 - lambda (tau |rate|)^c)/t_b (Roussel 2006). The state
is how far lambda has come from where it starts.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from functools import lru_cache

import sympy as sp

from softcat_sym.physics import symbols as sy
from softcat_sym.physics.constitutive_laws import SYMBOLS, Constant, Law, expression_of, growth_of
from softcat_sym.physics.symbols import ONE, RATE, STRESS, TIME, VISCOSITY, enter, eta, sigma_Y, t
from softcat_sym.physics.terms import Course
from softcat_sym.scene.formula import Formula, parse_formula
from softcat_sym.scene.history import TIME_NAME


@dataclass(frozen=True, slots=True)
class State:
    """What a clock follows at every point of a section; nothing at the start."""

    name: str  # Of what a run stores of it, its mean over the section
    symbol: sp.Symbol  # Change since the start
    shown: sp.Symbol  # What it is a change of, and that in terms of the change
    value: sp.Expr
    rate: sp.Expr  # [1/s], of the flow there


@dataclass(frozen=True, slots=True)
class Clock:
    """What an effect makes of constants of the material."""

    name: str  # Of its effect
    # Constants of the law, and what stands for them: of ``t``, the clock's own constants, and them as the scene states.
    replaces: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    constants: tuple[Constant, ...] = ()  # Its own
    # Moduli that springs without stress join, and what stands for the rate of that over the modulus.
    grows: tuple[tuple[sp.Symbol, sp.Symbol], ...] = ()
    state: State | None = None  # Of every point of a section, on which what it replaces depends


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


_MOORE, _ROUSSEL = "Moore 1959; de Souza Mendes & Thompson 2013", "Roussel 2006"

lam = enter("lambda", r"\lambda", ONE, "structure parameter of a fibre: 0 destroyed, 1 built up", _MOORE)
change = enter("Delta_lambda", r"\Delta\lambda", ONE, "change of the structure parameter since the start", _MOORE)
speed = enter("flow_rate", r"|\dot\epsilon^p|", RATE, "equivalent plastic strain rate of a fibre", "2.7")

t_b = enter("t_b", "t_b", TIME, "time in which structure builds up at rest", _MOORE, positive=True)
tau_b = enter("tau_b", r"\tau_b", TIME, "time that compares flow with build-up", _MOORE)
exponent = enter("c_b", "c_b", ONE, "power of the rate in the breakdown", _MOORE, positive=True)
rest = enter("t_rest", r"t_{rest}", TIME, "time at rest before the start", _ROUSSEL)
initial = enter("lambda_i", r"\lambda_i", ONE, "structure parameter for which the constants are stated", _MOORE)
yield_ends = (
    enter("sigma_Ys", r"\sigma_{Ys}", STRESS, "yield stress of the built-up material", "Houska 1981"),
    enter("sigma_Yd", r"\sigma_{Yd}", STRESS, "yield stress of the destroyed material", "Houska 1981"),
)
viscosity_ends = (
    enter("eta_s_b", r"\eta_{s}", VISCOSITY, "viscosity of the built-up material", "Houska 1981"),
    enter("eta_d_b", r"\eta_{d}", VISCOSITY, "viscosity of the destroyed material", "Houska 1981"),
)

_SYMBOLS = {
    "build_up_time": t_b,
    "breakdown_time": tau_b,
    "exponent": exponent,
    "rest": rest,
    "initial": initial,
    "structured_yield_stress": yield_ends[0],
    "destroyed_yield_stress": yield_ends[1],
    "structured_viscosity": viscosity_ends[0],
    "destroyed_viscosity": viscosity_ends[1],
}

_SLOW = sp.Rational(1, 10**8)
"""Of tau |rate|: below it the power is rounded, whose slope may be infinite at rest."""


def breakdown() -> sp.Expr:
    """(tau |rate|)^c, with a finite slope at rest."""
    relative = tau_b * speed
    return relative**2 * (relative**2 + _SLOW**2) ** (exponent / 2 - 1)


def build_up_rate(*, linear: bool) -> sp.Expr:
    """The rate of lambda [1/s]."""
    return ((1 if linear else 1 - lam) - lam * breakdown()) / t_b


def rested(start: sp.Expr, *, linear: bool) -> sp.Expr:
    """Lambda after a rest that began at `start`."""
    return start + rest / t_b if linear else 1 - (1 - start) * sp.exp(-rest / t_b)


def structure_clock(given: Collection[str], *, linear: bool) -> Clock:
    """What the keys of ``[material.structure]`` that a scene gives make of its yield stress and viscosity."""
    high, low = (
        symbol if f"{end}_yield_stress" in given else sigma_Y
        for end, symbol in zip(("structured", "destroyed"), yield_ends, strict=True)
    )
    of_yield = high is not sigma_Y or low is not sigma_Y
    start = (sigma_Y - low) / (high - low) if of_yield else initial if "initial" in given else sp.S.Zero
    begin = rested(start, linear=linear) if "rest" in given else start
    since = begin - start + change
    replaces = []
    if of_yield:
        replaces.append((sigma_Y, sigma_Y + (high - low) * since))
    if "structured_viscosity" in given:
        replaces.append((eta, eta + (viscosity_ends[0] - eta) * since / (1 - start)))
    if "destroyed_viscosity" in given:
        replaces.append((eta, eta + (eta - viscosity_ends[1]) * since / start))
    state = State("structure", change, lam, begin + change, build_up_rate(linear=linear))
    names = [name for name in _SYMBOLS if name in given]
    constants = tuple(Constant(f"material_structure_{name}", _SYMBOLS[name]) for name in names)
    return Clock("structure", tuple(replaces), constants, state=state)
