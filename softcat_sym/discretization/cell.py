"""The cell and the joint: a filament's densities on two nodes and on two neighbouring cells, differentiated by CasADi.

Forces, torques and tensions are derivatives of the densities of one cell and one joint with respect to their strains,
carried to the nodes by the derivatives of the strains (virtual power); averages from cells to nodes and back are each
other's transpose. So forces are the exact derivatives of the discrete energy.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.casadi_printer import CellFunction
from softcat_sym.discretization.grid import End
from softcat_sym.discretization.parameters import CATALOGUE, POINT_MASS, TIME_SCALE
from softcat_sym.discretization.section_rule import OneFibre, Sampling, SectionRule
from softcat_sym.discretization.stencil import (
    CELLS,
    FIBRE,
    INNER,
    INVERTED,
    NODES,
    PARAMETER,
    PER,
    PLACE,
    STAGED,
    TIME,
    UNKNOWN,
    WHOLE,
    Field,
    Leaf,
    Leaves,
    Neighbours,
    Same,
    Where,
)
from softcat_sym.discretization.supports import Body, Held, held
from softcat_sym.physics import reissner, symbols
from softcat_sym.physics.bulk import sigma_eq
from softcat_sym.physics.filament import FilamentEquations
from softcat_sym.physics.necking import aspect, s_slope
from softcat_sym.physics.reissner import FibreBranch, ResolvedSection
from softcat_sym.physics.section_response import BranchResponse, ViscousResponse

Values = Mapping[Any, Any]
Pair = tuple[ca.SX, ca.SX]


@dataclass(frozen=True)
class Slot:
    """One unknown of every site."""

    name: str  # ``x``, ``y``, ``u``, ``v``, ``psi``, ``omega``, or a plastic state
    on: str  # ``node``, ``cell``, or ``whole`` where the filament has it once
    held: tuple[bool, bool]  # Whether the first and the last of its sites hold it
    differential: bool  # Whether it has a rate, or balances something
    rate: str  # Name of the unknown that is its rate, or an empty text
    section: bool  # Whether it belongs to the section of one cell

    @property
    def where(self) -> Where:
        """The sites at which it is unknown."""
        if self.on == "whole":
            return Where(0, 0, alone=True)
        return Where(int(self.held[0]), int(self.held[1]) + (self.on == "cell"))


@dataclass(frozen=True)
class Program:
    """A filament as fields: what its sites compute, in order."""

    leaves: Leaves  # Symbols of all that is given
    slots: tuple[Slot, ...]  # Unknowns of a site, plastic states last
    fields: tuple[Field, ...]  # What other sites read, each made of earlier ones
    rates: tuple[Field, ...]  # What becomes of each slot: its rate, or what it balances
    # Plastic power, power of the load and of the necking gradient, each a sum over the sites of its fields.
    powers: tuple[tuple[Field, ...], ...]
    shown: Mapping[str, Field | tuple[Field, ...]]  # What a run stores: a field, or the sum over several
    parameters: tuple[str, ...]  # Numbers that a run is given, as a whole and for each site
    places: tuple[str, ...]
    profiles: Mapping[str, tuple[float, float]]  # What each plastic state is of a plastic strain a_0 + a_1 zeta


POWERS = "plastic", "load", "gradient"
"""What is integrated beside the unknowns."""


def printed(expression: Any, values: Values) -> ca.SX:
    """A SymPy expression as CasADi's, of what its symbols stand for."""
    needed = tuple(symbol for symbol in expression.free_symbols)
    return ca.SX(CellFunction({"value": expression}, needed)({symbol: values[symbol] for symbol in needed})["value"])


def derivatives(density: Any, by: Sequence[Any], values: Values) -> list[ca.SX]:
    """Derivatives of a density with respect to some of its symbols, by CasADi."""
    fresh = [ca.SX.sym(str(symbol)) for symbol in by]
    expression = printed(density, {**values, **dict(zip(by, fresh, strict=True))})
    slopes = ca.gradient(expression, ca.vertcat(*fresh))
    return ca.vertsplit(ca.substitute(slopes, ca.vertcat(*fresh), ca.vertcat(*(values[symbol] for symbol in by))))


class _Parameters(dict[str, ca.SX]):
    """Symbols of the numbers of a run, by name, made when they are asked for."""

    def __init__(self, leaves: Leaves) -> None:
        super().__init__()
        self._leaves = leaves

    def __missing__(self, name: str) -> ca.SX:
        return self._leaves.symbol(Leaf(PARAMETER, name))


Sided = Callable[[int | None, int | None], ca.SX]
"""A node's expression, of the distances of the cells before and behind it; None where there is none."""


