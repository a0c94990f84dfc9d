"""The cross-section: how it shrinks with stretch (2.9) and the closed-form means over its yielded part (2.26, 2.27).

Weighted means over zeta in [-1, 1]: <f> = integral of f(zeta) w(zeta), with w the relative width of the section there.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.symbols import A0, c, h0, s, zeta

# Inside (-1, 1) by this much, acos and sqrt keep finite derivatives; its effect on a mean is of order 1e-21.
_EDGE = sp.Rational(1, 10**14)


@dataclass(frozen=True, slots=True)
class Contraction:
    """How area and thickness follow the stretch.

    Attributes
    ----------
    area, thickness : sympy.Expr
        A(s) and h(s).
    source : str
        Equation numbers.
    """

    area: sp.Expr
    thickness: sp.Expr
    source: str


# Rectangle and circle shrink in both directions, a sheet only in its thickness: its width is held.
UNIFORM = Contraction(area=A0 / s, thickness=h0 / sp.sqrt(s), source="2.9")
WIDE = Contraction(area=A0 / s, thickness=h0 / s, source="THEORY 1")
NONE = Contraction(area=A0, thickness=h0, source="2.13")


@dataclass(frozen=True, slots=True)
class Section:
    """Shape of a cross-section, through its weight and the partial moments of that weight.

    Attributes
    ----------
    name : str
        As in the scene.
    weight : sympy.Expr
        w(zeta), integral one over [-1, 1].
    zeta_squared : sympy.Rational
        <zeta^2>; the second moment of area is I = A (h/2)^2 <zeta^2>.
    area : sympy.Expr
        Fraction of the section beyond c: integral of w from c to 1.
    overstress_mean, overstress_moment : sympy.Expr
        K_n(c) = integral of (zeta - c) zeta^n w(zeta) from c to 1, for n = 0 and 1.
    interval : tuple of sympy.Expr
        Where c may lie for these closed forms to have finite derivatives.
    contraction : Contraction
        How it shrinks when the filament stretches.
    area_power : int
        The area goes with this power of a relative thickness that varies along the filament.
    plane_strain : bool
        Whether it is too wide to change its width.
    """

    name: str
    weight: sp.Expr
    zeta_squared: sp.Rational
    area: sp.Expr
    overstress_mean: sp.Expr
    overstress_moment: sp.Expr
    interval: tuple[sp.Expr, sp.Expr]
    contraction: Contraction = UNIFORM
    area_power: int = 1
    plane_strain: bool = False


RECTANGLE = Section(
    name="rectangle",
    weight=sp.Rational(1, 2),
    zeta_squared=sp.Rational(1, 3),
    area=(1 - c) / 2,
    overstress_mean=(1 - c) ** 2 / 4,
    overstress_moment=(1 - c) ** 2 * (2 + c) / 12,
    interval=(sp.Integer(-1), sp.Integer(1)),
)

_half_chord = sp.sqrt(1 - c**2)

CIRCLE = Section(
    name="circle",
    weight=2 * sp.sqrt(1 - zeta**2) / sp.pi,
    zeta_squared=sp.Rational(1, 4),
    area=(sp.acos(c) - c * _half_chord) / sp.pi,
    overstress_mean=((2 + c**2) * _half_chord / 3 - c * sp.acos(c)) / sp.pi,
    overstress_moment=(sp.acos(c) / 4 - c * (5 - 2 * c**2) * _half_chord / 12) / sp.pi,
    interval=(-1 + _EDGE, 1 - _EDGE),
    area_power=2,
)

# A wide section: one of unit relative width, like the rectangle, but its width is held while it thins.
SHEET = replace(RECTANGLE, name="sheet", contraction=WIDE, plane_strain=True)

SECTIONS: dict[str, Section] = {section.name: section for section in (RECTANGLE, CIRCLE, SHEET)}


def _partial_moments(shape: Section) -> tuple[Equation, ...]:
    """Area, K_0 and K_1 as integrals over the part of the section beyond c."""
    beyond = (zeta, c, 1)
    return (
        Equation(f"share of the {shape.name} beyond c", shape.area, sp.Integral(shape.weight, beyond), "2.26"),
        Equation(
            f"K_0 of the {shape.name}", shape.overstress_mean, sp.Integral((zeta - c) * shape.weight, beyond), "2.26"
        ),
        Equation(
            f"K_1 of the {shape.name}",
            shape.overstress_moment,
            sp.Integral((zeta - c) * zeta * shape.weight, beyond),
            "2.27",
        ),
    )


EQUATIONS: tuple[Equation, ...] = (*_partial_moments(RECTANGLE), *_partial_moments(SHEET), *_partial_moments(CIRCLE))
