"""Geometry of a filament seen from the side: outline, yielded zones, and the frames that differ most."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from softcat_sym.plotting.style import Fields
from softcat_sym.plotting.units import nice_floor
from softcat_sym.scene.history import values_at

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene

Floats = NDArray[np.float64]


def array(data: Fields, name: str) -> Floats:
    """One field of a run."""
    return np.asarray(data[name], dtype=np.float64)


def telling_frames(data: Fields, count: int = 5) -> list[int]:
    """Choose frames whose shapes and yielded zones differ most, the final one among them.

    Each frame added is the one farthest from those already chosen, so a steady descent is cut into equal drops
    and a long rest takes one frame. The first frame, the undeformed filament, and whatever looks like it are taken only
    when there is nothing else.
    """
    time, fraction = array(data, "time"), array(data, "yielded_fraction")
    last, duration = time.size - 1, float(np.ptp(time))
    if last <= 0:
        return [0]
    # At most 65 nodes, the ends and the middle among them, are enough to compare shapes.
    count_nodes = len(data["X_node"])
    nodes = np.unique(np.linspace(0, count_nodes - 1, min(count_nodes, 65)).round().astype(np.intp))
    x, y = array(data, "x")[:, nodes], array(data, "y")[:, nodes]
    scale = max(float(np.ptp(x, axis=0).max()), float(np.ptp(y, axis=0).max()))

    def distance(frame: int) -> Floats:
        """A change of shape counts fully, of the yielded zones a third, mere lapse of time a tenth."""
        moved = np.maximum(np.abs(x - x[frame]).max(axis=1), np.abs(y - y[frame]).max(axis=1))
        different = (moved / scale if scale > 0 else 0.0) + 0.3 * np.abs(fraction - fraction[frame]).mean(axis=1)
        lapse = np.abs(time - time[frame]) / duration if duration > 0 else np.zeros(last + 1)
        # Time only decides between frames that differ: a filament at rest needs no second picture.
        return np.where(different > 0.02, different + 0.1 * lapse, 0.0)

    chosen = [last]
    nearest = np.minimum(distance(last), distance(0))
    while len(chosen) < count and nearest.max() > 0:
        chosen.append(int(nearest.argmax()))
        nearest = np.minimum(nearest, distance(chosen[-1]))
    return sorted(chosen)


@dataclass(frozen=True, slots=True)
class FilamentOutline:
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


def section_at(data: Fields, frame: int, clamped: Sequence[bool] = (False, False)) -> FilamentOutline:
    """Read the filament of one frame."""
    x, y = array(data, "x")[frame], array(data, "y")[frame]
    thickness = np.interp(array(data, "X_node"), array(data, "X_cell"), array(data, "thickness")[frame])
    angle = node_angles(x, y)
    angle[[0, -1]] = np.where(clamped, 0.0, angle[[0, -1]])
    return FilamentOutline(x, y, np.column_stack([-np.sin(angle), np.cos(angle)]), thickness)


def node_angles(x: Floats, y: Floats) -> Floats:
    """Tangent angle on the nodes: the bisector of the chords that meet there, extrapolated at the ends."""
    chord = np.unwrap(np.arctan2(np.diff(y), np.diff(x)))
    if chord.size == 1:
        return np.repeat(chord, 2)
    # Beyond 0.3 rad at an end an extrapolation would turn the drawn end face, not follow a curve.
    turns = np.clip(0.5 * np.diff(chord)[[0, -1]], -0.3, 0.3)
    middle = 0.5 * (chord[1:] + chord[:-1])
    return np.concatenate([[chord[0] - turns[0]], middle, [chord[-1] + turns[1]]])


def outline(section: FilamentOutline) -> Floats:
    """Closed polygon of the filament's side view."""
    return np.concatenate([section.at(-1.0), section.at(1.0)[::-1]])


