"""A scene given by its dimensionless groups instead of its constants (THEORY 5)."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, Literal

from pydantic import ValidationInfo, field_validator
from pydantic_core import PydanticCustomError, ValidationError

from softcat_sym.errors import Fault
from softcat_sym.scene.laws import LAWS, kind_of_constant, spec_of
from softcat_sym.scene.material import FROM_SHEAR, POISSON, Material, power, shear_names
from softcat_sym.scene.parts import Filament, Load, Part, kinds_of
from softcat_sym.scene.units import LARGEST, SMALLEST, Choice, Kind, Number, fault_of, refusal, shown, with_unit

TimeUnit = Literal["gravity", "elastic"]
_GROUPED = [one.name for one in LAWS.values() if one.has_groups]
Positive = Annotated[float | None, Number(above=0)]


class GroupBlock(Part, table="groups"):
    """The table ``[groups]``; dimensionless. It vanishes when the scene is resolved."""

    delta: Annotated[float, Number(above=0, below=1)]
    """Thickness over span, h0/L."""
    law: Annotated[str, Choice(tuple(LAWS))]
    """Constitutive law: how the material answers to stress."""
    G: Positive = None
    """Gravity over yield stress, rho g L/sY."""
    V: Positive = None
    """Viscosity, eta/(rho sqrt(g L^3)); with an index K/(rho g L (L/g)^(n/2))."""
    eps_Y: Positive = None
    """Yield strain, sY/E."""
    E_star: Positive = None
    """Young's modulus over the weight, E/(rho g L)."""
    tau: Positive = None
    """Relaxation time over that of a fall, V/E_star."""
    B: Positive = None
    """1/(2 V)."""
    n: Annotated[float, Number(above=0)] = 1.0
    """Index of a law that has one."""
    ramp: Annotated[float | None, Number(above=0, closed=True)] = None
    """Time in which gravity grows, in units of groups.time_unit."""
    duration: Positive = None
    """Simulated time, in units of groups.time_unit."""
    time_unit: Annotated[TimeUnit, Choice(TimeUnit)] = "gravity"
    """Unit of groups.ramp and groups.duration; gravity: sqrt(L/g), elastic: L sqrt(rho/E)."""

    @field_validator("law", "n", "time_unit")
    @classmethod
    def _of_the_law(cls, value: Any, info: ValidationInfo) -> Any:
        law = info.data.get("law", value)
        if info.field_name == "law" and law not in _GROUPED:
            accepted = f"give physical values; or one of the laws {', '.join(_GROUPED)}"
            raise refusal(f"the law '{law}' has more constants than groups", accepted)
        if info.field_name == "n" and value != 1 and law in LAWS and not LAWS[law].has_index:
            others = " or ".join(one.name for one in LAWS.values() if one.has_index)
            raise refusal(f"given, but the law '{law}' has no index", f"leaving it out, or {others}")
        if value == "elastic" and info.field_name == "time_unit" and law in LAWS and not LAWS[law].is_elastic:
            raise refusal(f"'elastic', but the law '{law}' has no Young's modulus", "gravity")
        return value


GROUND = "1"

_WITH_INDEX = "groups.V, K/(rho g L (L/g)^(n/2))"
_WORDS = {"youngs_modulus": "Young's modulus", "viscosity": "the viscosity", "yield_stress": "the yield stress"}

# The two constants that each group relates, and their ratio: of the group, the stress rho g L [Pa], the time sqrt(L/g)
# [s] and the index [3.9, 3.10].
RELATES: dict[str, tuple[str, str, Callable[[float, float, float, float], float]]] = {
    "G": ("yield_stress", GROUND, lambda group, stress, time, n: stress / group),
    "eps_Y": ("yield_stress", "youngs_modulus", lambda group, stress, time, n: group),
    "E_star": ("youngs_modulus", GROUND, lambda group, stress, time, n: stress * group),
    "V": ("viscosity", GROUND, lambda group, stress, time, n: stress * power(time, n) * group),
    "B": ("viscosity", GROUND, lambda group, stress, time, n: stress * time / (2 * group)),
    "tau": ("viscosity", "youngs_modulus", lambda group, stress, time, n: time * group),
}


@dataclass(frozen=True, slots=True)
class Relation:
    """``constant = ratio * other``, where the other may be the ground, 1."""

    path: str  # Dotted path of the key that states it
    constant: str  # Names of material constants, or `GROUND`
    other: str
    ratio: float  # SI


def relation_of(key: str, group: float, stress: float, time: float, index: float) -> Relation:
    """What a group says of two constants, from the stress rho g L [Pa] and the time sqrt(L/g) [s]."""
    constant, other, ratio = RELATES[key]
    return Relation(f"groups.{key}", constant, other, ratio(group, stress, time, index))


