"""``filament.h``: what a user of the compiled filament reads first."""

from __future__ import annotations

from softcat_sym.codegen.c_printer import number
from softcat_sym.codegen.description import Description
from softcat_sym.codegen.interface import heading, prefix_of, shown, symbol, symbol_of
from softcat_sym.graph import End


def header_text(described: Description, name: str, command: str) -> str:
    """The C header.

    Parameters
    ----------
    described, name, command
        As :func:`softcat_sym.codegen.interface.source_text` takes them.
    """
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
            least=described.least_cells,
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
