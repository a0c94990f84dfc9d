"""Names beside points: each at the nearest place where it lies on no other name and on no point."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, TypeAlias

from matplotlib.transforms import Bbox

from softcat_sym.report import style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_FONT, _MARKER, _PAD = 7.5, 4.0, 1.0
_NEAREST, _FAR, _FARTHEST, _STEP, _DIRECTIONS = 6.0, 60.0, 260.0, 3.0, 32

_CLEARLY, _ALONE = 0.8, 0.6
"""Of the distance to the next point: below the first a name is its own point's, below the second plainly so."""

Pixel: TypeAlias = tuple[float, float]


def label_points(axes: Axes, points: Sequence[tuple[float, float]], names: Sequence[str]) -> None:
    """Write a name beside each point, with a thin line to it where the name had to go farther away.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Limits and scales are set already.
    points : sequence of (float, float)
        In data coordinates.
    names : sequence of str
        As many.

    Notes
    -----
    Greedy: from the top down, each takes the nearest free place inside the axes. What finds none is left at its point.
    """
    pixels = (axes.figure.dpi if axes.figure is not None else style.DPI) / 72
    placed = [axes.transData.transform(point) for point in points]
    places = [(float(x), float(y)) for x, y in placed]
    taken = [_around(x, y, _MARKER * pixels) for x, y in places]
    inside = axes.get_window_extent()
    for k in sorted(range(len(names)), key=lambda k: (-places[k][1], places[k][0])):
        text = axes.text(0, 0, names[k], fontsize=_FONT, va="center", ha="center", transform=None, zorder=5)
        found = text.get_window_extent()
        size = found.width, found.height
        others = [place for place in places if place != places[k]]
        centre, far = _free_place(places[k], others, size, taken, inside, pixels)
        text.set_position(centre)
        box = _box(centre, size, _PAD * pixels)
        taken.append(box)
        if far:
            line = zip(places[k], _nearest(places[k], box), strict=True)
            axes.plot(*line, transform=None, color=style.GREY, linewidth=0.5, zorder=2.5)


def _free_place(
    point: Pixel, others: Sequence[Pixel], size: Pixel, taken: Sequence[Bbox], inside: Bbox, pixels: float
) -> tuple[Pixel, bool]:
    """Centre of the nearest free box [pixel], and whether it needs a line to its point.

    A box that is nearer to another point would be read as that one's name; only where there is no better is it taken.
    """
    second = None
    for centre, radius in _candidates(point, size, pixels):
        box = _box(centre, size, _PAD * pixels)
        within = inside.x0 <= box.x0 and box.x1 <= inside.x1 and inside.y0 <= box.y0 and box.y1 <= inside.y1
        if not within or any(box.overlaps(other) for other in taken):
            continue
        far = radius > _NEAREST + _STEP
        own = math.dist(point, _nearest(point, box))
        next_best = min((math.dist(other, _nearest(other, box)) for other in others), default=math.inf)
        if own < _CLEARLY * next_best:
            return centre, far or own > _ALONE * next_best
        second = second or (centre, True)
        if radius > _FAR:
            break
    return second or (point, False)


def _candidates(point: Pixel, size: Pixel, pixels: float) -> Iterator[tuple[Pixel, float]]:
    """Centres ever farther away and their distances [point]; at each to the right first, then round to either side."""
    radius = _NEAREST
    while radius < _FARTHEST:
        for k in range(_DIRECTIONS):
            angle = 2 * math.pi / _DIRECTIONS * ((k + 1) // 2) * (-1) ** k
            across = math.cos(angle) * (radius * pixels + size[0] / 2)
            up = math.sin(angle) * (radius * pixels + size[1] / 2)
            yield (point[0] + across, point[1] + up), radius
        radius += _STEP


def _nearest(point: Pixel, box: Bbox) -> Pixel:
    """The point of a box that is nearest to another point."""
    return min(max(point[0], box.x0), box.x1), min(max(point[1], box.y0), box.y1)


def _box(centre: Pixel, size: Pixel, pad: float) -> Bbox:
    half = size[0] / 2 + pad, size[1] / 2 + pad
    return Bbox.from_extents(centre[0] - half[0], centre[1] - half[1], centre[0] + half[0], centre[1] + half[1])


def _around(x: float, y: float, half: float) -> Bbox:
    return Bbox.from_extents(x - half, y - half, x + half, y + half)
