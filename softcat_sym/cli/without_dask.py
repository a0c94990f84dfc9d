"""One filament in one process, on a machine that also has Dask."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator


@contextlib.contextmanager
def without_dask() -> Iterator[None]:
    """Let xarray find no Dask meanwhile, unless one of them is loaded already.

    Where Dask is installed, xarray loads all of it to ask whether an array of NumPy's is one of Dask's: 0.7 s. For a
    command that has no other use of it, and ends soon: xarray goes on without.
    """
    if {"dask", "xarray"} & set(sys.modules):
        yield
        return
    sys.modules["dask"] = None  # type: ignore[assignment]  # by which an import finds that it is not there
    try:
        yield
    finally:
        del sys.modules["dask"]
