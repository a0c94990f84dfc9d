"""Inertia: momentum in the balance."""

from __future__ import annotations

from dataclasses import replace

from softcat_sym.effects.effect import Effect, Estimate, Motion, always
from softcat_sym.physics.filament import Terms
from softcat_sym.scene.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, inertia=True)


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    del scene
    return Estimate(
        motion.missed, "how far it lags behind its weight, or rings", "|y - y balanced| over the largest sag"
    )


INERTIA = Effect(
    name="inertia",
    summary="acceleration of the filament",
    source="2.1, 2.2",
    contribute=_contribute,
    applies=always,
    without_it="",
    estimate=_estimate,
    observable="lag behind the balanced sag: its jump, its pace against free fall, acceleration over gravity",
    example="maxwell-slow",
    derivation="01_balance",
)
