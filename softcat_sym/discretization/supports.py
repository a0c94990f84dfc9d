"""Where the supports are and how the right one moves; and a section that varies along the filament."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from softcat_sym.discretization.grid import Grid
from softcat_sym.discretization.unknowns import Floats


@dataclass(frozen=True)
class ThicknessProfile:
    """Relative thickness, one where it is the scene's."""

    # At the nodes and in the middle of the cells; None for a filament that is the same everywhere, which then leaves
    # nothing of this in the graph.
    nodes: Floats | None = None
    cells: Floats | None = None

    @classmethod
    def sampled(cls, values: tuple[float, ...], grid: Grid) -> ThicknessProfile:
        """The profile on a grid, linear between the given values at equal distances from left to right."""
        if not values:
            return cls()
        at = np.linspace(-0.5, 0.5, len(values))
        return cls(np.interp(grid.nodes, at, values), np.interp(grid.centres, at, values))


def node_mass(grid: Grid, profile: ThicknessProfile, power: int) -> Floats:
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
EXIT_PLACES = ("exit_node", "exit_cell")
"""Times at which a node and the middle of a cell come out of a nozzle [s]."""
NATURAL_PLACES = ("k0_1", "k0_2", "k0_3")
"""Natural twist and curvatures of a cell."""
END_TURNS = tuple(tuple(f"{side}_turn_{n}" for n in range(4)) for side in ("left", "right"))
"""Quaternions of clamps that hold the ends of a shape."""
DIRECTION = ("direction_x", "direction_y", "direction_z")
STUB, NOZZLE_PLACE, GUIDE = "extrusion_start", ("nozzle_x", "nozzle_y"), "guide_resistance"
"""Length that has come out at t = 0; first place of the nozzle; how stiffly it guides the nodes inside it."""


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
    springs: tuple[str, ...] = ()  # Names of the stiffnesses of ends that give way
    feeds: int = 0  # Rows of the feed of a nozzle, which then is the right support; none without

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the numbers that it needs."""
        plain = ((SPAN, self.apart), (DROP, self.lowered), (LEFT_ANGLE, self.left_turned))
        names = [name for name, needed in (*plain, (RIGHT_ANGLE, self.right_turned)) if needed]
        kinds = ("time", "dx", "dy", *(("dz",) if self.sideways else ()))
        names += [path_name(kind, row) for row in range(self.rows) for kind in kinds]
        if self.feeds:
            names += [STUB, *NOZZLE_PLACE, GUIDE]
            names += [feed_name(kind, row) for row in range(self.feeds) for kind in ("time", "speed")]
        names += [turn_name(kind, row) for row in range(self.turns) for kind in ("time", "angle")]
        names += [name for turn, needed in zip(END_TURNS, self.curved, strict=True) for name in turn if needed]
        return (*names, *(DIRECTION if self.directed else ()), *self.springs)


@dataclass(frozen=True)
class FilamentBody:
    """What of the filament's body and its supports a graph has to know, beyond equations and grid."""

    supports: Supports = field(default_factory=Supports)  # Where they are and how they move
    profile: ThicknessProfile = field(default_factory=ThicknessProfile)  # How the section varies along the filament
    weighted: bool = False  # Whether a mass hangs at midspan
    tip_mass: bool = False  # Whether one hangs at a free right end, and whether a force acts there
    tip_force: bool = False
    tip_torque: bool = False
    natural: Floats | None = None  # Twist and curvatures of each cell in its shape [1/m], if it has one
    # Times at which nodes and the middles of cells come out of a nozzle [s], if their age counts.
    exits: tuple[Floats, Floats] | None = None

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the numbers that it needs."""
        tip = (*((TIP_MASS,) if self.tip_mass else ()), *(TIP_FORCE if self.tip_force else ()))
        tip = (*tip, *(TIP_TORQUE if self.tip_torque else ()))
        return (*self.supports.parameters, *((POINT_MASS,) if self.weighted else ()), *tip)


def path_name(kind: str, row: int) -> str:
    """Name of one number of the path: ``motion_0_time``, ``motion_0_dx``, ..."""
    return f"motion_{row}_{kind}"


def feed_name(kind: str, row: int) -> str:
    """Name of one number of the feed: ``feed_0_time``, ``feed_0_speed``, ..."""
    return f"feed_{row}_{kind}"


def turn_name(kind: str, row: int) -> str:
    """Name of one number of the twist of the right clamp: ``turn_0_time``, ``turn_0_angle``."""
    return f"turn_{row}_{kind}"
