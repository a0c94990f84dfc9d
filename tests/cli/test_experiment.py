"""``softcat experiment`` as a user meets it: files, the limit of the sag, the critical span, refusals."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

import softcat_sym as sc
from tests.cli.in_process import Softcat, sets

SCENE = ("maxwell-fast", *sets("run.effects=paper", "groups.duration=6", "numerics.cells=10"))
FILM = ("--free", "viscosity", "--noise", "10 um", "--duration", "0.2:0.8 s", "--frame-rate", "10:200 Hz")
FILES = {"experiment.json", "scene.toml", "experiment.csv", "experiment.png"}


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def test_files_and_what_is_said(softcat: Softcat, tmp_path: Path) -> None:
    (tmp_path / "critical_span.png").write_bytes(b"of an earlier design")
    done = softcat("experiment", *SCENE, *FILM, "-o", str(tmp_path))
    assert done.status == 0, done.err
    assert {path.name for path in tmp_path.iterdir()} == FILES
    found = json.loads((tmp_path / "experiment.json").read_text())
    best = found["best"]
    assert found["text"][0] in done.out and "Film a span of 200 mm" in done.out
    assert best["worst"] == best["errors"]["material.viscosity"]
    assert found["gain"] == pytest.approx(found["as_given"]["worst"] / best["worst"])
    scene = sc.load_scene(str(tmp_path / "scene.toml"))
    assert (scene.run.duration, scene.run.frames) == (pytest.approx(best["duration_s"]), best["frames"])
    rows = list(csv.DictReader((tmp_path / "experiment.csv").read_text().splitlines()))
    assert float(rows[0]["worst"]) == best["worst"]
    # The sag that is told is that of a run.
    assert best["sag_m"] == pytest.approx(float(abs(sc.simulate(scene).data.midpoint.values).max()), rel=0.01)


@pytest.mark.slow
def test_a_limit_of_the_sag_noise_of_the_sag_and_the_critical_span(softcat: Softcat, tmp_path: Path) -> None:
    limited = ("--max-sag", "2 mm", "--noise", "1 %", "--span", "0.1:0.2 m", "--sag", "4 mm", "-q")
    # The last of an option counts.
    done = softcat("experiment", *SCENE, *FILM, *limited, "-o", str(tmp_path))
    assert (done.status, done.out, done.err) == (0, "", "")
    assert {path.name for path in tmp_path.iterdir()} == FILES | {"critical_span.png", "critical_span.csv"}
    found = json.loads((tmp_path / "experiment.json").read_text())
    best, critical = found["best"], found["critical_span"]
    scene = sc.load_scene(str(tmp_path / "scene.toml"))
    assert float(abs(sc.simulate(scene).data.midpoint.values).max()) <= 2e-3
    assert found["noise_m"] == pytest.approx(0.01 * best["sag_m"])
    given = sc.load_scene("maxwell-fast", ["run.effects=paper", "groups.duration=6", "numerics.cells=10"])
    at_limit = given.replace({"filament.span": f"{critical['span_m']!r} m"})
    assert float(abs(sc.simulate(at_limit).data.midpoint.values).max()) == pytest.approx(4e-3, rel=0.01)
    assert set(critical["gradient"]) >= {"material.viscosity", "filament.density"}


BAD = {
    "scene": (("maxwell-fsat", *FILM), "maxwell-fsat"),
    "nothing free": ((*SCENE, "--noise", "1 um"), "--free"),
    "no noise": ((*SCENE, "--free", "viscosity"), "--noise"),
    "unknown": ((*SCENE, *FILM, "--free", "viscsity"), "did you mean"),
    "camera only": ((*SCENE, "--noise", "1 um", "--free", "time_offset"), "nothing that counts is free"),
    "noise of no unit": ((*SCENE, *FILM, "--noise", "10"), "noise"),
    "noise in s": ((*SCENE, *FILM, "--noise", "10 s"), "not a length"),
    "no noise at all": ((*SCENE, *FILM, "--noise", "0 %"), "not positive"),
    "noise in words": ((*SCENE, *FILM, "--noise", "few %"), "no percentage"),
    "reversed": ((*SCENE, *FILM, "--span", "50:5 mm"), "is above"),
    "three ends": ((*SCENE, *FILM, "--span", "5:10:20 mm"), "within filament.span"),
    "empty end": ((*SCENE, *FILM, "--thickness", ":2 mm"), "within filament.thickness"),
    "rate in s": ((*SCENE, *FILM, "--frame-rate", "1:2 s"), "frequency"),
    "thick": ((*SCENE, *FILM, "--thickness", "1:2 m"), "a thickness below the span"),
    "frames": ((*SCENE, *FILM, "--max-frames", "1"), "--max-frames"),
    "rough": ((*SCENE, *FILM, "--rough", "0.5"), "at least one"),
    "sag": ((*SCENE, *FILM, "--sag", "-1 mm"), "not positive"),
    "sag in words": ((*SCENE, *FILM, "--max-sag", "little"), "max_sag"),
    "sag too small": ((*SCENE, *FILM, "--max-sag", "1 nm"), "sags more than"),
    "set": ((*SCENE, *FILM, *sets("material.visosity=1 Pa*s")), "material.visosity"),
}


@pytest.mark.parametrize(("arguments", "message"), BAD.values(), ids=BAD)
def test_bad_input_is_one_message_and_leaves_nothing(
    arguments: tuple[str, ...], message: str, softcat: Softcat, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    done = softcat("experiment", *arguments, "-o", str(output))
    assert done.status == 2 and done.out == ""
    assert message in " ".join(done.err.replace("│", " ").split())
    assert not output.exists()
