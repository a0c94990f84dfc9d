"""A plane of dimensionless groups: axes, the filament at a place in it, and how long that filament is watched."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, groups_of, is_held, is_slack
from softcat_sym.scene.scales import gravity_time

LEAST_RESOLUTION, MOST_RESOLUTION = 4, 640

ELASTIC_TIME: Final = 4.0
"""Least time of a run in sqrt(L/g), after the ramp of gravity.

An elastic filament of the paper's modulus swings four times or more in it, and an undamped fall past the catenary, half
a period pi sqrt(G/10), has turned back.
"""

ARREST_TIME: Final = 4.0
"""Time in eta/sigma_Y after which an arrest shows: overstress relaxes, and hinges turn, in a time eta/sigma_Y."""

WEIGHT_TIME: Final = 1.0
"""Longest time in eta/(rho g L). It is the time in which the stress rho g L makes a strain of one: a catenary that
nothing stops has fallen by some 0.4 L by then, and soon after it is drawn out at its clamps."""


@dataclass(frozen=True, slots=True)
class PhaseAxis:
    """One group, in equal steps of its logarithm.

    Attributes
    ----------
    key : str
        ``"G"``, ``"V"`` or ``"delta"``.
    low, high : float
        Its ends.
    """

    key: str
    low: float
    high: float

    def values(self, cells: int) -> Floats:
        """Lattice values, shape (cells + 1,)."""
        return np.geomspace(self.low, self.high, cells + 1)


@dataclass(frozen=True, slots=True)
class PhasePlane:
    """Two groups that vary, the third as in the scene.

    Attributes
    ----------
    name : str
        As a user names it.
    x, y : PhaseAxis
        G across, the other one upwards.
    """

    name: str
    x: PhaseAxis
    y: PhaseAxis


GRAVITY = PhaseAxis("G", 0.01, 3.0)
PLANES: dict[str, PhasePlane] = {
    "G-delta": PhasePlane("G-delta", GRAVITY, PhaseAxis("delta", 0.01, 0.1)),
    "G-V": PhasePlane("G-V", GRAVITY, PhaseAxis("V", 0.1, 100.0)),
}


@dataclass(frozen=True, slots=True)
class Place:
    """Groups of one filament (3.9, 3.10)."""

    G: float
    V: float
    delta: float


def planes_of(names: Sequence[str]) -> tuple[PhasePlane, ...]:
    """The planes of these names.

    Raises
    ------
    SoftcatError
        If there is none of such a name, or none is named.
    """
    unknown = [name for name in names if name not in PLANES]
    if unknown or not names:
        raise SoftcatError(f"no phase plane {', '.join(unknown) or 'named'}; accepted: {', '.join(PLANES)}")
    return tuple(PLANES[name] for name in dict.fromkeys(names))


def checked_resolution(resolution: int) -> int:
    """A number of cells along an axis that can be had.

    Raises
    ------
    SoftcatError
        If it is none.
    """
    if isinstance(resolution, bool) or not isinstance(resolution, int):
        raise SoftcatError(f"resolution = {resolution!r}: a whole number of cells along each axis")
    if not LEAST_RESOLUTION <= resolution <= MOST_RESOLUTION:
        raise SoftcatError(f"resolution = {resolution}: accepted: {LEAST_RESOLUTION} to {MOST_RESOLUTION} cells")
    return resolution


def refuse_scene(scene: Scene) -> None:
    """Refuse a filament whose regimes G, V and delta do not decide.

    Raises
    ------
    SceneError
        If its law is not Bingham's, if gravity is shaken, or if its supports are not level, at rest and as far apart as
        it is long.
    """
    faults = []
    if scene.material.law != "bingham":
        faults.append(Fault("material.law", f"{scene.material.law!r} has no regimes by G and V", '"bingham"'))
    if scene.load.gravity == 0:
        faults.append(Fault("load.gravity", "zero, but the groups are measured by it", "a positive gravity"))
    if scene.load.shake > 0:
        faults.append(Fault("load.shake", "shaken gravity has regimes of its own", "0"))
    if not is_held(scene) or is_slack(scene):
        faults.append(Fault("ends", "the filament is not held straight at both ends", "both ends held, no slack"))
    if scene.ends.motion or scene.ends.drop != 0:
        faults.append(Fault("ends", "a support moves or is lowered", "two level supports at rest"))
    if scene.load.point_mass > 0:
        faults.append(Fault("load.point_mass", "a weight at midspan is no part of the groups", "0"))
    if faults:
        raise SceneError(faults, "of a phase diagram")


def place_at(scene: Scene, plane: PhasePlane, x: float, y: float) -> Place:
    """The groups at a place of a plane; the one that does not vary is the scene's.

    Raises
    ------
    SceneError
        If the scene does not yield or flow: see :func:`refuse_scene`.
    """
    groups = groups_of(scene)
    if groups.G is None or groups.V is None:
        raise SceneError([Fault("material", "neither G nor V", "a yield stress and a viscosity")], "of a phase diagram")
    held = {"G": groups.G, "V": groups.V, "delta": groups.delta} | {plane.x.key: x, plane.y.key: y}
    return Place(**held)


def duration_at(scene: Scene, place: Place) -> float:
    """How long a filament is watched [s]: long enough for it to show whether it stops.

    The ramp, `ELASTIC_TIME`, and of flow the shorter of `ARREST_TIME` and `WEIGHT_TIME`.
    """
    flow = place.V * min(WEIGHT_TIME, ARREST_TIME * place.G)
    return scene.load.ramp + (ELASTIC_TIME + flow) * gravity_time(scene)


def row_of(scene: Scene, place: Place, duration: float) -> dict[str, object]:
    """What the filament at a place changes in the scene, as a row of :func:`softcat_sym.simulate_many`."""
    delta: dict[str, object] = {} if place.delta == groups_of(scene).delta else {"groups.delta": place.delta}
    return delta | {"groups.G": place.G, "groups.V": place.V, "run.duration": duration}
