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
        A CSV file with the columns ``time_s`` and ``midpoint_m``; every number reads back exactly. Of an answer that is
        refused it has a third column, ``refused``, that holds the outcome.
    """
    outcome = data.attrs.get("outcome", "solved")
    head, stamp = ("", "") if outcome == "solved" else (",refused", f",{outcome}")
    pairs = zip(data["time"].values.tolist(), data["midpoint"].values.tolist(), strict=True)
    lines = (f"{time!r},{height!r}{stamp}\n" for time, height in pairs)
    return "".join([f"time_s,midpoint_m{head}\n", *lines]).encode()
