"""One restrained publication style: colours, fonts, units in which values read best, names beside points, stamps."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cache
from io import BytesIO
from typing import TYPE_CHECKING, Any, Final, Protocol, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox
from numpy.typing import ArrayLike, NDArray

from softcat_sym.errors import SoftcatError

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.text import Text

SCREEN: Final = "screen"
STYLES: Final = {SCREEN: SCREEN, "publication": "column", "column": "column", "page": "page"}
"""What may be asked for, and what it means: pictures for a screen, or for print as wide as a column or a page."""


def picture_style(asked: str) -> str:
    """Read what was asked for, before anything is computed."""
    if asked not in STYLES:
        raise SoftcatError(
            f"--style: no style {asked!r}; accepted: screen, publication (or column: 84 mm wide, PDF and PNG), "
            "page (174 mm wide)"
        )
    return STYLES[asked]


Summary: TypeAlias = Mapping[str, Any]
"""The dictionary that ``summary.json`` holds."""


class PicturedFilament(Protocol):
    """Geometry and density of the filament, SI."""

    @property
    def span(self) -> float:
        """Distance between the supports [m]."""

    @property
    def thickness(self) -> float:
        """Initial thickness [m]."""

    @property
    def density(self) -> float:
        """Density [kg/m^3]."""


class PicturedMaterial(Protocol):
    """The law and the two moduli that scale a picture, SI."""

    @property
    def law(self) -> str:
        """Name of the law."""

    @property
    def youngs_modulus(self) -> float | None:
        """Young's modulus [Pa]; ``None`` for a law without elasticity."""

    @property
    def yield_stress(self) -> float | None:
        """Tensile yield stress [Pa]; ``None`` for a law that does not yield."""


class PicturedLoad(Protocol):
    """The load, SI."""

    @property
    def gravity(self) -> float:
        """Acceleration of gravity [m/s^2]."""


class PicturedEnds(Protocol):
    """What holds the ends."""

    @property
    def left(self) -> str:
        """``"clamped"``, or another kind of end."""

    @property
    def right(self) -> str:
        """Likewise."""

    @property
    def drop(self) -> float:
        """Right support below the left one [m]."""

    @property
    def motion(self) -> tuple[tuple[float, float, float], ...]:
        """Path of the right support; empty where it stays."""


class PicturedRun(Protocol):
    """What was asked of the run."""

    @property
    def accuracy(self) -> float:
        """Accuracy of the midpoint relative to its largest sag."""


class PicturedScene(Protocol):
    """The part of a scene that reaches a picture or a table."""

    @property
    def title(self) -> str:
        """Title, possibly empty."""

    @property
    def filament(self) -> PicturedFilament:
        """The filament."""

    @property
    def material(self) -> PicturedMaterial:
        """The material."""

    @property
    def ends(self) -> PicturedEnds:
        """The ends."""

    @property
    def load(self) -> PicturedLoad:
        """The load."""

    @property
    def run(self) -> PicturedRun:
        """The run."""


@dataclass(frozen=True, slots=True)
class Unit:
    """A display unit."""

    symbol: str  # Symbol written on the axis
    size: float  # Size of the unit in SI units

    def of(self, value: ArrayLike) -> NDArray[np.float64]:
        """Express SI values in this unit."""
        return np.asarray(value, dtype=np.float64) / self.size

    def text(self, value: float) -> str:
        """Write one SI value with three significant digits and this unit."""
        return f"{significant(value / self.size)} {self.symbol}"


LENGTHS = (Unit("nm", 1e-9), Unit("µm", 1e-6), Unit("mm", 1e-3), Unit("m", 1.0), Unit("km", 1e3))
# An hour and a minute begin late: 90 s and 100 min read better than 1.5 min and 1.67 h.
TIMES = (Unit("µs", 1e-6), Unit("ms", 1e-3), Unit("s", 1.0), Unit("min", 60.0), Unit("h", 3600.0))
TIMES_BEGIN = (1e-6, 1e-3, 1.0, 300.0, 10800.0)
ENERGIES = (Unit("pJ", 1e-12), Unit("nJ", 1e-9), Unit("µJ", 1e-6), Unit("mJ", 1e-3), Unit("J", 1.0), Unit("kJ", 1e3))
SHARES = (Unit("ppb", 1e-9), Unit("ppm", 1e-6), Unit("%", 1e-2))
SHARES_BEGIN = (1e-9, 1e-6, 1e-4)
STRESSES = (Unit("mPa", 1e-3), Unit("Pa", 1.0), Unit("kPa", 1e3), Unit("MPa", 1e6), Unit("GPa", 1e9))


