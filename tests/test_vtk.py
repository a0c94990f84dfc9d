"""VTK files of the elements: what meshio reads back is what was run."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.plotting import vtk
from softcat_sym.plotting.vtk import write_vtk
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.reference.elements import ElementRun, element_fields, run_elements
from softcat_sym.scene.scene import Scene, elastic_time

meshio = pytest.importorskip("meshio")
pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: install gcc, or set CC")


def shortened(scene: Scene, elastic_times: float, frames: int) -> Scene:
    """The scene over another time, in L sqrt(rho/E)."""
    return scene.replace({"run.duration": f"{elastic_times * elastic_time(scene)!r} s", "run.frames": frames})


SCENE = shortened(sc.load_scene("continual-descent"), 15.0, 4)


@pytest.fixture(scope="module")
def run() -> ElementRun:
    return run_elements(SCENE, Mesh(12, 2))


def read(folder: Path) -> list[tuple[float, Any]]:
    """Time and mesh of every file that the series names."""
    rows = ET.parse(folder / vtk.SERIES).getroot().iter("DataSet")
    return [(float(row.attrib["timestep"]), meshio.read(folder / row.attrib["file"])) for row in rows]


def test_series_reads_back_with_the_deformed_centreline_of_the_run(run: ElementRun, tmp_path: Path) -> None:
    written = write_vtk(SCENE, run, tmp_path / "vtk")
    assert sorted(written) == sorted((tmp_path / "vtk").iterdir())
    found = read(tmp_path / "vtk")
    assert [time for time, _ in found] == pytest.approx(list(run.rate_time), abs=0)
    for (_, mesh), rate in zip(found, run.rate, strict=True):
        assert mesh.cells[0].type == "quad8" and len(mesh.cells[0].data) == 24
        assert mesh.cell_data["plastic_shear_rate_at_points"][0] == pytest.approx(math.sqrt(3) * rate, abs=0)
    assert run.rate[-1].max() > 0
    mesh = found[-1][1]
    centre = np.isclose(mesh.points[:, 1], 0, atol=1e-12)
    order = np.argsort(mesh.points[centre, 0])
    place = (mesh.points + mesh.point_data["displacement"])[centre][order]
    assert place[:, 0] == pytest.approx(run.x[-1], rel=1e-12)
    assert place[:, 1] == pytest.approx(run.y[-1], rel=1e-12)
    # Corners counter-clockwise, then the middle of each side; the areas add up to half the filament.
    at = found[0][1].points[found[0][1].cells[0].data]
    corner, middle = at[:, :4], at[:, 4:]
    following = np.roll(corner, -1, axis=1)
    assert middle == pytest.approx((corner + following) / 2, abs=1e-15)
    area = 0.5 * (corner[..., 0] * following[..., 1] - corner[..., 1] * following[..., 0]).sum(axis=1)
    assert area.min() > 0
    assert area.sum() == pytest.approx(SCENE.filament.span * SCENE.filament.thickness / 2, rel=1e-12)


def test_stress_gives_the_rate_that_was_recorded_and_its_mean_is_in_the_file(run: ElementRun, tmp_path: Path) -> None:
    """Bingham's law by hand, rate = (sigma_eq - sY)/eta, with the stress from displacements and plastic state."""
    *_, field = element_fields(SCENE, run)
    along, shear, across = field.stress[..., 0, 0], field.stress[..., 0, 1], field.stress[..., 1, 1]
    equivalent = np.sqrt(along**2 - along * across + across**2 + 3 * shear**2)
    rate = np.maximum(equivalent - SCENE.material.yield_stress, 0) / SCENE.material.viscosity
    assert rate.max() > 0
    assert math.sqrt(3) * rate == pytest.approx(field.shear_rate, abs=2e-3 * math.sqrt(3) * rate.max())
    write_vtk(SCENE, run, tmp_path)
    written = read(tmp_path)[-1][1].cell_data["cauchy_stress"][0].reshape(-1, 3, 3)
    assert written[:, :2, :2] == pytest.approx(field.stress.mean(axis=1), rel=1e-12)
    assert not written[:, 2].any() and not written[:, :, 2].any()


@pytest.mark.parametrize("changes", [{}, pytest.param({"load.direction": [0.0, -1.0, 1.0]}, marks=pytest.mark.slow)])
def test_a_run_is_a_row_of_lines(changes: dict[str, object], tmp_path: Path) -> None:
    """Nodes, cells and time as in the trajectory; the axes of a section are those of its turn."""
    quick = {"numerics.cells": 6, "numerics.estimate": False, "run.frames": 4, "run.duration": "50 ms"}
    filament = sc.simulate(sc.load_scene("continual-descent", {**quick, **changes}))
    files = vtk.write_run_vtk(filament, tmp_path)
    assert sorted(files) == sorted(tmp_path.iterdir()) and files[0].name == vtk.RUN_SERIES
    rows = list(ET.parse(files[0]).getroot().iter("DataSet"))
    data = filament.data
    assert [float(row.attrib["timestep"]) for row in rows] == data.time.values.tolist()
    mesh = meshio.read(tmp_path / rows[-1].attrib["file"])
    aside = data.z.values[-1] if changes else 0 * data.y.values[-1]
    assert mesh.points == pytest.approx(np.column_stack([data.x.values[-1], data.y.values[-1], aside]), abs=0)
    assert mesh.cells[0].type == "line" and mesh.cells[0].data.tolist() == [[n, n + 1] for n in range(12)]
    assert mesh.cell_data["tension"][0] == pytest.approx(data.tension.values[-1], abs=0)
    assert mesh.point_data["displacement"] == pytest.approx(mesh.points - meshio.read(files[1]).points, abs=0)
    assert ("d1" in mesh.point_data) == bool(changes)
    if changes:
        along, width = mesh.point_data["d1"][6], mesh.point_data["d3"][6]
        assert along == pytest.approx([1, 0, 0], abs=1e-6)
        assert width == pytest.approx([0, 0, 1], abs=1e-6)
