"""C is compiled once and kept within a limit; what fails, hangs or is killed is one clear error and leaves nothing."""

from __future__ import annotations

import importlib.util
import os
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import pytest

from softcat_sym import cache
from softcat_sym.codegen import compiler as asking
from softcat_sym.codegen import library as cached
from softcat_sym.codegen.compiler import beside, find_compiler
from softcat_sym.codegen.library import OPTIMISED, cache_limit, compile_library, load
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


def test_where_the_cache_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    assert cache.cache_folder() == tmp_path / "cache"
    monkeypatch.delenv("SOFTCAT_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert cache.cache_folder() == tmp_path / "softcat_sym"
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    assert cache.cache_folder() == tmp_path / "home" / ".cache" / "softcat_sym"
    if sys.platform == "linux":  # nor a home in the list of users, as of a container's --user 1234
        monkeypatch.delenv("HOME")
        monkeypatch.setattr("pwd.getpwuid", {}.__getitem__)
        assert cache.cache_folder() == Path(tempfile.gettempdir()).resolve() / f"softcat_sym-{os.getuid()}"
    monkeypatch.setenv("SOFTCAT_CACHE", "~nobody-of-this-name/cache")
    refused("SOFTCAT_CACHE is '~nobody-of-this-name/cache'")


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


def test_two_processes_compile_the_same_at_once(native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = Counter(tmp_path, monkeypatch, delay=0.5)
    both = [subprocess.Popen([sys.executable, "-c", COMPILE], stdout=subprocess.PIPE, text=True) for _ in range(2)]
    assert [process.communicate(timeout=60)[0] for process in both] == ["42\n"] * 2
    assert counter.compilations == 2, "neither waited for the other"
    assert len(left_in(native)) == 1


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


@pytest.mark.parametrize("true", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_without_one_on_the_path_that_of_ziglang_is_taken(
    true: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The package's own compiler, or a script around this machine's in its place."""
    monkeypatch.delenv("CC", raising=False)
    known = find_compiler()
    assert known is not None
    (tmp_path / "ziglang").mkdir()
    (tmp_path / "ziglang" / "__init__.py").touch()
    zig = tmp_path / "ziglang" / "zig"
    zig.write_text(
        '#!/bin/sh\n[ "$1 $2" = "cc -mcpu=baseline" ] && shift 2 && '
        f'PATH={os.environ["PATH"]} {shlex.join(known.command)} "$@"\n'
    )
    zig.chmod(0o755)
    site = tmp_path
    if true:
        found = importlib.util.find_spec("ziglang")
        if found is None or found.origin is None:
            pytest.skip("pip install softcat_sym[compiler]")
        site = Path(found.origin).parents[1]
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.syspath_prepend(str(site))
    importlib.invalidate_caches()
    taken = find_compiler()
    assert taken is not None and taken.path == site / "ziglang" / "zig"
    assert load(compile_library(ANSWER)).answer() == 42


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


@pytest.mark.parametrize("limit", [2500, 100])
def test_a_disk_that_fills(limit: int, native: Path) -> None:
    """A limit on the size of files stops the linker, or already our own writing."""
    source = {**ANSWER, "note.h": "/* " + 200 * "x" + " */\n"}
    done = in_process(
        "import resource\nfrom softcat_sym.codegen.library import compile_library\n"
        "from softcat_sym.errors import SoftcatError\n"
        f"resource.setrlimit(resource.RLIMIT_FSIZE, ({limit}, {limit}))\n"
        f"try:\n    compile_library({source!r})\nexcept (SoftcatError, OSError) as error:\n"
        "    print(error, *getattr(error, '__notes__', []))"
    )
    # Zig's linker aborts where it cannot write, without a word.
    said = ("free some space, or set SOFTCAT_CACHE to a folder elsewhere", "or the disk is full, free some")
    assert any(one in done.stdout for one in said)
    assert left_in(native) == []
    assert load(compile_library(source)).answer() == 42


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


def test_a_compiler_that_hangs_is_stopped_with_its_passes(
    native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pids = hang(tmp_path, monkeypatch)
    monkeypatch.setattr(cached, "_PATIENCE", 0.5)
    refused("did not finish within")
    assert gone(read_pids(pids)) and left_in(native) == []


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


def test_work_beside_the_compiler(native: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both run at once; what one raises is raised, and a fault of the block ends the compiler, also a later one."""
    meeting = threading.Barrier(2, timeout=30)
    with beside(meeting.wait):
        meeting.wait()
    with pytest.raises(ZeroDivisionError), beside(lambda: 1 / 0):
        pass
    pids, threads = hang(tmp_path, monkeypatch), threading.active_count()
    for fault in (KeyboardInterrupt, ValueError):
        with pytest.raises(fault), beside(lambda: compile_library(ANSWER)):
            started = read_pids(pids)
            raise fault
        assert gone(started) and left_in(native) == [] and threading.active_count() == threads
        pids.unlink()
    failed, began = threading.Event(), time.monotonic()
    with pytest.raises(ValueError, match="a fault"), beside(lambda: failed.wait(30) and compile_library(ANSWER)):
        threading.Timer(0.1, failed.set).start()
        raise ValueError("a fault")
    assert time.monotonic() - began < 100, "it sleeps for 300 s"


# Its size.


def test_sizes(monkeypatch: pytest.MonkeyPatch) -> None:
    for text, size in {"": 512e6, "0": 0, "12345": 12345, "500 MB": 500e6, "2gib": 2 * 2**30, " 1.5 kB ": 1500}.items():
        monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", text)
        assert cache_limit() == size
    for text in ["12 potatoes", "-1", "MB", "1e9", "nan", "٣", "1 2"]:
        monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", text)
        refused(r"SOFTCAT_CACHE_LIMIT is .*'500 MB'")
    words = [cached.size_text(size) for size in (0, 999, 1500, 512e6, 2.5e9)]
    assert words == ["0 B", "999 B", "1.5 kB", "512.0 MB", "2.5 GB"]
