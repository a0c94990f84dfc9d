"""Gravity shaking: the weight oscillates, as in a vertically shaken frame."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.forecast import shaken_share
from softcat_sym.scene.scene import Scene


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    del motion
    share, formula = shaken_share(scene), "a (1 + r)/|1 - r^2| of the first mode, r = f/f_1"
    return Estimate(share, "oscillation that the shaking adds", formula, 1 / (1 + share))


GRAVITY_SHAKING = Effect(
    name="gravity-shaking",
    summary="g(t) oscillates about its steady value",
    source="Rayleigh 1877",
    contribute=partial(replace, shaken=True),
    applies=lambda scene: scene.load.shake > 0,
    without_it="load.shake is zero: gravity is steady",
    estimate=_estimate,
    observable="oscillation of the midpoint at the frequency of the shaking, over the sag",
    example="shaken-strand",
    derivation="01_balance",
    needs=("inertia",),
    in_paper=False,
    indispensable=lambda scene: (
        f"gravity is shaken at {scene.load.shake_frequency:g} Hz" if scene.load.shake > 0 else ""
    ),
)
