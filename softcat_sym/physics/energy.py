"""Energy of the continuum filament: what the forces do is kinetic energy, stored energy, or dissipated (THEORY 4).

Per unit material length, in fields of (X, t); the means are over the section.
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.physics import kinematics
from softcat_sym.physics.closures import flow_rule
from softcat_sym.physics.equation import Equation
from softcat_sym.physics.kinematics import mass_per_length
from softcat_sym.physics.symbols import A0, FORCE, ONE, STRESS, E, X, enter_field, g, t, zeta

_FORCE_RATE = (1, 1, -3)
_at_end = (zeta, X, t)

stored = enter_field("stored_energy", "W", FORCE, "elastic energy per unit material length", "THEORY 4")(X, t)
dissipated = enter_field("dissipation", r"\mathcal{D}", _FORCE_RATE, "plastic power per unit X", "THEORY 4")(X, t)
stress = enter_field("fibre_stress", r"\sigma", STRESS, "axial stress of the fibre zeta", "2.8")(*_at_end)
strain = enter_field("fibre_true_strain", r"\epsilon", ONE, "axial true strain of the fibre zeta", "2.6")(*_at_end)
weight = enter_field("relative_width", "w", ONE, "relative width of the section, its integral one", "A 1")(zeta)


def _mean(of: sp.Expr) -> sp.Integral:
    return sp.Integral(of * weight, (zeta, -1, 1))


def kinetic() -> sp.Expr:
    """Kinetic energy per unit material length, lambda_0 |v|^2/2."""
    return mass_per_length() * (sp.Derivative(kinematics.x, t) ** 2 + sp.Derivative(kinematics.y, t) ** 2) / 2


def flux() -> sp.Expr:
    """Power F.v - M theta_t that the filament ahead of a section exerts on the part behind it.

    It vanishes at a clamp, a pin, a free end and a plane of symmetry.
    """
    force = kinematics.internal_force_field()
    through = force[0] * sp.Derivative(kinematics.x, t) + force[1] * sp.Derivative(kinematics.y, t)
    return through - kinematics.moment * sp.Derivative(kinematics.angle, t)


def stress_power() -> sp.Expr:
    """Q s_t - M theta_Xt, what the section forces do on the stretch and the turning of a unit of material length."""
    return kinematics.axial_force * sp.Derivative(kinematics.stretch, t) - kinematics.moment * sp.Derivative(
        kinematics.angle, X, t
    )


BALANCE = Equation(
    "energy",
    sp.Derivative(kinetic() + stored, t) + dissipated,
    sp.Derivative(flux(), X) - mass_per_length() * g * sp.Derivative(kinematics.y, t),
    "THEORY 4",
)
CONJUGACY = Equation("work conjugacy", stress_power(), A0 * _mean(stress * sp.Derivative(strain, t)), "THEORY 4")
STORED = Equation("stored energy", stored, A0 / (2 * E) * _mean(stress**2), "THEORY 4")
DISSIPATED = Equation("dissipation", dissipated, A0 * _mean(stress * flow_rule(stress)), "THEORY 4")

ENERGY_EQUATIONS: tuple[Equation, ...] = (BALANCE, CONJUGACY, STORED, DISSIPATED)
