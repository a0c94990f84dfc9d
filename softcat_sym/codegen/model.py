"""The physics of a filament written as C, whatever its number of cells and fibres."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeVar

import casadi as ca

from softcat_sym.codegen.c_printer import SIZES, TABLES, Row, Target, Writer, helpers_of, times
from softcat_sym.codegen.loops import Chain, Entry, Loop, differentiated, entry_name, levels_of, needed
from softcat_sym.discretization.cell import Program
from softcat_sym.discretization.stencil import Field
from softcat_sym.discretization.unknowns import PER_FIBRE, Shown

Template = TypeVar("Template")

_MARK = "@"  # stands in the text for what is known only later


def template_of(program: Program, made_of: Callable[..., Template]) -> Template:
    """C text of a filament, made of its parts."""
    writer, leaves = Writer(program), program.leaves
    fields = needed(leaves, program.fields, program.rates)
    levels = levels_of(leaves, [*fields, *program.rates])
    loops = [loop for level in levels for loop in level]

    def rate(name: str) -> Target:
        return (
            writer.field(name)
            if writer.is_field(name)
            else Target(f"f[{writer.slots.at(name[2:])}]", PER_FIBRE in name, zeroed=True)
        )

    calls = [
        writer.function(f"rates_{k}", loop.where, loop.values, [rate(name) for name in loop.names])
        for k, loop in enumerate(loops)
    ]
    moves = writer.moves_in_time
    chain = Chain(leaves)
    entries, changes = _jacobian(writer, program, chain, levels)
    in_time, forced = Chain(leaves, by_time=True, by_unknowns=False), list[str]()
    if moves:
        forced = _derivatives(writer, in_time, levels, "rates_in_time", lambda name, _: rate(name), alone=True)
    powers, work, slopes, changing = _work(writer, program, chain, fields, in_time if moves else None)
    size, found = writer.slots.count, Row("entries", [entry_label(entry) for entry in entries])
    text = "\n\n".join(
        [
            *writer.functions,
            _entry_point("rates", "f", calls, zero=f"n * {size}"),
            _entry_point("jacobian", "e", changes, zero=f"n * {found.count}"),
            _entry_point("work", "q", work, zero=str(len(powers))) if powers else "",
            _entry_point("work_slope", "s", slopes, zero=f"n * {len(powers)} * {size}") if powers else "",
            _entry_point("rates_in_time", "f", forced, zero=f"n * {size}") if moves else "",
            _entry_point("work_in_time", "q", changing, zero=str(len(powers))) if moves and powers else "",
        ]
    )
    text = f"{helpers_of(text)}\n{text}"
    shown, observables, scratch = _observables(program)
    signature = replace(program.signature, shown=shown)
    return made_of(text, observables, signature, powers, entries, writer.scratch, scratch, moves)


_OBSERVE = """\
int softcat_filament_observe(const softcat_filament *filament, int count, const double *times,
                             const double *states, double *o, double *w)
{{
    const int n = filament->sites;
    const double *p = filament->parameters, *g = filament->places;
{given}    for (int frame = 0; frame < count; frame++) {{
        const double t = times[frame], *y = states + (size_t)frame * (size_t)(n * {slots});
        (void)p, (void)g, (void)t, (void)y, (void)w;
{calls}
        o += (size_t)n * (size_t)({rows});
    }}
    return SOFTCAT_SOLVED;
}}"""
"""Rows of n sites for each field at each time, zero before: what is a sum is left to whoever adds up its row."""


def _observables(program: Program) -> tuple[tuple[Shown, ...], str, tuple[int, int]]:
    """What a run stores, as rows of sites: those that each fibre has last; the C text, and the scratch it needs."""
    writer, leaves = Writer(program), program.leaves
    shown = sorted(program.signature.shown, key=lambda one: PER_FIBRE in one.name)
    plain = sum(PER_FIBRE not in one.name for one in shown)
    items: list[Field] = []
    targets: dict[str, Target] = {}
    for row, one in enumerate(shown):
        of, each = program.shown[one.name], PER_FIBRE in one.name
        place = f"({plain} + {row - plain} * fibres + k) * n + i" if each else f"{times(row, 'n')}i"
        for k, part in enumerate(of if isinstance(of, tuple) else (of,)):
            name = f"shown_{row}_{k}{PER_FIBRE if each else ''}"
            items.append(replace(part, name=name))
            targets[name] = Target(f"o[{place}]", each, adds=one.summed, zeroed=True)
    fields = needed(leaves, program.fields, items)
    loops = [loop for level in levels_of(leaves, [*fields, *items]) for loop in level]
    calls = [
        writer.function(
            f"show_{k}",
            loop.where,
            loop.values,
            [targets[name] if name in targets else writer.field(name) for name in loop.names],
        )
        for k, loop in enumerate(loops)
    ]
    rows = f"{plain} + {len(shown) - plain} * fibres" if plain < len(shown) else str(plain)
    given = "".join(f"{line}\n" for line in _given("\n".join([rows, writer.slots.count, *calls])))
    calls = [f"    {call}" for call in calls]
    body = _OBSERVE.format(slots=writer.slots.count, given=given, calls="\n".join(calls), rows=rows)
    text = "\n\n".join([*writer.functions, body])
    return tuple(shown), f"{helpers_of(text)}\n{text}", writer.scratch


def entry_label(entry: tuple[str, str, int]) -> str:
    """Name of an entry of the Jacobian."""
    return f"{entry[0]}/{entry_name(entry[1], ('', entry[2]))}"


def _derivatives(
    writer: Writer,
    chain: Chain,
    levels: Sequence[Sequence[Loop]],
    label: str,
    entry: Callable[[str, Entry], Target],
    *,
    alone: bool = False,
) -> list[str]:
    """Calls of functions that compute derivatives of fields, and the fields with them unless these are there already.

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
                targets += [] if alone else [writer.field(name)]
                values += [] if alone else [value]
                targets += [writer.field(entry_name(name, one)) for one in stored]
                values += [made.get(one, ca.SX(0)) for one in stored]
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
    mark = f"entries{_MARK}" if writer.slots.each else _MARK  # by its name a function asks for it

    def target(name: str, one: Entry) -> Target:
        label = (name[2:], *one)
        return Target(f"e[{mark}{marks.setdefault(label, len(marks))}]", PER_FIBRE in entry_label(label), zeroed=True)

    calls = _derivatives(writer, chain, levels, "jacobian", target)
    outputs = [name for level in levels for loop in level for name in loop.names if not writer.is_field(name)]
    entries = sorted(
        {(name[2:], entry[0], entry[1]) for name in outputs for entry in chain.patterns[name]},
        key=lambda one: (order[one[0]], one[2], order[one[1]]),
    )
    row = Row("entries", [entry_label(entry) for entry in entries])
    number = {marks[one]: row.at(entry_label(one)) for one in entries}
    found = re.compile(re.escape(mark) + r"(\d+)")
    writer.functions = [found.sub(lambda match: number[int(match[1])], text) for text in writer.functions]
    return tuple(entries), calls


