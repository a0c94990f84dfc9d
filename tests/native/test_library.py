"""C is compiled once; whatever goes wrong is one clear error."""

from __future__ import annotations

import ctypes
from pathlib import Path

import pytest

from softcat_sym.errors import SoftcatError
from softcat_sym.native import OPTIMISED, compile_library, find_compiler, load

from .compilers import ANSWER, Counter


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def test_a_library_runs_and_is_compiled_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = Counter(tmp_path, monkeypatch)
    path = compile_library(ANSWER)
    assert load(path).answer() == 42
    assert counter.compilations == 1
    before = counter.calls
    assert compile_library(ANSWER) == path
    assert counter.calls == before, "the second time nobody asks the compiler anything"


def test_sources_flags_units_and_compiler_each_make_another_library(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = compile_library(ANSWER)
    others = {
        compile_library({**ANSWER, "answer.h": "#define ANSWER 43\n"}),
        compile_library(ANSWER, flags=("-O1",)),
        compile_library({**ANSWER, "note.h": ""}),
        compile_library({**ANSWER, "part.c": "int part;\n"}),
        compile_library({**ANSWER, "part.c": "int part;\n"}, units=["answer.c"]),
    }
    Counter(tmp_path, monkeypatch)
    others.add(compile_library(ANSWER))
    assert len(others | {first}) == 7


def test_only_the_units_are_compiled_on_their_own() -> None:
    sources = {
        "whole.c": '#include "piece.c"\nint whole(void) { return piece(); }\n',
        "piece.c": "int piece(void) { return 3; }\n",
    }
    assert load(compile_library(sources, units=["whole.c"])).whole() == 3
    with pytest.raises(SoftcatError, match="piece"):
        compile_library(sources)


def test_the_mathematical_functions_are_linked() -> None:
    library = load(compile_library({"root.c": "#include <math.h>\ndouble root(double x) { return cbrt(exp(x)); }\n"}))
    library.root.restype, library.root.argtypes = ctypes.c_double, [ctypes.c_double]
    assert library.root(3.0) == pytest.approx(2.718281828459045)


def test_broken_sources_give_the_first_errors_and_leave_nothing(cache: Path) -> None:
    with pytest.raises(SoftcatError) as refusal:
        compile_library({"broken.c": "int f(void) { return nowhere; }\n"})
    text = str(refusal.value)
    assert "broken.c:1" in text
    assert "nowhere" in text
    assert "set CC" in text
    assert len(text.splitlines()) < 12
    assert not list((cache / "native").iterdir())


@pytest.mark.parametrize("named", ["/nowhere/cc", "no-such-compiler -O2", "false"])
def test_a_compiler_that_does_not_run_is_never_replaced_by_another(named: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", named)
    assert find_compiler() is None
    with pytest.raises(SoftcatError, match=f"CC is {named!r}, .* install gcc or clang"):
        compile_library(ANSWER)


def test_no_compiler_on_the_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert find_compiler() is None
    with pytest.raises(SoftcatError, match="no C compiler that runs was found; install gcc or clang, or set CC"):
        compile_library(ANSWER)


def test_cc_may_carry_flags(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = Counter(tmp_path, monkeypatch)
    monkeypatch.setenv("CC", f"{counter.script} -DEXTRA=7")
    source = {"extra.c": "int extra(void) { return EXTRA; }\n"}
    assert load(compile_library(source)).extra() == 7
    compiler = find_compiler()
    assert compiler is not None
    assert compiler.command == (str(counter.script), "-DEXTRA=7")
    assert compiler.path == counter.script
    assert compiler.version


def test_a_flag_for_this_processor_is_left_out_where_it_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    counter = Counter(tmp_path, monkeypatch)
    script = counter.script.read_text().replace("case", 'case "$*" in *-march*) exit 1;; esac\ncase', 1)
    counter.script.write_text(script)
    assert "-march=native" in OPTIMISED
    assert load(compile_library(ANSWER)).answer() == 42
    assert not any("-march" in call for call in counter.calls if "-shared" in call)


def test_what_is_no_library_is_not_loaded(tmp_path: Path) -> None:
    (tmp_path / "text.so").write_text("no library")
    for name in ("text.so", "missing.so"):
        with pytest.raises(SoftcatError, match="cannot load"):
            load(tmp_path / name)
