"""The gallery of scenes: what each lesson says is true of the run, the files, going on, interruption."""

from __future__ import annotations

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from matplotlib.image import imread

import softcat_sym as sc
from softcat_sym.plotting.gallery import DOCUMENT, contact_sheet, kept_exhibits
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.scene.bundled import bundled_lesson, bundled_text
from softcat_sym.studies.gallery import asked_of, exhibit_of
from tests.cli.in_process import Softcat

FINAL = {"gallery.html", "gallery.png", "gallery.csv", "gallery.json"}
QUICK = ("--set", "numerics.cells=4", "--set", "run.frames=5", "--set", "run.effects=paper")

UNITS = {"um": 1e-6, "mm": 1e-3, "": 1.0, "%": 0.01, "s": 1.0}


def _y(run: Trajectory, frame: int) -> np.ndarray:
    return run.data.y.values[frame]


# What a lesson may state as a number, and where it is read in the run.
STATED: dict[str, Callable[[Trajectory], float]] = {
    r"largest sag (NUMBER) (um|mm)": lambda run: -run.data.midpoint.values.min(),
    r"sag of (NUMBER) (um|mm)": lambda run: -run.data.midpoint.values[-1],
    r"(NUMBER) (%) of its span deep": lambda run: -run.data.midpoint.values[-1] / run.scene.filament.span,
    r"(NUMBER) (mm) deep": lambda run: -run.data.midpoint.values[0],
    r"goes down to (NUMBER) (mm)": lambda run: -run.data.y.values.min(),
    r"holds? it (NUMBER) (mm) above": lambda run: run.data.midpoint.values[0],
    r"rises (NUMBER) (mm)": lambda run: _y(run, 0)[-1],
    r"stretched (NUMBER)() times": lambda run: run.data.stretch.values[-1].max(),
    r"in (NUMBER) (s)": lambda run: run.scene.run.duration,
    r"Index (NUMBER)()": lambda run: run.scene.material.index,
    r"G = (NUMBER)()": lambda run: (
        run.scene.filament.density * run.scene.load.gravity * run.scene.filament.span / run.scene.material.yield_stress
    ),
    r"10 ms to (NUMBER) (s)": lambda run: (
        run.scene.material.modes[-1].viscosity / run.scene.material.modes[-1].youngs_modulus
    ),
}
# Names and formulas that hold digits, and are no measurement; the shaken strand's two are held by tests of shaking.
NAMES = ("3/4 of its first frequency", "sqrt 2", "1/3 law", "4/3", "ASTM C598", "w L^3/(E I)", "c/(2 L)")
REGIMES = {
    r"\bstops\b": ("arrested-overdamped", "arrested-underdamped"),
    r"for ever": ("descending",),
    r"no fibre ever yields": ("no-yield",),
}


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "160")
    return Softcat(monkeypatch, capsys)


def check_lesson(lesson: str, run: Trajectory) -> int:
    """Hold every number and regime of a lesson against the run; how many numbers there were."""
    left, count = lesson, 0
    for name in NAMES:
        left = left.replace(name, "")
    for pattern, measured in STATED.items():
        found = re.search(pattern.replace("NUMBER", r"[\d.]*\d"), left)
        if found is None:
            continue
        text, unit = found[1], UNITS[found[2]]
        digits = len(text.partition(".")[2])
        # Rounded, from a run whose error is not estimated: half a digit and two per cent.
        allowed = 0.5 * 10.0**-digits * unit + 0.02 * float(text) * unit
        assert abs(measured(run) - float(text) * unit) <= allowed, f"{found[0]}: {measured(run)}"
        left, count = left.replace(found[0], ""), count + 1
    for pattern, regimes in REGIMES.items():
        assert not re.search(pattern, lesson) or run.summary["regime"] in regimes, (pattern, run.summary["regime"])
    refused = not run.outcome.is_success
    assert refused == lesson.startswith("Refused as "), run.outcome
    assert not refused or lesson.startswith(f"Refused as {run.outcome.name}:")
    left = left.replace("10 ms", "") if count else left
    assert not re.search(r"\d", left), f"a number that nothing checks: {left}"
    return count


@pytest.mark.parametrize("name", sc.bundled_names())
def test_every_scene_teaches_something_in_a_line(name: str) -> None:
    lesson = bundled_lesson(name)
    assert 30 <= len(lesson) <= 100
    assert lesson.endswith(".")
    assert lesson not in bundled_text(name).replace(f"# Lesson: {lesson}", "")


def test_no_two_lessons_are_the_same() -> None:
    assert len({bundled_lesson(name) for name in sc.bundled_names()}) == len(sc.bundled_names())


@pytest.mark.parametrize("name", ["cold-honey", "continual-descent", "slime-slope"])
def test_what_a_lesson_says_is_what_the_run_shows(name: str) -> None:
    _, run = exhibit_of(asked_of(name))
    assert check_lesson(bundled_lesson(name), run) >= 1


def test_a_lesson_that_is_not_true_is_noticed() -> None:
    _, run = exhibit_of(asked_of("cold-honey"))
    for wrong in (
        "It hangs 40 % of its span deep.",
        "It stops at once.",
        "Refused as localised: no.",
        "It has 7 of something.",
    ):
        with pytest.raises(AssertionError):
            check_lesson(wrong, run)


