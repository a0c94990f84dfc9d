"""What the densities of effects do to the nodes of a filament: forces, powers and stored energies."""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca
import sympy as sp

from softcat_sym.discretization.cell import Builder, Mechanics, derivatives, printed
from softcat_sym.discretization.parameters import AREA
from softcat_sym.discretization.stencil import CELLS, NODES, Field, Neighbours, Where
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.densities import Densities

Pair = tuple[Neighbours, Neighbours]

_PLACES, _RATES = (sy.x, sy.y), (sy.x_t, sy.y_t)
_LOAD_RATE = sp.Symbol("g_t_rate", real=True)
_TANGENT, _TANGENT_RATES = (sy.x_X, sy.y_X), (sy.x_Xt, sy.y_Xt)


@dataclass
class Outer:
    """Sums over the effects, per undeformed area."""

    on_nodes: list[tuple[ca.SX, ca.SX]] = field(default_factory=list)  # Forces on a node, right and up [Pa]
    on_cells: list[tuple[Pair, Pair]] = field(default_factory=list)  # Of cells: on the node before, and behind
    power: list[Field] = field(default_factory=list)  # Of the explicit change in time [Pa/s]
    dissipation: list[Field] = field(default_factory=list)  # [Pa/s]
    energies: dict[str, list[Field]] = field(default_factory=dict)  # [Pa]

    def at(self, way: int, before: int | None, behind: int | None) -> ca.SX:
        """Force on a node between cells at these distances, to the right (0) or up (1)."""
        force = sum((one[way] for one in self.on_nodes), ca.SX(0))
        for on_left, on_right in self.on_cells:
            force += ca.SX(0) if before is None else on_right[way][before]
            force += ca.SX(0) if behind is None else on_left[way][behind]
        return force


def outer_forces(b: Builder, of: Mechanics) -> Outer:
    """Forces of all densities; a density of a cell adds its share to the internal forces of the cells."""
    outer = Outer()
    for one in b.equations.terms.densities:
        (_of_cells if one.of_a_cell else _of_nodes)(b, of, one, outer)
    return outer


def _of_nodes(b: Builder, of: Mechanics, densities: Densities, outer: Outer) -> None:
    speed = b.span / b.scale
    moved = of.u if of.moved is None else of.moved[0], of.v if of.moved is None else of.moved[1]
    values = _given(b, b.area_node, b.h_node, b.X[0])
    values |= {sy.x: of.x[0] * b.span, sy.y: of.y[0] * b.span, sy.x_t: moved[0][0] * speed, sy.y_t: moved[1][0] * speed}
    length = b.node[0] * b.span / b.named[AREA]
    along = derivatives(densities.stored, _PLACES, values)
    across = derivatives(densities.dissipation, _RATES, values)
    outer.on_nodes.append((-length * (along[0] + across[0]), -length * (along[1] + across[1])))
    _audit(densities, NODES, length / b.span, values, _RATES, across, outer)


def _of_cells(b: Builder, of: Mechanics, densities: Densities, outer: Outer) -> None:
    """Half of it at each node of a cell, with the cell's tangent: a mean velocity would not feel every other node."""
    name, speed, moved, area = densities.label, b.span / b.scale, of.moved or (of.u, of.v), b.named[AREA]
    densities = densities.of(b.equations.terms.centreline.stretch)
    values = _given(b, b.area_cell, b.h_cell, b.X[0])
    for slope, slope_rate, position, velocity in zip(_TANGENT, _TANGENT_RATES, (of.x, of.y), moved, strict=True):
        values[slope] = (position[1] - position[0]) / b.length[0]
        values[slope_rate] = (velocity[1] - velocity[0]) / b.length[0] / b.scale
    pulls = []
    half = b.length[0] / 2 / area
    inner = [ca.SX(0), ca.SX(0)]
    for end in (0, 1):
        for place, rate, position, velocity in zip(_PLACES, _RATES, (of.x, of.y), moved, strict=True):
            values |= {place: position[end] * b.span, rate: velocity[end] * speed}
        values[sy.X] = b.X[end] * b.span
        by_place = derivatives(densities.stored, (*_PLACES, *_TANGENT), values)
        by_rate = derivatives(densities.dissipation, (*_RATES, *_TANGENT_RATES), values)
        total = [one + two for one, two in zip(by_place, by_rate, strict=True)]
        pulls.append(
            tuple(b.stage(f"{name}_{way}_{end}", CELLS, -half * b.span * total[k]) for k, way in enumerate("xy"))
        )
        inner = [one + two / 2 / area for one, two in zip(inner, total[2:], strict=True)]
        _audit(densities, CELLS, half, values, (*_RATES, *_TANGENT_RATES), by_rate, outer)
    outer.on_cells.append((pulls[0], pulls[1]))  # type: ignore[arg-type]
    of.force = tuple(  # type: ignore[assignment]
        b.stage(f"force_{way}_with_{name}", CELLS, of.force[k][0] + inner[k]) for k, way in enumerate("xy")
    )


def _given(b: Builder, area: ca.SX, h: ca.SX, X: ca.SX) -> dict[sp.Symbol, ca.SX]:
    """What a density may hold beside place and tangent; of the undeformed section with its area here."""
    now = {**b.values, sy.t: b.time * b.scale}
    return {
        **now,
        sy.g_t: printed(b.equations.terms.load, now),
        _LOAD_RATE: printed(b.equations.terms.load_rate, now),
        sy.A0: b.named[AREA] * area,
        sy.h0: h,
        sy.X: X * b.span,
    }


def _audit(
    densities: Densities,
    where: Where,
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
    lost = sum((slope * values[rate] for slope, rate in zip(by_rate, rates, strict=True)), ca.SX(0))
    outer.dissipation.append(Field(f"lost_{name}_{part}", where, share * lost))
    stored = densities.stored
    changing = printed(sp.diff(stored, sy.t) + sp.diff(stored, sy.g_t) * _LOAD_RATE, values)
    outer.power.append(Field(f"power_{name}_{part}", where, share * changing))
