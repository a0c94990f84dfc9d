"""A strand that is laid while it hangs: the table [extrusion], the feed and the path of its nozzle."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any, Literal

from softcat_sym.scene.bodies import QuantityOrWord
from softcat_sym.scene.history import ChangingQuantity, History
from softcat_sym.scene.parts import Part, Rule, if_given
from softcat_sym.scene.units import MOTION, Choice, Number, Quantity, refusal, shown

if TYPE_CHECKING:
    from softcat_sym.scene.tables import Tables

ALONG, DOWN = "along", "down"
LEAST_EXPOSED = 0.1
"""Least length of the exit cell over that of a cell: shorter ones are as stiff, and change no answer by 0.1 %."""
SWITCH = 0.2
"""Fed length over that of a cell, about its exit, in which the nozzle hands a node over to its neighbours."""

_SHARE = re.compile(r"\s*([0-9.]+(?:[eE][-+]?\d+)?)\s*span\s*")


class _Stub(Quantity):
    """A length, or a share of the span."""

    def __init__(self) -> None:
        super().__init__("length", "0.5 mm")
        self.accepted = f'a share of the span, such as "0.1 span", or {self.accepted}'

    def read(self, value: object) -> Any:
        """A share as the text that it is; a length in SI."""
        if not isinstance(value, str) or not (found := _SHARE.fullmatch(value)):
            return super().read(value)
        if not 0 < float(found[1]) <= 1:
            raise refusal(f"{shown(value)} is not between 0 and 1", self.accepted)
        return f"{float(found[1])!r} span"

    def write(self, value: Any) -> object:
        """What TOML holds."""
        return value if isinstance(value, str) else super().write(value)


class _Feed(ChangingQuantity):
    """A quantity or a table of times, linear between its rows; no formula."""

    has_formulas = False


ExitEnd = Literal["clamped"]
After = Literal["hold"]


class Extrusion(Part, table="extrusion"):
    """A nozzle that lays the strand; lengths in m, velocities in m/s."""

    print_speed: Annotated[float | None, Quantity("velocity", "5 mm/s")] = None
    """Speed V of the nozzle, straight from the end of the stub to the right support; or path."""
    path: Annotated[tuple[tuple[float, ...], ...], MOTION] = ()
    """Path of the nozzle: rows of time, x and y from the left support, linear between them, held after the last."""
    speed: Annotated[float | None, _Feed("velocity", "5 mm/s")] = None
    """Feed U, rest length per time, which may be a table in time; or flow_rate, or draw_ratio."""
    flow_rate: Annotated[float | None, _Feed("volume rate", "0.6 uL/s")] = None
    """Volume per time, over the undeformed section."""
    draw_ratio: Annotated[float | None, Number(above=0)] = None
    """Speed of the nozzle over the feed, V/U; 1 unless a feed is given."""
    direction: Annotated[float | str, QuantityOrWord("angle", "60 deg", ALONG, DOWN, sign="any")] = ALONG
    """How the strand leaves the nozzle: along the path, down, or at the angle of its tangent there (down: 90 deg)."""
    exit_end: Annotated[ExitEnd, Choice(ExitEnd)] = "clamped"
    """Whether the nozzle holds the tangent of the strand."""
    swell: Annotated[float, Number(above=0)] = 1.0
    """Area of the strand over that of the nozzle; filament.thickness is the strand's."""
    start: Annotated[float | str, _Stub()] = "0.1 span"
    """Length that has come out at t = 0, straight and relaxed."""
    after: Annotated[After, Choice(After)] = "hold"
    """What the nozzle does when all is laid: it holds the strand as the right support."""

    @property
    def present(self) -> bool:
        """Whether the scene has it."""
        return bool(self.path) or self.print_speed is not None


def stub_length(scene: Tables) -> float:
    """Length that has come out at t = 0 [m]."""
    start = scene.extrusion.start
    return float(start.split()[0]) * scene.filament.span if isinstance(start, str) else start


def exit_angle(scene: Tables) -> float:
    """Angle of the tangent of the strand at the nozzle, counterclockwise from the horizontal [rad]."""
    nozzle = scene.extrusion
    if nozzle.direction == DOWN:
        return math.pi / 2
    if nozzle.direction != ALONG:
        return float(nozzle.direction)
    if not nozzle.path:
        return math.atan2(-scene.ends.drop, scene.filament.span) + 0.0
    (_, x, y, *_), (_, x_end, y_end, *_) = nozzle.path[0], nozzle.path[-1]
    return math.atan2(y_end - y, x_end - x)


def nozzle_path(scene: Tables) -> tuple[tuple[float, float, float], ...]:
    """Times and places of the nozzle, x from the left support [s, m]."""
    nozzle = scene.extrusion
    if nozzle.print_speed is None:
        return tuple((row[0], row[1], row[2]) for row in nozzle.path)
    stub, angle = stub_length(scene), exit_angle(scene)
    begin, end = (stub * math.cos(angle), stub * math.sin(angle)), (scene.filament.span, -scene.ends.drop)
    return (0.0, *begin), (math.dist(begin, end) / nozzle.print_speed, *end)


