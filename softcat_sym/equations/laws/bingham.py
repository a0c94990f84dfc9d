"""Bingham-Norton fluid: elastic up to the yield stress, beyond it phi = <|sigma| - sigma_Y> sign(sigma)/eta (2.25)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.law import Branch, Flow, Law
from softcat_sym.equations.laws.flow_rule import flow_rule
from softcat_sym.equations.laws.maxwell import linear_flow
from softcat_sym.equations.section import Section
from softcat_sym.equations.section_means import TINY, SectionMeans
from softcat_sym.equations.symbols import E, c, eta, sigma, sigma_0, sigma_1, sigma_Y


def bingham_rate() -> sp.Expr:
    """phi(sigma) = <|sigma| - sigma_Y> sign(sigma)/eta (2.25)."""
    return sp.Piecewise(
        ((sigma - sigma_Y) / eta, sigma > sigma_Y), ((sigma + sigma_Y) / eta, sigma < -sigma_Y), (sp.Integer(0), True)
    )


def bingham_means(section: Section) -> SectionMeans:
    """Means of :func:`bingham_rate` in closed form: (2.26), (2.27) for every sign case, free of 0/0.

    The fibres beyond sigma_Y in tension fill zeta from an edge c to the stressed side, those in compression from the
    other side; with the stress slope |sigma_1| the means are |sigma_1| K_n(c), and a section that has yielded right
    through adds the overstress of its least stressed fibre. Both sides bend the section the way of sigma_1.
    """
    slope = sp.Abs(sigma_1)
    tension = _one_sided(section, sigma_0 - sigma_Y, slope)
    compression = _one_sided(section, -sigma_0 - sigma_Y, slope)
    moment_per_slope = tension.moment_per_slope + compression.moment_per_slope
    return SectionMeans(
        rate=(tension.mean - compression.mean) / eta,
        bending_rate=sigma_1 * moment_per_slope / (section.zeta_squared * eta),
        yielded_fraction=tension.area + compression.area,
        largest_rate=sp.Max(0, sp.Abs(sigma_0) + slope - sigma_Y) / eta,
    )


@dataclass(frozen=True, slots=True)
class _OneSided:
    mean: sp.Expr
    moment_per_slope: sp.Expr
    area: sp.Expr


def _one_sided(section: Section, overstress: sp.Expr, slope: sp.Expr) -> _OneSided:
    low, high = section.interval
    edge = sp.Min(sp.Max(-overstress / sp.Max(slope, TINY * E), low), high)

    def beyond(partial: sp.Expr) -> sp.Expr:
        value = partial.subs(c, edge)
        # Where c is kept inside (-1, 1) a trace of 1e-21 would be left of a section that does not yield at all.
        return value if high == 1 else sp.Piecewise((value, edge < high), (sp.Integer(0), True))

    return _OneSided(
        mean=sp.Max(overstress + low * slope, 0) + slope * beyond(section.overstress_mean),
        moment_per_slope=beyond(section.overstress_moment),
        area=beyond(section.area),
    )


LAW = Law(
    "bingham",
    branches=(Branch(flow=linear_flow(eta), flow_beyond_yield=Flow(bingham_rate(), sigma_Y, bingham_means)),),
)

EQUATIONS: tuple[Equation, ...] = (flow_rule("Bingham-Norton fluid", bingham_rate(), "2.25"),)
