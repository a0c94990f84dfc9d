"""Choosing the frames that tell a run apart."""

from __future__ import annotations

import numpy as np
import xarray as xr
from numpy.typing import NDArray

# A change of shape counts fully, of the yielded zones a third, mere lapse of time a tenth.
_YIELD_WEIGHT = 0.3
_TIME_WEIGHT = 0.1
# Two frames closer than this in those measures look the same on paper.
_SAME = 0.02


def telling_frames(data: xr.Dataset, count: int = 5) -> list[int]:
    """Choose frames whose shapes and yielded zones differ most, the final one among them.

    Each frame added is the one farthest from those already chosen, so a steady descent is cut into equal drops
    and a long rest takes one frame. The first frame, the undeformed filament, and whatever looks like it are taken only
    when there is nothing else.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory with ``x``, ``y`` (time, node), ``yielded_fraction`` (time, cell) and ``time``.
    count : int
        The most frames wanted.

    Returns
    -------
    list of int
        Indices along ``time``, ascending; fewer than ``count`` if the run has fewer that differ.
    """
    last = data.sizes["time"] - 1
    if last <= 0:
        return [0]
    x, y = _compressed(data["x"].values), _compressed(data["y"].values)
    scale = max(float(np.ptp(x, axis=0).max()), float(np.ptp(y, axis=0).max()))
    fraction = np.asarray(data["yielded_fraction"].values, dtype=np.float64)
    time = np.asarray(data["time"].values, dtype=np.float64)
    duration = float(np.ptp(time))

    def distance(frame: int) -> NDArray[np.float64]:
        moved = np.maximum(np.abs(x - x[frame]).max(axis=1), np.abs(y - y[frame]).max(axis=1))
        shape = moved / scale if scale > 0 else np.zeros(last + 1)
        flow = np.abs(fraction - fraction[frame]).mean(axis=1)
        # Time only decides between frames that differ: a filament at rest needs no second picture.
        different = shape + _YIELD_WEIGHT * flow
        lapse = np.abs(time - time[frame]) / duration if duration > 0 else np.zeros(last + 1)
        return np.where(different > _SAME, different + _TIME_WEIGHT * lapse, 0.0)

    chosen = [last]
    nearest = np.minimum(distance(last), distance(0))
    while len(chosen) < count and nearest.max() > 0:
        chosen.append(int(nearest.argmax()))
        nearest = np.minimum(nearest, distance(chosen[-1]))
    return sorted(chosen)


def _compressed(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """At most 65 nodes of a (time, node) array, the ends and the middle among them: enough to compare shapes."""
    nodes = values.shape[1]
    kept = np.unique(np.linspace(0, nodes - 1, min(nodes, 65)).round().astype(np.intp))
    return np.asarray(values[:, kept], dtype=np.float64)
