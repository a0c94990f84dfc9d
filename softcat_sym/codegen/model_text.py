"""The physics of a filament as one C file: loops over the sites for fields, rates, Jacobian and powers."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import casadi as ca

from softcat_sym.codegen.c_printer import helpers_of
from softcat_sym.codegen.c_writer import Writer, at, times
from softcat_sym.codegen.derivatives import Chain, Entry, entry_name
from softcat_sym.codegen.recording import CELLS, POWERS, Item, Recording, Slot
from softcat_sym.codegen.stencil import Loop, loops_of, needed

Target = Callable[[str], str]


@dataclass(frozen=True)
class Model:
    """What the C text of a filament amounts to.

    Attributes
    ----------
    text : str
        The C file.
    slots : tuple of Slot
        Unknowns of a site.
    parameters, places : tuple of str
        Numbers that a run is given, as a whole and for each site.
    powers : tuple of str
        What is integrated beside the unknowns.
    entries : tuple of (str, str, int)
        Row, column and distance of each entry of the Jacobian.
    """

    text: str
    slots: tuple[Slot, ...]
    parameters: tuple[str, ...]
    places: tuple[str, ...]
    powers: tuple[str, ...]
    entries: tuple[tuple[str, str, int], ...]


_MARK, _SUM = "@", " SUM"  # stand in the text for what is known only later


def model_of(recording: Recording) -> Model:
    """C text of a filament that was taken apart.

    Parameters
    ----------
    recording : Recording
        From :func:`softcat_sym.codegen.recording.record`.

    Raises
    ------
    PrintingError
        If the sites in the middle of the filament do not all compute the same.
    """
    writer, leaves = Writer(recording), recording.leaves
    slots = [slot.name for slot in recording.slots]
    fields = needed(leaves, recording.staged, recording.rates)
    loops = loops_of(leaves, [*fields, *recording.rates])

    def rate(name: str) -> str:
        return writer.field(name) if writer.is_field(name) else f"f[{at(len(slots), 0, slots.index(name[2:]))}]"

    calls = _calls(writer, "rates", loops, rate)
    moves = writer.moves_in_time
    chain = Chain(leaves)
    entries, changes = _jacobian(writer, recording, chain, loops)
    powers, work, slopes = _work(writer, recording, chain, fields)
    text = "\n\n".join(
        [
            *writer.functions,
            _entry_point("rates", "f", calls, zero=f"n * {len(slots)}"),
            _entry_point("jacobian", "e", changes, zero=f"n * {len(entries)}"),
            _entry_point("work", "q", work, zero=str(len(powers))) if powers else "",
            _entry_point("work_slope", "s", slopes, zero=f"n * {len(powers) * len(slots)}") if powers else "",
            _tables(recording, entries, writer.scratch, len(powers), moves=moves),
        ]
    )
    text = f"{_HEAD}\n{helpers_of(text)}\n{text}\n"
    return Model(text, recording.slots, recording.parameters, recording.places, powers, entries)


def _calls(writer: Writer, label: str, loops: Sequence[Loop], target: Target) -> list[str]:
    return [
        writer.function(f"{label}_{k}", loop.where, loop.values, [target(name) for name in loop.names])
        for k, loop in enumerate(loops)
    ]


def _derivatives(
    writer: Writer, chain: Chain, loops: Sequence[Loop], label: str, entry: Callable[[str, Entry], str]
) -> list[str]:
    """Calls of functions that compute fields and their derivatives together.

    Derivatives of fields go to the scratch, those of all others where `entry` says.
    """
    known: dict[int, dict[str, dict[Entry, ca.SX]]] = {}
    for batch in _batches(loops):
        found = [chain.of(loop) for loop in batch]
        chain.learn(batch, found)
        known.update({id(loop): one for loop, one in zip(batch, found, strict=True)})
    calls = []
    for k, loop in enumerate(loops):
        targets: list[str] = []
        values: list[ca.SX] = []
        for name, value in zip(loop.names, loop.values, strict=True):
            made = known[id(loop)][name]
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
    writer: Writer, recording: Recording, chain: Chain, loops: Sequence[Loop]
) -> tuple[tuple[tuple[str, str, int], ...], list[str]]:
    """The entries, and the calls that compute them."""
    order = {slot.name: k for k, slot in enumerate(recording.slots)}
    marks: dict[tuple[str, str, int], int] = {}

    def mark(name: str, one: Entry) -> str:
        return f"e[{_MARK}{marks.setdefault((name[2:], *one), len(marks))}]"

    calls = _derivatives(writer, chain, loops, "jacobian", mark)
    outputs = [name for loop in loops for name in loop.names if not writer.is_field(name)]
    entries = sorted(
        {(name[2:], entry[0], entry[1]) for name in outputs for entry in chain.patterns[name]},
        key=lambda one: (order[one[0]], one[2], order[one[1]]),
    )
    number = {marks[one]: at(len(entries), 0, k) for k, one in enumerate(entries)}
    found = re.compile(re.escape(_MARK) + r"(\d+)")
    writer.functions = [found.sub(lambda match: number[int(match[1])], text) for text in writer.functions]
    return tuple(entries), calls


def _batches(loops: Sequence[Loop]) -> list[list[Loop]]:
    """Loops with those that compute the same fields at the ends."""
    found: list[list[Loop]] = []
    for loop in loops:
        for batch in found:
            if loop.where.alone and any(set(loop.names) & set(other.names) for other in batch):
                batch.append(loop)
                break
        else:
            found.append([loop])
    return found


def _work(
    writer: Writer, recording: Recording, chain: Chain, fields: Sequence[Item]
) -> tuple[tuple[str, ...], list[str], list[str]]:
    """Powers of the whole filament and their derivatives: what their places give, summed.

    The fields of the rates are in the scratch already, and their derivatives those of the Jacobian.
    """
    items = [item for power in recording.powers for item in power]
    if not items:
        return (), [], []
    known = {item.name for item in fields}
    others = [one for one in needed(recording.leaves, recording.staged, items) if one.name not in known]
    index = {item.name: k for k, power in enumerate(recording.powers) for item in power}
    loops, size = loops_of(recording.leaves, [*others, *items]), len(recording.slots)
    slots = {slot.name: k for k, slot in enumerate(recording.slots)}
    calls = []
    for k, loop in enumerate(loops):
        targets = [f"q[{index[name]}]{_SUM}" if name in index else writer.field(name) for name in loop.names]
        calls.append(writer.function(f"work_{k}", loop.where, loop.values, targets))

    def entry(name: str, one: Entry) -> str:
        return f"s[{times(index[name] * size, 'n')}{at(size, one[1], slots[one[0]])}]{_SUM}"

    changes = _derivatives(writer, chain, loops, "work_slope", entry)
    writer.functions = [text.replace(f"{_SUM} =", " +=") for text in writer.functions]
    return POWERS, calls, changes


_HEAD = """\
#include <math.h>

