"""Filaments, and the meshes of our elements, as VTK files for ParaView; needs meshio, an optional extra."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import SoftcatError
from softcat_sym.files import fill_atomically, new_folder, replace_atomically, written_together
from softcat_sym.reference.elements import ElementField, ElementRun, element_fields, strip_of
from softcat_sym.results.fields import VARIABLES, variable_of

if TYPE_CHECKING:
    from softcat_sym.results.run import Run
    from softcat_sym.scene.scene import Scene

SERIES = "elements.pvd"
"""The file to open: it names one mesh for each instant, with its time in s."""


RUN_SERIES = "filament.pvd"
"""The same of a run."""


def vtk_available() -> bool:
    """Whether meshio is installed."""
    return find_spec("meshio") is not None


def write_vtk(scene: Scene, run: ElementRun, directory: str | Path) -> list[Path]:
    """Write one ``elements-NN.vtu`` for each instant that was kept, and ``elements.pvd``, which lists them.

    The meshes are those of the half X >= 0 in their reference shape [m], quadratic quadrilaterals in the plane z = 0.
    At nodes: ``displacement`` [m]. For elements: ``plastic_shear_rate`` [1/s] and ``cauchy_stress`` [Pa] (nine
    components, row by row), means over the four Gauss points; ``plastic_shear_rate_at_points`` [1/s].
    """
    require_meshio()
    strip, span = strip_of(scene, run), scene.filament.span
    nodes = np.column_stack([span * strip.position, np.zeros(len(strip.position))])
    fields = list(element_fields(scene, run))
    # Meshio's quad8 numbers nodes as the elements do.
    meshes = ((field.time, nodes, ("quad8", strip.corner), *_data_of(field)) for field in fields)
    return _written(Path(directory), SERIES, meshes, len(fields))


def require_meshio() -> None:
    """Raise SoftcatError if meshio is not installed."""
    if not vtk_available():
        raise SoftcatError("VTK files are written by meshio, which is not installed: pip install 'softcat_sym[fem]'")


def write_run_vtk(run: Run, directory: str | Path) -> list[Path]:
    """Write the centreline at every frame as ``filament-NNN.vtu``, and ``filament.pvd``, which lists them.

    Parameters
    ----------
    run : Run
        In its plane (z = 0) or in three dimensions.
    directory : str or pathlib.Path
        Where the files go; made if missing.

    Returns
    -------
    list of pathlib.Path
        What was written, the file to open first. Points are the nodes [m], with ``displacement`` [m] since the first
        frame, ``radius`` [m] for a tube, and in three dimensions the axes ``d1``, ``d2``, ``d3`` of the section; lines
        are the cells, with all that the run has of them in SI units.

    Raises
    ------
    SoftcatError
        If meshio is not installed.
    """
    require_meshio()
    fields, time = run.fields, np.asarray(run.fields["time"])
    places = np.stack([fields["x"], fields["y"], fields.get("z", 0 * fields["y"])], axis=-1)
    cells = np.column_stack([np.arange(places.shape[1] - 1), np.arange(1, places.shape[1])])
    names = [name for name in VARIABLES if name in fields and variable_of(name).dims == ("time", "cell")]
    thick = np.asarray(fields["thickness"])
    edges = np.concatenate([thick[:, :1], (thick[:, 1:] + thick[:, :-1]) / 2, thick[:, -1:]], axis=1)
    points = {"displacement": places - places[:1], "radius": edges / 2}
    if "quaternion" in fields:
        turns = Rotation.from_quat(np.roll(fields["quaternion"], -1, axis=-1).reshape(-1, 4)).as_matrix()
        points |= {f"d{n + 1}": turns[:, :, n].reshape(places.shape) for n in range(3)}
    meshes = (
        (
            float(at),
            places[frame],
            ("line", cells),
            {name: values[frame] for name, values in points.items()},
            {name: [np.asarray(fields[name][frame])] for name in names},
        )
        for frame, at in enumerate(time)
    )
    return _written(Path(directory), RUN_SERIES, meshes, len(time))


Mesh: TypeAlias = tuple[float, Floats, tuple[str, NDArray[Any]], dict[str, Floats], dict[str, list[Floats]]]
"""Time, nodes, cells, fields at nodes and of cells."""


def _written(folder: Path, series: str, meshes: Iterable[Mesh], count: int) -> list[Path]:
    """A file for every mesh, and the series that lists them with their times."""
    import meshio

    digits, written, rows = max(2, len(str(count - 1))), list[Path](), ""
    with new_folder(folder), written_together():
        for number, (time, nodes, cells, points, fields) in enumerate(meshes):
            mesh = meshio.Mesh(nodes, [cells], point_data=points, cell_data=fields)
            path = folder / f"{Path(series).stem}-{number:0{digits}d}.vtu"
            fill_atomically(path, partial(mesh.write, file_format="vtu"))
            written.append(path)
            rows += f'    <DataSet timestep="{time!r}" file={quoteattr(path.name)}/>\n'
        content = (
            '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n  <Collection>\n'
            f"{rows}  </Collection>\n</VTKFile>\n"
        )
        return [replace_atomically(folder / series, content.encode()), *written]


def _data_of(field: ElementField) -> tuple[dict[str, Floats], dict[str, list[Floats]]]:
    """Displacements at the nodes; rates and stresses of elements."""
    stress = np.zeros((len(field.stress), 3, 3))
    stress[:, :2, :2] = field.stress.mean(axis=1)
    cells = {
        "plastic_shear_rate": [field.shear_rate.mean(axis=1)],
        "plastic_shear_rate_at_points": [field.shear_rate],
        "cauchy_stress": [stress.reshape(-1, 9)],
    }
    return {"displacement": np.pad(field.displacement, ((0, 0), (0, 1)))}, cells