def length_unit(largest: float, fallback: float = 1.0) -> Unit:
    """Choose nm, µm, mm, m or km for lengths up to ``largest`` [m]."""
    return _choose(LENGTHS, tuple(unit.size for unit in LENGTHS), largest or fallback)


def time_unit(largest: float) -> Unit:
    """Choose µs, ms, s, min (from 300 s) or h (from 3 h) for times up to ``largest`` [s]."""
    return _choose(TIMES, TIMES_BEGIN, largest or 1.0)


def energy_unit(largest: float) -> Unit:
    """Choose a prefix of the joule for energies up to ``largest`` [J]."""
    return _choose(ENERGIES, tuple(unit.size for unit in ENERGIES), largest or 1.0)


def share_unit(largest: float) -> Unit:
    """Choose ppb, ppm (from 1e-6) or per cent (from 1e-4) for shares up to ``largest``."""
    return _choose(SHARES, SHARES_BEGIN, largest or 1.0)


def stress_unit(largest: float) -> Unit:
    """Choose a prefix of the pascal for stresses up to ``largest`` [Pa]."""
    return _choose(STRESSES, tuple(unit.size for unit in STRESSES), largest or 1.0)


def significant(value: float) -> str:
    """Write a number with three significant digits, a true minus sign and no exponent between 1e-3 and 1e5."""
    if value == 0 or not math.isfinite(value):
        return f"{abs(value):g}" if value == 0 else str(value)
    exponent = math.floor(math.log10(abs(float(f"{value:.2e}"))))
    text = f"{value:.{max(0, 2 - exponent)}f}" if -3 <= exponent < 5 else f"{value:.2e}"
    return text.replace("-", "\N{MINUS SIGN}", 1) if value < 0 else text


def nice_floor(value: float) -> float:
    """Round a positive number down to 1, 2 or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value))
    # The tiny slack keeps 0.02 / 0.01 a two, and not 1.9999999999999998.
    return max((step for step in (1.0, 2.0, 5.0) if step * power <= value * (1 + 1e-12)), default=1.0) * power


def _choose(units: tuple[Unit, ...], begins: tuple[float, ...], largest: float) -> Unit:
    """Take the last unit whose range has begun; the slack keeps 0.999999999999 s in seconds."""
    reached = [unit for unit, begin in zip(units, begins, strict=True) if abs(largest) >= begin * (1 - 1e-9)]
    return reached[-1] if reached else units[0]


BLACK: Final = "#222222"
GREY: Final = "#8a8a8a"
BLUE: Final = "#0072B2"
SKY: Final = "#56B4E9"
GREEN: Final = "#009E73"
ORANGE: Final = "#E69F00"
VERMILLION: Final = "#D55E00"
PURPLE: Final = "#CC79A7"
FILAMENT: Final = "#e3eaf0"

DPI: Final = 150
WIDTH: Final = 7.2
"""Width of every picture [inch]: a page's text width."""

RC: Final[dict[str, Any]] = {
    # Said even where it is the default: a user's own matplotlibrc must neither restyle a report nor call LaTeX.
    "text.usetex": False,
    "font.family": ["DejaVu Sans"],
    "font.size": 9.0,
    "axes.unicode_minus": True,
    "axes.titlesize": 10.0,
    "axes.titleweight": "normal",
    "axes.labelsize": 9.0,
    "axes.labelcolor": BLACK,
    "axes.edgecolor": GREY,
    "axes.linewidth": 0.6,
    "axes.facecolor": "white",
    "axes.grid": False,
    "axes.axisbelow": True,
    "axes.formatter.use_locale": False,
    # Units are chosen to fit: neither a power of ten nor an offset stands beside an axis.
    "axes.formatter.limits": (-5, 6),
    "axes.formatter.useoffset": False,
    # Mathtext would load a parser, a sixth of a second, for the sake of one power of ten.
    "axes.formatter.use_mathtext": False,
    "axes.xmargin": 0.0,
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "xtick.color": GREY,
    "ytick.color": GREY,
    "xtick.labelcolor": BLACK,
    "ytick.labelcolor": BLACK,
    "xtick.direction": "out",
    "ytick.direction": "out",
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "grid.color": "#e8e8e8",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "legend.fontsize": 8.0,
    "lines.linewidth": 1.4,
    "text.color": BLACK,
    "figure.facecolor": "white",
    "figure.dpi": DPI,
    "savefig.dpi": DPI,
    "savefig.facecolor": "white",
    "savefig.bbox": None,
    # TrueType, as journals ask: text in a PDF stays text.
    "pdf.fonttype": 42,
}
"""Settings of Matplotlib in force while a picture is made and drawn."""