class Builder:
    """Collects the fields of a filament between two ends."""

    def __init__(self, equations: FilamentEquations, ends: tuple[End, End], body: Body) -> None:
        self.equations, self.first, self.last, self.body = equations, *ends, body
        self.half = self.first is End.SYMMETRY
        self.bends = self.first.holds_angle, self.last.holds_angle  # Which ends carry a moment
        self.leaves, self.fields = Leaves(), list[Field]()
        self.named = _Parameters(self.leaves)
        rows = [*CATALOGUE, *equations.law.constants]
        # Everything is per unit undeformed area.
        self.values: dict[Any, Any] = {symbols.A0: 1.0, **{row.symbol: self.named[row.name] for row in rows}}
        self.scale, self.span, self.density = self.named[TIME_SCALE], self.values[symbols.L_0], self.values[symbols.rho]
        self.time = self.leaves.symbol(Leaf(TIME, "t"))
        self.supports: Held = held(body.supports, self.named, self.span, self.time * self.scale)
        self.slots: dict[str, Slot] = {}
        self.X, self.length, self.node = (self.place(name) for name in ("X", "cell", "node"))
        power, h = equations.shape.area_power, self.values[symbols.h0]
        varies = body.profile.nodes is not None
        self.h_cell = h * self.place("h_cell")[0] if varies else h
        self.h_node = h * self.place("h_node")[0] if varies else h
        self.relative = self.place("h_cell")[0] if varies else ca.SX(1)
        self.area_cell = self.place("h_cell")[0] ** power if varies else ca.SX(1)
        self.area_node = self.place("h_node")[0] ** power if varies else ca.SX(1)

    def place(self, name: str) -> Neighbours:
        """A number of each site: a length, a mass, a relative thickness."""
        return Neighbours(self.leaves, PLACE, name)

    def stage(self, name: str, where: Where, value: Any, ends: Mapping[int, Any] | None = None) -> Neighbours:
        """Let other sites read a field; one that is the same number everywhere is no field."""
        return self._kept(Field(name, where, ca.SX(value), {at: ca.SX(one) for at, one in (ends or {}).items()}))

    def nodes(self, name: str, build: Sided) -> Neighbours:
        """Let other sites read a field of nodes."""
        return self._kept(
            Field(name, INNER, ca.SX(build(-1, 0)), {0: ca.SX(build(None, 0)), -1: ca.SX(build(-1, None))})
        )

    def joint_field(self, name: str, value: ca.SX, end: ca.SX | None = None) -> Field:
        """A field of the nodes that carry a moment; an end that does not hold the angle carries none."""
        ends = {
            at: ca.SX(0) if end is None else end for at, holds in zip((0, -1), self.bends, strict=True) if not holds
        }
        return Field(name, Where(int(not self.bends[0]), int(not self.bends[1])), ca.SX(value), ends)

    def joints(self, name: str, value: ca.SX, end: ca.SX | None = None) -> Neighbours:
        """Let other sites read a field of the nodes that carry a moment."""
        return self._kept(self.joint_field(name, value, end))

    def running(self, name: str, value: ca.SX) -> Neighbours:
        """Let nodes read the sum of a field over the cells before them."""
        self.fields.append(Field(name, CELLS, value, summed="before"))
        return Neighbours(self.leaves, STAGED, name)

    def whole(self, name: str, value: ca.SX) -> ca.SX:
        """The sum over the cells of a field."""
        self.fields.append(Field(name, CELLS, value, summed="whole"))
        return self.leaves.symbol(Leaf(WHOLE, name))

    def _kept(self, one: Field) -> Neighbours:
        values = one.values
        if all(value.is_constant() and float(value) == float(values[0]) for value in values):
            return Same(values[0])
        self.fields.append(one)
        return Neighbours(self.leaves, STAGED, one.name)

    def total(self, name: str, value: ca.SX) -> ca.SX:
        """The sum over the fibres of a field of cells."""
        if value.is_zero():
            return value
        self.leaves.totals.add(name)
        return self.stage(name, CELLS, value)[0]

    def unknown(self, slot: Slot, first: Any = 0, last: Any = 0, name: str = "") -> Neighbours:
        """An unknown, with what its ends hold it at."""
        self.slots[slot.name] = slot
        if slot.on == "whole":
            return Same(self.leaves.symbol(Leaf(WHOLE, slot.name)))
        plain = Neighbours(self.leaves, UNKNOWN, slot.name)
        ends = {at: value for at, value, is_held in zip((0, -1), (first, last), slot.held, strict=True) if is_held}
        return self.stage(name or slot.name, slot.where, plain[0], ends) if ends else plain

    def averaged(self, cells: Neighbours, over: Any = 1.0) -> Sided:
        """Mean of a field of cells over the length that a node answers for."""

        def build(before: int | None, behind: int | None) -> ca.SX:
            if before is None or behind is None:
                return cells[0 if before is None else before] / over
            half = 1 / (2 * self.node[0])
            return (self.length[before] * half * cells[before] + self.length[behind] * half * cells[behind]) / over

        return build

    def turning(
        self, name: str, angle: Any, tangent: Sequence[Neighbours], speed: Sequence[Neighbours] = ()
    ) -> Neighbours:
        """theta_X of every node [1/m], or its rate; an end that holds the angle turns against its clamp."""
        clamps = clamp_tangents(self)
        places = (symbols.x_X_before, symbols.y_X_before, symbols.x_X, symbols.y_X)
        rates = (symbols.x_Xt_before, symbols.y_Xt_before, symbols.x_Xt, symbols.y_Xt)

        def build(before: int | None, behind: int | None) -> ca.SX:
            if (before is None and not self.bends[0]) or (behind is None and not self.bends[1]):
                return ca.SX(0)
            values = []
            for fields, ends in ((tangent, clamps), (speed, ((ca.SX(0), ca.SX(0)),) * 2)):
                for site, end in zip((before, behind), ends, strict=True):
                    values += [one[site] if site is not None else e for one, e in zip(fields, end, strict=False)]
            given = dict(zip((*places, *rates), values, strict=False))
            return printed(angle, given) / self.node[0] / self.span

        return self.nodes(name, build)


def mean_of_nodes(nodes: Neighbours) -> ca.SX:
    """Two-point mean on a cell: the transpose of the average over a node's length."""
    return (nodes[0] + nodes[1]) / 2


@dataclass
class Mechanics:
    """What a theory makes of a filament."""

    x: Neighbours  # Places of the nodes, in rest lengths, and their velocities, in these and time scales
    y: Neighbours
    u: Neighbours
    v: Neighbours
    stretch: Neighbours  # Of cells
    force: tuple[Neighbours, Neighbours]  # Internal force of cells [Pa]
    plastic: dict[str, ca.SX]  # Rates of the plastic states [1/s]
    energies: dict[str, list[Field]]  # Stored energies, each a sum over sites
    dissipation: list[Field]  # Plastic power, weighted with the length of each place
    shown: dict[str, ca.SX]  # What a run stores of the cells
    omega: Neighbours = field(default_factory=Same)
    torque: Sided | None = None  # What turns the section angle of a node [Pa m], where it is independent
    double_force: Neighbours | None = None  # Conjugate of the change of the stretch at inner nodes [Pa]
    profiles: dict[str, tuple[float, float]] = field(default_factory=dict)


def positions(b: Builder, *, along: bool = True) -> tuple[Neighbours, Neighbours]:
    """Positions of all nodes in rest lengths; those that are held are where the supports are."""
    inertia, viscous = b.equations.terms.inertia, b.equations.law.viscosity is not None
    moves, at = inertia or viscous, b.supports
    found = []
    for name, rate, holds, first, last in (
        ("x", "u", (b.first.holds_x, b.last.holds_x), at.left_x if b.first.holds_height else 0, at.right_x),
        ("y", "v", (b.first.holds_height, b.last.holds_height), 0, at.right_y),
    ):
        if name == "y" or along:
            slot = Slot(name, "node", holds, moves, rate if moves else "", section=False)
            found.append(b.unknown(slot, first, last))
        else:
            # Nodes stay above the places where a straight, level filament has them.
            shift = at.left_x + 0.5 if b.first.holds_height else at.right_x - 0.5
            found.append(b.stage(name, NODES, b.X[0] + shift))
    return found[0], found[1]


