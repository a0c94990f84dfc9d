"""Fibres: the plastic strain has any profile through the thickness, not only a linear one."""

from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.equations.filament import Terms
from softcat_sym.scene import Scene, groups_of


def _contribute(terms: Terms) -> Terms:
    return replace(terms, resolved=True)


def _applies(scene: Scene) -> bool:
    return scene.model == "filament" and VISCOUS_FLOW.applies(scene)


def _estimate(scene: Scene) -> Estimate:
    # A linear law keeps a linear profile; where fibres yield in turn, what they leave behind is spread over h0.
    value = groups_of(scene).delta if YIELDING.applies(scene) else 0.0
    return Estimate(value, "change of the sag by fibres that yield in turn, h0/L (0 for a linear law)")


def _called_for(scene: Scene, value: float) -> bool:
    return value > 0


FIBRES = Effect(
    name="fibres",
    summary="plastic strain of any profile through the thickness",
    source="A 1, A 2",
    contribute=_contribute,
    applies=_applies,
    without_it=f"the law does not flow, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="largest difference of the plastic strain from a linear profile",
    needs=("bending", "finite-stretch", "thinning", "large-rotation", "viscous-flow"),
    in_paper=False,
    called_for=_called_for,
)
