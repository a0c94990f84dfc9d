"""Filaments as VTK files for ParaView; needs meshio, an optional extra."""

from __future__ import annotations

from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING
from xml.sax.saxutils import quoteattr

import numpy as np
from scipy.spatial.transform import Rotation

from softcat_sym.errors import SoftcatError
from softcat_sym.files import fill_atomically, new_folder, replace_atomically, written_together
from softcat_sym.results.fields import VARIABLES, variable_of

if TYPE_CHECKING:
    from softcat_sym.results.run import Run

SERIES = "filament.pvd"
"""The file to open: it names one mesh for each frame, with its time in s."""


def require_meshio() -> None:
    """Raise SoftcatError if meshio is not installed."""
    if find_spec("meshio") is None:
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
    import meshio

    folder, digits, written, rows = Path(directory), max(2, len(str(len(time) - 1))), list[Path](), ""
    with new_folder(folder), written_together():
        for frame, at in enumerate(time.tolist()):
            mesh = meshio.Mesh(
                places[frame],
                [("line", cells)],
                point_data={name: values[frame] for name, values in points.items()},
                cell_data={name: [np.asarray(fields[name][frame])] for name in names},
            )
            path = folder / f"{Path(SERIES).stem}-{frame:0{digits}d}.vtu"
            fill_atomically(path, partial(mesh.write, file_format="vtu"))
            written.append(path)
            rows += f'    <DataSet timestep="{at!r}" file={quoteattr(path.name)}/>\n'
        content = (
            '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1">\n  <Collection>\n'
            f"{rows}  </Collection>\n</VTKFile>\n"
        )
        return [replace_atomically(folder / SERIES, content.encode()), *written]
