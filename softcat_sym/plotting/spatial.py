"""Shapes of a filament in three dimensions: tubes of its true thickness, with a stripe that shows how it is twisted."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import Bbox
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from mpl_toolkits.mplot3d.axes3d import Axes3D

from softcat_sym.plotting import style
from softcat_sym.plotting.section import Floats, array
from softcat_sym.plotting.style import Fields

if TYPE_CHECKING:
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


def frame_tube(axes: Axes3D, low: Floats, high: Floats, unit: str) -> None:
    """Room for all shapes, to one scale."""
    middle, half = (low + high) / 2, np.maximum((high - low) / 2, 0.12 * float((high - low).max()))
    for part, least, most in zip("xyz", middle - half, middle + half, strict=True):
        getattr(axes, f"set_{part}lim")(least, most)
        getattr(axes, f"{part}axis").set_major_locator(MaxNLocator(3))
    axes.set_box_aspect(half)
    axes.view_init(*_VIEW)
    axes.tick_params(labelsize=7, pad=-2)
    axes.set_xlabel(f"x [{unit}]", labelpad=7)
    axes.set_ylabel("-z", labelpad=0)
    axes.set_zlabel("y", labelpad=-8)
    # As large as box and labels fit: what is tall would stand in the next picture.
    axes.figure.canvas.figure.draw_without_rendering()
    sides = (axes.xaxis, axes.yaxis, axes.zaxis)
    room, drawn = axes.get_window_extent(), Bbox.union([side.get_tightbbox() for side in sides])
    centre, reach = (room.p0 + room.p1) / 2, (room.p1 - room.p0) / 2
    share = reach / np.maximum(np.abs(drawn.p0 - centre), np.abs(drawn.p1 - centre))
    axes.set_box_aspect(half, zoom=min(1.5, 0.98 * float(share.min())))


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
