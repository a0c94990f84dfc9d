"""The filament, in its plane or in space: balance of its nodes, its powers, and what a run stores of it."""

from __future__ import annotations

import casadi as ca

from softcat_sym.discretization.body_forces import outer_forces
from softcat_sym.discretization.casadi_printer import printed
from softcat_sym.discretization.cell import (
    Builder,
    Exit,
    Mechanics,
    Program,
    Sided,
    Turning,
    necking_power,
    ordered,
    program_of,
)
from softcat_sym.discretization.heat_balance import heating
from softcat_sym.discretization.kirchhoff import kirchhoff
from softcat_sym.discretization.nozzle import Guided, cut_by
from softcat_sym.discretization.parameters import energy_scale
from softcat_sym.discretization.section_rule import SectionRule
from softcat_sym.discretization.shearing import shearing
from softcat_sym.discretization.stencil import UNKNOWN, Field, Neighbours
from softcat_sym.discretization.supports import POINT_MASS, TIP_FORCE, TIP_MASS, FilamentBody
from softcat_sym.discretization.unknowns import (
    CELLS,
    HEAT_LOST,
    INNER,
    LOST_AT_EXIT,
    NODES,
    PLACES,
    SPEEDS,
    TURN,
    WORK_OF_AGEING,
    WORK_OF_NOZZLE,
    SiteRange,
    Slot,
)
from softcat_sym.physics import symbols
from softcat_sym.physics.exit_cell import dilution
from softcat_sym.physics.section_equations import FilamentEquations
from softcat_sym.physics.spatial import spatial_section
from softcat_sym.scene.ends import Support


def build(
    equations: FilamentEquations, ends: tuple[Support, Support], body: FilamentBody, rule: SectionRule | None
) -> Program:
    """A filament of these equations between two ends, as fields; `rule` samples a section that is resolved."""
    b = Builder(equations, ends, body)
    if b.supports.nozzle is not None:
        cut_by(b, b.supports.nozzle)
    if rule is not None and rule.is_spatial:
        terms = b.equations.terms
        if b.half or b.equations.clocks or terms.hardens or terms.heat or b.equations.densities or terms.rotary_inertia:
            raise ValueError("a filament in three dimensions has neither a half span nor clocks, heat or a bath")
        section = spatial_section(equations.shape, equations.law, natural=equations.terms.curved)
        return _Balance(b, shearing(b, rule, section)).program()
    if rule is not None and equations.resolved is not None:
        return _Balance(b, shearing(b, rule, equations.resolved)).program()
    return _Balance(b, kirchhoff(b)).program()


_SIDES = ((0, (None, 0)), (-1, (-1, None)))
"""End nodes, and the distances of the cells before and behind them."""
_AT_RIGHT = SiteRange(-1, 0, alone=True)


