"""All files of the compiled solver, as a user takes them away."""

from __future__ import annotations

import re
import textwrap
from importlib import resources

from softcat_sym.codegen.interface import (
    DEFAULT_NAME,
    MIN_CELLS,
    Description,
    header_text,
    prefix_of,
    rendered,
    source_text,
    symbol_of,
)
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import SoftcatError

START = "start.csv"
_NAME = re.compile(r"[a-z][a-z0-9_]{0,39}")
_TAKEN = frozenset({"main", "all", "run", "clean"})


def check_name(name: str) -> str:
    """The name, if files and functions may have it."""
    if not _NAME.fullmatch(name) or name in _TAKEN or name.startswith("softcat"):
        raise SoftcatError(
            f"name {name!r}: take up to 40 small letters, digits and underscores, a letter first, and not "
            f"{', '.join(sorted(_TAKEN))} nor anything that begins with softcat"
        )
    return name


def model_files(described: Description, name: str, command: str) -> dict[str, str]:
    """The generated C with its header, by file name."""
    return {f"{name}.c": source_text(described, name, command), f"{name}.h": header_text(described, name, command)}


def parameter_text(described: Description, command: str, *, has_start: bool) -> str:
    """Lines ``name = number unit  # comment``, in SI units, of all that a run is given."""
    run, free = described.scene.run, ("curvature", "drop", "_angle", "_dx", "_dy")
    parameters = []
    for one in described.parameters:
        bound = {"positive": "> 0", "not-negative": ">= 0", "poisson": "-1 < nu < 1/2"}.get(one.bound, "")
        words = "; ".join(part for part in (one.meaning, bound) if part and not one.name.endswith(free))
        unit = "" if one.unit == "1" else f" {one.unit}"
        parameters.append((f"{one.name} = {one.value!r}{unit}", words or one.meaning))
    settings = [
        (f"cells = {described.cells}", f"per half span, {MIN_CELLS} or more"),
        (f"grading = {described.grading!r}", "longest cell over the shortest"),
        *([(f"fibres = {described.fibres}", "of the section, 2 or more")] if described.fibres else []),
        (f"duration = {run.duration!r} s", ""),
        (f"frames = {run.frames}", "times, evenly spaced from 0"),
        (f"relative = {described.steps.relative!r}", "tolerance of a step"),
        (f"absolute = {described.steps.absolute!r}", "tolerance of a step, in rest lengths"),
    ]
    if has_start:
        settings.append((f"start = {START}", "shape to begin from, at rest with the parameters above only"))
    title = " ".join(described.title.split())
    return rendered("parameters.txt.jinja", title=title, command=command, parameters=parameters, settings=settings)


def start_text(described: Description, nodes: Floats, state: Floats) -> str:
    """A starting shape as CSV: X of the nodes [rest lengths] and all unknowns, dimensionless."""
    names = [slot.name for slot in described.model.slots]
    rows = [",".join(repr(float(value)) for value in (x, *row)) for x, row in zip(nodes, state, strict=True)]
    return "\n".join([",".join(["X", *names]), *rows]) + "\n"


def runtime_files() -> dict[str, str]:
    """The C that is the same for all filaments, by file name."""
    folder = resources.files("softcat_sym.codegen")
    files = [file for part in ("runtime", "templates") for file in (folder / part).iterdir()]
    chosen = [file for file in files if file.name.startswith("softcat_") and file.name[-2:] in (".c", ".h")]
    return {file.name: file.read_text(encoding="utf-8") for file in sorted(chosen, key=lambda file: file.name)}


def program_files(described: Description, name: str, command: str, *, rhs: bool, accuracy: str) -> dict[str, str]:
    """A program around the generated C, and how to build it, by file name; `accuracy`: in words, for its README."""
    values = {"name": name, "prefix": prefix_of(name), "big": prefix_of(name).upper(), "command": command, "rhs": rhs}
    values["accuracy"] = textwrap.fill(accuracy, 120, break_on_hyphens=False)
    values |= {"title": " ".join(described.title.split()), "effects": ", ".join(described.effects.names)}
    texts = {file: rendered(file, **values) for file in ("main.c", "Makefile", "CMakeLists.txt", "README.md")}
    if name != DEFAULT_NAME:
        for old, new in (
            (f"{DEFAULT_NAME}.h", f"{name}.h"),
            (f"softcat_{DEFAULT_NAME}_structure", symbol_of(name, "structure")),
            (f"{DEFAULT_NAME} PARAMETERS", f"{name} PARAMETERS"),
        ):
            texts["main.c"] = texts["main.c"].replace(old, new)
    return texts
