"""Groups of a filament and catenaries as expressions (3.9)-(3.14); its beams are those of :mod:`.beams`."""

from __future__ import annotations

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.sections import Section
from softcat_sym.physics.symbols import LENGTH, ONE, STRESS, L, enter, g, rho

delta = enter("delta", r"\delta", ONE, "slenderness h_0/L", "3.9", positive=True)
V = enter("V", "V", ONE, "viscous number eta/(rho sqrt(g L^3))", "3.10", positive=True)
E_star = enter("E_star", "E^*", ONE, "modulus over weight E/(rho g L)", "THEORY 5", positive=True)
tau_star = enter("tau_star", r"\tau^*", ONE, "relaxation time eta/E in units of sqrt(L/g)", "2.18", positive=True)
H = enter("H", "H", LENGTH, "sag of the midpoint", "section 3.2", positive=True)
u_L = enter("u_L", "u", ONE, "half span over catenary parameter, L/(2a)", "3.12", positive=True)
sigma_max = enter("sigma_max", r"\sigma_{max}", STRESS, "largest tensile stress of a catenary", "3.12", positive=True)
psi_T = enter("psi_T", r"\psi", ONE, "(L/2) sqrt(T/(E I)): how far tension carries a beam", "3.11", positive=True)
K_I = enter("K_I", "K", ONE, "form factor of the section, I = K A h^2", "2.18", positive=True)


def gyration(section: Section) -> sp.Expr:
    """K = I/(A h_0^2) = <zeta^2>/4: 1/12 for a rectangle, 1/16 for a circle (before 2.18)."""
    return section.zeta_squared / 4


# The catenary y = a (cosh(x/a) - cosh(L/2a)) between level supports; u = L/(2a).
CATENARY_SAG = Equation("sag of a catenary", H, L * (sp.cosh(u_L) - 1) / (2 * u_L), "before 3.12")
SHALLOW_STRESS = Equation("stress of a shallow catenary", sigma_max, rho * g * (H + L**2 / (8 * H)), "before 3.12")
