"""Values of free parameters put into a scene, without validating everything anew at each step of a fit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TypeVar, cast

from softcat_sym.inverse.forward.free import FreeParameter
from softcat_sym.scene import Filament, Material, Scene
from softcat_sym.scene.part import Part
from softcat_sym.scene.shear_data import FROM_SHEAR

AnyPart = TypeVar("AnyPart", bound=Part)


def with_values(scene: Scene, free: Sequence[FreeParameter], values: Sequence[float]) -> Scene:
    """Return the scene with other values of what is free.

    What follows from a value follows again, as in :meth:`softcat_sym.Scene.replace`: a width that was not given is the
    thickness, tensile constants follow from shear data and the index. What belongs to the measurement is not in it.

    Parameters
    ----------
    scene : Scene
        Any.
    free : sequence of FreeParameter
        Of this scene.
    values : sequence of float
        SI.
    """
    tables: dict[str, dict[str, float]] = {}
    for one, value in zip(free, values, strict=True):
        if not one.of_measurement:
            table, _, key = one.path.partition(".")
            tables.setdefault(table, {})[key] = float(value)
    update: dict[str, object] = {}
    for table, changes in tables.items():
        if table == "material":
            update[table] = _material(scene.material, changes)
        elif table == "filament":
            update[table] = _filament(scene.filament, changes)
        else:
            update[table] = getattr(scene, table).model_copy(update=changes)
    return scene.model_copy(update=update)


def _filament(filament: Filament, changes: dict[str, float]) -> Filament:
    follows = filament.section == "circle" or "width" not in filament.model_fields_set
    if "thickness" not in changes or "width" in changes or not follows:
        return filament.model_copy(update=changes)
    return _copied(filament, changes, {"width": changes["thickness"], "diameter": None})


def _material(material: Material, changes: dict[str, float]) -> Material:
    given: dict[str, object] = {}
    follows = _following(material, changes)
    modes, parameters = list(material.modes), {one.name: one for one in material.parameters}
    for key, value in changes.items():
        if key.startswith("mode_"):
            _, number, name = key.split("_", 2)
            changed = {name: value}
            modes[int(number) - 1] = replace(modes[int(number) - 1], **changed)
        elif key.startswith("parameters."):
            name = key.partition(".")[2]
            parameters[name] = replace(parameters[name], value=value)
        else:
            given[key] = value
    if modes:
        given["modes"] = tuple(modes)
    if parameters:
        given["parameters"] = tuple(parameters.values())
    return _copied(material, given, follows)


def _following(material: Material, changes: dict[str, float]) -> dict[str, object]:
    """What follows from shear data and other names when some values change."""
    follows: dict[str, object] = {}
    index, poisson = changes.get("index", material.index), changes.get("poisson", material.poisson)
    for rule in FROM_SHEAR:
        if not rule.suits(material.law):
            continue
        others = {one.shear for one in FROM_SHEAR if one.constant == rule.constant} - {rule.shear}
        if rule.constant in changes or others & set(changes):
            # Else it would be said twice.
            follows[rule.shear] = None
            continue
        shear = changes.get(rule.shear, getattr(material, rule.shear))
        if shear is not None:
            follows[rule.constant] = rule.factor(index, poisson) * shear
    if material.loss_modulus is not None:
        modulus = follows.get("youngs_modulus") or changes.get("youngs_modulus", material.youngs_modulus)
        follows["loss_tangent"] = material.loss_modulus * 2 * (1 + poisson) / cast("float", modulus)
    return follows


def _copied(part: AnyPart, given: Mapping[str, object], follows: Mapping[str, object]) -> AnyPart:
    """A copy in which some values were given, and others follow from them."""
    result = part.model_copy(update={**given, **follows})
    # The copy's own set: what follows shall still do so after further changes.
    result.model_fields_set.difference_update(follows)
    return result
