"""Small deflections of a Maxwell filament (2.13-2.19): one deflection, one tension for the whole span, two memories.

To leading order in y/L, with thickness, deflection and gravity small together, tension and elongation are uniform along
the span: the strain of each cell is replaced by the mean of y_X^2/2, and the axial plastic strain by one number. The
memory integrals of (2.16)-(2.18) are held as states that relax: the plastic strains a_0(t) and a_1(X, t), which the
graph integrates, or q(t) and m(x, t) in the dimensionless form.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.regimes import V, delta, tau_star
from softcat_sym.physics.rheometry import t_star
from softcat_sym.physics.sections import Section
from softcat_sym.physics.symbols import (
    A0,
    FORCE,
    LENGTH,
    M_X,
    MOMENT,
    ONE,
    PER_LENGTH,
    RATE,
    TIME,
    E,
    L,
    M,
    T,
    X,
    a_0,
    a_1,
    enter,
    enter_field,
    eta,
    g,
    h0,
    rho,
    sigma_0,
    sigma_1,
    t,
    y_X,
)

_half = sp.Rational(1, 2)

# one section, for printing
e_mean = enter("e_mean", r"\bar\epsilon", ONE, "mean of y_X^2/2 over the span, the uniform axial strain", "2.17")
e_mean_t = enter("e_mean_t", r"\bar\epsilon_t", RATE, "rate of the uniform axial strain", "2.17")
y_XX = enter("y_XX", "y_{XX}", PER_LENGTH, "curvature of a small deflection", "2.13")
y_XXt = enter("y_XXt", "y_{XXt}", (0, -1, -1), "rate of curvature of a small deflection", "2.16")
F_X = enter("F_X", "F_X", (1, 0, -2), "change of vertical force per unit material length", "2.14")
K_I = enter("K_I", "K", ONE, "form factor of the section, I = K A h^2", "2.18", positive=True)

# coordinates; those with a bar or a star in units of L and sqrt(L/g)
x_bar = enter("x_bar", r"\bar x", ONE, "position along the span in spans", "2.18")
t_prime = enter("t_prime", "t'", TIME, "earlier time", "2.16")
t_star_prime = enter("t_star_prime", "t^{*\\prime}", ONE, "earlier time in sqrt(L/g)", "2.18")

# fields
y_of = enter_field("y_of", "y", LENGTH, "small deflection, of (X, t)", "2.13")
U_of = enter_field("U_of", "U", LENGTH, "displacement along the span, of (X, t)", "2.13")
M_of = enter_field("M_of", "M", MOMENT, "bending moment, of (X, t)", "2.14")
T_of = enter_field("T_of", "T", FORCE, "tension, of time alone", "2.14")
a_0_of = enter_field("a_0_of", "a_0", ONE, "axial plastic strain, of time alone", "2.15")
a_1_of = enter_field("a_1_of", "a_1", ONE, "bending plastic strain at zeta = 1, of (X, t)", "2.15")
y_bar = enter_field("y_bar", r"\bar y", ONE, "deflection in spans, of (x, t)", "2.18")
m_bar = enter_field("m_bar", "m", ONE, "bending memory of (2.18), of (x, t)", "2.18")
q_bar = enter_field("q_bar", "q", ONE, "stretching memory of (2.18), of time alone", "2.18")


def form_factor(shape: Section) -> sp.Rational:
    """K = I/(A h^2) of (2.18): 1/12 for a rectangle, 1/16 for a circle."""
    return shape.zeta_squared / 4


@dataclass(frozen=True, slots=True)
class SmallDeflection:
    """One section of the reduced filament, to be printed on nodes (curvature) or once for the span (elongation)."""

    elongation: sp.Expr  # Of y_X, in a cell; its mean over the span is e_mean (2.13)
    stress_mean: sp.Expr  # sigma_0 of (e_mean, a_0), one for the span (2.15)
    stress_bending: sp.Expr  # sigma_1 of (y_XX, a_1), on nodes (2.15)
    tension: sp.Expr  # T of sigma_0 and M of sigma_1 (2.10)
    moment: sp.Expr
    vertical_force: sp.Expr  # F of (T, y_X, M_X), in a cell (2.14)
    acceleration: sp.Expr  # y_tt of F_X, on nodes (2.14)
    rate_mean: sp.Expr  # da_0/dt of sigma_0 and da_1/dt of sigma_1 (2.12); zero without flow
    rate_bending: sp.Expr
    tension_rate: sp.Expr  # T_t of (e_mean_t, T) and M_t of (y_XXt, M): what the above amount to (2.16)
    moment_rate: sp.Expr
    elastic_mean: sp.Expr  # Stored energy per unit material length, of sigma_0 and of sigma_1
    elastic_bending: sp.Expr
    dissipation_mean: sp.Expr  # Plastic power per unit material length, of sigma_0 and of sigma_1; zero without flow
    dissipation_bending: sp.Expr


def small_deflection(shape: Section, *, flows: bool) -> SmallDeflection:
    """The reduced filament of a section: a Maxwell fluid if it flows, else elastic.

    Only a flow rule linear in the stress leaves the axial plastic strain uniform: any other mixes sigma_1(X) into it.
    """
    fluidity = 1 / eta if flows else sp.Integer(0)
    inertia = form_factor(shape) * A0 * h0**2
    bending_weight = A0 * shape.zeta_squared
    return SmallDeflection(
        elongation=y_X**2 / 2,
        stress_mean=E * (e_mean - a_0) if flows else E * e_mean,
        stress_bending=-E * (h0 * y_XX / 2 + a_1) if flows else -E * h0 * y_XX / 2,
        tension=A0 * sigma_0,
        moment=A0 * h0 * shape.zeta_squared * sigma_1 / 2,
        vertical_force=T * y_X + M_X,
        acceleration=F_X / (rho * A0) - g,
        rate_mean=sigma_0 * fluidity,
        rate_bending=sigma_1 * fluidity,
        tension_rate=E * A0 * e_mean_t - E * fluidity * T,
        moment_rate=-E * inertia * y_XXt - E * fluidity * M,
        elastic_mean=A0 * sigma_0**2 / (2 * E),
        elastic_bending=bending_weight * sigma_1**2 / (2 * E),
        dissipation_mean=A0 * fluidity * sigma_0**2,
        dissipation_bending=bending_weight * fluidity * sigma_1**2,
    )


_y, _M, _T = y_of(X, t), M_of(X, t), T_of(t)
_tau = eta / E
_inertia = K_I * A0 * h0**2


def mean_elongation(time: sp.Symbol) -> sp.Expr:
    """Mean of y_X^2/2 over the span, of the half span of a symmetric filament (2.17)."""
    return 2 / L * sp.Integral(sp.Derivative(y_of(X, time), X) ** 2 / 2, (X, 0, L / 2))


def _faded(rate: sp.Expr, relaxation: sp.Expr, now: sp.Symbol, earlier: sp.Symbol) -> sp.Expr:
    """exp(-t/tau) int_0^t exp(t'/tau) rate(t') dt', the memory of a Maxwell fluid."""
    return sp.exp(-now / relaxation) * sp.Integral(sp.exp(earlier / relaxation) * rate, (earlier, 0, now))


