"""Viscous stress: a stress proportional to the strain rate, parallel to an elastic one if there is one."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, OfMotion
from softcat_sym.estimates.scaling import law_in

VISCOUS_STRESS = Effect(
    name="viscous-stress",
    summary="stress eta eps_t",
    source="2.7",
    contribute=partial(replace, viscous=True),
    applies=lambda scene: scene.model == "filament" and law_in(scene).is_viscous,
    without_it="the law has no stress that depends on the strain rate",
    estimate=OfMotion("retarded", "lag of the sag behind its load, or damping of its ringing", late=True),
    observable="ringing of the midpoint that it would have damped; otherwise the forecast lag",
    example="cooked-spaghetti",
    derivation="11_rheologies",
    causes=("flow",),
    indispensable=lambda scene: (
        "" if scene.material.spec.is_elastic else f"the law {scene.material.law!r} has no other stress"
    ),
)