def elastic_core(mean: Floats, bending: Floats, yield_stress: float | Floats) -> tuple[Floats, Floats]:
    """Limits in zeta between which ``|mean + bending * zeta| <= yield_stress``."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        limits = np.stack([(-yield_stress - mean) / bending, (yield_stress - mean) / bending])
    uniform = bending == 0
    whole = uniform & (np.abs(mean) > yield_stress)
    lower = np.where(uniform, -1.0, np.clip(limits.min(axis=0), -1.0, 1.0))
    upper = np.where(uniform, np.where(whole, -1.0, 1.0), np.clip(limits.max(axis=0), -1.0, 1.0))
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


def slowest_flow(data: Fields, scene: Scene) -> float:
    """Plastic rate [1/s] below which flow does not show in the answer.

    A section that flowed so slowly through the whole run would add to the largest plastic strain no more than the
    accuracy asked. An arrested filament rests on its yield surface: there stresses exceed the yield stress by no more
    than the tolerance of the solver, now here, now there.
    """
    time = array(data, "time")
    if time.size < 2 or not time[-1] > time[0]:
        return 0.0
    rate = array(data, "plastic_rate")
    strain = 0.5 * np.diff(time) @ (rate[1:] + rate[:-1])
    return scene.run.accuracy * float(strain.max()) / float(time[-1] - time[0])


def yielding_of(data: Fields, scene: Scene) -> Yielding:
    """What yields in every frame, of a law that has a yield stress; nothing of another."""
    limit, rate = scene.material.yield_stress, array(data, "plastic_rate")
    if limit is None:
        return Yielding(np.full(rate.shape, -1.0), np.full(rate.shape, 1.0), np.zeros(rate.shape), 0.0)
    if "core_low" in data:
        low, high = array(data, "core_low"), array(data, "core_high")
    else:
        limits = values_at(limit, array(data, "time"))[:, None]
        low, high = elastic_core(array(data, "stress_mean"), array(data, "stress_bending"), limits)
    slowest = slowest_flow(data, scene)
    # Means over a twentieth of the run before and after each frame, less where it begins and ends.
    total = np.concatenate([np.zeros((1, *rate.shape[1:])), np.cumsum(rate, axis=0)])
    frame, reach = np.arange(len(rate)), len(rate) // 20
    first, end = np.maximum(frame - reach, 0), np.minimum(frame + reach + 1, len(rate))
    flows = (rate > slowest) & ((total[end] - total[first]) / (end - first)[:, None] > slowest)
    share = np.where(flows, array(data, "yielded_fraction"), 0.0)
    return Yielding(np.where(flows, low, -1.0), np.where(flows, high, 1.0), share, slowest)


def quads_outside(section: FilamentOutline, lower: Floats, upper: Floats) -> Floats:
    """Quadrilaterals below and above the elastic core of cells, linear between nodes; empty ones are left out."""
    left, right, quads = slice(None, -1), slice(1, None), []
    for core, face in ((lower, -1.0), (upper, 1.0)):
        limit = np.concatenate([core[:1], (core[1:] + core[:-1]) / 2, core[-1:]])
        below, above = (section.at(each(limit, face)) for each in (np.minimum, np.maximum))
        corners = [below[left], below[right], above[right], above[left]]
        quads.append(np.stack(corners, axis=1)[(limit[left] != face) | (limit[right] != face)])
    return np.concatenate(quads)


_MAGNIFIED = 1000.0
"""What sags by less than a ten-thousandth of its span is drawn as good as straight."""


@dataclass(frozen=True, slots=True)
class Magnification:
    """Factors by which heights and thicknesses of what is too flat to see are drawn larger: 1, 2 or 5 times 10^n."""

    sag: float = 1.0
    thickness: float = 1.0

    @classmethod
    def of(cls, sag: float, thickness: float, span: float) -> Magnification:
        """Of a sag below 2 % of the span, which is drawn as up to 10 % of it; its thickness as up to 12 %."""
        if sag <= 0 or sag >= 0.02 * span:
            return cls()
        factor = min(nice_floor(0.10 * span / sag), _MAGNIFIED)
        return cls(factor, max(1.0, min(factor, nice_floor(0.12 * span / thickness))))

    def __str__(self) -> str:
        """Words for a title; none where nothing is magnified."""
        if self.sag == self.thickness:
            return "" if self.sag == 1 else f"sag and thickness × {self.sag:g}"
        return f"sag × {self.sag:g}" + ("" if self.thickness == 1 else f", thickness × {self.thickness:g}")

    def drawn(self, data: Fields, swollen: float = 1.0) -> dict[str, Any]:
        """Fields whose thickness is right once heights are drawn larger, times a factor."""
        factor = swollen * self.thickness / self.sag
        return {**{str(name): data[name] for name in data}, "thickness": factor * array(data, "thickness")}


def largest_sag(y: Floats) -> float:
    """Largest departure of centrelines (shape, node) from the straight lines between their ends [m]."""
    return float(np.abs(y - np.linspace(y[:, 0], y[:, -1], y.shape[1], axis=1)).max())
