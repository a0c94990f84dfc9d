"""A run read back from the files that ``softcat run`` or ``Trajectory.save`` wrote."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.scene import Scene
from softcat_sym.solve import Outcome
from softcat_sym.trajectory.trajectory import Trajectory

if TYPE_CHECKING:
    import os

    import xarray as xr

_PLACES: Final = ("time", "X_node", "X_cell", "x", "y", "midpoint")
_FIELDS: Final = ("thickness", "stress_mean", "stress_bending", "yielded_fraction")
_ENERGIES: Final = ("kinetic", "elastic", "potential", "dissipated", "gradient")
_NEEDED: Final = (*_PLACES, *_FIELDS, *(f"energy_{name}" for name in _ENERGIES), "work_external")
_FORM = "accepted: a trajectory.nc that softcat run wrote, or the folder that holds it"


def open_run(directory: str | os.PathLike[str]) -> Trajectory:
    """Read a finished run again, as :func:`softcat_sym.simulate` returned it.

    Parameters
    ----------
    directory : str or path
        Folder into which ``softcat run`` or ``run.save`` wrote, or its ``trajectory.nc``.

    Returns
    -------
    Trajectory
        ``.data``, ``.scene``, ``.outcome``; ``.summary`` is that of the ``summary.json`` beside it, without one of this
        run it holds title and outcome only.

    Raises
    ------
    SoftcatError
        If there is no run of this program, or it is damaged.
    """
    path = Path(directory)
    path = path / "trajectory.nc" if path.is_dir() else path
    if not path.is_file():
        raise SoftcatError(f"{path}: no such file; {_FORM}")
    from softcat_sym.trajectory.files import read_netcdf

    try:
        data = read_netcdf(path)
    except OSError as error:
        raise SoftcatError(f"{path}: cannot be read as netCDF4 ({error}); {_FORM}") from None
    if "energy_gradient" in data and "energy_surface" not in data:
        # Of a run from before there was surface tension.
        data["energy_surface"] = 0 * data["energy_gradient"]
    missing = [name for name in _NEEDED if name not in data]
    text = data.attrs.get("scene")
    if missing or not isinstance(text, str) or not data.sizes.get("time"):
        lacking = ", ".join(missing) or ("its scene" if not isinstance(text, str) else "frames")
        raise SoftcatError(f"{path}: is no trajectory, it lacks {lacking}; {_FORM}")
    outcome = Outcome.__members__.get(str(data.attrs.get("outcome")))
    if outcome is None:
        raise SoftcatError(f"{path}: its outcome {data.attrs.get('outcome')!r} is not known; {_FORM}")
    try:
        scene = Scene.model_validate(tomllib.loads(text))
    except tomllib.TOMLDecodeError as error:
        raise SoftcatError(f"{path}: its scene cannot be read ({error}); {_FORM}") from None
    return Trajectory(scene, data, _summary(path, data), outcome, {})


def check_drawable(run: Trajectory) -> None:
    """Refuse a run that is not finite everywhere.

    Raises
    ------
    SoftcatError
        With the first variable that is not.
    """
    for name in (*_PLACES, "thickness"):
        if not np.isfinite(run.data[name].values).all():
            raise SoftcatError(f"{name} is not finite everywhere, so there is nothing to draw; {_FORM}")


def _summary(path: Path, data: xr.Dataset) -> dict[str, Any]:
    """The summary beside it, if that is of the same run."""
    told: dict[str, Any] = {"title": data.attrs.get("title", ""), "outcome": data.attrs.get("outcome", "")}
    try:
        read = json.loads(path.with_name("summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return told
    same = isinstance(read, dict) and read.get("midpoint_final_m") == float(data["midpoint"].values[-1])
    return read if same else told
