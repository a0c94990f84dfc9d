"""Added mass: the surrounding fluid moves with the filament across its tangent (Lighthill 1960)."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.scaling import added_mass_ratio
from softcat_sym.scene.scene import Scene


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    # It changes the phase of a ringing by this share; without ringing, it matters as much as inertia does.
    slower = math.sqrt(1 + added_mass_ratio(scene)) - 1
    value = slower * max(motion.missed, motion.swings)
    return Estimate(
        min(1.0, value),
        "change of every period, times the estimate of inertia",
        "sqrt(1 + C_m rho_b/rho) - 1",
        late=True,
    )


ADDED_MASS = Effect(
    name="added-mass",
    summary="inertia of the surrounding fluid, across the tangent of the filament",
    source="Lighthill 1960",
    contribute=partial(replace, added_mass=True),
    applies=lambda scene: (
        scene.filament.section != "sheet" and scene.surroundings.density > 0 and not scene.extrusion.present
    ),
    without_it="surroundings.density is zero, the strand is laid, or the section is a sheet, without a local flow",
    estimate=_estimate,
    observable="change of every period, times the lag behind the balanced sag",
    example="embedded-strand",
    derivation="17_surroundings",
    needs=("inertia",),
    in_paper=False,
    causes=("bath",),
)
