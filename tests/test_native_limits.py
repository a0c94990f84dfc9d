"""The cache keeps its limit, and drops what was used least recently; texts are recalled as they were or not at all."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from softcat_sym.codegen import library as cache
from softcat_sym.codegen import library as texts
from softcat_sym.codegen.library import (
    GRACE,
    cache_entries,
    cache_limit,
    clear_cache,
    compile_library,
    find,
    keep,
    kept_texts,
    load,
    recall,
    size_text,
    store,
)
from softcat_sym.errors import SoftcatError
from tests.common.compilers import ANSWER, left_in

OLD = 10 * GRACE


@pytest.fixture(autouse=True)
def native(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", "3500")
    return tmp_path / "cache" / "native"


def build(size: int) -> Callable[[Path], object]:
    return lambda folder: (folder / "library.so").write_bytes(bytes(size))


def put(name: str, age: float, size: int = 1000) -> str:
    """Store a library that was last used some seconds ago."""
    key = name * 64
    used = time.time() - age
    os.utime(store(key, build(size)).with_name("library.sha256"), (used, used))
    return key


def kept() -> set[str]:
    return {entry.key[0] for entry in cache_entries()}


def test_the_least_recently_used_go_until_the_limit_holds() -> None:
    for name, age in zip("abc", (3 * OLD, 2 * OLD, OLD), strict=True):
        put(name, age)
    assert find("a" * 64), "which is its last use"
    os.utime(find("a" * 64).with_name("library.sha256"), (time.time() - OLD / 2,) * 2)  # type: ignore[union-attr]
    put("d", 0)
    assert kept() == {"a", "c", "d"}
    assert sum(entry.size for entry in cache_entries()) <= cache_limit()
    put("e", 0, size=2100)
    assert kept() == {"d", "e"}, "d was used within the minute"


def test_the_one_just_stored_stays_however_large(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "GRACE", -1.0)  # a file server whose clock is behind
    put("a", OLD)
    put("b", OLD, size=10_000)
    assert kept() == {"b"}


def test_what_was_just_asked_for_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    put("a", OLD)
    put("b", OLD)
    find("a" * 64)
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", "0")
    put("c", OLD)
    assert kept() == {"a", "c"}


def test_a_loaded_library_works_after_it_was_dropped(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", "0")
    path = compile_library(ANSWER)
    library = load(path)
    os.utime(path.with_name("library.sha256"), (0, 0))
    put("a", 0)
    assert not path.exists()
    assert library.answer() == 42
    assert load(compile_library(ANSWER)).answer() == 42


def test_a_store_sweeps_old_leftovers_only(native: Path) -> None:
    put("a", 0)
    old, young = (native / f".{digit * 64}.{'0' * 8}" for digit in "12")
    for leftover in (old, young):
        leftover.mkdir()
    os.utime(old, (0, 0))
    put("b", 0)
    assert left_in(native) == [young.name, "a" * 64, "b" * 64]


@pytest.mark.parametrize(
    ("text", "size"),
    [("", 512e6), ("0", 0), ("12345", 12345), ("500 MB", 500e6), ("2gib", 2 * 2**30), (" 1.5 kB ", 1500)],
)
def test_sizes(text: str, size: float, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", text)
    assert cache_limit() == size


@pytest.mark.parametrize("text", ["12 potatoes", "-1", "MB", "1e9", "nan", "٣", "1 2"])
def test_what_is_no_size_is_refused(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    compile_library(ANSWER)
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", text)
    with pytest.raises(SoftcatError, match=r"SOFTCAT_CACHE_LIMIT is .*'500 MB'"):
        compile_library(ANSWER)


def test_sizes_in_words() -> None:
    assert [size_text(size) for size in (0, 999, 1500, 512e6, 2.5e9)] == [
        "0 B",
        "999 B",
        "1.5 kB",
        "512.0 MB",
        "2.5 GB",
    ]


@pytest.fixture
def folder(native: Path) -> Path:
    return native.with_name("texts")


def test_what_was_kept_is_recalled_and_nothing_else() -> None:
    keep("a" * 64, "phi(σ) = σ/η\n" * 1000)
    assert recall("a" * 64) == "phi(σ) = σ/η\n" * 1000
    assert recall("b" * 64) is None


def test_a_damaged_text_is_none_and_kept_anew(folder: Path) -> None:
    keep("a" * 64, "text")
    (path,) = folder.iterdir()
    path.write_bytes(path.read_bytes()[:-1] + b"?")
    assert recall("a" * 64) is None
    keep("a" * 64, "text")
    assert recall("a" * 64) == "text"


def test_a_text_in_the_place_of_another_is_none(folder: Path) -> None:
    keep("a" * 64, "text")
    (path,) = folder.iterdir()
    path.rename(folder / path.name.replace("a", "b"))
    assert recall("b" * 64) is None


@pytest.mark.skipif(os.name == "nt", reason="POSIX modes")
def test_a_folder_that_others_can_write_is_not_read(folder: Path) -> None:
    keep("a" * 64, "text")
    folder.chmod(0o777)
    assert recall("a" * 64) is None
    keep("b" * 64, "text")
    assert len(list(folder.iterdir())) == 1


def test_where_nothing_can_be_kept_nothing_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "file"))
    keep("a" * 64, "text")
    assert recall("a" * 64) is None


def test_those_go_that_were_not_used_for_longest(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(texts, "MOST", 2)
    for age, name in ((300, "a"), (200, "b")):
        keep(name * 64, name)
        os.utime(folder / f"{name * 64}.text", (time.time() - age,) * 2)
    assert recall("a" * 64) == "a"
    keep("c" * 64, "c")
    assert {name for name in "abc" if recall(name * 64)} == {"a", "c"}


def test_they_are_cleared_with_the_libraries() -> None:
    keep("a" * 64, "text")
    assert clear_cache() > 64
    assert kept_texts() == []
    assert recall("a" * 64) is None