MOMENTUM = Equation(
    "momentum across the span",
    rho * A0 * sp.Derivative(_y, t, t),
    _T * sp.Derivative(_y, X, X) + sp.Derivative(_M, X, X) - rho * A0 * g,
    "2.14",
)
UNIFORM_ELONGATION = Equation(
    "the same elongation everywhere, since the tension is uniform",
    sp.Derivative(_y, X) ** 2 / 2 + sp.Derivative(U_of(X, t), X),
    mean_elongation(t),
    "2.13, 2.14",
)
TENSION = Equation("tension", _T, E * A0 * (mean_elongation(t) - a_0_of(t)), "2.15")
BENDING_MOMENT = Equation(
    "bending moment", _M, -E * _inertia * (sp.Derivative(_y, X, X) + 2 * a_1_of(X, t) / h0), "2.15"
)
AXIAL_FLOW = Equation("axial flow", sp.Derivative(a_0_of(t), t), _T / (A0 * eta), "2.12")
BENDING_FLOW = Equation("bending flow", sp.Derivative(a_1_of(X, t), t), _M / (2 * K_I * A0 * h0 * eta), "2.12")
TENSION_RELAXES = Equation(
    "the tension relaxes", sp.Derivative(_T, t), E * A0 * sp.Derivative(mean_elongation(t), t) - _T / _tau, "2.16"
)
MOMENT_RELAXES = Equation(
    "the moment relaxes", sp.Derivative(_M, t), -E * _inertia * sp.Derivative(_y, X, X, t) - _M / _tau, "2.16"
)
TENSION_REMEMBERS = Equation(
    "tension as a memory of elongation",
    _T,
    E * A0 * _faded(sp.Derivative(mean_elongation(t_prime), t_prime), _tau, t, t_prime),
    "2.17",
)
MOMENT_REMEMBERS = Equation(
    "moment as a memory of curvature",
    _M,
    -E * _inertia * _faded(sp.Derivative(y_of(X, t_prime), X, X, t_prime), _tau, t, t_prime),
    "2.16",
)

