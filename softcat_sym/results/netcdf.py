"""``trajectory.nc``: the arrays of a run in a netCDF4 file, written in HDF5's own terms, and read."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
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


class _Unfailing(io.FileIO):
    """A file for HDF5, which does not hear of a full disk; what finds no room is kept in memory, to be read again."""

    def __init__(self, path: Path) -> None:
        super().__init__(path, "x+")
        self.error: OSError | None = None
        self._lost: list[tuple[int, bytes]] = []

    def check(self) -> None:
        """Raise what HDF5 has not heard of."""
        if self.error is not None:
            raise self.error

    def write(self, content: Any, /) -> int:
        place, rest = self.tell(), memoryview(content).cast("B")
        size = len(rest)
        try:
            self.check()
            while rest:
                rest = rest[super().write(rest) :]
        except OSError as error:
            self.error = error
            self._lost.append((place, bytes(content)))
        return size

    def readinto(self, buffer: Any, /) -> int:
        place, view = self.tell(), memoryview(buffer).cast("B")
        super().readinto(buffer)
        for at, content in self._lost:
            first, last = max(at, place), min(at + len(content), place + len(view))
            if first < last:
                view[first - place : last - place] = content[first - at : last - at]
        return len(view)

    def truncate(self, size: int | None = None, /) -> int:
        return super().truncate(size) if self.error is None else size or 0


@contextmanager
def netcdf_file(path: Path) -> Iterator[tuple[Any, Callable[[], None]]]:
    """A new file for what is too large to be made in memory, and what raises OSError as soon as the disk is full."""
    import h5netcdf

    with _Unfailing(path) as stream:
        with h5netcdf.File(stream, "w") as file:
            yield file, stream.check
        stream.check()


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
