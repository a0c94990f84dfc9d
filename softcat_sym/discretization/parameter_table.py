"""The numbers that a filament is given: their symbols and units, by their names in a scene."""

from __future__ import annotations

from dataclasses import dataclass

from softcat_sym.discretization.parameters import REST_LENGTH
from softcat_sym.physics import symbols
from softcat_sym.physics.bulk import nu
from softcat_sym.physics.loads import surface_tension
from softcat_sym.physics.necking import aspect
from softcat_sym.physics.section_equations import FilamentEquations
from softcat_sym.physics.spatial import natural_twist


@dataclass(frozen=True, slots=True)
class Parameter:
    """A numeric input of the graph: its leaf name in the scene, its symbol and its unit."""

    name: str
    symbol: symbols.Symbol
    unit: str


CATALOGUE: tuple[Parameter, ...] = (
    Parameter(REST_LENGTH, symbols.L_0, "m"),
    Parameter("thickness", symbols.h0, "m"),
    Parameter("density", symbols.rho, "kg/m^3"),
    Parameter("gravity", symbols.g, "m/s^2"),
    Parameter("ramp", symbols.g_on, "s"),
    Parameter("youngs_modulus", symbols.E, "Pa"),
    Parameter("viscosity", symbols.eta, "Pa*s"),
    Parameter("solid_viscosity", symbols.eta_s, "Pa*s"),
    Parameter("yield_stress", symbols.sigma_Y, "Pa"),
    Parameter("poisson", nu, "1"),
    Parameter("curvature", symbols.kappa_0, "1/m"),
    Parameter("twist", natural_twist, "1/m"),
    Parameter("aspect", aspect, "1"),
    Parameter("surface_tension", surface_tension, "N/m"),
    Parameter("bath_density", symbols.rho_b, "kg/m^3"),
    Parameter("bath_viscosity", symbols.mu_b, "Pa*s"),
    Parameter("shake", symbols.a_g, "1"),
    Parameter("shake_frequency", symbols.f_g, "Hz"),
)


def symbols_of(equations: FilamentEquations) -> dict[str, symbols.Symbol]:
    """Symbols of all numbers that a filament of these equations may be given, by their names."""
    own = {one.name: one.symbol for one in equations.constants}
    return {row.name: row.symbol for row in CATALOGUE} | own
