"""The cross-section: how it shrinks with stretch (2.9), and means of a flow rule over it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import sympy as sp
from sympy.integrals.quadrature import gauss_legendre

from softcat_sym.physics.cross_sections import CROSS_SECTIONS
from softcat_sym.physics.symbols import A0, E, c, h0, s, sigma, sigma_0, sigma_1, zeta

# Inside (-1, 1) by this much, acos and sqrt keep finite derivatives; its effect on a mean is of order 1e-21.
_EDGE = sp.Rational(1, 10**14)


@dataclass(frozen=True, slots=True)
class Contraction:
    """How area and thickness follow the stretch."""

    area: sp.Expr  # A(s) and h(s)
    thickness: sp.Expr
    source: str  # Equation numbers


# Rectangle and circle shrink in both directions, a sheet only in its thickness: its width is held.
UNIFORM = Contraction(area=A0 / s, thickness=h0 / sp.sqrt(s), source="2.9")
WIDE = Contraction(area=A0 / s, thickness=h0 / s, source="THEORY 1")
NONE = Contraction(area=A0, thickness=h0, source="2.13")


@dataclass(frozen=True, slots=True)
class Section:
    """Shape of a cross-section, through its weight and the partial moments of that weight."""

    name: str  # As in the scene
    weight: sp.Expr  # w(zeta), integral one over [-1, 1]
    area: sp.Expr  # Fraction of the section beyond c: integral of w from c to 1
    overstress_mean: sp.Expr  # K_n(c) = integral of (zeta - c) zeta^n w(zeta) from c to 1, for n = 0 and 1
    overstress_moment: sp.Expr
    interval: tuple[sp.Expr, sp.Expr]  # Where c may lie for these closed forms to have finite derivatives
    contraction: Contraction = UNIFORM  # How it shrinks when the filament stretches

    @property
    def zeta_squared(self) -> sp.Rational:
        """<zeta^2>; the second moment of area is I = A (h/2)^2 <zeta^2>."""
        return sp.Rational(CROSS_SECTIONS[self.name].zeta_squared)

    @property
    def shear_correction(self) -> sp.Rational:
        """kappa_s, from the energy of a parabolic shear stress."""
        return sp.Rational(CROSS_SECTIONS[self.name].shear_correction)

    @property
    def area_power(self) -> int:
        """With which the area goes with a relative thickness that varies along the filament."""
        return CROSS_SECTIONS[self.name].area_power

    @property
    def plane_strain(self) -> bool:
        """Whether it is too wide to change its width."""
        return CROSS_SECTIONS[self.name].plane_strain


RECTANGLE = Section(
    name="rectangle",
    weight=sp.Rational(1, 2),
    area=(1 - c) / 2,
    overstress_mean=(1 - c) ** 2 / 4,
    overstress_moment=(1 - c) ** 2 * (2 + c) / 12,
    interval=(sp.Integer(-1), sp.Integer(1)),
)

_half_chord = sp.sqrt(1 - c**2)

CIRCLE = Section(
    name="circle",
    weight=2 * sp.sqrt(1 - zeta**2) / sp.pi,
    area=(sp.acos(c) - c * _half_chord) / sp.pi,
    overstress_mean=((2 + c**2) * _half_chord / 3 - c * sp.acos(c)) / sp.pi,
    overstress_moment=(sp.acos(c) / 4 - c * (5 - 2 * c**2) * _half_chord / 12) / sp.pi,
    interval=(-1 + _EDGE, 1 - _EDGE),
)

# A wide section: one of unit relative width, like the rectangle, but its width is held while it thins.
SHEET = replace(RECTANGLE, name="sheet", contraction=WIDE)

SECTIONS: dict[str, Section] = {section.name: section for section in (RECTANGLE, CIRCLE, SHEET)}


# Where the section is uniformly stressed the edge of the yielded zone is anywhere; a stress slope of this many E keeps
# the quotient finite without moving any mean.
TINY = sp.Rational(1, 10**30)

# A side that is narrower than this is taken as empty where a square root of its width would have no derivative.
_NARROW = sp.Rational(1, 10**14)

_POINTS = 9
_DIGITS = 20


@dataclass(frozen=True, slots=True)
class SectionMeans:
    """Means of a flow rule over a section in which the stress is sigma_0 + sigma_1 zeta."""

    rate: sp.Expr  # <phi>, the mean plastic strain rate
    bending_rate: sp.Expr  # <phi zeta>/<zeta^2>, the plastic bending rate at zeta = 1
    yielded_fraction: sp.Expr  # Share of the section that flows
    largest_rate: sp.Expr  # max |phi| over the section


def scaled(means: SectionMeans, factor: sp.Expr) -> SectionMeans:
    """Means of the rule factor phi(factor sigma), from those of phi.

    A wide sheet cannot contract across its width: of its stress sigma the equivalent stress is sqrt(3)/2 sigma, and of
    the equivalent strain rate its own is sqrt(3)/2, so that it flows by this rule with the factor sqrt(3)/2.
    """
    of_scaled = _at({sigma_0: factor * sigma_0, sigma_1: factor * sigma_1})
    return SectionMeans(
        rate=factor * of_scaled(means.rate),
        bending_rate=factor * of_scaled(means.bending_rate),
        yielded_fraction=of_scaled(means.yielded_fraction),
        largest_rate=factor * of_scaled(means.largest_rate),
    )


def of_bending_alone(means: SectionMeans) -> SectionMeans:
    """Means where the stress is sigma_1 zeta: its two sides are mirror images, and <phi> of an odd rule vanishes."""
    without_mean = _at({sigma_0: sp.Integer(0)})
    return SectionMeans(
        rate=sp.Integer(0),
        bending_rate=without_mean(means.bending_rate),
        yielded_fraction=without_mean(means.yielded_fraction),
        largest_rate=without_mean(means.largest_rate),
    )


def _at(stresses: dict[sp.Symbol, sp.Expr]) -> Callable[[sp.Expr], sp.Expr]:
    """Expressions with other stresses put in."""

    def put_in(expr: sp.Expr) -> sp.Expr:
        # Each edge stands in the expression at every point; SymPy is slow to build a Max and does so once this way.
        return expr.xreplace({part: part.xreplace(stresses) for part in expr.atoms(sp.Max, sp.Min)} | stresses)

    return put_in


def quadrature_means(section: Section, rate: sp.Expr, threshold: sp.Expr) -> SectionMeans:
    """Means of any flow rule by Gauss quadrature, with nine points in tension and nine in compression.

    Values and first derivatives are finite for every stress, that of a section at rest included, if those of the rule
    are. Exact to rounding for a linear rule on a rectangle; within 3e-6 on a circle, and for |sigma|^(1/n) with n from
    1/4 to 2.
    """
    # Nowhere zero, unlike sign(sigma_1): with it the derivative at no moment would be lost, and so the resistance to
    # bending of a uniformly stressed section.
    turn = sp.sign(sigma_1 + TINY * E)
    slope = turn * sigma_1
    yields = threshold != 0
    beyond = _of_overstress(rate, threshold)
    tension = _one_sided(section, beyond, sigma_0 - threshold, slope, yields=yields)
    compression = _one_sided(section, beyond, -sigma_0 - threshold, slope, yields=yields)
    largest = sp.Max(0, sp.Abs(sigma_0) + sp.Abs(sigma_1) - threshold)
    return SectionMeans(
        rate=tension.mean - compression.mean,
        bending_rate=turn * (tension.moment + compression.moment) / section.zeta_squared,
        yielded_fraction=sp.Integer(1) if threshold == 0 else tension.area + compression.area,
        largest_rate=beyond(largest),
    )


@dataclass(frozen=True, slots=True)
class _OneSided:
    mean: sp.Expr
    moment: sp.Expr
    area: sp.Expr


def _one_sided(
    section: Section, rate: Callable[[sp.Expr], sp.Expr], overstress: sp.Expr, slope: sp.Expr, *, yields: bool
) -> _OneSided:
    """Integrals over the fibres q in [edge, 1] in which the overstress at the axis + slope q is positive."""
    edge = sp.Min(sp.Max(-overstress / sp.Max(sp.Abs(sigma_1), TINY * E), -1), 1)
    width = 1 - edge
    # Of a section that has yielded right through, the overstress of its least stressed fibre. Without a threshold
    # every section has: there a Max would lose half of the derivative of a section at rest.
    least = sp.Max(overstress - slope, 0) if yields else None
    constant, rounded = _weight(section)
    fibres, moments = [], []
    for point, weight in _points():
        here = edge + width * point
        flow = weight * rate(overstress + slope * here if least is None else least + slope * width * point)
        if rounded:
            # (1 - q^2) = (1 - q)(1 + q), of which the first factor is width (1 - point).
            flow *= sp.sqrt(1 - point) * sp.sqrt(1 + here)
        fibres.append(flow)
        moments.append(flow * here)
    share = constant * width * (sp.sqrt(sp.Max(width, _NARROW)) if rounded else 1)
    low, high = section.interval
    area = section.area.subs(c, sp.Min(sp.Max(edge, low), high))
    return _OneSided(
        mean=share * sp.Add(*fibres),
        moment=share * sp.Add(*moments),
        area=sp.Piecewise((area, edge < high), (sp.Integer(0), True)),
    )


def _of_overstress(rate: sp.Expr, threshold: sp.Expr) -> Callable[[sp.Expr], sp.Expr]:
    """The rule as a function of a tensile overstress: signs, absolute values and half of the branches drop out.

    Without a threshold it stays as it is: a stress that should be zero may then be of either sign.
    """
    if threshold == 0:
        return lambda value: rate.xreplace({sigma: value})
    overstress = sp.Dummy("overstress", positive=True)
    settled = rate.xreplace({sigma: threshold + overstress})
    return lambda value: settled.xreplace({overstress: value})


def _weight(section: Section) -> tuple[sp.Expr, bool]:
    """Constant k of the weight k (1 - zeta^2)^p, and whether p is 1/2."""
    for rounded, shape in ((False, sp.Integer(1)), (True, sp.sqrt(1 - zeta**2))):
        constant = section.weight / shape
        if not constant.has(zeta):
            return constant, rounded
    raise ValueError(f"no quadrature for the weight {section.weight} of the section {section.name}")


@cache
def _points() -> tuple[tuple[sp.Float, sp.Float], ...]:
    """Points in (0, 1) and weights, by q = u^2 (3 - 2u) from Gauss's: smooth where a root is at either end."""
    points, weights = gauss_legendre(_POINTS, _DIGITS)
    half = [((1 + x) / 2, w / 2) for x, w in zip(points, weights, strict=True)]
    return tuple((u**2 * (3 - 2 * u), w * 6 * u * (1 - u)) for u, w in half)
