"""Geometry of a filament seen from the side: outline, yielded zones, and the frames that tell a run apart."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from softcat_sym.plotting.units import nice_floor

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene


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


Floats = NDArray[np.float64]

# Beyond this angle [rad] at an end an extrapolation would turn the drawn end face, not follow a curve.
_MAX_END_TURN = 0.3


@dataclass(frozen=True, slots=True)
class Section:
    """The filament at one instant."""

    x: Floats  # Centreline, shape (node,) [m]
    y: Floats
    normal: Floats  # Unit normals (-sin th, cos th), shape (node, 2)
    thickness: Floats  # Current thickness, shape (node,) [m]

    def at(self, zeta: float | Floats, nodes: slice = slice(None)) -> Floats:
        """Place through-thickness coordinates in the plane."""
        centre = np.column_stack([self.x[nodes], self.y[nodes]])
        offset = 0.5 * np.asarray(zeta) * self.thickness[nodes]
        points: Floats = centre + offset[:, None] * self.normal[nodes]
        return points


def section_at(data: xr.Dataset, frame: int, clamped: tuple[bool, bool] = (False, False)) -> Section:
    """Read the filament of one frame."""
    x = np.asarray(data["x"].values[frame], dtype=np.float64)
    y = np.asarray(data["y"].values[frame], dtype=np.float64)
    cells = np.asarray(data["thickness"].values[frame], dtype=np.float64)
    thickness = np.interp(data["X_node"].values, data["X_cell"].values, cells)
    angle = node_angles(x, y)
    angle[[0, -1]] = np.where(clamped, 0.0, angle[[0, -1]])
    return Section(x, y, np.column_stack([-np.sin(angle), np.cos(angle)]), thickness)


def node_angles(x: Floats, y: Floats) -> Floats:
    """Tangent angle on the nodes: the bisector of the chords that meet there, extrapolated at the ends."""
    chord = np.unwrap(np.arctan2(np.diff(y), np.diff(x)))
    if chord.size == 1:
        return np.repeat(chord, 2)
    turns = np.clip(0.5 * np.diff(chord)[[0, -1]], -_MAX_END_TURN, _MAX_END_TURN)
    middle = 0.5 * (chord[1:] + chord[:-1])
    return np.concatenate([[chord[0] - turns[0]], middle, [chord[-1] + turns[1]]])


def outline(section: Section) -> Floats:
    """Closed polygon of the filament's side view."""
    return np.concatenate([section.at(-1.0), section.at(1.0)[::-1]])


def elastic_core(mean: Floats, bending: Floats, yield_stress: float) -> tuple[Floats, Floats]:
    """Limits in zeta between which ``|mean + bending * zeta| <= yield_stress``."""
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
    """What a picture shows as yielded: what flows, not what the solver's tolerance lets rest on the yield stress."""

    low: Floats  # Limits in zeta of what does not yield, shape (time, cell)
    high: Floats
    share: Floats  # Share of the section that yields, shape (time, cell)
    # Plastic rate [1/s] from which on a section counts as yielded, where it exceeds it on the average of a tenth of
    # the run too; see :func:`slowest_flow`.
    slowest: float


def slowest_flow(data: xr.Dataset, scene: Scene) -> float:
    """Plastic rate [1/s] below which flow does not show in the answer.

    A section that flowed so slowly through the whole run would add to the largest plastic strain no more than the
    accuracy asked. An arrested filament rests on its yield surface: there stresses exceed the yield stress by no more
    than the tolerance of the solver, now here, now there.
    """
    time = np.asarray(data["time"].values, dtype=np.float64)
    if time.size < 2 or not time[-1] > time[0]:
        return 0.0
    rate = np.asarray(data["plastic_rate"].values, dtype=np.float64)
    strain = 0.5 * np.diff(time) @ (rate[1:] + rate[:-1])
    return scene.run.accuracy * float(strain.max()) / float(time[-1] - time[0])


def yielding_of(data: xr.Dataset, scene: Scene) -> Yielding:
    """What yields in every frame, of a law that has a yield stress; nothing of another."""
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
    """Quadrilaterals below and above the elastic core, cell by cell."""
    ones = np.ones_like(lower)
    return np.concatenate([_quads(section, -ones, lower), _quads(section, upper, ones)])


def _quads(section: Section, low: Floats, high: Floats) -> Floats:
    """Quads between two zeta limits per cell; empty bands are left out."""
    left, right = slice(None, -1), slice(1, None)
    corners = [section.at(low, left), section.at(low, right), section.at(high, right), section.at(high, left)]
    return np.stack(corners, axis=1)[high > low]


# A sag below this share of the span is exaggerated, until it or the thickness reaches these shares as drawn.
_FLAT = 0.02
_DRAWN_SAG = 0.10
_DRAWN_THICKNESS = 0.12


def vertical_stretch(sag: float, thickness: float, span: float) -> float:
    """Factor by which the vertical scale is stretched: 1, 2 or 5 times a power of ten."""
    if sag <= 0 or sag >= _FLAT * span:
        return 1.0
    return max(1.0, nice_floor(min(_DRAWN_SAG * span / sag, _DRAWN_THICKNESS * span / thickness)))
