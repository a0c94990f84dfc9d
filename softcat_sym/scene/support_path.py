"""The path of a moving right support: where it goes, and whether it can."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from softcat_sym.errors import Fault
from softcat_sym.scene.units import with_unit

if TYPE_CHECKING:
    from softcat_sym.scene.model import Scene

Point = tuple[float, float]


def places(scene: Scene) -> list[Point]:
    """Return the places of the right support seen from the left one, first and at each row of its motion [m]."""
    first = (scene.filament.span, -scene.ends.drop)
    return [first, *((first[0] + dx, first[1] + dy) for _, dx, dy in scene.ends.motion)]


def farthest(scene: Scene) -> float:
    """Return the greatest distance of the supports at any time [m]; a straight path has it at one of its ends."""
    return max(math.hypot(*place) for place in places(scene))


def nearest(scene: Scene) -> float:
    """Return the least distance of the supports at any time [m]."""
    path = places(scene)
    return min((_to_origin(a, b) for a, b in pairwise(path)), default=math.hypot(*path[0]))


def motion_faults(scene: Scene) -> Iterator[Fault]:
    """List what is wrong with the motion of the right support."""
    rows, path = scene.ends.motion, "ends.motion"
    times = [time for time, _, _ in rows]
    if any(time < 0 for time in times):
        yield Fault(path, f"a row at {min(times):g} s, before the start", "times from 0 s on")
    for before, after in pairwise(times):
        if after <= before:
            yield Fault(path, f"a row at {after:g} s after one at {before:g} s", "times that increase from row to row")
            break
    if rows and rows[0][1:] != (0.0, 0.0):
        start = f'["{with_unit(0.0, "time")}", "0 m", "0 m"]'
        found = f"the first row, at {times[0]:g} s, moves the support at once"
        yield Fault(path, found, f"a first row without displacement, such as {start}")
    if rows and nearest(scene) < scene.filament.thickness:
        found = f"the supports come within {nearest(scene):.4g} m of each other"
        yield Fault(path, found, f"a path that keeps them the thickness apart, {scene.filament.thickness:g} m")


def _to_origin(start: Point, end: Point) -> float:
    """Distance of the origin from the straight line between two points."""
    along = (end[0] - start[0], end[1] - start[1])
    squared = along[0] ** 2 + along[1] ** 2
    if squared == 0:
        return math.hypot(*start)
    at = min(1.0, max(0.0, -(start[0] * along[0] + start[1] * along[1]) / squared))
    return math.hypot(start[0] + at * along[0], start[1] + at * along[1])
