"""Viscous flow: plastic strain that grows with the stress (without a threshold, unless yielding is in force)."""

import math
from dataclasses import replace

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.equations.filament import Terms
from softcat_sym.equations.rheology import maxwell_means, maxwell_rate
from softcat_sym.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, flow=maxwell_means, rate=maxwell_rate())


def _applies(scene: Scene) -> bool:
    return scene.material.law != "elastic"


def _estimate(scene: Scene) -> Estimate:
    material = scene.material
    if material.viscosity is None or material.youngs_modulus is None:
        return Estimate(0.0, "share of the stress that relaxes during the run")
    relaxed = -math.expm1(-scene.run.duration * material.youngs_modulus / material.viscosity)
    return Estimate(relaxed, "share of the stress that relaxes during the run, 1 - exp(-duration E/eta)")


VISCOUS_FLOW = Effect(
    name="viscous-flow",
    summary="plastic strain rate sigma/eta",
    source="2.7, 2.12",
    contribute=_contribute,
    applies=_applies,
    without_it="the law is elastic: it does not flow",
    estimate=_estimate,
    observable="largest plastic strain",
)
