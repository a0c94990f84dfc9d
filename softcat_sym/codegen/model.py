"""The physics of a filament as one C file, named by its structure, and kept between processes."""

from __future__ import annotations

import hashlib
import json
import re
import secrets
import textwrap
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field, fields, is_dataclass, replace
from functools import lru_cache
from types import FunctionType

import casadi as ca

from softcat_sym import store
from softcat_sym.codegen import library
from softcat_sym.codegen.c_printer import Row, Target, Writer, helpers_of, number, times
from softcat_sym.codegen.loops import Chain, Entry, Loop, differentiated, entry_name, levels_of, needed
from softcat_sym.discretization.assembly import Theory
from softcat_sym.discretization.cell import Program, Slot
from softcat_sym.discretization.filament import build
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import End
from softcat_sym.discretization.point_rule import PointRule
from softcat_sym.discretization.section_rule import PER_FIBRE, SectionRule
from softcat_sym.discretization.stencil import Field
from softcat_sym.discretization.supports import Body
from softcat_sym.effects.choosing import Effects
from softcat_sym.errors import PrintingError
from softcat_sym.physics.filament import FilamentEquations
from softcat_sym.scene.scene import Scene


@dataclass(frozen=True)
class Model:
    """What the C text of a filament amounts to."""

    text: str  # The C file
    slots: tuple[Slot, ...]  # Unknowns of a site
    parameters: tuple[str, ...]  # Numbers that a run is given, as a whole and for each site
    places: tuple[str, ...]
    powers: tuple[str, ...]  # What is integrated beside the unknowns
    entries: tuple[tuple[str, str, int], ...]  # Row, column and distance of each entry of the Jacobian


@dataclass(frozen=True)
class Template:
    """The C text of a filament before it is known how many fibres it has; what each has is named with a ``#``."""

    functions: str  # The C text of its physics
    slots: tuple[Slot, ...]  # As in :class:`Model`
    parameters: tuple[str, ...]
    places: tuple[str, ...]
    powers: tuple[str, ...]
    entries: tuple[tuple[str, str, int], ...]
    scratch: tuple[int, int]  # Doubles per site that the functions need, and per site and fibre
    moves: bool  # Whether they depend on time

    def with_fibres(self, rule: SectionRule | PointRule | None = None) -> Model:
        """The model with so many fibres; with none where it has no fibres."""
        count = rule.points if rule else 0
        slots = [
            replace(slot, name=slot.name.replace(PER_FIBRE, str(k)))
            for slot in self.slots
            for k in range(count if PER_FIBRE in slot.name else 1)
        ]
        # As they are numbered at a site: what each fibre has comes last.
        entries = [
            (row.replace(PER_FIBRE, str(k)), column.replace(PER_FIBRE, str(k)), distance)
            for row, column, distance in sorted(self.entries, key=lambda entry: PER_FIBRE in _label(entry))
            for k in range(count if PER_FIBRE in row + column else 1)
        ]
        scratch = self.scratch[0] + count * self.scratch[1]
        tables = _tables(self, slots, entries, scratch)
        constants = [_constants(rule, len(slots), len(entries), self.scratch[0])] if rule else []
        text = "\n\n".join([_HEAD, *constants, self.functions, tables])
        return Model(text + "\n", tuple(slots), self.parameters, self.places, self.powers, tuple(entries))


def _label(entry: tuple[str, str, int]) -> str:
    """Name of an entry of the Jacobian."""
    return f"{entry[0]}/{entry_name(entry[1], ('', entry[2]))}"


_MARK = "@"  # stands in the text for what is known only later


