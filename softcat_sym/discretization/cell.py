"""The cell and the joint: a filament's densities on two nodes and on two neighbouring cells, differentiated by CasADi.

Forces, torques and tensions are derivatives of the densities of one cell and one joint with respect to their strains,
carried to the nodes by the derivatives of the strains (virtual power); averages from cells to nodes and back are each
other's transpose. So forces are the exact derivatives of the discrete energy.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import casadi as ca

from softcat_sym.discretization.casadi_printer import printed
from softcat_sym.discretization.held_ends import Held, Nozzle, held
from softcat_sym.discretization.parameters import AREA, TIME_SCALE
from softcat_sym.discretization.stencil import (
    PARAMETER,
    PLACE,
    STAGED,
    TIME,
    UNKNOWN,
    Evaluated,
    Field,
    Leaf,
    Leaves,
    Neighbours,
    Same,
    Spread,
)
from softcat_sym.discretization.supports import EXIT_PLACES, NATURAL_PLACES, FilamentBody
from softcat_sym.discretization.unknowns import (
    CELLS,
    INNER,
    INVERTED,
    NODES,
    PER,
    PLACES,
    SPEEDS,
    WARMING,
    Floats,
    Shown,
    Signature,
    SiteRange,
    Slot,
)
from softcat_sym.physics import symbols
from softcat_sym.physics.heat import initial, temperature
from softcat_sym.physics.loads import h0_slope
from softcat_sym.physics.necking import aspect, s_slope
from softcat_sym.physics.polymer_chains import Direction
from softcat_sym.physics.section_equations import PARAMETERS, FilamentEquations
from softcat_sym.physics.section_response import shrunk
from softcat_sym.scene.ends import SYMMETRY, Support

Values = Mapping[Any, Any]
Pair = tuple[ca.SX, ca.SX]


@dataclass(frozen=True)
class Program:
    """A filament as fields: what its sites compute, in order."""

    leaves: Leaves  # Symbols of all that is given
    slots: tuple[Slot, ...]  # Unknowns of a site, plastic states last
    fields: tuple[Field, ...]  # What other sites read, each made of earlier ones
    rates: tuple[Field, ...]  # What becomes of each slot: its rate, or what it balances
    # Plastic power, power of the load, of the necking gradient, and what each effect dissipates: each a sum over the
    # sites of its fields.
    powers: Mapping[str, tuple[Field, ...]]
    shown: Mapping[str, Field | tuple[Field, ...]]  # What a run stores: a field, or the sum over several
    parameters: tuple[str, ...]  # Numbers that a run is given, as a whole and for each site
    places: tuple[str, ...]
    profiles: Mapping[str, tuple[float, float]]  # What each plastic state is of a plastic strain a_0 + a_1 zeta
    # Force of the right support on the filament, along x and y, over the undeformed area; none in three dimensions
    # and of a level filament.
    support: tuple[Field, ...] = ()

    @property
    def signature(self) -> Signature:
        """All of it that has no expressions."""
        shown = tuple(
            replace(item.shown, name=name) if isinstance(item, Field) else Shown(name, 0, 0, summed=True)
            for name, item in self.shown.items()
        )
        return Signature(self.slots, self.parameters, self.places, tuple(self.powers), shown, self.profiles)

    def evaluate(
        self, time: ca.SX, unknowns: Mapping[str, ca.SX], named: Mapping[str, ca.SX], places: Mapping[str, Floats]
    ) -> Evaluated:
        """Its fields at all sites of a grid."""
        shared = {Leaf(PARAMETER, name): value for name, value in named.items()} | {Leaf(TIME, "t"): time}
        columns = {slot.name: (int(slot.held[0]), unknowns[slot.name]) for slot in self.slots}
        spread = Spread(self.leaves, len(places["X"]), places, columns, shared)
        for one in self.fields:
            spread.take(one)
        return Evaluated(
            {slot.name: spread.values(rate) for slot, rate in zip(self.slots, self.rates, strict=True)},
            tuple(
                ca.vertcat(*(spread.values(one) for one in power)) if power else ca.SX(1, 1)
                for power in self.powers.values()
            ),
            {
                name: spread.values(item)
                if isinstance(item, Field)
                else sum((ca.sum1(spread.values(one)) for one in item), ca.SX(0))
                for name, item in self.shown.items()
            },
            tuple(spread.values(one) for one in self.support),
        )


def derivatives(density: Any, by: Sequence[Any], values: Values) -> list[ca.SX]:
    """Derivatives of a density with respect to some of its symbols, by CasADi."""
    fresh = [ca.SX.sym(str(symbol)) for symbol in by]
    expression = printed(density, {**values, **dict(zip(by, fresh, strict=True))})
    slopes = ca.vertcat(*(ca.jtimes(expression, one, ca.SX(1)) for one in fresh))
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


@dataclass(frozen=True)
class Exit:
    """What of a filament is out of its nozzle, at one instant."""

    nozzle: Nozzle
    exposed: Neighbours  # Share of the cells
    release: Neighbours  # Share of the nodes that the nozzle has handed over to their neighbours
    fed_node: Neighbours  # Length of a node that is out, and its mass in these units, of which some is always left
    mass: Neighbours
    diluted: Neighbours  # Rate of the logarithm of the length over which cells have means [1/s]; and of nodes
    fresh: ca.SX
    inside: tuple[ca.SX, ca.SX]  # From the right end of a cell to the node behind it, in rest lengths
    catching_up: ca.SX  # Time in which a node inside returns to its place [time scales]

    @property
    def out(self) -> ca.SX:
        """Whether any of a cell is out."""
        return ca.SX(self.exposed[0] > 0)


class Builder:
    """Collects the fields of a filament between two ends."""

    def __init__(self, equations: FilamentEquations, ends: tuple[Support, Support], body: FilamentBody) -> None:
        self.equations, self.first, self.last, self.body = equations, *ends, body
        self.half = self.first is SYMMETRY
        self.bends = self.first.holds_angle, self.last.holds_angle  # Which ends carry a moment
        self.leaves, self.fields, self._passing = Leaves(), list[Field](), dict[str, Neighbours]()
        self.named = _Parameters(self.leaves)
        # Everything is per unit undeformed area.
        self.values: dict[Any, Any] = {
            symbols.A0: 1.0,
            **{symbol: self.named[name] for name, symbol in equations.symbols.items()},
        }
        self.scale, self.span, self.density = self.named[TIME_SCALE], self.values[symbols.L_0], self.values[symbols.rho]
        self.time = self.leaves.symbol(Leaf(TIME, "t"))
        self.slots: dict[str, Slot] = {}
        self.rates: dict[str, Field] = {}  # Of states that are neither place nor velocity nor plastic, in time scales
        self.thermal: list[Pair] = []  # What follows from the temperature of cells and nodes, and its slope [1/K]
        terms, given = equations.terms, self.values
        # Temperature of the nodes over that at the start, less one.
        warm = Slot(WARMING, "node", (False, False), True, "", section=False)
        self.warming = self.unknown(warm) if terms.heat else Same()
        self.values = self._changed(given, "cell", CELLS, mean_of_nodes(self.warming))
        self.values_node = self._changed(given, "node", NODES, self.warming[0]) if terms.heat else self.values
        self.thinned, shrunk_area, node_thinned, node_area = (ca.SX(1),) * 4
        if terms.shrinks:
            # Of the section that has shrunk, as of one that was thinner from the beginning; its mass stays.
            shrunk_area, self.thinned = (printed(factor, self.values) for factor in shrunk(equations.shape))
            node_area, node_thinned = (printed(factor, self.values_node) for factor in shrunk(equations.shape))
        self.supports: Held = held(body.supports, self.named, self.span, self.time * self.scale)
        self.X, self.length, self.node = (self.place(name) for name in ("X", "cell", "node"))
        self.borne = self.node  # Length that a node answers for; of a strand that is laid, what of it is out
        self.exit: Exit | None = None
        power, h = equations.shape.area_power, self.values[symbols.h0]
        varies = body.profile.nodes is not None
        self.h_cell = h * self.place("h_cell")[0] if varies else h
        self.h_node = h * self.place("h_node")[0] if varies else h
        self.relative = self.place("h_cell")[0] if varies else ca.SX(1)
        self.area_cell = self.place("h_cell")[0] ** power if varies else ca.SX(1)
        self.area_node = self.place("h_node")[0] ** power if varies else ca.SX(1)
        if terms.shrinks:
            self.h_cell, self.h_node = self.h_cell * self.thinned, self.h_node * node_thinned
            self.area_cell, self.area_node = self.area_cell * shrunk_area, self.area_node * node_area

    def kelvin(self, warming: ca.SX) -> ca.SX:
        """Temperature of a filament that has one."""
        return ca.SX((1 + warming) * self.values[initial])

    def _changed(self, given: Values, name: str, where: SiteRange, warming: ca.SX) -> dict[Any, Any]:
        """What stands for the symbols at these sites: constants of the law may change in time and with temperature."""
        found, heat = dict(given), self.equations.heat
        for clock in (one for one in self.equations.clocks if one.state is None):
            now = {**found, symbols.t: self._age(name)}
            found |= {symbol: printed(value, now) for symbol, value in clock.replaces}
        if heat is not None:
            found[temperature] = self.kelvin(warming)
            for symbol, factor in heat.factors:
                found[symbol] = found[symbol] * self._thermal(f"{symbol}_of_a_{name}", where, factor, found)
            if heat.expands:
                strains = dict.fromkeys((symbols.n_0, symbols.n_1, symbols.n_0_t, symbols.n_1_t), ca.SX(0))
                found = strains | found
                found[symbols.n_0] += self._thermal(f"expansion_of_a_{name}", where, heat.strain, found)
        return found

    def _age(self, name: str) -> ca.SX:
        """Time for which the material has been as it is; of a strand that is laid, since it came out."""
        seconds = self.time * self.scale
        return seconds if self.body.exits is None else ca.fmax(seconds - self.place(f"exit_{name}")[0], 0)

    def _thermal(self, name: str, where: SiteRange, value: Any, given: Values) -> ca.SX:
        """What follows from the temperature of a site, computed once for all fibres and derivatives."""
        staged = self.stage(name, where, printed(value, given))[0]
        self.thermal.append((staged, printed(value.diff(temperature), given)))
        return staged

    def place(self, name: str) -> Neighbours:
        """A number of each site: a length, a mass, a relative thickness."""
        return Neighbours(self.leaves, PLACE, name)

    def stage(self, name: str, where: SiteRange, value: Any, ends: Mapping[int, Any] | None = None) -> Neighbours:
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
        return Field(name, SiteRange(int(not self.bends[0]), int(not self.bends[1])), ca.SX(value), ends)

    def joints(self, name: str, value: ca.SX, end: ca.SX | None = None) -> Neighbours:
        """Let other sites read a field of the nodes that carry a moment."""
        return self._kept(self.joint_field(name, value, end))

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

    def aged(self, one: Field) -> Field:
        """Rate of an energy at strains and plastic states that are held [1/s]: what clocks do to it."""
        return one.mapped(f"{one.name}_aged", self.rate)

    def softened(self, one: Field) -> Field:
        """What an energy gains by a kelvin at strains and plastic states that are held [1/K]."""
        return one.mapped(f"{one.name}_softened", self.by_temperature)

    def by_temperature(self, value: ca.SX) -> ca.SX:
        """Derivative of an expression by the temperature of its cell or node [1/K]."""
        return sum((ca.jtimes(value, one, ca.SX(1)) * slope for one, slope in self.thermal), ca.SX(0))

    def rate(self, value: ca.SX) -> ca.SX:
        """Rate of an expression [1/s] by what stands in it of the time itself."""
        return ca.SX(ca.jtimes(value, self.time, ca.SX(1)) / self.scale)

    def explicit_rate(self, value: ca.SX) -> ca.SX:
        """Rate of an expression [1/s] at unknowns that stay, but states of cells, which what comes out dilutes."""
        found = ca.SX(0)
        for leaf in self.leaves.within(value):
            symbol, slot = self.leaves.symbol(leaf), self.slots.get(leaf.name)
            if leaf.kind == TIME:
                rate = 1 / self.scale
            elif leaf.kind == STAGED and slot is None:
                rate = self._rate_of_field(leaf.name)[leaf.site]
            elif leaf.kind == UNKNOWN and slot is not None and slot.on == "cell" and self.exit is not None:
                rate = -self.exit.diluted[leaf.site] * symbol
            else:
                continue
            found += ca.jtimes(value, symbol, ca.SX(1)) * rate
        return found

    def _rate_of_field(self, name: str) -> Neighbours:
        """The same of a field that other sites read."""
        if name not in self._passing:
            one = next(field for field in self.fields if field.name == name)
            change = one.mapped(f"{name}_passing", self.explicit_rate)
            if name in self.leaves.totals and not change.value.is_zero():
                self.leaves.totals.add(change.name)
            self._passing[name] = self._kept(change)
        return self._passing[name]

    def unknown(self, slot: Slot, first: Any = 0, last: Any = 0, name: str = "") -> Neighbours:
        """An unknown, with what its ends hold it at."""
        self.slots[slot.name] = slot
        plain = Neighbours(self.leaves, UNKNOWN, slot.name)
        ends = {at: value for at, value, is_held in zip((0, -1), (first, last), slot.held, strict=True) if is_held}
        return self.stage(name or slot.name, slot.where, plain[0], ends) if ends else plain

    def averaged(self, cells: Neighbours, over: Any = 1.0) -> Sided:
        """Mean of a field of cells over the length that a node answers for."""

        def build(before: int | None, behind: int | None) -> ca.SX:
            if before is None or behind is None:
                return ca.SX(cells[0 if before is None else before] / over)
            half = 1 / (2 * self.node[0])
            whole = self.length[before] * half * cells[before] + self.length[behind] * half * cells[behind]
            return ca.SX(whole / over)

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
            return ca.SX(printed(angle, given) / self.node[0] / self.span)

        return self.nodes(name, build)


def slopes_of(b: Builder, places: Sequence[Neighbours]) -> list[ca.SX]:
    """Change of places along a cell, over the rest length that is out of a nozzle."""
    inside: Sequence[Any] = (0, 0, 0) if b.exit is None else b.exit.inside
    return [(r[1] - aside - r[0]) / b.length[0] for r, aside in zip(places, inside, strict=False)]


def mean_of_nodes(nodes: Neighbours) -> ca.SX:
    """Two-point mean on a cell: the transpose of the average over a node's length."""
    return ca.SX((nodes[0] + nodes[1]) / 2)


