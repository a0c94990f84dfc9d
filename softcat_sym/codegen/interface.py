"""``filament.c`` and ``filament.h``: the physics of a filament, what it is called by, and how to call it."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass

from softcat_sym.codegen.c_printer import VERSIONS, CSource, number
from softcat_sym.codegen.model import Model, Structure
from softcat_sym.discretization.graph import CATALOGUE, Graph, parameter_values
from softcat_sym.discretization.grid import End, choose_grading, towards_middle
from softcat_sym.effects.choosing import Effects
from softcat_sym.errors import PrintingError
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import si_unit

MIN_CELLS = 4
"""Per half span: with fewer, the two ends see each other."""

_UNITS = {
    "span": "m",
    "drop": "m",
    "left_angle": "rad",
    "right_angle": "rad",
    "point_mass_per_area": "kg/m^2",
    "time_scale": "s",
    "second_modulus": "Pa",
    "index": "1",
}
_ENDINGS = {"_time": "s", "_dx": "m", "_dy": "m", "_youngs_modulus": "Pa", "_viscosity": "Pa*s"}

_MEANINGS = {
    "rest_length": "length of the undeformed filament",
    "thickness": "of the section; the diameter of a circle",
    "gravity": "acceleration",
    "ramp": "time within which gravity comes on, 0 at once",
    "shake": "amplitude with which gravity oscillates, over g",
    "shake_frequency": "cycles in a second",
    "viscosity": "extensional",
    "yield_stress": "in tension",
    "index": "exponent n of the flow",
    "poisson": "used by shear only",
    "curvature": "natural",
    "aspect": "width over thickness",
    "surface_tension": "of the filament's surface",
    "span": "horizontal distance between the supports",
    "drop": "of the right support below the left one",
    "left_angle": "of the clamp, counterclockwise",
    "right_angle": "of the clamp, counterclockwise",
    "point_mass_per_area": "mass at midspan over the undeformed section",
    "time_scale": "unit of time in which the computation works; 0: sqrt(rest_length / gravity)",
}


@dataclass(frozen=True, slots=True)
class Given:
    """A parameter of a filament."""

    name: str  # SI
    unit: str
    meaning: str
    bound: str  # ``any``, ``not-negative``, ``positive`` or ``poisson``
    value: float  # That of the scene


@dataclass(frozen=True)
class Description:
    """A scene's filament as C sees it."""

    scene: Scene  # What was asked
    effects: Effects  # The physics in force
    structure: Structure  # What its text depends on
    model: Model  # Its physics as C text
    parameters: tuple[Given, ...]  # In the order of the model
    on_cells: tuple[bool, ...]  # Whether each slot belongs to the cell of its site
    # What each slot is of a plastic strain that is linear through the thickness.
    profiles: tuple[tuple[float, float], ...]
    cells: int  # Per half span
    grading: float  # Ratio of the longest cell to the shortest, and tolerances
    relative: float
    absolute: float
    towards_middle: bool  # Whether cells are short at midspan, too

    @property
    def title(self) -> str:
        """Of the scene."""
        return self.scene.title or "a filament"

    @property
    def digest(self) -> str:
        """Of the text of the physics: two filaments share a structure if theirs are the same."""
        return CSource({"model.c": self.model.text}).digest

    @property
    def min_cells(self) -> int:
        """Per half span."""
        return MIN_CELLS


def describe(
    scene: Scene, effects: Effects, graph: Graph, structure: Structure, model: Model, tolerances: tuple[float, float]
) -> Description:
    """Gather what is known of a scene's filament."""
    values = parameter_values(scene)
    units = {name: _unit(scene, name, model.parameters) for name in model.parameters}
    given = tuple(
        Given(name, units[name], _meaning(name, units[name]), _bound(scene, name), float(values[name]))
        for name in model.parameters
    )
    cells = graph.grid.cells if graph.grid.is_half else graph.grid.cells // 2
    names = [slot.name for slot in model.slots]
    grading = scene.numerics.grading or choose_grading(scene, cells, effects)
    return Description(
        scene=scene,
        effects=effects,
        structure=structure,
        model=model,
        parameters=given,
        on_cells=tuple(_is_on_cells(graph, name) for name in names),
        profiles=tuple(graph.profiles.get(name, (0.0, 0.0)) for name in names),
        cells=cells,
        grading=float(grading),
        relative=float(tolerances[0]),
        absolute=float(tolerances[1]),
        towards_middle=towards_middle(scene, effects),
    )


def _is_on_cells(graph: Graph, kind: str) -> bool:
    """Whether the unknowns of a kind stand in the middle of cells."""
    for kinds, places, where in (
        (graph.x_kinds, graph.x_places, graph.x_where),
        (graph.z_kinds, graph.z_places, graph.z_where),
    ):
        if kind in kinds:
            first = kinds.index(kind)
            return bool(where[first] != graph.grid.nodes[places[first]])
    return False


def _unit(scene: Scene, name: str, names: tuple[str, ...]) -> str:
    if name == "viscosity" and "index" in names:
        return "Pa*s^n"
    known = {one.name: one.unit for one in CATALOGUE} | _UNITS
    if name in known:
        return known[name]
    for own in scene.material.parameters:
        if own.name == name:
            return str(si_unit(own.dimension)).replace(" ", "") or "1"
    return next((unit for ending, unit in _ENDINGS.items() if name.endswith(ending)), "1")


