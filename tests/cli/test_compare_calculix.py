"""``softcat compare --engine calculix`` as a user meets it: files, table, the deck alone, refusals, Ctrl-C."""

from __future__ import annotations

import csv
import json
import signal
import sys
from pathlib import Path

import pytest

from softcat_sym.cli import main
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.plotting.terminal import IntegrationProgress
from softcat_sym.reference import calculix
from softcat_sym.reference.calculix import find_calculix

SHORT = (
    *("--set", "groups.duration=10", "--set", "run.frames=11"),
    *("--set", "numerics.cells=10", "--set", "numerics.estimate=false", "--mesh", "6x2"),
)
NARROW = ("--set", "filament.width=60 um")
needs_calculix = pytest.mark.skipif(find_calculix() is None, reason="no CalculiX: apt-get install calculix-ccx")


def compare(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int | str | None:
    """Exit status of the command, in this process."""
    monkeypatch.setattr(sys, "argv", ["softcat", "compare", "continual-descent", *arguments])
    with pytest.raises(SystemExit) as left:
        main()
    return left.value.code


def files(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_deck_alone_needs_no_calculix(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("softcat_sym.reference.calculix.find_calculix", lambda: None)
    assert compare(monkeypatch, "-o", str(tmp_path / "out"), "--write-input-only", *SHORT) == 0
    assert files(tmp_path / "out") == {"scene.toml", "calculix/deck.inp"}
    assert "C3D20R" in (tmp_path / "out" / "calculix" / "deck.inp").read_text()
    assert "calculix/deck.inp" in capsys.readouterr().out


def test_missing_calculix_is_one_message_and_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("softcat_sym.reference.calculix.find_calculix", lambda: None)
    assert compare(monkeypatch, "-o", str(tmp_path / "out"), "--engine", "calculix", *SHORT) == 2
    message = capsys.readouterr().err
    assert "calculix-ccx" in message and "--write-input-only" in message and "Traceback" not in message
    assert not (tmp_path / "out").exists()


def test_what_the_elements_do_not_know_has_no_deck(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    changes = ("--set", "filament.section=circle", "--write-input-only")
    assert compare(monkeypatch, "-o", str(tmp_path / "out"), *changes) == 2
    assert "filament.section" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_varied_study_is_of_our_elements(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    asked = ("--engine", "calculix", "--vary", "groups.G=0.4,0.5")
    assert compare(monkeypatch, "-o", str(tmp_path / "out"), *asked) == 2
    assert "our own elements" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@needs_calculix
@pytest.mark.skipif(find_compiler() is None, reason="no C compiler: install gcc, or set CC")
def test_calculix_filament_and_elements_side_by_side(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "out"
    assert compare(monkeypatch, "-o", str(output), "--engine", "both", *SHORT, *NARROW) == 0
    own = {"compare.json", "compare_midpoint.csv", "compare_midpoint.png", "scene.toml", "elements.npz"}
    assert files(output) == own | {f"calculix/deck.{end}" for end in ("inp", "dat", "sta", "cvg")}
    assert "CalculiX 6 × 2" in capsys.readouterr().out
    found = json.loads((output / "compare.json").read_text())
    assert found["warnings"] == []
    with (output / "compare_midpoint.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == 11
    largest = abs(found["calculix"]["midpoint_final_m"])
    for who in ("filament", "elements"):
        assert float(rows[-1][f"{who}_m"]) == found[who]["midpoint_final_m"]
        apart = (found[who]["midpoint_final_m"] - found["calculix"]["midpoint_final_m"]) / largest
        assert found["errors"][who]["at"][-1] == pytest.approx(apart)
        assert abs(apart) < 0.05


@needs_calculix
def test_ctrl_c_writes_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def stop(self: IntegrationProgress, simulated_time: float, step_size: float | None) -> None:
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(IntegrationProgress, "update", stop)
    long = ("--set", "groups.duration=460", "--mesh", "32x4")
    assert compare(monkeypatch, "-o", str(tmp_path / "out"), "--engine", "calculix", *long, *NARROW) == 130
    assert "interrupted" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@needs_calculix
def test_what_was_finished_is_not_run_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Ctrl-C while the elements run: the same command goes on, without CalculiX, to the same numbers."""
    ran: list[str] = []
    own, execute = IntegrationProgress.update, calculix._execute

    def stop(self: IntegrationProgress, simulated_time: float, step_size: float | None) -> None:
        own(self, simulated_time, step_size)
        if ran == ["finished"]:
            signal.raise_signal(signal.SIGINT)

    def executed(program: str, folder: Path, progress: object) -> None:
        ran.append("begun")
        execute(program, folder, progress)
        ran[-1] = "finished"

    monkeypatch.setattr(calculix, "_execute", executed)
    whole, cut = tmp_path / "whole", tmp_path / "cut"
    asked = ("--engine", "both", *SHORT, *NARROW)
    assert compare(monkeypatch, "-o", str(whole), *asked) == 0
    ran.clear()
    with monkeypatch.context() as patch:
        patch.setattr(IntegrationProgress, "update", stop)
        assert compare(monkeypatch, "-o", str(cut), *asked) == 130
    assert "the same command goes on" in capsys.readouterr().err
    assert compare(monkeypatch, "-o", str(cut), *asked) == 0
    assert ran == ["finished"]
    assert (cut / "compare_midpoint.csv").read_bytes() == (whole / "compare_midpoint.csv").read_bytes()
