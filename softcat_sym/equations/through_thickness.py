"""The material closure at any order: plastic strain as polynomials of the material coordinate zeta (THEORY 4, A 1-2).

A fibre keeps its zeta = 2z/h while the section shrinks, so that its strain is log s - theta_s (h/2) zeta and its
plastic strain sum a_n p_n(zeta) changes by flow alone. The p_n are orthogonal under the width of the section and one
at zeta = 1: Legendre's for a rectangle or sheet, Chebyshev's of the second kind (over n + 1) for a circle. Order 0 is a
membrane, order 1 the paper's level, higher orders its appendix.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.section import CIRCLE, RECTANGLE, SHEET, UNIFORM, WIDE, Contraction, Section
from softcat_sym.equations.symbols import A0, ONE, RATE, E, M, Q, T, enter_field, s, sigma, t, theta_X, zeta

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
        Equation(
            f"plastic state {n}, {section.name}",
            sp.Derivative(state, t),
            amplitude_rate(section, n, rate),
            "A 2",
        )
        for n, state in enumerate(states)
    )


EQUATIONS: tuple[Equation, ...] = (
    Equation("stress of a fibre", sigma, fibre_stress(RECTANGLE, UNIFORM, amplitudes), "2.6, 2.8"),
    Equation("stress of a fibre of a sheet", sigma, fibre_stress(SHEET, WIDE, amplitudes), "2.6, 2.8"),
    Equation("stress of a fibre of a round filament", sigma, fibre_stress(CIRCLE, UNIFORM, amplitudes), "2.6, 2.8"),
    Equation("axial force", Q, conjugate_force(UNIFORM), "THEORY 4"),
    Equation("axial force of a sheet", Q, conjugate_force(WIDE), "THEORY 4"),
    *_evolution(RECTANGLE, UNIFORM, 3),
    *_evolution(SHEET, WIDE, 3),
    *_evolution(CIRCLE, UNIFORM, 3),
)
