"""Viscous stress: a stress proportional to the strain rate, beside any elastic one."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, OfMotion
from softcat_sym.effects.law import law_in
from softcat_sym.scene.scene import Scene


def _indispensable(scene: Scene) -> str:
    law = law_in(scene)
    return "" if law.has_springs or law.has_chains else f"the law {law.name!r} has no other stress"


def _applies(scene: Scene) -> bool:
    return scene.model == "filament" and law_in(scene).is_viscous


VISCOUS_STRESS = Effect(
    name="viscous-stress",
    summary="stress eta eps_t",
    source="2.7",
    contribute=partial(replace, viscous=True),
    applies=_applies,
    without_it="the law has no stress that depends on the strain rate",
    estimate=OfMotion("retarded", "how far the sag lags behind its load, or its ringing dies out"),
    observable="ringing of the midpoint that it would have ended; else the lag foreseen",
    example="cooked-spaghetti",
    derivation="11_rheologies",
    causes=("flow",),
    indispensable=_indispensable,
)
