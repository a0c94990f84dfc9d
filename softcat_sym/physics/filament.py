"""One section of the filament, assembled from the terms that the effects in force have picked.

:class:`Terms` starts with nothing: an elastic filament at small slope and strain that neither stretches nor bends,
without inertia, under gravity switched on at once. Each effect replaces what it is responsible for. :func:`derive`
turns the terms into the expressions of one cell; the graph prints these same objects.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import lru_cache

import sympy as sp

from softcat_sym.physics import backstress, kinematics, sections
from softcat_sym.physics import closures as closure
from softcat_sym.physics.clocks import Clock
from softcat_sym.physics.conformation import ChainResponse
from softcat_sym.physics.conformation import respond as respond_chains
from softcat_sym.physics.densities import Densities
from softcat_sym.physics.heat import Heat, lateral_area
from softcat_sym.physics.kinematics import InternalForce, internal_force
from softcat_sym.physics.laws import ELASTIC, Constant, Law
from softcat_sym.physics.loads import SURFACES, Surface
from softcat_sym.physics.necking import NECKS, Neck
from softcat_sym.physics.reissner import ResolvedSection, resolve
from softcat_sym.physics.section_response import SectionResponse, Shape, respond
from softcat_sym.physics.symbols import eta_s, g, s, t


@dataclass(frozen=True, slots=True)
class Terms:
    """What the equations are made of; every field has the value of the barest filament."""

    centreline: kinematics.Kinematics = kinematics.SMALL_SLOPE  # Stretch and turning
    strain: kinematics.StrainMeasure = kinematics.SMALL_STRAIN  # Axial strain
    thins: bool = False  # Whether the section shrinks as its shape does
    inertia: bool = False  # Whether momentum and moment are in the balance
    bending: bool = False
    # Whether the filament stretches; otherwise it is a beam of small slope with no other unknown than its height.
    stretches: bool = False
    law: Law = ELASTIC  # The law of the material, of which the effects pick what is in force
    # Whether its branches flow, whether they do so only beyond the yield stress, and whether its viscous stress acts.
    flows: bool = False
    yields: bool = False
    viscous: bool = False
    damped: bool = False  # Whether a viscous stress acts beside a law that has none of its own
    curved: bool = False  # Whether the relaxed filament is curved
    shear: bool = False  # Whether the section turns by itself, and whether it takes a moment to turn it faster
    rotary_inertia: bool = False
    resolved: bool = False  # Whether the plastic strain has any profile through the thickness, instead of a linear one
    necking_gradient: bool = False  # Whether a neck's slope stiffens it
    surface_tension: bool = False  # Whether the energy of the surface pulls the filament together
    densities: tuple[Densities, ...] = ()  # Energies and Rayleigh potentials of place and tangent that effects add
    clocks: tuple[Clock, ...] = ()  # What changes the constants of the material
    heat: Heat | None = None  # What the temperature of the filament follows, if it has one
    shrinks: bool = False  # Whether the material is without stress at another strain as time goes on
    # Whether flow hardens kinematically; not in its representation, as for shaking below.
    hardens: bool = field(default=False, repr=False)
    gravity: sp.Expr = g  # Gravity and its rate where it does not shake
    gravity_rate: sp.Expr = sp.S.Zero
    # Not in its representation, from which a structure has its name: one that does not shake keeps it.
    shaking: sp.Expr = field(default=sp.S.One, repr=False)  # Factor by which it shakes, and the rate of that
    shaking_rate: sp.Expr = field(default=sp.S.Zero, repr=False)

    @property
    def finite(self) -> bool:
        """Whether the strain is that of finite stretch."""
        return self.strain is not kinematics.SMALL_STRAIN

    @property
    def ramped(self) -> bool:
        """Whether gravity is switched on over a time."""
        return bool(self.gravity.has(t))

    @property
    def turns(self) -> bool:
        """Whether the angle of a section is an unknown of its own."""
        return self.shear or self.resolved

    @property
    def resists(self) -> bool:
        """Whether a stress or a force depends on the velocities."""
        return self.viscous or self.drags

    @property
    def integrates(self) -> bool:
        """Whether the filament is carried through time, rather than from equilibrium to equilibrium."""
        return self.inertia or self.flows or self.resists or self.grows or self.heat is not None

    @property
    def grows(self) -> bool:
        """Whether springs without stress join those that there are, so that every branch remembers its strain."""
        return any(clock.grows for clock in self.clocks)

    @property
    def drags(self) -> bool:
        """Whether something resists the motion of the centreline itself."""
        return any(one.dissipation != 0 for one in self.densities)

    @property
    def adds_mass(self) -> bool:
        """Whether something that moves with the filament has a kinetic energy of its own."""
        return any(one.kinetic != 0 for one in self.densities)

    @property
    def load(self) -> sp.Expr:
        """g(t): as it comes on, times its shaking."""
        return self.gravity * self.shaking

    @property
    def load_rate(self) -> sp.Expr:
        """dg/dt by the product rule."""
        return self.gravity_rate * self.shaking + self.gravity * self.shaking_rate

    def law_in_force(self) -> Law:
        """The law with the flow rules and the viscous stress that the effects have left."""
        growth = {modulus: rate for clock in self.clocks for modulus, rate in clock.grows}
        branches = tuple(
            replace(branch.in_force(flows=self.flows, yields=self.yields), growth=growth.get(branch.modulus))
            for branch in self.law.branches
        )
        own = self.law.viscosity if self.viscous else None
        chains = None if self.law.chains is None else replace(self.law.chains, relaxes=self.flows)
        viscosity = eta_s if self.damped and own is None else own
        return replace(self.law, branches=branches, viscosity=viscosity, chains=chains)


@dataclass(frozen=True, slots=True)
class FilamentEquations:
    """The expressions of one cell of a filament: what the graph is printed from."""

    terms: Terms  # What the effects left
    shape: sections.Section  # Cross-section
    closure: str  # ``material`` or ``printed``
    law: Law  # With the one flow rule of each branch that is in force
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
        of_densities = (one for density in self.terms.densities for one in density.constants)
        of_clocks = (one for clock in self.terms.clocks for one in clock.constants)
        of_heat = () if self.terms.heat is None else self.terms.heat.constants
        of_hardening = backstress.CONSTANTS if self.terms.hardens else ()
        return (*self.law.constants, *of_densities, *of_clocks, *of_heat, *of_hardening)

    @property
    def conserves_energy(self) -> bool:
        """Whether forces and stored energy belong together, so that the energy balance can be judged."""
        return self.closure == "material" and s not in self.response.volume.free_symbols


@lru_cache(maxsize=64)
def derive(terms: Terms, shape: sections.Section, closure_name: str) -> FilamentEquations:
    """Assemble one cell."""
    if not terms.stretches:
        _refuse_stretching(terms)
    contraction = shape.contraction if terms.thins else sections.NONE
    law = terms.law_in_force()
    closed = closure.CLOSURES[closure_name](terms.strain, contraction)
    outline = Shape(
        shape,
        contraction,
        terms.strain,
        bends=terms.bending,
        stretches=terms.stretches,
        curved=terms.curved,
        shrinks=terms.shrinks,
    )
    resolved = None
    if terms.shear or terms.resolved:
        resolved = resolve(
            shape, law, shear=terms.shear, curved=terms.curved, shrinks=terms.shrinks, hardens=terms.hardens
        )
    elif terms.hardens:
        raise ValueError("backstress: only in a section that is resolved through its thickness")
    if law.chains is not None:
        _refuse_chains(terms, resolved)
    return FilamentEquations(
        terms=terms,
        shape=shape,
        closure=closure_name,
        law=law,
        response=respond(outline, closed, law),
        resolved=resolved,
        chains=None if law.chains is None else respond_chains(shape, law.chains),
        neck=NECKS[shape.name] if terms.necking_gradient else None,
        surface=SURFACES[shape.name] if terms.surface_tension else None,
        force=internal_force(terms.centreline, bending=terms.bending, stretches=terms.stretches),
        exchange=lateral_area(shape, thins=terms.thins),
    )


def _refuse_chains(terms: Terms, resolved: ResolvedSection | None) -> None:
    """Refuse a section of which the stress of chains is not known."""
    if terms.shear:
        raise ValueError("chains have no shear here: their conformation is that along and across a fibre")
    if terms.bending and resolved is None:
        raise ValueError("the stress of chains is not linear through the thickness: a section that bends is resolved")


def _refuse_stretching(terms: Terms) -> None:
    """Refuse what has no meaning in a filament that does not stretch."""
    if not terms.bending:
        raise ValueError("a filament that neither stretches nor bends carries no weight")
    present = {
        "finite strain": terms.finite,
        "large rotation": terms.centreline is not kinematics.SMALL_SLOPE,
        "thinning": terms.thins,
        "shear": terms.shear,
        "a section resolved point by point": terms.resolved,
        "a necking gradient": terms.necking_gradient,
        "surface tension": terms.surface_tension,
    }
    if any(present.values()):
        found = ", ".join(name for name, there in present.items() if there)
        raise ValueError(f"{found}: only in a filament that stretches")