@dataclass
class Mechanics:
    """What a theory makes of a filament, in the plane or in space."""

    places: tuple[Neighbours, ...]  # Of the nodes [rest lengths]
    speeds: tuple[Neighbours, ...]  # [rest lengths per time scale]
    moved: tuple[Neighbours, ...]  # Velocities with those of supports that move
    stretch: Neighbours  # Of cells
    force: tuple[Neighbours, ...]  # Internal force of cells [Pa]
    plastic: dict[str, ca.SX]  # Rates of the plastic states [1/s]
    energies: dict[str, list[Field]]  # Stored energies, each a sum over sites
    dissipation: list[Field]  # Plastic power, weighted with the length of each place
    shown: dict[str, ca.SX]  # What a run stores of the cells
    double_force: Neighbours | None = None  # Conjugate of the change of the stretch at inner nodes [Pa]
    profiles: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    ageing: list[Field] = field(default_factory=list)  # What clocks do to stored energies at strains that are held
    softening: list[Field] = field(default_factory=list)  # What stored energies gain by a kelvin, likewise [1/K]
    turning: Turning | None = None  # Frames of the sections, where they are independent


@dataclass
class Turning:
    """Frames of the nodes: angles or quaternions, their spins, and what turns them."""

    frame: Sequence[Neighbours]
    spin: Sequence[Neighbours]
    clamps: tuple[Sequence[ca.SX], Sequence[ca.SX]]  # Frames that the ends hold
    torques: dict[str, Sided]  # Of the cells [Pa m], by the unknown that balances them
    of_slopes: Callable[[Sequence[ca.SX]], list[ca.SX]]  # Torques that go with derivatives by the frame of a node
    fixed: dict[str, dict[int, ca.SX]] = field(default_factory=dict)  # What vanishes instead at single ends
    dead: Sequence[ca.SX] = ()  # A torque on the free end [Pa m]


