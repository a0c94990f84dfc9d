"""Floors and pillars in pictures of a filament."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.patches import Polygon

from softcat_sym.plotting.units import Unit
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.tables import bodies_of


def draw_bodies(axes: Axes, scene: Scene, thickness: float, x: tuple[float, float], bottom: float, ruler: Unit) -> None:
    """Draw what the filament may lie on, between two x and down to `bottom` [m], below one of this thickness [m]."""
    for body in bodies_of(scene):
        for corners in body.outlines(thickness, *x, bottom):
            axes.add_patch(Polygon(ruler.of(corners), facecolor="0.85", edgecolor="0.5", lw=0.5, zorder=0))
