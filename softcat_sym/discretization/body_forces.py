"""What the densities of effects do to the nodes of a filament: forces, powers and stored energies."""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca
import sympy as sp

from softcat_sym.discretization.casadi_printer import printed
from softcat_sym.discretization.cell import Builder, Mechanics, derivatives, slopes_of
from softcat_sym.discretization.end_springs import EndSpring, end_springs
from softcat_sym.discretization.parameters import AREA
from softcat_sym.discretization.stencil import Field, Neighbours
from softcat_sym.discretization.unknowns import CELLS, NODES, SiteRange
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.densities import Densities

Pair = tuple[Neighbours, Neighbours]
Matrix = tuple[Neighbours, Neighbours, Neighbours]
Triple = tuple[ca.SX, ca.SX, ca.SX]

_PLACES, _RATES = (sy.x, sy.y), (sy.x_t, sy.y_t)
_LOAD_RATE = sp.Symbol("g_t_rate", real=True)
_TANGENT, _TANGENT_RATES = (sy.x_X, sy.y_X), (sy.x_Xt, sy.y_Xt)


@dataclass
class Outer:
    """Sums over the effects, per undeformed area."""

    on_nodes: list[tuple[ca.SX, ca.SX]] = field(default_factory=list)  # Forces on a node, right and up [Pa]
    on_cells: list[tuple[Pair, Pair]] = field(default_factory=list)  # Of cells: on the node before, and behind
    power: list[Field] = field(default_factory=list)  # Of the explicit change in time [Pa/s]
    dissipation: dict[str, list[Field]] = field(default_factory=dict)  # [Pa/s]
    energies: dict[str, list[Field]] = field(default_factory=dict)  # [Pa]
    kinetic: list[Field] = field(default_factory=list)  # [Pa]
    # Mass matrices (xx, xy, yy) of a node, and those that a cell gives to the node before and behind it [kg/m^2].
    masses: list[Triple] = field(default_factory=list)
    masses_of_cells: list[tuple[Matrix, Matrix]] = field(default_factory=list)
    springs: tuple[EndSpring, ...] = ()  # Of ends that give way

    def at(self, way: int, before: int | None, behind: int | None) -> ca.SX:
        """Force on a node between cells at these distances, to the right (0) or up (1)."""
        force = sum((one[way] for one in self.on_nodes), ca.SX(0))
        for on_left, on_right in self.on_cells:
            force += ca.SX(0) if before is None else on_right[way][before]
            force += ca.SX(0) if behind is None else on_left[way][behind]
        return force + sum((one.pull[way] for one in self.springs if one.acts(before, behind)), ca.SX(0))

    @property
    def adds_mass(self) -> bool:
        """Whether a node's mass is a matrix."""
        return bool(self.masses or self.masses_of_cells)

    def mass(self, before: int | None, behind: int | None) -> Triple:
        """What moves with a node between cells at these distances, beside its own mass (xx, xy, yy)."""
        total = [sum((one[k] for one in self.masses), ca.SX(0)) for k in range(3)]
        for on_left, on_right in self.masses_of_cells:
            for k in range(3):
                total[k] += ca.SX(0) if before is None else on_right[k][before]
                total[k] += ca.SX(0) if behind is None else on_left[k][behind]
        return total[0], total[1], total[2]


def outer_forces(b: Builder, of: Mechanics) -> Outer:
    """Forces of all densities; a density of a cell adds its share to the internal forces of the cells."""
    outer = Outer()
    for stated in b.equations.densities:
        one = stated if b.equations.terms.stretches else stated.level
        (_of_cells if one.of_a_cell else _of_nodes)(b, of, one, outer)
    if b.body.supports.springs:
        frame, clamps = ((), ((), ())) if of.turning is None else (of.turning.frame, of.turning.clamps)
        outer.springs = end_springs(b, of.places, frame, clamps)
        outer.energies["supports"] = [one.stored for one in outer.springs]
    return outer


def _of_nodes(b: Builder, of: Mechanics, densities: Densities, outer: Outer) -> None:
    speed = b.span / b.scale
    values = _given(b, b.area_node, b.h_node, b.X[0])
    values |= {one: place[0] * b.span for one, place in zip(_PLACES, of.places, strict=True)}
    values |= {one: moved[0] * speed for one, moved in zip(_RATES, of.moved, strict=True)}
    length = b.borne[0] * b.span / b.named[AREA]
    along = derivatives(densities.stored, _PLACES, values)
    across = derivatives(densities.dissipation, _RATES, values)
    outer.on_nodes.append((-length * (along[0] + across[0]), -length * (along[1] + across[1])))
    _audit(densities, NODES, length / b.span, values, _RATES, across, outer)
    if densities.kinetic != 0:
        motion = _kinetics(densities.kinetic, values)
        outer.masses.append((length * motion.mass[0], length * motion.mass[1], length * motion.mass[2]))
        outer.kinetic.append(Field(f"moving_{densities.label}", NODES, length / b.span * motion.energy))


