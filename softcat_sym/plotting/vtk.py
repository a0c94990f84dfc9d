"""Meshes and fields of the elements as VTK files, for ParaView and its like; needs meshio, an optional extra."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import quoteattr

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.files import fill_atomically, replace_atomically
from softcat_sym.reference.elements import ElementField, element_fields, strip_of

if TYPE_CHECKING:
    from softcat_sym.reference.elements import ElementRun
    from softcat_sym.scene.scene import Scene

SERIES = "elements.pvd"
"""The file to open: it names one mesh for each instant, with its time in s."""


def vtk_available() -> bool:
    """Whether meshio is installed."""
    return find_spec("meshio") is not None


def write_vtk(scene: Scene, run: ElementRun, directory: str | Path) -> list[Path]:
    """Write one ``elements-NN.vtu`` for each instant that was kept, and ``elements.pvd``, which lists them.

    The meshes are those of the half X >= 0 in their reference shape [m], quadratic quadrilaterals in the plane z = 0.
    At nodes: ``displacement`` [m]. For elements: ``plastic_shear_rate`` [1/s] and ``cauchy_stress`` [Pa] (nine
    components, row by row), means over the four Gauss points; ``plastic_shear_rate_at_points`` [1/s].
    """
    if not vtk_available():
        raise SoftcatError("VTK files are written by meshio, which is not installed: pip install 'softcat_sym[fem]'")
    strip, span = strip_of(scene, run), scene.filament.span
    nodes = np.column_stack([span * strip.position, np.zeros(len(strip.position))])
    fields = list(element_fields(scene, run))
    folder = Path(directory)
    folder.mkdir(parents=True, exist_ok=True)
    digits = max(2, len(str(len(fields) - 1)))
    written = {}
    for number, field in enumerate(fields):
        mesh = _mesh(nodes, strip.corner, field)
        path = folder / f"elements-{number:0{digits}d}.vtu"
        fill_atomically(path, lambda passing, mesh=mesh: mesh.write(passing, file_format="vtu"))  # type: ignore[misc]
        written[path] = field.time
    return [replace_atomically(folder / SERIES, _series(written)), *written]


def _mesh(nodes: np.ndarray[Any, Any], corner: np.ndarray[Any, Any], field: ElementField) -> Any:
    """A mesh of meshio; its quad8 numbers nodes as the elements do."""
    import meshio

    stress = np.zeros((len(corner), 3, 3))
    stress[:, :2, :2] = field.stress.mean(axis=1)
    return meshio.Mesh(
        nodes,
        [("quad8", corner)],
        point_data={"displacement": np.column_stack([field.displacement, np.zeros(len(nodes))])},
        cell_data={
            "plastic_shear_rate": [field.shear_rate.mean(axis=1)],
            "plastic_shear_rate_at_points": [field.shear_rate],
            "cauchy_stress": [stress.reshape(-1, 9)],
        },
    )


def _series(files: dict[Path, float]) -> bytes:
    rows = "".join(f'    <DataSet timestep="{time!r}" file={quoteattr(path.name)}/>\n' for path, time in files.items())
    return (
        '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n  <Collection>\n'
        f"{rows}  </Collection>\n</VTKFile>\n"
    ).encode()
