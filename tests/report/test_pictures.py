"""Files of a run: complete, whole, and made from whatever a run leaves."""

from __future__ import annotations

import csv
import subprocess
import sys
from pathlib import Path

import matplotlib
import numpy as np
import pytest
import xarray as xr

from softcat_sym import files
from softcat_sym.plotting.run import energy_figure, energy_imbalance, midpoint_figure, write_pictures
from softcat_sym.plotting.style import printable

NAMES = ["midpoint.png", "shapes.png", "energy.png", "space-time.png", "midpoint.csv"]


def test_all_files_are_written_and_the_table_reads_back_exactly(descent, summary, scene, tmp_path):
    folder = tmp_path / "new" / "out"
    paths = write_pictures(descent, summary, scene, folder)
    assert [path.name for path in paths] == NAMES
    assert sorted(path.name for path in folder.iterdir()) == sorted(NAMES)
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in paths[:4])
    with paths[4].open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    np.testing.assert_array_equal([float(row["time_s"]) for row in rows], descent["time"].values)
    np.testing.assert_array_equal([float(row["midpoint_m"]) for row in rows], descent["midpoint"].values)


def test_style_and_settings_of_the_caller_are_left_alone(descent, summary, scene, tmp_path):
    with matplotlib.rc_context({"font.size": 17.0, "axes.grid": True}):
        before = matplotlib.rcParams.copy()
        write_pictures(descent, summary, scene, tmp_path)
        assert matplotlib.rcParams.copy() == before


def test_old_files_are_replaced_and_keep_no_trace(descent, summary, scene, tmp_path):
    (tmp_path / "midpoint.csv").write_text("old")
    write_pictures(descent, summary, scene, tmp_path)
    assert (tmp_path / "midpoint.csv").read_text().startswith("time_s,midpoint_m\n0.0,-0.0\n")


