"""Viscous flow: plastic strain that grows with the stress (without a threshold, unless yielding is in force)."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, Estimate, OfMotion
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.quasi_static_sag import elastic_sag_under, load_factor
from softcat_sym.estimates.scaling import instant_modulus, weight_stress
from softcat_sym.scene.scene import Scene


def _indispensable(scene: Scene) -> str:
    initial = scene.initial
    plastic = bool(initial.P) or bool(initial.C) or (initial.stretch != 1 and initial.relaxed)
    plastic = plastic or initial.surface == "relaxed"
    return "the initial state is a plastic strain" if plastic else ""


_RELAXED = OfMotion(
    "relaxed", "share of the stress that relaxes during the run", "1 - exp(-t E/eta), beyond yield", amplified=True
)


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    """Estimate of flow; without it the filament sags as its springs let it."""
    weight, found = weight_stress(scene) * load_factor(scene), _RELAXED(scene, motion)
    if weight == 0:
        return found
    return replace(found, without=min(1.0, elastic_sag_under(scene, weight, instant_modulus(scene)) / motion.sag))


VISCOUS_FLOW = Effect(
    name="viscous-flow",
    summary="plastic strain rate phi(sigma): sigma/eta, (sigma/K)^(1/n) or the given rule; chains that relax",
    source="2.7, 2.12",
    contribute=partial(replace, flows=True),
    applies=lambda scene: scene.material.spec.flows,
    without_it="the law is elastic, Newtonian or Kelvin-Voigt: it has no plastic strain",
    estimate=_estimate,
    observable="largest fibre stress over the yield stress; without one, the forecast relaxation",
    example="continual-descent",
    derivation="11_rheologies",
    causes=("flow",),
    indispensable=_indispensable,
)