def velocities(b: Builder, *, along: bool = True) -> tuple[Neighbours, Neighbours, Neighbours, Neighbours]:
    """Velocities of all nodes in rest lengths and time scales: those of held ones as zero, and as they move."""
    inertia, viscous = b.equations.terms.inertia, b.equations.law.viscosity is not None
    if not (inertia or viscous):
        return Same(), Same(), Same(), Same()
    at, plain, moved = b.supports, list[Neighbours](), list[Neighbours]()
    for name, holds, last in (
        ("u", (b.first.holds_x, b.last.holds_x), at.right_u * b.scale),
        ("v", (b.first.holds_height, b.last.holds_height), at.right_v * b.scale),
    ):
        if name == "u" and not along:
            plain.append(Same())
            moved.append(Same())
            continue
        slot = Slot(name, "node", holds, inertia, "", section=False)
        plain.append(b.unknown(slot))
        still = not any(holds) or not holds[1] or ca.SX(last).is_zero()
        moved.append(plain[-1] if still or not viscous else b.unknown(slot, 0, last, f"{name}_moving"))
    return plain[0], plain[1], moved[0], moved[1]


def branch_name(kind: str, branch: int) -> str:
    """Name of a plastic state: that of its kind in the first branch, numbered in the others."""
    return kind if branch == 0 else f"{kind}_mode{branch + 1}"


def clamp_tangents(b: Builder) -> tuple[Pair, Pair]:
    """Directions that the ends hold: a clamp its own, a plane of symmetry the level one."""
    left, right = b.supports.left_angle, b.supports.right_angle
    first = (ca.SX(1), ca.SX(0)) if b.half else (ca.cos(left), ca.sin(left))
    return first, (ca.cos(right), ca.sin(right))


def neck_force(b: Builder, stretch: Neighbours, tension: Neighbours) -> tuple[Neighbours | None, ca.SX]:
    """B s_X at inner nodes over the rest length [Pa], and what the axial force of a cell gains, -d/dX of it.

    It has no potential, since it grows with the tension: stated as the conjugate of the rate of s_X (virtual power).
    """
    neck = b.equations.neck
    if neck is None:
        return None, ca.SX(0)
    slope = (stretch[0] - stretch[-1]) / b.node[0] / b.span
    values = {
        **b.values,
        symbols.T: b.averaged(tension)(-1, 0),
        symbols.s: b.averaged(stretch)(-1, 0),
        s_slope: slope,
        symbols.h0: b.h_node,
    }
    force = printed(neck.double_force(), values) / b.span
    staged = b.stage("double_force", INNER, force, {0: ca.SX(0), -1: ca.SX(0)})
    return staged, -(staged[1] - staged[0]) / b.length[0]


def surface_force(b: Builder, stretch: ca.SX) -> tuple[ca.SX, list[Field]]:
    """Axial force of a cell per unit undeformed area of the scene's section, and the energy of its surface."""
    surface = b.equations.surface
    if surface is None:
        return ca.SX(0), []
    # Along a profile the width stays, so that its ratio to the thickness does not.
    values = {**b.values, symbols.s: stretch, symbols.h0: b.h_cell, aspect: b.values[aspect] / b.relative}
    (force,) = derivatives(surface.energy(), (symbols.s,), values)
    energy = printed(surface.energy(), values)
    return force * b.area_cell, [Field("surface", CELLS, b.length[0] * b.area_cell * energy)]


@dataclass(frozen=True)
class Strains:
    """Deformation of a filament that does not shear: on cells and on joints, with rates where stress depends on them."""

    s: Neighbours
    s_node: Neighbours
    turning: Neighbours  # theta_X [1/m]
    s_t: Neighbours
    s_node_t: Neighbours
    turning_t: Neighbours


@dataclass
class Section:
    """What a section does: sums over its parts, in expressions of a cell."""

    tension: ca.SX = field(default_factory=lambda: ca.SX(0))
    moment: tuple[ca.SX, ca.SX] = field(default_factory=lambda: (ca.SX(0), ca.SX(0)))  # At both ends of the cell
    correction: ca.SX = field(default_factory=lambda: ca.SX(0))  # Q - T
    plastic: dict[str, ca.SX] = field(default_factory=dict)  # Rates of the plastic states [1/s]
    stored: list[Field] = field(default_factory=list)  # Energies of cells and joints
    dissipation: list[Field] = field(default_factory=list)
    stress: tuple[ca.SX, ca.SX] = field(default_factory=lambda: (ca.SX(0), ca.SX(0)))  # sigma_0 and sigma_1
    fraction: ca.SX | None = None  # Share that yields, and the largest plastic rate
    speed: ca.SX | None = None


