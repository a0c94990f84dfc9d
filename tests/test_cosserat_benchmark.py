"""Scenarios of cosseratbench as scenes, and runs as its trajectories: with stand-ins for it, so it may be missing."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from enum import Enum
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import xarray as xr
from scipy.spatial.transform import Rotation

import softcat_sym as sc
from softcat_sym.cosserat_benchmark import CosseratBenchmarkSolver, axes_of, in_its_words
from softcat_sym.scene.dimensions import is_spatial

Three = tuple[float, float, float]
Floats = np.ndarray[Any, np.dtype[np.float64]]


class Held(Enum):
    """As cosseratbench.scenario.EndCondition."""

    FREE, PINNED, CLAMPED = "free", "pinned", "clamped"


class End(Enum):
    """As cosseratbench.scenario.End."""

    START, END = "start", "end"


@dataclass(frozen=True)
class Material:
    youngs_modulus: float = 1e6
    shear_modulus: float = 1e6 / 3
    density: float = 1000.0


@dataclass(frozen=True)
class PointLoad:
    force: Three
    at: End = End.END


@dataclass(frozen=True)
class Motion:
    times: tuple[float, ...]
    displacement: tuple[Three, ...]
    rotation: tuple[Three, ...]
    slides_along: Three | None = None

    @property
    def axis(self) -> Floats:
        return np.array(self.slides_along) / np.linalg.norm(self.slides_along or 1.0)


@dataclass(frozen=True)
class Rod:
    """A rod whose points are equally spaced along it: a straight one, or one with `length` given."""

    centerline: tuple[Three, ...] = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    radius: float = 0.02
    material: Material = Material()
    normal: Three = (0.0, 0.0, 1.0)
    start: Held = Held.CLAMPED
    end: Held = Held.FREE
    loads: tuple[PointLoad, ...] = ()
    start_motion: Motion | None = None
    end_motion: Motion | None = None
    length: float = 1.0

    def nodes(self, n_elements: int) -> Floats:
        points = np.array(self.centerline)
        at, here = np.linspace(0, 1, n_elements + 1), np.linspace(0, 1, len(points))
        return np.stack([np.interp(at, here, column) for column in points.T], axis=1)

    def directors(self, n_elements: int) -> Floats:
        # Of a rod that lies in a plane, and starts with a line in that plane or across it.
        tangents = np.diff(self.nodes(n_elements), axis=0)
        tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
        plane = np.cross(tangents[0], self.normal)
        bent = not np.allclose(tangents @ self.normal, 0)
        return np.cross(plane / np.linalg.norm(plane), tangents) if bent else np.tile(self.normal, (n_elements, 1))


@dataclass(frozen=True)
class Scenario:
    rods: tuple[Rod, ...]
    duration: float = 10.0
    gravity: Three = (0.0, 0.0, 0.0)
    obstacles: tuple[object, ...] = ()
    self_contact: bool = False
    quasi_static: bool = True


SOLVER = CosseratBenchmarkSolver()
PULL = (PointLoad((0.0, 0.0, -7.5e-3)),)
DOWN = (0.0, 0.0, -9.81)
TIMES = (0.0, 1.0, 2.0)


def scene_of(rod: Rod, n_elements: int = 20, **changes: Any) -> sc.Scene:
    """The scene of a scenario with one rod."""
    (found,) = SOLVER.scenes(Scenario((rod,), **changes), n_elements=n_elements, n_frames=11)
    return found


def arc(length: float = 1.0, span: float = 0.8, points: int = 201) -> tuple[Three, ...]:
    """A circular arc that hangs below its chord."""
    low, high = 1e-9, math.pi
    for _ in range(200):
        half = (low + high) / 2
        low, high = (half, high) if math.sin(half) / half > span / length else (low, half)
    angles, radius = np.linspace(-half, half, points), length / (2 * half)
    x, z = span / 2 + radius * np.sin(angles), radius * (math.cos(half) - np.cos(angles))
    return tuple(map(tuple, np.stack([x, 0 * x, z], axis=1).tolist()))


def clamp_that_turns(**changes: Any) -> Motion:
    turned = ((0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (7.0, 0.0, 0.0))
    static = Motion(TIMES, ((0.0, 0.0, 0.0),) * 3, turned, slides_along=(1.0, 0.0, 0.0))
    return replace(static, **changes)


def twisted(**changes: Any) -> Rod:
    """A rod between clamps, the end of which turns and slides."""
    motion = clamp_that_turns(**changes)
    return Rod(end=Held.CLAMPED, end_motion=motion, loads=(PointLoad((0.1, 0.0, 0.0)),))


def test_a_cantilever_is_at_rest_under_its_force() -> None:
    found = scene_of(Rod(loads=PULL))
    assert is_spatial(found) and "inertia" not in found.run.effects
    assert (found.ends.left, found.ends.right) == ("clamped", "free")
    assert found.load.tip_force == (0.0, -7.5e-3, 0.0)
    assert (found.filament.section, found.filament.thickness, found.filament.span) == ("circle", 0.04, 1.0)
    assert found.material.youngs_modulus / (2 * (1 + found.material.poisson)) == pytest.approx(1e6 / 3, rel=1e-15)
    assert (found.numerics.cells, found.numerics.grading, found.numerics.estimate) == (10, 1.0, False)


def test_a_pendulum_begins_where_it_is_and_is_not_damped() -> None:
    bent = tuple((0.02 * s * s, 0.0, -s) for s in np.linspace(0, 1, 21).tolist())
    found = scene_of(Rod(bent, start=Held.PINNED, normal=(0.0, 1.0, 0.0)), gravity=DOWN, quasi_static=False)
    assert found.material.law == "elastic" and "inertia" in found.run.effects
    assert len(found.initial.centreline) == 21
    assert math.dist(found.initial.centreline[-1], (0, 0, 0)) == pytest.approx(found.filament.span)
    # Its axis is the chord, and the weight is where it was: along that but for the bend.
    assert np.allclose(found.load.direction, [1, -0.02, 0], atol=1e-3)
    assert found.run.frames == 11


def test_a_clamp_that_turns_slides_under_its_force_and_sound_is_damped() -> None:
    found = scene_of(twisted())
    assert found.ends.right_slides and found.load.tip_force == (0.1, 0.0, 0.0)
    assert found.ends.right_twist == ((0.0, 0.0), (1.0, 3.0), (2.0, 7.0))
    assert found.material.law == "kelvin-voigt" and not found.ends.motion
    assert found.material.viscosity == pytest.approx(1e6 * math.sqrt(1000 / 1e6))
    moved = ((0.0, 0.0, 0.0), (0.0, 0.01, 0.0), (0.0, 0.01, 0.02))
    found = scene_of(twisted(displacement=moved))
    aside = np.array(found.ends.motion)
    assert np.allclose(aside[:, 1], 0) and np.allclose(
        np.linalg.norm(aside[:, 2:], axis=1), [0, 0.01, math.hypot(1, 2) / 100]
    )


CASES: list[tuple[Rod, dict[str, Any], str]] = [
    (Rod(), {"obstacles": ("a cylinder",)}, "contact"),
    (Rod(), {"n_elements": 25}, "25 elements: an even number"),
    (Rod(), {"n_elements": 4}, "4 elements"),
    (Rod(start=Held.FREE, end=Held.CLAMPED), {}, "start is free"),
    (Rod(start_motion=clamp_that_turns()), {}, "a start that moves"),
    (Rod(material=Material(shear_modulus=2e5)), {}, "a Poisson ratio of 1.5"),
    (Rod(arc(), end=Held.CLAMPED), {}, "a clamp that does not point along"),
    (twisted(rotation=((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 1.0, 0.0))), {}, "turns about any but its own axis"),
    (twisted(slides_along=(0.0, 1.0, 0.0)), {}, "slides any way but along"),
    (replace(twisted(), start=Held.PINNED), {}, "opposite a pin"),
    (Rod(radius=0.6), {}, "filament.thickness"),
    (Rod(arc(), start=Held.PINNED, end=Held.PINNED), {"gravity": (1.0, 0.0, -9.0)}, "load.direction"),
]


@pytest.mark.parametrize(("rod", "changes", "says"), CASES, ids=[says for *_, says in CASES])
def test_what_it_has_not_is_refused_by_name(rod: Rod, changes: dict[str, Any], says: str) -> None:
    given = {"n_elements": 20, "n_frames": 3, **changes}
    numbers = {name: given.pop(name) for name in ("n_elements", "n_frames")}
    with pytest.raises(NotImplementedError, match=says):
        SOLVER.scenes(Scenario((rod,), **given), **numbers)
    assert SOLVER.settings(Scenario((rod,), **given), **numbers) == {}


def turned(angle: float) -> Floats:
    """About the vertical of the benchmark's world."""
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


