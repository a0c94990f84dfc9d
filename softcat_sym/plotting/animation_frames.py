"""What a film shows at each moment, and films as files: GIF by Pillow, MP4 by ffmpeg."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, Final, cast

import numpy as np
import xarray as xr

from softcat_sym.errors import SoftcatError
from softcat_sym.plotting.section import Floats, outline, quads_outside, section_at, yielding_of

if TYPE_CHECKING:
    from PIL.Image import Image as Picture

    from softcat_sym.plotting.animation import Animation
    from softcat_sym.plotting.style import PicturedScene, Summary

STRIPS = 8
"""Through the thickness."""

_ZETA = np.linspace(-1.0, 1.0, STRIPS + 1)
_AMID = 0.5 * (_ZETA[1:] + _ZETA[:-1])

_FIELDS = ("x", "y", "thickness", "stress_mean", "stress_bending", "midpoint")


@dataclass(frozen=True, slots=True)
class Moment:
    """The filament at one time."""

    time: float  # [s]
    midpoint: float  # Its height [m]
    outline: Floats  # Closed polygon, shape (vertex, 2) [m]
    strips: Floats  # Quads that cover it, every cell in as many strips through the thickness, shape (quad, 4, 2) [m]
    stress: Floats  # Magnitude of the axial stress sigma_0 + sigma_1 zeta amid each, shape (quad,) [Pa]
    yielded: Floats  # Quads of what yields, shape (quad, 4, 2) [m]


class Film:
    """Moments of a run, equally spaced in time."""

    def __init__(self, data: xr.Dataset, scene: PicturedScene, moments: int) -> None:
        time = np.asarray(data["time"].values, dtype=np.float64)
        self.times: Floats = np.linspace(time[0], time[-1], max(1, moments))
        after = np.clip(np.searchsorted(time, self.times), 1, max(1, time.size - 1))
        before = after - 1
        after = np.minimum(after, time.size - 1)
        gap = time[after] - time[before]
        part = np.where(gap > 0, (self.times - time[before]) / np.where(gap > 0, gap, 1.0), 0.0)
        yields = yielding_of(data, scene)
        cores = {"low": (("time", "cell"), yields.low), "high": (("time", "cell"), yields.high)}
        self.run_times: Floats = time
        self.run_midpoint: Floats = np.asarray(data["midpoint"].values, dtype=np.float64)
        self.resolved = "core_low" in data
        data = data[list(_FIELDS)].assign(cores)

        def between(name: str) -> tuple[tuple[str, ...], Floats]:
            values = np.asarray(data[name].transpose("time", ...).values, dtype=np.float64)
            share = part.reshape(-1, *(1,) * (values.ndim - 1))
            dims = tuple(str(dim) for dim in data[name].transpose("time", ...).dims)
            return dims, np.asarray((1 - share) * values[before] + share * values[after])

        places = {name: data[name] for name in ("X_node", "X_cell")}
        self._data = xr.Dataset({name: between(str(name)) for name in data}, coords={"time": self.times, **places})
        self.midpoint: Floats = self._data["midpoint"].values
        self._clamped = (scene.ends.left == "clamped", scene.ends.right == "clamped")
        outlines = np.stack([outline(section_at(self._data, k, self._clamped)) for k in range(self.times.size)])
        self.bounds: Floats = np.stack([outlines.min(axis=(0, 1)), outlines.max(axis=(0, 1))])
        self.largest = float(np.quantile(np.stack([self._stress(k) for k in range(self.times.size)]), 0.995))
        self.sag = self._sag()

    def _sag(self) -> float:
        y = self._data["y"].values
        line = y[:, :1] + (y[:, -1:] - y[:, :1]) * np.linspace(0.0, 1.0, y.shape[1])
        return float(np.abs(y - line).max())

    def _stress(self, number: int) -> Floats:
        mean, slope = (self._data[name].values[number] for name in ("stress_mean", "stress_bending"))
        return np.asarray(np.abs(mean + np.multiply.outer(_AMID, slope)).ravel())

    def moment(self, number: int) -> Moment:
        """What is shown at the moment of this number."""
        data = self._data
        section = section_at(data, number, self._clamped)
        yielded = quads_outside(section, data["low"].values[number], data["high"].values[number])
        grid = np.stack([section.at(float(zeta)) for zeta in _ZETA])
        strips = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]], axis=2).reshape(-1, 4, 2)
        time, midpoint = float(self.times[number]), float(self.midpoint[number])
        return Moment(time, midpoint, outline(section), strips, self._stress(number), yielded)


KINDS: Final = {"gif": 12.5, "mp4": 25.0}
"""Kinds of film, and their pictures a second; a GIF counts in hundredths of a second, and 8 of them are a picture."""

LONGEST: Final = 120.0
"""Of a film [s]: what is longer would fill the memory, and nobody would watch it."""

_HOLD_MS: Final = 1200
"""How long a GIF rests on its last picture before it begins again."""

_COLOURS: Final = 128
"""Of a GIF; it then holds pictures without dots, and less of them."""

_PAPER: Final = 247
"""Colours of a GIF that are as light as this are the paper's."""


