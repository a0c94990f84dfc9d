"""``softcat compare`` as a user meets it: files, table, exit status, Ctrl-C, refusals."""

from __future__ import annotations

import csv
import json
import signal
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from softcat_sym.cli import main
from softcat_sym.plotting.terminal import IntegrationProgress

SHORT = (
    *("--set", "groups.duration=10", "--set", "run.frames=11"),
    *("--set", "numerics.cells=10", "--set", "numerics.estimate=false", "--mesh", "8x2"),
)
FILES = {
    "compare.json",
    "scene.toml",
    "elements.npz",
    "compare_midpoint.png",
    "compare_shapes.png",
    "compare_plastic_rate.png",
    "compare_clamp_strain.png",
    "compare_errors.csv",
    "compare_midpoint.csv",
    "compare_shapes.csv",
    "compare_plastic_rate.csv",
    "compare_clamp_strain.csv",
} | ({"vtk"} if find_spec("meshio") else set())
THEORIES = ("filament", "published_material_closure", "published_printed_closure")


def compare(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int | str | None:
    """Exit status of the command, in this process."""
    monkeypatch.setattr(sys, "argv", ["softcat", "compare", *arguments])
    with pytest.raises(SystemExit) as left:
        main()
    return left.value.code


def test_files_table_and_document(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "deep" / "out"
    assert compare(monkeypatch, "continual-descent", "-o", str(output), *SHORT) == 0
    assert {path.name for path in output.iterdir()} == FILES
    printed = capsys.readouterr().out
    assert "8 × 2" in printed and "error at t = 10" in printed
    assert "plane stress" in printed  # as wide as thick
    found = json.loads((output / "compare.json").read_text())
    assert found["outcome"] == "solved"
    for who in ("elements", *THEORIES):
        assert found[who]["midpoint_final_m"] < 0
        assert found[who]["wall_s"] > 0
        assert found[who]["dofs"] > 0
    assert (found["elements"]["along"], found["elements"]["through"]) == (8, 2)
    assert len(found["warnings"]) == 1
    largest = abs(found["elements"]["midpoint_final_m"])
    for who in THEORIES:
        final = (found[who]["midpoint_final_m"] - found["elements"]["midpoint_final_m"]) / largest
        assert found["errors"][who]["at"][-1] == pytest.approx(final)
    assert found["errors"]["time_elastic"] == pytest.approx([1, 2, 5, 10])
    with (output / "compare_errors.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["what"] for row in rows] == ["error"] * 4 + ["mean error", "largest error"]
    assert [float(rows[k]["filament"]) for k in range(4)] == found["errors"]["filament"]["at"]


def test_ctrl_c_keeps_the_checkpoint_and_the_same_command_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ("arrested-overdamped", "--set", "run.effects=paper", *SHORT)
    straight, broken = tmp_path / "straight", tmp_path / "broken"
    assert compare(monkeypatch, *arguments, "-o", str(straight), "-q") == 0
    assert capsys.readouterr() == ("", "")

    def stop(self: IntegrationProgress, simulated_time: float, step_size: float | None) -> None:
        signal.raise_signal(signal.SIGINT)

    with monkeypatch.context() as patch:
        patch.setattr(IntegrationProgress, "update", stop)
        assert compare(monkeypatch, *arguments, "-o", str(broken)) == 130
    assert [path.name for path in broken.iterdir()] == ["elements.npz"]
    message = capsys.readouterr().err
    assert "interrupted; the same command goes on" in message and (broken / "elements.npz").is_file()
    assert compare(monkeypatch, *arguments, "-o", str(broken)) == 0
    assert "go on from" in capsys.readouterr().out
    for name in ("compare_midpoint.csv", "compare_clamp_strain.csv", "compare_plastic_rate.csv"):
        assert (straight / name).read_bytes() == (broken / name).read_bytes()


def test_an_answer_not_to_be_trusted_exits_1_and_still_writes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    changes = ("--set", "run.effects=paper", "--set", "run.frames=11", "--set", "numerics.cells=20", "--mesh", "4x2")
    assert compare(monkeypatch, "edge-of-rupture", "-o", str(tmp_path), "-q", *changes) == 1
    assert capsys.readouterr().err.startswith("softcat: localised")
    assert {path.name for path in tmp_path.iterdir()} == FILES
    assert json.loads((tmp_path / "compare.json").read_text())["outcome"] == "localised"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("no-yield", "--mesh", "64"), "no mesh"),
        (("no-yield", "--mesh", "0x4"), "0 elements along"),
        (("no-yield", "--mesh", "8x3"), "even number"),
        (("no-yield", "--mesh", "-8x2"), "no mesh"),
        (("no-yield", "--mesh", "8x2x2"), "no mesh"),
        (("ink-bridge",), "filament.section"),
        (("no-yield", "--set", "ends.left=pinned", "--set", "ends.right=pinned"), "ends.right"),
        (("no-such-scene",), "no-such-scene"),
        (("no-yield", "--set", "run.effects=['shaer']"), "did you mean 'shear'"),
        (("maxwell-slow", "--set", "model=small-deflection"), "model"),
        (("no-yield", "--set", "groups.gravity=0"), "gravity"),
    ],
)
def test_bad_input_is_one_message_and_leaves_nothing(
    arguments: tuple[str, ...],
    message: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    output = tmp_path / "out"
    assert compare(monkeypatch, *arguments, "-o", str(output)) == 2
    said = capsys.readouterr().err
    assert message in said and "Traceback" not in said
    assert not output.exists()


def test_a_checkpoint_of_something_else_is_refused_and_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ("no-yield", "-o", str(tmp_path), "-q", "--set", "run.effects=paper", *SHORT)
    assert compare(monkeypatch, *arguments) == 0
    kept = {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()}
    assert compare(monkeypatch, *arguments, "--fixed-face") == 2
    assert "another problem" in capsys.readouterr().err
    assert {path: path.read_bytes() for path in tmp_path.rglob("*") if path.is_file()} == kept
    taken = tmp_path / "taken"
    taken.write_text("a file")
    assert compare(monkeypatch, "no-yield", "-o", str(taken)) == 2
    assert "not a directory" in capsys.readouterr().err
