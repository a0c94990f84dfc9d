"""Finite stretch: true strain log s and the curvature theta_s of the stretched centreline."""

from __future__ import annotations

from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, Motion, of_large_deflections
from softcat_sym.physics.filament import Terms
from softcat_sym.physics.kinematics import TRUE_STRAIN
from softcat_sym.scene.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, strain=TRUE_STRAIN)


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    del scene
    return Estimate(
        motion.amplified(0.4 * motion.strain),
        "difference of true strain and engineering strain",
        "0.4 of the mean strain",
    )


FINITE_STRETCH = Effect(
    name="finite-stretch",
    summary="true strain log s instead of s - 1",
    source="2.6",
    contribute=_contribute,
    applies=of_large_deflections,
    without_it=SMALL_MODEL,
    estimate=_estimate,
    needs=("extensibility",),
    observable="mean strain, and how far the midpoint rings",
    example="continual-descent",
    derivation="02_section_and_closures",
)
