"""Bending: curvature, moment and transverse force, with the bending plastic strain where the law flows."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, Estimate, always, held_up
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.scene.dimensions import needs_section_angles
from softcat_sym.scene.natural_curve import is_curved
from softcat_sym.scene.scene import Scene, carries_moment, groups_of, is_held, is_turned

_LAYER, _PINNED = 0.5, 0.1
"""Smallest share of the load in bending, over h0/H, of a string in clamps, and between pins."""


def _indispensable(scene: Scene) -> str:
    if why := needs_section_angles(scene):
        return why
    if is_curved(scene):
        return "the filament is curved by nature"
    return "a clamp is turned against the line between the supports" if is_turned(scene) else ""


def bending_share(scene: Scene, motion: Motion) -> float:
    """Share of the load carried in bending, at least h0/(2 H) for the bent ends of a string."""
    layer = (_LAYER if carries_moment(scene) else _PINNED) * groups_of(scene).delta / motion.sag
    return min(1.0, max(1 - motion.tension_share, layer))


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    share = bending_share(scene, motion)
    # Tension carries a load as the cube of the sag, and nothing but bending carries one to a free end.
    without = held_up(1 - motion.tension_share) ** (1 / 3) if is_held(scene) else math.inf
    formula = "at least h0/(2 H), between pins a fifth of it"
    return Estimate(motion.amplified(share), "share of the load that bending carries", formula, without)


BENDING = Effect(
    name="bending",
    summary="curvature, moment M and transverse force N = M_X/s",
    source="2.3, 2.10, 2.11",
    contribute=partial(replace, bending=True),
    applies=always,
    without_it="",
    estimate=_estimate,
    observable="share of the load in bending at the largest sag",
    example="glass-rod",
    derivation="01_balance",
    causes=("bending",),
    indispensable=_indispensable,
)
