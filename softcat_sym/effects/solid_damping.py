"""Solid damping: a viscous stress eta_s eps_t parallel to spring and flow damps ringing without flow, too."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, OfMotion

SOLID_DAMPING = Effect(
    name="solid-damping",
    summary="stress eta_s eps_t parallel to spring and flow",
    source="Voigt 1892",
    contribute=partial(replace, damped=True),
    applies=lambda scene: scene.model == "filament" and scene.material.has_loss,
    without_it=f"the scene states neither material.loss_tangent nor material.solid_viscosity, or {SMALL_MODEL}",
    estimate=OfMotion("damped", "ringing that the loss below yield damps, or lag of the sag", late=True),
    observable="ringing of the midpoint that it would have damped",
    example="agar-bar",
    derivation="11_rheologies",
    needs=("inertia",),
    eases=lambda _scene: "the scene states it, and it damps ringing",
    in_paper=False,
)
