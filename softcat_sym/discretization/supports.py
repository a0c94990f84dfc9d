"""Where the supports are and how the right one moves; and a section that varies along the filament."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.grid import Floats, Grid
from softcat_sym.physics import symbols


@dataclass(frozen=True)
class Profile:
    """Relative thickness, one where it is the scene's."""

    # At the nodes and in the middle of the cells, as symbols where the grid is an input; None for a filament that is
    # the same everywhere, which then leaves nothing of this in the graph.
    nodes: Floats | ca.SX | None = None
    cells: Floats | ca.SX | None = None

    @classmethod
    def sampled(cls, values: tuple[float, ...], grid: Grid) -> Profile:
        """The profile on a grid, linear between the given values at equal distances from left to right."""
        if not values:
            return cls()
        at = np.linspace(-0.5, 0.5, len(values))
        return cls(np.interp(grid.nodes, at, values), np.interp(grid.centres, at, values))


@dataclass(frozen=True)
class Outline:
    """Undeformed thickness [m] and relative area on cells and on nodes; numbers where nothing varies."""

    h_cells: Any  # Thickness
    h_nodes: Any
    area_cells: Any  # Area over that of the scene's thickness
    area_nodes: Any
    relative: Any  # Thickness of the cells over the scene's


def outline(profile: Profile, power: int, values: Mapping[symbols.Symbol, Any]) -> Outline:
    """The outline of a filament whose area goes with a power of its thickness."""
    h = values.get(symbols.h0)
    if profile.nodes is None or profile.cells is None or h is None:
        return Outline(h, h, 1.0, 1.0, 1.0)
    cells, nodes = as_values(profile.cells), as_values(profile.nodes)
    return Outline(h * cells, h * nodes, cells**power, nodes**power, cells)


def as_values(values: Floats | ca.SX) -> Any:
    """Numbers or symbols as CasADi has them."""
    return values if isinstance(values, ca.SX) else ca.DM(values)


def node_mass(grid: Grid, profile: Profile, power: int) -> Floats:
    """Mass that each node answers for, over density, undeformed area and rest length, shape (cells + 1,)."""
    half = grid.cell_length / 2
    if profile.cells is not None:
        half = half * np.asarray(profile.cells) ** power
    behind: Floats = np.concatenate([half, [0.0]])
    before: Floats = np.concatenate([[0.0], half])
    return behind + before


POINT_MASS = "point_mass_per_area"
SPAN, DROP, LEFT_ANGLE, RIGHT_ANGLE = "span", "drop", "left_angle", "right_angle"
TIP_MASS, TIP_FORCE = "tip_mass_per_area", ("tip_force_x", "tip_force_y", "tip_force_z")
TIP_TORQUE = ("tip_torque_x", "tip_torque_y", "tip_torque_z")
"""What hangs at the right end, what pulls there and what turns it, over the undeformed area."""
NATURAL_PLACES = ("k0_1", "k0_2", "k0_3")
"""Natural twist and curvatures of a cell."""
END_TURNS = tuple(tuple(f"{side}_turn_{n}" for n in range(4)) for side in ("left", "right"))
"""Quaternions of clamps that hold the ends of a shape."""
DIRECTION = ("direction_x", "direction_y", "direction_z")