@pytest.mark.parametrize("normal", [(0.0, 1.0, 0.0), (-0.6, 0.0, 0.8)])
def test_positions_and_sections_are_those_of_the_world(normal: Three) -> None:
    """A cable that hangs along another compass direction hangs alike; its lines stay square to it, in their plane."""
    found = []
    for turn in (np.eye(3), turned(0.7)):
        points = tuple(map(tuple, (np.array(arc()) @ turn.T + [1.0, 2.0, 3.0]).tolist()))
        tangent = np.array(arc()[1]) - arc()[0]
        line = np.array(normal) - (np.array(normal) @ tangent) * tangent / (tangent @ tangent)
        rod = Rod(points, 0.005, normal=tuple(turn @ line / np.linalg.norm(line)), start=Held.PINNED, end=Held.PINNED)
        run = sc.simulate(scene_of(rod, gravity=DOWN))
        places, lines = in_its_words(rod, axes_of(rod, DOWN), run, static=True)
        assert np.allclose(places[0], rod.nodes(20), atol=1e-12)
        assert np.allclose(lines[0], rod.directors(20), atol=1e-9)
        tangents = np.diff(places, axis=1)
        assert np.allclose(np.sum(tangents * lines, axis=-1), 0, atol=1e-12)
        assert np.allclose(np.linalg.norm(lines, axis=-1), 1)
        found.append([(one - origin) @ turn for one, origin in ((places, [1.0, 2.0, 3.0]), (lines, [0.0] * 3))])
    for one, other in zip(*found, strict=True):
        assert np.allclose(one, other, atol=1e-9)
    places, lines = found[0]
    assert np.allclose(places[..., 1], 0, atol=1e-12)
    assert places[-1, 10, 2] == pytest.approx(-0.2687, rel=2e-3)
    # In its plane, or across it, a line keeps what it has across.
    across = np.sum(lines * [0, 1, 0], axis=-1)
    assert np.allclose(across, across[0, 0], atol=1e-9)


