"""Thinning: area and thickness shrink as the filament stretches."""

from __future__ import annotations

from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, Motion, of_large_deflections
from softcat_sym.physics.filament import Terms
from softcat_sym.scene.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, thins=True)


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    del scene
    return Estimate(
        motion.amplified(0.5 * motion.strain), "stiffness lost as the section thins", "half the mean strain"
    )


THINNING = Effect(
    name="thinning",
    summary="A = A0/s, h = h0/sqrt(s), of a sheet h0/s",
    source="2.9",
    contribute=_contribute,
    applies=of_large_deflections,
    without_it=SMALL_MODEL,
    estimate=_estimate,
    needs=("extensibility",),
    observable="mean strain, and how far the midpoint rings",
    example="continual-descent",
    derivation="02_section_and_closures",
)
