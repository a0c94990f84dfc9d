"""The section in the paper's own letters: (2.9)-(2.12), (2.23)-(2.27) and the appendix, as printed.

These are what the printed closure means. The solver runs :mod:`softcat_sym.equations.closure` and
:mod:`softcat_sym.equations.laws`, which are proved to be the same.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import cast

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.symbols import (
    A0,
    AREA,
    LENGTH,
    ONE,
    Dimension,
    E,
    M,
    T,
    X,
    enter,
    enter_field,
    eta,
    h0,
    s,
    sigma,
    sigma_0,
    sigma_Y,
    t,
    theta_X,
    z,
)
from softcat_sym.equations.through_thickness import flow_rule

h = enter("h", "h", LENGTH, "thickness of the section", "2.26", positive=True)
D = enter("D", "D", LENGTH, "width of the section", "2.26", positive=True)
A = enter("A", "A", AREA, "area of the section", "2.9", positive=True)
I_z = enter("I_z", "I", (0, 4, 0), "second moment of area of the section", "2.9", positive=True)
P = enter("P", "P", AREA, "plastic stretch, the integral of the plastic strain", "2.11")
C = enter("C", "C", (0, 3, 0), "plastic bend, the integral of the plastic strain times z", "2.11")
z_L = enter("z_L", "z_L", LENGTH, "upper edge of the yielded zone at the bottom", "2.26")
z_H = enter("z_H", "z_H", LENGTH, "lower edge of the yielded zone at the top", "2.26")
stress_slope = enter(
    "stress_slope", r"\sigma_z", (1, -2, -2), "change of the axial stress per unit z (the paper's sigma_1)", "2.23"
)
plastic_stretch = enter_field("plastic_stretch", "P", AREA, "P of material coordinate and time", "2.12")(X, t)
plastic_bend = enter_field("plastic_bend", "C", (0, 3, 0), "C of material coordinate and time", "2.12")(X, t)
# The L_n carry 1/sqrt(length), and so the a_n sqrt(length): the one dimension here with a half in it.
_ROOT_OF_LENGTH = cast("Dimension", (0, Fraction(1, 2), 0))
coefficients = tuple(
    enter_field(f"coefficient_{n}", f"a_{n}", _ROOT_OF_LENGTH, f"plastic strain in L_{n}", "A 1")(X, t)
    for n in range(4)
)
fibre_strain = enter("fibre_strain", r"\epsilon", ONE, "axial true strain of a fibre", "2.6")

PRINTED_STRAIN = sp.log(s) - theta_X * z
TENSION = E * (A * sp.log(s) - P)
MOMENT = -E * (I_z * theta_X + C)
STRESS_FIELD = T / A + M / I_z * z


def plastic_stretch_rate() -> sp.Expr:
    """P_t of a Bingham filament of rectangular section (2.26)."""
    top, bottom = sp.sign(6 * M + h * T), sp.sign(6 * M - h * T)
    return (
        (1 + (z_L - z_H) / h) * T
        + 6 * M * (z_L**2 - z_H**2) / h**3
        + (z_H - h / 2) * D * sigma_Y * top
        + (z_L + h / 2) * D * sigma_Y * bottom
    ) / eta


def plastic_bend_rate() -> sp.Expr:
    """C_t of a Bingham filament of rectangular section (2.27)."""
    top, bottom = sp.sign(6 * M + h * T), sp.sign(6 * M - h * T)
    return (
        (1 - 4 * (z_H**3 - z_L**3) / h**3) * M
        + T * (z_L**2 - z_H**2) / (2 * h)
        + (z_H**2 / 2 - h**2 / 8) * D * sigma_Y * top
        + (z_L**2 / 2 - h**2 / 8) * D * sigma_Y * bottom
    ) / eta


def bingham_rate() -> sp.Expr:
    """Flow rule of an elastic, perfectly viscoplastic material (2.25)."""
    return (sigma - sp.sign(sigma) * sigma_Y) * sp.Heaviside(sp.Abs(sigma) - sigma_Y) / eta


def scaled_legendre(order: int) -> sp.Expr:
    """L_n(z) = sqrt((2n + 1)/h) p_n(2z/h), orthonormal over the present thickness (A 1)."""
    return sp.sqrt((2 * order + 1) / h) * sp.legendre(order, 2 * z / h)


def coefficient_rate(order: int, states: Sequence[sp.Expr]) -> sp.Expr:
    """da_n/dt as printed, with the sum cut after the states given (A 2)."""
    plastic = sp.Add(*(state * scaled_legendre(m) for m, state in enumerate(states)))
    stress = E * sp.log(s) - E * theta_X * z - E * plastic
    return sp.Integral(flow_rule(stress) * scaled_legendre(order), (z, -h / 2, h / 2))


EQUATIONS: tuple[Equation, ...] = (
    Equation("strain of a fibre, as printed", fibre_strain, PRINTED_STRAIN, "2.6"),
    Equation("area", A, A0 / s, "2.9"),
    Equation("thickness", h, h0 / sp.sqrt(s), "2.9"),
    Equation("second moment of area of a rectangle", I_z, A0 * h0**2 / (12 * s**2), "2.9"),
    Equation("tension", T, TENSION, "2.11"),
    Equation("moment", M, MOMENT, "2.11"),
    Equation("plastic stretch of a Maxwell fluid", sp.Derivative(plastic_stretch, t), T / eta, "2.12"),
    Equation("plastic bend of a Maxwell fluid", sp.Derivative(plastic_bend, t), M / eta, "2.12"),
    Equation("tension of a linear stress", T, sigma_0 * A, "2.23"),
    Equation("moment of a linear stress", M, stress_slope * I_z, "2.23"),
    Equation("stress of a fibre", sigma, STRESS_FIELD, "2.23"),
    Equation("Bingham-Norton flow rule", flow_rule(sigma), bingham_rate(), "2.25"),
    Equation("plastic stretch", sp.Derivative(plastic_stretch, t), plastic_stretch_rate(), "2.26"),
    Equation("plastic bend", sp.Derivative(plastic_bend, t), plastic_bend_rate(), "2.27"),
    *(
        Equation(f"coefficient {n}", sp.Derivative(a, t), coefficient_rate(n, coefficients), "A 2, as printed")
        for n, a in enumerate(coefficients)
    ),
)
