"""Films of filaments: what people, spreadsheets and trackers write is read; what is wrong is one clear refusal."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.measurements import Measurements, Series, read_measurements
from softcat_sym.fitting.plausibility import checked
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from tests.common.written_films import FALL, TIME, rows_of, written

Floats = NDArray[np.float64]
HEADER = "time_s,midpoint_m\n"
ROWS = rows_of(TIME, FALL)


def read(folder: Path, text: str) -> Series:
    (series,) = read_measurements(written(folder, text)).series
    return series


def test_one_film_in_many_dialects(tmp_path: Path) -> None:
    dialects = {
        "plain": HEADER + ROWS,
        "BOM": "\ufeff" + HEADER.replace(",", " , ") + ROWS,
        "comments": "# camera 2\n\n" + (HEADER + ROWS).replace("\n", "\r\n") + "\n  # end\n",
        "semicolons": "Time [s];Midpoint (m)\n" + rows_of(TIME, FALL, separator=";"),
        "Excel": "sep=;\nt_s;midpoint_m\n" + rows_of(TIME, FALL, separator=";", comma=True),
        "tabs": "t_s\tmidpoint_m\n" + rows_of(TIME, FALL, separator="\t", comma=True),
        "others": "frame,midpoint_m,x_px,y_px,time_stamp,time_s,T_K\n" + rows_of(TIME * 0, FALL, *[TIME] * 5),
        "empty cells": HEADER + ROWS.replace("\n", ",,\n"),
    }
    for name, text in dialects.items():
        series = read(tmp_path, text)
        assert np.array_equal(series.time, TIME) and np.array_equal(series.midpoint, FALL), name
        assert (series.std, series.shapes, series.path) == (None, None, tmp_path / "film.csv"), name
        assert series.notes == (("Read decimal commas.",) if name in ("Excel", "tabs") else ()), name


SECONDS = {"s": "1", "ms": "1e-3", "us": "1e-6", "min": "60", "h": "3600"}
METRES = {"m": "1", "cm": "1e-2", "mm": "1e-3", "um": "1e-6", "µm": "1e-6", "inch": "0.0254"}


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    frames=st.lists(
        st.tuples(st.integers(0, 10**6), st.integers(-(10**6), 10**6), st.integers(1, 99)),
        min_size=5,
        max_size=12,
        unique_by=lambda frame: frame[0],
    ).filter(lambda frames: len({height for _, height, _ in frames}) > 1),
    clock=st.sampled_from(sorted(SECONDS)),
    ruler=st.sampled_from(sorted(METRES)),
    dialect=st.sampled_from([(",", False), (";", False), (";", True), ("\t", True)]),
    name=st.sampled_from(["midpoint", "sag", "deflection"]),
)
def test_units_order_and_dialect_do_not_change_the_film(
    tmp_path: Path, frames: list[tuple[int, int, int]], clock: str, ruler: str, dialect: tuple[str, bool], name: str
) -> None:
    separator, comma = dialect
    header = separator.join([f"time_{clock}", f"{name}_{ruler}", f"{name}_std_{ruler}"]) + "\n"
    time, height, std = (np.array(column) / 100 for column in zip(*frames, strict=True))
    series = read(tmp_path, header + rows_of(time, height, std, separator=separator, comma=comma))
    order, down = np.argsort(time), -1.0 if name != "midpoint" else 1.0
    assert series.std is not None
    np.testing.assert_allclose(series.time, time[order] * float(SECONDS[clock]), rtol=1e-15)
    np.testing.assert_allclose(series.midpoint, down * height[order] * float(METRES[ruler]), rtol=1e-15)
    np.testing.assert_allclose(series.std, std[order] * float(METRES[ruler]), rtol=1e-15)
    note = "".join(series.notes).lower()
    assert ("sorted" in note, "downwards by its name" in note) == (not np.all(np.diff(time) > 0), down < 0)


REFUSED = [
    ("# only a comment\n", "holds no data"),
    ("time,midpoint\n" + ROWS, "2 faults.*'time': no unit.*'midpoint': no unit in its name; accepted: midpoint_m"),
    ("tiem_s,midpiont_m\n" + ROWS, "is it what is called 'tiem_s'.*is it what is called 'midpiont_m'"),
    ("time_s|midpoint_m\n", "separated by commas, semicolons, tabs or blanks"),
    ("frame,midpoint_px\n" + ROWS, "frames without a frame rate.*'midpoint_px': pixels, which"),
    ("time_m,midpoint_s\n" + ROWS, "'m' is a length, not a time.*'s' is a time, not a length"),
    ("time_s,midpoint_m,sag [bananas]\n" + ROWS, r"column 'sag \[bananas\]': unknown unit 'bananas'"),
    ("time_s,midpoint_m,midpoint_std_bananas\n" + ROWS, "unknown unit 'bananas'"),
    ("time_s,midpoint_m,x_m,y_m\n", "points of whole shapes beside midpoint; accepted: two files"),
    ("time_s,y_m\n", "no column x among"),
    ("time_s,x_m\n", "no column y among"),
    ("time_s,x_m,y_m\n1,0,0\n", "1 point; accepted: at least 5"),
    (HEADER + ROWS + "1,2,3\n", "line 22: 3 cells under 2 names.*decimal commas need"),
    (HEADER + ROWS + "x,inf\n-1e999,1_0\n", "4 faults.*line 22, time_s: 'x' is not a.*midpoint_m: inf is not fin"),
    ("t_s;midpoint_m\n1.000,5;2\n", "line 2, t_s: '1.000,5' is not a number"),
    (HEADER + '"1,2\n' + "1" * 200_000 + ",2\n", "line 3, time_s: inf is not finite"),
    (HEADER + ROWS + "1,-2e12\n", "beyond anything measured"),
    ("time_s,midpoint_m,midpoint_std_m\n0,0,0\n1,1,-2\n", "line 2, midpoint_std_m: 0 is.*line 3.*-2 is not positive"),
    (HEADER + ROWS + "2,\n" * 10, "10 of 30 rows without a number .line 22,.* ....; accepted: .*two thirds"),
    (HEADER + rows_of(TIME, 0 * TIME - 3e-3), "-0.003 m at every time: nothing moves"),
    (HEADER + ROWS + "0.5,-0.01\n0.50000000000001,-0.02\n", "line 11, line 22, line 23: .*time, 0.5 s; .*one file"),
    (HEADER + rows_of(TIME - 0.5, FALL), "9 rows before time 0 .*the filament moves already"),
    (HEADER + rows_of(TIME - 9, FALL), "all times are before 0"),
    ("# filament.spam = 3\n" + HEADER + ROWS, "line 1, filament.spam: unknown key .did you mean 'span'"),
    ("# filamnet.span = 3 m\n" + HEADER + ROWS, "filamnet.span: unknown key .did you mean table 'filament'"),
    ("# filament.span 3 m\n" + HEADER + ROWS, "line 1, filament.span: sets nothing; accepted: key = value"),
    ("# load.ramp =\n" + HEADER + ROWS, "sets nothing"),
    ("# load.ramp = 1 s\n" * 2 + HEADER + ROWS, "line 2, load.ramp: set again"),
    (HEADER + "a,b\n" * 9, "18 faults.*and 10 more"),
]


def test_a_bad_file_is_one_clear_refusal(tmp_path: Path) -> None:
    for text, message in REFUSED:
        path = written(tmp_path, text)
        with pytest.raises(SoftcatError, match=rf"(?s)measurements {path}: .*{message}"):
            read_measurements(path)
    fine, short = written(tmp_path, HEADER + ROWS), written(tmp_path, HEADER, "short.csv")
    latin = tmp_path / "latin.csv"
    latin.write_bytes("time_s,midpoint_µm\n".encode("latin-1"))
    with pytest.raises(SoftcatError) as refused:
        read_measurements([fine, tmp_path / "nowhere.csv", tmp_path, latin, short])
    words = ("no such file", "a directory", "line 1: no rows", "short.csv: 1 fault")
    assert all(text in str(refused.value) for text in words) and str(fine) not in str(refused.value)
    for paths, message in (([fine, tmp_path / "." / "film.csv"], "named twice"), ([], "no file")):
        with pytest.raises(SoftcatError, match=message):
            read_measurements(paths)
    assert len(read_measurements([str(fine), written(tmp_path, HEADER + ROWS, "again.csv")]).series) == 2


@pytest.fixture(scope="module")
def scene() -> Scene:
    """Span 0.2 m, duration 2.86 s, sqrt(L/g) = 0.143 s."""
    return load_scene("maxwell-slow")


def of_checked(time: Floats, midpoint: Floats, scene: Scene) -> Series:
    return checked(Measurements.of(time, midpoint), scene).series[0]


def test_wrong_units_are_named_and_what_is_odd_is_remarked_on(scene: Scene) -> None:
    for time, length, message in (
        (1.0, 1000.0, r"-20 m at 1 s, 100 times the 0.2 m .*-0.02 m would do, as of mm in a column named for m"),
        (1.0, 1e9, r"-20 m would do|as of um|at most 2 m from the supports' level$"),
        (
            1000.0,
            1.0,
            r"time: the last time is 1000 s, long after the end .*1 s would do, as of ms in a column named for s",
        ),
        (1e-3, 1.0, r"time: the last time is 0.001 s, before any .*1 s would do, as of s in a column named for ms"),
        (5e-3, 1.0, r"moves by 0.01995 m within 0.005 s, in which a free body falls 0.000123 m.*as of s in a col"),
    ):
        with pytest.raises(SoftcatError, match=message):
            of_checked(time * TIME, length * FALL, scene)
    for clock, height, remark in (
        (TIME, 1e-6 * FALL, "less than a camera can resolve: is the unit right"),
        (TIME, 30 * FALL, "reaches -0.6 m, 3 times the length of the filament: is the unit right"),
        (TIME + 50, FALL, "begins at 50.05 s and is shorter than that: is time 0 the release"),
        (TIME / 40, FALL, "is time 0 the release, and the supports' level the zero"),
    ):
        series = of_checked(clock, height, scene)
        assert np.array_equal(series.midpoint, height) and any(remark in note for note in series.notes), remark
