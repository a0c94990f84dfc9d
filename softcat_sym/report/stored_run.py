"""A run read back from its ``trajectory.nc``, to be drawn again."""

from __future__ import annotations

import json
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from softcat_sym.errors import SoftcatError

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.scene import Scene

_PLACES: Final = ("time", "X_node", "X_cell", "x", "y", "midpoint")
_FIELDS: Final = ("thickness", "stress_mean", "stress_bending", "yielded_fraction")
_ENERGIES: Final = ("kinetic", "elastic", "potential", "dissipated", "gradient")
_NEEDED: Final = (*_PLACES, *_FIELDS, *(f"energy_{name}" for name in _ENERGIES), "work_external")
_FORM = "accepted: a trajectory.nc that softcat run wrote, or the folder that holds it"


@dataclass(frozen=True)
class StoredRun:
    """A finished run.

    Attributes
    ----------
    data : xarray.Dataset
        Trajectory, in memory.
    summary : dict
        What ``summary.json`` beside it holds; without one, title and outcome.
    scene : Scene
        As resolved.
    scene_text : str
        Its TOML.
    """

    data: xr.Dataset
    summary: dict[str, Any]
    scene: Scene
    scene_text: str


def read_run(place: str | Path) -> StoredRun:
    """Read a trajectory, its scene, and the summary beside it.

    Parameters
    ----------
    place : str or path
        Of ``trajectory.nc``, or of its folder.

    Raises
    ------
    SoftcatError
        If there is none, or it is not a trajectory of this program.
    """
    import xarray as xr

    from softcat_sym.scene import Scene

    path = Path(place)
    path = path / "trajectory.nc" if path.is_dir() else path
    if not path.is_file():
        raise SoftcatError(f"{path}: no such file; {_FORM}")
    try:
        with xr.open_dataset(path, engine="h5netcdf") as opened:
            data = opened.load()
    except (OSError, ValueError, KeyError, RuntimeError) as error:
        reason = " ".join(str(error).split())[:120]
        raise SoftcatError(f"{path}: cannot be read as netCDF4 ({reason}); {_FORM}") from None
    if "energy_gradient" in data and "energy_surface" not in data:
        # Of a run from before there was surface tension.
        data["energy_surface"] = 0 * data["energy_gradient"]
    missing = [name for name in _NEEDED if name not in data]
    text = data.attrs.get("scene")
    if missing or not isinstance(text, str) or not data.sizes.get("time"):
        lacking = ", ".join(missing) or ("its scene" if not isinstance(text, str) else "frames")
        raise SoftcatError(f"{path}: is no trajectory, it lacks {lacking}; {_FORM}")
    broken = [name for name in (*_PLACES, "thickness") if not bool(np.isfinite(data[name].values).all())]
    if broken:
        raise SoftcatError(f"{path}: {broken[0]} is not finite everywhere, so there is nothing to draw; {_FORM}")
    try:
        scene = Scene.model_validate(tomllib.loads(text))
    except tomllib.TOMLDecodeError as error:
        raise SoftcatError(f"{path}: its scene cannot be read ({error}); {_FORM}") from None
    return StoredRun(data, _summary(path, data), scene, text)


def _summary(path: Path, data: xr.Dataset) -> dict[str, Any]:
    """The summary beside it, if that is of the same run."""
    told: dict[str, Any] = {"title": data.attrs.get("title", ""), "outcome": data.attrs.get("outcome", "")}
    try:
        read = json.loads(path.with_name("summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return told
    same = isinstance(read, dict) and read.get("midpoint_final_m") == float(data["midpoint"].values[-1])
    return read if same else told
