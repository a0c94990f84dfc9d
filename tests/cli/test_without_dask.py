"""A run of one filament does not wait for Dask, which is there again afterwards."""

from __future__ import annotations

import subprocess
import sys

import pytest

pytest.importorskip("dask.array")

ALONE = """
import sys
from softcat_sym.cli.without_dask import without_dask
with without_dask():
    import xarray as xr
    data = xr.Dataset({"a": ("x", [1.0, 2.0])}, coords={"x": [0.0, 1.0]})
    assert len(bytes(data.to_netcdf(engine="h5netcdf"))) > 1000
assert not any(name.startswith(("dask.", "distributed")) for name in sys.modules), "that is what takes long"
import dask.array
assert dask.array.ones(3).sum().compute() == 3
"""

ALREADY_THERE = """
import xarray as xr
from softcat_sym.cli.without_dask import without_dask
with without_dask():
    assert xr.DataArray([1.0, 2.0]).chunk(1).sum().compute() == 3
"""


@pytest.mark.parametrize("program", [ALONE, ALREADY_THERE], ids=["alone", "in a process that uses it"])
def test_dask_is_not_loaded_for_arrays_of_numpy(program: str) -> None:
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