def linear_section(b: Builder, at: Strains, *, whole: bool = False) -> Section:
    """The section of the paper: a plastic strain linear through the thickness; stretching on cells, bending on joints.

    What has a potential is differentiated. What has none - the printed closure, and a finite stretch of a section that
    does not thin - states its resultants, conjugate to the rates of the strains (virtual power).
    """
    response, found = b.equations.response, Section()
    for j, part in enumerate(response.parts):
        viscous = isinstance(part, ViscousResponse)
        flows = isinstance(part, BranchResponse) and part.means is not None
        a_0, a_1 = _states(b, j, whole=whole) if flows else (Same(), Same())
        cell = {**b.values, symbols.s: at.s[0], symbols.s_t: at.s_t[0], symbols.a_0: a_0[0], symbols.h0: b.h_cell}
        node = {**b.values, symbols.s: at.s_node[0], symbols.s_t: at.s_node_t[0], symbols.h0: b.h_node}
        node |= {symbols.theta_X: at.turning[0], symbols.theta_Xt: at.turning_t[0], symbols.a_1: a_1[0]}
        sigma_0, sigma_1 = printed(part.stress_mean, cell), printed(part.stress_bending, node)
        if b.equations.conserves_energy:
            (pull,) = derivatives(part.stretching, (symbols.s_t if viscous else symbols.s,), cell)
            by = (symbols.theta_Xt, symbols.s_t) if viscous else (symbols.theta_X, symbols.s)
            turn, correction = derivatives(part.bending, by, node)
            T, M, C = b.area_cell * pull, -b.area_node * turn, b.area_node * correction
        else:
            T = b.area_cell * printed(response.tension, {**cell, symbols.sigma_0: sigma_0})
            M = b.area_node * printed(response.moment, {**node, symbols.sigma_1: sigma_1})
            C = printed(response.axial_correction, {**node, symbols.M: M})
        tension, moment = b.stage(f"tension_{j}", CELLS, T), b.joints(f"moment_{j}", M)
        lengthening = b.joints(f"axial_correction_{j}", C)
        found.tension += tension[0]
        found.moment = found.moment[0] + moment[0], found.moment[1] + moment[1]
        found.correction += mean_of_nodes(lengthening)
        # The other stress, where the flow of one needs both: resultants are averaged, not stresses.
        moment_cell = b.stage(f"moment_cell_{j}", CELLS, mean_of_nodes(moment) / b.area_cell)
        tension_node = b.nodes(f"tension_node_{j}", b.averaged(tension, over=b.area_node))
        across = printed(response.stress_of_moment, {**cell, symbols.M: moment_cell[0]})
        along = printed(response.stress_of_tension, {**node, symbols.T: tension_node[0]})
        cell |= {symbols.sigma_0: sigma_0, symbols.sigma_1: across}
        node |= {symbols.sigma_0: along, symbols.sigma_1: sigma_1}
        found.stress = found.stress[0] + sigma_0, found.stress[1] + across
        over_cell, over_node = b.length[0] * b.area_cell, b.node[0] * b.area_node
        if viscous:
            lost = 2 * printed(part.stretching, cell), 2 * printed(part.bending, node)
        else:
            found.stored += [
                Field("stretching", CELLS, over_cell * printed(part.stretching, cell)),
                b.joint_field("bending", over_node * printed(part.bending, node)),
            ]
            rates = printed(part.rate_mean, cell), printed(part.rate_bending, node)
            names = branch_name("a_0", j), branch_name("a_1", j)
            found.plastic |= {n: r for n, r in zip(names, rates, strict=True) if n in b.slots}
            lost = tuple(printed(power, given) for power, given in zip(part.dissipation, (cell, node), strict=True))
        found.dissipation += [
            Field("power_stretching", CELLS, over_cell * lost[0]),
            b.joint_field("power_bending", over_node * lost[1]),
        ]
        if not viscous or len(response.parts) == 1:
            end = {**node, symbols.sigma_1: ca.SX(0)}
            shown = [
                mean_of_nodes(b.joints(f"{name}_{j}", printed(value, node), printed(value, end)))
                for name, value in (("fraction", part.yielded_fraction), ("speed", part.plastic_rate))
            ]
            found.fraction = shown[0] if found.fraction is None else ca.fmax(found.fraction, shown[0])
            found.speed = shown[1] if found.speed is None else ca.fmax(found.speed, shown[1])
    return found


def _states(b: Builder, branch: int, *, whole: bool) -> tuple[Neighbours, Neighbours]:
    """Plastic states of a branch: a_0 of every cell, or one of the filament; a_1 of every joint with a moment."""
    terms, mean, bending = b.equations.terms, Same(), Same()
    free = (not b.first.holds_angle, not b.last.holds_angle)
    if terms.stretches:
        slot = Slot(branch_name("a_0", branch), "whole" if whole else "cell", (False, False), True, "", section=False)
        mean = b.unknown(slot)
    if terms.bending:
        bending = b.unknown(Slot(branch_name("a_1", branch), "node", free, True, "", section=False))
    return mean, bending


def kirchhoff(b: Builder) -> Mechanics:
    """A filament whose sections stay normal to the centreline."""
    terms, line = b.equations.terms, b.equations.terms.centreline
    x, y = positions(b, along=terms.stretches)
    u, v, *moved = velocities(b, along=terms.stretches)
    slope = tuple(b.stage(f"slope_{n}", CELLS, (r[1] - r[0]) / b.length[0]) for n, r in (("x", x), ("y", y)))
    tangent = {symbols.x_X: slope[0][0], symbols.y_X: slope[1][0]}
    s = b.stage("s", CELLS, printed(line.stretch, tangent) if terms.stretches else ca.SX(1))
    s_node = b.nodes("s_node", b.averaged(s))
    turning = b.turning("turning", line.turning, slope) if terms.bending else Same()
    s_t = s_node_t = turning_t = Same()
    if b.equations.response.viscous is not None:
        speed = tuple(
            b.stage(f"speed_{n}", CELLS, (r[1] - r[0]) / b.length[0] / b.scale)
            for n, r in zip("xy", moved, strict=True)
        )
        if terms.stretches:
            rates = {symbols.x_Xt: speed[0][0], symbols.y_Xt: speed[1][0]}
            s_t = b.stage("stretching", CELLS, printed(line.stretch_rate(), {**tangent, **rates}))
            s_node_t = b.nodes("stretching_node", b.averaged(s_t))
        if terms.bending:
            turning_t = b.turning("turning_rate", line.turning_rate(), slope, speed)
    section = linear_section(b, Strains(s, s_node, turning, s_t, s_node_t, turning_t))
    pull, surface = surface_force(b, s[0])
    total = b.stage("tension", CELLS, section.tension) if b.equations.neck is not None else s
    double_force, necked = neck_force(b, s, total)
    axial = section.tension + section.correction + pull + necked
    transverse = (section.moment[1] - section.moment[0]) / b.length[0] / b.span
    given = {**tangent, symbols.s: s[0], symbols.Q: axial, symbols.M_X: transverse}
    force = tuple(
        b.stage(f"force_{n}", CELLS, printed(component, given))
        for n, component in (("x", b.equations.force.horizontal), ("y", b.equations.force.vertical))
    )
    shown = {
        **_shown(b, section, s[0], transverse, mean_of_nodes(b.nodes("curvature", lambda *_: turning[0] / s_node[0]))),
        **({"axial_force": axial} if surface else {}),
    }
    energies = {"elastic": section.stored, "surface": surface}
    return Mechanics(
        x, y, u, v, s, force, section.plastic, energies, section.dissipation, shown, double_force=double_force
    )


