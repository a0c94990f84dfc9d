"""All files of one run."""

from __future__ import annotations

import time
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from softcat_sym.report import write_pictures

if TYPE_CHECKING:
    from softcat_sym.trajectory import Trajectory


@dataclass(frozen=True)
class WrittenRun:
    """What a run left behind.

    Attributes
    ----------
    files : tuple of pathlib.Path
        In the order of interest.
    summary : dict
        As in ``summary.json``, with the time that the writing took.
    """

    files: tuple[Path, ...]
    summary: dict[str, Any]


def write_run(trajectory: Trajectory, directory: str | Path, style: str = "screen") -> WrittenRun:
    """Write what ``softcat run`` leaves behind: trajectory, summary, resolved scene, pictures and the midpoint table.

    The summary goes last, so that it can state how long the writing took.

    Parameters
    ----------
    trajectory : Trajectory
        The run.
    directory : str or pathlib.Path
        Where the files go; made if missing.
    style : str
        Of the pictures: ``screen``, ``column`` or ``page``.

    Raises
    ------
    OSError
        If the directory cannot be made or written.
    """
    from softcat_sym.trajectory.files import write_scene, write_summary, write_trajectory

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
