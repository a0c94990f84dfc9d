"""All files of the compiled solver, as a user takes them away."""

from __future__ import annotations

import re
from importlib import resources

from softcat_sym.codegen.c_source import CSource
from softcat_sym.codegen.description import Description
from softcat_sym.codegen.header import header_text
from softcat_sym.codegen.interface import DEFAULT_NAME, prefix_of, source_text, symbol_of
from softcat_sym.codegen.manifest import manifest_text
from softcat_sym.errors import SoftcatError

_NAME = re.compile(r"[a-z][a-z0-9_]{0,39}")
_TAKEN = frozenset({"main", "all", "run", "clean"})
_TEMPLATES = ("main.c", "Makefile", "CMakeLists.txt", "README.md")


def check_name(name: str) -> str:
    """The name, if files and functions may have it.

    Raises
    ------
    SoftcatError
        If not.
    """
    if not _NAME.fullmatch(name) or name in _TAKEN or name.startswith("softcat"):
        raise SoftcatError(
            f"name {name!r}: take up to 40 small letters, digits and underscores, a letter first, and not "
            f"{', '.join(sorted(_TAKEN))} nor anything that begins with softcat"
        )
    return name


def model_files(described: Description, name: str, command: str) -> dict[str, str]:
    """The generated C with its header and manifest, by file name."""
    source = CSource(
        {f"{name}.c": source_text(described, name, command), f"{name}.h": header_text(described, name, command)}
    )
    return {**source.files, "manifest.json": manifest_text(described, name, command, source)}


def runtime_files() -> dict[str, str]:
    """The C that is the same for all filaments, by file name."""
    folder = resources.files("softcat_sym.codegen")
    files = [file for part in ("runtime", "templates") for file in (folder / part).iterdir()]
    chosen = [file for file in files if file.name.startswith("softcat_") and file.name[-2:] in (".c", ".h")]
    return {file.name: file.read_text(encoding="utf-8") for file in sorted(chosen, key=lambda file: file.name)}


def program_files(described: Description, name: str, command: str, *, rhs: bool) -> dict[str, str]:
    """A program around the generated C, and how to build it, by file name."""
    folder = resources.files("softcat_sym.codegen") / "templates"
    texts = {file: (folder / file).read_text(encoding="utf-8") for file in _TEMPLATES}
    if name != DEFAULT_NAME:
        texts["main.c"] = (
            texts["main.c"]
            .replace(f"{DEFAULT_NAME}.h", f"{name}.h")
            .replace(f"softcat_{DEFAULT_NAME}_structure", symbol_of(name, "structure"))
            .replace(f"{DEFAULT_NAME} PARAMETERS", f"{name} PARAMETERS")
        )
    filled = {
        "@NAME@": name,
        "@PREFIX@": prefix_of(name),
        "@BIG@": prefix_of(name).upper(),
        "@TITLE@": " ".join(described.title.split()),
        "@COMMAND@": command,
        "@EFFECTS@": ", ".join(described.effects.names),
        "@RHS@": _RHS if rhs else "",
    }
    for file in _TEMPLATES[1:]:
        for mark, text in filled.items():
            texts[file] = texts[file].replace(mark, text)
    return texts


_RHS = """
## Your own integrator

`softcat_rhs.c` and `softcat_rhs.h` are the same filament as plain CasADi functions: right-hand side, sparse Jacobian
and powers, on the grid of the scene. They need nothing else here; their comment says what goes in and out.
"""
