"""Tables as instruments, trackers, spreadsheets and people write them: read to the right numbers, or refused by line.

Formats are those of files and writers in public repositories.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.batch.plan import plan_sweep
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.collapse_test import read_contour
from softcat_sym.fitting.flow_curve import read_flow_curve
from softcat_sym.fitting.measurements import read_measurements
from softcat_sym.scene.table_reader import points_in

CURVE = [(1, 14), (10, 20), (100, 40), (1000, 90)]
RHEOCOMPASS = (
    "Project:\tViscosity Curve | PC-1, 1/2/2020 | 1\n\nTest:\tFlow curve of an oil\n\nResult:\tViscosity curve 1\n\n"
    "Interval and data points:\t1\t2\nInterval data:\tPoint No.\tTime\tShear Rate\tShear Stress\tViscosity\tStatus\n"
    "\t\tConstant component\t\t\t\t\n\t\t[s]\t[1/s]\t[Pa]\t[mPa·s]\t\n\t1\t10\t1\t14\t14000\tDy_auto\n"
    "\t2\t20\t10\t20\t2000\tDy_auto\n\n"
)
SECOND = RHEOCOMPASS.partition("1\n\n")[2].partition("Interval and")[2].replace("\t10\t1\t14\t", "\t10\t100\t40\t")
AMPLITUDES = (
    "Interval and data points:\t3\t2\nInterval data:\tPoint No.\tTime\tShear Strain\tStorage Modulus\n"
    "\t\t[s]\t[1]\t[Pa]\n\t1\t1\t0.1\t300\n\t2\t2\t1\t200\n"
)
TRIOS = (
    "Filename\tSample 1\nInstrument name\tDHR\n[step]\nConditioning\nStep time\tTemperature\ns\t°C\n1\t25\n\n[step]\n"
    "Flow sweep\nStress\tShear rate\tViscosity\tStep time\tTemperature\tNormal stress\nPa\t1/s\tPa.s\ts\t°C\tPa\n"
)
HAAKE = (
    "C:\\data\\file.rwd\nCompany / Operator: - / -\nDate / Time / Version: 1.2.2020 / 10:00:00 / HAAKE RheoWin\n"
    "Substance / Sample no: --- / \n\n;GP in 1/s;Tau in Pa;Eta in Pas;T in ºC;t in s;t_seg in s;\n"
    "1|1; ;0,06978; ; ;17,86;7,239;\n"
)
RSPACE = "Action Name;Time (action)(s);Temperature(°C);Shear rate({});Shear stress(Pa);Shear viscosity(Pa s)\n"


def lines(form: str, *, comma: bool = False) -> str:
    """A line for each point of the flow curve."""
    text = "".join(form.format(rate=rate, stress=stress, viscosity=stress / rate) + "\n" for rate, stress in CURVE)
    return text.replace(".", ",") if comma else text


FLOW_CURVES = {
    "ours": "shear_rate_1_s,shear_stress_Pa\n" + lines("{rate},{stress}"),
    "other columns": "note,Stress / kPa,t,shear_rate_1/min\nnan,0.014,1,60\n,20e-3,1,6e2\nx,.04,,6e3\n,.09,4,6e4,,\n",
    "one sample": "sample_id,shear rate [s-1],stress_Pa\n" + lines("ink,{rate},{stress}"),
    "Excel": "sep=;\nShear rate [1/s];Shear Stress (kPa)\n1,0;0,014\n10;2e-2\n100;,04\n1000,;0.090\n",
    "old Mac": ("\ufeffShear rate (1/s)\tStress (Pa)\n" + lines("{rate}\t{stress}")).replace("\n", "\r"),
    "NumPy": "# γ̇[1/s] tau_Pa\n" + lines("{rate} {stress}"),
    "RheoCompass": RHEOCOMPASS + "Interval and" + SECOND.replace("\t20\t10\t20\t", "\t20\t1000\t90\t") + AMPLITUDES,
    "TRIOS": TRIOS + lines("{stress}\t{rate}\t{viscosity}\t10\t25\t0.1"),
    "TA, AR": "shear stress\tshear rate\ttime\nPa\t1/s\ts\n" + lines("{stress}\t{rate}\t1"),
    "units in a row": "Shear Rate;Shear Stress;Speed\n[1/s];[Pa];[1/min]\n"
    + lines("{rate:.1f};{stress};1.5", comma=True),
    "only a viscosity": "Shear Rate [1/s]\tViscosity [mPa s]\n1\t14000\n10\t2000\n100\t400\n1000\t90\n",
    "below the least torque": "Shear rate [1/s],Shear stress [Pa]\n0.1,-0.0002\n" + lines("{rate},{stress}"),
    "HAAKE": HAAKE + lines("3|1;{rate};{stress:.1f};{viscosity};20;245;33;", comma=True),
    "HAAKE, Greek": "γ̇ in 1/s;τ in Pa;η in Pas\n" + lines("{rate};{stress};{viscosity}"),
    "rSpace": RSPACE.format("s⁻¹") + lines("Shear ramp;1,5;25;{rate};{stress:.1f};{viscosity}", comma=True),
    "rSpace, older": RSPACE.format("s-¹").replace(";", ",") + lines("Shear ramp,1,25,{rate},{stress},{viscosity}"),
}
ENCODINGS = {
    **{"Excel": "utf-8-sig", "RheoCompass": "utf-16", "TRIOS": "cp1252", "HAAKE": "cp1252", "rSpace": "utf-8-sig"},
    **{"rSpace, older": "cp1252", "Manual Tracking": "cp1252", "old Mac": "utf-16-be"},
}
"""Others are UTF-8."""
NOTES = {
    "Excel": "Read decimal commas.",
    "RheoCompass": "Skipped 4 lines above the header in line 8; joined 2 tables with the same header (again in line "
    "15); left out 6 lines outside of the table (line 14, 21, 22, 23, 24, ...); took units from line 10.",
    "TRIOS": "Skipped 9 lines above the header in line 11; took units from line 12.",
    "TA, AR": "Took units from line 2.",
    "units in a row": "Read decimal commas; took units from line 2.",
    "only a viscosity": "Computed stresses, rate times viscosity.",
    "below the least torque": "Left out 1 of 5 rows without a positive number (line 2).",
    "HAAKE": "Skipped 4 lines above the header in line 6; read decimal commas; left out 1 of 5 rows without a positive "
    "number (line 7).",
    "rSpace": "Read decimal commas.",
}


@pytest.mark.parametrize("maker", FLOW_CURVES)
def test_flow_curves_as_rheometers_write_them(maker: str, tmp_path: Path) -> None:
    curve = read_flow_curve(as_written(maker, FLOW_CURVES[maker], tmp_path))
    np.testing.assert_allclose(np.column_stack([curve.shear_rate, curve.shear_stress]), CURVE, rtol=1e-14)
    assert "".join(curve.notes) == NOTES.get(maker, "")


def as_written(maker: str, text: str, folder: Path) -> Path:
    """A file, with the line ends of Windows where a maker has a code page."""
    path, encoding = folder / "table.txt", ENCODINGS.get(maker, "utf-8")
    path.write_bytes((text.replace("\n", "\r\n") if maker in ENCODINGS else text).encode(encoding))
    return path


CAMERA = "# camera.fps = 240\n# camera.pixel = 0.1 mm\n# camera.origin = 1000 200\n"
RELEASE = CAMERA + "# camera.release = 12\n"
FRAMES, PLACES = (12, 36, 60, 84), np.linspace(-0.08, 0.08, 9)
POINTS = [(frame, x, -1e-3 * ((frame - 12) / 24) ** 2 * (1 - (x / 0.1) ** 2)) for frame in FRAMES for x in PLACES]
PIXELS = [(frame, f"{1000 + 1e4 * x:.3f}", f"{200 - 1e4 * y:.3f}") for frame, x, y in POINTS]
WIDE = {frame: [pair for at, *pair in PIXELS if at == frame] for frame in FRAMES}
SHAPES = np.array([((frame - 12) / 240, x, y) for frame, x, y in POINTS])
# One point that is tracked through five frames: x = 20 mm, y = 0 to -16 mm.
TRACK = np.array([(k / 240, 0.02, -1e-3 * k**2) for k in range(5)])


def points(form: str, first: int = 0) -> str:
    """A line for each of `PIXELS`."""
    return "".join(form.format(n=n, frame=frame + first, x=x, y=y) for n, (frame, x, y) in enumerate(PIXELS, start=1))


def track(form: str, *, comma: bool = False) -> str:
    """A line for each frame of `TRACK`, with coordinates upwards in m and mm, or pixels downwards."""
    text = "".join(
        form.format(k=k, slice=k + 1, t=t, x=x, y=y, mx=1e3 * x, my=1e3 * y, px=1000 + 1e4 * x, py=200 - 1e4 * y)
        for k, (t, x, y) in enumerate(TRACK.tolist())
    )
    return text.replace(".", ",") if comma else text


def shapes() -> dict[str, str]:
    """Films of whole shapes."""
    spots = "LABEL,ID,POSITION_X,POSITION_Y,POSITION_T,FRAME\n" + 2 * "Label,Spot ID,X,Y,T,Frame\n"
    micron = "".join(f"a,1,{1e6 * x:.3f},{1e6 * y:.3f},{(f - 12) / 240!r},{f}\n" for f, x, y in POINTS)
    deep = ["scorer" + 27 * ",net", "bodyparts" + "".join(3 * f",p{k}" for k in range(9))]
    deep += ["coords" + 9 * ",x,y,likelihood"]
    deep += [f"{frame}" + "".join(f",{x},{y},0.99" for x, y in row) for frame, row in WIDE.items()]
    dltdv = [",".join(f"pt{k}_cam1_X,pt{k}_cam1_Y" for k in range(1, 10))]
    dltdv += [",".join(f"{x},{y}" for x, y in WIDE[k]) if k in WIDE else ",".join(18 * ["NaN"]) for k in range(85)]
    return {
        "points": RELEASE + "frame,x_px,y_px\n" + points("{frame},{x},{y}\n"),
        "ImageJ": RELEASE + " \tArea\tX\tY\tSlice\n" + points("{n}\t5\t{x}\t{y}\t{frame}\n"),
        "ImageJ, slices from 1": CAMERA + " ,Label,X,Y,Slice\n" + points("{n},a,{x},{y},{frame}\n", -11),
        "TrackMate": RELEASE + spots + ",,(pixel),(pixel),(frame),\n" + points("a,1,{x},{y},{frame},{frame}\n"),
        "TrackMate, calibrated": spots + ",,(micron),(micron),(sec),\n" + micron,
        "DeepLabCut": RELEASE + "\n".join(deep),
        "DLTdv": RELEASE + "\n".join(dltdv),
    }


def tracks() -> dict[str, str]:
    """Films of one point, or of two on either side."""
    kinovea = "# camera.unit = 1 mm\n# camera.time = 1 {}\n".format
    in_text = "".join(f"{1e3 * t:.6f} {1e3 * x:.2f} {1e3 * y:.2f} \n".replace(".", ",") for t, x, y in TRACK)
    two = "".join(f'"{t:.9f}","{1e3 * x}","{1e3 * y}","{-1e3 * x}","{1e3 * y}"\n' for t, x, y in TRACK)
    head = " \tTrack n°\tSlice n°\tX\tY\tDistance\tVelocity\tPixel Value\n"
    return {
        "Tracker": "mass_A\nt\tx\ty\n" + track("{t!r}\t{x!r}\t{y!r}\n"),
        "Kinovea": kinovea("s") + '"Time","A/0/X","A/0/Y"\n' + track('"{t:.9f}","{mx}","{my}"\n', comma=True),
        "Kinovea, two points": kinovea("s") + '"Time","A/0/X","A/0/Y","B/0/X","B/0/Y"\n' + two,
        "two points, units below": "time,a/x,a/y,b/x,b/y\ns,mm,mm,mm,mm\n" + two.replace('"', ""),
        "Kinovea, text": kinovea("ms") + "#Kinovea Trajectory data export\n#T X Y\n\n# Trajectory 1\n" + in_text,
        "Logger Pro": "Latest: Time (s),Latest: X (m),Latest: Y (m),Latest: X Velocity (m/s)\n"
        + track("{t!r},{x!r},{y!r},0\n"),
        "Logger Pro, video": "VideoAnalysis: Time (s)\tVideoAnalysis: X (cm)\tVideoAnalysis: Y (mm)\n"
        + track("{t!r}\t2\t{my!r}\n"),
        "Manual Tracking": CAMERA + head + track("{k}\t1\t{slice}\t{px:.0f}\t{py:.0f}\t-1\t-1\t200\n"),
        "OpenCV": CAMERA + "frame,cx,cy\n" + track("{k},{px:.3f},{py:.3f}\n"),
        "OpenCV, NumPy": CAMERA + "# frame x y\n" + track("{k:.18e} {px:.18e} {py:.18e}\n"),
    }


FILMS = shapes() | tracks()


def film_is_read(maker: str, folder: Path) -> float:
    """Read a film; the largest difference of its numbers."""
    (series,) = read_measurements(as_written(maker, FILMS[maker], folder)).series
    expected = TRACK if maker in tracks() else SHAPES
    if "two" in maker:
        expected = np.concatenate([[row, row * [1, -1, 1]] for row in TRACK])
    found = series.shapes
    assert found is not None and len(series.notes) <= 1
    return float(np.abs(np.column_stack([found.time, found.x, found.y]) - expected).max())


@pytest.mark.parametrize("maker", FILMS)
def test_films_as_trackers_write_them(maker: str, tmp_path: Path) -> None:
    assert film_is_read(maker, tmp_path) < 1e-7


def test_time_codes_count_hundredths_in_files_of_kinovea_and_are_refused_elsewhere(tmp_path: Path) -> None:
    """After the last colon Kinovea writes 1/100 s, or 1/1000 s beyond 100 frames a second; others write frames."""
    for codes, step in ((("0:00:59:96", "0:01:00:00", "0:01:00:04"), 0.04), (("0:00:59.996", "0:01:00:000"), 4e-3)):
        rows = "".join(f"{code} 20.00 {-k * k:.2f} \n" for k, code in enumerate((*codes, "1:00:00:00", "1:00:01:00")))
        head = "# camera.unit = 1 mm\n#Kinovea Trajectory data export\n#T X Y\n"
        text = head + rows + "0:00:59:00 20.00 1.00\n"
        path = as_written("Kinovea", text, tmp_path)
        (series,) = read_measurements(path).series
        assert series.shapes is not None and "ook camera.time = 1 s of Kinovea" in series.notes[0]
        expected = [59.0, *(60 + step * (k - 1) for k in range(len(codes))), 3600.0, 3601.0]
        np.testing.assert_allclose(series.shapes.time, expected, atol=1e-9)
        # They are seconds whatever the unit of times is, and no lengths.
        path.write_text("# camera.time = 1 ms\n" + text)
        (other,) = read_measurements(path).series
        assert other.shapes is not None and np.array_equal(other.shapes.time, series.shapes.time)
        for change, words in (
            (("20.00 1.00", "0:00:01.00 1.00"), "X: '0:00:01.00' is not a number"),
            (("0:00:59:00", "0:00:61:00"), "T: '0:00:61:00' is not a number"),
            (("Kinovea", "My program"), r"line [56], T: '0:0\d:\d\d:\d+' is not a number"),
        ):
            path.write_text("# camera.time = 1 s\n" + text.replace(*change))
            with pytest.raises(SoftcatError, match=words):
                read_measurements(path)


def test_doubtful_points_are_left_out_and_said(tmp_path: Path) -> None:
    path = as_written("DeepLabCut", FILMS["DeepLabCut"].replace("0.99", "0.2", 3), tmp_path)
    (series,) = read_measurements(path).series
    assert series.shapes is not None and series.shapes.x.size == 33
    assert "left out 3 points with a likelihood below 0.6" in series.notes[0]


KINDS = {
    "measurements": (read_measurements, "time_s,midpoint_m", "1,-0.1", "sag_mm"),
    "shapes": (read_measurements, "time_s,x_m,y_m", "1,0,-0.1", "x_mm"),
    "flow curve": (read_flow_curve, "shear_rate_1_s,shear_stress_Pa", "1,2", "tau [kPa]"),
    "contour": (read_contour, "x_mm,y_mm", "1,2", "y [m]"),
    "polyline": (lambda path: points_in(path, "x, y and z"), "x_m,y_m,z_m", "1,2,3", "z (cm)"),
    "table of a sweep": (
        lambda path: plan_sweep(sc.load_scene("ink-bridge"), path),
        "filament.span [m],filament.density [kg/m^3]",
        "1e-2,2000",
        "filament.span [mm]",
    ),
}


@pytest.mark.parametrize("kind", KINDS)
def test_two_columns_of_one_quantity_are_refused_by_name(kind: str, tmp_path: Path) -> None:
    read, header, row, twice = KINDS[kind]
    path = tmp_path / "table.csv"
    path.write_text(f"# pillars.gap = 0, 1\n{header},{twice}\n" + f"{row},7\n" * 6)
    words = (
        "filament.span stands there twice" if "sweep" in kind else f"2 columns for one quantity: .*, {re.escape(twice)}"
    )
    with pytest.raises(SoftcatError, match=f"line 2: {words}; accepted: "):
        read(path)


def bad(header: str, row: str) -> dict[str, tuple[bytes | None, str]]:
    """Bad inputs, and what the refusal says."""
    rest = row.split(",")[1:]
    name = header.split(",")[0]
    plain = name.partition(" [")[0].removesuffix("_mm").removesuffix("_m").removesuffix("_1_s").removesuffix("_s")
    rows = f"{row}\n" * 4
    return {
        "empty": (b"", "holds no data"),
        "only a header": (f"{header}\n".encode(), "line 1: no rows"),
        "more cells than names": (f"{header}\n{rows}{row},5\n".encode(), "line 6"),
        "text in a column": (f"{header}\n{rows}{','.join(['abc', *rest])}\n".encode(), "line 6"),
        "no unit": (f"{header.replace(name, plain)}\n{rows}".encode(), "unit"),
        "unknown unit": (f"{header.replace(name, f'{plain} [bananas]')}\n{rows}".encode(), "line 1.*bananas"),
        "not a number": (f"{header}\n{','.join(['nan', *rest])}\n{row}\n".encode(), "line 2|without|at least"),
        "infinite": (f"{header}\n{rows}{','.join(['inf', *rest])}\n".encode(), "line 6.*inf"),
        "binary": (bytes(range(256)), "not text"),
        "a folder": (None, "a directory"),
    }


@pytest.mark.parametrize("kind", KINDS)
def test_bad_input_is_one_refusal_that_names_file_and_line(kind: str, tmp_path: Path) -> None:
    read, header, row, _ = KINDS[kind]
    head = kind.replace("shapes", "measurements")
    for name, (content, words) in bad(header, row).items():
        path = tmp_path / name
        path.mkdir() if content is None else path.write_bytes(content)
        with pytest.raises(SoftcatError, match=rf"(?s){head} {path}: .*({words})") as refused:
            read(path)
        assert "accepted: " in str(refused.value) and len(str(refused.value)) < 4000, name
