"""Texts kept between processes: the same text or none, whatever happened to the folder."""

from __future__ import annotations

import os
import time
from pathlib import Path

import pytest

from softcat_sym.codegen import library as texts
from softcat_sym.codegen.library import clear_cache, keep, kept_texts, recall


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache" / "texts"


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
