"""A filament in three dimensions: nodes with a place and a quaternion, the whole section on the cell (THEORY3D 5).

The turn of a cell is the middle of the geodesic between those of its nodes, curvature and twist their relative turn
over the length (Crisfield & Jelenic 1999): a rigid motion strains nothing, and what is planar is the planar cell.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca

from softcat_sym.discretization.cell import (
    Builder,
    Program,
    Sided,
    derivatives,
    neck_force,
    necking_power,
    ordered,
    printed,
    program_of,
    surface_force,
)
from softcat_sym.discretization.end_springs import end_springs
from softcat_sym.discretization.held_ends import Held
from softcat_sym.discretization.parameters import energy_scale
from softcat_sym.discretization.sampling import OnePoint, Sampling
from softcat_sym.discretization.section_points import Sampled, sampled
from softcat_sym.discretization.stencil import Field, Leaf, Neighbours, Same
from softcat_sym.discretization.supports import NATURAL_PLACES, TIP_FORCE, TIP_MASS, TIP_TORQUE
from softcat_sym.discretization.unknowns import CELLS, INNER, NODES, PLACES, TURN, Slot, Where
from softcat_sym.physics import spatial, symbols
from softcat_sym.physics.spatial import MEANS, STRAINS

Three = tuple[ca.SX, ca.SX, ca.SX]

SPEEDS, SPIN = ("u", "v", "w"), ("o1", "o2", "o3")
"""Unknowns of a node beside its place and quaternion: its velocity, and its spin where a viscous stress asks for it."""

_ROUND = 1e-24
"""Square of the angle between two nodes below which it counts as none."""


@dataclass
class _Cell:
    """Strains of a cell, as functions of its nodes, and what its stresses do to them."""

    slope: list[ca.SX]  # r_X
    strains: list[ca.SX]  # Gamma and kappa
    rates: list[ca.SX]  # [1/s]
    force: list[ca.SX] = field(default_factory=list)  # R n [Pa]
    torques: tuple[list[ca.SX], list[ca.SX]] = ([], [])  # On either node, in its own axes [Pa m]


def spatial_filament(b: Builder, rule: Sampling) -> Program:
    """Rates of all unknowns, powers and observables of a filament in three dimensions.

    Raises
    ------
    ValueError
        For what only a filament in its plane has: half of a symmetric span, clocks, heat, and effects of a bath.
    """
    terms = b.equations.terms
    if b.half or b.equations.clocks or terms.hardens or terms.heat or b.equations.densities or terms.rotary_inertia:
        raise ValueError("a filament in three dimensions has neither a half span nor clocks, heat or a bath")
    section = spatial.spatial_section(b.equations.shape, b.equations.law, natural=terms.curved)
    places, speeds, moved, turn, spin = _unknowns(b)
    cell = _cell(b, places, moved, turn, spin)
    if isinstance(rule, OnePoint):
        # What all points see is looked up.
        names = [f"strain_{n}" for n in range(6)]
        cell.strains = [b.stage(name, CELLS, one)[0] for name, one in zip(names, cell.strains, strict=True)]
        cell.rates = [b.stage(f"{name}_t", CELLS, one)[0] for name, one in zip(names, cell.rates, strict=True)]
    values = {**b.values, symbols.h0: b.h_cell, **dict(zip(STRAINS, cell.strains, strict=True))}
    if terms.curved:
        values |= dict(zip(spatial.NATURAL, _natural(b), strict=True))
    points = sampled(b, section, rule, values | dict(zip(spatial.RATES, cell.rates, strict=True)))
    values |= points.means
    conjugate = [b.area_cell * one for one in derivatives(section.power, STRAINS, values)]
    _act(b, cell, turn, conjugate)
    stretch = b.stage("stretch", CELLS, ca.sqrt(sum((one**2 for one in cell.slope), ca.SX(0))))
    pull, surface = surface_force(b, stretch)
    tension_now = b.area_cell * points.means[MEANS[0]] / cell.strains[0]
    tension = b.stage("tension", CELLS, tension_now) if b.equations.neck is not None else Same()
    double_force, necked = neck_force(b, stretch, tension)
    along = (pull + necked) / stretch[0]
    force = [
        b.stage(f"force_{name}", CELLS, one + along * slope)
        for name, one, slope in zip(PLACES, cell.force, cell.slope, strict=True)
    ]
    torque = [
        [b.stage(f"torque_{side}_{n + 1}", CELLS, one) for n, one in enumerate(parts)]
        for side, parts in zip(("first", "last"), cell.torques, strict=True)
    ]
    of = _Body(b, places, speeds, moved, turn, spin, force, torque, stretch, double_force)
    rates = tuple(of.rate(slot, points.plastic) for slot in ordered(b.slots))
    volume = b.length[0] * b.area_cell
    stored = {"elastic": [Field("elastic", CELLS, volume * points.energy)], "surface": surface}
    stored |= {"supports": [one.stored for one in of.springs]} if of.springs else {}
    powers = of.powers(Field("power_plastic_0", CELLS, volume * points.dissipation * of.work))
    shown = {**of.shown(stored), **_shown(b, cell, conjugate, tension_now, points)}
    return program_of(b, rates, powers, shown, points.profiles)


def _unknowns(b: Builder) -> tuple[list[Neighbours], ...]:
    """Places, velocities, velocities with those of supports, quaternions and spins of all nodes."""
    terms, at = b.equations.terms, b.supports
    moves, turns = terms.inertia or b.equations.law.viscosity is not None, b.equations.law.viscosity is not None
    across = (b.first.holds_height, b.last.holds_height)
    holds = ((b.first.holds_x, b.last.holds_x), across, across)
    ends = ((at.left_x, at.right_x), (0, at.right_y), (0, at.right_z))
    places = [
        b.unknown(Slot(name, "node", are, moves, speed if moves else "", section=False), *end)
        for name, speed, are, end in zip(PLACES, SPEEDS, holds, ends, strict=True)
    ]
    speeds: list[Neighbours] = [Same()] * 3
    moved = speeds
    if moves:
        slots = zip(SPEEDS, holds, strict=True)
        speeds = [b.unknown(Slot(name, "node", are, terms.inertia, "", section=False)) for name, are in slots]
        last = [one * b.scale for one in (at.right_u, at.right_v, at.right_w)]
        moved = [
            plain if not are[1] or ca.SX(end).is_zero() else b.unknown(b.slots[name], 0, end, f"{name}_moving")
            for name, plain, are, end in zip(SPEEDS, speeds, holds, last, strict=True)
        ]
    held = _clamps(at)
    turn = [
        b.unknown(Slot(name, "node", b.bends, turns, "", section=False), *pair)
        for name, pair in zip(TURN, zip(*held, strict=True), strict=True)
    ]
    spin: list[Neighbours] = [Same()] * 3
    if turns:
        rate = (at.right_spin * b.scale, 0, 0)
        spin = [
            b.unknown(Slot(name, "node", b.bends, False, "", section=False), 0, end)
            for name, end in zip(SPIN, rate, strict=True)
        ]
    return places, speeds, moved, turn, spin


def _quaternion(angle: Any, twist: Any) -> list[ca.SX]:
    """A clamp turned by an angle in the plane, and about its own normal."""
    c, s, a, t = (ca.SX(f(one / 2)) for one, f in ((angle, ca.cos), (angle, ca.sin), (twist, ca.cos), (twist, ca.sin)))
    return [c * a, c * t, s * t, s * a]


def _clamps(at: Held) -> tuple[list[ca.SX], list[ca.SX]]:
    """Quaternions that the supports hold."""
    return at.turns[0] or _quaternion(at.left_angle, ca.SX(0)), _right_clamp(at)


def _right_clamp(at: Held) -> list[ca.SX]:
    """The right clamp, turned about its own normal."""
    if not at.turns[1]:
        return _quaternion(at.right_angle, at.right_twist)
    w, x, y, z = at.turns[1]
    c, s = ca.cos(at.right_twist / 2), ca.sin(at.right_twist / 2)
    return [w * c - x * s, x * c + w * s, y * c + z * s, z * c - y * s]


def _natural(b: Builder) -> list[ca.SX]:
    """Natural twist and curvatures of a cell [1/m]: the scene's, or those of its shape."""
    if b.body.natural is not None:
        return [b.place(name)[0] for name in NATURAL_PLACES]
    return [b.values[spatial.natural_twist], ca.SX(0), b.values[symbols.kappa_0]]


