"""Bending: curvature, moment and transverse force, with the bending plastic strain where the law flows."""

from dataclasses import replace

from softcat_sym.effects.effect import Effect, Estimate, always
from softcat_sym.effects.prediction import predicted_sag
from softcat_sym.equations.filament import Terms
from softcat_sym.scene import Scene, groups_of


def _contribute(terms: Terms) -> Terms:
    return replace(terms, bending=True)


def _estimate(scene: Scene) -> Estimate:
    delta = groups_of(scene).delta
    tension_over_bending = 2 / 3 * (predicted_sag(scene) / delta) ** 2
    return Estimate(max(delta, 1 / (1 + tension_over_bending)), "share of the load carried in bending, at least h0/L")


BENDING = Effect(
    name="bending",
    summary="curvature, moment M and transverse force N = M_X/s",
    source="2.3, 2.10, 2.11",
    contribute=_contribute,
    applies=always,
    without_it="",
    estimate=_estimate,
    observable="bending share of the load away from the clamps",
)
