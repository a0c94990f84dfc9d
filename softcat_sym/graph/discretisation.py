"""What a theory must say to become a graph: its unknowns on the grid, and the fields that they imply."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.layout import Block, Layout
from softcat_sym.graph.lengths import Lengths
from softcat_sym.graph.profile import Profile
from softcat_sym.graph.section_rule import OneFibre, SectionRule, Total
from softcat_sym.graph.supports import Held


@dataclass(frozen=True)
class Unknowns:
    """Blocks of unknowns.

    Attributes
    ----------
    positions : tuple of Block
        Named ``x``, ``y``: differential with inertia, algebraic without.
    velocities : tuple of Block
        Named ``u``, ``v``: only with inertia.
    plastic : tuple of Block
        Named as the rates in :class:`Fields`: only where the law flows.
    profiles : mapping of str to (float, float)
        What each kind of plastic state is of a plastic strain a_0 + a_1 zeta, the same in every branch.
    angles, spins : tuple of Block
        Named ``psi``, ``omega``: section angles where they are independent.
    """

    positions: tuple[Block, ...]
    velocities: tuple[Block, ...]
    plastic: tuple[Block, ...]
    profiles: Mapping[str, tuple[float, float]]
    angles: tuple[Block, ...] = ()
    spins: tuple[Block, ...] = ()


class Recall(Protocol):
    """Whatever knows the unknowns by name."""

    def field(self, name: str, full: ca.SX) -> ca.SX:
        """The values `full` of all nodes (or cells), with the unknown ones replaced."""
        ...


class Stage(Protocol):
    """Names a field of cells or nodes that other places read; it may put symbols in its place."""

    def __call__(self, name: str, value: ca.SX) -> ca.SX:
        """The field, or what stands for it."""
        ...


def unstaged(name: str, value: ca.SX) -> ca.SX:
    """Every field written out where it is used."""
    del name
    return value


def without_sums(name: str, value: ca.SX) -> ca.SX:
    """Sums over fibres stand for themselves only where one fibre stands for all.

    Raises
    ------
    ValueError
        Always.
    """
    raise ValueError(f"{name}: one fibre stands for all, and nothing sums over them")


@dataclass(frozen=True)
class State:
    """The unknowns by name, wherever they stand.

    Attributes
    ----------
    moving, still : Layout
        Differential and algebraic unknowns.
    """

    moving: Layout
    still: Layout

    def field(self, name: str, full: ca.SX) -> ca.SX:
        """The values `full` of all nodes (or cells), with the unknown ones replaced by the state's."""
        return self.still.field(name, self.moving.field(name, full))


@dataclass(frozen=True)
class Setting:
    """Where a filament is evaluated.

    Attributes
    ----------
    values : mapping of sympy.Symbol to casadi value
        Parameters.
    grid : Grid
        Nodes.
    profile : Profile
        How the section varies along the filament.
    supports : Held
        Where the supports are.
    time_scale : casadi.SX
        Unit of time [s].
    lengths : Lengths
        Of the grid.
    stage : Stage
        What becomes of the fields that other places read.
    total : callable
        What becomes of sums over the fibres, where one stands for all.
    """

    values: Mapping[sy.Symbol, Any]
    grid: Grid
    profile: Profile
    supports: Held
    time_scale: ca.SX
    lengths: Lengths
    stage: Stage = unstaged
    total: Total = without_sums

    def positions(self, state: Recall) -> tuple[ca.SX, ca.SX]:
        """Positions of all nodes, in rest lengths; those that are held are where the supports are."""
        x, y = ca.SX(self.lengths.nodes), ca.SX.zeros(self.grid.cells + 1)
        if self.grid.first.holds_height:
            x[0] = self.supports.left_x
        x[-1], y[-1] = self.supports.right_x, self.supports.right_y
        return state.field("x", x), state.field("y", y)

    def velocities(self, state: Recall) -> tuple[ca.SX, ca.SX]:
        """Velocities of all nodes, in rest lengths per second."""
        u, v = ca.SX.zeros(self.grid.cells + 1), ca.SX.zeros(self.grid.cells + 1)
        u[-1], v[-1] = self.supports.right_u * self.time_scale, self.supports.right_v * self.time_scale
        return state.field("u", u) / self.time_scale, state.field("v", v) / self.time_scale


@dataclass(frozen=True)
class Fields:
    """Everything the filament is at one instant; positions in rest lengths, the rest in SI per unit undeformed area.

    Attributes
    ----------
    x, y : casadi.SX, shape (cells + 1,)
        Positions.
    stretch : casadi.SX, shape (cells,)
        Stretch of the centreline.
    force_x, force_y : casadi.SX, shape (cells,)
        Internal force.
    plastic_rates : mapping of str to casadi.SX
        Rates of the plastic states on all cells or nodes [1/s].
    elastic_energy : casadi.SX
        Stored energy per unit span [Pa].
    dissipation : casadi.SX
        Plastic power per unit span, place by place, weighted with the length of each place [Pa/s].
    observables : mapping of str to casadi.SX
        What a trajectory shows of the section, on cells.
    torque : casadi.SX or None, shape (cells + 1,)
        What turns the section angle of each node [Pa m], where it is independent.
    double_force : casadi.SX or None, shape (cells - 1,)
        Conjugate of the change of the stretch at inner nodes [Pa], where the necking gradient is in force.
    surface_energy : casadi.SX or None
        Energy of the surface per unit span [Pa], where surface tension is in force.
    """

    x: ca.SX
    y: ca.SX
    stretch: ca.SX
    force_x: ca.SX
    force_y: ca.SX
    plastic_rates: Mapping[str, ca.SX]
    elastic_energy: ca.SX
    dissipation: ca.SX
    observables: Mapping[str, ca.SX]
    torque: ca.SX | None = None
    double_force: ca.SX | None = None
    surface_energy: ca.SX | None = None


@dataclass(frozen=True)
class Fibres:
    """A theory in which every fibre has plastic states of its own, and does alike.

    Attributes
    ----------
    rule : SectionRule
        Where the fibres are.
    one : OneFibre
        Symbols of one that stands for all.
    theory : Discretisation
        The theory with that one.
    """

    rule: SectionRule
    one: OneFibre
    theory: Discretisation


@dataclass(frozen=True)
class Discretisation:
    """A theory on a grid.

    Attributes
    ----------
    label : str
        What it is, down to the numbers that its equations hold.
    unknowns : callable
        Equations and grid to the unknowns.
    evaluate : callable
        Equations, setting and state to the fields.
    expressions : callable
        Equations to the expressions that are printed, for the parameters that occur in them.
    fibres : Fibres or None
        Where every fibre has plastic states of its own.
    """

    label: str
    unknowns: Callable[[FilamentEquations, Grid], Unknowns]
    evaluate: Callable[[FilamentEquations, Setting, Recall], Fields]
    expressions: Callable[[FilamentEquations], Iterable[Any]]
    fibres: Fibres | None = None
