"""Inertia: momentum in the balance."""

from dataclasses import replace

from softcat_sym.effects.effect import Effect, Estimate, always
from softcat_sym.effects.prediction import duration_star, viscous_number
from softcat_sym.equations.filament import Terms
from softcat_sym.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, inertia=True)


def _estimate(scene: Scene) -> Estimate:
    # t_high of section 2.2 with alpha = 1/15: from then on inertia is less than alpha of the tension.
    number = viscous_number(scene)
    viscous = None if number is None else 1 / (2 * number)
    time = duration_star(scene)
    settles = (viscous / 3) ** 0.2 * 0.4**-0.6 if viscous is not None else time
    return Estimate(
        min(1.0, settles / time) if time else 1.0, "share of the run before inertia has died out, t_high/duration"
    )


INERTIA = Effect(
    name="inertia",
    summary="acceleration of the filament",
    source="2.1, 2.2",
    contribute=_contribute,
    applies=always,
    without_it="",
    estimate=_estimate,
    observable="largest inertia force over weight",
)