@dataclass(frozen=True)
class Supports:
    """What of the supports a graph has to know; whatever is plain leaves nothing in it."""

    apart: bool = False  # Whether their horizontal distance differs from the rest length
    lowered: bool = False  # Whether the right one is lower
    left_turned: bool = False  # Whether a clamp is not level
    right_turned: bool = False
    rows: int = 0  # Points of the path of the right one; none if it stays
    sideways: bool = False  # Whether that path leaves the plane
    turns: int = 0  # Rows of the twist of the right clamp about its own normal
    curved: tuple[bool, bool] = (False, False)  # Whether the left and the right clamp hold the ends of a shape
    directed: bool = False  # Whether gravity points anywhere but down

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the numbers that it needs."""
        plain = ((SPAN, self.apart), (DROP, self.lowered), (LEFT_ANGLE, self.left_turned))
        names = [name for name, needed in (*plain, (RIGHT_ANGLE, self.right_turned)) if needed]
        kinds = ("time", "dx", "dy", *(("dz",) if self.sideways else ()))
        names += [path_name(kind, row) for row in range(self.rows) for kind in kinds]
        names += [turn_name(kind, row) for row in range(self.turns) for kind in ("time", "angle")]
        names += [name for turn, needed in zip(END_TURNS, self.curved, strict=True) for name in turn if needed]
        return (*names, *(DIRECTION if self.directed else ()))


@dataclass(frozen=True)
class Body:
    """What of the filament's body and its supports a graph has to know, beyond equations and grid."""

    supports: Supports = field(default_factory=Supports)  # Where they are and how they move
    profile: Profile = field(default_factory=Profile)  # How the section varies along the filament
    weighted: bool = False  # Whether a mass hangs at midspan
    tip_mass: bool = False  # Whether one hangs at a free right end, and whether a force acts there
    tip_force: bool = False
    tip_torque: bool = False
    natural: Floats | None = None  # Twist and curvatures of each cell in its shape [1/m], if it has one

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the numbers that it needs."""
        tip = (*((TIP_MASS,) if self.tip_mass else ()), *(TIP_FORCE if self.tip_force else ()))
        tip = (*tip, *(TIP_TORQUE if self.tip_torque else ()))
        return (*self.supports.parameters, *((POINT_MASS,) if self.weighted else ()), *tip)


def path_name(kind: str, row: int) -> str:
    """Name of one number of the path: ``motion_0_time``, ``motion_0_dx``, ..."""
    return f"motion_{row}_{kind}"


def turn_name(kind: str, row: int) -> str:
    """Name of one number of the twist of the right clamp: ``turn_0_time``, ``turn_0_angle``."""
    return f"turn_{row}_{kind}"


@dataclass(frozen=True)
class Held:
    """The supports at one instant; lengths in rest lengths, angles in rad, velocities in rest lengths per second."""

    left_x: ca.SX  # Positions; the left one has the height zero
    right_x: ca.SX
    right_y: ca.SX
    right_u: ca.SX  # Velocity of the right one
    right_v: ca.SX
    left_angle: ca.SX  # Tangent angles that clamps impose
    right_angle: ca.SX
    right_z: ca.SX  # Of a filament in three dimensions, with the velocity
    right_w: ca.SX
    right_twist: ca.SX  # Of the right clamp about its own normal, and its rate [1/s]
    right_spin: ca.SX
    turns: tuple[list[ca.SX], ...]  # Quaternions of clamps that hold the ends of a shape; empty elsewhere
    direction: tuple[ca.SX, ca.SX, ca.SX]  # Of gravity, of length one


def held(supports: Supports, given: Mapping[str, ca.SX], length: ca.SX, seconds: ca.SX) -> Held:
    """The supports at a time."""
    half = given[SPAN] / (2 * length) if supports.apart else ca.SX(0.5)
    drop = given[DROP] / length if supports.lowered else ca.SX(0)
    axes = ("dx", "dy", "dz") if supports.sideways else ("dx", "dy")
    moved, speed = _path([path_name, *axes], supports.rows, given, seconds)
    (twist,), (spin,) = _path([turn_name, "angle"], supports.turns, given, seconds)
    nothing = ca.SX(0)
    aside, aside_speed = (moved[2] / length, speed[2] / length) if supports.sideways else (nothing, nothing)
    down = (given[name] for name in DIRECTION) if supports.directed else (nothing, ca.SX(-1), nothing)
    return Held(
        left_x=-half,
        right_x=half + moved[0] / length,
        right_y=moved[1] / length - drop,
        right_u=speed[0] / length,
        right_v=speed[1] / length,
        left_angle=given[LEFT_ANGLE] if supports.left_turned else nothing,
        right_angle=given[RIGHT_ANGLE] if supports.right_turned else nothing,
        right_z=aside,
        right_w=aside_speed,
        right_twist=twist,
        right_spin=spin,
        turns=tuple(
            [given[name] for name in turn] if needed else []
            for turn, needed in zip(END_TURNS, supports.curved, strict=True)
        ),
        direction=tuple(down),  # type: ignore[arg-type]
    )


def _path(
    named: Sequence[Any], rows: int, given: Mapping[str, ca.SX], seconds: ca.SX
) -> tuple[list[ca.SX], list[ca.SX]]:
    """Displacements and velocities along straight pieces, from nothing at t = 0 and held after the last row.

    `named` has the function that names the numbers of a row, and what they are beside its time.
    """
    name, *axes = named
    points = [[ca.SX(0)] * (1 + len(axes))]
    points += [[given[name(kind, row)] for kind in ("time", *axes)] for row in range(rows)]
    place, speed = [ca.SX(0)] * len(axes), [ca.SX(0)] * len(axes)
    for (begin, *old), (end, *new) in itertools.pairwise(points):
        # A path may state its beginning at t = 0, a piece of no duration.
        lasting = ca.fmax(end - begin, 1e-300)
        share = ca.fmin(ca.fmax((seconds - begin) / lasting, 0), 1)
        under_way = ca.logic_and(seconds >= begin, seconds < end)
        for axis in range(len(axes)):
            change = new[axis] - old[axis]
            place[axis] += change * share
            speed[axis] += under_way * change / lasting
    return place, speed
