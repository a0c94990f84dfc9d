"""Columns of dimensionless groups: which constants of a physical scene they set (Kamrin & Mahadevan 2012, 3.9, 3.10).

A scene that has been read holds physical values only. Here a group sets the constants that it is made of, in the units
rho g L and sqrt(L/g) of the scene; what no group fixes keeps its value, and so do times.
"""

from __future__ import annotations

import math

from softcat_sym.ensemble.table import Row, is_number
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene
from softcat_sym.scene.laws import CONSTANTS, kind_of_constant
from softcat_sym.scene.relations import GROUND, RELATES, Relation, faults_of, solve
from softcat_sym.scene.shear_data import power, shear_names
from softcat_sym.scene.units import shown, with_unit

TABLE = "groups."
_SLENDERNESS = "groups.delta"


def is_group(key: str) -> bool:
    """Whether a key belongs to the groups."""
    return key.startswith(TABLE)


def constants_of(scene: Scene, row: Row) -> Row:
    """What the groups of a row set in a scene, as a scene file would give it.

    Parameters
    ----------
    scene : Scene
        With the other values of the row.
    row : dict
        The row, its other keys included: what they set is not set again.

    Raises
    ------
    SceneError
        If a group is unknown, no positive number, says something twice, or belongs to another law.
    """
    groups = {key.removeprefix(TABLE): value for key, value in row.items() if is_group(key)}
    faults = [fault for key, value in groups.items() if (fault := _fault(key, value)) is not None]
    if scene.load.gravity == 0 and not faults:
        faults = [Fault("load.gravity", "zero, but the groups are measured by it", "a positive gravity")]
    if faults:
        raise SceneError(faults)
    numbers = {key: float(value) for key, value in groups.items() if is_number(value)}
    slenderness = numbers.pop("delta", None)
    set_by_groups: Row = {}
    if slenderness is not None:
        set_by_groups["filament.thickness"] = with_unit(slenderness * scene.filament.span, "length")
    material, at = scene.material, _units(scene)
    relations = [Relation(TABLE + key, *RELATES[key], _ratio(key, value, at)) for key, value in numbers.items()]
    given = [
        name for name in CONSTANTS[material.law] if {f"material.{one}" for one in (name, *shear_names(name))} & set(row)
    ]
    relations += [_kept(scene, name) for name in given]
    for name in CONSTANTS[material.law]:
        if name not in solve(relations):
            relations.append(_kept(scene, name))
    faults = faults_of(relations, material.law)
    if faults:
        raise SceneError(faults)
    for name, value in solve(relations).items():
        if name not in given and value != getattr(material, name):
            set_by_groups[f"material.{name}"] = kind_of_constant(name, material.law, material.index).write(value)
    return set_by_groups


def _fault(key: str, value: object) -> Fault | None:
    known = ("delta", *RELATES)
    if key not in known:
        accepted = f"{', '.join(known)}; times as run.duration and load.ramp, an index as material.index"
        return Fault(TABLE + key, "no group that a table can change", accepted)
    if not is_number(value) or not 0 < float(value) < math.inf:
        return Fault(TABLE + key, f"{shown(value)} is no positive number", "a positive number without a unit")
    return None


def _units(scene: Scene) -> tuple[float, float, float]:
    """Stress rho g L [Pa], time sqrt(L/g) [s] and the index."""
    span, gravity = scene.filament.span, scene.load.gravity
    return scene.filament.density * gravity * span, math.sqrt(span / gravity), scene.material.index


def _ratio(key: str, group: float, at: tuple[float, float, float]) -> float:
    stress, time, index = at
    ratios = {
        "G": stress / group,
        "eps_Y": group,
        "E_star": stress * group,
        "V": stress * power(time, index) * group,
        "B": stress * time / (2 * group),
        "tau": time * group,
    }
    return ratios[key]


def _kept(scene: Scene, name: str) -> Relation:
    return Relation(f"material.{name}", name, GROUND, getattr(scene.material, name))
