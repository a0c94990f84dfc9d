"""Films, stacks and folders of pictures as grey frames with the file's own times."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from softcat_sym.errors import SoftcatError

Picture = NDArray[np.float32]
Region = tuple[int, int, int, int]
"""Columns and rows x0, x1, y0, y1 of a part of a picture; x1 and y1 are the first ones beyond it."""

PICTURES = (".png", ".tif", ".tiff", ".gif", ".bmp", ".jpg", ".jpeg", ".pgm")
_FILMS = (".mp4", ".mov", ".avi", ".mkv", ".webm", ".m4v", ".mpg", ".mpeg", ".wmv", ".mjpeg")
_UNREADABLE = "cannot be read; accepted: a film, a TIFF stack or a folder of pictures"


@dataclass(frozen=True, eq=False)
class Frame:
    """One frame."""

    number: int  # From 0
    time: float  # [s] by the file's own clock
    grey: Picture  # shape (rows, columns); grey levels
    is_predicted: bool = False  # Whether the codec wrote only what changes


class Codec(NamedTuple):
    """How the frames of a film are written."""

    name: str
    bits: float  # Of all frames; infinite for pictures
    is_lossless: bool


def part_of(grey: Picture, region: Region, name: str) -> Picture:
    """A region of a picture."""
    (rows, columns), (x0, x1, y0, y1) = grey.shape, region
    if not (0 <= x0 < x1 <= columns and 0 <= y0 < y1 <= rows):
        raise SoftcatError(f"{name} {x0},{x1},{y0},{y1} is outside of the picture; accepted: columns x0,x1 in 0 to "
                           f"{columns} and rows y0,y1 in 0 to {rows}")  # fmt: skip
    return grey[y0:y1, x0:x1]


@dataclass(frozen=True)
class Film:
    """A film, a stack or a folder of pictures, which is read anew by every loop over it."""

    path: Path
    fps: float | None = None  # [1/s]; None for the times of the file
    region: Region | None = None  # Part that is read; None for all
    is_vertical: bool = False  # Turned by 90 degrees, for threads that hang

    @property
    def _is_pictures(self) -> bool:
        return self.path.is_dir() or self.path.suffix.lower() in PICTURES

    def __iter__(self) -> Iterator[Frame]:
        try:
            for frame in self._of_pictures() if self._is_pictures else self._of_video():
                grey = frame.grey if self.region is None else part_of(frame.grey, self.region, "region")
                yield replace(frame, grey=np.rot90(grey) if self.is_vertical else grey)
        except (UnidentifiedImageError, EOFError, SyntaxError) as error:
            raise SoftcatError(f"film {self.path}: {_UNREADABLE} ({error})") from None

    def _of_pictures(self) -> Iterator[Frame]:
        if self.fps is None:
            raise SoftcatError(
                f"film {self.path}: pictures have no times; accepted: softcat track with --fps, such as --fps 240"
            )
        number, size = 0, None
        for file in self._files():
            with Image.open(file) as picture:
                for page in range(getattr(picture, "n_frames", 1)):
                    picture.seek(page)
                    # Of a picture in colour its brightness.
                    is_grey = picture.mode in ("I;16", "I;16B", "I;16L", "I", "F")
                    grey = np.asarray(picture if is_grey else picture.convert("L"), dtype=np.float32)
                    if size not in (None, grey.shape):
                        raise SoftcatError(f"film {self.path}: {file.name} is of another size than the first picture")
                    size = grey.shape
                    yield Frame(number, number / self.fps, grey)
                    number += 1

    def _files(self) -> list[Path]:
        """The pictures, number 10 after number 9."""
        if self.path.is_file():
            return [self.path]
        return sorted(
            (one for one in self.path.iterdir() if one.suffix.lower() in PICTURES),
            key=lambda one: [(not part.isdigit(), part.zfill(20)) for part in re.split(r"(\d+)", one.name)],
        )

    def _of_video(self) -> Iterator[Frame]:
        av = pyav()
        if not self.path.exists():
            raise FileNotFoundError(f"no such film: {self.path}")
        try:
            with av.open(str(self.path)) as container:
                if not container.streams.video:
                    raise SoftcatError(f"film {self.path}: no pictures in it; accepted: a film or a folder of pictures")
                stream = container.streams.video[0]
                is_intra = stream.codec_context.codec.intra_only
                for number, frame in enumerate(container.decode(stream)):
                    if self.fps is None and frame.pts is None:
                        raise SoftcatError(f"film {self.path}: frame {number} has no time; accepted: --fps 240")
                    deep = max(component.bits for component in frame.format.components) > 8
                    grey = frame.to_ndarray(format="gray16le" if deep else "gray").astype(np.float32)
                    turns = round(getattr(frame, "rotation", 0) / 90) % 4  # as the phone was held
                    time = frame.pts * Fraction(frame.time_base) if self.fps is None else number / self.fps
                    yield Frame(number, float(time), np.rot90(grey, turns), not is_intra and int(frame.pict_type) != 1)
        except av.error.FFmpegError as error:
            raise SoftcatError(f"film {self.path}: {_UNREADABLE} ({error.strerror})") from None

    def codec(self) -> Codec:
        """How its frames are written."""
        if self._is_pictures:
            return Codec("pictures", np.inf, not {".jpg", ".jpeg"} & {one.suffix.lower() for one in self._files()})
        with pyav().open(str(self.path)) as container:
            stream = container.streams.video[0]
            kind, bits = stream.codec_context.codec, 8.0 * sum(packet.size for packet in container.demux(stream))
            return Codec(stream.codec_context.name, bits, bool(kind.lossless and not kind.lossy))


def is_film(path: Path) -> bool:
    """Whether a file is a film with times of its own, and no table, by its name."""
    return path.suffix.lower() in _FILMS


def pyav() -> Any:
    """The module of PyAV, or an error that says how to install it."""
    try:
        import av
    except ImportError:
        raise SoftcatError(
            "films are read by PyAV, which is not installed: pip install 'softcat_sym[camera]'"
        ) from None
    return av
