"""Killed compilers, folders that cannot be used, full disks: a clear error, nothing left behind."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from pathlib import Path

import pytest

from softcat_sym.codegen import compiler as folder
from softcat_sym.codegen.library import clear_cache, compile_library, load
from softcat_sym.errors import SoftcatError

from .compilers import ANSWER, COMPILE, Counter, compiler, left_in


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


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
    folder.temporary.cache_clear()
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
