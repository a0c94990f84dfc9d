"""What surrounds a filament, as densities: buoyancy, drag of a slender body or in cross-flow, and added mass.

Both laws of drag derive from a Rayleigh potential of the velocity along and across the tangent, so that their loss is
exact in the energy audit. The second holds the first as its limit.
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.physics.constitutive_laws import Constant
from softcat_sym.physics.contact_densities import densities_of_contact
from softcat_sym.physics.densities import Densities
from softcat_sym.physics.necking import aspect
from softcat_sym.physics.symbols import A0, L_0, g_t, h0, mu_b, rho_b, s, x_t, x_X, y, y_t, y_X
from softcat_sym.physics.terms import Terms

_DENSITY, _VISCOSITY = Constant("bath_density", rho_b), Constant("bath_viscosity", mu_b)

# Its mass counts for the weight only, not for the inertia; a point mass keeps its own weight.
BUOYANT = Densities("buoyancy", stored=-rho_b * A0 * g_t * y, constants=(_DENSITY,))

# Of a body of half the mean of thickness and width as radius; of an ellipse that is exact.
_slenderness = sp.log(8 * L_0 / (h0 * (1 + aspect)))
across = 4 * sp.pi * mu_b / (_slenderness - sp.Rational(1, 2))
along = 2 * sp.pi * mu_b / (_slenderness - sp.Rational(3, 2))
"""Force per length and velocity across and along a slender body (Cox 1970, Batchelor 1970)."""

_v_t = (x_X * x_t + y_X * y_t) / s
_v_n = (x_X * y_t - y_X * x_t) / s
_d = h0 * (1 + aspect) / 2 / sp.sqrt(s)

SLENDER = s * (along * _v_t**2 + across * _v_n**2) / 2

_inertial = sp.Abs(_v_n) ** 3 / 3
_slow = across**3 / (125 * rho_b * _d * mu_b**2)  # Speed below which the slender body's force is the larger one
_viscous = sp.Rational(30, 7) * (mu_b / (rho_b * _d)) ** sp.Rational(2, 3) * (_v_n**2 + _slow**2) ** sp.Rational(7, 6)
CROSS_FLOW = s * (along * _v_t**2 + rho_b * _d * (_inertial + _viscous)) / 2
"""Potential of (1/2) rho_b C_d d |v_n| v_n with C_d = 1 + 10 Re^(-2/3) (White 1991), and of a slender body along.

Of a Reynolds number near 0.1 it passes into the slender body across too: Re^(-2/3) alone would have no slope at rest.
"""

DRAGS = {
    name: Densities("drag", dissipation=law, constants=(_DENSITY, _VISCOSITY))
    for name, law in (("slender", SLENDER), ("cross-flow", CROSS_FLOW))
}

# Of a cylinder its own volume, whatever the stretch: rho_b A s = rho_b A_0. Of a rectangle pi D_0/(4 h_0) of it.
ADDED = {
    "circle": Densities("added-mass", kinetic=rho_b * A0 * _v_n**2 / 2, constants=(_DENSITY,)),
    "rectangle": Densities("added-mass", kinetic=sp.pi / 4 * aspect * rho_b * A0 * _v_n**2 / 2, constants=(_DENSITY,)),
}


def densities_of(terms: Terms, section: str) -> tuple[Densities, ...]:
    """All that effects add to a filament of this section."""
    buoyancy = (BUOYANT,) if terms.buoyant else ()
    drag = (DRAGS[terms.drag],) if terms.drag else ()
    added = (ADDED[section],) if terms.added_mass else ()
    contact = (one for touch in terms.touches for one in densities_of_contact(touch))
    return (*buoyancy, *drag, *added, *contact, *terms.densities)
