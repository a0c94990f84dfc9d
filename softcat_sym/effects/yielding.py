"""Yielding: the material does not flow below the yield stress."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.forecast import expected_sag
from softcat_sym.estimates.scaling import law_in
from softcat_sym.scene.scene import Scene


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    # In an initially plastic state the yield stress decides whether the material flows at once.
    flows = 1.0 if VISCOUS_FLOW.indispensable(scene) else VISCOUS_FLOW.estimate(scene, motion).value
    return Estimate(
        flows / max(1.0, motion.flowing_overstress),
        "flow that the yield stress prevents",
        "sigma_Y over the mean stress, times the estimate of flow",
        _without(scene),
    )


def _without(scene: Scene) -> float | None:
    """Sag of a filament that flows under any stress, over that of this one; None for a rule of its own."""
    limit, sag = scene.material.yield_stress, expected_sag(scene)
    if limit is None or not sag > 0:
        return None
    fluid = scene.material.model_copy(update={"yield_stress": _FAINT * limit})
    return expected_sag(scene.model_copy(update={"material": fluid})) / sag


_FAINT = 1e-6
"""Share of the yield stress that holds nothing."""


YIELDING = Effect(
    name="yielding",
    summary="no flow below the yield stress",
    source="2.25-2.27",
    contribute=partial(replace, yields=True),
    applies=lambda scene: law_in(scene).yields,
    without_it="the law has no yield stress",
    estimate=_estimate,
    observable="yield stress over the stress of beam or catenary at the largest sag",
    example="arrested-overdamped",
    derivation="02_section_and_closures",
    causes=("yield stress",),
    needs=("viscous-flow",),
)