def laid_at(scene: Tables) -> float:
    """Time at which the last of the strand has come out [s]: the end of the path, of a fixed nozzle that of the run."""
    return nozzle_path(scene)[-1][0] or scene.run.duration


def feed_rows(scene: Tables) -> tuple[tuple[float, float], ...]:
    """Times and feeds, linear between them [s, m/s]: the first at t = 0, the last when all is laid."""
    return _feed_rows(scene)


@lru_cache(maxsize=256)
def _feed_rows(scene: Any) -> tuple[tuple[float, float], ...]:
    nozzle, end, area = scene.extrusion, laid_at(scene), scene.filament.area
    given = nozzle.speed if nozzle.flow_rate is None else nozzle.flow_rate
    if given is None:
        rows = nozzle_path(scene)
        speeds = [math.dist(a[1:], b[1:]) / (b[0] - a[0]) / (nozzle.draw_ratio or 1.0) for a, b in pairwise(rows)]
        return tuple((row[0], speed) for pair, speed in zip(pairwise(rows), speeds, strict=True) for row in pair)
    factor = 1.0 if nozzle.flow_rate is None else 1 / area
    table = given.table if isinstance(given, History) else ((0.0, given),)
    inner = [(time, value) for time, value in table if 0 < time < end]
    return tuple(
        (time, value * factor) for time, value in ((0.0, _linear(table, 0.0)), *inner, (end, _linear(table, end)))
    )


def _linear(table: tuple[tuple[float, float], ...], time: float) -> float:
    """Value of a table at a time; constant before and behind."""
    for (begin, first), (end, last) in pairwise(table):
        if begin <= time <= end:
            return first + (last - first) * (time - begin) / (end - begin)
    return table[0][1] if time < table[0][0] else table[-1][1]


def extruded(scene: Tables, time: float) -> float:
    """Rest length that has come out at a time [m]."""
    length = stub_length(scene)
    for (begin, first), (end, last) in pairwise(feed_rows(scene)):
        gone = min(max(time - begin, 0.0), end - begin)
        length += first * gone + ((last - first) / (end - begin) * gone**2 / 2 if end > begin else 0.0)
    return length


def laid_length(scene: Tables) -> float:
    """Rest length of the whole strand [m]."""
    return extruded(scene, laid_at(scene))


def exit_time(scene: Tables, place: float) -> float:
    """Time at which a place comes out, of its rest length from the left end [s]; 0 in the stub."""
    length = stub_length(scene)
    if place <= length:
        return 0.0
    for (begin, first), (end, last) in pairwise(feed_rows(scene)):
        fed, slope = (first + last) * (end - begin) / 2, (last - first) / (end - begin) if end > begin else 0.0
        if length + fed >= place and end > begin:
            # The smaller root of first t + slope t^2/2 = rest, written so that it holds for a vanishing slope.
            rest = place - length
            return begin + 2 * rest / (first + math.sqrt(max(first**2 + 2 * slope * rest, 0.0)))
        length += fed
    return laid_at(scene)


def releases(scene: Tables, nodes: Sequence[float]) -> tuple[float, ...]:
    """Times at which the nozzle changes, or begins or ends to hand over a node, at X over the rest length [s]."""
    if not scene.extrusion.present:
        return ()
    length, cell = laid_length(scene), nodes[1] - nodes[0]
    switch = (-SWITCH / 2, 0.0, SWITCH / 2)
    places = [(node + 0.5 + share * cell) * length for node in nodes for share in switch]
    rows = (*(row[0] for row in nozzle_path(scene)), *(row[0] for row in feed_rows(scene)))
    return (*rows, *(exit_time(scene, place) for place in places))


def nozzle_walls(scene: Tables, time: float, across: float) -> list[tuple[float, float]]:
    """Corners of the nozzle with the strand that is in it, of a half width, x from midspan [m]."""
    rows, angle = nozzle_path(scene), exit_angle(scene)
    x, y = (_linear(tuple((row[0], row[way]) for row in rows), time) for way in (1, 2))
    along, x = (math.cos(angle), math.sin(angle)), x - scene.filament.span / 2
    inside = laid_length(scene) - extruded(scene, time)
    ends = [(x + far * along[0], y + far * along[1]) for far in (0.0, inside)]
    side = (-across * along[1], across * along[0])
    return [
        (p[0] + way * side[0], p[1] + way * side[1])
        for p, way in zip((*ends, *ends[::-1]), (1, 1, -1, -1), strict=True)
    ]


def emplaced(scene: Tables, time: float) -> float:
    """Length of the stub and of the path of the nozzle until a time [m]."""
    length = stub_length(scene)
    for a, b in pairwise(nozzle_path(scene)):
        length += math.dist(a[1:], b[1:]) * min(max(time - a[0], 0.0) / (b[0] - a[0]), 1.0)
    return length


