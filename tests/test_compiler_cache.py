"""C is compiled once and kept within a limit; what fails, hangs or is killed is one clear error and leaves nothing."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from softcat_sym import cache
from softcat_sym.codegen import compiler as asking
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.library import OPTIMISED, compile_library, load
from softcat_sym.errors import SoftcatError
from tests.common.compilers import ANSWER, COMPILE, Counter, compiler, left_in


@pytest.fixture(autouse=True)
def native(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    # A flag such as -march=native of whoever tests has each process ask the compiler for its processor.
    monkeypatch.delenv("SOFTCAT_CFLAGS", raising=False)
    return tmp_path / "cache" / "native"


def in_process(code: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, text=True, check=True)


def refused(match: str, sources: dict[str, str] = ANSWER) -> None:
    with pytest.raises(SoftcatError, match=match):
        compile_library(sources)


# What makes a library, and what is compiled again.
def test_a_library_runs_and_is_compiled_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = Counter(tmp_path, monkeypatch)
    path = compile_library(ANSWER)
    assert load(path, "answer").answer() == 42 and counter.compilations == 1
    before = counter.calls
    assert compile_library(ANSWER) == path
    assert in_process(f"import subprocess; subprocess.Popen = None\n{COMPILE}").stdout == "42\n"
    assert counter.calls == before, "neither again nor in another process is the compiler asked anything"
    assert load(compile_library({"r.c": "#include <math.h>\ndouble r(double x) { return cbrt(x); }\n"}), "r")
    with pytest.raises(SoftcatError, match="lacks hidden, which its C sources define"):
        load(path, "answer", "hidden")
    (tmp_path / "text.so").write_text("no library")
    for name in ("text.so", "missing.so"):
        with pytest.raises(SoftcatError, match="cannot load"):
            load(tmp_path / name)


def test_sources_flags_units_versions_and_compiler_each_make_another_library(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    paths = [
        compile_library(ANSWER),
        compile_library({**ANSWER, "answer.h": "#define ANSWER 43\n"}),
        compile_library(ANSWER, flags=("-O1",)),
        compile_library({**ANSWER, "note.h": ""}),
        compile_library({**ANSWER, "part.c": "int part;\n"}),
        compile_library({**ANSWER, "part.c": "int part;\n"}, units=["answer.c"]),
        compile_library(ANSWER, versions={"casadi": "3.6"}),
    ]
    counter = Counter(tmp_path, monkeypatch)
    monkeypatch.setenv("CC", f"{counter.script} -DEXTRA=7")
    paths.append(compile_library(ANSWER))
    assert not any("native" in text for text in (*counter.calls, *OPTIMISED)), "no flag names the processor by itself"
    monkeypatch.setenv("SOFTCAT_CFLAGS", "-march=native -DSPACE='a b'")
    paths.append(compile_library(ANSWER))
    assert "-march=native -DSPACE=a b -o" in counter.calls[-1], "after the flags of the package"
    asking._processor.cache_clear()
    monkeypatch.setattr(asking, "_output", lambda *command: "#define __OTHER__ 1\n")
    paths.append(compile_library(ANSWER))
    asking._processor.cache_clear()
    assert len(set(paths)) == len(paths), "on another processor, too"
    assert all(load(path).answer() == 42 for path in (paths[0], *paths[2:]))
    found = find_compiler()
    assert found is not None and found.command == (str(counter.script), "-DEXTRA=7") and found.version


@pytest.mark.parametrize("damage", ["cut", "changed", "no digest", "no library", "empty", "another's"])
def test_a_damaged_entry_is_compiled_again(damage: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = Counter(tmp_path, monkeypatch)
    path = compile_library(ANSWER)
    content = path.read_bytes()
    if damage == "cut":
        path.write_bytes(content[: len(content) // 2])
    elif damage == "changed":
        path.write_bytes(content[:-1] + bytes([content[-1] ^ 1]))
    elif damage == "another's":
        other = compile_library({"answer.c": "int answer(void) { return 43; }\n"}).parent
        shutil.rmtree(path.parent)
        other.rename(path.parent)
        counter.log.unlink()
    elif damage == "no digest":
        path.with_name("about.txt").unlink()
    else:
        for left in path.parent.iterdir():
            if damage == "empty" or left == path:
                left.unlink()
    assert compile_library(ANSWER) == path
    assert counter.compilations == (1 if damage == "another's" else 2)
    assert load(path).answer() == 42
    assert left_in(path.parent.parent) == [path.parent.name], "the damaged one is gone"


# Faults: each is one error, and nothing is left behind.
def test_what_is_wrong_with_compiler_or_flags_is_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for variable, text, message in [
        ("CC", "/nowhere/cc", "CC is '/nowhere/cc', .* install gcc or clang"),
        ("CC", "no-such-compiler -O2", "CC is .* install gcc or clang"),
        ("CC", "false", "CC is 'false', .* install gcc or clang"),
        ("CC", "'-O2", "CC is .*No closing quotation"),
        ("SOFTCAT_CFLAGS", "'-O2", "SOFTCAT_CFLAGS is .*No closing quotation"),
        ("SOFTCAT_CFLAGS", "-march=no-such-processor", "no-such-processor"),
    ]:
        with monkeypatch.context() as patch:
            patch.setenv(variable, text)
            refused(message)
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    assert find_compiler() is None
    refused(r"no C compiler that runs was found; install gcc or clang \(or pip install 'softcat_sym\[compiler\]'\)")


@pytest.mark.parametrize(
    ("does", "message"),
    [
        ("echo half > library.so; kill -9 $$", r"killed by signal 9: Killed[\s\S]*if memory ran out"),
        ('echo part > "$TMPDIR/cc1.s"; kill -9 $$', "killed by signal 9"),
        ("exit 0", "nothing; exit status 0"),
    ],
)
def test_a_compiler_that_fails(
    does: str, message: str, native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiler(tmp_path, monkeypatch, does)
    refused(message)
    assert left_in(native) == []
    monkeypatch.delenv("CC")
    assert load(compile_library(ANSWER)).answer() == 42


def test_broken_sources_give_the_first_errors(native: Path) -> None:
    with pytest.raises(SoftcatError, match=r"broken\.c:1[\s\S]*nowhere[\s\S]*set CC") as refusal:
        compile_library({"broken.c": "int f(void) { return nowhere; }\n"})
    assert len(str(refusal.value).splitlines()) < 12
    assert left_in(native) == []


# Compilers that hang, and processes that are interrupted or killed.
def hang(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A compiler whose pass hangs; the file will hold the process ids of driver and pass."""
    pids = tmp_path / "pids"
    compiler(tmp_path, monkeypatch, f"echo half > library.so; sleep 300 & echo $$ $! > {pids}; wait")
    return pids