def _work(
    writer: Writer, program: Program, chain: Chain, fields: Sequence[Field], in_time: Chain | None
) -> tuple[tuple[str, ...], list[str], list[str], list[str]]:
    """Powers of the whole filament and their derivatives, by unknowns and in time: what their places give, summed.

    The fields of the rates are in the scratch already, and their derivatives those of the Jacobian.
    """
    items = [item for power in program.powers.values() for item in power]
    if not items:
        return (), [], [], []
    known = {item.name for item in fields}
    others = [one for one in needed(program.leaves, program.fields, items) if one.name not in known]
    index = {item.name: k for k, power in enumerate(program.powers.values()) for item in power}
    levels, size = levels_of(program.leaves, [*others, *items]), writer.slots.count
    loops = [loop for level in levels for loop in level]

    def power(name: str) -> Target:
        return Target(f"q[{index[name]}]", adds=True)

    calls = []
    for k, loop in enumerate(loops):
        targets = [power(name) if name in index else writer.field(name) for name in loop.names]
        calls.append(writer.function(f"work_{k}", loop.where, loop.values, targets))

    def entry(name: str, one: Entry) -> Target:
        before = times(index[name], f"{size} * n")
        return Target(f"s[{before}{writer.slots.at(*one)}]", PER_FIBRE in one[0], adds=True)

    changes = _derivatives(writer, chain, levels, "work_slope", entry)
    if in_time is None:
        return tuple(program.powers), calls, changes, []
    forced = _derivatives(writer, in_time, levels, "work_in_time", lambda name, _: power(name), alone=True)
    return tuple(program.powers), calls, changes, forced


def _given(text: str) -> list[str]:
    """What the text has of the numbers of fibres, and of where they are."""
    sizes = [f"    const int {name} = {size};" for name, size in SIZES.items() if re.search(rf"\b{name}\b", text)]
    return sizes + [f"    const double *{name} = fibre_{name};" for name in TABLES if re.search(rf"\b{name}\b", text)]


def _entry_point(name: str, result: str, calls: Sequence[str], zero: str) -> str:
    body = "\n".join(calls)
    unpacked = _given(f"{zero}\n{body}") + [
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