def _resists(b: Builder) -> bool:
    """Whether a stress or a force depends on the velocities."""
    terms = b.equations.terms
    return b.equations.law.viscosity is not None or terms.drags or terms.adds_mass


def _needs_velocities(b: Builder) -> bool:
    return b.equations.terms.inertia or _resists(b)


def _held(b: Builder, way: int) -> tuple[bool, bool]:
    """Whether the ends hold a coordinate."""
    return (b.first.holds_height, b.last.holds_height) if way else (b.first.holds_x, b.last.holds_x)


def positions(b: Builder, ways: int = 2, *, along: bool = True) -> tuple[Neighbours, ...]:
    """Positions of all nodes in rest lengths; those that are held are where the supports are."""
    moves, at = _needs_velocities(b), b.supports
    ends = ((at.left_x if b.first.holds_height else 0, at.right_x), (0, at.right_y), (0, at.right_z))
    found = []
    for way in range(ways):
        if way or along:
            slot = Slot(PLACES[way], "node", _held(b, way), moves, SPEEDS[way] if moves else "", section=False)
            found.append(b.unknown(slot, *ends[way]))
        else:
            # Nodes stay above the places where a straight, level filament has them.
            shift = at.left_x + 0.5 if b.first.holds_height else at.right_x - 0.5
            found.append(b.stage("x", NODES, b.X[0] + shift))
    return tuple(found)