def small_deflection(b: Builder) -> Mechanics:
    """A filament of small slope: one stretch for the whole, the mean elongation of its cells (2.13)."""
    line = b.equations.terms.centreline
    y = positions(b, along=False)[1]
    u, v, *_ = velocities(b, along=False)
    slope = Same(1), b.stage("slope_y", CELLS, (y[1] - y[0]) / b.length[0])
    tangent = {symbols.x_X: slope[0][0], symbols.y_X: slope[1][0]}
    # Elongation of each cell at x_X = 1; what the mean has beyond it is the horizontal displacement U (2.13).
    lengthening = b.stage("lengthening", CELLS, printed(line.stretch, tangent) - 1)
    s = 1 + b.whole("elongation", b.length[0] * lengthening[0] / (0.5 if b.half else 1.0))
    moved = b.running("displacement", b.length[0] * (s - 1 - lengthening[0]))
    x = b.stage("x", NODES, b.X[0] + moved[0])
    same, none = Same(s), Same()
    turning = b.turning("turning", line.turning, slope)
    section = linear_section(b, Strains(same, same, turning, none, none, none), whole=True)
    pull, surface = surface_force(b, s)
    transverse = (section.moment[1] - section.moment[0]) / b.length[0] / b.span
    given = {**tangent, symbols.s: s, symbols.Q: section.tension + pull, symbols.M_X: transverse}
    force = none, b.stage("force_y", CELLS, printed(b.equations.force.vertical, given))
    shown = _shown(b, section, s, transverse, mean_of_nodes(turning) / s)
    shown |= {"relative_thickness": ca.SX(1), **({"axial_force": section.tension + pull} if surface else {})}
    energies = {"elastic": section.stored, "surface": surface}
    return Mechanics(x, y, u, v, same, force, section.plastic, energies, section.dissipation, shown)


def _shown(b: Builder, section: Section, s: ca.SX, transverse: ca.SX, curvature: ca.SX) -> dict[str, ca.SX]:
    thickness = b.equations.response.thickness / symbols.h0
    return {
        "shear_force": transverse / s,
        "relative_thickness": printed(thickness, {**b.values, symbols.s: s}) * b.relative,
        "tension": section.tension,
        "moment": (section.moment[0] + section.moment[1]) / 2,
        "curvature": curvature,
        "shear": ca.SX(0),
        "yielded_fraction": ca.SX(0) if section.fraction is None else section.fraction,
        "plastic_rate": ca.SX(0) if section.speed is None else section.speed,
        "stress_mean": section.stress[0],
        "stress_bending": section.stress[1],
    }


@dataclass
class Fibres:
    """Sums over the section of a cell, and what a run shows of its fibres."""

    axial: ca.SX  # Means of the axial stress, of that times zeta, and of the shear stress
    axial_zeta: ca.SX
    shear: ca.SX
    energy: ca.SX
    dissipation: ca.SX
    plastic: dict[str, ca.SX]  # Rates of the plastic states [1/s]
    shown: dict[str, ca.SX]
    profiles: dict[str, tuple[float, float]]


def shearing(b: Builder, rule: Sampling) -> Mechanics:
    """A filament that shears (geometrically exact in the plane), its section resolved point by point.

    Positions and section angle live on nodes, the whole section on cells: a two-node element with one point along the
    filament, so that it neither locks in shear nor has a spurious mode.
    """
    resolved = b.equations.resolved
    if resolved is None:
        raise ValueError("the section is not resolved: neither shear nor fibres are in force")
    x, y = positions(b)
    u, v, *moved = velocities(b)
    psi, omega = angles(b)
    slope_x, slope_y = ((r[1] - r[0]) / b.length[0] for r in (x, y))
    at = {symbols.x_X: slope_x, symbols.y_X: slope_y, reissner.psi: mean_of_nodes(psi)}
    strains = [*(printed(one, at) for one in resolved.strains), (psi[1] - psi[0]) / b.length[0] / b.span]
    rates = [ca.SX(0)] * 3
    if resolved.viscous is not None:
        speed = [(r[1] - r[0]) / b.length[0] / b.scale for r in moved]
        moving = {symbols.x_Xt: speed[0], symbols.y_Xt: speed[1], reissner.psi_t: mean_of_nodes(omega) / b.scale}
        rates = [printed(one, {**at, **moving}) for one in resolved.strain_rates]
        rates.append((omega[1] - omega[0]) / b.scale / b.length[0] / b.span)
    if isinstance(rule, OneFibre):
        # What all fibres see is looked up.
        names = ("Lam", "Gam", "k")
        strains = [b.stage(name, CELLS, one)[0] for name, one in zip(names, strains, strict=True)]
        rates = [b.stage(f"{name}_t", CELLS, one)[0] for name, one in zip(names, rates, strict=True)]
    by = (reissner.Lam, reissner.Gam, reissner.k)
    values = {**b.values, symbols.h0: b.h_cell, **dict(zip(by, strains, strict=True))}
    values |= dict(zip((reissner.Lam_t, reissner.Gam_t, reissner.k_t), rates, strict=True))
    fibres = sampled(b, resolved, rule, values)
    values |= {reissner.sigma_mean: fibres.axial, reissner.sigma_zeta: fibres.axial_zeta}
    values |= {reissner.tau_mean: fibres.shear}
    # Stresses to the conjugates of the cell's strains, and these to forces on its nodes, each by virtual power.
    n_1, n_2, couple = (b.area_cell * one for one in derivatives(resolved.cell.power, by, values))
    couple = b.stage("couple", CELLS, couple)
    at |= {reissner.n_1: n_1, reissner.n_2: n_2}
    power = reissner.n_1 * resolved.strains[0] + reissner.n_2 * resolved.strains[1]
    force_x, force_y, turn = derivatives(power, (symbols.x_X, symbols.y_X, reissner.psi), at)
    turn = b.stage("turning_half", CELLS, -b.length[0] * b.span * turn / 2)
    section = {
        name: b.area_cell * printed(one, values)
        for name, one in (("tension", resolved.cell.tension), ("moment", resolved.cell.moment))
    }
    section["shear_force"] = b.area_cell * printed(resolved.cell.shear_force, values)
    # Along the tangent of the centreline, not along the normal of the section: conjugate to its stretch.
    stretch = b.stage("stretch", CELLS, ca.sqrt(slope_x**2 + slope_y**2))
    pull, surface = surface_force(b, stretch[0])
    tension = b.stage("tension", CELLS, section["tension"]) if b.equations.neck is not None else Same()
    double_force, necked = neck_force(b, stretch, tension)
    along = (pull + necked) / stretch[0]
    force = (
        b.stage("force_x", CELLS, force_x + along * slope_x),
        b.stage("force_y", CELLS, force_y + along * slope_y),
    )

    def torque(before: int | None, behind: int | None) -> ca.SX:
        """Change of the couple and the moment of the forces about a node [Pa m]."""
        ahead = ca.SX(0) if behind is None else couple[behind] + turn[behind]
        return ahead if before is None else ahead - couple[before] + turn[before]

    shown = {
        **section,
        "relative_thickness": printed(resolved.relative_thickness, values) * b.relative,
        "curvature": strains[2] / strains[0],
        "shear": strains[1] / strains[0],
        **fibres.shown,
        **({"axial_force": (force[0][0] * slope_x + force[1][0] * slope_y) / stretch[0]} if surface else {}),
    }
    volume = b.length[0] * b.area_cell
    return Mechanics(
        x,
        y,
        u,
        v,
        stretch,
        force,
        fibres.plastic,
        {"elastic": [Field("elastic", CELLS, volume * fibres.energy)], "surface": surface},
        [Field("power_plastic", CELLS, volume * fibres.dissipation)],
        shown,
        omega,
        torque,
        double_force,
        fibres.profiles,
    )


