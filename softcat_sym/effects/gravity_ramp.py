"""Gravity ramp: the weight is switched on smoothly instead of at once."""

from __future__ import annotations

from dataclasses import replace

from softcat_sym.effects.effect import Effect, OfMotion
from softcat_sym.physics.filament import Terms
from softcat_sym.physics.loads import ramp_rate, ramped_gravity
from softcat_sym.scene.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, gravity=ramped_gravity(), gravity_rate=ramp_rate())


def _applies(scene: Scene) -> bool:
    return scene.load.ramp > 0


GRAVITY_RAMP = Effect(
    name="gravity-ramp",
    summary="g(t) by a quintic smooth step",
    source="section 3",
    contribute=_contribute,
    applies=_applies,
    without_it="load.ramp is zero: gravity acts at once",
    estimate=OfMotion("risen", "share of the sag, and of the ringing, that the ramp delays"),
    observable="share of the sag reached by the end of the ramp",
    example="arrested-overdamped",
    derivation="01_balance",
)