@dataclass(frozen=True, slots=True)
class FilmOrder:
    """A film that was asked for, and can be made here."""

    name: str  # Of the file
    kind: str  # ``gif`` or ``mp4``
    seconds: float  # Its length [s]
    ffmpeg: str = ""  # The program, of an MP4

    @property
    def pictures(self) -> int:
        """How many it shows."""
        return max(2, round(self.seconds * KINDS[self.kind]))


def film_order(asked: str, seconds: float) -> FilmOrder:
    """Read what was asked for, before anything is computed."""
    name = asked if "." in asked else f"film.{asked}"
    kind = Path(name).suffix[1:].lower()
    if kind not in KINDS or Path(name).name != name or not Path(name).stem.strip("."):
        raise SoftcatError(
            f"--animate: {asked!r} is no film; accepted: gif, mp4, or a file name that ends so, such as film.gif; "
            "it goes into DIR"
        )
    if not 0 < seconds <= LONGEST:
        raise SoftcatError(f"--animate-seconds: {seconds:g} s; accepted: more than 0 and at most {LONGEST:g} s")
    return FilmOrder(name, kind, seconds, _ffmpeg() if kind == "mp4" else "")


def _ffmpeg() -> str:
    """The program on the path, or the one that the package imageio-ffmpeg brings along."""
    found = shutil.which("ffmpeg")
    if found:
        return found
    try:
        import imageio_ffmpeg

        return str(imageio_ffmpeg.get_ffmpeg_exe())
    except (ImportError, RuntimeError):
        raise SoftcatError(
            "--animate: an MP4 needs ffmpeg, and there is none: install it (Debian: apt install ffmpeg), or "
            "pip install 'softcat_sym[movies]'; a GIF needs nothing else"
        ) from None


def write_film(
    order: FilmOrder,
    directory: Path,
    run: tuple[xr.Dataset, Summary, PicturedScene],
    step: Callable[[str], None] = lambda what: None,
    width: int = 1280,
) -> tuple[Path, str]:
    """Draw a film and write it, whole or not at all."""
    from softcat_sym.files import fill_atomically
    from softcat_sym.plotting.animation import Animation

    animation = Animation(*run, order.pictures, width)

    def fill(path: Path) -> None:
        if order.kind == "gif":
            _gif(animation, path, step)
        else:
            _mp4(animation, path, order.ffmpeg, step)

    return fill_atomically(directory / order.name, fill), animation.note


def _gif(animation: Animation, path: Path, step: Callable[[str], None]) -> None:
    """All pictures with the colours of a few of them, so that what does not move is the same number in all."""
    from PIL import Image

    few = np.concatenate([animation.picture(k) for k in np.unique(np.linspace(0, len(animation) - 1, 5).astype(int))])
    palette = Image.fromarray(few).quantize(_COLOURS, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
    # The mean of what is nearly white is not white.
    colours = np.reshape(palette.getpalette() or [], (-1, 3))
    colours[colours.min(axis=1) >= _PAPER] = 255
    palette.putpalette(colours.ravel().tolist())

    def painted(number: int) -> Picture:
        step(f"picture {number + 1} of {len(animation)}")
        return Image.fromarray(animation.picture(number)).quantize(palette=palette, dither=Image.Dither.NONE)

    pause = round(1000 / KINDS["gif"])
    pauses = [pause] * (len(animation) - 1) + [_HOLD_MS]
    first, rest = painted(0), (painted(number) for number in range(1, len(animation)))
    with path.open("xb") as stream:
        first.save(stream, format="GIF", save_all=True, append_images=rest, duration=pauses, loop=0, optimize=False)


def _mp4(animation: Animation, path: Path, ffmpeg: str, step: Callable[[str], None]) -> None:
    """Hand raw pictures to ffmpeg; H.264 that every player shows."""
    width, height = animation.size
    taken = ["-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", f"{KINDS['mp4']:g}", "-i", "-"]
    made = ["-an", "-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart", str(path)]
    command = [ffmpeg, "-loglevel", "error", "-nostdin", "-y", *taken, *made]
    # A group of its own: Ctrl-C is ours to handle.
    pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE}
    with subprocess.Popen(command, start_new_session=True, **pipes) as process:
        ours, theirs = cast("IO[bytes]", process.stdin), cast("IO[bytes]", process.stderr)
        try:
            for number, picture in enumerate(animation.pictures()):
                step(f"picture {number + 1} of {len(animation)}")
                ours.write(picture.tobytes())
            _, said = process.communicate()
        except BrokenPipeError:
            said = theirs.read()
            process.wait()
        except BaseException:
            process.kill()
            raise
    if process.returncode != 0:
        reason = " ".join(said.decode(errors="replace").split())[-300:] or f"exit status {process.returncode}"
        raise SoftcatError(f"--animate: ffmpeg could not write the film: {reason}")