def _cell(
    b: Builder,
    places: Sequence[Neighbours],
    moved: Sequence[Neighbours],
    turn: Sequence[Neighbours],
    spin: Sequence[Neighbours],
) -> _Cell:
    """Strains of the cell behind a node, and their rates where a viscous stress asks for them."""
    length = b.length[0]
    slope = [(r[1] - r[0]) / length for r in places]
    every = ca.SX.sym("slope_and_turns", 11)
    expressions = ca.vertcat(*cell_strains(*_split(every), length * b.span))
    first, last = ([q[n] for q in turn] for n in (0, 1))
    now = ca.vertcat(*slope, *first, *last)
    strains = ca.vertsplit(ca.substitute(expressions, every, now))
    rates = [ca.SX(0)] * 6
    if not isinstance(spin[0], Same):
        speed = [(r[1] - r[0]) / length / b.scale for r in moved]
        turning = [one / b.scale for n, q in ((0, first), (1, last)) for one in _turning(q, [o[n] for o in spin])]
        moving = ca.jtimes(expressions, every, ca.vertcat(*speed, *turning))
        rates = ca.vertsplit(ca.substitute(moving, every, now))
    return _Cell(slope, strains, rates)


def _split(every: ca.SX) -> tuple[list[ca.SX], list[ca.SX], list[ca.SX]]:
    """r_X of a cell and the quaternions of its nodes."""
    parts = ca.vertsplit(every)
    return parts[:3], parts[3:7], parts[7:]


