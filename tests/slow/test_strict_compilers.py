"""The generated C is clean under the strictest warnings of gcc, its static analysis, and clang."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

import softcat_sym as sc

pytestmark = pytest.mark.slow

SCENES = ("no-yield", "ink-bridge", "maxwell-slow", "beam-viscometer", "drawn-blob", "glass-fibre")
"""Of different laws, ends, sections and surroundings."""
WARNINGS = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-c", "-o", "/dev/null")
COMPILERS = {"gcc": ("-O1", "-fanalyzer"), "clang": ()}
STRAIGHT = "softcat_rhs.c"
"""Of tables above all: its analysis takes as long as that of all others."""


def test_no_compiler_warns_of_anything(tmp_path: Path) -> None:
    sources: dict[bytes, Path] = {}
    for name in SCENES:
        sc.generate(sc.load_scene(name), tmp_path / name, rhs=True)
        for path in sorted((tmp_path / name).glob("*.c")):
            sources.setdefault(path.read_bytes(), path)  # one that several scenes share, once
    assert len(sources) >= 20
    found, messages = [compiler for compiler in COMPILERS if shutil.which(compiler)], {}
    assert found, "neither gcc nor clang"
    for compiler in found:
        for path in sources.values():
            more = COMPILERS[compiler] if path.name != STRAIGHT else ()
            command = [compiler, *WARNINGS, *more, f"-I{path.parent}", str(path)]
            done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
            if done.returncode:
                messages[f"{compiler}, {path.parent.name}/{path.name}"] = done.stderr[:400]
    print(f"\n{len(sources)} sources by {' and '.join(found)}")
    assert messages == {}
