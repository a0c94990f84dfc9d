"""Viscous stress: a stress proportional to the strain rate, beside any elastic one."""

from dataclasses import replace

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.effects.law import law_in
from softcat_sym.effects.prediction import duration_star, static_modulus
from softcat_sym.equations.filament import Terms
from softcat_sym.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, viscous=True)


def _applies(scene: Scene) -> bool:
    return scene.model == "filament" and law_in(scene).viscosity is not None


def _estimate(scene: Scene) -> Estimate:
    modulus, viscosity = static_modulus(scene), scene.material.viscosity
    if modulus is None or viscosity is None or duration_star(scene) == 0:
        return Estimate(1.0, "retardation time eta/E over the duration, at most 1")
    return Estimate(
        min(1.0, viscosity / modulus / scene.run.duration), "retardation time eta/E over the duration, at most 1"
    )


VISCOUS_STRESS = Effect(
    name="viscous-stress",
    summary="stress eta eps_t",
    source="2.7",
    contribute=_contribute,
    applies=_applies,
    without_it="the law has no stress that depends on the strain rate",
    estimate=_estimate,
    observable="largest viscous stress over the largest stress",
)