def cell_strains(slope: list[ca.SX], first: list[ca.SX], last: list[ca.SX], length: ca.SX) -> list[ca.SX]:
    """Gamma = R_m^T r_X, and kappa from the relative turn of two nodes: 2 atan2(|v|, w)/|v| v over the length [m].

    Of r_X and the quaternions of both nodes.
    """
    middle = tuple(a + z for a, z in zip(first, last, strict=True))
    w, *v = spatial.relative(tuple(first), tuple(last))
    size = ca.sqrt(sum((one**2 for one in v), ca.SX(0)) + _ROUND)
    angle = 2 * ca.atan2(size, w) / size / length
    return [*spatial.unrotated(middle, tuple(slope)), *(angle * one for one in v)]  # type: ignore[arg-type]


def _turning(q: Sequence[ca.SX], spin: Sequence[ca.SX]) -> list[ca.SX]:
    """Rate of a quaternion that turns with a spin in its own axes: q (0, spin)/2."""
    w, x, y, z = q
    a, b, c = spin
    return [
        -(x * a + y * b + z * c) / 2,
        (w * a + y * c - z * b) / 2,
        (w * b + z * a - x * c) / 2,
        (w * c + x * b - y * a) / 2,
    ]


def _act(b: Builder, cell: _Cell, turn: Sequence[Neighbours], conjugate: Sequence[ca.SX]) -> None:
    """Force of a cell and its torques on its nodes, of the conjugates of its strains (virtual power)."""
    length = b.length[0] * b.span
    every, held = ca.SX.sym("slope_and_turns", 11), ca.SX.sym("conjugate", 6)
    strains = ca.vertcat(*cell_strains(*_split(every), length))
    slopes = ca.jtimes(strains, every, held, True)
    first, last = ([q[n] for q in turn] for n in (0, 1))
    given = ca.vertcat(every, held)
    found = ca.vertsplit(ca.substitute(slopes, given, ca.vertcat(*cell.slope, *first, *last, *conjugate)))
    cell.force = found[:3]
    on_first, on_last = _of_a_turn(first, found[3:7]), _of_a_turn(last, found[7:])
    cell.torques = [-length * one / 2 for one in on_first], [-length * one / 2 for one in on_last]


def _of_a_turn(q: Sequence[ca.SX], slope: Sequence[ca.SX]) -> list[ca.SX]:
    """G(q)^T of a slope in the four components: what is conjugate to a spin, times two."""
    w, x, y, z = q
    a, b, c, d = slope
    return [-x * a + w * b + z * c - y * d, -y * a - z * b + w * c + x * d, -z * a + y * b - x * c + w * d]