#include "softcat_model.h"
"""


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


def _tables(
    recording: Recording, entries: Sequence[tuple[str, str, int]], scratch: int, powers: int, *, moves: bool
) -> str:
    slots = [slot.name for slot in recording.slots]
    columns = {
        "rate": [slots.index(s.rate) if s.rate else -1 for s in recording.slots],
        "differential": [int(s.differential) for s in recording.slots],
        "held_first": [int(0 not in s.sites) for s in recording.slots],
        "held_last": [int(CELLS not in s.sites) for s in recording.slots],
        "row": [slots.index(row) for row, _, _ in entries],
        "offset": [distance for _, _, distance in entries],
        "column": [slots.index(column) for _, column, _ in entries],
    }
    lines = [f"static const int {name}[] = {{{', '.join(map(str, numbers))}}};" for name, numbers in columns.items()]
    sections = sum(s.section for s in recording.slots)
    given = len(recording.parameters), len(recording.places)
    sizes = (len(slots), sections, *given, scratch, len(entries), powers, int(moves))
    lines += [
        "",
        "const softcat_model softcat_filament_model = {",
        f"    {', '.join(map(str, sizes))},",
        "    rate, differential, held_first, held_last, row, offset, column,",
        f"    rates, jacobian, {'work, work_slope' if powers else '0, 0'},",
        "};",
    ]
    return "\n".join(lines)
