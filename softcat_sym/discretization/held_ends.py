"""What the supports hold at one instant, as expressions of the numbers of a run."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.discretization.supports import (
    DIRECTION,
    DROP,
    END_TURNS,
    LEFT_ANGLE,
    NOZZLE_PLACE,
    RIGHT_ANGLE,
    SPAN,
    STUB,
    Supports,
    feed_name,
    path_name,
    turn_name,
)


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
    nozzle: Nozzle | None = None  # The right support, if it is one


@dataclass(frozen=True)
class Nozzle:
    """A nozzle at one instant, in rest lengths and seconds; inside it the strand is straight and moves as one."""

    exit: ca.SX  # X that comes out just now
    feed: ca.SX
    tip: tuple[ca.SX, ca.SX]
    along: tuple[ca.SX, ca.SX]  # Tangent of the strand inside
    velocity: tuple[ca.SX, ca.SX]  # Of the strand inside

    def place(self, way: int, X: ca.SX) -> ca.SX:
        """Where a node is that has not come out."""
        return ca.SX(self.tip[way] + self.along[way] * (X - self.exit))


def held(supports: Supports, given: Mapping[str, ca.SX], length: ca.SX, seconds: ca.SX) -> Held:
    """The supports at a time."""
    half = given[SPAN] / (2 * length) if supports.apart else ca.SX(0.5)
    drop = given[DROP] / length if supports.lowered else ca.SX(0)
    axes = ("dx", "dy", "dz") if supports.sideways else ("dx", "dy")
    moved, speed = _path([path_name, *axes], supports.rows, given, seconds)
    (twist,), (spin,) = _path([turn_name, "angle"], supports.turns, given, seconds)
    nothing, nozzle = ca.SX(0), None
    if supports.feeds:
        moved = [one + given[name] for one, name in zip(moved, NOZZLE_PLACE, strict=True)]
        fed, feed = _fed(supports.feeds, given, seconds)
        angle = given[RIGHT_ANGLE]
        tip, along = (moved[0] / length - half, moved[1] / length), (ca.cos(angle), ca.sin(angle))
        u, v = (one / length - d * feed / length for one, d in zip(speed, along, strict=True))
        nozzle = Nozzle((given[STUB] + fed) / length - 0.5, feed / length, tip, along, (u, v))
    out_of_plane, out_of_plane_speed = (
        (moved[2] / length, speed[2] / length) if supports.sideways else (nothing, nothing)
    )
    down = (given[name] for name in DIRECTION) if supports.directed else (nothing, ca.SX(-1), nothing)
    return Held(
        left_x=-half,
        right_x=half + moved[0] / length if nozzle is None else nozzle.place(0, ca.SX(0.5)),
        right_y=moved[1] / length - drop if nozzle is None else nozzle.place(1, ca.SX(0.5)),
        right_u=speed[0] / length if nozzle is None else nozzle.velocity[0],
        right_v=speed[1] / length if nozzle is None else nozzle.velocity[1],
        left_angle=given[LEFT_ANGLE] if supports.left_turned else nothing,
        right_angle=given[RIGHT_ANGLE] if supports.right_turned else nothing,
        right_z=out_of_plane,
        right_w=out_of_plane_speed,
        right_twist=twist,
        right_spin=spin,
        turns=tuple(
            [given[name] for name in turn] if needed else []
            for turn, needed in zip(END_TURNS, supports.curved, strict=True)
        ),
        direction=tuple(down),  # type: ignore[arg-type]
        nozzle=nozzle,
    )


def _fed(rows: int, given: Mapping[str, ca.SX], seconds: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Length that was fed, and the feed, which is linear between its rows; none after the last one."""
    points = [(given[feed_name("time", row)], given[feed_name("speed", row)]) for row in range(rows)]
    length = feed = ca.SX(0)
    for (begin, first), (end, last) in itertools.pairwise(points):
        lasting = ca.fmax(end - begin, 1e-300)
        gone = ca.fmin(ca.fmax(seconds - begin, 0), lasting)
        length += first * gone + (last - first) / lasting * gone**2 / 2
        under_way = ca.logic_and(seconds >= begin, seconds < end)
        feed += under_way * (first + (last - first) / lasting * gone)
    return length, feed


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
