"""Shear: the section turns by itself, and is sheared against the centreline (Reissner's kinematics)."""

from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, of_large_deflections
from softcat_sym.equations.filament import Terms
from softcat_sym.scene import Scene, groups_of

_PER_SLENDERNESS = 0.7
"""Change of the sag per h0/L, against plane-stress elements: the hinges of a yielding filament shear most."""


def _contribute(terms: Terms) -> Terms:
    return replace(terms, shear=True)


def _estimate(scene: Scene) -> Estimate:
    return Estimate(_PER_SLENDERNESS * groups_of(scene).delta, "change of the sag by shear, 0.7 h0/L")


def _called_for(scene: Scene, value: float) -> bool:
    return value > scene.run.accuracy


SHEAR = Effect(
    name="shear",
    summary="shear strain of the section, shear stress in its flow",
    source="Reissner 1972; 3.5-3.7",
    contribute=_contribute,
    applies=of_large_deflections,
    without_it=SMALL_MODEL,
    estimate=_estimate,
    observable="largest shear strain over largest bending strain",
    needs=("bending", "finite-stretch", "thinning", "large-rotation"),
    in_paper=False,
    called_for=_called_for,
)
