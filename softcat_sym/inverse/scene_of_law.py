"""A scene under another law: with its own constants where it has them, and rough ones otherwise."""

from __future__ import annotations

from collections.abc import Sequence

from softcat_sym.effects import REGISTRY
from softcat_sym.inverse.flow_curve.handing_on import REPLACED
from softcat_sym.inverse.measurements.series import Measurements
from softcat_sym.inverse.rough_constants import rough_constants
from softcat_sym.scene import Scene
from softcat_sym.scene.laws import CONSTANTS, kind_of_constant
from softcat_sym.scene.shear_data import INDEXED

FITTED = tuple(law for law, constants in CONSTANTS.items() if constants and law != "custom")
"""Laws that have a fixed set of constants."""


def constants_of(law: str) -> tuple[str, ...]:
    """Names of all constants of one of :data:`FITTED`, its index included."""
    return (*CONSTANTS[law], *(("index",) if law in INDEXED else ()))


def scene_of_law(scene: Scene, law: str, films: Measurements) -> Scene:
    """Give a scene another law, with its own values where it has them and rough ones otherwise.

    Parameters
    ----------
    scene : Scene
        Any.
    law : str
        One of :data:`FITTED`.
    films : Measurements
        How far it sags, and in which time, tells rough values.

    Returns
    -------
    Scene
        Where effects are listed, without those that the law cannot have, and with what only it has.
    """
    material, rough = scene.material, rough_constants(scene, films, law)
    index = material.index if law in INDEXED and material.law in INDEXED else 1.0
    # A consistency is no viscosity, and its rough value is only right for an index of one.
    same = (material.law in INDEXED) == (law in INDEXED) or material.index == 1
    changes: dict[str, object] = {f"material.{name}": None for name in REPLACED}
    changes["material.law"] = law
    if law not in FITTED or "youngs_modulus" not in CONSTANTS[law]:
        changes["material.youngs_modulus"] = None
    for name in CONSTANTS[law]:
        own = getattr(material, name)
        keeps = own is not None and (name != "viscosity" or same)
        changes[f"material.{name}"] = kind_of_constant(name, law, index).write(own if keeps else rough[name])
    if law in INDEXED:
        changes["material.index"] = index
    if isinstance(scene.run.effects, str):
        return scene.replace(changes)
    freed = scene.replace({**changes, "run.effects": "auto"})
    return freed.replace({"run.effects": _effects(scene, freed, scene.run.effects)})


def _effects(former: Scene, scene: Scene, listed: Sequence[str]) -> list[str]:
    """The listed effects that another law can have, and those of published theory that only it has, not the former."""
    able = {one.name: one for one in REGISTRY if one.applies(scene)}
    own = [name for name, one in able.items() if one.in_paper and not one.applies(former)]
    kept = [name for name in listed if name in able]
    names = [*kept, *(name for name in own if name not in kept)]
    while lacking := [name for name in names if not {*able[name].needs} <= {*names}]:
        names = [name for name in names if name not in lacking]
    return names
