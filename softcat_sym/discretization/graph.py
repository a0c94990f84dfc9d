"""The assembled Graph: a filament of N cells, with every parameter an input; its expressions are made when needed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.discretization.grid import Grid
from softcat_sym.discretization.section_rule import SectionRule, shown_of_points, shown_of_section
from softcat_sym.discretization.supports import FilamentBody
from softcat_sym.discretization.unknowns import Floats, Layout, Signature
from softcat_sym.physics.terms import Formulation, Terms

if TYPE_CHECKING:
    from softcat_sym.discretization.cell import Program
    from softcat_sym.discretization.small_deflection import SmallDeflection
    from softcat_sym.discretization.symbolic import Symbolic


@dataclass(frozen=True)
class Theory:
    """Which kinematics a filament has, and how its section is sampled where it is resolved."""

    model: str  # As in the scene
    rule: SectionRule | None  # None for the section of the paper

    @property
    def name(self) -> str:
        """As the field calls it."""
        return "kirchhoff" if self.rule is None else "simo-reissner" if self.is_spatial else "reissner"

    @property
    def is_spatial(self) -> bool:
        """Whether the filament leaves its plane."""
        return self.rule is not None and self.rule.is_spatial

    @property
    def label(self) -> str:
        """All that its equations hold; fibres are a loop, whose points are numbers of a run."""
        if self.rule is None:
            return self.model
        if self.is_spatial:
            return "points"
        return "fibres" if self.rule.is_of_fibres else self.rule.label

    @property
    def fibres(self) -> SectionRule | None:
        """The points at which every fibre has plastic states of its own; None where the section has none."""
        return self.rule if self.rule is not None and self.rule.is_of_fibres else None


@dataclass(frozen=True)
class Recorded:
    """A filament whose program is written down when somebody asks for it."""

    formulation: Formulation
    grid: Grid
    theory: Theory
    body: FilamentBody

    @cached_property
    def program(self) -> Program | SmallDeflection:
        """What its sites compute, or the small-deflection model, which has none."""
        if self.theory.model != "small-deflection":
            return self.sampled_by(self.theory.rule)
        # Imported here and below: a run whose library is cached does without SymPy and CasADi.
        from softcat_sym.discretization.small_deflection import SmallDeflection
        from softcat_sym.physics.section_equations import equations_of

        return SmallDeflection(equations_of(self.formulation), (self.grid.first, self.grid.last), self.body)

    def sampled_by(self, rule: SectionRule | None) -> Program:
        """What its sites compute with other points of the section, or one that stands for all."""
        from softcat_sym.discretization.filament_graph import build
        from softcat_sym.physics.section_equations import equations_of

        return build(equations_of(self.formulation), (self.grid.first, self.grid.last), self.body, rule)


@dataclass(frozen=True, eq=False)
class Graph:
    """Semi-discrete filament: dx/dt = ode, 0 = alg, with energies as quadratures.

    Unknowns are dimensionless: lengths in rest lengths, time in units of the parameter ``time_scale``; parameters
    are SI.
    """

    grid: Grid  # Nodes and ends
    effects: tuple[str, ...]  # Names of the effects in force
    terms: Terms  # What they left of the equations
    conserves_energy: bool  # Whether forces and stored energy belong together, so that the energy balance can be judged
    signature: Signature  # What its sites compute, by name
    rule: SectionRule | None  # Points of a section that is resolved
    recorded: Recorded  # What writes down what its sites compute
    places: Mapping[str, Floats]  # Geometry of each site
    differential: Layout  # Where the differential and the algebraic unknowns stand
    algebraic: Layout

    @property
    def program(self) -> Program | SmallDeflection:
        """What its sites compute."""
        return self.recorded.program

    @cached_property
    def symbolic(self) -> Symbolic:
        """Its equations as CasADi expressions."""
        # Imported here: a run whose library is cached does without CasADi.
        from softcat_sym.discretization.symbolic import Symbolic

        return Symbolic(self.program, self.places, self.differential, self.algebraic)

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the inputs `p`, in order."""
        return self.signature.parameters

    @property
    def profiles(self) -> Mapping[str, tuple[float, float]]:
        """What each kind of plastic state is of a plastic strain a_0 + a_1 zeta."""
        return self.signature.profiles

    @property
    def powers(self) -> tuple[str, ...]:
        """Names of the quadratures."""
        return self.signature.powers

    @property
    def start(self) -> Floats:
        """Differential states of the straight, relaxed filament at rest, shape (nx,)."""
        return self.differential.start

    @property
    def straight(self) -> Floats:
        """Algebraic states of the straight filament, where the search for equilibrium begins, shape (nz,)."""
        return self.algebraic.start

    def midpoint_row(self, kind: str) -> int:
        """Row of an unknown of the node at X = 0, differential ones first."""
        unknowns = [*self.differential.unknowns, *self.algebraic.unknowns]
        return unknowns.index((kind, int(np.argmin(np.abs(self.grid.nodes)))))

    @property
    def is_dae(self) -> bool:
        """Whether some unknowns are algebraic: positions without inertia, section angles without rotary inertia."""
        return len(self.algebraic) > 0

    @property
    def has_velocities(self) -> bool:
        """Whether velocities are among the unknowns: with inertia or a viscous stress."""
        return not {"u", "v"}.isdisjoint((*self.differential.kinds, *self.algebraic.kinds))

    @property
    def positions_are_algebraic(self) -> bool:
        """Whether the filament is in equilibrium at every instant: without inertia and without a viscous stress."""
        return "y" in self.algebraic.kinds

    def vector(self, values: dict[str, float]) -> Floats:
        """Parameter values in the order of `p`."""
        return np.array([values[name] for name in self.parameters], dtype=float)

    def observe(self, time: Floats, x: Floats, z: Floats, p: Floats) -> dict[str, Floats]:
        """Fields and energies at several times, shape (frames, sites), by CasADi."""
        observed = self.symbolic.observe(time, x, z, p)
        points = shown_of_points(observed)
        return observed if self.rule is None else observed | shown_of_section(points, self.rule)
