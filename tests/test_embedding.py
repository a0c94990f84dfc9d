"""The solver in other people's programs: without a heap, stepped from outside, as FMU, as one file for Python."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.export import runtime_files

ROOT = Path(__file__).parents[1]
PROGRAMS = Path(__file__).with_name("common") / "programs"
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wconversion", "-Wshadow")
OF_LIBM = """
acos asin atan atan2 ceil cos cosh erf exp expm1 fabs floor fmax fmin hypot log log1p nextafter pow sin sincos sinh sqrt
tan tanh
"""
MEMORY = {"memcpy", "memmove", "memset", "memcmp"}


def compiler() -> list[str]:
    found = find_compiler()
    if found is None:
        assert not os.environ.get("SOFTCAT_TESTS_NEED_A_COMPILER"), "a C compiler is missing"
        pytest.skip("no C compiler here")
    return list(found.command)


def test_the_library_allocates_nothing_and_bounds_its_stack(tmp_path: Path) -> None:
    """Of the runtime and a product: libm and four functions of memory, no other symbol, no data that changes."""
    command, nm = compiler(), shutil.which("nm")
    if nm is None:
        pytest.skip("no nm here")
    for name, text in runtime_files().items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    shutil.copy(ROOT / "generated/arrested-overdamped/filament.c", tmp_path)
    shutil.copy(ROOT / "generated/arrested-overdamped/filament.h", tmp_path)
    bounded = ["-Wstack-usage=4096"] if "gcc" in find_compiler().name else []  # type: ignore[union-attr]
    sources = [path.name for path in sorted(tmp_path.glob("*.c")) if path.name != "softcat_text.c"]
    subprocess.run([*command, *STRICT, *bounded, "-O2", "-fno-pie", "-c", *sources], cwd=tmp_path, check=True)
    objects = [name.replace(".c", ".o") for name in sources]
    said = subprocess.run([nm, *objects], cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    symbols = [line.split() for line in said.splitlines() if line and not line.endswith(":")]
    defined = {words[-1] for words in symbols if len(words) == 3}
    needed = {words[-1] for words in symbols if words[0] in ("U", "w")} - defined
    allowed = set(OF_LIBM.split()) | MEMORY
    assert needed <= allowed | {"_GLOBAL_OFFSET_TABLE_", "__stack_chk_fail"}, needed - allowed
    assert not [words for words in symbols if words[-2] in "BbDdCG"], "a global that can be written"