def _of_cells(b: Builder, of: Mechanics, densities: Densities, outer: Outer) -> None:
    """Half of it at each node of a cell, with the cell's tangent: a mean velocity would not feel every other node."""
    name, speed, moved, area = densities.label, b.span / b.scale, of.moved, b.named[AREA]
    densities = densities.of(b.equations.centreline.stretch)
    values = _given(b, b.area_cell, b.h_cell, b.X[0])
    values |= dict(zip(_TANGENT, slopes_of(b, of.places), strict=True))
    for slope_rate, velocity in zip(_TANGENT_RATES, moved, strict=True):
        values[slope_rate] = (velocity[1] - velocity[0]) / b.length[0] / b.scale
    pulls, masses = [], []
    half = b.length[0] / 2 / area
    inner = [ca.SX(0), ca.SX(0)]
    for end in (0, 1):
        for place, rate, position, velocity in zip(_PLACES, _RATES, of.places, moved, strict=True):
            values |= {place: position[end] * b.span, rate: velocity[end] * speed}
        values[sy.X] = b.X[end] * b.span
        by_place = derivatives(densities.stored, (*_PLACES, *_TANGENT), values)
        by_rate = derivatives(densities.dissipation, (*_RATES, *_TANGENT_RATES), values)
        total = [one + two for one, two in zip(by_place, by_rate, strict=True)]
        if densities.kinetic != 0:
            # A node that is held has no momentum.
            own = {rate: speed * unknown[end] for rate, unknown in zip(_RATES, of.speeds, strict=True)}
            motion = _kinetics(densities.kinetic, {**values, **own})
            total = [one + two for one, two in zip(total, (*motion.turned, *motion.by_tangent), strict=True)]
            masses.append(
                tuple(
                    b.stage(f"{name}_mass_{k}_{end}", CELLS, half * b.span * one) for k, one in enumerate(motion.mass)
                )
            )
            outer.kinetic.append(Field(f"moving_{name}_{end}", CELLS, half * motion.energy))
        pulls.append(
            tuple(b.stage(f"{name}_{way}_{end}", CELLS, -half * b.span * total[k]) for k, way in enumerate("xy"))
        )
        inner = [one + two / 2 / area for one, two in zip(inner, total[2:], strict=True)]
        _audit(densities, CELLS, half, values, (*_RATES, *_TANGENT_RATES), by_rate, outer)
    outer.on_cells.append((pulls[0], pulls[1]))  # type: ignore[arg-type]
    if masses:
        outer.masses_of_cells.append((masses[0], masses[1]))  # type: ignore[arg-type]
    of.force = tuple(
        b.stage(f"force_{way}_with_{name}", CELLS, of.force[k][0] + inner[k]) for k, way in enumerate("xy")
    )


@dataclass(frozen=True)
class _Kinetics:
    """What a kinetic energy T does, with the momentum p = T_v."""

    energy: ca.SX
    mass: Triple  # T_vv
    turned: tuple[ca.SX, ca.SX]  # dp/dt at constant velocity, as the tangent turns
    by_tangent: tuple[ca.SX, ca.SX]  # What the internal force gains, -T_{q_X}


def _kinetics(kinetic: sp.Expr, values: dict[sp.Symbol, ca.SX]) -> _Kinetics:
    velocity, tangent = (ca.SX.sym("velocity", 2), ca.SX.sym("tangent", 2))
    fresh = dict(zip((*_RATES, *_TANGENT), (*ca.vertsplit(velocity), *ca.vertsplit(tangent)), strict=True))
    energy = printed(kinetic, {**values, **fresh})
    momentum = ca.gradient(energy, velocity)
    mass = ca.jacobian(momentum, velocity)
    nothing = ca.SX(0)
    turning = ca.vertcat(*(values.get(one, nothing) for one in _TANGENT_RATES))
    turned = ca.jtimes(momentum, tangent, turning)
    by_tangent = -ca.gradient(energy, tangent)
    found = ca.vertcat(energy, mass[0, 0], mass[0, 1], mass[1, 1], turned, by_tangent)
    now = ca.vertcat(*(values.get(one, nothing) for one in fresh))
    e, xx, xy, yy, *rest = ca.vertsplit(ca.substitute(ca.densify(found), ca.vertcat(velocity, tangent), now))
    return _Kinetics(e, (xx, xy, yy), (rest[0], rest[1]), (rest[2], rest[3]))


def _given(b: Builder, area: ca.SX, h: ca.SX, X: ca.SX) -> dict[sp.Symbol, ca.SX]:
    """What a density may hold beside place and tangent; of the undeformed section with its area here."""
    now = {**b.values, sy.t: b.time * b.scale}
    return {
        **now,
        sy.g_t: printed(b.equations.load, now),
        _LOAD_RATE: printed(b.equations.load_rate, now),
        sy.A0: b.named[AREA] * area,
        sy.h0: h,
        sy.X: X * b.span,
    }


def _audit(
    densities: Densities,
    where: SiteRange,
    share: ca.SX,
    values: dict[sp.Symbol, ca.SX],
    rates: tuple[sp.Symbol, ...],
    by_rate: list[ca.SX],
    outer: Outer,
) -> None:
    name, part = densities.label, len(outer.power)
    if densities.stored != 0:
        energy = Field(f"energy_{name}_{part}", where, share * printed(densities.stored, values))
        outer.energies.setdefault(name, []).append(energy)
    given = by_rate[0] * printed(densities.carried, values)
    lost = sum((slope * values[rate] for slope, rate in zip(by_rate, rates, strict=True)), ca.SX(0)) - given
    if densities.dissipation != 0:
        outer.dissipation.setdefault(name, []).append(Field(f"lost_{name}_{part}", where, share * lost))
    stored = densities.stored
    changing = printed(sp.diff(stored, sy.t) + sp.diff(stored, sy.g_t) * _LOAD_RATE, values)
    outer.power.append(Field(f"power_{name}_{part}", where, share * (changing - given)))
