"""The midpoint as a table."""

from __future__ import annotations

import xarray as xr


def midpoint_csv(data: xr.Dataset) -> bytes:
    """Tabulate the midpoint.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory with ``time`` [s] and ``midpoint`` [m].

    Returns
    -------
    bytes
        A CSV file with the columns ``time_s`` and ``midpoint_m``; every number reads back exactly.
    """
    pairs = zip(data["time"].values.tolist(), data["midpoint"].values.tolist(), strict=True)
    return "".join(["time_s,midpoint_m\n", *(f"{time!r},{height!r}\n" for time, height in pairs)]).encode()
