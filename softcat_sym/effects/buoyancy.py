"""Buoyancy: the surrounding fluid carries a part of the weight (Archimedes).

The hydrostatic pressure cancels in the section: the law gives the effective tension A (sigma_xx + p).
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, Estimate, held_up
from softcat_sym.errors import Fault
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.scene.scene import Scene

_MAX_DENSITY = 22_600.0
"""Density of osmium [kg/m^3]: a larger density has a wrong unit."""


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    share = scene.surroundings.density / scene.filament.density
    # The frequency of a string depends on the tension by its weight; that of a beam does not.
    change = share * motion.sag / motion.scale * (1 + motion.tension_share * motion.swings)
    meaning = "share of the weight that the surrounding fluid carries, amplified by the ringing of a string"
    without = held_up(share) if share < 1 else None
    return Estimate(min(1.0, change), meaning, "rho_b/rho (1 + phase of the ringing)", without)


def _faults(scene: Scene) -> list[Fault]:
    density = scene.surroundings.density
    if density <= _MAX_DENSITY:
        return []
    return [Fault("surroundings.density", f"{density:.3g} kg/m^3", f"at most {_MAX_DENSITY:g} kg/m^3 (osmium)")]


BUOYANCY = Effect(
    name="buoyancy",
    summary="weight minus that of the displaced fluid, g (1 - rho_b/rho)",
    source="Archimedes",
    contribute=partial(replace, buoyant=True),
    applies=lambda scene: scene.surroundings.density > 0,
    without_it="surroundings.density is zero",
    estimate=_estimate,
    observable="share of the weight that the fluid carries, times the observed phase of the ringing",
    example="embedded-strand",
    derivation="17_surroundings",
    faults=_faults,
    in_paper=False,
)
