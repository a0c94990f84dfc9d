"""What follows from the geometry of a scene: lengths, slackness, symmetry, the undeformed section."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from softcat_sym.scene.model import Scene

_ROUNDING = 1e-12


def distance(scene: Scene) -> float:
    """Return the straight distance between the supports at the start [m]."""
    return math.hypot(scene.filament.span, scene.ends.drop)


def rest_length(scene: Scene) -> float:
    """Return the length of the reference configuration, to which the undeformed section belongs [m].

    As given, or the distance over the initial stretch.
    """
    given = scene.filament.rest_length
    return distance(scene) / scene.initial.stretch if given is None else given


def stress_free_length(scene: Scene) -> float:
    """Return the length at which the filament starts without stress [m]: a relaxed initial stretch lengthens it."""
    return rest_length(scene) * (scene.initial.stretch if scene.initial.relaxed else 1.0)


def is_held(scene: Scene) -> bool:
    """Tell whether neither end is free."""
    return "free" not in (scene.ends.left, scene.ends.right)


def is_slack(scene: Scene) -> bool:
    """Tell whether both ends are held and the filament is longer without stress than they are apart."""
    return is_held(scene) and stress_free_length(scene) > distance(scene) * (1 + _ROUNDING)


def is_symmetric(scene: Scene) -> bool:
    """Tell whether left and right mirror each other at all times."""
    ends = scene.ends
    mirrored = math.isclose(ends.left_angle, -ends.right_angle, rel_tol=_ROUNDING, abs_tol=_ROUNDING)
    along = (scene.filament.profile, scene.initial.P, scene.initial.C)
    return (
        ends.left == ends.right
        and is_held(scene)
        and mirrored
        and ends.drop == 0
        and not ends.motion
        and all(values == values[::-1] for values in along)
    )


def chord_angle(scene: Scene) -> float:
    """Return the angle of the line from the left support to the right one, counterclockwise [rad]."""
    return math.atan2(-scene.ends.drop, scene.filament.span) + 0.0  # level is 0, not -0


def undeformed_area(scene: Scene) -> float:
    """Return A0 [m^2] where the relative thickness is 1."""
    filament = scene.filament
    if filament.section == "circle":
        return math.pi * filament.thickness**2 / 4
    return filament.thickness * filament.width
