"""A trajectory on disk: netCDF4, JSON and the resolved scene, each replaced whole or not at all."""

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


def write_summary(summary: dict[str, Any], directory: Path) -> Path:
    """Write ``summary.json``."""
    text = json.dumps(summary, indent=2, allow_nan=False) + "\n"
    return replace_atomically(directory / "summary.json", text.encode())


def write_scene(toml: str, directory: Path) -> Path:
    """Write ``scene.toml``, the scene as resolved."""
    return replace_atomically(directory / "scene.toml", toml.encode())
