"""Shapes of a filament in three dimensions: tubes of its true thickness, with a stripe that shows how it is twisted."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import Bbox
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from mpl_toolkits.mplot3d.axes3d import Axes3D

from softcat_sym.plotting import style
from softcat_sym.plotting.pictures import Pictures
from softcat_sym.plotting.section import Floats, array
from softcat_sym.plotting.style import Fields
from softcat_sym.plotting.units import length_unit, time_unit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from softcat_sym.plotting.units import Summary
    from softcat_sym.scene.scene import Scene

_ROUND = 16
"""Sides of a tube."""

_STRIPE = 2
"""Of these, how many are the stripe along the second axis of the section."""

_VIEW = 22.0, -62.0
"""Height and direction from which the filament is looked at [deg]."""


def axes_of_sections(quaternion: Floats) -> tuple[Floats, Floats]:
    """Second and third axes d2, d3 of sections, shape (..., 3), of quaternions with the scalar first."""
    w, x, y, z = np.moveaxis(quaternion, -1, 0)
    second = np.stack([2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)], axis=-1)
    third = np.stack([2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z], axis=-1)
    return second, third


def tube(data: Fields, scene: Scene, frame: int, radius: float) -> Floats:
    """Corners of the rings of a tube at the nodes of one frame, shape (node, side, 3) [m]; x, depth, height."""
    thick = array(data, "thickness")[frame]
    edge = np.concatenate([thick[:1], (thick[1:] + thick[:-1]) / 2, thick[-1:]]) / 2 * radius
    second, third = axes_of_sections(array(data, "quaternion")[frame])
    filament = scene.filament
    if filament.section == "circle":
        angle = 2 * np.pi * (np.arange(_ROUND) - 0.5 * _STRIPE) / _ROUND
        around = np.column_stack([np.cos(angle), np.sin(angle)])
    else:
        wide = filament.width / filament.thickness
        around = np.array([[1.0, -wide], [1.0, wide], [-1.0, wide], [-1.0, -wide]])
    centre = np.stack([array(data, name)[frame] for name in ("x", "y", "z")], axis=-1)
    rings = around[:, :1] * second[:, None] + around[:, 1:] * third[:, None]
    found: Floats = centre[:, None] + edge[:, None, None] * rings
    # Drawn with the height upwards and the plane's normal towards the viewer.
    turned: Floats = found[..., [0, 2, 1]] * np.array([1.0, -1.0, 1.0])
    return turned


_WIDE, _TALL = 12.8, 8.0
"""Of a film [inch]."""


def frame_tube(axes: Axes3D, low: Floats, high: Floats, unit: str) -> None:
    """Room for all shapes, to one scale."""
    middle, half = (low + high) / 2, np.maximum((high - low) / 2, 0.12 * float((high - low).max()))
    for part, least, most in zip("xyz", middle - half, middle + half, strict=True):
        getattr(axes, f"set_{part}lim")(least, most)
        getattr(axes, f"{part}axis").set_major_locator(MaxNLocator(3))
    axes.set_box_aspect(half)
    axes.view_init(*_VIEW)
    axes.tick_params(labelsize=7, pad=-2)
    axes.set_xlabel(f"x [{unit}]", labelpad=2)
    axes.set_ylabel("-z", labelpad=0)
    axes.set_zlabel("y", labelpad=-8)
    # As large as box and labels fit: what is tall would stand in the next picture.
    axes.figure.draw_without_rendering()
    sides = (axes.xaxis, axes.yaxis, axes.zaxis)
    room, drawn = axes.get_window_extent(), Bbox.union([side.get_tightbbox() for side in sides])
    centre, reach = (room.p0 + room.p1) / 2, (room.p1 - room.p0) / 2
    share = reach / np.maximum(np.abs(drawn.p0 - centre), np.abs(drawn.p1 - centre))
    axes.set_box_aspect(half, zoom=min(1.5, 0.98 * float(share.min())))


class SpatialAnimation(Pictures):
    """Draws one moment of a filament in space after another, with a clock and the height of its midpoint."""

    def __init__(
        self, data: Fields, summary: Summary, scene: Scene, times: Floats, note: str, width: int = 1280
    ) -> None:
        time = array(data, "time")
        self.times, self.note = times, note
        nearest = np.abs(time[:, None] - times).argmin(axis=0)
        tubes = {frame: tube(data, scene, frame, 1.0) for frame in np.unique(nearest).tolist()}
        corners = np.concatenate([one.reshape(-1, 3) for one in tubes.values()])
        low, high = corners.min(axis=0), corners.max(axis=0)
        ruler = length_unit(float(np.abs(corners).max()), scene.filament.span)
        self._clock = time_unit(float(np.abs(times).max()))
        self._shapes = [ruler.of(tubes[frame]) for frame in nearest.tolist()]
        self._shown = [(float(time[frame]), float(array(data, "midpoint")[frame])) for frame in nearest.tolist()]
        self._ruler = ruler
        with style.styled():
            self.figure: Figure = style.new_figure(_WIDE, _TALL)
            self.figure.set_dpi(width / _WIDE)
            self.axes: Axes3D = self.figure.add_axes((0.0, 0.24, 1.0, 0.72), projection="3d")
            frame_tube(self.axes, ruler.of(low), ruler.of(high), ruler.symbol)
            title = style.printable(scene.title, 70) or "Filament"
            self.figure.text(0.05, 0.98, title, fontsize=16, fontweight="bold", va="top", parse_math=False)
            self.figure.text(0.95, 0.94, note, fontsize=10, color=style.VERMILLION, va="top", ha="right")
            self._now = self.figure.text(0.95, 0.98, "", fontsize=16, va="top", ha="right")
            below = self.figure.add_axes((0.1, 0.08, 0.82, 0.12))
            below.plot(self._clock.of(time), ruler.of(array(data, "midpoint")), color=style.BLUE, linewidth=1.6)
            below.set_xlabel(f"time [{self._clock.symbol}]")
            below.set_ylabel(f"midpoint [{ruler.symbol}]")
            (self._dot,) = below.plot([], [], "o", color=style.BLUE, ms=8, markeredgecolor="white", clip_on=False)
            style.stamp(self.figure, summary)
        self._body: Poly3DCollection | None = None

    def __len__(self) -> int:
        return len(self._shapes)

    def picture(self, number: int) -> NDArray[np.uint8]:
        """Draw one moment, shape (height, width, 3)."""
        canvas: Any = self.figure.canvas
        with style.styled():
            if self._body is not None:
                self._body.remove()
            self._body = draw_tube(self.axes, self._shapes[number])
            time, height = self._shown[number]
            self._dot.set_data([self._clock.of(time)], [self._ruler.of(height)])
            self._now.set_text(f"t = {self._clock.text(time)}")
            canvas.draw()
        return self.pixels()


def draw_tube(axes: Axes3D, rings: Floats) -> Poly3DCollection:
    """Faces between neighbouring rings; the first few sides are the stripe."""
    following = np.roll(rings, -1, axis=1)
    faces = np.stack([rings[:-1], following[:-1], following[1:], rings[1:]], axis=2)
    sides = faces.shape[1]
    stripe = _STRIPE if sides > _STRIPE * 2 else 1
    colours = np.array([style.VERMILLION if side < stripe else style.FILAMENT for side in range(sides)])
    quads = faces.reshape(-1, 4, 3)
    painted = np.tile(colours, len(faces))
    body = Poly3DCollection(list(quads), facecolors=painted, edgecolors=painted, lw=0.1, shade=True)
    axes.add_collection3d(body)
    return body
