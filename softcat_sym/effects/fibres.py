"""Fibres: the plastic strain has any profile through the thickness, not only a linear one."""

from dataclasses import replace

from softcat_sym.effects.bending import BENDING
from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate
from softcat_sym.effects.law import flow_is_linear
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.equations.filament import Terms
from softcat_sym.equations.section import SECTIONS
from softcat_sym.equations.symbols import c
from softcat_sym.scene import Scene


def _contribute(terms: Terms) -> Terms:
    return replace(terms, resolved=True)


def _applies(scene: Scene) -> bool:
    return scene.model == "filament" and VISCOUS_FLOW.applies(scene)


def _estimate(scene: Scene) -> Estimate:
    # A linear profile carries M_Y at the most, M_p = M_Y <|zeta|>/<zeta^2> is what fibres that yield in turn can carry.
    shape = SECTIONS[scene.filament.section]
    reserve = float(2 * shape.overstress_mean.subs(c, 0) / shape.zeta_squared) - 1
    value = 0.0 if flow_is_linear(scene) else reserve * BENDING.estimate(scene).value
    return Estimate(value, "plastic reserve M_p/M_Y - 1 times the share of the load carried in bending")


def _called_for(scene: Scene, value: float) -> bool:
    # Fibres that yield in turn change where a filament stops; a smooth rule only how fast it goes.
    return value > (0.0 if YIELDING.applies(scene) else scene.run.accuracy)


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