@pytest.mark.slow
@pytest.mark.parametrize("name", sc.bundled_names())
def test_what_every_lesson_says_is_what_the_run_shows(name: str) -> None:
    _, run = exhibit_of(asked_of(name))
    check_lesson(bundled_lesson(name), run)


def test_the_list_names_each_scene_with_its_lesson(softcat: Softcat) -> None:
    done = softcat("scenes")
    assert (done.status, done.err) == (0, "")
    lines = done.out.splitlines()
    assert [line.split()[0] for line in lines[::2]] == list(sc.bundled_names())
    assert [line.strip() for line in lines[1::2]] == [bundled_lesson(name) for name in sc.bundled_names()]


def test_files_and_what_they_hold(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "deep" / "gallery"
    names = ["cold-honey", "stretched-rubber-band"]
    done = softcat("scenes", "-o", str(output), "--only", names[0], "--only", names[1], *QUICK)
    assert (done.status, done.err) == (0, "")
    assert {path.name for path in output.iterdir()} == FINAL | {f"{n}.{e}" for n in names for e in ("png", "toml")}
    found = json.loads((output / DOCUMENT).read_text())
    assert [row["name"] for row in found["scenes"]] == names
    changes = [text for text in QUICK if text != "--set"]
    honey = sc.simulate(sc.load_scene(names[0], [*changes, "numerics.estimate=false"]))
    row = found["scenes"][0]
    assert row["sag_final_m"] == pytest.approx(-honey.summary["midpoint_final_m"], rel=1e-9)
    assert (row["regime"], row["outcome"], row["law"]) == ("viscous", "solved", "newtonian")
    assert sc.load_scene(output / "cold-honey.toml") == sc.load_scene(names[0], changes)
    with (output / "gallery.csv").open(newline="") as stream:
        table = list(csv.DictReader(stream))
    assert [float(line["sag_final_m"]) for line in table] == [one["sag_final_m"] for one in found["scenes"]]
    page = (output / "gallery.html").read_text()
    assert page.count("data:image/png;base64,") == 2
    assert not re.search(r'(src|href)="(?!data:)', page), "the page needs another file"
    tiles = [imread(output / f"{name}.png")[..., :3] for name in names]
    sheet = imread(output / "gallery.png")[..., :3]
    assert np.array_equal(sheet, np.concatenate(tiles, axis=1))


def test_sheet_has_rows() -> None:
    from softcat_sym.plotting.style import new_figure, png

    one = png(new_figure(0.2, 0.1))
    high, wide, _ = imread(BytesIO(contact_sheet([one] * 7, columns=3)), format="png").shape
    assert (high, wide) == (3 * 15, 3 * 30)


def test_finished_scenes_are_not_run_again_unless_they_changed(softcat: Softcat, tmp_path: Path) -> None:
    command = ("scenes", "-o", str(tmp_path), "--only", "cold-honey", *QUICK)
    assert softcat(*command).status == 0
    first = json.loads((tmp_path / DOCUMENT).read_text())["scenes"][0]
    again = softcat(*command)
    assert "(1 of them were there)" in again.out
    assert json.loads((tmp_path / DOCUMENT).read_text())["scenes"][0] == first
    assert "were there" not in softcat(*command, "--set", "run.duration=0.1 s").out
    changed = json.loads((tmp_path / DOCUMENT).read_text())["scenes"][0]
    assert changed["sag_final_m"] < first["sag_final_m"]


@pytest.mark.parametrize("spoilt", ["", "{}", '{"scenes": [{"name": "x"}]}', '{"scenes": 3}'])
def test_what_cannot_be_read_is_not_kept(tmp_path: Path, spoilt: str) -> None:
    (tmp_path / DOCUMENT).write_text(spoilt)
    assert kept_exhibits(tmp_path) == {}
    assert kept_exhibits(tmp_path / "nowhere") == {}


def test_faults_write_nothing(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "out"
    for arguments in (("--only", "cold-hony"), ("--set", "filament.spam=1 m")):
        done = softcat("scenes", "-o", str(output), *arguments)
        assert done.status == 2
        assert done.err
        assert not output.exists()
    assert softcat("scenes", "--set", "run.frames=5").status == 2


def test_ctrl_c_keeps_what_is_finished_and_the_same_command_goes_on(tmp_path: Path) -> None:
    output = tmp_path / "out"
    # The compiler is not needed for this, and would be what is interrupted.
    command = [sys.executable, "-c", "from softcat_sym.cli import main; main()", "scenes", "-o", str(output)]
    command += ["--only", "cold-honey", "--only", "no-yield", "--set", "numerics.backend=interpreted"]
    command += ["--set", "run.effects=paper", "--set", "numerics.cells=10"]
    started = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env={**os.environ})
    limit = time.monotonic() + 60
    while not (output / DOCUMENT).exists() and started.poll() is None and time.monotonic() < limit:
        time.sleep(0.005)
    time.sleep(0.3)  # the second, of some two seconds, is under way
    started.send_signal(signal.SIGINT)
    _, said = started.communicate(timeout=60)
    assert started.returncode == 130, said
    assert "1 of 2 scenes are in" in said
    assert {path.name for path in output.iterdir()} == {"cold-honey.png", "cold-honey.toml", DOCUMENT}
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=120)
    assert "2 scenes (1 of them were there)" in done.stdout
