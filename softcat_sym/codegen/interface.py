"""``filament.c`` and ``filament.h``: the physics of a filament, what it is called by, and how to call it."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

from softcat_sym.codegen.c_printer import number
from softcat_sym.codegen.description import Description, Given
from softcat_sym.codegen.versions import VERSIONS
from softcat_sym.errors import PrintingError

DEFAULT_NAME = "filament"

_RANGES = {
    "any": "SOFTCAT_ANY",
    "not-negative": "SOFTCAT_NOT_NEGATIVE",
    "positive": "SOFTCAT_POSITIVE",
    "poisson": "SOFTCAT_POISSON",
}

_PLACES = frozenset({"X", "cell", "node", "mass", "per_cell", "per_node", "per_mass", "h_node", "h_cell", "hung"})


def prefix_of(name: str) -> str:
    """What the names of the functions begin with: no other than the default may begin as those of the runtime do."""
    return "softcat" if name == DEFAULT_NAME else name


def symbol_of(name: str, what: str) -> str:
    """Name of the model or the structure that the file exports."""
    return f"softcat_{name}_{what}" if name == DEFAULT_NAME else f"{name}_{what}"


def symbol(text: str) -> str:
    """A name as part of a C constant."""
    return re.sub(r"\W", "_", text, flags=re.ASCII).upper()


def source_text(described: Description, name: str, command: str) -> str:
    """The C file: the model, then its description and the functions of the header.

    Parameters
    ----------
    described : Description
        What it is of.
    name : str
        Of the file, and within the names of all that it exports.
    command : str
        That writes the file again.
    """
    model = described.model.text.replace("softcat_filament_model", symbol_of(name, "model"))
    # Its head includes what the model needs; the header of this file brings more.
    return "\n".join(
        [
            heading(described, command),
            f'#include "{name}.h"',
            "",
            model,
            _tables(described),
            "",
            _structure(described, name),
            "",
            _functions(prefix_of(name), symbol_of(name, "structure")),
        ]
    )


def heading(described: Description, command: str) -> str:
    """The comment that stands above all generated text."""
    lines = [
        described.title,
        "",
        f"Generated, do not edit; written by: {command}",
        ", ".join(f"{package} {version}" for package, version in VERSIONS.items()),
        f"Effects: {', '.join(described.effects.names)}",
        f"Digest of the structure: {described.digest}",
    ]
    return comment(lines)


def comment(lines: Sequence[str]) -> str:
    """Lines as a C comment that nothing in them can end."""
    safe = [re.sub(r"\?(?=\?)", "? ", line.replace("*/", "* /").replace("/*", "/ *")) for line in lines]
    wrapped = [
        part
        for line in safe
        for part in textwrap.wrap(line, 96, subsequent_indent="    ", break_on_hyphens=False) or [""]
    ]
    return "\n".join(["/*", *(f" * {line}".rstrip() for line in wrapped), " */"])


def quoted(text: str) -> str:
    """A C string."""
    shown = "".join(_escaped(sign) for sign in text)
    return f'"{shown}"'


def _escaped(sign: str) -> str:
    if sign in '"\\?':
        return f"\\{sign}"
    # Octal: unlike hexadecimal, it ends after three digits.
    return sign if sign.isascii() and sign.isprintable() else "".join(f"\\{byte:03o}" for byte in sign.encode())


def _array(kind: str, name: str, values: Sequence[str]) -> str:
    body = textwrap.fill(", ".join(values), 96, initial_indent="    ", subsequent_indent="    ", break_long_words=False)
    return f"static const {kind}{name}[] = {{\n{body}}};"


def _tables(described: Description) -> str:
    given = described.parameters
    slots = described.model.slots
    texts = "char *const "
    arrays = [
        _array(texts, "described_parameters", [quoted(one.name) for one in given]),
        _array(texts, "described_units", [quoted(one.unit) for one in given]),
        _array("softcat_range ", "described_ranges", [_RANGES[one.bound] for one in given]),
        _array("double ", "described_values", [number(one.value) for one in given]),
        _array(texts, "described_slots", [quoted(slot.name) for slot in slots]),
        _array("softcat_place ", "described_places", [_place_kind(place) for place in described.model.places]),
        _array("int ", "described_on_cells", [str(int(one)) for one in described.on_cells]),
        _array("double ", "described_mean", [number(one) for one, _ in described.profiles]),
        _array("double ", "described_bending", [number(one) for _, one in described.profiles]),
    ]
    arrays += [_array("double ", name, list(map(number, values))) for name, values in _lists(described) if values]
    return "\n".join(arrays)


def _place_kind(name: str) -> str:
    """The C constant of a number that sites are given.

    Raises
    ------
    PrintingError
        If softcat_places.c does not know it.
    """
    if name not in _PLACES:
        raise PrintingError(f"the generated code asks sites for {name}, which softcat_places.c does not know")
    return f"SOFTCAT_PLACE_{symbol(name)}"


def _lists(described: Description) -> list[tuple[str, tuple[float, ...]]]:
    """What a scene states along the filament."""
    initial = described.scene.initial
    return [
        ("described_initial_mean", initial.P),
        ("described_initial_bending", initial.C),
        ("described_thickness", described.scene.filament.profile),
    ]


def _structure(described: Description, name: str) -> str:
    scene, structure = described.scene, described.structure
    parameters = [one.name for one in described.parameters]
    slots = [slot.name for slot in described.model.slots]
    fields = {
        "model": f"&{symbol_of(name, 'model')}",
        "title": quoted(described.title),
        "parameter_names": "described_parameters",
        "parameter_units": "described_units",
        "parameter_ranges": "described_ranges",
        "parameter_values": "described_values",
        "slot_names": "described_slots",
        "on_cells": "described_on_cells",
        "mean": "described_mean",
        "bending": "described_bending",
        "first": f"SOFTCAT_{structure.ends[0].name}",
        "last": f"SOFTCAT_{structure.ends[1].name}",
        "least_cells": str(described.least_cells),
        "area_power": str(structure.area_power),
        "profiled": str(int(structure.body.profile.nodes is not None)),
        "places": "described_places",
    }
    fields |= {slot: str(_place(slots, slot)) for slot in ("x", "y", "psi")}
    fields |= {one: str(_place(parameters, one)) for one in _KNOWN}
    fields |= {
        "motion": str(_place(parameters, "motion_0_time")),
        "motion_rows": str(structure.body.supports.rows),
        "stretch": number(scene.initial.stretch if scene.initial.relaxed else 1.0),
    }
    for text, values in _lists(described):
        field = text.removeprefix("described_")
        fields |= {field: text if values else "0", f"{field}_count": str(len(values))}
    fields |= {key: number(getattr(described, key)) for key in ("grading", "relative", "absolute")}
    fields |= {"towards_middle": str(int(described.towards_middle))}
    fields |= {"duration": number(scene.run.duration), "cells": str(described.cells), "frames": str(scene.run.frames)}
    lines = [f"    .{key} = {value}," for key, value in fields.items()]
    return "\n".join([f"const softcat_structure {symbol_of(name, 'structure')} = {{", *lines, "};"])


_KNOWN = (
    "rest_length",
    "time_scale",
    "gravity",
    "density",
    "span",
    "drop",
    "left_angle",
    "right_angle",
    "curvature",
)


def _place(names: Sequence[str], name: str) -> int:
    return names.index(name) if name in names else -1


def _functions(prefix: str, structure: str) -> str:
    return f"""\
