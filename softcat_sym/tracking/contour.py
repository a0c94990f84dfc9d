"""The contour of a strand over pillars in one picture, for ``softcat fit --test collapse``."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from softcat_sym import drawing
from softcat_sym.errors import SoftcatError
from softcat_sym.tracking.calibration import Ruler, cameras_of_gaps, read_region
from softcat_sym.tracking.film import Film
from softcat_sym.tracking.strand import Camera, UnreadableFrameError, measure

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PillarContour(drawing.Drawable):
    """The centre line of a strand over the gaps between pillars."""

    film: Film  # The picture, as a film of one frame
    cameras: tuple[Camera, ...]  # One for each gap, from left to right
    pixel: float  # Length of a pixel [m]
    x: Floats  # shape (points,); [m] from the left edge of the picture
    y: Floats  # shape (points,); [m] upwards
    refused: tuple[str, ...]  # Gaps that could not be read, with the reason

    @property
    def gaps(self) -> list[tuple[float, float]]:
        """Places of both edges of each gap [m]."""
        return [(self.pixel * left, self.pixel * right) for left, right in (one.supports for one in self.cameras)]

    def to_csv(self) -> str:
        """Table of the points, with a comment for each gap."""
        lines = [f"# pillars.gap = {1e3 * left:.7g}, {1e3 * right:.7g}" for left, right in self.gaps]
        rows = [f"{1e3 * x:.7g},{1e3 * y:.7g}" for x, y in zip(self.x, self.y, strict=True)]
        return "\n".join([*lines, "x_mm,y_mm", *rows]) + "\n"


def contour(
    picture: str | os.PathLike[str],
    scale: str,
    *,
    region: Sequence[object] | None = None,
    dark: bool | None = None,
    flatten: bool = True,
) -> PillarContour:
    """Read the centre line of a strand over pillars from one picture, as :func:`softcat_sym.track` reads a frame.

    Parameters
    ----------
    picture : path
        A picture, or a film, of which the first frame counts.
    scale, region, dark, flatten
        As of :func:`softcat_sym.track`; a span is that of the only gap.

    Returns
    -------
    PillarContour
        A point for each pixel of arc length over every gap.

    Raises
    ------
    SoftcatError
        If there is no strand, no gap that can be read, or no scale.
    """
    ruler = Ruler.read(scale)
    source = Film(Path(picture), 1.0, None if region is None else read_region(region))
    frame = next(iter(source))
    cameras, points, refused = list[Camera](), list[tuple[Floats, Floats]](), list[str]()
    for camera in cameras_of_gaps(source, frame, dark, flatten=flatten):
        signal = camera.light.signal(frame.grey)
        try:
            # The blur width first, then with it all cuts.
            camera = replace(camera, width=measure(camera, signal, free=True).blur)
            strand = measure(camera, signal)
        except UnreadableFrameError as error:
            refused.append(f"gap at columns {camera.supports[0]:.0f} to {camera.supports[1]:.0f}: {error}")
            continue
        cameras.append(camera)
        points.append(camera.to_picture(strand.x[strand.line.kept], strand.y[strand.line.kept]))
    if not cameras or (ruler.of == "span" and len(cameras) > 1):
        found = "; ".join(refused) or (f"{len(cameras)} gaps" if cameras else "no gap between two supports")
        accepted = "a strand across one gap, or across several with a scale by pixel or needle"
        raise SoftcatError(f"picture {source.path}: {found}; accepted: {accepted}")
    pixel, _ = ruler.pixel(cameras[0], frame.grey)
    x, row = np.concatenate(points, axis=1)
    return PillarContour(source, tuple(cameras), pixel, pixel * x, -pixel * row, tuple(refused))
