"""Large rotation: exact stretch and turning instead of their small-slope forms."""

from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, of_large_deflections
from softcat_sym.effects.prediction import predicted_sag
from softcat_sym.equations.filament import Terms
from softcat_sym.equations.kinematics import LARGE_ROTATION as EXACT
from softcat_sym.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, centreline=EXACT)


def _estimate(scene: Scene) -> Estimate:
    slope = 4 * predicted_sag(scene)
    return Estimate(slope**2 / 2, "half the square of the slope at the supports")


LARGE_ROTATION = Effect(
    name="large-rotation",
    summary="exact stretch and angle of the centreline",
    source="2.5",
    contribute=_contribute,
    applies=of_large_deflections,
    without_it=SMALL_MODEL,
    estimate=_estimate,
    observable="largest slope squared",
)