def template_of(program: Program) -> Template:
    """C text of a filament."""
    if any(one.summed for one in program.fields):
        raise PrintingError("there is no C of a filament whose sites all read one sum: that of small deflections")
    writer, leaves = Writer(program), program.leaves
    fields = needed(leaves, program.fields, program.rates)
    levels = levels_of(leaves, [*fields, *program.rates])
    loops = [loop for level in levels for loop in level]

    def rate(name: str) -> Target:
        return (
            writer.field(name)
            if writer.is_field(name)
            else Target(f"f[{writer.slots.at(name[2:])}]", PER_FIBRE in name)
        )

    calls = [
        writer.function(f"rates_{k}", loop.where, loop.values, [rate(name) for name in loop.names])
        for k, loop in enumerate(loops)
    ]
    moves = writer.moves_in_time
    chain = Chain(leaves)
    entries, changes = _jacobian(writer, program, chain, levels)
    powers, work, slopes = _work(writer, program, chain, fields)
    size, found = writer.slots.count, Row("ENTRIES", [_label(entry) for entry in entries])
    text = "\n\n".join(
        [
            *writer.functions,
            _entry_point("rates", "f", calls, zero=f"n * {size}"),
            _entry_point("jacobian", "e", changes, zero=f"n * {found.count}"),
            _entry_point("work", "q", work, zero=str(len(powers))) if powers else "",
            _entry_point("work_slope", "s", slopes, zero=f"n * {len(powers)} * {size}") if powers else "",
        ]
    )
    text = f"{helpers_of(text)}\n{text}"
    given = program.parameters, program.places
    return Template(text, program.slots, *given, powers, entries, writer.scratch, moves)


def _derivatives(
    writer: Writer, chain: Chain, levels: Sequence[Sequence[Loop]], label: str, entry: Callable[[str, Entry], Target]
) -> list[str]:
    """Calls of functions that compute fields and their derivatives together.

    Derivatives of fields go to the scratch, those of all others where `entry` says.
    """
    calls = []
    every = (pair for level in levels for pair in differentiated(chain, level))
    for k, (loop, slopes) in enumerate(every):
        targets: list[Target] = []
        values: list[ca.SX] = []
        for name, value in zip(loop.names, loop.values, strict=True):
            made = slopes[name]
            if writer.is_field(name):
                stored = chain.stored(name)
                targets += [writer.field(name), *(writer.field(entry_name(name, one)) for one in stored)]
                values += [value, *(made.get(one, ca.SX(0)) for one in stored)]
            else:
                targets += [entry(name, one) for one in made]
                values += made.values()
        if values:
            calls.append(writer.function(f"{label}_{k}", loop.where, values, targets))
    return calls


def _jacobian(
    writer: Writer, program: Program, chain: Chain, levels: Sequence[Sequence[Loop]]
) -> tuple[tuple[tuple[str, str, int], ...], list[str]]:
    """The entries, and the calls that compute them."""
    order = {slot.name: k for k, slot in enumerate(program.slots)}
    marks: dict[tuple[str, str, int], int] = {}

    def mark(name: str, one: Entry) -> Target:
        label = (name[2:], *one)
        return Target(f"e[{_MARK}{marks.setdefault(label, len(marks))}]", PER_FIBRE in _label(label))

    calls = _derivatives(writer, chain, levels, "jacobian", mark)
    outputs = [name for level in levels for loop in level for name in loop.names if not writer.is_field(name)]
    entries = sorted(
        {(name[2:], entry[0], entry[1]) for name in outputs for entry in chain.patterns[name]},
        key=lambda one: (order[one[0]], one[2], order[one[1]]),
    )
    row = Row("ENTRIES", [_label(entry) for entry in entries])
    number = {marks[one]: row.at(_label(one)) for one in entries}
    found = re.compile(re.escape(_MARK) + r"(\d+)")
    writer.functions = [found.sub(lambda match: number[int(match[1])], text) for text in writer.functions]
    return tuple(entries), calls