def test_a_place_that_is_taken_is_an_error_and_nothing_half_written_stays(descent, summary, scene, tmp_path):
    (tmp_path / "shapes.png").mkdir()
    with pytest.raises(OSError, match=r"shapes\.png"):
        write_pictures(descent, summary, scene, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["shapes.png"]


def test_a_folder_that_cannot_be_made_is_an_error(descent, summary, scene, tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError, match="file"):
        write_pictures(descent, summary, scene, tmp_path / "file")


def test_a_run_that_cannot_be_drawn_leaves_no_file(descent, summary, scene, tmp_path):
    with pytest.raises(KeyError):
        write_pictures(descent.drop_vars("energy_kinetic"), summary, scene, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_write_that_fails_midway_keeps_the_old_file(tmp_path, monkeypatch):
    target = tmp_path / "table.csv"
    target.write_bytes(b"old")

    def full(self: Path, other: Path) -> Path:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(OSError, match="No space"):
        files.replace_atomically(target, b"new")
    assert target.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [target]


@pytest.mark.parametrize(
    ("sags", "times"),
    [
        ([0.01], [0.0]),
        ([0.0], [0.0]),
        ([0.0, 1e-9], [0.0, 1e-7]),
        ([0.0, 0.0, 0.0], [0.0, 1.0, 2.0]),
        ([0.0, 1e9], [0.0, 1e9]),
        ([0.0, 0.01, 1e100], [0.0, 1.0, 2.0]),
        ([0.0, 0.004, 0.01], [0.0, 0.013, 0.0171]),
    ],
    ids=["one-frame", "one-frame-at-rest", "minute", "at-rest", "huge", "runaway", "ended-early"],
)
@pytest.mark.parametrize("cells", [1, 160])
def test_whatever_a_run_leaves_is_drawn_without_a_warning(scene, summary, make_run, tmp_path, sags, times, cells):
    data = make_run(scene, np.array(sags), np.array(times), cells)
    assert [path.name for path in write_pictures(data, summary, scene, tmp_path)] == NAMES


def test_an_early_end_is_the_end_of_the_axes(descent, summary, scene):
    early = descent.isel(time=slice(0, 38))
    axes = midpoint_figure(early, summary, scene).axes[0]
    assert axes.get_xlabel() == "time [ms]"
    assert axes.get_xlim() == pytest.approx((0.0, 370.0))
    line = axes.lines[1]
    np.testing.assert_allclose(line.get_ydata(), 1e3 * early["midpoint"].values)


def test_the_far_axes_are_the_papers_dimensionless_ones(descent, summary, scene):
    axes = midpoint_figure(descent, summary, scene).axes[0]
    right, top = (child for child in axes.child_axes)
    right.figure.canvas.draw()
    assert axes.get_ylabel() == "midpoint height [mm]"
    assert right.get_ylabel() == "midpoint height [% of L]"
    np.testing.assert_allclose(np.array(right.get_ylim()) * 2.0, axes.get_ylim())
    # t sqrt(E/rho)/L of 2 s, the paper's 10 alpha = 460 nearly
    assert top.get_xlim()[1] == pytest.approx(2.0 * np.sqrt(4e6 / 1900) / 0.2)


def test_imbalance_is_what_is_missing_from_the_budget():
    energies = {
        "energy_kinetic": [0.0, 1.0, 1.5],
        "energy_elastic": [0.5, 0.5, 1.0],
        "energy_potential": [10.0, 7.0, 3.0],
        "energy_dissipated": [0.0, 1.0, 4.0],
        "energy_gradient": [0.0, 0.0, 0.5],
        "energy_surface": [0.0, 0.0, 0.0],
        "work_external": [0.0, -1.0, -0.5],
    }
    data = xr.Dataset({name: ("time", value) for name, value in energies.items()})
    imbalance, largest = energy_imbalance(data)
    np.testing.assert_allclose(imbalance, [0.0, 0.0, 0.0])
    assert largest == 10.0
    data["energy_dissipated"] = ("time", [0.0, 1.0, 4.25])
    np.testing.assert_allclose(energy_imbalance(data)[0], [0.0, 0.0, 0.25])


def test_energy_picture_shows_five_energies_in_one_unit_and_the_relative_imbalance(descent, summary, scene):
    upper, lower = sorted(energy_figure(descent, summary, scene).axes, key=lambda axes: -axes.get_position().y0)
    assert upper.get_ylabel() == "energy [µJ]"
    drawn = {line.get_label(): line.get_ydata() for line in upper.lines}
    np.testing.assert_allclose(drawn["potential"], 1e6 * descent["energy_potential"].values)
    assert {"kinetic", "elastic", "dissipated", "external work"} < set(drawn)
    imbalance, largest = energy_imbalance(descent)
    assert lower.get_ylabel() == "imbalance /\nlargest [ppm]"
    np.testing.assert_allclose(lower.lines[0].get_ydata(), 1e6 * imbalance / largest)


@pytest.mark.parametrize(
    ("text", "shown"), [("a $x^{ b", "a $x^{ b"), ("two\nlines", "two lines"), ("5 µm – 漢", "5 µm – ?")]
)
def test_titles_are_made_printable(text, shown):
    assert printable(text) == shown


def test_awkward_titles_do_not_stop_a_report(descent, summary, make_scene, tmp_path):
    made = write_pictures(descent, summary, make_scene(title="$\\frac{$ 漢字 " + 200 * "long "), tmp_path)
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in made if path.suffix == ".png")
    assert len(made) == len(NAMES)


def test_importing_the_report_loads_no_plotting_and_drawing_loads_no_pyplot():
    code = (
        "import sys, softcat_sym.plotting, softcat_sym.plotting.terminal, softcat_sym.plotting.terminal\n"
        "assert not {'matplotlib', 'rich', 'casadi', 'sympy', 'xarray'} & set(sys.modules)\n"
        "import softcat_sym.plotting.run\n"
        "assert not {'matplotlib.pyplot', 'casadi', 'sympy'} & set(sys.modules)\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)
