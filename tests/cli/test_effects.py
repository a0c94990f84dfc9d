"""``softcat effects`` as a user meets it: files, tables, all bundled scenes, refusals, interruption."""

from __future__ import annotations

import csv
import json
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.studies.pricing import EVERYTHING
from tests.cli.in_process import Softcat, sets

NAMES = [effect.name for effect in REGISTRY]
FILES = {"effects.json", "effects.csv", "effects.png", "scene.toml"}
QUICK = ("numerics.cells=4", "run.frames=4", "run.duration=0.02 s")
BASE = ("inertia", "bending", "viscous-stress")
BARE = (*QUICK, f"run.effects={json.dumps(BASE)}")
PNG = b"\x89PNG"
KEYS = {
    "effect", "in_force", "also", "change", "change_final", "own_change", "share", "estimate",
    "states_ratio", "instructions_ratio", "time_ratio", "reason",
}  # fmt: skip


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "160")
    return Softcat(monkeypatch, capsys)


def test_files_and_what_they_hold(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "deep" / "out"
    done = softcat("effects", "cold-honey", "-o", str(output), *sets(*BARE))
    assert (done.status, done.err) == (0, "")
    assert {path.name for path in output.iterdir()} == FILES
    assert all(name in done.out for name in (*NAMES, EVERYTHING, f"to {output}"))
    assert (output / "effects.png").read_bytes().startswith(PNG)
    scene = sc.load_scene("cold-honey", BARE)
    assert sc.load_scene(output / "scene.toml") == scene
    found = json.loads((output / "effects.json").read_text())
    assert (found["scene"], found["title"], found["cells"]) == ("cold-honey", scene.title, 4)
    assert found["base"]["effects"] == list(BASE)
    assert [row["effect"] for row in found["effects"]] == NAMES
    assert [row["effect"] for row in found["effects"] if row["in_force"]] == list(BASE)
    rows = [*found["effects"], found["everything"]]
    assert all(set(row) >= KEYS for row in rows)
    assert all((row["run"] is None) == bool(row["reason"]) for row in rows)
    with (output / "effects.csv").open(newline="") as stream:
        table = list(csv.DictReader(stream))
    assert [line["effect"] for line in table] == [*NAMES, EVERYTHING]
    for line, row in zip(table, rows, strict=True):
        for key in ("change", "own_change", "estimate", "time_ratio"):
            assert (float(line[key]) if line[key] else None) == row[key]
        assert (line["outcome"] or None) == (row["run"] and row["run"]["outcome"])


def test_quiet_is_silent_and_tells_the_change_of_the_runs_themselves(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("effects", "cold-honey", "-q", "-o", str(tmp_path), *sets(*BARE))
    assert (done.status, done.out, done.err) == (0, "", "")
    found = json.loads((tmp_path / "effects.json").read_text())
    grid = (*QUICK, f"numerics.grading={found['grading']!r}")
    base, still = (
        sc.simulate(sc.load_scene("cold-honey", [*grid, f"run.effects={json.dumps(names)}"])).data.midpoint.values
        for names in (BASE, BASE[1:])
    )
    (inertia,) = (row for row in found["effects"] if row["effect"] == "inertia")
    scale = abs(base).max()
    assert found["base"]["midpoint_largest_m"] == pytest.approx(scale, rel=1e-12)
    assert inertia["change"] == pytest.approx(abs(still - base).max() / scale, rel=1e-9)
    assert inertia["change_final"] == pytest.approx((still - base)[-1] / scale, rel=1e-9)


@pytest.mark.parametrize(
    ("scene", "changes", "outcome"),
    [
        # Straight, without weight at first, and without inertia: a string that has no shape.
        ("cold-honey", ("load.ramp=0.01 s", 'run.effects=["extensibility", "viscous-stress"]'), "no_equilibrium"),
        pytest.param(
            "edge-of-rupture",
            ("run.duration=0.7 s", 'run.effects=["inertia", "finite-stretch", "thinning", "viscous-flow"]'),
            "localised",
            marks=pytest.mark.slow,
        ),
    ],
)
def test_a_base_not_to_be_trusted_exits_1_and_still_writes(
    scene: str, changes: tuple[str, ...], outcome: str, softcat: Softcat, tmp_path: Path
) -> None:
    done = softcat("effects", scene, "-q", "-o", str(tmp_path), *sets(*QUICK, *changes))
    assert (done.status, done.out) == (1, "")
    assert done.err.startswith(f"softcat: {outcome}")
    assert {path.name for path in tmp_path.iterdir()} == FILES
    found = json.loads((tmp_path / "effects.json").read_text())
    assert found["base"]["outcome"] == outcome
    assert found["reading"].startswith("not to be trusted")


def test_all_bundled_scenes_in_one_table(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each change is made in every scene."""
    names = ("cold-honey", "gelatin-strand")
    monkeypatch.setattr("softcat_sym.scene.bundled.bundled_names", lambda: names)
    done = softcat("effects", "--bundled", "-q", "-o", str(tmp_path), *sets(*BARE))
    assert (done.status, done.out, done.err) == (0, "", "")
    files = {f"effects_{name}.{kind}" for name in names for kind in ("json", "png")}
    assert {path.name for path in tmp_path.iterdir()} == {*files, "pricing.md"}
    for name in names:
        found = json.loads((tmp_path / f"effects_{name}.json").read_text())
        assert (found["scene"], found["cells"], found["base"]["effects"]) == (name, 4, list(BASE))
        assert (tmp_path / f"effects_{name}.png").read_bytes().startswith(PNG)
    lines = (tmp_path / "pricing.md").read_text().splitlines()
    assert [line.split("|")[1].strip() for line in lines[2:]] == list(names)
    assert not any("not priced" in line for line in lines)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ((), "name one scene, or ask for --bundled"),
        (("cold-honey", "--bundled"), "name one scene, or ask for --bundled"),
        (("nowhere.toml",), "no such file"),
        (("FOLDER",), "a directory, not a file"),
        (("NOT-TOML",), "not TOML"),
        (("cold-honey", "--set", "nonsense"), "'nonsense' sets nothing"),
        (("cold-honey", "--set", "numerics.cells=2.5"), "numerics.cells"),
        (("cold-honey", "--set", 'run.effects=["inertai"]'), "did you mean 'inertia'"),
        (("ink-bridge", "--set", "model=small-deflection"), "material.law"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_bad_input_is_one_message_and_leaves_nothing(
    arguments: tuple[str, ...], said: str, softcat: Softcat, tmp_path: Path
) -> None:
    files = {"FOLDER": tmp_path / "folder", "NOT-TOML": tmp_path / "not.toml"}
    files["FOLDER"].mkdir()
    files["NOT-TOML"].write_text("span == 3")
    output = tmp_path / "out"
    done = softcat("effects", *(str(files.get(word, word)) for word in arguments), "-o", str(output))
    assert (done.status, done.out) == (2, "")
    assert said in done.err
    assert not output.exists()


@pytest.mark.parametrize("change", ["nonsense", "material.yeild_stress=3 Pa", 'run.effects=["inertai"]'])
def test_a_change_that_no_bundled_scene_takes_is_bad_input(change: str, softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "out"
    done = softcat("effects", "--bundled", "-o", str(output), "--set", change)
    assert (done.status, done.out) == (2, "")
    assert change.split("=")[0] in done.err
    assert not output.exists()


def test_a_directory_must_be_one(softcat: Softcat, tmp_path: Path) -> None:
    taken = tmp_path / "taken"
    taken.write_text("a file")
    for what in ("cold-honey", "--bundled"):
        for output in (taken, taken / "below"):
            done = softcat("effects", what, "-o", str(output))
            assert (done.status, done.out) == (2, "")
            assert f"{taken} is not a directory" in done.err
    assert taken.read_text() == "a file"


def test_interrupted_before_anything_is_finished_nothing_is_written(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*_: object) -> None:
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr("softcat_sym.studies.pricing.simulated", interrupted)
    output = tmp_path / "out"
    done = softcat("effects", "cold-honey", "-o", str(output), *sets(*BARE))
    assert (done.status, done.out) == (130, "")
    assert "interrupted; the same command goes on" in done.err
    assert not output.exists()


def test_what_was_finished_before_an_interruption_is_written(tmp_path: Path) -> None:
    output, command = tmp_path / "out", Path(sys.executable).with_name("softcat")
    asked = [
        str(command),
        "effects",
        "--bundled",
        "-q",
        "-o",
        str(output),
        *sets(*QUICK, 'run.effects=["inertia", "bending"]'),
    ]
    with subprocess.Popen(asked, stderr=subprocess.PIPE, text=True) as process:
        until = time.monotonic() + 60
        while not (output / "pricing.md").exists() and time.monotonic() < until:
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "interrupted" in said and "Traceback" not in said
    table = (output / "pricing.md").read_text().splitlines()[2:]
    finished = [line.split("|")[1].strip() for line in table]
    assert finished[0] == sc.bundled_names()[0] and len(finished) < len(sc.bundled_names())
    written = {f"effects_{name}.{kind}" for name in finished for kind in ("json", "png")}
    # The table is written before the files of its last scene, one at a time.
    assert {path.name for path in output.iterdir()} >= {f for f in written if finished[-1] not in f}
    for path in output.glob("*.json"):
        json.loads(path.read_text())
    assert all(path.suffix in {".md", ".json", ".png"} for path in output.iterdir())
