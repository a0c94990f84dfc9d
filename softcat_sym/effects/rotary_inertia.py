"""Rotary inertia: it takes a moment to turn a section faster."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, Motion, of_large_deflections
from softcat_sym.effects.scaling_estimates import section_of
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.scene import Scene, groups_of

_SLOPE = 12.3
"""Mean square slope over mean square sag of a clamped beam's first mode, times L^2."""

_SHAPE = 0.05
"""Of the change of frequency, what height and amplitude of a ringing change by: the weight bends the strand as far as
before, and only the share of the first mode in that shape changes. Measured 0.005 between clamps; in strands that yield
at first it may be more."""


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    # It slows the first mode by half of what turning adds to its kinetic energy.
    slower = _SLOPE / 2 * section_of(scene).gyration * groups_of(scene).delta ** 2
    share = min(1.0, slower * (_SHAPE if motion.rings_on else motion.missed + motion.swings))
    return Estimate(share, "how much slower it swings", "6.2 (h0/L)^2 <zeta^2>/4 of the frequency, as far as it swings")


def _spared(scene: Scene) -> str:
    return "followed through hinges that yield it takes many times as long" if YIELDING.applies(scene) else ""


def _applies(scene: Scene) -> bool:
    return of_large_deflections(scene) and not is_spatial(scene)


ROTARY_INERTIA = Effect(
    name="rotary-inertia",
    summary="angular momentum of the sections",
    source="Timoshenko 1921",
    contribute=partial(replace, rotary_inertia=True),
    applies=_applies,
    without_it=f"in three dimensions sections turn without inertia so far, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="how far the midpoint rings, times (h0/L)^2",
    example="stretched-rubber-band",
    derivation="09_shearing_filament",
    cures="failure",
    dear=True,
    needs=("inertia", "shear"),
    in_paper=False,
    saved=_spared,
)
