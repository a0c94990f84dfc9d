"""``[groups]`` resolved into a physical table; what it does not determine may stand beside it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from pydantic_core import PydanticCustomError, ValidationError

from softcat_sym.errors import Fault
from softcat_sym.scene.faults import fault_of
from softcat_sym.scene.filament import Filament
from softcat_sym.scene.groups import GroupBlock
from softcat_sym.scene.kinds import LARGEST, SMALLEST
from softcat_sym.scene.laws import CONSTANTS, GROUPED, kind_of_constant
from softcat_sym.scene.load import Load
from softcat_sym.scene.material import POISSON, Material
from softcat_sym.scene.part import kinds_of
from softcat_sym.scene.relations import GROUND, RELATES, Relation, faults_of, solve
from softcat_sym.scene.shear_data import FROM_SHEAR, INDEXED, power, shear_names
from softcat_sym.scene.units import shown, with_unit

Table = dict[str, Any]

# The paper's own dimensional set (its section 3).
PAPER = {"filament.span": "0.2 m", "filament.density": "1900 kg/m^3", "load.gravity": "9.81 m/s^2"}
PAPER_MODULUS = "4 MPa"
_MODULUS_GROUPS = ("E_star", "eps_Y", "tau")
# Each of these keys of [groups] stands for one physical key.
_STANDS_FOR = {
    "delta": "filament.thickness",
    "law": "material.law",
    "ramp": "load.ramp",
    "duration": "run.duration",
}


@dataclass(frozen=True, slots=True)
class Resolved:
    """A physical table, what was wrong with its groups, and the paths that are theirs to fill."""

    table: Table
    faults: tuple[Fault, ...] = ()
    determined: frozenset[str] = frozenset()
    complete: bool = True

    def excuses(self, fault: Fault) -> bool:
        """Tell whether a physical key is missing only because the groups could not be resolved."""
        return not self.complete and fault.path in self.determined and fault.found.startswith("missing")


@dataclass(frozen=True, slots=True)
class _Scales:
    """L, rho and g, SI; and the index."""

    span: float
    density: float
    gravity: float
    index: float

    @property
    def stress(self) -> float:
        return self.density * self.gravity * self.span

    @property
    def time(self) -> float:
        return math.sqrt(self.span / self.gravity)


def determined_by_groups(table: Mapping[str, Any]) -> frozenset[str]:
    """Name the physical paths that ``[groups]`` fills in this table.

    Parameters
    ----------
    table : mapping
        Raw scene.

    Returns
    -------
    frozenset of str
        Dotted paths; empty without groups.
    """
    groups = table.get("groups")
    if not isinstance(groups, Mapping):
        return frozenset(_STANDS_FOR.values()) if "groups" in table else frozenset()
    filled = {path for key, path in _STANDS_FOR.items() if key in groups or key in ("delta", "law")}
    constants = CONSTANTS.get(str(groups.get("law")), ("youngs_modulus", "viscosity", "yield_stress"))
    given = _section(table, "material")
    for name in constants:
        if not {name, *shear_names(name)} & set(given):
            filled.add(f"material.{name}")
    if not any(key in groups for key in _MODULUS_GROUPS):
        # The modulus is then only the paper's default, and may be given beside the groups.
        filled.discard("material.youngs_modulus")
    return frozenset(filled)


def resolve_groups(table: Table) -> Resolved:
    """Replace ``[groups]`` by the physical values it determines.

    Parameters
    ----------
    table : dict
        Raw scene; not changed.

    Returns
    -------
    Resolved
        The table without groups. With faults, what could not be determined is left out.
    """
    if "groups" not in table:
        return Resolved(table)
    determined = determined_by_groups(table) | {"material.youngs_modulus"}
    rest = {key: dict(value) if isinstance(value, Mapping) else value for key, value in table.items()}
    raw = rest.pop("groups")
    if not isinstance(raw, Mapping):
        no_table = Fault("groups", f"{shown(raw)} is not a table", "a table [groups]")
        return Resolved(rest, (no_table,), determined | set(PAPER), complete=False)
    block, faults = _read_block(raw)
    faults += _given_twice(raw, rest)
    for path, value in PAPER.items():
        _fill(rest, path, value)
    scales = _scales(rest, faults, _index(raw, rest, block))
    relations = _relations(raw, rest, block, scales)
    law = raw.get("law")
    if isinstance(law, str) and law in GROUPED:
        faults += [*faults_of(relations, law), *_of_another_index(raw, law, _index(raw, rest, block))]
        _fill(rest, "material.law", law)
        if block is not None and "n" in raw and law in INDEXED:
            _fill(rest, "material.index", block.n)
    if faults or block is None or scales is None or any(relation.ratio <= 0 for relation in relations):
        return Resolved(rest, tuple(faults), determined, complete=False)
    faults += _fill_in(rest, block, scales, solve(relations))
    return Resolved(rest, tuple(faults), determined, complete=not faults)


def _read_block(raw: Mapping[str, Any]) -> tuple[GroupBlock | None, list[Fault]]:
    try:
        return GroupBlock.model_validate(dict(raw)), []
    except ValidationError as error:
        known = {"groups": tuple(GroupBlock.model_fields)}
        accepted = {f"groups.{name}": kind.accepted for name, kind in kinds_of(GroupBlock).items()}
        details = [{**one, "loc": ("groups", *one["loc"])} for one in error.errors()]
        return None, [fault_of(one, known, accepted) for one in details]  # type: ignore[arg-type]


def _given_twice(raw: Mapping[str, Any], rest: Table) -> list[Fault]:
    faults = []
    for key, path in (*_STANDS_FOR.items(), ("n", "material.index")):
        table, _, name = path.partition(".")
        if key in raw and name in _section(rest, table):
            faults.append(Fault(path, f"given twice, here and as groups.{key}", "one of the two"))
    if "delta" in raw and "diameter" in _section(rest, "filament"):
        faults.append(Fault("filament.diameter", "given twice, here and as groups.delta", "one of the two"))
    return faults


def _index(raw: Mapping[str, Any], rest: Table, block: GroupBlock | None) -> float:
    if block is not None and "n" in raw:
        return block.n
    try:
        return float(kinds_of(Material)["index"].read(_section(rest, "material").get("index", 1.0)))
    except PydanticCustomError:
        return 1.0


def _poisson(rest: Table) -> float:
    try:
        return float(kinds_of(Material)["poisson"].read(_section(rest, "material").get("poisson", POISSON)))
    except PydanticCustomError:
        return POISSON


def _of_another_index(raw: Mapping[str, Any], law: str, index: float) -> list[Fault]:
    """Tau and B are ratios of a viscosity."""
    if law not in INDEXED or index == 1:
        return []
    found = f"given, but with an index of {index:g} there is no viscosity to scale"
    return [Fault(f"groups.{key}", found, "groups.V, K/(rho g L (L/g)^(n/2))") for key in ("tau", "B") if key in raw]


def _scales(rest: Table, faults: list[Fault], index: float) -> _Scales | None:
    """Read L, rho and g; a scale that cannot be read is its own part's fault, gravity 0 is one of the groups."""
    try:
        span = kinds_of(Filament)["span"].read(rest["filament"]["span"])
        density = kinds_of(Filament)["density"].read(rest["filament"]["density"])
        gravity = kinds_of(Load)["gravity"].read(rest["load"]["gravity"])
    except (PydanticCustomError, KeyError, TypeError):
        return None
    if gravity == 0:
        faults.append(Fault("load.gravity", "zero, but [groups] is scaled by gravity", "a positive acceleration"))
        return None
    return _Scales(span, density, gravity, index)


