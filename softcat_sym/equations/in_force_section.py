"""Stress and flow of a section whose plastic strain is linear through its thickness, written out."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from softcat_sym.equations.closure import CLOSURES
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.equations.law import Branch, Flow
from softcat_sym.equations.laws.flow_rule import plastic_rate
from softcat_sym.equations.necking import s_slope
from softcat_sym.equations.section import NONE, Section
from softcat_sym.equations.section_response import PLANE_STRAIN, BranchResponse
from softcat_sym.equations.symbols import (
    A0,
    ONE,
    STRESS,
    E,
    X,
    a_0,
    a_1,
    enter,
    sigma,
    sigma_0,
    sigma_1,
    t,
    zeta,
)
from softcat_sym.equations.written import Mean, Rate, Stated, stated

Rename = dict[sp.Symbol, sp.Symbol]

_READABLE = 12
"""Operations up to which a mean in closed form is written as such."""


def stresses(equations: FilamentEquations) -> Iterator[Stated]:
    """The stress of every branch, of the viscous stress, and their sum."""
    terms, response = equations.terms, equations.response
    stretches, bends = terms.stretches, terms.bending
    several = len(response.parts) > 1
    for j, part in enumerate(response.parts):
        new, which = names(j, several=several), _which(equations, j)
        if stretches:
            yield stated(f"mean stress{which}", sigma_0.xreplace(new), part.stress_mean.xreplace(new), "2.8, 2.11")
        if bends:
            bending = part.stress_bending.xreplace(new)
            yield stated(f"bending stress at zeta = 1{which}", sigma_1.xreplace(new), bending, "2.8, 2.11")
    if several:
        for present, total in ((stretches, sigma_0), (bends, sigma_1)):
            if present:
                parts = [total.xreplace(names(j, several=True)) for j in range(len(response.parts))]
                yield stated("sum over the parts in parallel", total, sp.Add(*parts), "2.8")


def plastic_rates(equations: FilamentEquations) -> Iterator[Stated]:
    """The flow rule of every branch that flows, and the rates of its plastic states."""
    several = len(equations.response.parts) > 1
    for j, (branch, response) in enumerate(zip(equations.law.branches, equations.response.branches, strict=True)):
        if branch.flow is None:
            continue
        new, which = names(j, several=several), _which(equations, j)
        yield stated(
            f"flow rule of a fibre{which}", plastic_rate, shown_rate(branch.flow, equations.shape), "2.7, 2.25"
        )
        yield from _states(equations, branch, response, new, which)


def _states(
    equations: FilamentEquations, branch: Branch, response: BranchResponse, new: Rename, which: str
) -> Iterator[Stated]:
    flow, means, shape = branch.flow, response.means, equations.shape
    if flow is None or means is None:
        return
    terms = equations.terms
    contraction = shape.contraction if terms.thins else NONE
    closed = CLOSURES[equations.closure](terms.strain, contraction)
    # A mean in closed form is written as such where one can read it.
    at_once = sp.count_ops(means.rate) <= _READABLE and sp.count_ops(means.bending_rate) <= _READABLE
    if terms.bending and not at_once:
        through = (sigma_0 if terms.stretches else sp.Integer(0)) + sigma_1 * zeta
        yield stated(f"stress of the fibre zeta{which}", sigma, through.xreplace(new), "2.23")
    if terms.stretches:
        mean = _mean_of(flow, shape, bends=terms.bending) / closed.recall_mean
        rate = response.rate_mean if at_once else mean
        yield stated(f"axial flow{which}", Rate(a_0.xreplace(new), t, 1), rate.xreplace(new), "2.12, 2.24")
    if terms.bending:
        mean = Mean(plastic_rate * zeta) / (shape.zeta_squared * closed.recall_bending)
        rate = response.rate_bending if at_once else mean
        yield stated(f"bending flow{which}", Rate(a_1.xreplace(new), t, 1), rate.xreplace(new), "2.12, 2.24")


def _mean_of(flow: Flow, shape: Section, *, bends: bool) -> sp.Expr:
    """<eps_p_t>, or the rule itself of the only stress there is."""
    return Mean(plastic_rate) if bends else shown_rate(flow, shape).subs(sigma, sigma_0)


def shown_rate(flow: Flow, shape: Section) -> sp.Expr:
    """The flow rule of an axial stress.

    In a section too wide to change its width the equivalent stress is sqrt(3)/2 times the axial one, and so is the
    axial rate of the equivalent one.
    """
    rate = plain_rate(flow)
    return PLANE_STRAIN * rate.subs(sigma, PLANE_STRAIN * sigma) if shape.plane_strain else rate


def plain_rate(flow: Flow) -> sp.Expr:
    """The flow rule without the rounding at zero stress, the only place where E stands in it."""
    rate = flow.rate
    if rate.has(E):
        over = {part: sp.Dummy("over", positive=True) for part in rate.atoms(sp.Max)}
        rate = sp.powsimp(sp.simplify(rate.subs(E, 0).xreplace(over)))
        rate = rate.xreplace({stand_in: part for part, stand_in in over.items()})
    return rate


def gradient_term(equations: FilamentEquations) -> sp.Expr:
    """What a neck adds to the axial force; zero if it is not in force."""
    return sp.Integer(0) if equations.neck is None else -Rate(equations.neck.stiffness() * s_slope, X, 1)


def surface_term(equations: FilamentEquations) -> sp.Expr:
    """What surface tension adds to the axial force; zero if it is not in force."""
    return sp.Integer(0) if equations.surface is None else A0 * equations.surface.force()


def names(number: int, *, several: bool) -> Rename:
    """Symbols of one of several parts in parallel; the plain ones of an only part."""
    if not several:
        return {}
    j = number + 1
    return {
        symbol: enter(f"{symbol.name}_part{j}", f"{latex}^{{({j})}}", dimension, f"{meaning} of part {j}", "2.8")
        for symbol, latex, dimension, meaning in (
            (sigma_0, r"\sigma_0", STRESS, "mean stress"),
            (sigma_1, r"\sigma_1", STRESS, "bending stress"),
            (a_0, "a_0", ONE, "axial plastic strain"),
            (a_1, "a_1", ONE, "bending plastic strain"),
        )
    }


def _which(equations: FilamentEquations, number: int) -> str:
    """Which part, where there are several."""
    response = equations.response
    if len(response.parts) == 1:
        return ""
    return f", part {number + 1}" if number < len(response.branches) else ", viscous"
