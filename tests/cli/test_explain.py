"""``softcat explain`` as a user meets it: what is printed, what is written, what is refused."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.effects.registry import REGISTRY
from tests.cli.in_process import Softcat, sets

FILES = {"explain.json", "equations.tex", "scene.toml"}
KEYS = {
    "title", "law", "model", "closure", "accuracy", "groups", "regime", "sag", "strain",
    "effects", "equations", "unknowns", "graph", "integrator", "warnings",
}  # fmt: skip
SMALL = ("numerics.cells=5",)


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Softcat:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "160")
    return Softcat(monkeypatch, capsys)


def test_files_and_what_they_hold(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "deep" / "out"
    done = softcat("explain", "arrested-overdamped", "-o", str(output), *sets(*SMALL))
    assert (done.status, done.err) == (0, "")
    assert {path.name for path in output.iterdir()} == FILES
    assert f"wrote explain.json, equations.tex, scene.toml to {output}" in done.out
    scene = sc.load_scene("arrested-overdamped", SMALL)
    assert sc.load_scene(output / "scene.toml") == scene
    found = json.loads((output / "explain.json").read_text())
    assert set(found) >= KEYS
    # As Python tells it, to the last digit.
    assert found == json.loads(json.dumps(sc.explain(scene).to_dict()))
    assert found["graph"]["cells"] == 5
    assert {group["name"]: group["value"] for group in found["groups"]}["G"] == pytest.approx(0.4, rel=1e-9)
    assert [one["effect"] for one in found["effects"]] == [effect.name for effect in REGISTRY]
    assert all(set(one) >= {"in_force", "estimate", "meaning", "reason"} for one in found["effects"])
    tex = (output / "equations.tex").read_text()
    assert tex.count(r"\begin{equation*}") == len(found["equations"])
    for one in found["effects"]:
        assert one["effect"] in done.out or one["estimate"] is None
    assert "Groups" not in done.out
    whole = softcat("explain", "arrested-overdamped", "--verbose", *sets(*SMALL))
    for one in found["effects"]:
        assert one["effect"] in whole.out and one["meaning"][:12] in whole.out
    for title in ("Groups", "Expected", "Effects", "Equations in force", "Numerics", found["regime"]["name"]):
        assert title in whole.out


def test_without_a_directory_nothing_is_written(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("explain", "cold-honey", *sets(*SMALL))
    assert (done.status, done.err) == (0, "")
    assert "viscous-stress" in done.out and "wrote" not in done.out
    assert not list(tmp_path.iterdir())


def test_quiet_is_silent_and_still_writes(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("explain", "cold-honey", "-q", "-o", str(tmp_path / "out"), *sets(*SMALL))
    assert (done.status, done.out, done.err) == (0, "", "")
    assert {path.name for path in (tmp_path / "out").iterdir()} == FILES


def test_changes_reach_what_is_told(softcat: Softcat, tmp_path: Path) -> None:
    named = 'run.effects=["inertia", "bending"]'
    asked = sets(named, "numerics.cells=7", "material.youngs_modulus=5 MPa")
    assert softcat("explain", "arrested-overdamped", "-q", "-o", str(tmp_path), *asked).status == 0
    found = json.loads((tmp_path / "explain.json").read_text())
    assert [one["effect"] for one in found["effects"] if one["in_force"]] == ["inertia", "bending"]
    assert found["graph"]["cells"] == 7
    assert dict(found["graph"]["parameters"])["youngs_modulus"] == 5e6
    assert "viscosity" not in dict(found["graph"]["parameters"])


def test_the_written_scene_is_explained_alike(softcat: Softcat, tmp_path: Path) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    assert softcat("explain", "glass-rod", "-q", "-o", str(first), *sets(*SMALL)).status == 0
    assert softcat("explain", str(first / "scene.toml"), "-q", "-o", str(second)).status == 0
    for name in ("explain.json", "equations.tex"):
        assert (first / name).read_bytes() == (second / name).read_bytes()
    # But for the remarks on what was converted.
    assert sc.load_scene(first / "scene.toml") == sc.load_scene(second / "scene.toml")


def test_nothing_is_integrated(softcat: Softcat, monkeypatch: pytest.MonkeyPatch) -> None:
    """A scene that takes minutes to run, or ends in rupture, is explained at once."""
    from softcat_sym.solvers.run import Prepared

    monkeypatch.delattr(Prepared, "solve")
    done = softcat("explain", "edge-of-rupture", *sets("numerics.cells=5", "run.duration=1000 s"))
    assert (done.status, done.err) == (0, "")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("nowhere.toml",), "no such file"),
        (("no-yeild",), "did you mean 'no-yield'"),
        (("FOLDER",), "a directory, not a file"),
        (("NOT-TOML",), "not TOML"),
        (("EMPTY",), "empty"),
        (("cold-honey", "--set", "nonsense"), "'nonsense' sets nothing"),
        (("cold-honey", "--set", "run.colour=red"), "run.colour"),
        (("cold-honey", "--set", "numerics.cells=six"), "numerics.cells: 'six' is not a whole number"),
        (("cold-honey", "--set", 'run.effects=["magic"]'), "unknown effect 'magic'"),
        (("cold-honey", "--set", "run=3"), "run: 3 is not a table"),
        (("cold-honey", "no-yield"), "unexpected extra argument"),
        (("cold-honey", "--frames", "3"), "No such option"),
        ((), "Missing argument"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_bad_input_is_one_message_and_leaves_nothing(
    arguments: tuple[str, ...], said: str, softcat: Softcat, tmp_path: Path
) -> None:
    files = {"FOLDER": tmp_path / "folder", "NOT-TOML": tmp_path / "not.toml", "EMPTY": tmp_path / "empty.toml"}
    files["FOLDER"].mkdir()
    files["NOT-TOML"].write_text("span == 3")
    files["EMPTY"].write_text("")
    output = tmp_path / "out"
    done = softcat("explain", *(str(files.get(word, word)) for word in arguments), "-o", str(output))
    assert (done.status, done.out) == (2, "")
    assert said in done.err
    assert not output.exists()


def test_a_place_that_cannot_be_written_is_refused(softcat: Softcat, tmp_path: Path) -> None:
    taken = tmp_path / "taken"
    taken.write_text("a file")
    for output in (taken, taken / "below"):
        done = softcat("explain", "cold-honey", "-o", str(output))
        assert (done.status, done.out) == (2, "")
        assert f"{taken} is not a directory" in done.err
    assert taken.read_text() == "a file"


def test_the_installed_command() -> None:
    command = str(Path(sys.executable).with_name("softcat"))
    done = subprocess.run(
        [command, "explain", "cold-honey", *sets(*SMALL)], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "viscous-stress: on" in done.stdout