def velocities(
    b: Builder, ways: int = 2, *, along: bool = True
) -> tuple[tuple[Neighbours, ...], tuple[Neighbours, ...]]:
    """Velocities of all nodes in rest lengths and time scales: those of held ones as zero, and as they move."""
    # A neck's gradient takes power where the last cell is stretched by a support that moves.
    felt, at, plain, moved = (
        _resists(b) or b.equations.neck is not None,
        b.supports,
        list[Neighbours](),
        list[Neighbours](),
    )
    for way, last in zip(range(ways), (at.right_u, at.right_v, at.right_w), strict=False):
        if not _needs_velocities(b) or not (way or along):
            plain.append(Same())
            moved.append(Same())
            continue
        holds = _held(b, way)
        slot = Slot(SPEEDS[way], "node", holds, b.equations.terms.inertia, "", section=False)
        plain.append(b.unknown(slot))
        still = not felt or not holds[1] or ca.SX(last).is_zero()
        moved.append(plain[-1] if still else b.unknown(slot, 0, last * b.scale, f"{SPEEDS[way]}_moving"))
    return tuple(plain), tuple(moved)


def branch_name(kind: str, branch: int) -> str:
    """Name of a plastic state: that of its kind in the first branch, numbered in the others."""
    return kind if branch == 0 else f"{kind}_mode{branch + 1}"


