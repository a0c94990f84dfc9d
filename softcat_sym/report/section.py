"""Geometry of a filament seen from the side: outline with its thickness, and the zones that yield."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from numpy.typing import NDArray

if TYPE_CHECKING:
    from softcat_sym.report.contract import PicturedScene

Floats = NDArray[np.float64]

# Beyond this angle [rad] at an end an extrapolation would turn the drawn end face, not follow a curve.
_LARGEST_END_TURN = 0.3


@dataclass(frozen=True, slots=True)
class Section:
    """The filament at one instant.

    Attributes
    ----------
    x, y : numpy.ndarray
        Centreline, shape (node,) [m].
    normal : numpy.ndarray
        Unit normals (-sin th, cos th), shape (node, 2).
    thickness : numpy.ndarray
        Current thickness, shape (node,) [m].
    """

    x: Floats
    y: Floats
    normal: Floats
    thickness: Floats

    def at(self, zeta: float | Floats, nodes: slice = slice(None)) -> Floats:
        """Place through-thickness coordinates in the plane.

        Parameters
        ----------
        zeta : float or numpy.ndarray
            Coordinate in [-1, 1] for each of the chosen nodes; +1 is the side of the normal.
        nodes : slice
            The nodes.

        Returns
        -------
        numpy.ndarray
            Points, shape (node, 2) [m].
        """
        centre = np.column_stack([self.x[nodes], self.y[nodes]])
        offset = 0.5 * np.asarray(zeta) * self.thickness[nodes]
        points: Floats = centre + offset[:, None] * self.normal[nodes]
        return points


def section_at(data: xr.Dataset, frame: int, clamped: tuple[bool, bool] = (False, False)) -> Section:
    """Read the filament of one frame.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory with ``x``, ``y`` (time, node) and ``thickness`` (time, cell), all [m].
    frame : int
        Index along ``time``.
    clamped : pair of bool
        Whether the left and the right end are held level, so that their sections stay vertical.

    Returns
    -------
    Section
        Centreline, normals and thickness on the nodes.
    """
    x = np.asarray(data["x"].values[frame], dtype=np.float64)
    y = np.asarray(data["y"].values[frame], dtype=np.float64)
    cells = np.asarray(data["thickness"].values[frame], dtype=np.float64)
    thickness = np.interp(data["X_node"].values, data["X_cell"].values, cells)
    angle = node_angles(x, y)
    angle[[0, -1]] = np.where(clamped, 0.0, angle[[0, -1]])
    return Section(x, y, np.column_stack([-np.sin(angle), np.cos(angle)]), thickness)


def node_angles(x: Floats, y: Floats) -> Floats:
    """Tangent angle on the nodes: the bisector of the chords that meet there, extrapolated at the ends.

    Parameters
    ----------
    x, y : numpy.ndarray
        Centreline, shape (node,) with at least two nodes [m].

    Returns
    -------
    numpy.ndarray
        Angles [rad], shape (node,), continuous along the filament.
    """
    chord = np.unwrap(np.arctan2(np.diff(y), np.diff(x)))
    if chord.size == 1:
        return np.repeat(chord, 2)
    turns = np.clip(0.5 * np.diff(chord)[[0, -1]], -_LARGEST_END_TURN, _LARGEST_END_TURN)
    middle = 0.5 * (chord[1:] + chord[:-1])
    return np.concatenate([[chord[0] - turns[0]], middle, [chord[-1] + turns[1]]])


def outline(section: Section) -> Floats:
    """Closed polygon of the filament's side view.

    Parameters
    ----------
    section : Section
        The filament.

    Returns
    -------
    numpy.ndarray
        Vertices, shape (2 * node, 2) [m], anticlockwise for a filament that runs to the right.
    """
    return np.concatenate([section.at(-1.0), section.at(1.0)[::-1]])


def elastic_core(mean: Floats, bending: Floats, yield_stress: float) -> tuple[Floats, Floats]:
    """Limits in zeta between which ``|mean + bending * zeta| <= yield_stress``.

    Parameters
    ----------
    mean, bending : numpy.ndarray
        Section-mean stress sigma_0 and its slope sigma_1, shape (cell,) [Pa].
    yield_stress : float
        Yield stress [Pa].

    Returns
    -------
    lower, upper : numpy.ndarray
        Limits clipped to [-1, 1]. Below ``lower`` and above ``upper`` the material yields; they coincide, on
        one face, where the whole thickness does.
    """
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        one = (-yield_stress - mean) / bending
        other = (yield_stress - mean) / bending
    lower, upper = np.minimum(one, other), np.maximum(one, other)
    uniform = bending == 0
    whole = uniform & (np.abs(mean) > yield_stress)
    lower = np.where(uniform, -1.0, np.clip(lower, -1.0, 1.0))
    upper = np.where(uniform, np.where(whole, -1.0, 1.0), np.clip(upper, -1.0, 1.0))
    return lower, upper


@dataclass(frozen=True, slots=True)
class Yielding:
    """What a picture shows as yielded: what flows, not what the solver's tolerance lets rest on the yield stress.

    Attributes
    ----------
    low, high : numpy.ndarray
        Limits in zeta of what does not yield, shape (time, cell).
    share : numpy.ndarray
        Share of the section that yields, shape (time, cell).
    slowest : float
        Plastic rate [1/s] from which on a section counts as yielded, where it exceeds it on the average of a tenth of
        the run too; see :func:`slowest_flow`.
    """

    low: Floats
    high: Floats
    share: Floats
    slowest: float


def slowest_flow(data: xr.Dataset, scene: PicturedScene) -> float:
    """Plastic rate [1/s] below which flow does not show in the answer.

    A section that flowed so slowly through the whole run would add to the largest plastic strain no more than the
    accuracy asked. An arrested filament rests on its yield surface: there stresses exceed the yield stress by no more
    than the tolerance of the solver, now here, now there.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory with ``time`` [s] and ``plastic_rate`` [1/s] (time, cell).
    scene : PicturedScene
        Its accuracy is read.
    """
    time = np.asarray(data["time"].values, dtype=np.float64)
    if time.size < 2 or not time[-1] > time[0]:
        return 0.0
    rate = np.asarray(data["plastic_rate"].values, dtype=np.float64)
    strain = 0.5 * np.diff(time) @ (rate[1:] + rate[:-1])
    return scene.run.accuracy * float(strain.max()) / float(time[-1] - time[0])


def yielding_of(data: xr.Dataset, scene: PicturedScene) -> Yielding:
    """What yields in every frame, of a law that has a yield stress; nothing of another.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory with ``yielded_fraction``, ``plastic_rate``, ``stress_mean``, ``stress_bending`` (time, cell), and
        ``core_low``, ``core_high`` where the section is resolved fibre by fibre.
    scene : PicturedScene
        Its yield stress and its accuracy are read.
    """
    limit = scene.material.yield_stress
    if limit is None:
        shape = data["yielded_fraction"].shape
        return Yielding(np.full(shape, -1.0), np.full(shape, 1.0), np.zeros(shape), 0.0)
    if "core_low" in data:
        low, high = data["core_low"].values, data["core_high"].values
    else:
        low, high = elastic_core(data["stress_mean"].values, data["stress_bending"].values, limit)
    slowest, rate = slowest_flow(data, scene), np.asarray(data["plastic_rate"].values, dtype=np.float64)
    flows = (rate > slowest) & (_running_mean(rate, len(rate) // 20) > slowest)
    share = np.where(flows, data["yielded_fraction"].values, 0.0)
    return Yielding(np.where(flows, low, -1.0), np.where(flows, high, 1.0), share, slowest)


def _running_mean(values: Floats, reach: int) -> Floats:
    """Means over `reach` frames before and after each frame, fewer where the run begins and ends."""
    total = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0)])
    frame = np.arange(len(values))
    first, end = np.maximum(frame - reach, 0), np.minimum(frame + reach + 1, len(values))
    return np.asarray((total[end] - total[first]) / (end - first)[:, None])


def quads_outside(section: Section, lower: Floats, upper: Floats) -> Floats:
    """Quadrilaterals below and above the elastic core, cell by cell.

    Parameters
    ----------
    section : Section
        The filament.
    lower, upper : numpy.ndarray
        Limits of the core in zeta, shape (cell,).

    Returns
    -------
    numpy.ndarray
        Vertices, shape (quad, 4, 2) [m].
    """
    ones = np.ones_like(lower)
    return np.concatenate([_quads(section, -ones, lower), _quads(section, upper, ones)])


def _quads(section: Section, low: Floats, high: Floats) -> Floats:
    """Quads between two zeta limits per cell; empty bands are left out."""
    left, right = slice(None, -1), slice(1, None)
    corners = [section.at(low, left), section.at(low, right), section.at(high, right), section.at(high, left)]
    return np.stack(corners, axis=1)[high > low]
