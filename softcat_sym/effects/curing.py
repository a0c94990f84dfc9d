"""Curing: constants of the material are tables or formulas of time, as for an ink that dries or a concrete that sets.

New springs of a growing modulus are free of stress, sigma_t = E(t) eps_t, like the strands of a transient network
(Castonguay et al. 2025): they do not lift a filament. A falling modulus loses springs with their stress,
sigma = E(t) eps.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.quasi_static_sag import followed_sag
from softcat_sym.physics.terms import Course
from softcat_sym.scene.scene import Scene


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    meaning = "largest change of the sag if the constants keep their initial values"
    if not scene.material.histories():
        return Estimate(0.0, meaning)
    changing, constant = (followed_sag(one)[1] for one in (scene, scene.at(0.0)))
    change = float(np.max(np.abs(changing - constant)) / max(np.max(changing), np.max(constant), 1e-300))
    without = float(np.max(constant)) / max(float(np.max(changing)), 1e-300)
    return Estimate(motion.amplified(change), meaning, without=without)


CURING = Effect(
    name="curing",
    summary="constants of the material that are tables or formulas of time",
    source="Castonguay et al. 2025",
    adapt=lambda scene, terms: replace(
        terms, curing=tuple(Course.of(*one) for one in scene.material.histories().items())
    ),
    applies=lambda scene: bool(scene.material.histories()),
    without_it="no constant of the material is a table or a formula of time",
    estimate=_estimate,
    observable="the same, from the sag and the ringing of a run",
    example="solvent-cast-strand",
    derivation="21_curing",
    in_paper=False,
)