def faults_of(relations: list[Relation], law: str) -> list[Fault]:
    """List what is said twice, what the law does not use, and what is missing."""
    faults: list[Fault] = []
    tree: list[Relation] = []
    for relation in relations:
        unused = [name for name in (relation.constant, relation.other) if name not in (*LAWS[law].constants, GROUND)]
        if unused:
            # Constants given as such are refused by the material itself.
            if relation.path.startswith("groups."):
                found = f"given, but the law '{law}' has no {unused[0].replace('_', ' ')}"
                faults.append(Fault(relation.path, found, "leaving it out"))
            continue
        ring = _chain(tree, relation.constant, relation.other)
        if ring is None:
            tree.append(relation)
            continue
        names = ", ".join(part.path.removeprefix("groups.") for part in ring)
        own = relation.path.removeprefix("groups.")
        found = f"given twice: {names} and {own} together fix more than there is to fix"
        faults.append(Fault(relation.path, found, "leaving one of them out"))
    loose = [name for name in LAWS[law].constants if _chain(tree, name, GROUND) is None]
    if loose:
        given = {relation.path for relation in relations}
        ways = [f"groups.{key}" for key, pair in RELATES.items() if set(pair[:2]) & set(loose)]
        ways = [path for path in (*ways, *(f"material.{name}" for name in loose)) if path not in given]
        found = f"missing: nothing fixes {' and '.join(_WORDS[name] for name in loose)}"
        faults.append(Fault("groups", found, f"one more of {', '.join(ways)}"))
    return faults


def solve(relations: list[Relation]) -> dict[str, float]:
    """Follow the relations from the ground."""
    values = {GROUND: 1.0}
    for _ in relations:
        for relation in relations:
            if relation.other in values:
                values.setdefault(relation.constant, relation.ratio * values[relation.other])
            elif relation.constant in values:
                values[relation.other] = values[relation.constant] / relation.ratio
    del values[GROUND]
    return values


def _chain(tree: list[Relation], start: str, end: str) -> list[Relation] | None:
    """Return the relations that join two nodes, or None."""
    if start == end:
        return []
    for relation in tree:
        if start in (relation.constant, relation.other):
            beyond = relation.other if start == relation.constant else relation.constant
            rest = _chain([other for other in tree if other is not relation], beyond, end)
            if rest is not None:
                return [relation, *rest]
    return None


Table = dict[str, Any]

# The paper's own dimensional set (its section 3).
PAPER = {"filament.span": "0.2 m", "filament.density": "1900 kg/m^3", "load.gravity": "9.81 m/s^2"}
PAPER_MODULUS = "4 MPa"
_MODULUS_GROUPS = ("E_star", "eps_Y", "tau")
# Each of these keys of [groups] stands for one physical key.
_STANDS_FOR = {"delta": "filament.thickness", "law": "material.law", "ramp": "load.ramp", "duration": "run.duration"}


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


def determined_by_groups(table: Mapping[str, Any]) -> frozenset[str]:
    """Name the physical paths that ``[groups]`` fills in this table."""
    groups = table.get("groups")
    if not isinstance(groups, Mapping):
        return frozenset(_STANDS_FOR.values()) if "groups" in table else frozenset()
    filled = {path for key, path in _STANDS_FOR.items() if key in groups or key in ("delta", "law")}
    law = str(groups.get("law"))
    constants = LAWS[law].constants if law in LAWS else ("youngs_modulus", "viscosity", "yield_stress")
    given = _section(table, "material")
    for name in constants:
        if not {name, *shear_names(name)} & set(given):
            filled.add(f"material.{name}")
    if not any(key in groups for key in _MODULUS_GROUPS):
        # The modulus is then only the paper's default, and may be given beside the groups.
        filled.discard("material.youngs_modulus")
    return frozenset(filled)


def resolve_groups(table: Table) -> Resolved:
    """Replace ``[groups]`` by the physical values it determines."""
    if "groups" not in table:
        return Resolved(table)
    determined = determined_by_groups(table) | {"material.youngs_modulus"}
    rest = {key: dict(value) if isinstance(value, Mapping) else value for key, value in table.items()}
    raw = rest.pop("groups")
    if not isinstance(raw, Mapping):
        no_table = Fault("groups", f"{shown(raw)} is not a table", "a table [groups]")
        return Resolved(rest, (no_table,), determined | set(PAPER), complete=False)
    block, faults = _read_block(raw)
    others = [("delta", f"filament.{key}") for key in ("diameter", "line_width")]
    for key, path in (*_STANDS_FOR.items(), ("n", "material.index"), *others):
        section, _, name = path.partition(".")
        if key in raw and name in _section(rest, section):
            faults.append(Fault(path, f"given twice, here and as groups.{key}", "one of the two"))
    for path, value in PAPER.items():
        _fill(rest, path, value)
    index = block.n if block is not None and "n" in raw else _value(Material, rest, "index", 1.0)
    span, density, gravity = (
        _value(part, rest, key) for part, key in ((Filament, "span"), (Filament, "density"), (Load, "gravity"))
    )
    # A scale that cannot be read is its own part's fault, gravity 0 is one of the groups.
    if span > 0 and density > 0 and gravity == 0:
        faults.append(Fault("load.gravity", "zero, but [groups] is scaled by gravity", "a positive acceleration"))
    scaled = span > 0 and density > 0 and gravity > 0
    stress, time = density * gravity * span, math.sqrt(span / gravity) if scaled else 0.0
    relations = _relations(raw, rest, block if scaled else None, (stress, time, index if scaled else 1.0))
    faults += _of_law(raw, rest, block, relations, index)
    if faults or block is None or not scaled or any(relation.ratio <= 0 for relation in relations):
        return Resolved(rest, tuple(faults), determined, complete=False)
    constants = solve(relations)
    sizes = {"thickness": block.delta * span, **constants}
    if absurd := [f"{name} {value:g}" for name, value in sizes.items() if not SMALLEST <= value <= LARGEST]:
        found = f"these groups give {', '.join(absurd)}, beyond {SMALLEST:g} to {LARGEST:g} in SI units"
        return Resolved(rest, (Fault("groups", found, "moderate numbers"),), determined, complete=False)
    unit = time if block.time_unit == "gravity" else span * math.sqrt(density / constants["youngs_modulus"])
    _fill_physical(rest, block, sizes, unit, index)
    return Resolved(rest, (), determined)


