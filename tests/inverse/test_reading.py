"""Reading films: what people, spreadsheets and trackers write is read, and what is wrong is one clear refusal."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.measurements import Series, read_measurements
from tests.inverse.written_films import FALL, TIME, rows_of, written

HEADER = "time_s,midpoint_m\n"
ROWS = rows_of(TIME, FALL)


def read(folder: Path, text: str) -> Series:
    (series,) = read_measurements(written(folder, text)).series
    return series


@pytest.mark.parametrize(
    "text",
    [
        HEADER + ROWS,
        "\ufeff" + HEADER.replace(",", " , ") + ROWS,
        "# camera 2\n\n" + (HEADER + ROWS).replace("\n", "\r\n") + "\n  # end\n",
        "Time [s];Midpoint (m)\n" + rows_of(TIME, FALL, separator=";"),
        "t_s;midpoint_m\n" + rows_of(TIME, FALL, separator=";", comma=True),
        "sep=;\nt_s;midpoint_m\n" + rows_of(TIME, FALL, separator=";", comma=True),
        "t_s\tmidpoint_m\n" + rows_of(TIME, FALL, separator="\t", comma=True),
        "frame,midpoint_m,x_px,y_px,time_stamp,time_s,T_K\n" + rows_of(TIME * 0, FALL, TIME, TIME, TIME, TIME, TIME),
        HEADER + ROWS.replace("\n", ",,\n"),
    ],
    ids=["plain", "BOM", "comments", "semicolons", "decimal commas", "Excel", "tabs", "other columns", "empty cells"],
)
def test_one_film_in_many_dialects(tmp_path: Path, text: str) -> None:
    series = read(tmp_path, text)
    np.testing.assert_array_equal(series.time, TIME)
    np.testing.assert_array_equal(series.midpoint, FALL)
    assert series.std is None
    assert series.shapes is None
    assert series.notes == ()
    assert series.path == tmp_path / "film.csv"


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
    tmp_path: Path,
    frames: list[tuple[int, int, int]],
    clock: str,
    ruler: str,
    dialect: tuple[str, bool],
    name: str,
) -> None:
    separator, comma = dialect
    header = separator.join([f"time_{clock}", f"{name}_{ruler}", f"{name}_std_{ruler}"]) + "\n"
    time, height, std = (np.array(column) / 100 for column in zip(*frames, strict=True))
    series = read(tmp_path, header + rows_of(time, height, std, separator=separator, comma=comma))
    order = np.argsort(time)
    down = -1.0 if name != "midpoint" else 1.0
    assert series.std is not None
    np.testing.assert_allclose(series.time, time[order] * float(SECONDS[clock]), rtol=1e-15)
    np.testing.assert_allclose(series.midpoint, down * height[order] * float(METRES[ruler]), rtol=1e-15)
    np.testing.assert_allclose(series.std, std[order] * float(METRES[ruler]), rtol=1e-15)
    was_sorted = bool(np.all(np.diff(time) > 0))
    assert any("Sorted" in note for note in series.notes) is not was_sorted
    assert any("downwards by its name" in note for note in series.notes) is (down < 0)


def test_a_length_in_mm_is_the_same_float_as_in_m(tmp_path: Path) -> None:
    series = read(tmp_path, "time_ms,midpoint_mm\n0.1,-6\n0.3,-7\n0.7,-9.1\n0.9,-11\n1.1,-13\n")
    assert series.midpoint.tolist() == [-0.006, -0.007, -0.0091, -0.011, -0.013]
    assert series.time.tolist() == [0.0001, 0.0003, 0.0007, 0.0009, 0.0011]


def test_whole_shapes(tmp_path: Path) -> None:
    x = np.linspace(-0.1, 0.1, 9)
    time, place = np.repeat([0.2, 0.1], 9), np.tile(x, 2)
    y = -(0.01 - place**2)
    table = "time_s,x_m,y_mm,y_std_mm\n" + rows_of(time, place, np.round(y * 1e3, 6), np.full(18, 0.1))
    series = read(tmp_path, table + table.splitlines()[-1] + "\n")
    shapes = series.shapes
    assert shapes is not None
    assert series.time.size == series.midpoint.size == 0
    np.testing.assert_array_equal(shapes.time, np.repeat([0.1, 0.2], 9))
    np.testing.assert_allclose(shapes.x, place)
    np.testing.assert_allclose(shapes.y, y, atol=1e-9)
    assert shapes.std is not None
    np.testing.assert_array_equal(shapes.std, 1e-4)
    assert [note.split()[0] for note in series.notes] == ["Sorted", "Left"]
    assert "1 point of the shapes that repeats another" in series.notes[1]


def test_comments_give_a_filament_values_of_its_own(tmp_path: Path) -> None:
    text = (
        "# filament.span = 5 mm   # between the pins\n#filament.section=circle;;\n# camera.fps = 60\n"
        "# e.g. this = that\n# run.time was short\n"
    )
    series = read(tmp_path, text + HEADER + ROWS + "# ends.left_angle = -3 deg\n")
    assert series.overrides == {"filament.span": "5 mm", "filament.section": "circle", "ends.left_angle": "-3 deg"}


def test_rows_without_a_number_are_left_out_and_said(tmp_path: Path) -> None:
    series = read(tmp_path, HEADER + "0.01,NaN\n" + ROWS + "1.1,\n1.2,N/A\n1.3\n")
    np.testing.assert_array_equal(series.time, TIME)
    assert series.notes == ("Left out 4 of 24 rows without a number (line 2, line 23, line 24, line 25).",)


def test_rows_before_the_release_are_left_out_and_said(tmp_path: Path) -> None:
    series = read(tmp_path, HEADER + "-0.2,0\n-0.1,1e-5\n" + ROWS)
    np.testing.assert_array_equal(series.time, TIME)
    assert "2 rows before time 0 (line 2, line 3)" in series.notes[0]


def test_repeated_times_are_averaged_with_their_weights(tmp_path: Path) -> None:
    header = "time_s,midpoint_m,midpoint_std_m\n"
    rows = rows_of(TIME, FALL, np.full(TIME.size, 1e-3))
    series = read(tmp_path, header + rows + f"1.0,{FALL[-1] - 3e-3},2e-3\n")
    assert series.std is not None
    assert series.time.size == TIME.size
    # Weights 4 and 1; the variances 1 and 4 (in mm^2) add inversely to 4/5.
    assert math.isclose(series.midpoint[-1], FALL[-1] - 3e-3 / 5)
    assert math.isclose(series.std[-1], 1e-3 * math.sqrt(0.8))
    np.testing.assert_allclose(series.std[:-1], 1e-3)
    assert "Averaged the midpoints at 1 time that occurred more than once (line 21, line 22)." in series.notes


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "holds no data"),
        ("# only a comment\n", "holds no data"),
        (HEADER, "0 distinct times; accepted: at least 5"),
        (HEADER + "0,0\n1,-1\n", "2 distinct times; accepted: at least 5"),
        (HEADER + ROWS + "\0", "not text"),
        ("time,midpoint\n" + ROWS, "2 faults.*'time': no unit.*'midpoint': no unit in its name; accepted: midpoint_m"),
        ("tiem_s,midpiont_m\n" + ROWS, "is it what is called 'tiem_s'.*is it what is called 'midpiont_m'"),
        ("time_s midpoint_m\n", "separated by commas, semicolons or tabs"),
        ("frame,midpoint_px\n" + ROWS, "'midpoint_px': pixels, which.*no column of times"),
        ("time_m,midpoint_s\n" + ROWS, "'m' is a length, not a time.*'s' is a time, not a length"),
        ("time_s,midpoint_bananas\n" + ROWS, "unknown unit 'bananas'"),
        ("time_s,midpoint_m,sag [bananas]\n" + ROWS, r"column 'sag \[bananas\]': unknown unit 'bananas'"),
        ("time_s,time_s,midpoint_m\n", "2 columns for one quantity: time_s, time_s"),
        ("time_s,midpoint_m,sag_mm\n", "2 columns for one quantity: midpoint_m, sag_mm"),
        ("time_s,midpoint_m,x_m,y_m\n", "both a midpoint and points of a whole shape"),
        ("time_s,y_m\n", "y without x.*midpoint_m for the midpoint alone"),
        ("time_s,x_m\n", "x without y"),
        ("time_s,x_m,y_m\n1,0,0\n", "1 point; accepted: at least 5"),
        (HEADER + ROWS + "1,2,3\n", "line 22: 3 cells under 2 names.*decimal commas need"),
        (HEADER + ROWS + "x,inf\n-1e999,1_0\n", "4 faults.*line 22, time_s: 'x' is not a.*midpoint_m: inf is not fin"),
        ("t_s;midpoint_m\n1.000,5;2\n", "line 2, t_s: '1.000,5' is not a number"),
        (HEADER + '"1,2\n' + "1" * 200_000 + ",2\n", "line 3, time_s: '1111.*is not a number"),
        (HEADER + ROWS + "1,-2e12\n", "beyond anything measured"),
        (
            "time_s,midpoint_m,midpoint_std_m\n0,0,0\n1,1,-2\n",
            "line 2, midpoint_std_m: 0 is.*line 3.*-2 is not positive",
        ),
        (HEADER + ROWS + "2,\n" * 10, "10 of 30 rows without a number .line 22,.* ....; accepted: .*two thirds"),
        (HEADER + rows_of(TIME, 0 * TIME - 3e-3), "-0.003 m at every time: nothing moves"),
        (
            HEADER + ROWS + "0.5,-0.01\n0.50000000000001,-0.02\n",
            "line 11, line 22, line 23: .*at the same time, 0.5 s; .*one file",
        ),
        (HEADER + rows_of(TIME - 0.5, FALL), "9 rows before time 0 .*the filament moves already"),
        (HEADER + rows_of(TIME - 9, FALL), "all times are before 0"),
        ("# filament.spam = 3\n" + HEADER + ROWS, "line 1, filament.spam: unknown key .did you mean 'span'"),
        ("# filamnet.span = 3 m\n" + HEADER + ROWS, "unknown table in 'filamnet.span' .did you mean 'filament'"),
        ("# filament.span 3 m\n" + HEADER + ROWS, "'# filament.span 3 m' sets nothing; accepted: key = value"),
        ("# load.ramp =\n" + HEADER + ROWS, "sets nothing"),
        ("# load.ramp = 1 s\n" * 2 + HEADER + ROWS, "line 2: load.ramp set again"),
        (HEADER + "a,b\n" * 9, "18 faults.*and 10 more"),
    ],
)
def test_a_bad_file_is_one_clear_refusal(tmp_path: Path, text: str, message: str) -> None:
    path = written(tmp_path, text)
    with pytest.raises(SoftcatError, match=rf"(?s)measurements {path}: .*{message}"):
        read_measurements(path)


def test_files_that_are_no_text_files_and_several_at_once(tmp_path: Path) -> None:
    fine, short = written(tmp_path, HEADER + ROWS), written(tmp_path, HEADER, "short.csv")
    latin = tmp_path / "latin.csv"
    latin.write_bytes("time_s,midpoint_µm\n".encode("latin-1"))
    with pytest.raises(SoftcatError) as refused:
        read_measurements([fine, tmp_path / "nowhere.csv", tmp_path, latin, short])
    text = str(refused.value)
    assert ["no such file" in text, "a directory" in text, "line 1: not UTF-8" in text, "0 distinct" in text] == [
        True
    ] * 4
    assert str(fine) not in text
    with pytest.raises(SoftcatError, match="named twice"):
        read_measurements([fine, tmp_path / "." / "film.csv"])
    with pytest.raises(SoftcatError, match="no file"):
        read_measurements([])
    assert len(read_measurements([str(fine), written(tmp_path, HEADER + ROWS, "again.csv")]).series) == 2
