"""``trajectory.nc``: the arrays of a run in a netCDF4 file, written in HDF5's own terms, and read."""

from __future__ import annotations

import io
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.results.fields import variable_of, variables_of

_SIZES: Final = {"time": "time", "node": "X_node", "cell": "X_cell", "dense_time": "dense_time"}
"""Each dimension, and the coordinate that is as long."""

_CHUNK: Final = 1 << 20
"""Most bytes of an array that are packed as one."""


_DATASET: Final[dict[str, Any]] = {"track_order": True, "track_times": False}
"""As netCDF4 asks; and the same run gives the same bytes."""


def variable_attrs(name: str) -> dict[str, str]:
    """Attributes of a variable in the file."""
    return {"units": variable_of(name).unit, "long_name": variable_of(name).meaning}


def netcdf_bytes(fields: Mapping[str, Floats], attrs: Mapping[str, str]) -> bytes:
    """Make the file in memory: on a full disk HDF5 would not only fail, but end the program as it closes the file.

    It is as h5netcdf and xarray write it, which take ten times as long to look up what they have written themselves.
    """
    import h5py

    sizes = {name: len(fields[of]) for name, of in _SIZES.items() if of in fields}
    sizes |= {"component": 4} if "quaternion" in fields else {}
    known = variables_of(fields)
    numbers = {name: number for number, name in enumerate(sizes)}
    stream = io.BytesIO()
    with h5py.File(stream, "w", track_order=True) as file:
        file.attrs.update(attrs)
        made = f"version=2,softcat_sym,hdf5={h5py.version.hdf5_version},h5py={h5py.version.version}"
        file.attrs["_NCProperties"] = np.bytes_(made)
        for name, size in sizes.items():
            if name not in known:
                scale = file.create_dataset(name, (size,), ">f4", **_DATASET)
                scale.make_scale(f"This is a netCDF dimension but not a netCDF variable.{size:10d}")
                scale.attrs["_Netcdf4Dimid"] = np.int32(numbers[name])
        for name, variable in known.items():
            places, values = [numbers[each] for each in variable.dims], np.asarray(fields[name], dtype=float)
            packing: dict[str, Any] = {}
            if values.ndim > 1:  # Many frames at once
                frames = max(1, min(len(values), _CHUNK // values[0].nbytes))
                packing = {"chunks": (frames, *values.shape[1:]), "compression": "gzip", "compression_opts": 1}
            written = file.create_dataset(name, data=values, fillvalue=np.nan, **_DATASET, **packing)
            if name in sizes:
                written.make_scale(name)
            else:
                for axis, each in enumerate(variable.dims):
                    written.dims[axis].attach_scale(file[each])
            written.attrs["_Netcdf4Coordinates"] = np.array(places, np.int32)
            written.attrs["_Netcdf4Dimid"] = np.int32(places[0])
            written.attrs["_FillValue"] = np.array([np.nan])
            written.attrs.update(variable_attrs(name))
            if len(places) > 1:
                written.attrs["coordinates"] = f"X_{variable.dims[1]}"
    return stream.getvalue()


def read_netcdf(path: Path) -> tuple[dict[str, Floats], dict[str, Any]]:
    """Arrays and attributes of a netCDF file; OSError, in one line, if it is none."""
    import h5netcdf
    import h5py

    try:
        # A file that fails here would fail h5netcdf half made, which then complains a second time as it is closed.
        with h5py.File(path, "r") as raw:
            raw.attrs.get("_nc3_strict")
        with h5netcdf.File(path, "r") as file:
            fields = {
                name: np.asarray(file.variables[name][...], dtype=float)
                for name, known in variables_of(file.variables).items()
                if file.variables[name].dimensions == known.dims
            }
            return fields, dict(file.attrs)
    except (OSError, ValueError, LookupError, RuntimeError, TypeError, AttributeError, OverflowError) as error:
        raise OSError(" ".join(str(error).split())[:120] or type(error).__name__) from error
