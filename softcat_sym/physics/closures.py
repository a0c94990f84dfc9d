"""The closures for the plastic state (THEORY 4): the paper's, as printed, and the material one, the default."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import cast

import sympy as sp

from softcat_sym.physics.equation import Equation, Equations
from softcat_sym.physics.kinematics import StrainMeasure
from softcat_sym.physics.sections import CIRCLE, RECTANGLE, SHEET, UNIFORM, WIDE, Contraction, Section
from softcat_sym.physics.symbols import (
    A0,
    AREA,
    LENGTH,
    ONE,
    RATE,
    Dimension,
    E,
    M,
    Q,
    T,
    X,
    a_0,
    a_1,
    enter,
    enter_field,
    eta,
    h0,
    s,
    sigma,
    sigma_0,
    sigma_1,
    sigma_Y,
    t,
    theta_X,
    z,
    zeta,
)


@dataclass(frozen=True, slots=True)
class ClosedSection:
    """What a closure makes of a strain measure and a contraction."""

    lever: sp.Expr  # Bending strain at zeta = 1 per unit -theta_X
    recall_mean: sp.Expr  # Factors with which the states a_0 and a_1 count as plastic strain
    recall_bending: sp.Expr
    axial_correction: sp.Expr  # Q - T in terms of M, theta_X and s


def material(measure: StrainMeasure, contraction: Contraction) -> ClosedSection:
    """Fibres keep their zeta: eps = log s - theta_s (h/2) zeta, and Q = T + (3/2) M theta_s by work conjugacy.

    The correction to T is what the bending strain gains when the stretch changes at a fixed turning.
    """
    lever = contraction.thickness / (2 * measure.arc_stretch)
    return ClosedSection(
        lever=lever,
        recall_mean=sp.Integer(1),
        recall_bending=sp.Integer(1),
        axial_correction=-M * theta_X * sp.powsimp(sp.diff(lever, s) / lever),
    )


def printed(measure: StrainMeasure, contraction: Contraction) -> ClosedSection:
    """(2.6), (2.9)-(2.12): eps = log s - theta_X z, P and C as states, Q = T.

    P_t = integral of phi over the *current* section, so that P/A grows or shrinks with the section: the terms that the
    shrinking adds (A_t P/A and the like) are missing, and at finite stretch the tension is too small.
    """
    del measure
    shrink = A0 / contraction.area
    return ClosedSection(
        lever=contraction.thickness / 2,
        recall_mean=shrink,
        recall_bending=shrink * h0 / contraction.thickness,
        axial_correction=sp.Integer(0),
    )


CLOSURES = {"material": material, "printed": printed}

CLOSURE_EQUATIONS: tuple[Equation, ...] = (
    Equation("axial force, material closure", Q, T + sp.Rational(3, 2) * M * theta_X / s, "THEORY 4"),
    Equation("axial force of a sheet, material closure", Q, T + 2 * M * theta_X / s, "THEORY 4"),
    Equation("axial force, printed closure", Q, T, "2.4"),
    Equation("mean stress, material closure", sigma_0, E * (sp.log(s) - a_0), "THEORY 4"),
    Equation("mean stress, printed closure", sigma_0, E * (sp.log(s) - s * a_0), "2.11"),
    Equation(
        "bending stress, material closure",
        sigma_1,
        -E * (h0 * theta_X / (2 * s ** sp.Rational(3, 2)) + a_1),
        "THEORY 4",
    ),
    Equation(
        "bending stress, printed closure",
        sigma_1,
        -E * (h0 * theta_X / (2 * sp.sqrt(s)) + s ** sp.Rational(3, 2) * a_1),
        "2.11",
    ),
)

flow_rule = enter_field("flow_rule", r"\hat\epsilon^p_t", RATE, "plastic strain rate of a stress", "2.24")
amplitudes = tuple(
    enter_field(f"amplitude_{n}", f"a_{n}", ONE, f"plastic strain in the polynomial p_{n}", "A 1")(t) for n in range(5)
)


def _legendre(order: int) -> sp.Expr:
    return sp.legendre(order, zeta)


def _chebyshev(order: int) -> sp.Expr:
    return sp.expand(sp.chebyshevu(order, zeta) / (order + 1))


_POLYNOMIALS: dict[str, Callable[[int], sp.Expr]] = {
    RECTANGLE.name: _legendre,
    SHEET.name: _legendre,
    CIRCLE.name: _chebyshev,
}
_MEAN_SQUARES: dict[str, Callable[[int], sp.Rational]] = {
    RECTANGLE.name: lambda order: sp.Rational(1, 2 * order + 1),
    SHEET.name: lambda order: sp.Rational(1, 2 * order + 1),
    CIRCLE.name: lambda order: sp.Rational(1, (order + 1) ** 2),
}


def polynomial(section: Section, order: int) -> sp.Expr:
    """p_n(zeta), orthogonal under the width of the section, with p_n(1) = 1 (A 1)."""
    return _POLYNOMIALS[section.name](order)


def mean_square(section: Section, order: int) -> sp.Rational:
    """<p_n^2>."""
    return _MEAN_SQUARES[section.name](order)


def mean(section: Section, of: sp.Expr) -> sp.Integral:
    """<f>, the mean over the section, not evaluated."""
    return sp.Integral(of * section.weight, (zeta, -1, 1))


def fibre_strain(contraction: Contraction) -> sp.Expr:
    """Axial true strain of the fibre zeta, log s - theta_s (h/2) zeta (2.6, corrected)."""
    return sp.log(s) - theta_X / s * contraction.thickness / 2 * zeta


def plastic_strain(section: Section, states: Sequence[sp.Expr]) -> sp.Expr:
    """Plastic strain of the fibre zeta, the sum of a_n p_n(zeta) (A 1)."""
    return sp.Add(*(state * polynomial(section, n) for n, state in enumerate(states)))


def fibre_stress(section: Section, contraction: Contraction, states: Sequence[sp.Expr]) -> sp.Expr:
    """Axial stress of the fibre zeta (2.8)."""
    return E * (fibre_strain(contraction) - plastic_strain(section, states))


def stress_amplitudes(contraction: Contraction, states: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """b_n of the stress, the sum of b_n p_n(zeta) (A 1); strain is linear, so b_n = -E a_n from n = 2 on."""
    lever = contraction.thickness / (2 * s)
    strains = (sp.log(s), -lever * theta_X)
    return tuple(E * ((strains[n] if n < 2 else 0) - state) for n, state in enumerate(states))


def amplitude_rate(section: Section, order: int, rate: sp.Expr) -> sp.Expr:
    """da_n/dt = <phi p_n>/<p_n^2> (A 2 for a thickness that moves)."""
    return mean(section, rate * polynomial(section, order)) / mean_square(section, order)


def tension(contraction: Contraction, stresses: Sequence[sp.Expr]) -> sp.Expr:
    """T = A <sigma> = A b_0 at any order (2.10)."""
    return contraction.area * stresses[0]


def moment(section: Section, contraction: Contraction, stresses: Sequence[sp.Expr]) -> sp.Expr:
    """M = A (h/2) <sigma zeta> = A (h/2) <zeta^2> b_1 at any order above zero (2.10)."""
    if len(stresses) < 2:
        return sp.Integer(0)
    return contraction.area * contraction.thickness / 2 * section.zeta_squared * stresses[1]


def conjugate_force(contraction: Contraction) -> sp.Expr:
    """Q = T + m M theta_s, m = 3/2 for a section that shrinks both ways and 2 for a sheet (THEORY 4)."""
    factor = 1 - sp.cancel(s * sp.diff(contraction.thickness, s) / contraction.thickness)
    return T + factor * M * theta_X / s


def stored_energy(section: Section, stresses: Sequence[sp.Expr]) -> sp.Expr:
    """Elastic energy per unit material length, A0 <sigma^2>/(2E)."""
    return A0 / (2 * E) * sp.Add(*(b**2 * mean_square(section, n) for n, b in enumerate(stresses)))


def dissipation(section: Section, stress: sp.Expr, rate: sp.Expr) -> sp.Expr:
    """Plastic power per unit material length, A0 <sigma phi>: no fibre ever gives work back."""
    return A0 * mean(section, stress * rate)


def _evolution(section: Section, contraction: Contraction, order: int) -> tuple[Equation, ...]:
    states = amplitudes[: order + 1]
    rate = flow_rule(fibre_stress(section, contraction, states))
    return tuple(
        Equation(f"plastic state {n}, {section.name}", sp.Derivative(state, t), amplitude_rate(section, n, rate), "A 2")
        for n, state in enumerate(states)
    )


def _through_thickness_equations() -> tuple[Equation, ...]:
    return (
        Equation("stress of a fibre", sigma, fibre_stress(RECTANGLE, UNIFORM, amplitudes), "2.6, 2.8"),
        Equation("stress of a fibre of a sheet", sigma, fibre_stress(SHEET, WIDE, amplitudes), "2.6, 2.8"),
        Equation("stress of a fibre of a round filament", sigma, fibre_stress(CIRCLE, UNIFORM, amplitudes), "2.6, 2.8"),
        Equation("axial force", Q, conjugate_force(UNIFORM), "THEORY 4"),
        Equation("axial force of a sheet", Q, conjugate_force(WIDE), "THEORY 4"),
        *_evolution(RECTANGLE, UNIFORM, 3),
        *_evolution(SHEET, WIDE, 3),
        *_evolution(CIRCLE, UNIFORM, 3),
    )


THROUGH_THICKNESS_EQUATIONS = Equations(_through_thickness_equations)

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
printed_fibre_strain = enter("fibre_strain", r"\epsilon", ONE, "axial true strain of a fibre", "2.6")

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


def _paper_section_equations() -> tuple[Equation, ...]:
    return (
        Equation("strain of a fibre, as printed", printed_fibre_strain, PRINTED_STRAIN, "2.6"),
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


PAPER_SECTION_EQUATIONS = Equations(_paper_section_equations)