def angles(b: Builder) -> tuple[Neighbours, Neighbours]:
    """Section angles of all nodes and their rates, which an end that holds the angle gives."""
    viscous, terms = b.equations.law.viscosity is not None, b.equations.terms
    turns, rotary = terms.rotary_inertia or viscous, terms.rotary_inertia and terms.inertia
    psi = b.unknown(
        Slot("psi", "node", b.bends, turns, "omega" if turns else "", section=False),
        0 if b.half else b.supports.left_angle,
        b.supports.right_angle,
    )
    omega = b.unknown(Slot("omega", "node", b.bends, rotary, "", section=False)) if turns else Same()
    return psi, omega


_NO_STRESS = 1e-12
"""Equivalent stress, in Young's moduli, below which a point counts as unstressed: it is divided by."""


def sampled(b: Builder, resolved: ResolvedSection, rule: Sampling, values: Values) -> Fibres:
    """Stress and flow at the points of a section, and their sums."""
    one = isinstance(rule, OneFibre)
    if isinstance(rule, OneFibre):
        for symbol, name in ((rule.zeta, "zeta"), (rule.weight, "weight")):
            b.leaves.adopt(symbol, Leaf(FIBRE, name))
    places = [rule.zeta] if one else [float(place) for place in rule.zeta]
    weights = [rule.weight] if one else [float(weight) for weight in rule.weight]
    fibres = [_Fibre(b, resolved, {**values, symbols.zeta: ca.SX(place)}) for place in places]
    found: dict[str, tuple[float, float]] = {}
    plastic: dict[str, ca.SX] = {}
    for j, branch in enumerate(resolved.branches):
        states = _fibre_states(b, resolved, branch, rule, j, found)
        for k, fibre in enumerate(fibres):
            fibre.add(branch, tuple(one[k] for one in states))
    if resolved.viscous is not None:
        for fibre in fibres:
            fibre.resist()
    for j, branch in enumerate(resolved.branches):
        for kind, number in (("axial", 0), ("shear", 1)):
            if branch.flow is None or (number and not resolved.shears):
                continue
            rates = [fibre.rates[j][number] for fibre in fibres]
            for n, label in enumerate(rule.labels):
                rate = rates[0] if one else _dot(rule.project[n], rates)
                plastic[branch_name(f"{kind}_{label}", j)] = rate

    def mean(name: str, *, linear: bool = False) -> ca.SX:
        terms = [
            getattr(fibre, name) * (w * z if linear else w) for fibre, z, w in zip(fibres, places, weights, strict=True)
        ]
        total = _dot([1.0] * len(terms), terms)
        return b.total(f"{name}_zeta" if linear else name, total) if one else total

    return Fibres(
        axial=mean("axial"),
        axial_zeta=mean("axial", linear=True),
        shear=mean("shear"),
        energy=mean("energy"),
        dissipation=mean("dissipation"),
        plastic=plastic,
        shown={} if one else _shown_fibres(rule, fibres),
        profiles=found,
    )


def _dot(weights: Sequence[float], values: Sequence[ca.SX]) -> ca.SX:
    total = ca.SX(0)
    for weight, value in zip(weights, values, strict=True):
        if weight:
            total += weight * value
    return total


def _fibre_states(
    b: Builder, resolved: ResolvedSection, branch: FibreBranch, rule: Sampling, number: int, profiles: dict[str, Any]
) -> tuple[list[ca.SX], list[ca.SX]]:
    """Axial and shear plastic strain of a branch at every point."""
    found = []
    for kind in ("axial", "shear"):
        if branch.flow is None or (kind == "shear" and not resolved.shears):
            found.append([ca.SX(0)] * rule.points)
            continue
        names = [branch_name(f"{kind}_{label}", number) for label in rule.labels]
        states = [b.unknown(Slot(name, "cell", (False, False), True, "", section=True))[0] for name in names]
        if isinstance(rule, SectionRule) and kind == "axial":
            mean, linear = rule.project @ np.ones(rule.points), rule.project @ rule.zeta
            profiles |= {name: (float(mean[n]), float(linear[n])) for n, name in enumerate(names)}
        found.append(states if isinstance(rule, OneFibre) else [_dot(row, states) for row in rule.recall])
    return found[0], found[1]


