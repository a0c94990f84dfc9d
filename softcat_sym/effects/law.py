"""The constitutive law of a scene, as equations."""

from __future__ import annotations

from softcat_sym.equations.law import Law
from softcat_sym.equations.laws import law_of
from softcat_sym.scene import Scene
from softcat_sym.scene.laws import SOLIDS


def law_in(scene: Scene) -> Law:
    """The law that the scene names, with its modes or its own flow rule."""
    material = scene.material
    return law_of(material.law, modes=len(material.modes), formula=material.formula, yields=material.threshold > 0)


def is_solid(scene: Scene) -> bool:
    """Whether the material keeps its shape for ever."""
    return scene.material.law in SOLIDS


def flow_is_linear(scene: Scene) -> bool:
    """Whether the plastic strain rate is proportional to the stress, so that it stays linear through the thickness."""
    material = scene.material
    rules = {"bingham": False, "custom": False, "power-law": material.index == 1, "herschel-bulkley": False}
    return rules.get(material.law, True)
