"""C is compiled once; whatever goes wrong is one clear error."""

from __future__ import annotations

import ctypes
import json
import subprocess
import sys
from pathlib import Path

import pytest

from softcat_sym.codegen import compiler
from softcat_sym.codegen.compiler import cache_folder, compiler_name, find_compiler
from softcat_sym.codegen.library import OPTIMISED, compile_library, load
from softcat_sym.errors import SoftcatError

from .compilers import ANSWER, Counter, left_in


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
    assert left_in(cache / "native") == []


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


def test_no_flag_names_the_processor_unless_the_user_asks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = Counter(tmp_path, monkeypatch)
    assert not any("native" in flag for flag in OPTIMISED)
    first = compile_library(ANSWER)
    assert not any("native" in call for call in counter.calls)
    monkeypatch.setenv("SOFTCAT_CFLAGS", "-march=native -DSPACE='a b'")
    second = compile_library(ANSWER)
    assert second != first
    assert load(second).answer() == 42
    assert "-march=native -DSPACE=a b -o" in counter.calls[-1], "after the flags of the package"
    assert compile_library(ANSWER) == second


def test_the_processor_counts_where_a_flag_asks_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    native, general = compile_library(ANSWER, flags=["-march=native"]), compile_library(ANSWER)
    compiler._processor.cache_clear()
    monkeypatch.setattr(compiler, "_output", lambda *command: "#define __OTHER__ 1\n")
    assert compile_library(ANSWER) == general
    assert compile_library(ANSWER, flags=["-march=native"]) != native
    compiler._processor.cache_clear()


@pytest.mark.parametrize("variable", ["SOFTCAT_CFLAGS", "CC"])
def test_quotes_that_are_not_closed_are_said(variable: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(variable, "'-O2")
    with pytest.raises(SoftcatError, match=f"{variable} is .*No closing quotation"):
        compile_library(ANSWER)


def test_a_flag_of_the_user_that_the_compiler_refuses_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CFLAGS", "-march=no-such-processor")
    with pytest.raises(SoftcatError, match="no-such-processor"):
        compile_library(ANSWER)


def test_versions_are_in_the_key() -> None:
    paths = [compile_library(ANSWER, versions=versions) for versions in ({"casadi": "3.6"}, {"casadi": "3.7"}, None)]
    assert len(set(paths)) == 3


def test_another_process_finds_a_library_without_starting_any(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = Counter(tmp_path, monkeypatch)
    path = compile_library(ANSWER)
    before = counter.calls
    code = (
        "import subprocess\nsubprocess.Popen = None\nfrom softcat_sym.codegen.library import compile_library\n"
        f"print(compile_library({ANSWER!r}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == str(path)
    assert counter.calls == before
    counter.script.write_text(counter.script.read_text() + "# another\n")
    assert compile_library(ANSWER) == path
    assert len(counter.calls) == len(before) + 1, "a compiler whose file changed is asked again"
    known = cache_folder() / "native" / "compilers.json"
    days_ago = {key: {**value, "time": value["time"] - 2e5} for key, value in json.loads(known.read_bytes()).items()}
    known.write_text(json.dumps(days_ago))
    compiler._examine.cache_clear()
    assert compile_library(ANSWER) == path
    assert len(counter.calls) == len(before) + 2, "and so is one behind a wrapper, once a day"


@pytest.mark.parametrize("known", [b"", b"[]", b'{"a": 1}', b"\xff"])
def test_what_is_known_of_compilers_may_be_damaged(known: bytes, cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (cache / "native").mkdir(parents=True)
    (cache / "native" / "compilers.json").write_bytes(known)
    compiler._examine.cache_clear()
    assert load(compile_library(ANSWER)).answer() == 42
    found = find_compiler()
    assert found is not None
    assert found.version in json.dumps(json.loads((cache / "native" / "compilers.json").read_bytes()))


def test_a_compiler_in_short() -> None:
    for version, name in [
        ("cc (Debian 12.2.0-14+deb12u1) 12.2.0", "gcc 12.2.0"),
        ("gcc (GCC) 11.4.1 20231218 (Red Hat 11.4.1-3)", "gcc 11.4.1"),
        ("gcc-13 (Homebrew GCC 13.2.0) 13.2.0", "gcc 13.2.0"),
        ("Debian clang version 14.0.6", "clang 14.0.6"),
        ("Apple clang version 15.0.0 (clang-1500.3.9.4)", "clang 15.0.0"),
        ("tcc version 0.9.27 (x86_64 Linux)", "tcc 0.9.27"),
        ("strange", "strange"),
    ]:
        assert compiler.Compiler(("cc",), version).name == name


def test_no_compiler_has_no_name(monkeypatch: pytest.MonkeyPatch) -> None:
    assert compiler_name().split()[0] in ("gcc", "clang")
    monkeypatch.setenv("CC", "/nowhere/cc")
    assert compiler_name() == ""


def test_what_is_no_library_is_not_loaded(tmp_path: Path) -> None:
    (tmp_path / "text.so").write_text("no library")
    for name in ("text.so", "missing.so"):
        with pytest.raises(SoftcatError, match="cannot load"):
            load(tmp_path / name)


def test_a_library_without_its_symbols_is_refused() -> None:
    path = compile_library({"hidden.c": "int shown(void) { return 1; }\nstatic int hidden;\nint *at = &hidden;\n"})
    assert load(path, "shown", "at").shown() == 1
    with pytest.raises(SoftcatError, match=r"lacks hidden, which its C sources define; look at CC and SOFTCAT_CFLAGS"):
        load(path, "shown", "hidden")


@pytest.mark.parametrize(("prints", "name"), [("printf '\\n\\nodd 1.2\\n'", "odd 1.2"), ("sleep 60", "")])
def test_a_compiler_with_an_odd_version_or_none(
    prints: str, name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    script = tmp_path / "odd-cc"
    script.write_text(f"#!/bin/sh\n{prints}\n")
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    monkeypatch.setattr("softcat_sym.codegen.compiler._PATIENCE", 0.5)
    assert compiler_name() == name
