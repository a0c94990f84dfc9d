"""Yielding: nothing flows below the yield stress."""

from dataclasses import replace

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.effects.law import law_in
from softcat_sym.effects.prediction import gravity_number_of, predicted_sag
from softcat_sym.equations.filament import Terms
from softcat_sym.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, yields=True)


def _applies(scene: Scene) -> bool:
    return law_in(scene).yields


def _estimate(scene: Scene) -> Estimate:
    gravity_number = gravity_number_of(scene)
    sag = predicted_sag(scene)
    if gravity_number is None or gravity_number == 0 or sag == 0:
        return Estimate(1.0, "yield stress over the stress of the catenary")
    return Estimate(
        1 / (gravity_number * (sag + 1 / (8 * sag))), "yield stress over the stress of the catenary, 1/(G (H + 1/8H))"
    )


YIELDING = Effect(
    name="yielding",
    summary="nothing flows below the yield stress",
    source="2.25-2.27",
    contribute=_contribute,
    applies=_applies,
    without_it="the law has no yield stress",
    estimate=_estimate,
    observable="yield stress over the largest fibre stress",
    needs=("viscous-flow",),
)