def chain_state(direction: Direction) -> str:
    """Name of what relaxation took of the conformation in a direction."""
    return f"chains_{direction.name}"


def shown_chains(extensions: Sequence[ca.SX]) -> dict[str, ca.SX]:
    """What a run stores of the conformation: along and across the fibres."""
    return dict(zip(("conformation_along", "conformation_across"), extensions, strict=False))


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
    values = {**_of_a_joint(b, stretch), symbols.T: b.averaged(tension)(-1, 0)}
    return _double_force(b, "double_force", printed(neck.double_force(), values))


def _of_a_joint(b: Builder, stretch: Neighbours) -> dict[Any, Any]:
    """The stretch at an inner node and its change along the filament, with the section there."""
    values = {**b.values_node, symbols.s: b.averaged(stretch)(-1, 0), symbols.h0: b.h_node}
    return values | {s_slope: (stretch[0] - stretch[-1]) / b.node[0] / b.span}


def _double_force(b: Builder, name: str, force: ca.SX) -> tuple[Neighbours, ca.SX]:
    """What is conjugate to s_X at inner nodes, over the rest length, and -d/dX of it; the ends are free of it."""
    staged = b.stage(name, INNER, force / b.span, {0: ca.SX(0), -1: ca.SX(0)})
    return staged, -(staged[1] - staged[0]) / b.length[0]


