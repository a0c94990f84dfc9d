"""Flow rules: overstress, plastic strain rate phi(sigma), and its closed-form means over a section (2.7, 2.24-2.27)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.section import Section
from softcat_sym.equations.symbols import ONE, RATE, E, c, enter, eta, sigma, sigma_0, sigma_1, sigma_Y

elastic_part = enter("eps_e", r"\epsilon^e", ONE, "elastic strain of a fibre", "2.8")
plastic_rate = enter("eps_p_t", r"\epsilon^p_t", RATE, "plastic strain rate of a fibre", "2.7")

# Where the section is uniformly stressed the edge of the yielded zone is anywhere; a stress slope of this many E keeps
# the quotient finite without moving any mean.
_TINY = sp.Rational(1, 10**30)


@dataclass(frozen=True, slots=True)
class SectionMeans:
    """Means of a flow rule over a section in which the stress is sigma_0 + sigma_1 zeta.

    Attributes
    ----------
    rate : sympy.Expr
        <phi>, the mean plastic strain rate.
    bending_rate : sympy.Expr
        <phi zeta>/<zeta^2>, the plastic bending rate at zeta = 1.
    yielded_fraction : sympy.Expr
        Share of the section that flows.
    largest_rate : sympy.Expr
        max |phi| over the section.
    """

    rate: sp.Expr
    bending_rate: sp.Expr
    yielded_fraction: sp.Expr
    largest_rate: sp.Expr


def elastic_stress(strain: sp.Expr, plastic_strain: sp.Expr) -> sp.Expr:
    """Axial stress E (eps - eps_p) (2.8)."""
    return E * (strain - plastic_strain)


def maxwell_rate() -> sp.Expr:
    """phi(sigma) = sigma/eta (2.7)."""
    return sigma / eta


def bingham_rate() -> sp.Expr:
    """phi(sigma) = <|sigma| - sigma_Y> sign(sigma)/eta (2.25)."""
    return sp.Piecewise(
        ((sigma - sigma_Y) / eta, sigma > sigma_Y), ((sigma + sigma_Y) / eta, sigma < -sigma_Y), (sp.Integer(0), True)
    )


def maxwell_means(section: Section) -> SectionMeans:
    """Means of :func:`maxwell_rate`, linear in the stress, so that the section does not matter (2.12)."""
    del section
    return SectionMeans(
        rate=sigma_0 / eta,
        bending_rate=sigma_1 / eta,
        yielded_fraction=sp.Integer(1),
        largest_rate=(sp.Abs(sigma_0) + sp.Abs(sigma_1)) / eta,
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
    edge = sp.Min(sp.Max(-overstress / sp.Max(slope, _TINY * E), low), high)

    def beyond(partial: sp.Expr) -> sp.Expr:
        value = partial.subs(c, edge)
        # Where c is kept inside (-1, 1) a trace of 1e-21 would be left of a section that does not yield at all.
        return value if high == 1 else sp.Piecewise((value, edge < high), (sp.Integer(0), True))

    return _OneSided(
        mean=sp.Max(overstress + low * slope, 0) + slope * beyond(section.overstress_mean),
        moment_per_slope=beyond(section.overstress_moment),
        area=beyond(section.area),
    )


EQUATIONS: tuple[Equation, ...] = (
    Equation("stress of an elastic strain", sigma, elastic_stress(elastic_part, sp.Integer(0)), "2.8"),
    Equation("Maxwell fluid", plastic_rate, maxwell_rate(), "2.7"),
    Equation("Bingham-Norton fluid", plastic_rate, bingham_rate(), "2.25"),
)
