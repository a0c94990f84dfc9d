"""A trajectory on disk: netCDF4, JSON and the resolved scene, each replaced whole or not at all; and read again."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import xarray as xr

from softcat_sym.errors import SoftcatError
from softcat_sym.files import replace_atomically
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.store import Form, packed, unpacked

if TYPE_CHECKING:
    import os


def write_trajectory(data: xr.Dataset, directory: Path) -> Path:
    """Write ``trajectory.nc``.

    It is made in memory: where the disk is full, HDF5 would not only fail, but end the program as it closes the file.
    """
    encoding = {name: {"zlib": True, "complevel": 1} for name in data.data_vars if data[name].ndim > 1}
    content = data.to_netcdf(engine="h5netcdf", encoding=encoding)
    return replace_atomically(directory / "trajectory.nc", bytes(content))


def read_netcdf(path: Path) -> xr.Dataset:
    """Read a netCDF file into memory."""
    import h5py

    try:
        # A file that fails here would fail h5netcdf half made, which then complains a second time as it is closed.
        with h5py.File(path, "r") as file:
            file.attrs.get("_nc3_strict")
        with xr.open_dataset(path, engine="h5netcdf") as opened:
            return opened.load()
    except (OSError, ValueError, LookupError, RuntimeError, TypeError, AttributeError, OverflowError) as error:
        raise OSError(" ".join(str(error).split())[:120] or type(error).__name__) from error


def write_summary(summary: dict[str, Any], directory: Path) -> Path:
    """Write ``summary.json``."""
    text = json.dumps(summary, indent=2, allow_nan=False) + "\n"
    return replace_atomically(directory / "summary.json", text.encode())


def write_scene(toml: str, directory: Path) -> Path:
    """Write ``scene.toml``, the scene as resolved."""
    return replace_atomically(directory / "scene.toml", toml.encode())


_TOLD = "told"


def trajectory_form(scene: Scene) -> Form[Trajectory]:
    """Return the form of runs of a scene, whatever its title was when it was run."""
    return Form(_written, lambda content: _read(scene, content))


def _written(run: Trajectory) -> bytes:
    data = run.data
    told = {
        "summary": run.summary,
        "outcome": run.outcome.name,
        "missing_effect": run.missing_effect,
        "attrs": data.attrs,
        "variables": {str(name): [list(one.dims), one.attrs] for name, one in data.variables.items()},
        "coordinates": [str(name) for name in data.coords],
    }
    return packed({_TOLD: np.array(json.dumps(told))} | {str(name): one.values for name, one in data.variables.items()})


def _read(scene: Scene, content: bytes) -> Trajectory:
    arrays = unpacked(content)
    told = json.loads(str(arrays[_TOLD]))
    variables = {name: (dims, arrays[name], attrs) for name, (dims, attrs) in told["variables"].items()}
    coordinates = {name: variables.pop(name) for name in told["coordinates"]}
    data = xr.Dataset(variables, coords=coordinates, attrs=told["attrs"])
    data.attrs |= {"title": scene.title, "scene": scene.to_toml()}
    summary = told["summary"] | {"title": scene.title}
    return Trajectory(scene, data, summary, Outcome[told["outcome"]], told["missing_effect"])


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
    """Refuse a run that is not finite everywhere."""
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
