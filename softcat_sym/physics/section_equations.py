"""One section of the filament, assembled from the terms that the effects in force have picked.

:func:`derive` turns the terms into the expressions of one cell; the graph prints these same objects.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import sympy as sp

from softcat_sym.physics import hardening_rule, loads, sections, symbols
from softcat_sym.physics.bulk import nu
from softcat_sym.physics.clocks import Clock, curing_clock, natural_clock, structure_clock
from softcat_sym.physics.constitutive_laws import Constant, Law, law_of
from softcat_sym.physics.densities import Densities
from softcat_sym.physics.heat import Heat, heat_of, lateral_area
from softcat_sym.physics.kinematics import (
    LARGE_ROTATION,
    SMALL_SLOPE,
    SMALL_STRAIN,
    TRUE_STRAIN,
    InternalForce,
    Kinematics,
    StrainMeasure,
    internal_force,
)
from softcat_sym.physics.loads import SURFACES, Surface, surface_tension
from softcat_sym.physics.necking import NECKS, Neck, aspect
from softcat_sym.physics.polymer_chains import ChainResponse
from softcat_sym.physics.polymer_chains import respond as respond_chains
from softcat_sym.physics.reissner import ResolvedSection, resolve
from softcat_sym.physics.section_response import CLOSURES, SectionResponse, SectionShape, respond
from softcat_sym.physics.spatial import natural_twist
from softcat_sym.physics.surroundings import densities_of
from softcat_sym.physics.symbols import eta_s, g
from softcat_sym.physics.terms import Formulation, Rheology, Terms
from softcat_sym.scene.formula import parse_formula


@dataclass(frozen=True, slots=True)
class Parameter:
    """A number that a filament is given: its leaf name in the scene, its symbol and its unit."""

    name: str
    symbol: sp.Symbol
    unit: str


PARAMETERS: tuple[Parameter, ...] = (
    Parameter("rest_length", symbols.L_0, "m"),
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
"""Numbers that every filament may be given."""


@dataclass(frozen=True, slots=True)
class FilamentEquations:
    """The expressions of one cell of a filament: what the graph is printed from."""

    terms: Terms  # What the effects left
    shape: sections.Section  # Cross-section
    closure: str  # ``material`` or ``printed``
    centreline: Kinematics  # Stretch and turning
    strain: StrainMeasure  # Axial strain
    law: Law  # With the one flow rule of each branch that is in force
    densities: tuple[Densities, ...]  # Energies and Rayleigh potentials of place and tangent that effects add
    clocks: tuple[Clock, ...]  # What changes the constants of the material
    heat: Heat | None  # What the temperature of the filament follows, if it has one
    response: SectionResponse  # The section of the paper: no shear, a plastic strain linear through the thickness
    # The section point by point, where shear or fibres are in force; it then replaces `response`.
    resolved: ResolvedSection | None
    chains: ChainResponse | None  # Polymer chains of a fibre, if the law is made of them
    neck: Neck | None  # The gradient term, if in force
    surface: Surface | None  # Surface tension, if in force
    force: InternalForce  # Q t + N n of a filament that does not shear
    exchange: sp.Expr  # Lateral area over volume of the undeformed section, of the stretch

    @property
    def constants(self) -> tuple[Constant, ...]:
        """What the law asks the scene for, and what the densities and clocks of effects do."""
        of_densities = (one for density in self.densities for one in density.constants)
        of_clocks = (one for clock in self.clocks for one in clock.constants)
        of_heat = () if self.heat is None else self.heat.constants
        of_hardening = hardening_rule.CONSTANTS if self.terms.hardens else ()
        return (*self.law.constants, *of_densities, *of_clocks, *of_heat, *of_hardening)

    @property
    def symbols(self) -> dict[str, sp.Symbol]:
        """Symbols of all numbers that a filament may be given, by their names."""
        own = {one.name: one.symbol for one in self.constants}
        return {one.name: one.symbol for one in PARAMETERS} | own

    @property
    def formulation(self) -> Formulation:
        """What they are the equations of."""
        return Formulation(self.terms, self.shape.name, self.closure)

    @property
    def conserves_energy(self) -> bool:
        """Whether forces and stored energy belong together, so that the energy balance can be judged."""
        return self.formulation.conserves_energy

    @property
    def gravity(self) -> sp.Expr:
        """Gravity where it does not shake."""
        return loads.ramped_gravity() if self.terms.ramped else g

    @property
    def load(self) -> sp.Expr:
        """g(t): as it comes on, times its shaking."""
        return self.gravity * loads.shaking() if self.terms.shaken else self.gravity

    @property
    def load_rate(self) -> sp.Expr:
        """dg/dt by the product rule."""
        rate = loads.ramp_rate() if self.terms.ramped else sp.S.Zero
        if not self.terms.shaken:
            return rate
        return rate * loads.shaking() + self.gravity * loads.shaking_rate()


def law_named(rheology: Rheology) -> Law:
    """The law of the material with all that it has."""
    return law_of(
        rheology.name,
        modes=rheology.modes,
        formula=parse_formula(rheology.flow) if rheology.flow else None,
        yields=rheology.threshold,
        solvent=rheology.solvent,
    )


def law_in_force(terms: Terms, clocks: tuple[Clock, ...] = ()) -> Law:
    """The law with the flow rules and the viscous stress that the effects have left."""
    law = law_named(terms.law)
    growth = {modulus: rate for clock in clocks for modulus, rate in clock.grows}
    branches = tuple(
        replace(branch.in_force(flows=terms.flows, yields=terms.yields), growth=growth.get(branch.modulus))
        for branch in law.branches
    )
    own = law.viscosity if terms.viscous else None
    chains = None if law.chains is None else replace(law.chains, relaxes=terms.flows)
    viscosity = eta_s if terms.damped and own is None else own
    return replace(law, branches=branches, viscosity=viscosity, chains=chains)


def clocks_of(terms: Terms) -> tuple[Clock, ...]:
    """What changes the constants of the material while it hangs."""
    curing = (curing_clock(terms.curing, law_named(terms.law)),) if terms.curing else ()
    built = (structure_clock(terms.structure, linear=terms.builds_up_without_limit),) if terms.structure else ()
    natural = (natural_clock(terms.natural_strain),) if terms.natural_strain else ()
    return (*curing, *built, *natural)


def equations_of(formulation: Formulation) -> FilamentEquations:
    """The equations of a cell, derived once a process."""
    return derive(formulation.terms, sections.SECTIONS[formulation.section], formulation.closure)


@lru_cache(maxsize=64)
def derive(terms: Terms, shape: sections.Section, closure_name: str) -> FilamentEquations:
    """Assemble one cell."""
    if not terms.stretches:
        _refuse_stretching(terms)
    contraction = shape.contraction if terms.thins else sections.NONE
    strain, clocks = TRUE_STRAIN if terms.finite else SMALL_STRAIN, clocks_of(terms)
    centreline, law = LARGE_ROTATION if terms.large_rotation else SMALL_SLOPE, law_in_force(terms, clocks)
    closed = CLOSURES[closure_name](strain, contraction)
    outline = SectionShape(shape, contraction, strain, terms)
    resolved = None
    if terms.shear or terms.resolved:
        resolved = resolve(
            shape, law, shear=terms.shear, curved=terms.curved, shrinks=terms.shrinks, hardens=terms.hardens
        )
    elif terms.hardens:
        raise ValueError("backstress: only in a section that is resolved through its thickness")
    if law.chains is not None:
        if terms.shear:
            raise ValueError("chains have no shear here: their conformation is that along and across a fibre")
        if terms.bending and resolved is None:
            raise ValueError(
                "the stress of chains is not linear through the thickness: a section that bends is resolved"
            )
    return FilamentEquations(
        terms=terms,
        shape=shape,
        closure=closure_name,
        centreline=centreline,
        strain=strain,
        law=law,
        densities=densities_of(terms, shape.name),
        clocks=clocks,
        heat=None if terms.heat is None else heat_of(terms.heat, law),
        response=respond(outline, closed, law),
        resolved=resolved,
        chains=None if law.chains is None else respond_chains(shape, law.chains),
        neck=NECKS[shape.name] if terms.necking_gradient else None,
        surface=SURFACES[shape.name] if terms.surface_tension else None,
        force=internal_force(centreline, bending=terms.bending, stretches=terms.stretches),
        exchange=sp.S.Zero if terms.heat is None else lateral_area(shape, thins=terms.thins),
    )


def _refuse_stretching(terms: Terms) -> None:
    """Refuse what has no meaning in a filament that does not stretch."""
    if not terms.bending:
        raise ValueError("a filament that neither stretches nor bends carries no weight")
    present = {
        "finite strain": terms.finite,
        "large rotation": terms.large_rotation,
        "thinning": terms.thins,
        "shear": terms.shear,
        "a section resolved point by point": terms.resolved,
        "a necking gradient": terms.necking_gradient,
        "surface tension": terms.surface_tension,
    }
    if any(present.values()):
        found = ", ".join(name for name, there in present.items() if there)
        raise ValueError(f"{found}: only in a filament that stretches")