class _Fibre:
    """One point of a section: its stress is the derivative of its stored energy, its flow is driven by it."""

    def __init__(self, b: Builder, resolved: ResolvedSection, values: dict[Any, Any]) -> None:
        self.moduli = [branch.modulus for branch in b.equations.law.branches]
        self.resolved, self.values = resolved, values
        self.strain = (printed(resolved.cell.axial_strain, values), printed(resolved.cell.shear_strain, values))
        self.axial = self.shear = self.energy = self.dissipation = self.speed = self.yields = ca.SX(0)
        self.rates: list[Pair] = []
        self.flows = False

    def add(self, branch: FibreBranch, plastic: Pair) -> None:
        """A spring with its flow rule."""
        strain = (reissner.eps, reissner.gamma)
        values = {**self.values, **dict(zip(strain, self.strain, strict=True))}
        values |= {reissner.eps_p: plastic[0], reissner.gamma_p: plastic[1]}
        sigma, tau = derivatives(branch.stored, strain, values)
        self.axial, self.shear = self.axial + sigma, self.shear + tau
        self.energy += printed(branch.stored, values)
        if branch.flow is None:
            self.rates.append((ca.SX(0), ca.SX(0)))
            return
        modulus = printed(self.moduli[len(self.rates)], values)
        given = {**values, symbols.sigma: sigma, reissner.tau_f: tau}
        # Compared before the root is taken, whose derivative is infinite where nothing is stressed.
        square = printed(branch.flow.equivalent**2, given)
        given[sigma_eq] = ca.sqrt(ca.fmax(square, (_NO_STRESS * modulus) ** 2))
        flow = CellFunction(
            {
                name: getattr(branch.flow, name)
                for name in ("axial_rate", "shear_rate", "speed", "dissipation", "yields")
            },
            tuple(given),
        )(given)
        self.rates.append((ca.SX(flow["axial_rate"]), ca.SX(flow["shear_rate"])))
        self.dissipation += flow["dissipation"]
        self.speed = ca.fmax(self.speed, flow["speed"]) if self.flows else ca.SX(flow["speed"])
        self.yields = ca.fmax(self.yields, flow["yields"]) if self.flows else ca.SX(flow["yields"])
        self.flows = True

    def resist(self) -> None:
        """The viscous stress beside the springs: the derivative of its Rayleigh potential."""
        viscous = self.resolved.viscous
        if viscous is None:
            raise ValueError("this law has no viscous stress")
        rates = {
            symbol: printed(rate, self.values)
            for symbol, rate in zip((reissner.eps_t, reissner.gamma_t), viscous.strain_rates, strict=True)
        }
        values = {**self.values, **rates}
        sigma, tau = derivatives(viscous.rayleigh, tuple(rates), values)
        self.axial, self.shear = self.axial + sigma, self.shear + tau
        self.dissipation += 2 * printed(viscous.rayleigh, values)
        if not self.moduli:
            self.speed, self.yields = ca.fabs(rates[reissner.eps_t]), ca.SX(1)


def _shown_fibres(rule: SectionRule, fibres: Sequence[_Fibre]) -> dict[str, ca.SX]:
    weight, zeta = rule.weight, rule.zeta
    yields, axial = [fibre.yields for fibre in fibres], [fibre.axial for fibre in fibres]
    fastest = fibres[0].speed
    for fibre in fibres[1:]:
        fastest = ca.fmax(fastest, fibre.speed)
    # Limits in zeta of what does not yield, between the fibres that do on either side and those that do not.
    edges = np.concatenate([[-1.0], (zeta[1:] + zeta[:-1]) / 2, [1.0]])
    below, above, low, high = ca.SX(1), ca.SX(1), ca.SX(-1), ca.SX(1)
    for n in range(len(fibres)):
        below, above = below * yields[n], above * yields[-1 - n]
        low += below * (edges[n + 1] - edges[n])
        high -= above * (edges[-1 - n] - edges[-2 - n])
    return {
        "core_low": low,
        # Where the whole thickness yields both limits have met on the opposite faces: they are put together.
        "core_high": ca.fmax(low, high),
        "yielded_fraction": _dot(weight, yields),
        "plastic_rate": fastest,
        "stress_mean": _dot(weight, axial),
        "stress_bending": _dot(weight * zeta / float(weight @ zeta**2), axial),
    }


def build(
    equations: FilamentEquations, model: str, ends: tuple[End, End], body: Body, rule: Sampling | None
) -> Program:
    """A filament of these equations between two ends, as fields; `rule` samples a section that is resolved."""
    b = Builder(equations, ends, body)
    if rule is not None and equations.resolved is not None:
        mechanics = shearing(b, rule)
    else:
        mechanics = small_deflection(b) if model == "small-deflection" else kirchhoff(b)
    return _balanced(b, mechanics)


def _balanced(b: Builder, of: Mechanics) -> Program:
    """Rates of all unknowns, powers and observables, in units of rest length and time scale."""
    terms, span, scale = b.equations.terms, b.span, b.scale
    load = {**b.values, symbols.t: b.time * scale}
    gravity, gravity_rate = printed(terms.load, load), printed(terms.load_rate, load)
    mass = b.place("mass")[0]
    if b.body.weighted:
        mass += b.place("hung")[0] * (b.named[POINT_MASS] / (b.density * span))
    unit = scale**2 / span
    per_mass = 1 / mass * (unit / (b.density * span))
    rotary = ca.SX(0)
    if b.equations.resolved is not None:
        rotary = printed(b.equations.resolved.rotary_inertia, b.values)

    def net(force: Neighbours) -> Sided:
        return lambda before, behind: (
            (0 if behind is None else force[behind]) - (0 if before is None else force[before])
        )

    def rate_of(slot: Slot) -> Sided:
        """Rate of an unknown, or what must vanish for an algebraic one: the rate of its momentum.

        A torque is divided by the mass and the square of the span, not by the rotary inertia: sparse factorisations do
        not scale rows, and one that is thousands of times larger than the others blurs them.
        """
        if slot.rate:
            own = Neighbours(b.leaves, UNKNOWN, slot.rate)
            return lambda *_: own[0]
        if slot.name in ("x", "u"):
            return lambda l, r: net(of.force[0])(l, r) * per_mass
        if slot.name in ("y", "v"):
            return lambda l, r: net(of.force[1])(l, r) * per_mass - gravity * unit
        if slot.name in ("psi", "omega"):
            torque = of.torque or (lambda *_: ca.SX(0))
            inertia = rotary if slot.differential else b.density * span**2
            return lambda l, r: torque(l, r) / b.node[0] * (scale**2 / (inertia * span))
        return lambda *_: of.plastic[slot.name] * scale

    slots = _ordered(b.slots)
    rates = []
    for slot in slots:
        make, name = rate_of(slot), f"f_{slot.name}"
        # Nodes beside which there is a cell on one side only are written out by themselves.
        if slot.on == "node" and not slot.rate and slot.name not in of.plastic:
            ends = {0: make(None, 0), -1: make(-1, None)}
            ends = {at: ca.SX(v) for (at, v), is_held in zip(ends.items(), slot.held, strict=True) if not is_held}
            rates.append(Field(name, INNER, ca.SX(make(-1, 0)), ends))
        else:
            rates.append(Field(name, slot.where, ca.SX(make(-1, 0))))
    powers = _powers(b, of, mass, gravity, gravity_rate)
    shown = _observables(b, of, mass, gravity, rotary)
    everything = [*b.fields, *rates, *(one for power in powers for one in power)]
    everything += [one for item in shown.values() for one in (item if isinstance(item, tuple) else (item,))]
    used = {
        leaf.name
        for one in everything
        for value in one.values
        for leaf in b.leaves.within(value)
        if leaf.kind == PARAMETER
    }
    always = {"density", "rest_length"}
    rows = [row.name for row in (*CATALOGUE, *b.equations.law.constants)]
    named = [name for name in rows if name in used | always]
    named += b.body.parameters
    return Program(
        leaves=b.leaves,
        slots=slots,
        fields=tuple(b.fields),
        rates=tuple(rates),
        powers=powers,
        shown=shown,
        parameters=(*dict.fromkeys(named), TIME_SCALE),
        places=place_names(b.body),
        profiles=of.profiles or _linear_profiles(b),
    )


