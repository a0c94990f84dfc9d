"""A tracked film: midpoint, thickness and shapes over time, what was refused, and the files of it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from softcat_sym import drawing, files
from softcat_sym.tracking.film import Film
from softcat_sym.tracking.over_time import REPEATED
from softcat_sym.tracking.strand import Camera

Floats = NDArray[np.float64]

MAX_POINTS = 11
"""Points of a shape at most: of more, neighbours on one spline are no readings of their own."""


class RefusedFrame(NamedTuple):
    """A frame that gives no midpoint."""

    number: int
    time: float  # [s] by the film's clock
    reason: str


@dataclass(frozen=True, eq=False)
class Track(drawing.Drawable):
    """A strand tracked through a film.

    Attributes
    ----------
    film : Film
        The film, to be read again for pictures.
    camera : Camera
        Geometry and light of the picture.
    pixel, pixel_std : float
        Length of a pixel and its standard error [m].
    number : ndarray of int, shape (n,)
        Numbers of the frames that were read, from 0.
    time : ndarray, shape (n,)
        [s] since the release.
    midpoint, midpoint_std : ndarray, shape (n,)
        Height above the supports' level, negative below it, and its standard error [m].
    thickness, thickness_std : ndarray, shape (n,)
        At the midpoint, along the normal [m]; NaN where it is below 2.5 blur widths.
    place : ndarray, shape (points,)
        x of the shapes' points from halfway between the supports [m].
    shapes, shapes_std, shapes_thickness : ndarray, shape (n, points)
        Heights, standard errors and thicknesses there [m]; NaN where the strand was not seen.
    release, release_std : float
        Time of the release by the film's clock, and its standard error [s].
    misfit : ndarray, shape (n,)
        Residuals of the edges' brightness over the film's median.
    refused : tuple of RefusedFrame
        Frames that were refused, with the reason.
    codec : str
        Name of the codec.
    bits_per_pixel : float
        Size of the film; infinite for pictures.
    factors : tuple of float
        By which scatter over time widens the errors of midpoint and thickness.
    warnings : tuple of str
        What speaks against the numbers, and how to film better.
    """

    film: Film
    camera: Camera
    pixel: float
    pixel_std: float
    number: NDArray[np.int64]
    time: Floats
    midpoint: Floats
    midpoint_std: Floats
    thickness: Floats
    thickness_std: Floats
    place: Floats
    shapes: Floats
    shapes_std: Floats
    shapes_thickness: Floats
    release: float
    release_std: float
    misfit: Floats
    refused: tuple[RefusedFrame, ...]
    codec: str
    bits_per_pixel: float
    factors: tuple[float, float]
    warnings: tuple[str, ...]

    @property
    def span(self) -> float:
        """Distance of the supports [m]."""
        return self.camera.span * self.pixel

    @property
    def is_trusted(self) -> bool:
        """Whether five frames were read or more, and at most half of them refused, repeated ones aside."""
        # A repeated frame is no fault of the film: it tells nothing new.
        lost = sum(one.reason != REPEATED for one in self.refused)
        return self.number.size >= 5 and lost <= self.number.size

    def to_frame(self, points: int = 0) -> pd.DataFrame:
        """Table of midpoints, or of up to 11 points of each whole shape, as ``softcat fit`` reads it.

        Its columns are ``time_s, midpoint_mm, midpoint_std_mm, thickness_mm, thickness_std_mm, frame_number``, or
        ``time_s, x_mm, y_mm, y_std_mm, thickness_mm, frame_number``.
        """
        if not points:
            columns = {
                "time_s": self.time,
                "midpoint_mm": 1e3 * self.midpoint,
                "midpoint_std_mm": 1e3 * self.midpoint_std,
                "thickness_mm": 1e3 * self.thickness,
                "thickness_std_mm": 1e3 * self.thickness_std,
                "frame_number": self.number,
            }
            return pd.DataFrame(columns).dropna(subset="midpoint_mm")
        chosen = np.linspace(0, self.place.size - 1, points).round().astype(int)
        columns = {
            "time_s": np.repeat(self.time, points),
            "x_mm": np.tile(1e3 * self.place[chosen], self.number.size),
            "y_mm": 1e3 * self.shapes[:, chosen].ravel(),
            "y_std_mm": 1e3 * self.shapes_std[:, chosen].ravel(),
            "thickness_mm": 1e3 * self.shapes_thickness[:, chosen].ravel(),
            "frame_number": np.repeat(self.number, points),
        }
        return pd.DataFrame(columns).dropna(subset="y_mm")

    def to_csv(self, points: int = 0) -> str:
        """The table with comments, of which ``filament.span`` sets the scene's."""
        comments = [
            f"filament.span = {1e3 * self.span:.6g} mm",
            f"tracked from: {self.film.path.name} ({self.codec}, {self.bits_per_pixel:.3g} bits a pixel and frame)",
            f"pixel of {1e6 * self.pixel:.6g} +- {1e6 * self.pixel_std:.2g} um, "
            f"tilt of {np.degrees(self.camera.tilt):.3f} deg taken out",
            f"time 0 is {self.release:.6g} +- {self.release_std:.2g} s of the film, the release",
            *(f"warning: {text}" for text in self.warnings),
        ]
        table: str = self.to_frame(points).to_csv(index=False, float_format="%.7g")
        return "".join(f"# {line}\n" for line in comments) + table

    def save(self, path: str | Path, points: int = 0) -> Path:
        """Write the table for ``softcat fit`` and :func:`softcat_sym.fit`, and return its path."""
        path = Path(path)
        with files.new_folder(path.parent):
            return files.replace_atomically(path, self.to_csv(points).encode())

    def to_dict(self) -> dict[str, Any]:
        """Content of ``track.json``, in SI; pixels where it says so."""
        return {
            "film": self.film.path.name,
            "codec": self.codec,
            "bits_per_pixel": self.bits_per_pixel,
            "frames_read": int(self.number.size),
            "frames_refused": len(self.refused),
            "is_trusted": self.is_trusted,
            "pixel_m": self.pixel,
            "pixel_std_m": self.pixel_std,
            "span_m": self.span,
            "supports_px": list(self.camera.supports),
            "supports_std_px": list(self.camera.supports_std),
            "tilt_rad": self.camera.tilt,
            "blur_px": self.camera.width,
            "is_dark": self.camera.light.is_dark,
            "release_s": self.release,
            "release_std_s": self.release_std,
            "time_s": self.time.tolist(),
            "midpoint_m": self.midpoint.tolist(),
            "midpoint_std_m": self.midpoint_std.tolist(),
            "thickness_m": self.thickness.tolist(),
            "thickness_std_m": self.thickness_std.tolist(),
            "error_factors": {"midpoint": self.factors[0], "thickness": self.factors[1]},
            "refused": [dict(zip(("frame", "time_s", "reason"), one, strict=True)) for one in self.refused],
            "warnings": list(self.warnings),
        }

    def __repr__(self) -> str:
        return (
            f"Track of {self.film.path.name}: {self.number.size} frames read, {len(self.refused)} refused, "
            f"span {1e3 * self.span:.4g} mm, sag to {-1e3 * np.nanmin(self.midpoint):.4g} mm"
        )
