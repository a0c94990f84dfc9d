"""Rotary inertia: the angular acceleration of a section needs a moment."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, of_large_deflections
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.scaling import section_of
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.scene import Scene, groups_of

_SLOPE = 12.3
"""Mean square slope over mean square sag of a clamped beam's first mode, times L^2."""

_SHAPE = 0.05
"""Relative change of height and amplitude of a ringing over that of its frequency: the static shape is unchanged, and
only the share of the first mode in it changes. Measured 0.005 between clamps; it may be larger in strands that yield at
first."""


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    # The relative change of the first frequency is half of that of the kinetic energy by rotation.
    slower = _SLOPE / 2 * section_of(scene).gyration * groups_of(scene).delta ** 2
    share = min(1.0, slower * (_SHAPE if motion.rings_on else motion.missed + motion.swings))
    return Estimate(
        share, "decrease of its frequency, if it rings", "6.2 (h0/L)^2 <zeta^2>/4 of the frequency", late=True
    )


ROTARY_INERTIA = Effect(
    name="rotary-inertia",
    summary="angular momentum of the sections",
    source="Timoshenko 1921",
    contribute=partial(replace, rotary_inertia=True),
    applies=lambda scene: of_large_deflections(scene) and not (is_spatial(scene) or scene.extrusion.present),
    without_it=f"in three dimensions and of a laid strand sections have no rotary inertia, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="ringing of the midpoint, times (h0/L)^2",
    example="stretched-rubber-band",
    derivation="09_shearing_filament",
    cures="failure",
    dear=True,
    needs=("inertia", "shear"),
    in_paper=False,
    saved=lambda scene: "it makes runs with yielding hinges many times longer" if YIELDING.applies(scene) else "",
)
