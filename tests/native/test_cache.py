"""The cache survives damage, races and a clearing; it touches nothing that is not its own."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from softcat_sym.codegen.compiler import cache_folder
from softcat_sym.codegen.library import cache_entries, clear_cache, compile_library, load, store

from .compilers import ANSWER, Counter, left_in


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


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