def extrusion_rules(scene: Tables) -> Iterator[Rule]:
    """List what may be wrong with the table [extrusion], and what does not go with it."""
    nozzle, out, table = scene.extrusion, "leaving it out", "[extrusion]"
    if not nozzle.present:
        given = sorted(nozzle.model_fields_set)
        found = f"missing, but extrusion.{given[0]} is given" if given else ""
        yield given, "extrusion.print_speed", found, 'a speed, such as "5 mm/s", or extrusion.path, or no [extrusion]'
        return
    both = nozzle.print_speed is not None and nozzle.path
    yield both, "extrusion.path", "given with extrusion.print_speed: each says where the nozzle is", "one of the two"
    feeds = [key for key in ("speed", "flow_rate", "draw_ratio") if getattr(nozzle, key) is not None]
    twice = f"given with extrusion.{feeds[0]}: each says how much comes out" if len(feeds) > 1 else ""
    yield len(feeds) > 1, f"extrusion.{feeds[-1] if feeds else 'speed'}", twice, "one of the two"
    yield from _of_path(scene)
    said = "given, but [extrusion] says how long the strand is"
    yield scene.filament.rest_length is not None, "filament.rest_length", said, out
    nozzled = "given, but the nozzle of [extrusion] is the right support"
    ends = ("right", "right_angle", "motion", "right_twist", "right_slides")
    yield from if_given(scene, nozzled, out, *(f"ends.{key}" for key in ends))
    fresh = "given, but what comes out of a nozzle is relaxed"
    yield from if_given(scene, fresh, out, "initial.stretch", "initial.P", "initial.C", "initial.centreline")
    only = f"given with {table}, which has not this so far"
    keys = ("load.point_mass", "filament.profile", "filament.curvature", "filament.twist")
    yield from if_given(scene, only, out, *keys, "temperature.conductivity", "temperature.heated")
    uneven, found = (
        scene.numerics.grading not in (None, 1.0),
        f"{scene.numerics.grading}, but a laid strand has equal cells",
    )
    yield uneven, "numerics.grading", found, "1, or leaving it out"
    yield scene.initial.surface != "fresh", "initial.surface", "'relaxed', but what comes out has a fresh one", "fresh"
    yield scene.model == "small-deflection", "model", f"'small-deflection', given with {table}", "filament"
    yield scene.run.closure == "printed", "run.closure", f"'printed', given with {table}", "material"
    yield scene.run.dimensions == 3, "run.dimensions", f"3, but {table} has a strand in its plane only", "auto or 2"
    chains = scene.material.spec.has_chains
    yield chains, "material.law", f"'{scene.material.law}', which has no angle that a nozzle holds", "another law"
    yield scene.pillars.present, "pillars.gap", f"given with {table}, which has not this so far", out


def _of_path(scene: Tables) -> Iterator[Rule]:
    """Whether the path and the stub go together."""
    nozzle, stub, angle, span = scene.extrusion, stub_length(scene), exit_angle(scene), scene.filament.span
    path, times = "extrusion.path", [row[0] for row in nozzle.path]
    if nozzle.path:
        begins = f"begins at {times[0]:g} s"
        yield times[0] != 0, path, begins, 'a first row at "0 s"'
        back = next((b for a, b in pairwise(times) if b <= a), None)
        yield back is not None, path, f"a row at {back} s after a later one", "times that increase from row to row"
        yield any(len(row) > 3 for row in nozzle.path), path, "leaves the plane", "rows [time, x, y]"
        still = math.isclose(sum(math.dist(a[1:3], b[1:3]) for a, b in pairwise(nozzle.path)), 0.0, abs_tol=0.0)
        given = nozzle.speed is not None or nozzle.flow_rate is not None
        found = "missing: the nozzle stands still, so that no draw ratio says how much comes out"
        yield still and not given, "extrusion.speed", found, 'a speed, such as "5 mm/s", or extrusion.flow_rate'
        needed = "'along', but the nozzle stands still"
        yield still and nozzle.direction == ALONG, "extrusion.direction", needed, "down, or an angle"
    yield (
        nozzle.path == () and stub >= span,
        "extrusion.start",
        f"{stub:.4g} m, not shorter than the span",
        "a shorter stub",
    )
    left = scene.ends.supports[0]
    if left.is_free or any(times[:1]):
        return
    x, y = nozzle_path(scene)[0][1:]
    off = math.dist((x, y), (stub * math.cos(angle), stub * math.sin(angle))) > 1e-6 * span
    found = f"begins at ({x:.4g}, {y:.4g}) m, where a straight stub of {stub:.4g} m from the left support does not end"
    accepted = f"a first row at ({stub * math.cos(angle):.6g}, {stub * math.sin(angle):.6g}) m, or another start"
    yield bool(nozzle.path) and off, path, found, accepted
    turned = left.carries_moment and abs(scene.ends.left_angle - angle) > 1e-9
    held, exits = (math.degrees(one) for one in (scene.ends.left_angle, angle))
    found = f"{held:.4g} deg, but the strand leaves the nozzle at {exits:.4g} deg"
    yield turned, "ends.left_angle", found, f'"{angle!r} rad", a pinned or a free end'