def _work(
    writer: Writer, program: Program, chain: Chain, fields: Sequence[Field]
) -> tuple[tuple[str, ...], list[str], list[str]]:
    """Powers of the whole filament and their derivatives: what their places give, summed.

    The fields of the rates are in the scratch already, and their derivatives those of the Jacobian.
    """
    items = [item for power in program.powers.values() for item in power]
    if not items:
        return (), [], []
    known = {item.name for item in fields}
    others = [one for one in needed(program.leaves, program.fields, items) if one.name not in known]
    index = {item.name: k for k, power in enumerate(program.powers.values()) for item in power}
    levels, size = levels_of(program.leaves, [*others, *items]), writer.slots.count
    loops = [loop for level in levels for loop in level]
    calls = []
    for k, loop in enumerate(loops):
        targets = [
            Target(f"q[{index[name]}]", adds=True) if name in index else writer.field(name) for name in loop.names
        ]
        calls.append(writer.function(f"work_{k}", loop.where, loop.values, targets))

    def entry(name: str, one: Entry) -> Target:
        before = times(index[name], f"{size} * n")
        return Target(f"s[{before}{writer.slots.at(*one)}]", PER_FIBRE in one[0], adds=True)

    changes = _derivatives(writer, chain, levels, "work_slope", entry)
    return tuple(program.powers), calls, changes


_HEAD = """\
#include <math.h>

#include "softcat_model.h\""""


def _entry_point(name: str, result: str, calls: Sequence[str], zero: str) -> str:
    body = "\n".join(calls)
    unpacked = [
        text
        for letter, text in (
            ("p", "    const double *p = filament->parameters;"),
            ("g", "    const double *g = filament->places;"),
        )
        if re.search(rf"\b{letter}\b", body)
    ]
    unused = [f"    (void){letter};" for letter in ("t", "y", "w") if not re.search(rf"\b{letter}\b", body)]
    return "\n".join(
        [
            f"static int {name}(const softcat_filament *filament, double t, const double *y, double *{result},",
            f"{' ' * len(f'static int {name}(')}double *w)",
            "{",
            "    const int n = filament->sites;",
            *unpacked,
            *unused,
            f"    for (int k = 0; k < {zero}; k++) {result}[k] = 0.0;",
            *calls,
            "    return SOFTCAT_SOLVED;",
            "}",
        ]
    )


def _constants(rule: SectionRule | PointRule, slots: int, entries: int, scratch: int) -> str:
    """Numbers of what a site has, and where the fibres are."""
    sizes = {"FIBRES": rule.points, "SLOTS": slots, "ENTRIES": entries, "SCRATCH": scratch}
    return "\n".join(
        [
            *(f"#define {name} {size}" for name, size in sizes.items()),
            "",
            rule.heading,
            *(c_array("double", name, [number(float(one)) for one in values]) for name, values in rule.tables.items()),
        ]
    )


def c_array(kind: str, name: str, values: Sequence[str]) -> str:
    """A table of constants."""
    body = textwrap.fill(", ".join(values), 96, initial_indent="    ", subsequent_indent="    ", break_long_words=False)
    return f"static const {kind} {name}[] = {{\n{body}}};"


def _tables(template: Template, slots: Sequence[Slot], entries: Sequence[tuple[str, str, int]], scratch: int) -> str:
    place = {slot.name: k for k, slot in enumerate(slots)}
    columns = {
        "rate": [place[s.rate] if s.rate else -1 for s in slots],
        "differential": [int(s.differential) for s in slots],
        "held_first": [int(s.where.first > 0) for s in slots],
        "held_last": [int(s.where.behind > 0) for s in slots],
        "row": [place[row] for row, _, _ in entries],
        "offset": [distance for _, _, distance in entries],
        "column": [place[column] for _, column, _ in entries],
    }
    lines = [c_array("int", name, [str(one) for one in numbers]) for name, numbers in columns.items()]
    sections, powers = sum(s.section for s in slots), len(template.powers)
    given = len(template.parameters), len(template.places)
    sizes = (len(slots), sections, *given, scratch, len(entries), powers, int(template.moves))
    lines += [
        "",
        "const softcat_model softcat_filament_model = {",
        f"    {', '.join(map(str, sizes))},",
        "    rate, differential, held_first, held_last, row, offset, column,",
        f"    rates, jacobian, {'work, work_slope' if powers else '0, 0'},",
        "};",
    ]
    return "\n".join(lines)


