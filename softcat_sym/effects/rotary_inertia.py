"""Rotary inertia: it takes a moment to turn a section faster."""

from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, of_large_deflections
from softcat_sym.equations.filament import Terms
from softcat_sym.scene import Scene, groups_of


def _contribute(terms: Terms) -> Terms:
    return replace(terms, rotary_inertia=True)


def _estimate(scene: Scene) -> Estimate:
    # rho I0 of a rectangle over the mass, times 12.3/L^2: mean square slope over mean square sag of the first mode.
    return Estimate(groups_of(scene).delta ** 2, "kinetic energy of turning over that of the motion, (h0/L)^2")


def _called_for(scene: Scene, value: float) -> bool:
    # Without it the section angle is algebraic, and with it the fastest wave of all must be followed.
    return False


ROTARY_INERTIA = Effect(
    name="rotary-inertia",
    summary="angular momentum of the sections",
    source="Timoshenko 1921",
    contribute=_contribute,
    applies=of_large_deflections,
    without_it=SMALL_MODEL,
    estimate=_estimate,
    observable="kinetic energy of turning over kinetic energy",
    needs=("inertia", "shear"),
    in_paper=False,
    called_for=_called_for,
)
