"""Solid damping: a viscous stress eta_s eps_t beside spring and flow, so that what does not flow rings down too."""

from __future__ import annotations

from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, Motion
from softcat_sym.physics.filament import Terms
from softcat_sym.scene.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, damped=True)


def _applies(scene: Scene) -> bool:
    return scene.model == "filament" and scene.material.has_loss


def _eases(scene: Scene) -> str:
    del scene
    return "stated, it ends ringing"


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    del scene
    return Estimate(motion.damped, "ringing that the loss below yield takes away, or lag of the sag")


SOLID_DAMPING = Effect(
    name="solid-damping",
    summary="stress eta_s eps_t beside spring and flow",
    source="Voigt 1892",
    contribute=_contribute,
    applies=_applies,
    without_it=f"the scene states neither material.loss_tangent nor material.solid_viscosity, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="ringing of the midpoint that it would have ended",
    example="agar-bar",
    derivation="11_rheologies",
    needs=("inertia",),
    eases=_eases,
    in_paper=False,
)
