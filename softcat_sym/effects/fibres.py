"""Fibres: the plastic strain has any profile through the thickness, not only a linear one."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.bending import bending_share
from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.scaling import flow_nonlinearity, section_of
from softcat_sym.scene.dimensions import needed_in_space
from softcat_sym.scene.scene import Scene


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    # A linear profile carries at most M_Y; fibres that yield one after another carry M_p = M_Y <|zeta|>/<zeta^2>.
    section = section_of(scene)
    reserve = section.mean_lever / section.zeta_squared - 1
    nonlinear = flow_nonlinearity(scene, motion.flowing_overstress)
    share = reserve * bending_share(scene, motion) * motion.relaxed * nonlinear
    meaning = "load that fibres yielding one after another carry beyond a linear profile"
    return Estimate(
        min(1.0, share), meaning, "M_p/M_Y - 1 of the load in bending, for a nonlinear flow rule", 1 + share
    )


FIBRES = Effect(
    name="fibres",
    summary="plastic strain of any profile through the thickness",
    source="A 1, A 2",
    contribute=partial(replace, resolved=True),
    applies=lambda scene: scene.model == "filament" and VISCOUS_FLOW.applies(scene),
    without_it=f"the law does not flow, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="share of the load in bending, times the share that flow has dissipated",
    example="arrested-overdamped",
    derivation="09_shearing_filament",
    needs=("bending", "finite-stretch", "thinning", "large-rotation", "viscous-flow"),
    in_paper=False,
    indispensable=needed_in_space,
)
