"""Gravity ramp: the weight is switched on smoothly instead of at once."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, OfMotion

GRAVITY_RAMP = Effect(
    name="gravity-ramp",
    summary="g(t) by a quintic smooth step",
    source="section 3",
    contribute=partial(replace, ramped=True),
    applies=lambda scene: scene.load.ramp > 0,
    without_it="load.ramp is zero: gravity acts at once",
    estimate=OfMotion("risen", "share of the sag, and of the ringing, that the ramp delays", late=True),
    observable="share of the sag reached by the end of the ramp",
    example="arrested-overdamped",
    derivation="01_balance",
)