class _Balance:
    """Rates of all unknowns, powers and observables, in units of rest length and time scale."""

    def __init__(self, b: Builder, of: Mechanics) -> None:
        self.b, self.of, span = b, of, b.span
        load = {**b.values, symbols.t: b.time * b.scale}
        self.gravity, self.gravity_rate = printed(b.equations.load, load), printed(b.equations.load_rate, load)
        self.mass = b.place("mass")[0] if b.exit is None else b.borne[0]  # Of a node over density, area, rest length
        if b.body.weighted:
            self.mass += b.place("hung")[0] * (b.named[POINT_MASS] / (b.density * span))
        self.unit = b.scale**2 / span
        self.down = sum((d * r[0] for d, r in zip(b.supports.direction, of.places, strict=False)), ca.SX(0))
        self.rotary = ca.SX(0)
        if b.equations.resolved is not None:
            self.rotary = printed(b.equations.resolved.rotary_inertia, b.values)
        self.outer, self.heat = outer_forces(b, of), heating(b, of)
        of.energies |= self.outer.energies
        self.support = self._support()
        self.guided = {} if b.exit is None else self._guided(b.exit)

    def program(self) -> Program:
        """The filament as fields."""
        b, of = self.b, self.of
        rates = tuple(self._rate(slot) for slot in ordered(b.slots))
        shown = self._observables() | self.heat.shown
        linear = {
            name: (1.0, 0.0) if name.startswith("a_0") else (0.0, 1.0) for name in b.slots if name.startswith("a_")
        }
        # Where only slopes are in motion nothing balances along x.
        known = b.equations.terms.stretches and len(of.places) == 2
        pulled = (Field(f"support_{way}", _AT_RIGHT, one) for way, one in zip("xy", self.support, strict=known))
        return program_of(b, rates, self._powers(), shown, of.profiles or linear, tuple(pulled) if known else ())

    def _heavy(self, behind: int | None) -> ca.SX:
        """Mass of a node; at a free end with what hangs there."""
        b = self.b
        tip = b.named[TIP_MASS] / (b.density * b.span) if b.body.tip_mass and behind is None else ca.SX(0)
        return self.mass + tip

    def _of_masses(self, name: str, value: ca.SX) -> Field:
        """A field of the nodes in proportion to their masses."""
        ends = {-1: self._heavy(None) * value} if self.b.body.tip_mass else {}
        return Field(name, SiteRange(0, int(bool(ends))), self.mass * value, ends)

    def _rate(self, slot: Slot) -> Field:
        """Rate of an unknown, or what must vanish for an algebraic one: the rate of its momentum."""
        b, of, name = self.b, self.of, f"f_{slot.name}"
        if slot.rate:
            return Field(name, slot.where, Neighbours(b.leaves, UNKNOWN, slot.rate)[0])
        if slot.name in b.rates:
            return b.rates[slot.name]
        if slot.name in of.plastic:
            rate = of.plastic[slot.name]
            if b.exit is not None:
                # What follows the time, and not a strain, waits until it is out.
                waits = any(slot.name.startswith(f"{clock.name}_") for clock in b.equations.clocks)
                state = Neighbours(b.leaves, UNKNOWN, slot.name)[0]
                rate = (b.exit.out if waits else 1) * rate + dilution(state, b.exit.diluted[0])
            return Field(name, slot.where, rate * b.scale)
        if slot.name in self.guided:
            return Field(name, slot.where, self.guided[slot.name].rate)
        if of.turning is not None and slot.name in of.turning.torques:
            acting, fixed = self._turned(slot, of.turning), of.turning.fixed.get(slot.name, {})
        elif self.outer.adds_mass and slot.name in SPEEDS:
            return self._with_added_mass(slot)
        else:
            acting, fixed = self._accelerated((SPEEDS if slot.name in SPEEDS else PLACES).index(slot.name)), {}
        # Nodes beside which there is a cell on one side only are written out by themselves.
        ends = {site: acting(*cells) for (site, cells), held in zip(_SIDES, slot.held, strict=True) if not held}
        return Field(name, INNER, acting(-1, 0), ends | fixed)

    def _turned(self, slot: Slot, turning: Turning) -> Sided:
        """What the cells beside a node, the spring of an end and a dead torque do to its frame.

        A torque is divided by the mass and the square of the span, not by the rotary inertia, where it is algebraic:
        sparse factorisations do not scale rows, and one that is thousands of times larger than the others blurs them.
        """
        b = self.b
        inertia = self.rotary if slot.differential else b.density * b.span**2
        factor = 1 / b.place("node")[0] * (b.scale**2 / (inertia * b.span))
        net = self._torque(slot.name, turning)
        return lambda before, behind: ca.SX(net(before, behind) * factor)

    def _torque(self, name: str, turning: Turning) -> Sided:
        """Torque on the frame of a node [Pa m], by the unknown that balances it."""
        b, axis = self.b, list(turning.torques).index(name)

        def acting(before: int | None, behind: int | None) -> ca.SX:
            net = turning.torques[name](before, behind)
            if behind is None and turning.dead:
                net += turning.dead[axis]
            for one in self.outer.springs:
                if one.acts(before, behind):
                    net -= b.span * turning.of_slopes(one.by_turn)[axis]
            return ca.SX(net)

        return acting

    def _guided(self, exit_: Exit) -> dict[str, Guided]:
        """Coordinates of the nodes of a strand that is laid, by the unknowns that balance them."""
        b, turning, nozzle = self.b, self.of.turning, exit_.nozzle
        row, found = self.unit / (b.density * b.span * b.place("node")[0]), dict[str, Guided]()
        for way, place in enumerate(self.of.places):
            name = next(one for one in (SPEEDS[way], PLACES[way]) if one in b.slots)
            weight = b.density * b.span * self.gravity * b.supports.direction[way]
            force = b.nodes(
                f"net_{PLACES[way]}",
                lambda *beside, way=way, weight=weight: self._net(way, *beside) + self.mass * weight,
            )
            off = nozzle.place(way, b.X[0]) - place[0]
            speed = None if name == PLACES[way] else self.of.speeds[way][0]
            given = force[0], off, nozzle.velocity[way] * b.scale, speed
            found[name] = Guided(b, exit_, *given, row, accelerates=b.slots[name].differential)
        if turning is None:
            raise ValueError("a strand that is laid has no angle for its nozzle to hold")
        (name,) = turning.torques
        torque = b.nodes("net_turn", self._torque(name, turning))[0] / b.span
        off = b.supports.right_angle - turning.frame[0][0]
        lever = b.values[symbols.h0] ** 2 / 12 / b.span**2
        speed = None if name == "psi" else turning.spin[0][0]
        found[name] = Guided(b, exit_, torque, off, ca.SX(0), speed, row, lever)
        return found

    def _net(self, way: int, before: int | None, behind: int | None) -> ca.SX:
        """What the forces of the cells beside a node leave, with those from outside."""
        b, force, nothing = self.b, self.of.force[way], ca.SX(0)
        inner = (nothing if behind is None else force[behind]) - (nothing if before is None else force[before])
        tip = b.named[TIP_FORCE[way]] if behind is None and b.body.tip_force else nothing
        return inner + tip + self.outer.at(way, before, behind)

    def _accelerated(self, way: int) -> Sided:
        b = self.b
        weight = self.gravity * self.unit * b.supports.direction[way]

        def acting(before: int | None, behind: int | None) -> ca.SX:
            per_mass = 1 / self._heavy(behind) * (self.unit / (b.density * b.span))
            return ca.SX(self._net(way, before, behind) * per_mass + weight)

        return acting

    def _with_added_mass(self, slot: Slot) -> Field:
        """Acceleration of a node whose mass differs with the direction: two components, solved together.

        Where the other component is held, its force is the support's.
        """
        b, way = self.b, int(slot.name == "v")
        two = {"u", "v"} <= set(b.slots)
        other = b.slots["u" if way else "v"].held if two else (True, True)
        mass = self.mass * b.density * b.span

        def acting(before: int | None, behind: int | None, *, alone: bool) -> ca.SX:
            along, across = (self._net(k, before, behind) for k in (0, 1))
            across -= mass * self.gravity
            xx, xy, yy = self.outer.mass(before, behind)
            xx, yy = xx + mass, yy + mass
            if alone:
                return ca.SX(self.unit * (across / yy if way else along / xx))
            solved = xx * across - xy * along if way else yy * along - xy * across
            return ca.SX(self.unit * solved / (xx * yy - xy**2))

        sides = zip(_SIDES, slot.held, other, strict=True)
        ends = {site: acting(*cells, alone=held) for (site, cells), is_held, held in sides if not is_held}
        return Field(f"f_{slot.name}", INNER, acting(-1, 0, alone=not two), ends)

    def _support(self) -> list[ca.SX]:
        """Force of the right support: it carries the last cell and its own share, or pulls by its spring."""
        b = self.b
        for spring in self.outer.springs:
            if spring.site and not b.last.holds_height:
                return list(spring.pull)
        weight = self.mass * b.density * b.span * self.gravity
        return [
            force[-1] - weight * b.supports.direction[way] - self.outer.at(way, -1, None)
            for way, force in enumerate(self.of.force)
        ]

    def _powers(self) -> dict[str, list[Field]]:
        """Plastic power, power of the changing load, of the gradient and of what effects dissipate, site by site.

        In `energy_scale` units; what is integrated beside the unknowns.
        """
        b, of, outer, at = self.b, self.of, self.outer, self.b.supports
        scale = b.scale / energy_scale(b.density, b.span, b.scale)
        load = [self._of_masses("power_load_0", -(b.span * b.density * self.gravity_rate * scale) * self.down)]
        speeds = zip(self.support, (at.right_u, at.right_v, at.right_w), strict=False)
        moved = sum((force * speed for force, speed in speeds), ca.SX(0))
        turning = of.turning
        if turning is not None and len(turning.spin) > 1:
            first = next(iter(turning.torques.values()))
            moved -= first(-1, None) * at.right_spin / b.span
        if not moved.is_zero() and b.exit is None:
            load.append(Field("power_load_1", _AT_RIGHT, moved * scale))
        if turning is not None and turning.dead and len(turning.spin) > 1:
            turned = sum((t * o[0] for t, o in zip(turning.dead, turning.spin, strict=True)), ca.SX(0))
            load.append(Field("power_load_2", _AT_RIGHT, turned * scale / b.scale / b.span))
        load += [one.times(scale) for one in outer.power]
        gradient: list[Field] = []
        if of.double_force is not None:
            power = necking_power(b, of.double_force, of.places, of.moved, of.stretch)
            gradient = [Field("power_gradient_0", INNER, power * (scale / b.scale))]
        plastic = [one.times(scale, f"power_plastic_{k}") for k, one in enumerate(of.dissipation)]
        lost = {name: [one.times(scale) for one in fields] for name, fields in outer.dissipation.items()}
        softened = [one.times(scale) for one in self.heat.softening]
        groups = {"plastic": plastic, "load": load, "gradient": gradient, **lost}
        groups |= {"energy_softening": softened} if softened else {}
        groups |= {HEAT_LOST: self.heat.lost} if self.heat.lost else {}
        if b.equations.clocks:
            groups[WORK_OF_AGEING] = [one.times(scale, f"power_ageing_{k}") for k, one in enumerate(of.ageing)]
        if b.exit is not None:
            work = [Field("power_support", _AT_RIGHT, moved)]
            work += [Field(f"power_nozzle_{name}", b.slots[name].where, one.power) for name, one in self.guided.items()]
            groups[WORK_OF_NOZZLE] = [one.times(scale) for one in work]
            groups[LOST_AT_EXIT] = [one.times(scale) for one in self._lost_at_exit()]
        return groups

    def _lost_at_exit(self) -> list[Field]:
        """What stored energies lose as a cell comes out, at places and strains that stay [Pa/s]."""
        b, of = self.b, self.of
        stored = [one for fields in of.energies.values() for one in fields]
        passing = [one.mapped(f"exit_{one.name}", lambda value: -b.explicit_rate(value)) for one in stored]
        # Energy that a material which changes in time gains is counted by itself.
        aged = [one.times(ca.SX(1), f"exit_{one.name}") for one in of.ageing]
        carried = b.explicit_rate(self.mass) * b.span * b.density * self.gravity * self.down
        losses = [Field(f"exit_{name}", b.slots[name].where, one.loss) for name, one in self.guided.items()]
        return [*passing, *aged, Field("exit_weight", NODES, carried), *losses]

    def _observables(self) -> dict[str, Field | tuple[Field, ...]]:
        """What a run stores, in SI and per unit undeformed area."""
        b, of, span, terms = self.b, self.of, self.b.span, self.b.equations.terms
        # Velocities that are unknown for the sake of a viscous stress alone carry no energy.
        kinetic = []
        if terms.inertia:
            square = sum((one[0] ** 2 for one in of.speeds), ca.SX(0))
            kinetic = [self._of_masses("moving", square * (span / b.scale) ** 2 * b.density / 2 * span)]
            kinetic += [one.times(span) for one in self.outer.kinetic]
        if terms.rotary_inertia and of.turning is not None:
            turning = b.node[0] * of.turning.spin[0][0] ** 2 * self.rotary / (2 * b.scale**2)
            kinetic.append(Field("turning", NODES, turning * span))
        stored = {
            f"energy_{name}": tuple(one.times(span, name) for one in fields) for name, fields in of.energies.items()
        }
        guiding = (Field(f"guide_{name}", b.slots[name].where, one.energy * span) for name, one in self.guided.items())
        stored |= {"energy_guide": tuple(guiding)} if self.guided else {}
        weight = [self._of_masses("weight", -self.down * span * b.density * self.gravity * span)]
        if b.body.tip_force:
            pulled = sum((b.named[n] * r[0] for n, r in zip(TIP_FORCE, of.places, strict=True)), ca.SX(0))
            weight.append(Field("tip", _AT_RIGHT, -pulled * span))
        turn = zip(TURN, of.turning.frame, strict=True) if of.turning is not None and len(of.places) > 2 else ()
        return {
            **{name: Field(name, NODES, r[0] * span) for name, r in zip(PLACES, of.places, strict=False)},
            **{name: Field(name, NODES, q[0]) for name, q in turn},
            "stretch": Field("stretch", CELLS, of.stretch[0]),
            **{name: Field(name, CELLS, ca.SX(value)) for name, value in of.shown.items()},
            "double_force": Field("double_force", INNER, ca.SX(0) if of.double_force is None else of.double_force[0]),
            "energy_kinetic": tuple(kinetic),
            **stored,
            "energy_potential": tuple(weight),
            **({} if b.exit is None else self._of_nozzle(b.exit)),
        }

    def _of_nozzle(self, exit_: Exit) -> dict[str, Field | tuple[Field, ...]]:
        """What is out, and the force of the nozzle on the strand."""
        forces = [
            (way, self.support[k], *one) for k, (way, one) in enumerate(zip("xy", self.guided.items(), strict=False))
        ]
        return {"exposed": Field("exposed_share", CELLS, exit_.exposed[0])} | {
            f"nozzle_force_{way}": (
                Field(f"held_{way}", _AT_RIGHT, held),
                Field(f"guiding_{way}", self.b.slots[name].where, one.reaction),
            )
            for way, held, name, one in forces
        }
