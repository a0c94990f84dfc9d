"""Pictures, tables and terminal output of a run. Matplotlib and rich are loaded when they are used."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.report.contract import PicturedScene, Summary

__all__ = ["write_pictures"]


def write_pictures(
    data: xr.Dataset, summary: Summary, scene: PicturedScene, directory: str | Path, style: str = "screen"
) -> list[Path]:
    """Write ``midpoint.png``, ``shapes.png``, ``energy.png``, ``space-time.png`` and ``midpoint.csv``.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory with dims time, node, cell; besides the variables of ``trajectory.nc`` it holds ``thickness`` [m],
        ``stress_mean`` and ``stress_bending`` [Pa] (time, cell): the stress is stress_mean + stress_bending * zeta.
    summary : mapping
        What ``summary.json`` holds.
    scene : Scene
        The scene.
    directory : str or pathlib.Path
        Where the files go; made if missing.
    style : str
        ``screen``, or for print ``column`` or ``page``: then the same pictures, each as PDF too.

    Returns
    -------
    list of pathlib.Path
        The files written.

    Raises
    ------
    OSError
        If the directory cannot be written.
    """
    from softcat_sym.files import write_all
    from softcat_sym.report.table import midpoint_csv

    if style == "screen":
        contents = _for_screens(data, summary, scene)
    else:
        from softcat_sym.report.publication import publication_figures

        contents = publication_figures(data, summary, scene, style)
    return write_all(directory, {**contents, "midpoint.csv": midpoint_csv(data)})


def _for_screens(data: xr.Dataset, summary: Summary, scene: PicturedScene) -> dict[str, bytes]:
    from softcat_sym.report.canvas import png
    from softcat_sym.report.energy import energy_figure
    from softcat_sym.report.midpoint import midpoint_figure
    from softcat_sym.report.shapes import shapes_figure
    from softcat_sym.report.space_time import space_time_figure

    return {
        "midpoint.png": png(midpoint_figure(data, summary, scene)),
        "shapes.png": png(shapes_figure(data, summary, scene)),
        "energy.png": png(energy_figure(data, summary, scene)),
        "space-time.png": png(space_time_figure(data, summary, scene)),
    }
