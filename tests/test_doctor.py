"""``softcat doctor``: it finds nothing wrong where all works, and what is wrong where it does not."""

from __future__ import annotations

import re
import warnings
from importlib import metadata
from pathlib import Path

import pytest

from softcat_sym import cache
from softcat_sym.cli import doctor
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.scene.reading import load_scene
from tests.common.in_process import Softcat

LINES = ("python", "softcat_sym", "required", "compiler", "cache", "results", *2 * ("self-test",), "result")


def heads(text: str) -> list[str]:
    """The names of the lines, in their order."""
    return [line[:12].strip() for line in text.splitlines() if line[:12].strip()]


@pytest.fixture(autouse=True)
def wide(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "400")


def test_where_all_is_well_it_says_so_and_is_quiet_if_asked(softcat: Softcat, monkeypatch: pytest.MonkeyPatch) -> None:
    done = softcat("doctor")
    assert (done.status, done.err) == (0, ""), done.out
    assert [name for name in heads(done.out) if name[0] != "["] == [*LINES]
    assert f"casadi {metadata.version('casadi')}" in done.out
    assert f"results     {cache.folder(cache.RESULTS)}" in done.out
    extras = set(metadata.metadata("softcat_sym").get_all("Provides-Extra", ()))
    assert {f"[{name}]" for name in extras} <= set(heads(done.out))
    assert "everything works" in done.out.splitlines()[-1]
    monkeypatch.setattr(doctor, "_tested", lambda backend, quiet: doctor.Check("self-test", backend))
    assert softcat("doctor", "-q") == type(done)(0, "", "")


def test_without_a_compiler_runs_are_interpreted_which_is_no_fault(
    softcat: Softcat, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("softcat_sym.codegen.compiler.of_a_wheel", lambda: iter(()))
    done = softcat("doctor")
    assert (done.status, "compiler    none: runs are interpreted" in done.out) == (0, True), done.out
    assert "to have it: install gcc or clang" in done.out and "compiled: not run, see compiler" in done.out


@pytest.mark.parametrize(
    ("variable", "text", "said"),
    [
        ("CC", "/nowhere/cc", "compiler: CC is '/nowhere/cc', which is no C compiler that runs; install gcc"),
        ("CC", "'gcc", "compiler: CC is .*No closing quotation"),
        ("SOFTCAT_CACHE_LIMIT", "much", "cache: SOFTCAT_CACHE_LIMIT is 'much'; accepted"),
        ("SOFTCAT_CACHE", "{file}/cache", "cache: .*file/cache/native cannot be used: .*; set SOFTCAT_CACHE"),
    ],
)
def test_what_is_named_and_does_not_work_is_a_fault_with_its_remedy(
    softcat: Softcat, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, variable: str, text: str, said: str
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv(variable, text.format(file=tmp_path / "file"))
    monkeypatch.setattr(doctor, "_tested", lambda backend, quiet: doctor.Check("self-test", backend))
    with warnings.catch_warnings():
        warnings.simplefilter("default")
        done = softcat("doctor", "-q")
    assert (done.status, done.out) == (1, "")
    *warned, line = done.err.splitlines()
    kept_elsewhere = variable == "SOFTCAT_CACHE" and find_compiler() is not None
    assert [text.partition(" in ")[0] for text in warned] == ["softcat: nothing is kept"] * kept_elsewhere
    assert re.match(f"softcat: {said}", line), line


def test_a_sag_that_is_not_the_exact_one_is_a_fault(softcat: Softcat, monkeypatch: pytest.MonkeyPatch) -> None:
    exact = doctor.exact_sag(load_scene("beam-viscometer"))
    monkeypatch.setattr(doctor, "exact_sag", lambda scene: exact / 1.01)
    done = softcat("doctor", "-q")
    assert done.status == 1 and "self-test: interpreted: sag 29.7" in done.err and "exact 29.4" in done.err
