"""The solver of a scene as WebAssembly: its C compiled for a browser, and kept in the cache of compiled libraries."""

from __future__ import annotations

import functools
import os
import re
import tempfile
from collections.abc import Iterator
from importlib import resources
from pathlib import Path

from softcat_sym.codegen.compiler import Compiler, first_of, of_a_wheel, run, split_variable
from softcat_sym.codegen.export import model_files, runtime_files
from softcat_sym.codegen.interface import DEFAULT_NAME, Description
from softcat_sym.codegen.library import OPTIMISED, compiled_by
from softcat_sym.errors import SoftcatError

VARIABLE = "SOFTCAT_WASM_CC"
TO_INSTALL = f'pip install "softcat_sym[web]", or name a C compiler for WebAssembly in {VARIABLE}'
"""What a user without such a compiler can do."""

# Sums may be taken in any order, so that vectors add them up: without it a run takes a tenth to a half longer. What is
# not finite is still found; -ffast-math would say it never is.
FLAGS = (*OPTIMISED, "-fassociative-math", "-fno-signed-zeros")

_ALWAYS = ("-std=c99", "-target", "wasm32-wasi", "-mexec-model=reactor", "-s")
_SIMD, _SOUND = "-msimd128", 16  # clang 14 makes wrong vectors of softcat_band.c; 16 and 22 do not
_PAGE, _COMMAND = "softcat_page.c", "softcat generate --web"
_PLACES = ("/opt/wasi-sdk/bin/clang", "clang")
_PATIENCE = 60.0  # s, to compile next to nothing
_NOTHING = """\
#include <math.h>
#include <stdlib.h>

double *asked(double x)
{
    double *room = malloc(sizeof *room);
    if (room) *room = exp(x);
    return room;
}
"""


def find_wasm_compiler() -> Compiler | None:
    """The compiler that SOFTCAT_WASM_CC names, else the package ziglang, else zig or a clang that has such a libc."""
    named = split_variable(VARIABLE)
    if named:
        return first_of([named])
    zig = first_of([*of_a_wheel(), ["zig", "cc"]])
    return zig or next((found for one in _clangs() if (found := first_of([[one]])) and _links(found)), None)


def _clangs() -> Iterator[str]:
    """Where one of WASI's SDK may be, or one that a system has: Debian calls the other packages wasi-libc and lld."""
    if kit := os.environ.get("WASI_SDK_PATH"):
        yield str(Path(kit) / "bin" / "clang")
    yield from _PLACES


@functools.lru_cache(maxsize=8)
def _links(compiler: Compiler) -> bool:
    """Whether a compiler has what a module for the web is linked with."""
    with tempfile.TemporaryDirectory(prefix="softcat_sym-") as passing:
        (Path(passing) / "asked.c").write_text(_NOTHING, encoding="utf-8")
        command = [*compiler.command, *_ALWAYS, "-o", "asked.wasm", "asked.c", "-lm"]
        return run(command, _PATIENCE, Path(passing)).returncode == 0


def _flags(compiler: Compiler) -> tuple[str, ...]:
    """How a compiler is asked; one that makes wrong vectors is asked for none."""
    version = re.search(r"\d+", compiler.name)
    return FLAGS if version is not None and int(version[0]) < _SOUND else (*FLAGS, _SIMD)


def module_sources(described: Description) -> dict[str, str]:
    """C of the solver of a scene with what a page calls, by file name."""
    page, model = resources.files("softcat_sym.web") / "templates" / _PAGE, described.model
    files = {name: text for name, text in runtime_files().items() if not name.startswith("softcat_text.")}
    sizes = {"ROWS": model.rows, "SCRATCH": model.template.scratch_shown}
    head = [f"#define PAGE_{name}(points) ({plain} + {each} * (points))" for name, (plain, each) in sizes.items()]
    files |= {"observables.c": model.observables, _PAGE: page.read_text(encoding="utf-8")}
    return files | model_files(described, DEFAULT_NAME, _COMMAND) | {"page_rows.h": "\n".join([*head, ""])}


def wasm_compiler() -> Compiler:
    """The compiler for WebAssembly; SoftcatError where there is none."""
    compiler = find_wasm_compiler()
    if compiler is None:
        named = os.environ.get(VARIABLE)
        found = f"{VARIABLE} is {named!r}, which does not run" if named else "no C compiler for WebAssembly was found"
        raise SoftcatError(f"{found}; {TO_INSTALL}")
    return compiler


def wasm_module(described: Description) -> bytes:
    """The solver of a scene as a WebAssembly module that imports nothing, compiled now or found in the cache."""
    compiler = wasm_compiler()
    return compiled_by(compiler, module_sources(described), _ALWAYS, _flags(compiler)).read_bytes()
