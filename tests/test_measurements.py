"""Films of filaments: what people, spreadsheets and trackers write is read; what is wrong is one clear refusal."""

from __future__ import annotations

import copy
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

import softcat_sym as sc
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.fitting.fit import fit
from softcat_sym.fitting.measurements import Measurements, Series, Shapes, read_measurements
from softcat_sym.fitting.plausibility import checked, own_scene
from softcat_sym.fitting.result import Fit
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from tests.common.draws import draws, errors_away
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


def test_a_length_in_mm_is_the_same_float_as_in_m(tmp_path: Path) -> None:
    series = read(tmp_path, "time_ms,midpoint_mm\n0.1,-6\n0.3,-7\n0.7,-9.1\n0.9,-11\n1.1,-13\n")
    assert series.midpoint.tolist() == [-0.006, -0.007, -0.0091, -0.011, -0.013]
    assert series.time.tolist() == [0.0001, 0.0003, 0.0007, 0.0009, 0.0011]


def test_whole_shapes_and_values_of_ones_own(tmp_path: Path) -> None:
    place = np.tile(np.linspace(-0.1, 0.1, 9), 2)
    y = -(0.01 - place**2)
    table = "time_s,x_m,y_mm,y_std_mm\n" + rows_of(np.repeat([0.2, 0.1], 9), place, np.round(y * 1e3, 6), 0 * y + 0.1)
    series = read(tmp_path, table + table.splitlines()[-1] + "\n")
    shapes = series.shapes
    assert shapes is not None and shapes.std is not None and series.time.size == series.midpoint.size == 0
    np.testing.assert_array_equal(shapes.time, np.repeat([0.1, 0.2], 9))
    np.testing.assert_allclose(shapes.x, place)
    np.testing.assert_allclose(shapes.y, y, atol=1e-9)
    np.testing.assert_array_equal(shapes.std, 1e-4)
    assert series.notes[0].startswith("Sorted") and "; left out 1 point of the shapes" in series.notes[0]
    comments = (
        "# filament.span = 5 mm   # between the pins\n#filament.section=circle;;\n# camera.fps = 60\n# this = that\n"
    )
    series = read(tmp_path, comments + HEADER + ROWS + "# ends.left_angle = -3 deg\n")
    assert series.overrides == {"filament.span": "5 mm", "filament.section": "circle", "ends.left_angle": "-3 deg"}


def test_what_needs_no_guess_is_mended_and_said(tmp_path: Path) -> None:
    series = read(tmp_path, HEADER + "0.01,NaN\n" + ROWS + "1.1,\n1.2,N/A\n1.3\n")
    np.testing.assert_array_equal(series.time, TIME)
    assert series.notes == ("Left out 4 of 24 rows without a number (line 2, line 23, line 24, line 25).",)
    series = read(tmp_path, HEADER + "-0.2,0\n-0.1,1e-5\n" + ROWS)
    np.testing.assert_array_equal(series.time, TIME)
    assert "2 rows before time 0 (line 2, line 3)" in series.notes[0]
    rows = rows_of(TIME, FALL, np.full(TIME.size, 1e-3))
    series = read(tmp_path, "time_s,midpoint_m,midpoint_std_m\n" + rows + f"1.0,{FALL[-1] - 3e-3},2e-3\n")
    assert series.std is not None and series.time.size == TIME.size
    # Weights 4 and 1; the variances 1 and 4 (in mm^2) add inversely to 4/5.
    assert math.isclose(series.midpoint[-1], FALL[-1] - 3e-3 / 5)
    np.testing.assert_allclose(series.std, np.where(TIME == 1, 1e-3 * math.sqrt(0.8), 1e-3))
    assert series.notes == ("Averaged the midpoints at 1 time that occurred more than once (line 21, line 22).",)


