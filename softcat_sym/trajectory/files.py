"""A trajectory on disk: netCDF4, JSON and the resolved scene, each replaced whole or not at all; and read again."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import xarray as xr

from softcat_sym.files import replace_atomically


def write_trajectory(data: xr.Dataset, directory: Path) -> Path:
    """Write ``trajectory.nc``.

    It is made in memory: where the disk is full, HDF5 would not only fail, but end the program as it closes the file.
    """
    encoding = {name: {"zlib": True, "complevel": 1} for name in data.data_vars if data[name].ndim > 1}
    content = data.to_netcdf(engine="h5netcdf", encoding=encoding)
    return replace_atomically(directory / "trajectory.nc", bytes(content))


def read_netcdf(path: Path) -> xr.Dataset:
    """Read a netCDF file into memory.

    Raises
    ------
    OSError
        If it cannot be read, or is none.
    """
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