def surface_force(b: Builder, stretch: Neighbours) -> tuple[ca.SX, list[Field]]:
    """Axial force of a cell per unit undeformed area of the scene's section, and the energy of its surface.

    Derivatives of one energy, of the stretch of cells and of its change at the joints between them.
    """
    surface = b.equations.surface
    if surface is None:
        return ca.SX(0), []
    # Along a profile the width stays, so that its ratio to the thickness does not.
    values = {**b.values, symbols.s: stretch[0], symbols.h0: b.h_cell, aspect: b.values[aspect] / b.relative}
    (force,) = derivatives(surface.energy(), (symbols.s,), values)
    pull = force * b.area_cell
    fresh = printed(surface.energy(), {**values, symbols.s: ca.SX(1)}) if b.exit is not None else ca.SX(0)
    energies = [Field("surface", CELLS, b.length[0] * b.area_cell * (printed(surface.energy(), values) - fresh))]
    values, density = {**_of_a_joint(b, stretch), h0_slope: ca.SX(0)}, surface.gradient_energy()
    if b.body.profile.nodes is not None:
        h, h_node = b.place("h_cell"), b.place("h_node")[0]
        values |= {
            h0_slope: b.values[symbols.h0] * (h[0] - h[-1]) / b.node[0] / b.span,
            aspect: b.values[aspect] / h_node,
        }
    direct, across = (b.area_node * one for one in derivatives(density, (symbols.s, s_slope), values))
    of_stretch = b.stage("surface_at_joints", INNER, direct, {0: ca.SX(0), -1: ca.SX(0)})
    pull += _double_force(b, "surface_double_force", across)[1] + mean_of_nodes(of_stretch)
    energies.append(Field("surface_slope", INNER, b.node[0] * b.area_node * printed(density, values)))
    return pull, energies


def ordered(slots: Mapping[str, Slot]) -> tuple[Slot, ...]:
    """What moves, what is still, and plastic states last."""
    known = ("x", "y", "z", "u", "v", "w", "psi", "omega", "q0", "q1", "q2", "q3", "o1", "o2", "o3")
    plain = [slots[name] for name in known if name in slots]
    plastic = [slot for name, slot in slots.items() if name not in known]
    return (*(s for s in plain if s.differential), *(s for s in plain if not s.differential), *plastic)


def necking_power(
    b: Builder,
    double_force: Neighbours,
    places: Sequence[Neighbours],
    speeds: Sequence[Neighbours],
    stretch: Neighbours,
) -> ca.SX:
    """Double force times the rate at which the stretch changes from one cell beside a node to the next."""
    rates = []
    for i in (-1, 0):
        slopes, moving = ([(r[i + 1] - r[i]) / b.length[i] for r in part] for part in (places, speeds))
        rates.append(sum((a * c for a, c in zip(slopes, moving, strict=True)), ca.SX(0)) / stretch[i])
    return ca.SX(double_force[0] * (rates[1] - rates[0]))


def program_of(
    b: Builder,
    rates: tuple[Field, ...],
    powers: Mapping[str, Sequence[Field]],
    shown: Mapping[str, Field | tuple[Field, ...]],
    profiles: Mapping[str, tuple[float, float]],
    support: tuple[Field, ...] = (),
) -> Program:
    """All that was collected; what is zero everywhere has no power."""
    at_work = {
        name: tuple(one for one in fields if not all(value.is_zero() for value in one.values))
        for name, fields in powers.items()
    }
    everything = [*b.fields, *rates, *(one for power in at_work.values() for one in power)]
    everything += [one for item in shown.values() for one in (item if isinstance(item, tuple) else (item,))]
    leaves = {leaf for one in everything for value in one.values for leaf in b.leaves.within(value)}
    used = {"density", "rest_length", *(leaf.name for leaf in leaves if leaf.kind == PARAMETER)}
    rows = [*(row.name for row in PARAMETERS), AREA, *(row.name for row in b.equations.constants)]
    parameters = dict.fromkeys([*(name for name in rows if name in used), *b.body.parameters])
    places = ["X", *INVERTED, *(PER + name for name in INVERTED)]
    places += ["h_node", "h_cell"] if b.body.profile.nodes is not None else []
    places += ["hung"] if b.body.weighted else []
    places += NATURAL_PLACES if b.body.natural is not None else []
    places += EXIT_PLACES if b.body.exits is not None else []
    return Program(
        leaves=b.leaves,
        slots=ordered(b.slots),
        fields=tuple(b.fields),
        rates=rates,
        powers=at_work,
        shown=shown,
        parameters=(*parameters, TIME_SCALE),
        places=tuple(places),
        profiles=profiles,
        support=support,
    )
