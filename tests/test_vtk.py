"""VTK files of a run: what meshio reads back is what was run."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.plotting import vtk

meshio = pytest.importorskip("meshio")
pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler: install gcc, or set CC")


@pytest.mark.parametrize("changes", [{}, pytest.param({"load.direction": [0.0, -1.0, 1.0]}, marks=pytest.mark.slow)])
def test_a_run_is_a_row_of_lines(changes: dict[str, object], tmp_path: Path) -> None:
    """Nodes, cells and time as in the trajectory; the axes of a section are those of its turn."""
    quick = {"numerics.cells": 6, "numerics.estimate": False, "run.frames": 4, "run.duration": "50 ms"}
    filament = sc.simulate(sc.load_scene("continual-descent", {**quick, **changes}))
    files = vtk.write_run_vtk(filament, tmp_path)
    assert sorted(files) == sorted(tmp_path.iterdir()) and files[0].name == vtk.SERIES
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