def styled() -> AbstractContextManager[None]:
    """Put the style in force for the length of a ``with`` block; what was set before comes back."""
    from matplotlib import rc_context

    # Matplotlib's versions disagree on the type of the keys, not on the keys.
    settings: Any = RC
    return rc_context(settings)


def lighten(axes: Axes, twin: bool = False) -> None:
    """Take away the spines that carry no axis."""
    axes.spines["top"].set_visible(twin)
    axes.spines["right"].set_visible(twin)


def printable(text: str, longest: int = 78) -> str:
    """Make a user's text safe to draw: one line, not too long, only glyphs that the font has.

    A missing glyph would raise a warning and draw a box; it is replaced by a question mark.
    """
    line = " ".join(text.split())
    line = line if len(line) <= longest else line[: longest - 1].rstrip() + "…"
    if line.isascii():
        return line
    known = _glyphs()
    return "".join(character if ord(character) in known else "?" for character in line)


@cache
def _glyphs() -> frozenset[int]:
    """Code points of the report's font."""
    from matplotlib.font_manager import findfont, get_font

    return frozenset(get_font(findfont("DejaVu Sans")).get_charmap())


STAMP: Final = "REFUSED: "

_USED: Final = ("", "solved")
"""Outcomes of answers that may be used; nothing is known of one without outcome."""


def refused(summary: Summary) -> str:
    """Outcome of a result that is refused; empty of one that may be used."""
    outcome = str(summary.get("outcome") or "")
    return "" if outcome in _USED else outcome


def stamp(figure: Figure, summary: Summary) -> list[Text]:
    """Write across a picture that its result is refused, and what of it is not drawn."""
    outcome = refused(summary)
    if not outcome:
        return []
    width, height = figure.get_size_inches()
    lines = [STAMP + outcome, *([str(summary["not_drawn"])] if summary.get("not_drawn") else [])]
    texts = []
    # Letters of a bold font are three quarters as wide as it is high.
    big, small = (
        min(size, 72 * 0.8 * width / (0.75 * len(line)))
        for size, line in zip((30.0, 11.0), (lines * 2)[:2], strict=True)
    )
    for text, size, below in zip(lines, (big, small), (0.0, 1.1 * big / 72), strict=False):
        texts.append(
            figure.text(
                0.5, 0.5 - below / height, text, ha="center", va="center", fontsize=size, fontweight="bold",
                color=VERMILLION, alpha=0.75, zorder=100, parse_math=False, in_layout=False,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.6, "pad": 1.5},
            )
        )  # fmt: skip
    return texts


def shown_part(data: xr.Dataset, summary: Summary) -> tuple[xr.Dataset, Summary]:
    """A run as it is drawn: one that is refused ends where it hangs deeper than it is long.

    A neck that runs away would otherwise scale the axes, as if its depth were an answer.
    """
    if not refused(summary):
        return data, summary
    x, y = (np.asarray(data[name].values, dtype=np.float64) for name in ("x", "y"))
    line = y[:, :1] + (y[:, -1:] - y[:, :1]) * np.linspace(0.0, 1.0, y.shape[1])
    reach = np.maximum(np.ptp(data["X_node"].values), np.hypot(x[:, -1] - x[:, 0], y[:, -1] - y[:, 0]))
    # Written so that what is not a number is beyond it too.
    beyond = ~(np.abs(y - line).max(axis=1) <= reach)
    if not beyond.any():
        return data, summary
    end = max(1, int(beyond.argmax()))
    time = data["time"].values
    said = time_unit(float(time[-1])).text(float(time[end - 1]))
    words = f"not drawn after {said}: deeper than it is long"
    return data.isel(time=slice(0, end)), {**summary, "not_drawn": words}


