"""The assembled Graph: a filament of N cells, with every parameter an input; its expressions are made when needed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Protocol

import numpy as np

from softcat_sym.discretization.grid import Grid
from softcat_sym.discretization.section_rule import SectionRule, shown_of_points, shown_of_section
from softcat_sym.discretization.unknowns import Floats, Layout, Signature
from softcat_sym.physics.terms import Terms

if TYPE_CHECKING:
    import casadi as ca

    from softcat_sym.discretization.symbolic import Symbolic, SymbolicFilament


class RecordedProgram(Protocol):
    """What its sites compute, written down when somebody asks for it."""

    @property
    def program(self) -> SymbolicFilament:
        """The fields."""
        ...


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
    recorded: RecordedProgram  # What writes down what its sites compute
    places: Mapping[str, Floats]  # Geometry of each site
    differential: Layout  # Where the differential and the algebraic unknowns stand
    algebraic: Layout

    @property
    def program(self) -> SymbolicFilament:
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

    @property
    def state_names(self) -> tuple[str, ...]:
        """What each component is, for messages."""
        return self.differential.names

    @property
    def algebraic_names(self) -> tuple[str, ...]:
        """Of the algebraic states."""
        return self.algebraic.names

    @property
    def x_kinds(self) -> tuple[str, ...]:
        """Block of each component: ``x``, ``y``, ``u``, ``v``, ``psi``, ``a_0``, ..."""
        return self.differential.kinds

    @property
    def z_kinds(self) -> tuple[str, ...]:
        """Of the algebraic states."""
        return self.algebraic.kinds

    @property
    def x_where(self) -> Floats:
        """X/L_0 of each component."""
        return self.differential.where

    @property
    def z_where(self) -> Floats:
        """Of the algebraic states."""
        return self.algebraic.where

    @property
    def x_places(self) -> tuple[int, ...]:
        """Number of the node or cell of each component."""
        return self.differential.places

    @property
    def z_places(self) -> tuple[int, ...]:
        """Of the algebraic states."""
        return self.algebraic.places

    def midpoint_row(self, kind: str) -> int:
        """Row of an unknown of the node at X = 0, differential ones first."""
        places = zip((*self.x_kinds, *self.z_kinds), (*self.x_places, *self.z_places), strict=True)
        return list(places).index((kind, int(np.argmin(np.abs(self.grid.nodes)))))

    @property
    def is_dae(self) -> bool:
        """Whether some unknowns are algebraic: positions without inertia, section angles without rotary inertia."""
        return len(self.algebraic) > 0

    @property
    def has_velocities(self) -> bool:
        """Whether velocities are among the unknowns: with inertia or a viscous stress."""
        return not {"u", "v"}.isdisjoint((*self.x_kinds, *self.z_kinds))

    @property
    def positions_are_algebraic(self) -> bool:
        """Whether the filament is in equilibrium at every instant: without inertia and without a viscous stress."""
        return "y" in self.z_kinds

    @property
    def t(self) -> ca.SX:
        """Time, in time scales."""
        return self.symbolic.t

    @property
    def x(self) -> ca.SX:
        """Differential states, shape (nx,)."""
        return self.symbolic.x

    @property
    def z(self) -> ca.SX:
        """Algebraic states, shape (nz,)."""
        return self.symbolic.z

    @property
    def p(self) -> ca.SX:
        """Parameters, SI."""
        return self.symbolic.p

    @property
    def ode(self) -> ca.SX:
        """Right-hand side of the differential states, shape (nx,)."""
        return self.symbolic.ode

    @property
    def alg(self) -> ca.SX:
        """Right-hand side of the algebraic states, shape (nz,)."""
        return self.symbolic.alg

    @property
    def quad(self) -> ca.SX:
        """The powers of the whole filament, shape (powers,)."""
        return self.symbolic.quad

    def vector(self, values: dict[str, float]) -> Floats:
        """Parameter values in the order of `p`."""
        return np.array([values[name] for name in self.parameters], dtype=float)

    def observe(self, time: Floats, x: Floats, z: Floats, p: Floats) -> dict[str, Floats]:
        """Fields and energies at several times, shape (frames, sites), by CasADi."""
        observed = self.symbolic.observe(time, x, z, p)
        points = shown_of_points(observed)
        return observed if self.rule is None else observed | shown_of_section(points, self.rule)