def _relations(raw: Mapping[str, Any], rest: Table, block: GroupBlock | None, at: _Scales | None) -> list[Relation]:
    """All that was said of the constants. Without numbers (a fault elsewhere) the ratios are 0: only who fixes whom."""
    relations, poisson = [], _poisson(rest)
    for name in ("youngs_modulus", "viscosity", "yield_stress"):
        index = at.index if at else 1.0
        shear = [(one.shear, one.factor(index, poisson)) for one in FROM_SHEAR if one.constant == name]
        for key, times in ((name, 1.0), *shear):
            if key in _section(rest, "material"):
                value = times * _number(rest["material"][key], key, raw.get("law"), index)
                relations.append(Relation(f"material.{key}", name, GROUND, value))
    for key, (constant, other) in RELATES.items():
        if raw.get(key) is not None:
            ratio = _ratio(key, getattr(block, key), at) if block and at else 0.0
            relations.append(Relation(f"groups.{key}", constant, other, ratio))
    moduli = {"youngs_modulus", *shear_names("youngs_modulus")}
    if not any(key in raw for key in _MODULUS_GROUPS) and not moduli & set(_section(rest, "material")):
        relations.append(Relation("groups", "youngs_modulus", GROUND, _number(PAPER_MODULUS, "youngs_modulus")))
    return relations


def _number(value: object, key: str, law: object = None, index: float = 1.0) -> float:
    try:
        return float(kind_of_constant(key, str(law), index).read(value))
    except PydanticCustomError:
        return 0.0


def _ratio(key: str, group: float, at: _Scales) -> float:
    """Turn a group into the ratio of its two constants, SI [3.9, 3.10]."""
    return {
        "G": at.stress / group,
        "eps_Y": group,
        "E_star": at.stress * group,
        "V": at.stress * power(at.time, at.index) * group,
        "B": at.stress * at.time / (2 * group),
        "tau": at.time * group,
    }[key]


def _fill_in(rest: Table, block: GroupBlock, at: _Scales, constants: dict[str, float]) -> list[Fault]:
    """Write the determined values into the table; they are beyond all measure only for absurd groups."""
    thickness = block.delta * at.span
    absurd = [
        f"{name} {value:g}"
        for name, value in {"thickness": thickness, **constants}.items()
        if not SMALLEST <= value <= LARGEST
    ]
    if absurd:
        found = f"these groups give {', '.join(absurd)}, beyond {SMALLEST:g} to {LARGEST:g} in SI units"
        return [Fault("groups", found, "moderate numbers")]
    elastic = at.span * math.sqrt(at.density / constants["youngs_modulus"])
    unit = at.time if block.time_unit == "gravity" else elastic
    _fill(rest, "filament.thickness", with_unit(thickness, "length"))
    for path, time in (("load.ramp", block.ramp), ("run.duration", block.duration)):
        if time is not None:
            _fill(rest, path, with_unit(time * unit, "time"))
    for name in CONSTANTS[block.law]:
        if not set(shear_names(name)) & set(_section(rest, "material")):
            _fill(rest, f"material.{name}", kind_of_constant(name, block.law, at.index).write(constants[name]))
    return []


def _fill(rest: Table, path: str, value: object) -> None:
    table, _, key = path.partition(".")
    section = rest.setdefault(table, {})
    if isinstance(section, dict):
        section.setdefault(key, value)


def _section(table: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    section = table.get(name)
    return section if isinstance(section, Mapping) else {}