HEADING = 0.62
"""Height that a heading takes at the top of a picture [inch]."""

_TITLE = 0.31
"""Height of its first line, the title."""


def new_figure(width: float, height: float) -> Figure:
    """Make an empty figure of the given size [inch] with a canvas of its own."""
    figure = Figure(figsize=(width, height))
    FigureCanvasAgg(figure)
    return figure


def constrained(figure: Figure, heading: float = HEADING) -> None:
    """Let Matplotlib's constrained layout place the axes of a figure below a heading of this height [inch]."""
    height = figure.get_size_inches()[1]
    figure.set_layout_engine("constrained", rect=(0.0, 0.0, 1.0, 1.0 - heading / height), w_pad=0.06, h_pad=0.04)


def axes_in_inches(figure: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Add axes at a place given in inches, so that a layout needs no solver and an aspect is exact."""
    full_width, full_height = figure.get_size_inches()
    return figure.add_axes((left / full_width, bottom / full_height, width / full_width, height / full_height))


def head(figure: Figure, what: str, summary: Summary, scene: PicturedScene, left: float) -> None:
    """Write the scene's title, what is shown and how the run ended along the top; stamp what is refused."""
    width, height = figure.get_size_inches()
    ending = [str(summary[key]) for key in ("regime", "outcome") if summary.get(key)]
    below = " · ".join([what, *ending])
    title = printable(scene.title) or "Filament"
    # parse_math off: a dollar sign in a user's title is a dollar sign.
    place = left / width
    figure.text(place, 1 - 0.12 / height, title, va="top", fontsize=10.5, fontweight="bold", parse_math=False)
    figure.text(place, 1 - 0.33 / height, printable(below, 110), va="top", fontsize=8.5, color=GREY, parse_math=False)
    stamp(figure, summary)


def png(figure: Figure, *, titled: bool = True) -> bytes:
    """Draw a figure."""
    content = BytesIO()
    # Some settings are read only now: ticks are made, and fonts found, while drawing.
    width, height = figure.get_size_inches()
    shown = None if titled else Bbox.from_extents(0.0, 0.0, width, height - _TITLE)
    with styled():
        figure.savefig(content, format="png", bbox_inches=shown)
    return content.getvalue()


_FONT, _MARKER, _PAD = 7.5, 4.0, 1.0
_NEAREST, _FAR, _FARTHEST, _STEP, _DIRECTIONS = 6.0, 60.0, 260.0, 3.0, 32

_CLEARLY, _ALONE = 0.8, 0.6
"""Of the distance to the next point: below the first a name is its own point's, below the second plainly so."""

Pixel: TypeAlias = tuple[float, float]


def label_points(axes: Axes, points: Sequence[tuple[float, float]], names: Sequence[str]) -> None:
    """Write a name beside each point, with a thin line to it where the name had to go farther away."""
    pixels = (axes.figure.dpi if axes.figure is not None else DPI) / 72
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
            axes.plot(*line, transform=None, color=GREY, linewidth=0.5, zorder=2.5)


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


REGIMES = {
    "no-yield": "it holds: no fibre yields",
    "arrested-overdamped": "it yields, sags and stops",
    "arrested-underdamped": "it yields, overshoots, swings back and stops",
    "descending": "it does not stop within this run",
    "viscous": "it flows for as long as it is loaded",
    "shaken": "it has yielded, is shaken, and flows no further",
    "elastic": "it is elastic and sags no further than its modulus lets it",
}
"""Regimes by name."""


def regime_words(name: str) -> str:
    """A regime in words, and its name."""
    return f"{REGIMES[name]} ({name})" if name in REGIMES else name


def error_percent(share: float) -> str:
    """An error in per cent with one digit, two if the first is a one: ``0.09 %``, ``1.1 %``."""
    rough = f"{100 * share:.1e}"
    digits = 2 if rough.startswith("1") else 1
    return f"{float(f'{100 * share:.{digits}g}'):g} %"
