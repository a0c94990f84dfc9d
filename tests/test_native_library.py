"""C is compiled once; whatever goes wrong, hangs or is killed is one clear error, and nothing is left behind."""

from __future__ import annotations

import ctypes
import errno
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from softcat_sym.codegen import compiler as asking
from softcat_sym.codegen import library
from softcat_sym.codegen.compiler import beside, cache_folder, compiler_name, find_compiler
from softcat_sym.codegen.library import OPTIMISED, cache_entries, clear_cache, compile_library, load, store
from softcat_sym.errors import SoftcatError
from tests.common.compilers import ANSWER, COMPILE, Counter, compiler, left_in


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
    asking._processor.cache_clear()
    monkeypatch.setattr(asking, "_output", lambda *command: "#define __OTHER__ 1\n")
    assert compile_library(ANSWER) == general
    assert compile_library(ANSWER, flags=["-march=native"]) != native
    asking._processor.cache_clear()


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
    asking._examine.cache_clear()
    assert compile_library(ANSWER) == path
    assert len(counter.calls) == len(before) + 2, "and so is one behind a wrapper, once a day"


@pytest.mark.parametrize("known", [b"", b"[]", b'{"a": 1}', b"\xff"])
def test_what_is_known_of_compilers_may_be_damaged(known: bytes, cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (cache / "native").mkdir(parents=True)
    (cache / "native" / "compilers.json").write_bytes(known)
    asking._examine.cache_clear()
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
        assert asking.Compiler(("cc",), version).name == name


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


def test_where_the_cache_is(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    assert cache_folder() == tmp_path / "cache"
    monkeypatch.delenv("SOFTCAT_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "shared"))
    assert cache_folder() == tmp_path / "shared" / "softcat_sym"
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    assert cache_folder() == tmp_path / "home" / ".cache" / "softcat_sym"


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
        path.with_name("library.sha256").unlink()
    else:
        for left in path.parent.iterdir():
            if damage == "empty" or left == path:
                left.unlink()
    assert compile_library(ANSWER) == path
    assert counter.compilations == (1 if damage == "another's" else 2)
    assert load(path).answer() == 42
    assert [entry.path for entry in cache_entries()] == [path]
    assert left_in(path.parent.parent) == [path.parent.name], "the damaged one is gone"


def test_two_processes_compile_the_same_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = Counter(tmp_path, monkeypatch, delay=0.5)
    code = (
        "from softcat_sym.codegen.library import compile_library, load\n"
        + f"print(load(compile_library({ANSWER!r})).answer())"
    )
    both = [
        subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        for _ in range(2)
    ]
    said = [process.communicate(timeout=60) for process in both]
    assert said == [("42\n", "")] * 2
    assert counter.compilations == 2, "neither waited for the other"
    assert len(cache_entries()) == 1
    assert compile_library(ANSWER)
    assert counter.compilations == 2


def test_the_first_to_finish_is_kept_and_the_other_uses_it() -> None:
    key, first = "a" * 64, []

    def build(content: bytes) -> Callable[[Path], object]:
        return lambda folder: (folder / "library.so").write_bytes(content)

    def overtaken(folder: Path) -> None:
        build(b"slow")(folder)
        first.append(store(key, build(b"fast")))

    assert [store(key, overtaken)] == first
    assert first[0].read_bytes() == b"fast"
    assert [entry.key for entry in cache_entries()] == [key]


def test_clearing_frees_what_the_entries_weigh_and_nothing_else(cache: Path) -> None:
    assert cache_entries() == ()
    assert clear_cache() == 0
    paths = {compile_library(ANSWER), compile_library(ANSWER, flags=("-O1",))}
    entries = cache_entries()
    assert {entry.path for entry in entries} == paths
    assert all(entry.size >= entry.path.stat().st_size and entry.key == entry.path.parent.name for entry in entries)
    assert entries[0].modified >= entries[1].modified
    mine = [cache / "notes.txt", cache / "native" / "notes.txt"]
    for note in mine:
        note.write_text("mine")
    broken_off = cache / "native" / f".{'0' * 64}.{'1' * 8}"
    broken_off.mkdir()
    (broken_off / "half.c").write_text("12345")
    os.utime(broken_off, (0, 0))
    (cache / "native" / ".compilers.01234567.part.json").write_text("123")
    (cache / "native" / "compilers.json").write_text("{}")
    assert clear_cache() == sum(entry.size for entry in entries) + 5 + 3 + 2
    assert cache_entries() == ()
    assert [path.name for path in (cache / "native").iterdir()] == ["notes.txt"]
    assert all(note.read_text() == "mine" for note in mine)


def test_a_killed_compiler_is_said_and_leaves_nothing(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiler(tmp_path, monkeypatch, "echo half > library.so; kill -9 $$")
    with pytest.raises(SoftcatError, match=r"killed by signal 9: Killed[\s\S]*if memory ran out"):
        compile_library(ANSWER)
    assert left_in(cache / "native") == []
    monkeypatch.delenv("CC")
    assert load(compile_library(ANSWER)).answer() == 42


def test_temporary_files_of_a_killed_compiler_go_with_its_folder(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place = tmp_path / "place"
    compiler(tmp_path, monkeypatch, f'echo part > "$TMPDIR/cc1.s"; echo "$TMPDIR" > {place}; kill -9 $$')
    with pytest.raises(SoftcatError, match="killed by signal 9"):
        compile_library(ANSWER)
    assert Path(place.read_text().strip()).parent == cache / "native"
    assert left_in(cache / "native") == []


def test_a_compiler_that_writes_nothing_is_said(cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    compiler(tmp_path, monkeypatch, "exit 0")
    with pytest.raises(SoftcatError, match="nothing; exit status 0"):
        compile_library(ANSWER)
    assert left_in(cache / "native") == []


@pytest.mark.parametrize("limit", [2500, 100])
def test_a_disk_that_fills_is_said_and_leaves_nothing(limit: int, cache: Path) -> None:
    """A limit on the size of files stops the linker, or already our own writing."""
    source = {**ANSWER, "note.h": "/* " + 200 * "x" + " */\n"}
    code = (
        "import resource\nfrom softcat_sym.codegen.library import compile_library\n"
        "from softcat_sym.errors import SoftcatError\n"
        f"resource.setrlimit(resource.RLIMIT_FSIZE, ({limit}, {limit}))\n"
        f"try:\n    compile_library({source!r})\nexcept SoftcatError as error:\n    print(error)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "free some space, or set SOFTCAT_CACHE to a folder elsewhere" in done.stdout
    assert left_in(cache / "native") == []
    assert load(compile_library(source)).answer() == 42


@pytest.mark.parametrize("written", ["library.sha256", "answer.c"])
@pytest.mark.parametrize("usual", [False, True], ids=["named", "usual"])
def test_no_space_left_is_said(
    written: str, usual: bool, cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if usual:
        monkeypatch.delenv("SOFTCAT_CACHE")
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
        cache = tmp_path / "softcat_sym"
    write = Path.write_text

    def full(path: Path, data: str, encoding: str | None = None) -> int:
        if path.name == written:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return write(path, data, encoding)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_text", full)
        with pytest.raises(SoftcatError, match="No space left on device; free some space"):
            compile_library(ANSWER)
    assert left_in(cache / "native") == []
    assert load(compile_library(ANSWER)).answer() == 42


def test_a_full_disk_is_no_reason_to_compile_elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("SOFTCAT_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))

    def full(*_: object, **__: object) -> None:
        raise OSError(errno.EDQUOT, os.strerror(errno.EDQUOT))

    monkeypatch.setattr(Path, "mkdir", full)
    with pytest.raises(SoftcatError, match="quota exceeded; free some space"):
        compile_library(ANSWER)


@pytest.mark.parametrize("place", ["a file", "/proc/nowhere"])
def test_a_named_folder_that_cannot_be_used_is_said(
    place: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a file").write_text("mine")
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / place))
    with pytest.raises(SoftcatError, match="set SOFTCAT_CACHE"):
        compile_library(ANSWER)


def test_a_home_that_does_not_exist_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE", "~nobody-of-this-name/cache")
    with pytest.raises(SoftcatError, match="SOFTCAT_CACHE is '~nobody-of-this-name/cache'"):
        compile_library(ANSWER)


def test_without_the_usual_folder_every_process_compiles_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    counter = Counter(tmp_path, monkeypatch)
    monkeypatch.delenv("SOFTCAT_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", "/proc/nowhere")
    asking.temporary.cache_clear()
    with pytest.warns(UserWarning, match="/proc/nowhere/softcat_sym/native: .* set SOFTCAT_CACHE"):
        path = compile_library(ANSWER)
    assert load(path).answer() == 42
    assert compile_library(ANSWER) == path, "and says so only once"
    assert counter.compilations == 1
    assert path.parent.parent.stat().st_mode & 0o077 == 0
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", COMPILE + "\nprint(compile_library)"], check=False,
                          capture_output=True, text=True)  # fmt: skip
    assert done.stdout.startswith("42\n")
    assert counter.compilations == 2


def test_the_temporary_folder_goes_with_its_process(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv("SOFTCAT_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", "/proc/nowhere")
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    subprocess.run([sys.executable, "-W", "ignore", "-c", COMPILE], check=True, capture_output=True)
    assert not list(tmp_path.glob("softcat_sym-*"))


def test_a_cache_that_is_only_read_serves_what_it_holds(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    counter = Counter(tmp_path, monkeypatch)
    path = compile_library(ANSWER)

    def refuse(*_: object, **__: object) -> None:
        raise OSError(errno.EROFS, os.strerror(errno.EROFS))

    monkeypatch.setattr(os, "utime", refuse)
    monkeypatch.setattr(Path, "mkdir", refuse)
    assert compile_library(ANSWER) == path
    assert counter.compilations == 1
    with pytest.raises(SoftcatError, match="Read-only file system; set SOFTCAT_CACHE"):
        compile_library({"other.c": "int other;\n"})


@pytest.mark.parametrize("usual", [False, True], ids=["named", "usual"])
@pytest.mark.parametrize("whose", ["another's", "writable"])
def test_code_is_not_loaded_from_where_others_can_write(
    whose: str, usual: bool, cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    if usual:
        monkeypatch.delenv("SOFTCAT_CACHE")
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
        cache = tmp_path / "softcat_sym"
    native = cache / "native"
    path = compile_library(ANSWER)
    assert native.stat().st_mode & 0o777 == 0o700
    if whose == "writable":
        native.chmod(0o770)
    elif os.geteuid() == 0:
        os.chown(native, 12345, 12345)
    else:
        monkeypatch.setattr(os, "geteuid", lambda: 12345)
    said = "belongs to another user" if whose == "another's" else "can be written by others .*chmod go-w"
    said = said.replace(" .*", ".*")
    if usual:
        with pytest.warns(UserWarning, match=said):
            other = compile_library(ANSWER)
        assert native not in other.parents
        assert load(other).answer() == 42
    else:
        with pytest.raises(SoftcatError, match=said):
            compile_library(ANSWER)
    with pytest.raises(SoftcatError, match=said):
        clear_cache()
    assert path.exists()


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
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    state = Path(f"/proc/{pid}/stat")
    return not state.exists() or state.read_text().rsplit(")", 1)[1].split()[0] != "Z"


def gone(pids: list[int]) -> bool:
    for _ in range(100):
        if not any(map(running, pids)):
            return True
        time.sleep(0.05)
    return False


def test_a_compiler_that_hangs_is_stopped_with_its_passes(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pids = hang(tmp_path, monkeypatch)
    monkeypatch.setattr(library, "_PATIENCE", 0.5)
    with pytest.raises(SoftcatError, match="did not finish within"):
        compile_library(ANSWER)
    assert gone(read_pids(pids))
    assert left_in(cache / "native") == []


def test_an_interrupt_stops_the_compiler_and_leaves_nothing(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = hang(tmp_path, monkeypatch)
    process = subprocess.Popen([sys.executable, "-c", COMPILE], stderr=subprocess.PIPE, text=True)
    pids = read_pids(path)
    process.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in process.communicate(timeout=30)[1]
    assert gone(pids)
    assert left_in(cache / "native") == []


def test_a_killed_process_leaves_nothing_that_is_taken_for_a_library(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = hang(tmp_path, monkeypatch)
    process = subprocess.Popen([sys.executable, "-c", COMPILE])
    driver, hanging = read_pids(path)
    (leftover,) = left_in(cache / "native")
    clear_cache()
    assert left_in(cache / "native") == [leftover], "what is under way is let alone"
    process.kill()
    process.wait(timeout=30)
    os.killpg(driver, signal.SIGKILL)
    assert gone([driver, hanging])
    assert cache_entries() == ()
    monkeypatch.delenv("CC")
    assert load(compile_library(ANSWER)).answer() == 42
    assert len(cache_entries()) == 1
    assert leftover in left_in(cache / "native")
    clear_cache()
    assert not list((cache / "native").iterdir())


def test_an_interrupt_while_the_compiler_starts_is_not_lost_and_stops_it(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pids = hang(tmp_path, monkeypatch)
    start = subprocess.Popen.__init__

    def interrupted(self: subprocess.Popen[str], *arguments: object, **options: object) -> None:
        start(self, *arguments, **options)  # type: ignore[call-overload]
        if "-shared" in str(arguments):
            read_pids(pids)
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.1)

    monkeypatch.setattr(subprocess.Popen, "__init__", interrupted)
    with pytest.raises(KeyboardInterrupt):
        compile_library(ANSWER)
    assert gone(read_pids(pids))
    assert left_in(cache / "native") == []


def test_a_compiler_that_hangs_when_asked_who_it_is_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    script = tmp_path / "cc"
    script.write_text("#!/bin/sh\nsleep 300\n")
    script.chmod(0o755)
    monkeypatch.setenv("CC", str(script))
    monkeypatch.setattr(asking, "_PATIENCE", 0.3)
    with pytest.raises(SoftcatError, match="no C compiler that runs"):
        compile_library(ANSWER)


def test_they_run_at_the_same_time() -> None:
    meeting = threading.Barrier(2, timeout=30)
    with beside(meeting.wait):
        meeting.wait()


def test_what_it_raises_is_raised_at_the_end_of_the_block() -> None:
    done = []

    def refused() -> None:
        raise SoftcatError("refused")

    with pytest.raises(SoftcatError, match="refused"), beside(refused):
        done.append(True)
    assert done


@pytest.mark.parametrize("fault", [KeyboardInterrupt, ValueError])
def test_a_fault_of_the_block_ends_the_compiler(
    fault: type[BaseException], cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pids = hang(tmp_path, monkeypatch)
    threads = threading.active_count()
    with pytest.raises(fault), beside(lambda: compile_library(ANSWER)):
        read_pids(pids)
        raise fault
    assert gone(read_pids(pids))
    assert left_in(cache / "native") == []
    assert threading.active_count() == threads


def test_a_compiler_that_starts_after_the_fault_is_ended_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    hang(tmp_path, monkeypatch)
    failed, began = threading.Event(), time.monotonic()

    def late() -> None:
        failed.wait(30)
        compile_library(ANSWER)

    with pytest.raises(ValueError, match="a fault"), beside(late):
        threading.Timer(0.1, failed.set).start()
        raise ValueError("a fault")
    assert time.monotonic() - began < 100, "it sleeps for 300 s"
