"""Viscous flow: plastic strain that grows with the stress (without a threshold, unless yielding is in force)."""

import math
from dataclasses import replace

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.effects.law import law_in
from softcat_sym.effects.prediction import effective_viscosity, instant_modulus
from softcat_sym.equations.filament import Terms
from softcat_sym.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, flows=True)


def _applies(scene: Scene) -> bool:
    return law_in(scene).flows


def _estimate(scene: Scene) -> Estimate:
    modulus, viscosity = instant_modulus(scene), effective_viscosity(scene)
    if not viscosity or modulus is None:
        return Estimate(0.0, "share of the stress that relaxes during the run")
    relaxed = -math.expm1(-scene.run.duration * modulus / viscosity)
    return Estimate(relaxed, "share of the stress that relaxes during the run, 1 - exp(-duration E/eta)")


VISCOUS_FLOW = Effect(
    name="viscous-flow",
    summary="plastic strain rate phi(sigma): sigma/eta, (sigma/K)^(1/n) or the rule given",
    source="2.7, 2.12",
    contribute=_contribute,
    applies=_applies,
    without_it="the law is elastic, Newtonian or Kelvin-Voigt: it has no plastic strain",
    estimate=_estimate,
    observable="largest plastic strain",
)
