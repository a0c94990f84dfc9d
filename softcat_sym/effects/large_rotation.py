"""Large rotation: exact stretch and turning instead of their small-slope forms."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, of_large_deflections
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.scene.dimensions import needs_section_angles
from softcat_sym.scene.scene import Scene, is_held

_HELD, _FREE = 0.07, 0.25
"""Change of the sag per slope squared, for a filament held at both ends, and at one end."""

_STEEP = math.radians(60)
"""Angle of a clamp above which the small-slope stretch x_X + y_X^2/2 has no meaning."""


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    share = _HELD if is_held(scene) else _FREE
    return Estimate(motion.amplified(share * motion.slope**2), "error of small slopes", f"{share:g} slope^2")


def _indispensable(scene: Scene) -> str:
    ends = scene.ends
    steep = max(abs(ends.left_angle), abs(ends.right_angle)) > _STEEP
    return "a clamp holds the filament too steeply for a small slope" if steep else needs_section_angles(scene)


LARGE_ROTATION = Effect(
    name="large-rotation",
    summary="exact stretch and angle of the centreline",
    source="2.5",
    contribute=partial(replace, large_rotation=True),
    applies=of_large_deflections,
    without_it=SMALL_MODEL,
    estimate=_estimate,
    needs=("extensibility",),
    observable="largest slope, and ringing of the midpoint",
    example="continual-descent",
    derivation="01_balance",
    causes=("slopes",),
    indispensable=_indispensable,
)
