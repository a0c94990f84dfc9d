"""What surrounds a filament and what it touches, as densities: buoyancy, drag, added mass, contact with rigid bodies.

Both laws of drag derive from a Rayleigh potential of the velocity along and across the tangent, so that their loss is
exact in the energy audit. The second holds the first as its limit. A contact is a penalty energy with normal damping,
bond and Coulomb friction, of a node's place and velocity: so stiff that the filament sinks in by the stated penetration
under its own weight, k = q/d_p, over which it is smoothed, too.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace

import sympy as sp

from softcat_sym.physics.constitutive_laws import Constant
from softcat_sym.physics.densities import Densities
from softcat_sym.physics.necking import aspect
from softcat_sym.physics.symbols import (
    A0,
    L_0,
    LENGTH,
    ONE,
    VISCOSITY,
    enter,
    g,
    g_t,
    h0,
    mu_b,
    rho,
    rho_b,
    s,
    x,
    x_t,
    x_X,
    y,
    y_t,
    y_X,
)
from softcat_sym.physics.terms import Terms, Touch
from softcat_sym.scene.bodies import BODIES, body_number, overlap

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


_SOURCE, _SPEED = "Winkler 1867", (0, 1, -1)
_NUMBERS = {
    "penetration": ("d_p", LENGTH, "penetration under the own weight"),
    "bond": ("c_b", VISCOSITY, "bond along the surface"),
    "friction": (r"\mu_C", ONE, "coefficient of Coulomb friction"),
    "slip": ("v_s", _SPEED, "slip speed of the smoothed friction"),
    "speed": ("V_b", _SPEED, "velocity of the surface"),
}
"""What every body has beside its sizes: LaTeX, dimension, meaning."""


@cache
def constants_of(body: str) -> dict[str, sp.Symbol]:
    """Symbols of the numbers of a body, by their keys."""
    sizes = {key: (rf"\ell_{{{key}}}", LENGTH, f"size {key}") for key in BODIES[body].sizes}
    found = {}
    for key, (latex, dimension, meaning) in (sizes | _NUMBERS).items():
        name, positive = body_number(body, key), key in ("penetration", "slip")
        found[key] = enter(name, f"{latex}^{{{body}}}", dimension, meaning, _SOURCE, positive=positive)
    return found


@dataclass(frozen=True, slots=True)
class Contact:
    """Expressions of the contact with one body."""

    gap: sp.Expr  # Between the lower surface of the filament and the body
    energy: sp.Expr  # Phi [J/m]
    pressure: sp.Expr  # -dPhi/dgap [N/m]
    pressed: sp.Expr  # The same over the own weight: with it damping and bond grow, and have no jumps
    normal: sp.Expr  # Velocity along the outward normal of the body
    tangential: sp.Expr  # Velocity along its surface, relative to it


@cache
def contact_of(body: str) -> Contact:
    """Contact of a node with a body."""
    of = constants_of(body)
    gap = BODIES[body].clearance(SimpleNamespace(**of), x, y, h0, sp.sqrt)
    stiffness = rho * g * A0 / of["penetration"]
    energy, depth = overlap(gap, of["penetration"])
    n_x, n_y = sp.diff(gap, x), sp.diff(gap, y)
    slides = x_t - of["speed"]
    normal, tangential = n_x * slides + n_y * y_t, n_y * slides - n_x * y_t
    return Contact(gap, stiffness * energy, stiffness * depth, depth / of["penetration"], normal, tangential)


def densities_of_contact(touch: Touch) -> tuple[Densities, ...]:
    """What one body adds to the filament: an energy, and Rayleigh potentials of the velocity relative to it."""
    of, one = constants_of(touch.body), contact_of(touch.body)
    # Critical damping of the weight on the penalty, 2 sqrt(k rho A0).
    damping = 2 * rho * A0 * sp.sqrt(g / of["penetration"])
    sliding = of["friction"] * one.pressure * (sp.sqrt(one.tangential**2 + of["slip"] ** 2) - of["slip"])
    parts = {
        "contact": (True, {"stored": one.energy}),
        "contact-damping": (touch.resists, {"dissipation": damping * one.pressed * one.normal**2 / 2}),
        "bond": (touch.resists and touch.bond, {"dissipation": of["bond"] * one.pressed * one.tangential**2 / 2}),
        "friction": (touch.resists and touch.friction, {"dissipation": sliding}),
    }
    carried = of["speed"] if touch.moves else sp.S.Zero
    found = []
    for name, given in ((name, given) for name, (present, given) in parts.items() if present):
        stated = {key: value if touch.moves else value.subs(of["speed"], 0) for key, value in given.items()}
        used = set().union(carried.free_symbols, *(value.free_symbols for value in stated.values()))
        constants = tuple(Constant(body_number(touch.body, key), one) for key, one in of.items() if one in used)
        found.append(Densities(name, constants=constants, carried=carried, **stated))
    return tuple(found)


def densities_of(terms: Terms, section: str) -> tuple[Densities, ...]:
    """All that effects add to a filament of this section."""
    buoyancy = (BUOYANT,) if terms.buoyant else ()
    drag = (DRAGS[terms.drag],) if terms.drag else ()
    added = (ADDED[section],) if terms.added_mass else ()
    contact = (one for touch in terms.touches for one in densities_of_contact(touch))
    return (*buoyancy, *drag, *added, *contact, *terms.densities)
