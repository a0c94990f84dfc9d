"""``softcat compare --vary`` as a user meets it: files, tables, Ctrl-C, refusals."""

from __future__ import annotations

import csv
import json
import math
import signal
from pathlib import Path

import pytest

from softcat_sym import progress
from softcat_sym.plotting.terminal import IntegrationProgress
from tests.cli.in_process import Softcat, sets

SHORT = sets("groups.duration=10", "run.frames=11", "numerics.cells=10", "filament.width=0.1 mm")
VARIED = ("compare", "continual-descent", *SHORT, "--mesh", "4x4", "--vary", "groups.delta=0.03,0.06,0.045")
TABLES = {"compare_vary_errors.csv", "compare_vary_cost.csv", "compare_vary_limit.csv"}
FILES = {"compare.json", "scene.toml", "elements", "compare_vary.png", *TABLES}


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def rows_of(path: Path) -> list[dict[str, str]]:
    with path.open(newline="") as stream:
        return list(csv.DictReader(stream))


def test_ctrl_c_keeps_what_is_finished_and_the_same_command_writes_the_files(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # However slow the machine, so that the screen holds errors only.
    monkeypatch.setattr(progress, "_PLAIN_DELAY", math.inf)
    output = tmp_path / "out"
    heard = []

    def stop(self: IntegrationProgress, simulated_time: float, step_size: float | None) -> None:
        heard.append(self.stages[-1].name)
        if heard[-1].startswith("groups.delta = 0.045, 4 x 4"):
            signal.raise_signal(signal.SIGINT)

    with monkeypatch.context() as patch:
        patch.setattr(IntegrationProgress, "update", stop)
        broken = softcat(*VARIED, "-o", str(output))
    assert broken.status == 130
    assert "interrupted; the same command goes on from" in broken.err
    # Two meshes of the first value, and what there was of the second.
    assert [path.name for path in output.iterdir()] == ["elements"]
    assert len(list((output / "elements").iterdir())) == 3
    assert heard[0].startswith("groups.delta = 0.03, 4 x 4 elements")
    done = softcat(*VARIED, "-o", str(output))
    assert (done.status, done.err) == (0, "")
    assert {path.name for path in output.iterdir()} == FILES
    assert "half the elements" in done.out and "Slender limit" in done.out and "Cost" in done.out
    found = json.loads((output / "compare.json").read_text())
    assert [one["value"] for one in found["values"]] == [0.03, 0.045, 0.06]
    for one in found["values"]:
        assert one["elements"]["midpoint_final_m"] < 0 and one["elements"]["wall_s"] > 0
        own = one["filament"]["midpoint_final_m"] / one["elements"]["midpoint_final_m"] - 1
        theory = one["theory_errors"]["filament"]
        assert theory["errors"][3] == pytest.approx(own, abs=1.01 * theory["grid"])
        assert theory["dofs_ratio"] == pytest.approx(one["elements"]["dofs"] / one["filament"]["dofs"])
    errors = rows_of(output / "compare_vary_errors.csv")
    assert len(errors) == 3 * (2 + 3)
    assert float(errors[2]["t_10"]) == found["values"][0]["theory_errors"]["filament"]["errors"][3]
    costs = rows_of(output / "compare_vary_cost.csv")
    assert float(costs[0]["solve_ratio"]) == 1.0 and int(costs[0]["dofs"]) > int(costs[1]["dofs"])
    limits = rows_of(output / "compare_vary_limit.csv")
    assert {row["theory"] for row in limits} == {
        "filament",
        *(f"published {c} closure" for c in ("material", "printed")),
    }


def test_quiet_and_a_variable_that_is_not_the_thickness(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "out"
    varied = ("compare", "continual-descent", *SHORT, "--mesh", "4x4", "--vary", "groups.V=2.6:260:2:log", "-q")
    done = softcat(*varied, "--set", "run.effects=paper", "-o", str(output))
    assert (done.status, done.out, done.err) == (0, "", "")
    assert {path.name for path in output.iterdir()} == FILES - {"compare_vary_limit.csv"}
    found = json.loads((output / "compare.json").read_text())
    assert found["slender_limit"] is None
    assert [set(one["theory_errors"]) for one in found["values"]] == [{"filament"}] * 2


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--vary", "groups.delta=0.03"), "has one value"),
        (("--vary", "groups.delta=0.03,0.06", "--mesh", "4x2"), "half as many must be a mesh too"),
        (("--vary", "groups.detla=0.03,0.06"), "detla"),
        (("--vary", "filament.section=rectangle,circle"), "filament.section"),
    ],
)
def test_refusals_write_nothing(softcat: Softcat, tmp_path: Path, arguments: tuple[str, ...], said: str) -> None:
    output = tmp_path / "out"
    done = softcat("compare", "continual-descent", *arguments, "-o", str(output))
    assert done.status == 2
    assert said in done.err
    assert not output.exists()
