"""The generated C is clean under the strictest warnings of gcc, its static analysis, and clang."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

import softcat_sym as sc

pytestmark = pytest.mark.slow

SCENES = ("no-yield", "ink-bridge", "maxwell-slow", "beam-viscometer", "drawn-blob")
"""Of different laws, ends, sections and surroundings."""
WARNINGS = ("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-c", "-o", "/dev/null")
COMPILERS = {"gcc": ("-O1", "-fanalyzer"), "clang": ()}
STRAIGHT = "softcat_rhs.c"
"""Thousands of assignments by CasADi, without a pointer of its own: its analysis takes minutes."""


@pytest.fixture(scope="module")
def sources(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Every C file of the five products; one that several share, once."""
    found: dict[bytes, Path] = {}
    for name in SCENES:
        folder = tmp_path_factory.mktemp(name)
        sc.generate(sc.load_scene(name), folder, rhs=True)
        for path in sorted(folder.glob("*.c")):
            found.setdefault(path.read_bytes(), path)
    return list(found.values())


@pytest.mark.parametrize("compiler", list(COMPILERS))
def test_no_compiler_warns_of_anything(compiler: str, sources: list[Path]) -> None:
    if shutil.which(compiler) is None:
        pytest.skip(f"no {compiler}")
    said = {}
    for path in sources:
        more = COMPILERS[compiler] if path.name != STRAIGHT else ()
        command = [compiler, *WARNINGS, *more, f"-I{path.parent}", str(path)]
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
        if done.returncode:
            said[f"{path.parent.name}/{path.name}"] = done.stderr[:400]
    assert said == {}
    assert len(sources) >= 20