_yb, _mb, _qb = y_bar(x_bar, t_star), m_bar(x_bar, t_star), q_bar(t_star)


def _elongation_bar(time: sp.Symbol) -> sp.Expr:
    return sp.Integral(sp.Derivative(y_bar(x_bar, time), x_bar) ** 2 / 2, (x_bar, 0, _half))


_load = (sp.Derivative(_yb, t_star, t_star) + 1) * tau_star / (2 * V)

REDUCED = Equation(
    "deflection with its two memories as states",
    -(delta**2) * K_I * _mb / 2 + sp.Derivative(_yb, x_bar, x_bar) * _qb,
    _load,
    "2.18, corrected",
)
BENDING_MEMORY = Equation(
    "bending memory", sp.Derivative(_mb, t_star), sp.Derivative(_yb, (x_bar, 4), t_star) - _mb / tau_star, "2.18"
)
STRETCHING_MEMORY = Equation(
    "stretching memory",
    sp.Derivative(_qb, t_star),
    sp.Derivative(_elongation_bar(t_star), t_star) - _qb / tau_star,
    "2.18",
)
REDUCED_WITH_INTEGRALS = Equation(
    "deflection with its two memories as integrals",
    -(delta**2)
    * K_I
    / 2
    * _faded(sp.Derivative(y_bar(x_bar, t_star_prime), (x_bar, 4), t_star_prime), tau_star, t_star, t_star_prime)
    + sp.Derivative(_yb, x_bar, x_bar)
    * _faded(sp.Derivative(_elongation_bar(t_star_prime), t_star_prime), tau_star, t_star, t_star_prime),
    _load,
    "2.18, corrected",
)


def _at(expression: sp.Expr, variable: sp.Symbol, value: sp.Expr) -> sp.Expr:
    return sp.Subs(expression, variable, value)


CLAMPED_HEIGHT = Equation("a clamp holds the height", y_bar(_half, t_star), sp.Integer(0), "2.19")
CLAMPED_SLOPE = Equation("a clamp holds the slope", _at(sp.Derivative(_yb, x_bar), x_bar, _half), sp.Integer(0), "2.19")
SYMMETRY_SLOPE = Equation(
    "no slope at midspan", _at(sp.Derivative(_yb, x_bar), x_bar, sp.Integer(0)), sp.Integer(0), "2.19"
)
STARTS_STRAIGHT = Equation("straight at first", y_bar(x_bar, 0), sp.Integer(0), "2.19")
STARTS_AT_REST = Equation(
    "at rest at first", _at(sp.Derivative(_yb, t_star), t_star, sp.Integer(0)), sp.Integer(0), "2.19"
)

EQUATIONS: tuple[Equation, ...] = tuple(stated for stated in [*globals().values()] if isinstance(stated, Equation))