int {prefix}_row(int cells)
{{
    return softcat_structure_row(&{structure}, cells);
}}

void {prefix}_defaults(double *params)
{{
    const int count = {structure}.model->parameters;
    for (int k = 0; k < count; k++) params[k] = described_values[k];
}}

int {prefix}_solve_with(const double *params, int cells, const double *times, int n,
    const softcat_settings *settings, const softcat_results *results, softcat_status *status)
{{
    return softcat_structure_solve(&{structure}, params, cells, times, n, settings,
        results, status);
}}

int {prefix}_solve(const double *params, int cells, const double *times, int n, double *out,
    softcat_status *status)
{{
    const softcat_results results = {{.positions = out}};
    return {prefix}_solve_with(params, cells, times, n, 0, &results, status);
}}

int {prefix}_midpoint(const double *params, int cells, const double *times, int n, double *out,
    softcat_status *status)
{{
    const softcat_results results = {{.midpoint = out}};
    return {prefix}_solve_with(params, cells, times, n, 0, &results, status);
}}

int {prefix}_solve_sensitivities(const double *params, int cells, const double *times, int n,
    const int *by, int by_count, double *out, double *derivatives, softcat_status *status)
{{
    const softcat_settings settings = {{.by = by, .by_count = by_count}};
    const softcat_results results = {{.positions = out, .derivatives = derivatives}};
    return {prefix}_solve_with(params, cells, times, n, &settings, &results, status);
}}
"""


def shown(one: Given) -> str:
    """Unit, value and meaning of a parameter in a few words."""
    return f"[{one.unit}] {one.value:.6g}{f': {one.meaning}' if one.meaning else ''}"