def _linear_profiles(b: Builder) -> dict[str, tuple[float, float]]:
    return {name: (1.0, 0.0) if name.startswith("a_0") else (0.0, 1.0) for name in b.slots if name.startswith("a_")}


def _ordered(slots: Mapping[str, Slot]) -> tuple[Slot, ...]:
    """What moves, what is still, and plastic states last."""
    known = ("x", "y", "u", "v", "psi", "omega")
    plain = [slots[name] for name in known if name in slots]
    plastic = [slot for name, slot in slots.items() if name not in known]
    return (*(s for s in plain if s.differential), *(s for s in plain if not s.differential), *plastic)


def place_names(body: Body) -> tuple[str, ...]:
    """The geometry of a site that a body needs."""
    profile = ("h_node", "h_cell") if body.profile.nodes is not None else ()
    return ("X", *INVERTED, *(PER + name for name in INVERTED), *profile, *(("hung",) if body.weighted else ()))


def _powers(
    b: Builder, of: Mechanics, mass: ca.SX, gravity: ca.SX, gravity_rate: ca.SX
) -> tuple[tuple[Field, ...], ...]:
    """Plastic power, power of the changing load and of the gradient, site by site, in `energy_scale` units."""
    span, at = b.span, b.supports
    scale = b.scale / energy_scale(b.density, span, b.scale)
    lifted = mass * (span * b.density * gravity_rate * scale)
    # The force on the right support carries the last cell and its own share.
    weight = mass * b.density * gravity * span
    moved = (of.force[0][-1] * at.right_u + (of.force[1][-1] + weight) * at.right_v) * scale
    load = [Field("power_load_0", NODES, lifted * of.y[0])]
    if not moved.is_zero():
        load.append(Field("power_load_1", Where(-1, 0, alone=True), moved))
    gradient: list[Field] = []
    if of.double_force is not None:
        stretching = []
        for i in (-1, 0):
            slope, speed = ([(r[i + 1] - r[i]) / b.length[i] for r in pair] for pair in ((of.x, of.y), (of.u, of.v)))
            stretching.append((slope[0] * speed[0] + slope[1] * speed[1]) / of.stretch[i])
        power = of.double_force[0] * (stretching[1] - stretching[0]) * (scale / b.scale)
        gradient = [Field("power_gradient_0", INNER, power)]
    plastic = [
        Field(f"power_plastic_{k}", one.where, one.value * scale, {at: v * scale for at, v in one.ends.items()})
        for k, one in enumerate(of.dissipation)
    ]
    kept = (
        tuple(one for one in group if not all(v.is_zero() for v in one.values)) for group in (plastic, load, gradient)
    )
    return tuple(kept)


def _observables(
    b: Builder, of: Mechanics, mass: ca.SX, gravity: ca.SX, rotary: ca.SX
) -> dict[str, Field | tuple[Field, ...]]:
    """What a run stores, in SI and per unit undeformed area."""
    span, terms = b.span, b.equations.terms
    # Velocities that are unknown for the sake of a viscous stress alone carry no energy.
    speed = span / b.scale
    kinetic = []
    if terms.inertia:
        moving = mass * (of.u[0] ** 2 + of.v[0] ** 2) * speed**2 * b.density / 2
        kinetic.append(Field("moving", NODES, moving * span))
    if terms.rotary_inertia:
        turning = b.node[0] * of.omega[0] ** 2 * rotary / (2 * b.scale**2)
        kinetic.append(Field("turning", NODES, turning * span))
    stored = {
        f"energy_{name}": tuple(
            Field(name, one.where, one.value * span, {at: v * span for at, v in one.ends.items()}) for one in fields
        )
        for name, fields in of.energies.items()
    }
    double_force = ca.SX(0) if of.double_force is None else of.double_force[0]
    return {
        "x": Field("x", NODES, of.x[0] * span),
        "y": Field("y", NODES, of.y[0] * span),
        "stretch": Field("stretch", CELLS, of.stretch[0]),
        **{name: Field(name, CELLS, ca.SX(value)) for name, value in of.shown.items()},
        "double_force": Field("double_force", INNER, double_force),
        "energy_kinetic": tuple(kinetic),
        **stored,
        "energy_potential": (Field("weight", NODES, mass * of.y[0] * span * b.density * gravity * span),),
    }


def energy_scale(density: Any, span: Any, time_scale: Any) -> Any:
    """Unit of the quadratures [Pa]: density times the square of span over time scale.

    An integrator that controls the quadratures measures them with the tolerances of the unknowns, so they have the same
    size whatever the units of the scene.
    """
    return density * (span / time_scale) ** 2