@dataclass
class _Body:
    """What acts on the nodes."""

    b: Builder
    places: list[Neighbours]
    speeds: list[Neighbours]
    moved: list[Neighbours]
    turn: list[Neighbours]
    spin: list[Neighbours]
    force: list[Neighbours]
    torque: list[list[Neighbours]]  # Of a cell on its first node, and on its last
    stretch: Neighbours
    double_force: Neighbours | None

    def __post_init__(self) -> None:
        b = self.b
        load = {**b.values, symbols.t: b.time * b.scale}
        self.gravity, self.gravity_rate = printed(b.equations.load, load), printed(b.equations.load_rate, load)
        self.direction = b.supports.direction
        self.mass = b.place("mass")[0]
        self.unit = b.scale**2 / b.span
        self.work = b.scale / energy_scale(b.density, b.span, b.scale)
        self.springs = end_springs(b, self.places, self.turn, _clamps(b.supports)) if b.body.supports.springs else ()

    def _mass(self, behind: int | None) -> ca.SX:
        """Of a node over density, area and rest length; at a free end with what hangs there."""
        tip = self.b.named[TIP_MASS] / (self.b.density * self.b.span) if self.b.body.tip_mass else ca.SX(0)
        return self.mass + (tip if behind is None else 0)

    def rate(self, slot: Slot, plastic: Mapping[str, ca.SX]) -> Field:
        """Rate of an unknown, or what must vanish for an algebraic one."""
        b, name = self.b, f"f_{slot.name}"
        if slot.rate:
            return Field(name, slot.where, b.leaves.symbol(Leaf("unknown", slot.rate)))
        if slot.name in plastic:
            return Field(name, slot.where, plastic[slot.name] * b.scale)
        if slot.name in TURN:
            acting = self._of_turn(slot)
        elif slot.name in SPIN:
            acting = self._twisting(SPIN.index(slot.name))
        else:
            names = SPEEDS if slot.name in SPEEDS else PLACES
            acting = self._falling(names.index(slot.name))
        sides = zip((0, -1), ((None, 0), (-1, None)), slot.held, strict=True)
        ends = {site: acting(*cells) for site, cells, held in sides if not held}
        if slot.name in (TURN[1], SPIN[0]) and not slot.differential:
            # A pin leaves the normal free but does not let it spin: the filament would, without resistance.
            supports = zip((0, -1), (b.first, b.last), strict=True)
            pinned = [site for site, one in supports if not (one.is_free or one.carries_moment)]
            ends |= {site: self._spinning(slot) for site in pinned}
        return Field(name, INNER, acting(-1, 0), ends)

    def _spinning(self, slot: Slot) -> ca.SX:
        """What vanishes where a node does not turn about its own normal: the first part of its quaternion's vector."""
        q = [one[0] for one in self.turn]
        return q[1] if slot.name in TURN else _turning(q, [one[0] for one in self.spin])[1]

    def _falling(self, way: int) -> Sided:
        b, force = self.b, self.force[way]

        def acting(before: int | None, behind: int | None) -> ca.SX:
            net = (0 if behind is None else force[behind]) - (0 if before is None else force[before])
            if behind is None and b.body.tip_force:
                net += b.named[TIP_FORCE[way]]
            net += sum((one.pull[way] for one in self.springs if one.acts(before, behind)), ca.SX(0))
            per_mass = self.unit / (self._mass(behind) * b.density * b.span)
            return ca.SX(net * per_mass + self.gravity * self.unit * self.direction[way])

        return acting

    def _twisting(self, axis: int) -> Sided:
        """Torque on a node in its own axes, over a mass as that of places (a row of a matrix is not scaled)."""
        b, (first, last) = self.b, (part[axis] for part in self.torque)
        factor = 1 / b.node[0] * (b.scale**2 / (b.density * b.span**3))

        def acting(before: int | None, behind: int | None) -> ca.SX:
            net = (0 if behind is None else first[behind]) + (0 if before is None else last[before])
            if behind is None and b.body.tip_torque:
                net += self._dead_torque()[axis]
            for one in self.springs:
                if one.acts(before, behind):
                    net -= b.span / 2 * _of_a_turn([q[0] for q in self.turn], one.by_turn)[axis]
            return ca.SX(net * factor)

        return acting

    def _dead_torque(self) -> Three:
        """Torque on the free end in its own axes."""
        dead = tuple(self.b.named[name] for name in TIP_TORQUE)
        return spatial.unrotated(tuple(one[0] for one in self.turn), dead)  # type: ignore[arg-type]

    def _of_turn(self, slot: Slot) -> Sided:
        """The length of a quaternion and the balance of its torques, or its rate where it has a spin."""
        number, q = TURN.index(slot.name), [one[0] for one in self.turn]
        excess = sum((one**2 for one in q), ca.SX(0)) - 1
        if not slot.differential:
            return self._twisting(number - 1) if number else lambda _before, _behind: ca.SX(excess)
        rate = _turning(q, [one[0] for one in self.spin])[number] - excess * q[number]
        return lambda _before, _behind: ca.SX(rate)

    def powers(self, plastic: Field) -> dict[str, list[Field]]:
        """Plastic power, power of the changing load and of supports that move, and of the necking gradient."""
        b, at = self.b, self.b.supports
        down = sum((d * r[0] for d, r in zip(self.direction, self.places, strict=True)), ca.SX(0))
        weight = self.mass * (b.span * b.density)
        rising = -(b.span * b.density) * self.gravity_rate * down * self.work
        ends = {-1: self._mass(None) * rising} if b.body.tip_mass else {}
        load = [Field("power_load_0", Where(0, int(bool(ends))), self.mass * rising, ends)]
        # The force on the right support carries the last cell and its own share.
        pushed = sum(
            (
                (force[-1] - weight * self.gravity * d) * speed
                for force, d, speed in zip(
                    self.force, self.direction, (at.right_u, at.right_v, at.right_w), strict=True
                )
            ),
            ca.SX(0),
        )
        for spring in self.springs:
            if spring.site and not b.last.holds_height:
                speeds = zip(spring.pull, (at.right_u, at.right_v, at.right_w), strict=True)
                pushed = sum((pull * speed for pull, speed in speeds), ca.SX(0))
        pushed -= self.torque[1][0][-1] * at.right_spin / b.span
        if not ca.SX(pushed).is_zero():
            load.append(Field("power_load_1", Where(-1, 0, alone=True), pushed * self.work))
        if b.body.tip_torque and not isinstance(self.spin[0], Same):
            turned = sum((t * o[0] for t, o in zip(self._dead_torque(), self.spin, strict=True)), ca.SX(0))
            load.append(Field("power_load_2", Where(-1, 0, alone=True), turned * self.work / b.scale / b.span))
        gradient: list[Field] = []
        if self.double_force is not None:
            power = necking_power(b, self.double_force, self.places, self.moved, self.stretch) * self.work / b.scale
            gradient = [Field("power_gradient_0", INNER, power)]
        return {"plastic": [plastic], "load": load, "gradient": gradient}

    def shown(self, stored: Mapping[str, list[Field]]) -> dict[str, Field | tuple[Field, ...]]:
        """Places, turns and energies, in SI and per unit undeformed area."""
        b = self.b
        kinetic: list[Field] = []
        if b.equations.terms.inertia:
            square = sum((one[0] ** 2 for one in self.speeds), ca.SX(0))
            moving = square * (b.span / b.scale) ** 2 * b.density / 2 * b.span
            ends = {-1: self._mass(None) * moving} if b.body.tip_mass else {}
            kinetic.append(Field("moving", Where(0, int(bool(ends))), self.mass * moving, ends))
        down = sum((d * r[0] for d, r in zip(self.direction, self.places, strict=True)), ca.SX(0))
        falling = -down * b.span * b.density * self.gravity * b.span
        ends = {}
        if b.body.tip_mass or b.body.tip_force:
            pulled = sum((b.named[n] * r[0] for n, r in zip(TIP_FORCE, self.places, strict=True)), ca.SX(0))
            hanging = self._mass(None) * falling - (pulled * b.span if b.body.tip_force else 0)
            ends = {-1: ca.SX(hanging)}
        weight = Field("weight", Where(0, int(bool(ends))), self.mass * falling, ends)
        kept = {f"energy_{name}": tuple(one.times(b.span) for one in fields) for name, fields in stored.items()}
        double = ca.SX(0) if self.double_force is None else self.double_force[0]
        return {
            **{name: Field(name, NODES, r[0] * b.span) for name, r in zip(PLACES, self.places, strict=True)},
            **{name: Field(name, NODES, q[0]) for name, q in zip(TURN, self.turn, strict=True)},
            "stretch": Field("stretch", CELLS, self.stretch[0]),
            "double_force": Field("double_force", INNER, double),
            "energy_kinetic": tuple(kinetic),
            **kept,
            "energy_potential": (weight,),
        }


def _shown(
    b: Builder, cell: _Cell, conjugate: Sequence[ca.SX], tension: ca.SX, points: Sampled
) -> dict[str, Field | tuple[Field, ...]]:
    """What a run stores of the cells; curvature, moment, shear and shear force are those of the plane."""
    Lam, second, third, twist, k_2, k_3 = cell.strains
    values = {
        "relative_thickness": Lam**-0.5 * b.relative,
        "curvature": k_3 / Lam,
        "curvature_2": k_2 / Lam,
        "twist": twist,
        "shear": second / Lam,
        "shear_3": third / Lam,
        "tension": tension,
        "shear_force": conjugate[1],
        "shear_force_3": conjugate[2],
        "torque": conjugate[3],
        "moment_2": conjugate[4],
        "moment": -conjugate[5],
        "stress_mean": points.means[MEANS[0]],
        "stress_bending": points.means[MEANS[1]] / float(b.equations.shape.zeta_squared),
    }
    return {name: Field(name, CELLS, ca.SX(value)) for name, value in (values | points.shown).items()}