def _meaning(name: str, unit: str) -> str:
    return "consistency K of the flow" if unit == "Pa*s^n" else _MEANINGS.get(name, "")


def _bound(scene: Scene, name: str) -> str:
    if name == "poisson":
        return "poisson"
    own = {parameter.name for parameter in scene.material.parameters}
    free = ("curvature", "drop", "left_angle", "right_angle")
    if name in own or name in free or (name.startswith("motion_") and not name.endswith("_time")):
        return "any"
    zero = ("gravity", "ramp", "shake", "shake_frequency", "point_mass_per_area", "time_scale", "surface_tension")
    return "not-negative" if name in zero or name.startswith("motion_") else "positive"


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
    """The C file: the model, then its description and the functions of the header."""
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
    """The C constant of a number that sites are given."""
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
        "least_cells": str(described.min_cells),
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


def header_text(described: Description, name: str, command: str) -> str:
    """The C header."""
    prefix = prefix_of(name)
    big, guard = prefix.upper(), f"SOFTCAT_{symbol(name)}_H"
    parts = [
        heading(described, command),
        f"#ifndef {guard}\n#define {guard}",
        '#include "softcat_solve.h"',
        '#ifdef __cplusplus\nextern "C" {\n#endif',
        "/* Numbers of the parameters; all are in SI units. Values are those of the scene. */\n"
        + _enumeration([f"{big}_P_{symbol(one.name)}" for one in described.parameters], f"{big}_PARAMETERS").format(
            *(shown(one) for one in described.parameters)
        ),
        "/* Numbers of the unknowns of a site: a node, or the cell to its right. */\n"
        + _enumeration([f"{big}_SLOT_{symbol(slot.name)}" for slot in described.model.slots], f"{big}_SLOTS").format(
            *(_words(described, k) for k in range(len(described.model.slots)))
        ),
        _constants(described, big),
        _FUNCTIONS.format(
            prefix=prefix,
            big=big,
            structure=symbol_of(name, "structure"),
            grid=_grid(described),
            least=described.min_cells,
        ),
        "#ifdef __cplusplus\n}\n#endif",
        "#endif",
    ]
    return "\n\n".join(parts) + "\n"


def _enumeration(names: list[str], count: str) -> str:
    """An enum with a place for a comment on each name."""
    width = max(map(len, names)) + 1
    lines = [f"    {f'{name},':{width}} /* {{}} */" for name in names]
    return "\n".join(["enum {{", *lines, f"    {count}", "}};"])


def _words(described: Description, slot: int) -> str:
    known = described.model.slots[slot]
    where = "cell" if described.on_cells[slot] else "node"
    return f"{where}, {'differential' if known.differential else 'algebraic'}"


def _constants(described: Description, big: str) -> str:
    scene = described.scene
    values = {
        "CELLS": str(described.cells),
        "GRADING": number(described.grading),
        "RELATIVE": number(described.relative),
        "ABSOLUTE": number(described.absolute),
        "DURATION": number(scene.run.duration),
        "FRAMES": str(scene.run.frames),
    }
    said = "/* How the scene is run: cells a half span, longest over shortest cell, tolerances, [s], times. */"
    return "\n".join([said, *(f"#define {big}_SCENE_{key} {value}" for key, value in values.items())])


def _grid(described: Description) -> str:
    ends = described.structure.ends
    if ends[0] is End.SYMMETRY:
        return "half the filament, from its plane of symmetry (x = 0) to the right support: cells + 1 nodes"
    return "the whole filament from left to right: 2 * cells + 1 nodes, the middle one number `cells`"


_FUNCTIONS = """\
extern const softcat_structure {structure};

/* Doubles that one time takes in `out`, 2 for each node; 0 if cells < {least}. Solved is
 * {grid}. */
int {prefix}_row(int cells);

/* Fill params [{big}_PARAMETERS] with the scene's. */
void {prefix}_defaults(double *params);

/* Positions [m] of all nodes at n times, with the scene's grading and tolerances.
 *
 * params  [{big}_PARAMETERS] SI
 * cells   per half span, {least} or more
 * times   [n] increasing, from 0 on [s]; the filament is at rest at t = 0
 * out     [n * {prefix}_row(cells)] x_0 y_0 x_1 y_1 ... of each time; NaN at times not reached
 * status  or NULL
 * Returns SOFTCAT_SOLVED or a code; softcat_explain says what it means. */
int {prefix}_solve(const double *params, int cells, const double *times, int n, double *out,
                   softcat_status *status);

/* The same for the height [m] of the node at X = 0 only: out [n]. */
int {prefix}_midpoint(const double *params, int cells, const double *times, int n, double *out,
                      softcat_status *status);

/* Positions, and their derivatives by parameters number by[0] ... by[by_count - 1] in the same
 * pass: derivatives [by_count * n * {prefix}_row(cells)] in m per SI unit. */
int {prefix}_solve_sensitivities(const double *params, int cells, const double *times, int n,
                                 const int *by, int by_count, double *out, double *derivatives,
                                 softcat_status *status);

/* All that softcat_solve.h offers: grading, tolerances, a starting shape, stopping, the thickness
 * along the filament, all unknowns, work. */
int {prefix}_solve_with(const double *params, int cells, const double *times, int n,
                        const softcat_settings *settings, const softcat_results *results,
                        softcat_status *status);"""