def template_kept(key: str, made: Callable[[], Template]) -> Template:
    """The template of a structure, from the cache or else made and stored there; another program has others."""
    full = store.key_of("template", key)
    text = library.recall(full)
    if text is None:
        template = made()
        library.keep(full, json.dumps(asdict(template)))
        return template
    parts = json.loads(text)
    parts |= {name: tuple(parts[name]) for name in ("parameters", "places", "powers", "scratch")}
    parts["slots"] = tuple(Slot(**{**slot, "held": tuple(slot["held"])}) for slot in parts["slots"])
    parts["entries"] = tuple((row, column, distance) for row, column, distance in parts["entries"])
    return Template(**parts)


_PROCESS = secrets.token_hex()


@dataclass(frozen=True)
class Structure:
    """All filaments that share a C text."""

    key: str  # Hash of all that the text depends on but the program and the fibres
    rule: str  # Where the fibres are; empty without. Two structures are equal if these two are
    effects: tuple[str, ...]  # Names of the effects in force
    equations: FilamentEquations = field(compare=False)  # What the filament is recorded from
    theory: Theory = field(compare=False)
    ends: tuple[End, End] = field(compare=False)
    body: Body = field(compare=False)

    @property
    def area_power(self) -> int:
        """With which the area of the section goes with its thickness."""
        return self.equations.shape.area_power


def structure_of(
    scene: Scene, effects: Effects, graph: Graph, equations: FilamentEquations, theory: Theory, body: Body
) -> Structure:
    """The structure of a scene's filament."""
    ends, fibres = (graph.grid.first, graph.grid.last), theory.fibres
    parts: tuple[object, ...] = (
        equations.terms,
        equations.shape.name,
        scene.run.closure,
        theory.label,
        tuple(end.name for end in ends),
        body.supports,
        body.profile.nodes is not None,
        body.weighted,
        body.tip_mass,
        body.tip_force,
        body.natural is not None,
    )
    if body.tip_torque:
        parts = (*parts, "torque")
    if equations.terms.shaking != 1:
        parts = (*parts, equations.terms.shaking)
    if equations.terms.hardens:
        parts = (*parts, "hardens")
    rule = fibres.label if fibres else ""
    return Structure(_digest(parts), rule, effects.names, equations, theory, ends, body)


def _digest(parts: tuple[object, ...]) -> str:
    """Hash of what parts say of themselves; where that is an address, it means nothing to another process."""
    text = "\n".join(repr(_named(part)) for part in parts)
    return hashlib.sha256(f"{_PROCESS} {text}".encode() if " at 0x" in text else text.encode()).hexdigest()


def _named(part: object) -> object:
    """A part in which functions are called by module and name, where these say which: a closure's do not."""
    if isinstance(part, FunctionType) and "<" not in part.__qualname__:
        return f"{part.__module__}.{part.__qualname__}"
    if isinstance(part, tuple):
        return tuple(_named(one) for one in part)
    if is_dataclass(part) and not isinstance(part, type):
        return type(part).__name__, *((one.name, _named(getattr(part, one.name))) for one in fields(part))
    return part


@lru_cache(maxsize=128)
def model_for(structure: Structure) -> Model:
    """The C text of a structure."""
    fibres = structure.theory.fibres
    return _template(replace(structure, rule="")).with_fibres(fibres)


@lru_cache(maxsize=128)
def _template(structure: Structure) -> Template:
    """Read once a process, and made once a machine."""

    def made() -> Template:
        theory = structure.theory
        rule = theory.fibres.one if theory.fibres else theory.rule
        return template_of(build(structure.equations, theory.model, structure.ends, structure.body, rule))

    return template_kept(structure.key, made)
