"""What a film shows at each moment: a trajectory between its frames, at equal steps of time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from softcat_sym.report.section import Floats, outline, quads_outside, section_at, yielding_of

if TYPE_CHECKING:
    from softcat_sym.report.contract import PicturedScene

STRIPS = 8
"""Through the thickness."""

_ZETA = np.linspace(-1.0, 1.0, STRIPS + 1)
_AMID = 0.5 * (_ZETA[1:] + _ZETA[:-1])

_FIELDS = ("x", "y", "thickness", "stress_mean", "stress_bending", "midpoint")


@dataclass(frozen=True, slots=True)
class Moment:
    """The filament at one time.

    Attributes
    ----------
    time : float
        [s].
    midpoint : float
        Its height [m].
    outline : numpy.ndarray
        Closed polygon, shape (vertex, 2) [m].
    strips : numpy.ndarray
        Quads that cover it, every cell in as many strips through the thickness, shape (quad, 4, 2) [m].
    stress : numpy.ndarray
        Magnitude of the axial stress sigma_0 + sigma_1 zeta amid each, shape (quad,) [Pa].
    yielded : numpy.ndarray
        Quads of what yields, shape (quad, 4, 2) [m].
    """

    time: float
    midpoint: float
    outline: Floats
    strips: Floats
    stress: Floats
    yielded: Floats


class Film:
    """Moments of a run, equally spaced in time.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory.
    scene : PicturedScene
        Ends and yield stress are read.
    moments : int
        How many; at least one.

    Attributes
    ----------
    times, midpoint : numpy.ndarray
        Of the moments [s], [m].
    run_times, run_midpoint : numpy.ndarray
        Of all frames of the run [s], [m].
    bounds : numpy.ndarray
        Lower left and upper right corner of all outlines, shape (2, 2) [m].
    largest : float
        Stress below which 99.5 % of it lie [Pa].
    resolved : bool
        Whether the section is resolved fibre by fibre.
    sag : float
        Largest departure of a centreline from the straight line between its ends [m].

    Notes
    -----
    Between two frames of the trajectory everything is interpolated linearly.
    """

    def __init__(self, data: xr.Dataset, scene: PicturedScene, moments: int) -> None:
        time = np.asarray(data["time"].values, dtype=np.float64)
        self.times: Floats = np.linspace(time[0], time[-1], max(1, moments))
        after = np.clip(np.searchsorted(time, self.times), 1, max(1, time.size - 1))
        before = after - 1
        after = np.minimum(after, time.size - 1)
        gap = time[after] - time[before]
        part = np.where(gap > 0, (self.times - time[before]) / np.where(gap > 0, gap, 1.0), 0.0)
        yields = yielding_of(data, scene)
        cores = {"low": (("time", "cell"), yields.low), "high": (("time", "cell"), yields.high)}
        self.run_times: Floats = time
        self.run_midpoint: Floats = np.asarray(data["midpoint"].values, dtype=np.float64)
        self.resolved = "core_low" in data
        data = data[list(_FIELDS)].assign(cores)

        def between(name: str) -> tuple[tuple[str, ...], Floats]:
            values = np.asarray(data[name].transpose("time", ...).values, dtype=np.float64)
            share = part.reshape(-1, *(1,) * (values.ndim - 1))
            dims = tuple(str(dim) for dim in data[name].transpose("time", ...).dims)
            return dims, np.asarray((1 - share) * values[before] + share * values[after])

        places = {name: data[name] for name in ("X_node", "X_cell")}
        self._data = xr.Dataset({name: between(str(name)) for name in data}, coords={"time": self.times, **places})
        self.midpoint: Floats = self._data["midpoint"].values
        self._clamped = (scene.ends.left == "clamped", scene.ends.right == "clamped")
        outlines = np.stack([outline(section_at(self._data, k, self._clamped)) for k in range(self.times.size)])
        self.bounds: Floats = np.stack([outlines.min(axis=(0, 1)), outlines.max(axis=(0, 1))])
        self.largest = float(np.quantile(np.stack([self._stress(k) for k in range(self.times.size)]), 0.995))
        self.sag = self._sag()

    def _sag(self) -> float:
        y = self._data["y"].values
        line = y[:, :1] + (y[:, -1:] - y[:, :1]) * np.linspace(0.0, 1.0, y.shape[1])
        return float(np.abs(y - line).max())

    def _stress(self, number: int) -> Floats:
        mean, slope = (self._data[name].values[number] for name in ("stress_mean", "stress_bending"))
        return np.asarray(np.abs(mean + np.multiply.outer(_AMID, slope)).ravel())

    def moment(self, number: int) -> Moment:
        """What is shown at the moment of this number."""
        data = self._data
        section = section_at(data, number, self._clamped)
        yielded = quads_outside(section, data["low"].values[number], data["high"].values[number])
        grid = np.stack([section.at(float(zeta)) for zeta in _ZETA])
        strips = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], axis=2).reshape(-1, 4, 2)
        time, midpoint = float(self.times[number]), float(self.midpoint[number])
        return Moment(time, midpoint, outline(section), strips, self._stress(number), yielded)
