"""Regimes of a yield-stress filament: no yield, arrested descent, continual descent (3.9)-(3.14).

First yield is a beam's, arrest is a catenary's. Both are kept in the paper's approximation and in the exact one.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics import beams
from softcat_sym.physics.equation import Equation
from softcat_sym.physics.sections import CIRCLE, RECTANGLE, Section
from softcat_sym.physics.symbols import LENGTH, ONE, STRESS, E, L, c, enter, eta, g, h0, rho, sigma_Y

Rational = sp.Rational

delta = enter("delta", r"\delta", ONE, "slenderness h_0/L", "3.9", positive=True)
eps_Y = enter("eps_Y", r"\epsilon_Y", ONE, "yield strain sigma_Y/E", "3.9", positive=True)
G = enter("G", "G", ONE, "gravity number rho g L/sigma_Y", "3.10", positive=True)
Gam_s = enter("Gam_s", r"\Gamma_s", STRESS, "pull of the surface over the area, gamma P/(2 A)", "Eggers & Dupont 1994")
V = enter("V", "V", ONE, "viscous number eta/(rho sqrt(g L^3))", "3.10", positive=True)
E_star = enter("E_star", "E^*", ONE, "modulus over weight E/(rho g L)", "THEORY 5", positive=True)
tau_star = enter("tau_star", r"\tau^*", ONE, "relaxation time eta/E in units of sqrt(L/g)", "2.18", positive=True)
H = enter("H", "H", LENGTH, "sag of the midpoint", "section 3.2", positive=True)
H_stop = enter("H_stop", r"H_{stop}", LENGTH, "sag at which plastic descent stops", "3.13", positive=True)
a_c = enter("a_c", "a", LENGTH, "catenary parameter: horizontal tension over weight per length", "3.12", positive=True)
u_L = enter("u_L", "u", ONE, "half span over catenary parameter, L/(2a)", "3.12", positive=True)
sigma_max = enter("sigma_max", r"\sigma_{max}", STRESS, "largest tensile stress of a catenary", "3.12", positive=True)
psi_T = enter("psi_T", r"\psi", ONE, "(L/2) sqrt(T/(E I)): how far tension carries a beam", "3.11", positive=True)
K_I = enter("K_I", "K", ONE, "form factor of the section, I = K A h^2", "2.18", positive=True)
k_on = enter("k_on", r"\omega g_{on}", ONE, "frequency of a mode times the ramp of gravity", "section 3", positive=True)


@dataclass(frozen=True, slots=True)
class Beam:
    """A straight beam of span L under its own weight q per length, by the way its ends are held."""

    largest_moment: sp.Expr  # Largest static bending moment over q L^2
    midspan_sag: sp.Expr  # Static elastic sag at midspan over q L^4/(E I)
    # Bound on the largest moment over the static one, when the weight is applied at once and no mode is damped: the
    # moment that all modes add up to when all are at their worst.
    overshoot_bound: sp.Expr
    collapse: sp.Expr  # q L^2 over the fully plastic moment when enough hinges have formed for the beam to give way
    # Share of the largest static moment that a steady tension, such as that of the surface, leaves; of psi.
    relief: sp.Expr = sp.S.One


CLAMPED = Beam(Rational(1, 12), Rational(1, 384), sp.Integer(2), sp.Integer(16), beams.clamped_relief(psi_T, sp))
PROPPED = Beam(Rational(1, 8), Rational(1, 192), sp.Integer(2), 6 + 4 * sp.sqrt(2), beams.propped_relief(psi_T, sp))
PINNED = Beam(
    Rational(1, 8), Rational(5, 384), 1 + 28 * sp.zeta(3) / sp.pi**3, sp.Integer(8), beams.pinned_relief(psi_T, sp)
)

CANTILEVER = Beam(Rational(1, 2), Rational(17, 384), sp.Integer(2), sp.Integer(2))
"""One end clamped, the other free; the sag is that of the middle."""

BEAMS: dict[tuple[str, str], Beam] = {
    ("clamped", "clamped"): CLAMPED,
    ("clamped", "pinned"): PROPPED,
    ("pinned", "pinned"): PINNED,
}
NAMED: dict[str, Beam] = {"clamped": CLAMPED, "propped": PROPPED, "pinned": PINNED, "cantilever": CANTILEVER}
"""By the names that they have in numbers."""


def gyration(section: Section) -> sp.Expr:
    """K = I/(A h_0^2) = <zeta^2>/4: 1/12 for a rectangle, 1/16 for a circle (before 2.18)."""
    return section.zeta_squared / 4


def first_yield(section: Section, beam: Beam = CLAMPED) -> sp.Expr:
    """G at which the most stressed fibre yields under a slowly applied weight (3.11): 2 delta, rectangle in clamps.

    Linear beam: right while the sag is well below the thickness, that is for eps_Y well below 16 delta^2; beyond it
    see :func:`first_yield_stretched`.
    """
    return 2 * gyration(section) * delta / beam.largest_moment


def first_yield_at_once(section: Section, beam: Beam = CLAMPED) -> sp.Expr:
    """G below which no fibre ever yields although the weight is applied at once, however long the beam rings."""
    return first_yield(section, beam) / beam.overshoot_bound


def ramp_gain() -> sp.Expr:
    """Share of a mode's ringing that is left when gravity is switched on by the quintic step, of omega g_on.

    Magnitude of the Fourier transform of the ramp's rate: 1 for a sudden load, 0 for a slow one; signed.
    """
    gain: sp.Expr = beams.ramp_gain(k_on, sp)
    return gain


def plastic_collapse(section: Section, beam: Beam = CLAMPED) -> sp.Expr:
    """G at which a straight perfectly plastic beam turns into a mechanism: 4 delta for a clamped rectangle.

    Fully plastic moment M_p = sigma_Y A (h_0/2) <|zeta|>. Between first yield and collapse some fibres flow, and stop
    without any help from the sag.
    """
    mean_lever = 2 * section.overstress_mean.subs(c, 0)
    return beam.collapse * mean_lever * delta / 2


@dataclass(frozen=True, slots=True)
class FirstYieldCurve:
    """First yield of a clamped filament whose tension helps to carry it, along the parameter psi."""

    yield_strain: sp.Expr
    gravity_number: sp.Expr


def first_yield_stretched(section: Section) -> FirstYieldCurve:
    """(eps_Y, G) at first yield with bending and stretching in the balance; clamped ends, small slopes and strains.

    psi -> 0 is the linear beam (3.11); psi -> infinity a taut string with sharply bent ends, G ~ sqrt(eps_Y). Between
    them G dips by a per cent before it rises: the first tension adds more stress than it takes from the bending.
    """
    return FirstYieldCurve(*beams.stretched_first_yield(psi_T, gyration(section), delta, sp))


# The catenary y = a (cosh(x/a) - cosh(L/2a)) between level supports; u = L/(2a).
CATENARY_SAG = Equation("sag of a catenary", H, L * (sp.cosh(u_L) - 1) / (2 * u_L), "before 3.12")
CATENARY_STRESS = Equation(
    "largest stress of a catenary", sigma_max, rho * g * L * sp.cosh(u_L) / (2 * u_L), "before 3.12"
)
STRESS_AND_SAG = Equation("stress of a catenary by its sag", sigma_max, rho * g * (H + a_c), "before 3.12")

SHALLOW_PARAMETER = Equation("parameter of a shallow catenary", a_c, L**2 / (8 * H), "before 3.12")
SHALLOW_STRESS = Equation("stress of a shallow catenary", sigma_max, rho * g * (H + L**2 / (8 * H)), "before 3.12")
SHALLOW_STRESS_SECOND = Equation(
    "stress of a shallow catenary, every term of first order in H",
    sigma_max,
    rho * g * (Rational(7, 6) * H + L**2 / (8 * H)),
    "before 3.12, consistently",
)

ARREST_THRESHOLD = sp.sqrt(2)
"""G above which the shallow catenary of the paper finds no sag to rest at (3.12)."""

ARREST_THRESHOLD_SECOND = sp.sqrt(Rational(12, 7))
"""The same from :data:`SHALLOW_STRESS_SECOND`: 1.309."""

ARREST_CONDITION = Equation("lightest stressed catenary", u_L * sp.tanh(u_L), sp.Integer(1), "3.12, exact")
ARREST_THRESHOLD_EXACT = Equation("arrest threshold", G, 2 * sp.sqrt(u_L**2 - 1), "3.12, exact")
"""With u the root of :data:`ARREST_CONDITION`: 1.3255, twice the Laplace limit constant."""

STOPPING_DEPTH = Equation(
    "stopping depth", H_stop / L, 1 / (2 * G) - sp.sqrt((1 / (2 * G)) ** 2 - Rational(1, 8)), "3.13"
)
STOPPING_DEPTH_SECOND = Equation(
    "stopping depth, every term of first order in H",
    H_stop / L,
    Rational(3, 7) * (1 / G - sp.sqrt(1 / G**2 - Rational(7, 12))),
    "3.13, consistently",
)
STOPPING_CATENARY = Equation(
    "catenary at rest: its largest stress is the yield stress", G * sp.cosh(u_L), 2 * u_L, "3.13, exact"
)
"""Smaller root u of this, then :data:`CATENARY_SAG`: the exact stopping depth."""


def no_yield(section: Section = RECTANGLE, beam: Beam = CLAMPED) -> sp.Basic:
    """(3.11): no fibre yields."""
    return sp.Lt(G, first_yield(section, beam))


def arrested(section: Section = RECTANGLE, beam: Beam = CLAMPED) -> sp.Basic:
    """(3.12): fibres yield, and the filament comes to rest."""
    return sp.And(sp.Ge(G, first_yield(section, beam)), sp.Lt(G, ARREST_THRESHOLD))


def descending(section: Section = RECTANGLE, beam: Beam = CLAMPED) -> sp.Basic:
    """(3.14): the filament descends for ever."""
    return sp.And(sp.Ge(G, first_yield(section, beam)), sp.Ge(G, ARREST_THRESHOLD))


def arrest_parameter(digits: int = 20) -> sp.Float:
    """The root u of u tanh u = 1."""
    return sp.nsolve(ARREST_CONDITION.residual(), u_L, Rational(6, 5), prec=digits + 5).n(digits)


def arrest_threshold_exact(digits: int = 20) -> sp.Float:
    """G above which no catenary can be held: 1.3255."""
    return ARREST_THRESHOLD_EXACT.right.subs(u_L, arrest_parameter(digits + 5)).n(digits)


def stopping_depth_exact(gravity_number: sp.Expr | float, digits: int = 15) -> sp.Float:
    """H_stop/L of the exact catenary."""
    threshold = arrest_threshold_exact(digits)
    if not 0 < gravity_number < threshold:
        raise ValueError(
            f"no catenary is held at G = {gravity_number}: it must lie between 0 and {float(threshold):.4f}"
        )
    held = STOPPING_CATENARY.residual().subs(G, gravity_number)
    root = sp.nsolve(held, u_L, (0, arrest_parameter(digits + 5)), solver="anderson", prec=digits + 5)
    return (CATENARY_SAG.right / L).subs(u_L, root).n(digits)


GROUPS = (
    Equation("slenderness", delta, h0 / L, "3.9"),
    Equation("yield strain", eps_Y, sigma_Y / E, "3.9"),
    Equation("gravity number", G, rho * g * L / sigma_Y, "3.10"),
    Equation("viscous number", V, eta / (rho * sp.sqrt(g * L**3)), "3.10"),
    Equation("modulus over weight", E_star, E / (rho * g * L), "THEORY 5"),
    Equation("relaxation time", tau_star, eta / (E * sp.sqrt(L / g)), "2.18"),
    Equation("modulus over weight by the groups of yield", E_star, 1 / (G * eps_Y), "THEORY 5"),
    Equation("relaxation time by the groups", tau_star, V / E_star, "THEORY 5"),
)

FIRST_YIELD = tuple(
    Equation(f"first yield, {section.name}, {' and '.join(ends)} ends", G, first_yield(section, beam), "3.11")
    for section in (RECTANGLE, CIRCLE)
    for ends, beam in BEAMS.items()
)

EQUATIONS: tuple[Equation, ...] = (
    *GROUPS,
    Equation("gravity number with surface tension", G, rho * g * L / (sigma_Y + Gam_s), "3.10, Eggers & Dupont 1994"),
    *FIRST_YIELD,
    CATENARY_SAG,
    CATENARY_STRESS,
    STRESS_AND_SAG,
    SHALLOW_PARAMETER,
    SHALLOW_STRESS,
    SHALLOW_STRESS_SECOND,
    ARREST_CONDITION,
    ARREST_THRESHOLD_EXACT,
    STOPPING_DEPTH,
    STOPPING_DEPTH_SECOND,
    STOPPING_CATENARY,
)
