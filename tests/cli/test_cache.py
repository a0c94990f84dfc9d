"""``softcat cache`` shows what is kept, and clears the compiled libraries only."""

from __future__ import annotations

from pathlib import Path

import pytest

from softcat_sym.codegen.library import keep, store

from .in_process import Softcat


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def put(name: str, size: int) -> None:
    store(name * 64, lambda folder: (folder / "library.so").write_bytes(bytes(size)), f"{name}.c by gcc")


def test_an_empty_cache(softcat: Softcat, cache: Path) -> None:
    done = softcat("cache")
    assert done.status == 0
    assert f"folder     {cache}\n" in done.out
    assert "libraries  0, 0 B of at most 512.0 MB\n" in done.out
    assert "C texts    0, 0 B\n" in done.out
    done = softcat("cache", "--clear")
    assert done.status == 0
    assert f"deleted 0 compiled libraries from {cache / 'native'}: " in done.out


def test_what_is_kept_is_shown_and_cleared(softcat: Softcat, cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", "2 MB")
    put("a", 400_000)
    put("b", 100_000)
    keep("c" * 64, "text")
    (cache / "elements").mkdir()
    (cache / "elements" / "run.npz").write_bytes(bytes(3000))
    done = softcat("cache")
    assert done.status == 0
    assert "libraries  2, 500.2 kB of at most 2.0 MB\n" in done.out
    assert "C texts    1, 7" in done.out
    assert [line.split()[0] for line in done.out.splitlines() if ".c by gcc" in line] in (
        ["a" * 12, "b" * 12],
        ["b" * 12, "a" * 12],
    )
    assert "elements: states of finite elements, 1 files, 3.0 kB; not cleared" in done.out
    monkeypatch.setenv("CC", "/nowhere/cc")
    assert "compiler   none\n" in softcat("cache").out
    done = softcat("cache", "--clear")
    assert done.status == 0
    assert "deleted 2 compiled libraries" in done.out
    assert ": 500." in done.out
    assert "elements: " in done.out
    assert (cache / "elements" / "run.npz").exists()
    done = softcat("cache")
    assert "libraries  0, " in done.out
    assert "C texts    0, 0 B\n" in done.out


def test_many_are_counted(softcat: Softcat) -> None:
    for number in range(32):
        store(f"{number:064x}", lambda folder: (folder / "library.so").write_bytes(b""), "by gcc")
    done = softcat("cache")
    assert "libraries  32, " in done.out
    assert done.out.count("by gcc") == 20
    assert "... and 12 that were used before\n" in done.out


def test_a_limit_that_is_no_size_is_bad_input(softcat: Softcat, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", "much")
    done = softcat("cache")
    assert done.status == 2
    assert done.out == ""
    assert done.err.startswith("softcat: SOFTCAT_CACHE_LIMIT is 'much'; accepted: ")


def test_a_folder_of_others_is_not_cleared(softcat: Softcat, cache: Path) -> None:
    put("a", 10)
    (cache / "native").chmod(0o777)
    done = softcat("cache", "--clear")
    assert done.status == 2
    assert "not cleared" in done.err
    assert (cache / "native" / ("a" * 64)).exists()


def test_the_help_names_the_command(softcat: Softcat) -> None:
    assert "Show the libraries and results that are kept, or clear them." in softcat("--help").out