def _of_law(
    raw: Mapping[str, Any], rest: Table, block: GroupBlock | None, relations: list[Relation], index: float
) -> list[Fault]:
    """Fill in the law with its index, and find what does not belong to it."""
    law, faults = raw.get("law"), list[Fault]()
    if isinstance(law, str) and law in _GROUPED:
        faults += faults_of(relations, law)
        if spec_of(law).has_index and index != 1:
            found = f"given, but with an index of {index:g} there is no viscosity to scale"
            faults += [Fault(f"groups.{key}", found, _WITH_INDEX) for key in ("tau", "B") if key in raw]
        _fill(rest, "material.law", law)
    if block is not None and "n" in raw and LAWS[block.law].has_index:
        _fill(rest, "material.index", block.n)
    return faults


def _fill_physical(rest: Table, block: GroupBlock, sizes: Mapping[str, float], unit: float, index: float) -> None:
    """Fill in thickness, times and the constants of the law; `unit` is that of times [s]."""
    _fill(rest, "filament.thickness", with_unit(sizes["thickness"], "m"))
    for path, times in (("load.ramp", block.ramp), ("run.duration", block.duration)):
        if times is not None:
            _fill(rest, path, with_unit(times * unit, "s"))
    for name in LAWS[block.law].constants:
        if not set(shear_names(name)) & set(_section(rest, "material")):
            _fill(rest, f"material.{name}", kind_of_constant(name, block.law, index).write(sizes[name]))


def _read_block(raw: Mapping[str, Any]) -> tuple[GroupBlock | None, list[Fault]]:
    try:
        return GroupBlock.model_validate(dict(raw)), []
    except ValidationError as error:
        known = {"groups": tuple(GroupBlock.model_fields)}
        accepted = {f"groups.{name}": kind.accepted for name, kind in kinds_of(GroupBlock).items()}
        details = [{**detail, "loc": ("groups", *detail["loc"])} for detail in error.errors()]
        return None, [fault_of(detail, known, accepted) for detail in details]  # type: ignore[arg-type]


def _relations(
    raw: Mapping[str, Any], rest: Table, block: GroupBlock | None, scales: tuple[float, float, float]
) -> list[Relation]:
    """All that was said of the constants. Without a sound block the ratios of groups are 0: only who fixes whom."""
    relations, given, index = [], _section(rest, "material"), scales[-1]
    poisson = _value(Material, rest, "poisson", POISSON)
    for name in ("youngs_modulus", "viscosity", "yield_stress"):
        shear = [(rule.shear, rule.factor(index, poisson)) for rule in FROM_SHEAR if rule.constant == name]
        for key, times in ((name, 1.0), *shear):
            if key in given:
                value = times * _read(kind_of_constant(key, str(raw.get("law")), index), given[key], 0.0)
                relations.append(Relation(f"material.{key}", name, GROUND, value))
    for key, (constant, other, _) in RELATES.items():
        if raw.get(key) is not None:
            plain = Relation(f"groups.{key}", constant, other, 0.0)
            relations.append(plain if block is None else relation_of(key, getattr(block, key), *scales))
    if not {*_MODULUS_GROUPS} & set(raw) and not {"youngs_modulus", *shear_names("youngs_modulus")} & set(given):
        modulus = _read(kind_of_constant("youngs_modulus", None, 1.0), PAPER_MODULUS, 0.0)
        relations.append(Relation("groups", "youngs_modulus", GROUND, modulus))
    return relations


def _value(part: type[Part], table: Table, key: str, default: float = math.nan) -> float:
    """A value of the raw table in SI, or the default where it has none or a faulty one."""
    return _read(kinds_of(part)[key], _section(table, part.table_name).get(key, default), default)


def _read(kind: Kind, value: object, default: float) -> float:
    try:
        return float(kind.read(value))
    except (PydanticCustomError, ValidationError):
        return default


def _fill(rest: Table, path: str, value: object) -> None:
    table, _, key = path.partition(".")
    section = rest.setdefault(table, {})
    if isinstance(section, dict):
        section.setdefault(key, value)


def _section(table: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    section = table.get(name)
    return section if isinstance(section, Mapping) else {}
