"""A compiler that counts: it writes down how it is called and hands over to the real one."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest

from softcat_sym.codegen.compiler import find_compiler

ANSWER = {"answer.c": '#include "answer.h"\nint answer(void) { return ANSWER; }\n', "answer.h": "#define ANSWER 42\n"}
COMPILE = (
    f"from softcat_sym.codegen.library import compile_library, load\nprint(load(compile_library({ANSWER!r})).answer())"
)


def left_in(native: Path) -> list[str]:
    """What lies in the folder of libraries."""
    return sorted(path.name for path in native.iterdir())


class Counter:
    """A stand-in for the C compiler that CC names."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch, delay: float = 0.0) -> None:
        real = find_compiler()
        assert real is not None, "these tests want a C compiler"
        self.log, self.script = folder / "calls", folder / "counting-cc"
        command = " ".join(map(shlex.quote, real.command))
        # Zig asks what CC names where headers are, which would be counted.
        self.script.write_text(
            f'#!/bin/sh\nunset CC\necho "$*" >> {shlex.quote(str(self.log))}\n'
            f'case "$*" in *-nostdlib*) ;; *-shared*) sleep {delay};; esac\nexec {command} "$@"\n'
        )
        self.script.chmod(0o755)
        monkeypatch.setenv("CC", str(self.script))

    @property
    def calls(self) -> list[str]:
        """Every call so far."""
        return self.log.read_text().splitlines() if self.log.exists() else []

    @property
    def compilations(self) -> int:
        """Calls that compiled, rather than asked for the version and whether it links."""
        return sum("-shared" in call and "-nostdlib" not in call for call in self.calls)


def compiler(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, compiling: str) -> Counter:
    """A compiler that does this instead of compiling."""
    counter = Counter(tmp_path, monkeypatch)
    text = counter.script.read_text()
    counter.script.write_text(text.replace("*-shared*) sleep 0.0;;", f"*-shared*) {compiling};;"))
    return counter
