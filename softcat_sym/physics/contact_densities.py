"""Contact of a filament with rigid bodies: penalty energy, normal damping, bond and Coulomb friction, as densities.

All are of a node's place and velocity, per unit of rest length. The penalty is so stiff that the filament sinks in by
the stated penetration under its own weight, k = q/d_p, over which it is smoothed, too.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace

import sympy as sp

from softcat_sym.physics.constitutive_laws import Constant
from softcat_sym.physics.densities import Densities
from softcat_sym.physics.symbols import A0, LENGTH, ONE, VISCOSITY, enter, g, h0, rho, x, x_t, y, y_t
from softcat_sym.physics.terms import Touch
from softcat_sym.scene.bodies import BODIES, body_number, overlap

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
