"""Bad measurements: one clear error each, and nothing written; what can be mended without a guess is mended, and said.

Through files, `fit` and ``softcat fit``.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.fit import Fit, fit
from tests.cli.in_process import Softcat

from .table import show

SCENE = {"run.effects": "paper", "numerics.cells": 6, "run.frames": 61}
HEADER = "time_s,midpoint_m\n"


@cache
def _scene() -> sc.Scene:
    return sc.load_scene("continual-descent", SCENE)


@cache
def _film() -> tuple[np.ndarray, np.ndarray]:
    """A film of 60 frames, on a 0.2 m span, with 1 % noise."""
    run = sc.simulate(_scene()).data
    height = run.midpoint.values[1:]
    noise = 0.01 * float(np.max(np.abs(height))) * np.random.default_rng(11).standard_normal(height.size)
    return run.time.values[1:], height + noise


def _rows(time: np.ndarray, height: np.ndarray) -> str:
    return "".join(f"{t:.9g},{y:.9g}\n" for t, y in zip(time, height, strict=True))


def _text(case: str) -> str:
    """The file of a case."""
    time, height = _film()
    k = np.arange(time.size)
    late = np.where(k == 40, 0.5 * height, height)
    return {
        "two points": HEADER + _rows(time[[9, 59]], height[[9, 59]]),
        "constant": HEADER + _rows(time, np.full(time.size, -0.02)),
        "header only": HEADER,
        "empty": "",
        "mostly NaN": HEADER + _rows(time, np.where(k % 3 > 0, np.nan, height)),
        "infinite": HEADER + _rows(time, np.where(k == 7, -np.inf, height)),
        "text in a cell": HEADER + _rows(time, height) + "2.1,blurred\n",
        "two heights at a time": HEADER + _rows(np.where(k == 40, time[50], time), late),
        "mm as m": HEADER + _rows(time, 1e3 * height),
        "5 m on 0.2 m": HEADER + _rows(time, 5 / 0.05 * height),
        "ms as s": HEADER + _rows(1e3 * time, height),
        "s as ms": "time_ms,midpoint_m\n" + _rows(time, height),
        "no unit": "time,midpoint\n" + _rows(time, height),
        "pixels": "time_s,midpoint_px\n" + _rows(time, 1e4 * height),
        "unknown unit": "time_s,midpoint_banana\n" + _rows(time, height),
        "a time as a length": "time_m,midpoint_s\n" + _rows(time, height),
        "no time": "frame,midpoint_m\n" + _rows(k.astype(float), height),
        "before the release": HEADER + _rows(time - 0.5, height),
        "from another level": HEADER + _rows(time, 0.3 + height),
        "a standard error of 0": "time_s,midpoint_m,midpoint_std_m\n"
        + "".join(f"{t:.9g},{y:.9g},0\n" for t, y in zip(time, height, strict=True)),
        "shapes beside the supports": "time_s,x_m,y_m\n"
        + "".join(f"{t:.9g},{0.2 * (i % 5):.9g},{y:.9g}\n" for i, (t, y) in enumerate(zip(time, height, strict=True))),
        "its own value of what is free": "# material.viscosity = 9 kPa*s\n" + HEADER + _rows(time, height),
        "its own misspelt value": "# filament.spam = 0.2 m\n" + HEADER + _rows(time, height),
        "as it should be": HEADER + _rows(time, height),
        "unsorted": HEADER + _rows(time[::-1], height[::-1]),
        "a row twice": HEADER + _rows(np.insert(time, 20, time[20]), np.insert(height, 20, height[20])),
        "a few NaN": HEADER + _rows(time, np.where(k % 20 == 0, np.nan, height)),
        "positive down": HEADER + _rows(time, -height),
        "sag": "time_s,sag_mm\n" + _rows(time, -1e3 * height),
        "decimal commas": "time_s;midpoint_mm\n" + _rows(time, 1e3 * height).replace(",", ";").replace(".", ","),
    }[case]


REFUSED = {
    "two points": "2 distinct times; accepted: at least 5",
    "constant": "-0.02 m at every time: nothing moves",
    "header only": "0 distinct times",
    "empty": "the file holds no data",
    "mostly NaN": "40 of 60 rows without a number",
    "infinite": "line 9, midpoint_m: -inf is not finite",
    "text in a cell": "line 62, midpoint_m: 'blurred' is not a number",
    "two heights at a time": "at the same time",
    "mm as m": "wrong unit? ",
    "5 m on 0.2 m": "times the 0.2 m that the filament is long",
    "ms as s": "ms in a column named for s",
    "s as ms": "s in a column named for ms",
    "no unit": "'time': no unit",
    "pixels": "'midpoint_px': pixels",
    "unknown unit": "unknown unit 'banana'",
    "a time as a length": "'m' is a length, not a time",
    "no time": "no column of times",
    "before the release": "before time 0",
    "from another level": "above the supports' level and falling",
    "a standard error of 0": "midpoint_std_m: 0 is not positive",
    "shapes beside the supports": "counted from halfway between the supports",
    "its own value of what is free": "free viscosity: set by",
    "its own misspelt value": "unknown key (did you mean 'span'",
}

MENDED = {
    "as it should be": "",
    "unsorted": "Sorted the rows by time",
    "a row twice": "Averaged the midpoints at 1 time",
    "a few NaN": "Left out 3 of 60 rows without a number",
    "positive down": "Turned the sign of midpoint",
    "sag": "Turned the sign of sag_mm",
    "decimal commas": "",
}


def _written(folder: Path, case: str) -> Path:
    path = folder / "film.csv"
    path.write_text(_text(case), encoding="utf-8")
    return path


def _fit(path: Path) -> Fit:
    return fit(path, _scene(), ["viscosity"], starts=0, profiles=False)


def test_a_bad_film_is_one_clear_error(tmp_path: Path) -> None:
    for case, wanted in REFUSED.items():
        path = _written(tmp_path, case)
        with pytest.raises(SoftcatError) as caught:
            _fit(path)
        said = str(caught.value)
        print(f"{case}: {said}")
        assert wanted in said
        assert str(path) in said
        # What is wrong, where, and what would be accepted.
        assert "accepted: " in said


@pytest.mark.parametrize("case", MENDED)
def test_what_needs_no_guess_is_mended_and_said(case: str, tmp_path: Path) -> None:
    found, wanted = _fit(_written(tmp_path, case)), _fit(_written(tmp_path, "as it should be"))
    ours, theirs = found.parameters["viscosity"], wanted.parameters["viscosity"]
    show("", ["film", "viscosity", "undisturbed", "said"], [[case, ours.value, theirs.value, " ".join(found.notes)]])
    assert len(found.notes) == bool(MENDED[case])
    assert MENDED[case] in "".join(found.notes)
    assert ours.value is not None
    assert theirs.value is not None
    assert theirs.std is not None
    # Three frames fewer are not the same answer; everything else is, to the digits of the file.
    allowed = theirs.std if case == "a few NaN" else 1e-4 * theirs.value
    assert abs(ours.value - theirs.value) < allowed
    assert abs(ours.value - ours.typical) < 4 * theirs.std


def test_files_that_are_not_there_or_not_text(tmp_path: Path) -> None:
    absent, binary = tmp_path / "absent.csv", tmp_path / "binary.csv"
    binary.write_bytes(b"\x89PNG\r\n\x1a\n\x00\x00\xff")
    for path, said in ((absent, "no such"), (tmp_path, "directory"), (binary, "text")):
        with pytest.raises(SoftcatError, match=said):
            _fit(path)


def test_the_faults_of_all_films_come_at_once(tmp_path: Path) -> None:
    paths = []
    for case in ("constant", "two points", "as it should be"):
        paths.append(tmp_path / f"{case}.csv")
        paths[-1].write_text(_text(case), encoding="utf-8")
    with pytest.raises(SoftcatError) as caught:
        fit(paths, _scene(), ["viscosity"], starts=0)
    assert "nothing moves" in str(caught.value)
    assert "2 distinct times" in str(caught.value)
    assert "as it should be.csv" not in str(caught.value)


COMMANDS = {
    "free unknown": (["--free", "viscosty"], "viscosty"),
    "free twice": (["--free", "viscosity", "--free", "viscosity"], "named twice"),
    "bounds the wrong way": (["--free", "viscosity", "--bounds", "viscosity=9e4:1 Pa*s"], "the lower one first"),
    "bounds of what is not free": (["--free", "viscosity", "--bounds", "density=1:2 kg/m^3"], "not free"),
    "an unknown loss": (["--free", "viscosity", "--loss", "huber"], "huber"),
    "no such scene": (["--free", "viscosity", "--scene", "continual-decent"], "continual-d"),
}


def test_the_command_refuses_with_status_2_and_writes_nothing(softcat: Softcat, tmp_path: Path) -> None:
    for case in ("two points", "constant", "5 m on 0.2 m", "from another level", "text in a cell"):
        assert REFUSED[case] in refused(softcat, tmp_path, case, ["--free", "viscosity"])


def test_the_command_refuses_what_it_cannot_do(softcat: Softcat, tmp_path: Path) -> None:
    for arguments, said in COMMANDS.values():
        assert said in refused(softcat, tmp_path, "as it should be", arguments)


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def refused(softcat: Softcat, folder: Path, case: str, arguments: list[str]) -> str:
    path, output = _written(folder, case), folder / "out"
    scene = [] if "--scene" in arguments else ["--scene", "continual-descent"]
    done = softcat("fit", str(path), *scene, *arguments, "--set", "run.effects=paper", "-o", str(output))
    assert (done.status, done.out, output.exists()) == (2, "", False)
    return " ".join(done.err.split())