def read_pids(path: Path) -> list[int]:
    for _ in range(400):
        if path.exists() and path.read_text().endswith("\n"):
            return [int(word) for word in path.read_text().split()]
        time.sleep(0.05)
    raise AssertionError("the compiler was not called")


def running(pid: int) -> bool:
    """Whether a process runs: one that is dead but not yet reaped does not."""
    state = Path(f"/proc/{pid}/stat")
    return state.exists() and state.read_text().rsplit(")", 1)[1].split()[0] != "Z"


def gone(pids: list[int]) -> bool:
    for _ in range(100):
        if not any(map(running, pids)):
            return True
        time.sleep(0.05)
    return False


@pytest.mark.parametrize("killed", [False, True], ids=["interrupted", "killed"])
def test_an_ended_process_leaves_nothing_that_is_taken_for_a_library(
    killed: bool, native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = hang(tmp_path, monkeypatch)
    process = subprocess.Popen([sys.executable, "-c", COMPILE], stderr=subprocess.PIPE, text=True)
    driver, hanging = read_pids(path)
    if not killed:
        process.send_signal(signal.SIGINT)
        assert "KeyboardInterrupt" in process.communicate(timeout=30)[1]
        assert gone([driver, hanging]) and left_in(native) == []
        return
    (leftover,) = left_in(native)
    cache.clear(cache.LIBRARIES)
    assert left_in(native) == [leftover], "what is under way is let alone"
    process.kill()
    process.communicate(timeout=30)
    os.killpg(driver, signal.SIGKILL)
    assert gone([driver, hanging]) and cache.entries(cache.LIBRARIES) == []
    monkeypatch.delenv("CC")
    os.utime(native / leftover, (0, 0))  # an hour later
    assert load(compile_library(ANSWER)).answer() == 42
    assert leftover not in left_in(native) and len(left_in(native)) == 1
