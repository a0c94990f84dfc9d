"""Floors, pillars and nozzles in pictures of a filament."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Polygon
from numpy.typing import NDArray

from softcat_sym.plotting.units import Unit
from softcat_sym.scene.extrusion import nozzle_walls
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.tables import bodies_of


def draw_bodies(axes: Axes, scene: Scene, thickness: float, x: tuple[float, float], bottom: float, ruler: Unit) -> None:
    """Draw what the filament may lie on, between two x and down to `bottom` [m], below one of this thickness [m]."""
    for body in bodies_of(scene):
        for corners in body.outlines(thickness, *x, bottom):
            axes.add_patch(Polygon(ruler.of(corners), facecolor="0.85", edgecolor="0.5", lw=0.5, zorder=0))


def draw_nozzle(axes: Axes, scene: Scene, time: float, thickness: float, ruler: Unit) -> Polygon:
    """Draw the nozzle at a time [s], with walls around a strand drawn of this thickness [m]."""
    walls = Polygon(ruler.of(walls_at(scene, time, thickness)), facecolor="0.75", edgecolor="0.4", lw=0.6, zorder=0)
    axes.add_artist(walls)
    return walls


def walls_at(scene: Scene, time: float, thickness: float) -> NDArray[np.float64]:
    """Corners of the nozzle [m]."""
    return np.array(nozzle_walls(scene, time, _WALLS * thickness))


_WALLS = 0.9
"""Half width of a nozzle in thicknesses of the strand, so that its walls are seen on either side."""
