"""Extensibility: axial strain and tension; without it the filament is a beam that bends and does not stretch."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, OfMotion, held_up, of_large_deflections
from softcat_sym.scene.dimensions import needs_section_angles
from softcat_sym.scene.natural_curve import is_curved
from softcat_sym.scene.scene import Scene, distance, is_held, rest_length


def _indispensable(scene: Scene) -> str:
    """Why a scene requires it; empty for a straight relaxed filament with fixed level supports or a free end."""
    ends = scene.ends
    straight = math.isclose(rest_length(scene), distance(scene), rel_tol=1e-14) or not is_held(scene)
    level = ends.drop == 0 and ends.left_angle == 0 and ends.right_angle == 0 and not ends.motion
    stressed = bool(scene.initial.P) or bool(scene.initial.C) or is_curved(scene)
    if straight and level and not stressed:
        return needs_section_angles(scene)
    return "the filament does not start straight, level and without stress between fixed supports"


EXTENSIBILITY = Effect(
    name="extensibility",
    summary="axial strain and tension",
    source="2.2, 2.10",
    contribute=partial(replace, stretches=True),
    applies=of_large_deflections,
    without_it=SMALL_MODEL,
    estimate=OfMotion(
        "tension_share",
        "share of the load that tension carries",
        "(64/3) (H/L)^2 against the stiffness of the beam",
        amplified=True,
        without=held_up,
    ),
    observable="share of the load that tension would carry at the largest sag",
    example="arrested-overdamped",
    derivation="02_section_and_closures",
    causes=("stretching",),
    indispensable=_indispensable,
)
