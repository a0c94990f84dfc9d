"""The constitutive law of a scene and its properties."""

from __future__ import annotations

from softcat_sym.physics.terms import Rheology
from softcat_sym.scene.scene import Scene


def law_in(scene: Scene) -> Rheology:
    """The law that the scene names, with its modes or its own flow rule."""
    material = scene.material
    return Rheology(
        material.law,
        modes=len(material.modes),
        flow=material.flow,
        threshold=bool(material.flow) and material.threshold > 0,
        solvent=not material.spec.has_chains or bool(material.solvent_viscosity),
    )


def may_have(scene: Scene, effect: str) -> bool:
    """Whether `auto` may choose an effect, or a list names it; those of the published theory are not asked for here."""
    requested = scene.run.effects
    return requested == "auto" if isinstance(requested, str) else effect in requested


def flow_nonlinearity(scene: Scene, overstress: float) -> float:
    """Nonlinearity of the flow rule, 0 to 1: with a linear one the plastic strain stays linear in z."""
    material = scene.material
    if material.spec.has_formula:
        return 1.0
    bent = abs(1 - 1 / material.index)
    return min(1.0, bent + 1 / max(1.0, overstress))
