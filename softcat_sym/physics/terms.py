"""What the equations of a filament are made of, in names and flags: known without SymPy, and hashed.

:class:`Terms` starts with nothing: an elastic filament at small slope and strain that neither stretches nor bends,
without inertia, under gravity switched on at once. Each effect replaces what it is responsible for.
:func:`softcat_sym.physics.section_equations.derive` makes expressions of it; a run whose C is there asks for none.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from softcat_sym.physics.cross_sections import CROSS_SECTIONS
from softcat_sym.scene.history import History
from softcat_sym.scene.laws import LAWS, LawSpec

if TYPE_CHECKING:
    from softcat_sym.physics.densities import Densities


@dataclass(frozen=True, slots=True)
class Rheology:
    """A constitutive law by its name, and what its equations depend on besides."""

    name: str = "elastic"  # As in the scene
    modes: int = 0  # Of ``multimode-maxwell``
    flow: str = ""  # Formula of ``custom``
    threshold: bool = False  # Whether the rule of ``custom`` is zero up to the yield stress
    solvent: bool = True  # Whether a viscous solvent is beside polymer chains

    @property
    def spec(self) -> LawSpec:
        """Properties of the law."""
        return LAWS[self.name]

    @property
    def yields(self) -> bool:
        """Whether it has a yield stress."""
        return self.threshold or self.spec.yields

    @property
    def is_viscous(self) -> bool:
        """Whether it has a stress proportional to the rate of strain."""
        return bool(self.spec.viscous_stress) and (self.solvent or not self.spec.has_chains)


@dataclass(frozen=True, slots=True)
class Course:
    """Form of a quantity that changes in time: a table of so many rows, or a formula of so many numbers."""

    name: str  # What its numbers are named by, such as ``yield_stress``
    rows: int = 0
    formula: str = ""
    numbers: int = 0

    @classmethod
    def of(cls, name: str, history: History) -> Course:
        """The form of a history."""
        formula = history.formula
        if formula is None:
            return cls(name, rows=len(history.table))
        return cls(name, formula=formula.text, numbers=len(history.numbers))


@dataclass(frozen=True, slots=True)
class Warming:
    """What the balance of heat of a filament with a temperature is made of."""

    law: str = "constant"  # Of the viscosity
    by_reference: bool = False  # Whether VFT is one at the reference temperature
    exchange: str = ""  # ``coefficient``, or the name of a correlation; empty if nothing passes the surface
    ambient: Course | None = None  # Of the surroundings, where that changes
    modulus: Course | None = None  # Of the modulus with the temperature, where that changes
    conducts: bool = False  # Along the filament
    expands: bool = False
    partial: bool = False  # Whether a part only is in the furnace
    freezes: bool = False  # Whether some of it cools below where the law of the viscosity ends


@dataclass(frozen=True, slots=True)
class Touch:
    """How a filament touches a body."""

    body: str  # Name of its table in the scene
    bond: bool  # Whether a bond, and whether friction resists sliding
    friction: bool
    moves: bool  # Whether the surface of the body moves
    resists: bool  # Whether what depends on velocities acts: damping, bond and friction


@dataclass(frozen=True, slots=True)
class Terms:
    """What the equations are made of; every field has the value of the barest filament."""

    large_rotation: bool = False  # Whether stretch and turning are exact
    finite: bool = False  # Whether the strain is that of finite stretch
    thins: bool = False  # Whether the section shrinks as its shape does
    inertia: bool = False  # Whether momentum and moment are in the balance
    bending: bool = False
    # Whether the filament stretches; otherwise it is a beam of small slope with no other unknown than its height.
    stretches: bool = False
    law: Rheology = Rheology()  # The law of the material, of which the effects pick what is in force
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
    ramped: bool = False  # Whether gravity is switched on over a time, and whether it oscillates
    shaken: bool = False
    buoyant: bool = False  # Whether what surrounds the filament carries it, resists it and moves with it
    drag: Literal["", "slender", "cross-flow"] = ""
    added_mass: bool = False
    touches: tuple[Touch, ...] = ()  # Bodies on which the filament may come to lie
    densities: tuple[Densities, ...] = ()  # Energies and Rayleigh potentials of effects from outside the package
    curing: tuple[Course, ...] = ()  # Constants of the material that change in time
    structure: tuple[str, ...] = ()  # What a scene states of a structure that flow breaks; empty without
    builds_up_without_limit: bool = False
    hardens: bool = False  # Whether flow hardens kinematically
    natural_strain: tuple[Course, ...] = ()  # Strains without stress that change in time
    laid: bool = False  # Whether it comes out of a nozzle while it hangs
    heat: Warming | None = None  # What the temperature of the filament follows, if it has one

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
        return self.inertia or self.flows or self.resists or self.grows or self.laid or self.heat is not None

    @property
    def grows(self) -> bool:
        """Whether springs without stress join those that there are, so that every branch remembers its strain."""
        return self.law.spec.has_springs and any(one.name.endswith("modulus") for one in self.curing)

    @property
    def changes_in_time(self) -> bool:
        """Whether load or material go on changing by themselves, after a ramp and the motion of a support."""
        forces = bool(self.densities) or self.heat is not None
        return self.shaken or forces or bool(self.curing or self.structure or self.natural_strain)

    @property
    def shrinks(self) -> bool:
        """Whether the material is without stress at another strain as time goes on."""
        return bool(self.natural_strain) or (self.heat is not None and self.heat.expands)

    @property
    def drags(self) -> bool:
        """Whether something resists the motion of the centreline itself."""
        touched = any(one.resists for one in self.touches)
        return bool(self.drag) or touched or any(one.dissipation != 0 for one in self.densities)

    @property
    def adds_mass(self) -> bool:
        """Whether something that moves with the filament has a kinetic energy of its own."""
        return self.added_mass or any(one.kinetic != 0 for one in self.densities)

    @property
    def is_conservative(self) -> bool:
        """Whether the tension has a potential: not where only one of finite stretch and thinning is in force."""
        return self.finite == self.thins


@dataclass(frozen=True, slots=True)
class Formulation:
    """All that the equations of one cell depend on."""

    terms: Terms  # What the effects left
    section: str  # As in the scene
    closure: str  # ``material`` or ``printed``

    @property
    def conserves_energy(self) -> bool:
        """Whether forces and stored energy belong together, so that the energy balance can be judged."""
        return self.closure == "material" and self.terms.is_conservative

    @property
    def area_power(self) -> int:
        """With which the area of the section goes with its thickness."""
        return CROSS_SECTIONS[self.section].area_power
