"""All files of one run."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.plotting.style import PicturedScene, Summary
    from softcat_sym.results.trajectory import Trajectory


def write_pictures(
    data: xr.Dataset, summary: Summary, scene: PicturedScene, directory: str | Path, style: str = "screen"
) -> list[Path]:
    """Write ``midpoint.png``, ``shapes.png``, ``energy.png``, ``space-time.png`` and ``midpoint.csv``.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    from softcat_sym.files import write_all
    from softcat_sym.plotting.run import midpoint_csv

    if style == "screen":
        contents = _for_screens(data, summary, scene)
    else:
        from softcat_sym.plotting.publication import publication_figures

        contents = publication_figures(data, summary, scene, style)
    return write_all(directory, {**contents, "midpoint.csv": midpoint_csv(data)})


def _for_screens(data: xr.Dataset, summary: Summary, scene: PicturedScene) -> dict[str, bytes]:
    from softcat_sym.plotting.energy import energy_figure
    from softcat_sym.plotting.run import midpoint_figure
    from softcat_sym.plotting.shapes import shapes_figure
    from softcat_sym.plotting.space_time import space_time_figure
    from softcat_sym.plotting.style import png

    return {
        "midpoint.png": png(midpoint_figure(data, summary, scene)),
        "shapes.png": png(shapes_figure(data, summary, scene)),
        "energy.png": png(energy_figure(data, summary, scene)),
        "space-time.png": png(space_time_figure(data, summary, scene)),
    }


@dataclass(frozen=True)
class WrittenRun:
    """What a run left behind."""

    files: tuple[Path, ...]  # In the order of interest
    summary: dict[str, Any]  # As in ``summary.json``, with the time that the writing took


def write_run(trajectory: Trajectory, directory: str | Path, style: str = "screen") -> WrittenRun:
    """Write what ``softcat run`` leaves behind: trajectory, summary, resolved scene, pictures and the midpoint table.

    The summary goes last, so that it can state how long the writing took.
    """
    from softcat_sym.results.files import write_scene, write_summary, write_trajectory

    began = time.perf_counter()
    folder = Path(directory)
    folder.mkdir(parents=True, exist_ok=True)
    pictures = write_pictures(trajectory.data, trajectory.summary, trajectory.scene, folder, style)
    data = write_trajectory(trajectory.data, folder)
    scene = write_scene(trajectory.scene.to_toml(), folder)
    spent = time.perf_counter() - began
    wall = trajectory.summary["wall_s"]
    summary = {**trajectory.summary, "wall_s": {**wall, "write": spent, "total": wall["total"] + spent}}
    return WrittenRun((data, write_summary(summary, folder), scene, *pictures), summary)