def test_sections_that_turn_and_twist_carry_their_lines() -> None:
    """A straight rod that turns as a whole about its start, and is twisted from there, seen from the world."""
    rod, n = Rod(((0.0, 0.0, 0.0), (0.0, 0.0, -2.0)), normal=(0.6, 0.8, 0.0), length=2.0), 10
    turns, twists = [(0.0, 0.0, 0.0), (0.3, -0.8, 0.5), (1.0, 0.4, -2.0)], (0.0, 1.0, 4.0)
    axes, s = axes_of(rod, (0.0, 0.0, 0.0)), np.linspace(0, 1, n + 1)
    places, quaternions = [], []
    for turn, twist in zip(turns, twists, strict=True):
        sections = Rotation.from_rotvec(turn) * Rotation.from_rotvec(np.outer(twist * s, [1, 0, 0]))
        places.append(Rotation.from_rotvec(turn).apply(np.outer(2 * s, [1, 0, 0])) - [1, 0, 0])
        quaternions.append(np.roll(sections.as_quat(), 1, axis=-1))
    fields = {name: (("time", "node"), one) for name, one in zip("xyz", np.moveaxis(places, -1, 0), strict=True)}
    turned_by = {"quaternion": (("time", "node", "component"), np.array(quaternions))}
    run: Any = SimpleNamespace(data=xr.Dataset({**fields, **turned_by}, coords={"X_cell": ("cell", np.arange(n))}))
    found, lines = in_its_words(rod, axes, run, static=False)
    middle = (s[1:] + s[:-1]) / 2
    for k, (turn, twist) in enumerate(zip(turns, twists, strict=True)):
        whole = Rotation.from_rotvec(np.array(turn) @ axes)
        assert np.allclose(found[k], whole.apply(rod.nodes(n)))
        # Right-handed about the rod, which points down.
        twisting = Rotation.from_rotvec(np.outer(twist * middle, [0, 0, -1]))
        assert np.allclose(lines[k], whole.apply(twisting.apply(rod.normal)), atol=1e-12)
