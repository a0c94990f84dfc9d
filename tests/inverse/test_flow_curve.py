"""Reading a flow curve: what is tolerated, and what is refused in one clear message."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.flow_curve import FlowCurve, read_flow_curve

ROWS = "1,14\n10,20\n100,40\n1000,90\n"
HEADER = "shear_rate_1_s,shear_stress_Pa\n"


@pytest.mark.parametrize(
    "text",
    [
        HEADER + ROWS,
        "\ufeff" + HEADER + ROWS,
        "# sample 7, 23 C\n\n  # cup and bob\n" + HEADER + ROWS.replace("100,", "# pause\n\n100,"),
        " shear_rate_1_s , shear_stress_Pa \n" + ROWS.replace(",", " ,  "),
        (HEADER + ROWS).replace("\n", "\r\n"),
        '"shear_rate_1_s","shear_stress_Pa"\n' + ROWS.replace("14", '"14"'),
        "note,shear_stress_Pa,shear_rate_1_s\nslow,14,1\n,20,1e1\nnan,40,100\n,90,1000,,\n",
        "sep=;\n" + (HEADER + ROWS.replace("20", "20,0")).replace(",", ";").replace("20;0", "20,0"),
        (HEADER + ROWS).replace(",", "\t"),
        "Shear rate [1/s];Shear Stress (kPa)\n1,0;0,014\n10;2e-2\n100;,04\n1000,;0.090\n",
        "shear_rate_1/min,shear_stress_mPa\n60,14000\n600,2e4\n6e3,4e4\n60000,9e4\n",
        "shear rate (s^-1),shear_stress_Pa\n" + ROWS,
        "shear rate [s-1],shear stress [Pa]\n" + ROWS,
    ],
    ids=[
        *("plain", "BOM", "comments", "spaces", "CRLF", "quotes", "other columns"),
        *("decimal commas", "tabs", "units", "other units", "s^-1", "s-1"),
    ],
)
def test_what_rheometers_write_is_read(tmp_path: Path, text: str) -> None:
    path = tmp_path / "curve.csv"
    path.write_bytes(text.encode())
    curve = read_flow_curve(path)
    np.testing.assert_array_equal(curve.shear_rate, [1, 10, 100, 1000])
    assert curve.notes == ()
    np.testing.assert_array_equal(curve.shear_stress, [14, 20, 40, 90])
    assert curve.path == path


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "holds no data"),
        ("# only a comment\n", "holds no data"),
        (HEADER, "0 distinct shear rates; accepted: at least 4"),
        ("shear_rate_1_s,stress_Pa\n" + ROWS, r"no column shear_stress_Pa .*called 'stress_Pa'"),
        ("shear_rate_1_s shear_stress_Pa\n", "separated by commas, semicolons or tabs"),
        ("shear_rate_1_s,shear_stress_Pa,shear_rate_1_s\n" + ROWS, "2 columns for one quantity: shear_rate_1_s, shear"),
        ("shear_rate_1_s,shear stress [kbananas]\n" + ROWS, r"column 'shear stress \[kbananas\]': unknown unit"),
        ("shear_rate_s,shear_stress\n" + ROWS, "2 faults.*'s' is a time, not a shear rate.*no unit in its name"),
        (HEADER + "1,14,5\n" + ROWS, "line 2: 3 cells under 2 names.*decimal commas need semicolons"),
        (HEADER + ROWS.replace("20", "twenty"), "line 3, shear_stress_Pa: 'twenty' is not a number"),
        (HEADER + ROWS.replace("20", "").replace("40", "n/a"), r"2 of 4 rows without a number \(line 3, line 4\)"),
        (HEADER + ROWS.replace("20", "1_000"), "'1_000' is not a number"),
        (HEADER + ROWS.replace("20", "1e999"), "inf is not finite"),
        (HEADER + ROWS.replace("20", "-20"), "line 3, shear_stress_Pa: -20 is not positive"),
        (HEADER + ROWS.replace("\n10,", "\n0,"), "line 3, shear_rate_1_s: 0 is not positive"),
        (HEADER + ROWS.replace("20", "2e20"), "beyond what a rheometer measures"),
        (HEADER + ROWS.replace("1000,", "100.00000001,") + "1,15\n10,21\n", "3 distinct shear rates"),
        (HEADER + "a,b\n" * 9, "18 faults.*and 10 more"),
        (HEADER + ROWS + "\0", "not text"),
    ],
)
def test_a_bad_file_is_one_clear_refusal(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "curve.csv"
    path.write_text(text)
    with pytest.raises(SoftcatError, match=rf"(?s)flow curve {path}: .*{message}"):
        sc.fit_flow_curve(str(path))


def test_rows_without_a_number_are_left_out_and_said(tmp_path: Path) -> None:
    path = tmp_path / "curve.csv"
    path.write_text(HEADER + ROWS + "5\n")
    curve = read_flow_curve(path)
    np.testing.assert_array_equal(curve.shear_rate, [1, 10, 100, 1000])
    assert curve.warnings == ("Left out 1 of 5 rows without a number (line 6).",)


def test_files_that_are_no_text_files(tmp_path: Path) -> None:
    with pytest.raises(SoftcatError, match="no such file"):
        sc.fit_flow_curve(tmp_path / "nowhere.csv")
    with pytest.raises(SoftcatError, match="a directory"):
        sc.fit_flow_curve(tmp_path)
    latin = tmp_path / "latin.csv"
    latin.write_bytes(HEADER.encode() + "1,14\n# 20 °C\n".encode("latin-1"))
    with pytest.raises(SoftcatError, match="line 3: not UTF-8"):
        sc.fit_flow_curve(latin)
    long = tmp_path / "long.csv"
    long.write_bytes(b"1" * ((1 << 24) + 1))
    with pytest.raises(SoftcatError, match="longer than 16 MiB"):
        sc.fit_flow_curve(long)


@pytest.mark.parametrize(
    ("rate", "stress", "message"),
    [
        ([1, 2, 3, 4], [1, 2, 3], r"shape \(4,\).*shape \(3,\)"),
        ([[1, 2], [3, 4]], [[1, 2], [3, 4]], "two lists"),
        ([1, 2, 3, "x"], [1, 2, 3, 4], "shear_rate: not a list of numbers"),
        ([1, 2, 3, 4], [1, 2, float("nan"), 4], r"shear_stress\[2\]: nan is not finite"),
        ([1, 2, 3, -4], [1, 2, 3, 0], "2 faults"),
        ([], [], "0 distinct"),
    ],
)
def test_bad_points_are_refused(rate: list[float], stress: list[float], message: str) -> None:
    with pytest.raises(SoftcatError, match=rf"(?s){message}"):
        FlowCurve(rate, stress)  # type: ignore[arg-type]


def test_a_curve_cannot_be_changed() -> None:
    rate = np.array([1.0, 2, 3, 4])
    curve = FlowCurve(rate, rate)
    rate[0] = 9
    assert curve.shear_rate[0] == 1
    with pytest.raises(ValueError, match="read-only"):
        curve.shear_rate[0] = 9