REFUSED = [
    ("# only a comment\n", "holds no data"),
    ("time,midpoint\n" + ROWS, "2 faults.*'time': no unit.*'midpoint': no unit in its name; accepted: midpoint_m"),
    ("tiem_s,midpiont_m\n" + ROWS, "is it what is called 'tiem_s'.*is it what is called 'midpiont_m'"),
    ("time_s|midpoint_m\n", "separated by commas, semicolons, tabs or blanks"),
    ("frame,midpoint_px\n" + ROWS, "frames without a frame rate.*'midpoint_px': pixels, which"),
    ("time_m,midpoint_s\n" + ROWS, "'m' is a length, not a time.*'s' is a time, not a length"),
    ("time_s,midpoint_m,sag [bananas]\n" + ROWS, r"column 'sag \[bananas\]': unknown unit 'bananas'"),
    ("time_s,midpoint_m,midpoint_std_bananas\n" + ROWS, "unknown unit 'bananas'"),
    ("time_s,midpoint_m,vertical_force_kg\n" + ROWS, "'kg' is a mass, not a force"),
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


def test_bad_arrays_are_refused() -> None:
    for time, midpoint, std, message in (
        ([0, 1, 2], [0, 1, 2, 3, 4], None, r"time of shape \(3,\), midpoint of shape \(5,\)"),
        ([[0, 1], [2, 3]], [[0, 1], [2, 3]], None, "lists of the same length"),
        ("abc", [1.0], None, "time: not a list of numbers"),
        ([0, 1, 2, 3, np.nan], [0, 1, 2, np.inf, 4], [0, -1, 1, 1, 1], r"4 faults.*time\[4\].*std\[1\]: -1 is not pos"),
        ([0, 1, 2, 1, 4], [0, 1, 2, 3, 4], None, r"time\[3\]: 1 s after 2 s; .*Measurements.of sorts"),
        ([0, 1, 2, 2, 4], [0, 1, 2, 3, 4], None, r"time\[3\]: 2 s again; .*Measurements.of averages"),
        ([-1, 1, 2, 3, 4], [0, 1, 2, 3, 4], None, r"time\[0\]: -1 s, before the release"),
        ([0, 1, 2, 3], [0, 1, 2, 3], None, "4 distinct times"),
        ([0, 1, 2, 3, 4], [0.3] * 5, None, "0.3 m at every time"),
    ):
        with pytest.raises(SoftcatError, match=rf"(?s){message}"):
            Series(time, midpoint, std)  # type: ignore[arg-type]
    for x, y, message in (
        ([1.0] * 5, [0.0] * 5, "0 m at every point"),
        ([1.0] * 4, [0, 1, 2, 3], "4 points; accepted"),
    ):
        with pytest.raises(SoftcatError, match=message):
            Shapes([0.0] * len(x), x, y)  # type: ignore[arg-type]
    with pytest.raises(SoftcatError, match="at least one Series"):
        Measurements(())


def test_arrays_are_corrected_as_files_are_and_cannot_be_changed() -> None:
    time, height = np.append(TIME[::-1], [TIME[3], 2.0]), np.append(FALL[::-1], [FALL[3], np.nan])
    (series,) = Measurements.of(time, height, 1e-4, {"filament.span": "1 cm"}).series
    np.testing.assert_array_equal(series.time, TIME)
    np.testing.assert_allclose(series.midpoint, FALL, rtol=1e-15)
    assert series.std is not None
    np.testing.assert_allclose(series.std, np.where(TIME == TIME[3], 1e-4 / np.sqrt(2), 1e-4))
    assert [note.split()[0].lower() for note in series.notes[0].split("; ")] == ["left", "sorted", "averaged"]
    assert "index 21" in series.notes[0] and series.overrides == {"filament.span": "1 cm"}
    masked = np.ma.masked_array(FALL, mask=TIME == TIME[5])
    assert Measurements.of(TIME, masked).series[0].time.size == TIME.size - 1
    for heights, std, message in (([3, np.inf], None, r"midpoint\[1\]: inf is"), ([3, 4], "few", "std: not a list")):
        with pytest.raises(SoftcatError, match=message):
            Measurements.of([1, 2], heights, std)
    time[0] = 9
    for values in (series.time, series.midpoint, series.std):
        with pytest.raises(ValueError, match="read-only"):
            values[0] = 9
    np.testing.assert_array_equal(copy.deepcopy(series).midpoint, series.midpoint)


@pytest.fixture(scope="module")
def scene() -> Scene:
    """Span 0.2 m, duration 2.86 s, sqrt(L/g) = 0.143 s."""
    return load_scene("maxwell-slow")


def of_checked(time: Floats, midpoint: Floats, scene: Scene) -> Series:
    return checked(Measurements.of(time, midpoint), scene).series[0]


@pytest.mark.slow
def test_what_a_scene_itself_does_is_neither_refused_nor_remarked_on() -> None:
    for name in ("maxwell-slow", "drawn-blob", "putty-arch", "curled-rod", "slack-taffy", "glass-rod"):
        scene = load_scene(name, {"run.frames": 60, "numerics.cells": 12, "numerics.estimate": False})
        data = sc.simulate(scene).data
        series = of_checked(data["time"].values, data["midpoint"].values, scene)
        assert np.array_equal(series.midpoint, data["midpoint"].values) and series.notes == (), name


def test_heights_that_count_downwards_are_turned_and_said(scene: Scene) -> None:
    for noise in (0.0, 5e-4):
        heights = FALL + noise * draws(1).standard_normal(TIME.size)
        turned, upright = of_checked(TIME, -heights, scene), of_checked(TIME, heights, scene)
        np.testing.assert_array_equal(turned.midpoint, heights)
        assert "Turned the sign of midpoint" in turned.notes[0]
        assert np.array_equal(upright.midpoint, heights) and upright.notes == ()
    # An elastic film swings back; an arch may stand above its supports.
    ringing = 0.005 * (1 - np.exp(-TIME) * np.cos(40 * TIME))
    np.testing.assert_array_equal(of_checked(TIME, ringing, scene).midpoint, -ringing)
    arch = 0.003 - FALL / 10
    np.testing.assert_array_equal(of_checked(TIME, arch, load_scene("putty-arch")).midpoint, arch)
    with pytest.raises(SoftcatError, match=r"midpoint: above the supports' level and falling, from 0.09.* sag_m for"):
        of_checked(TIME, 0.1 + FALL, scene)
    astride = of_checked(TIME, 0.01 + FALL, scene)
    assert "up to 0.00995 m above the supports' level" in astride.notes[0]


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


def test_shapes_are_held_against_the_supports(scene: Scene) -> None:
    x = np.tile(np.linspace(-0.1, 0.1, 9), 2)
    shapes = Shapes(np.repeat([0.5, 1.0], 9), x, np.repeat([0.5, 1.0], 9) * -(0.01 - x**2))

    def of(shapes: Shapes, scene: Scene) -> Series:
        return checked(Measurements((Series(np.empty(0), np.empty(0), shapes=shapes),)), scene).series[0]

    turned = of(replace(shapes, y=-shapes.y), scene)
    for series in (of(shapes, scene), turned):
        assert series.shapes is not None and np.array_equal(series.shapes.y, shapes.y)
    assert "Turned the sign of y" in turned.notes[0]
    bulge = np.linspace(-0.115, 0.115, 9)
    slack = Shapes(0 * bulge + 1, bulge, bulge**2 - 0.014)
    assert of(slack, load_scene("slack-taffy")).shapes is not None
    for bad, message in (
        (replace(shapes, x=x + 0.1), r"x: from 0 m to 0.2 m; .*halfway between the supports; subtract 0.1 m\?"),
        (replace(shapes, x=1000 * x), r"x: from -100 m to 100 m.*as of mm in a column named for m"),
        (replace(shapes, y=1000 * shapes.y), "y: -10 m at 1 s"),
        (slack, r"x: from -0.115 m to 0.115 m"),
    ):
        with pytest.raises(SoftcatError, match=message):
            of(bad, scene)


def test_each_filament_has_its_own_scene(scene: Scene) -> None:
    short = Series(TIME, FALL, overrides={"filament.span": "1 cm", "filament.thickness": "1 mm"})
    assert own_scene(short, scene).filament.span == 0.01
    assert own_scene(Series(TIME, FALL), scene) is scene
    both = Measurements((Series(TIME, 60 * FALL), Series(TIME, 60 * FALL, overrides=short.overrides)))
    # 1.2 m is 6 spans of the one, and 120 of the other.
    with pytest.raises(SoftcatError, match=r"120 times the 0.01 m") as refused:
        checked(both, scene)
    assert str(refused.value).count("fault") == 1
    bad = {"filament.thickness": "5 m", "material.viscosity": "big"}
    with pytest.raises(SceneError, match=r"(?s)filament.thickness: '5 m' is not less.*material.viscosity: 'big'"):
        own_scene(Series(TIME, FALL, overrides=bad), scene)


QUICK = {"run.effects": "paper", "numerics.cells": 6, "run.frames": 61, "numerics.estimate": False}


@pytest.fixture(scope="module")
def filmed() -> tuple[Scene, Floats, Floats]:
    """A scene and its film of 60 frames, on a 0.2 m span, with 1 % noise."""
    scene = load_scene("continual-descent", QUICK)
    run = sc.simulate(scene).data
    height = run.midpoint.values[1:]
    noise = 0.01 * float(np.max(np.abs(height))) * draws(11).standard_normal(height.size)
    return scene, run.time.values[1:], height + noise


def rounded(*columns: Floats) -> str:
    return "".join(",".join(f"{value:.9g}" for value in row) + "\n" for row in zip(*columns, strict=True))


@pytest.mark.statistical
def test_a_fit_is_the_same_from_what_was_mended(filmed: tuple[Scene, Floats, Floats], tmp_path: Path) -> None:
    scene, time, height = filmed

    def fitted(text: str) -> Fit:
        return fit(written(tmp_path, text), scene, ["viscosity"], starts=0, profiles=False)

    theirs = fitted(HEADER + rounded(time, height)).parameters["viscosity"]
    assert theirs.value is not None and theirs.std is not None
    assert abs(theirs.value - scene.material.viscosity) < errors_away(59) * theirs.std
    few = np.where(np.arange(60) % 20 == 0, np.nan, height)
    commas = "time_s;midpoint_mm\n" + rounded(time, 1e3 * height).replace(",", ";").replace(".", ",")
    for text, note in (
        (HEADER + rounded(time[::-1], height[::-1]), "Sorted the rows by time"),
        (HEADER + rounded(np.insert(time, 20, time[20]), np.insert(height, 20, height[20])), "Averaged the midpoints"),
        (HEADER + rounded(time, few), "Left out 3 of 60 rows without a number"),
        (HEADER + rounded(time, -height), "Turned the sign of midpoint"),
        ("time_s,sag_mm\n" + rounded(time, -1e3 * height), "Turned the sign of sag_mm"),
        (commas, "Read decimal commas"),
    ):
        found = fitted(text)
        ours = found.parameters["viscosity"]
        assert len(found.notes) == 1 and note in found.notes[0]
        assert ours.value is not None and ours.std is not None
        if "Left out" in note:  # Three frames fewer are another draw, near the truth as the first
            assert abs(ours.value - scene.material.viscosity) < errors_away(56) * ours.std
        else:  # The same, to the digits of the file
            assert abs(ours.value - theirs.value) < 1e-4 * theirs.value, note
