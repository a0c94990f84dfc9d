"""One restrained publication style: colours, fonts, sheets with their headings, names beside points, stamps."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager
from functools import cache
from io import BytesIO
from textwrap import fill
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure, SubFigure
from matplotlib.font_manager import findfont, get_font
from matplotlib.legend import Legend
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
from matplotlib.transforms import Bbox, ScaledTranslation
from numpy.typing import ArrayLike

from softcat_sym.errors import SoftcatError
from softcat_sym.plotting.units import Summary, time_unit

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.text import Text

    from softcat_sym.scene.scene import Scene

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


def axes_in_inches(figure: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Add axes at a place given in inches, so that a layout needs no solver and an aspect is exact."""
    full_width, full_height = figure.get_size_inches()
    return figure.add_axes((left / full_width, bottom / full_height, width / full_width, height / full_height))


def head(figure: Figure, what: str, summary: Summary, scene: Scene, left: float) -> None:
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


def sheet(
    title: str, below: str = "", *, height: float, notes: str = "", width: float = WIDTH, columns: int = 118
) -> tuple[Figure, SubFigure]:
    """A figure with a title and what is shown along its top and notes along its bottom, and the part in between.

    Matplotlib's constrained layout places axes and legends in that part, which is `height` [inch] high.
    """
    text = "\n".join(fill(line, columns) for line in notes.splitlines())
    top = HEADING if below else _TITLE + 0.05
    foot = 0.2 + 0.145 * text.count("\n") if text else 0.0
    tall = top + height + foot
    figure = new_figure(width, tall)
    figure.set_layout_engine("constrained", w_pad=0.06, h_pad=0.04)
    ratios = [top, height, *([foot] if foot else [])]
    parts: Any = figure.subfigures(len(ratios), 1, height_ratios=ratios)
    body: SubFigure = parts[1]
    for words, down, look in (
        (printable(title), 0.12, {"fontsize": 10.5, "fontweight": "bold"}),
        (printable(below, 118), 0.33, {"fontsize": 8.5, "color": GREY}),
        (text, tall - foot + 0.03, {"fontsize": 7.5, "linespacing": 1.3}),
    ):
        if not words:
            continue
        # In inches from the top: a figure may yet be made as high as its panels need.
        place = figure.transFigure + ScaledTranslation(0.2, -down, figure.dpi_scale_trans)
        figure.text(0.0, 1.0, words, va="top", parse_math=False, transform=place, **look)
    return figure, body


def headed(
    scene: Scene, what: str, summary: Summary, *, height: float, notes: str = "", columns: int = 118
) -> tuple[Figure, SubFigure]:
    """A :func:`sheet` with the scene's title, what is shown and how the run ended; stamped if it is refused."""
    ending = [str(summary[key]) for key in ("regime", "outcome") if summary.get(key)]
    below = " · ".join([what, *ending])
    figure, body = sheet(scene.title or "Filament", below, height=height, notes=notes, columns=columns)
    stamp(figure, summary)
    return figure, body


def legend(part: Figure | SubFigure, where: str = "lower left", **settings: Any) -> Legend:
    """A legend outside the axes of a part of a figure."""
    close = {"borderaxespad": 1.0, "columnspacing": 1.1, "handletextpad": 0.5, "fontsize": 7.5, **settings}
    place: Any = f"outside {where}"
    drawn: Legend = part.legend(loc=place, **close)
    return drawn


def secondary_scale(factor: float) -> tuple[Callable[[ArrayLike], ArrayLike], Callable[[ArrayLike], ArrayLike]]:
    """Multiplication by a factor and its inverse, as a secondary axis wants them."""
    return lambda values: np.asarray(values) * factor, lambda values: np.asarray(values) / factor


def plain_log(axis: Axis, text: Callable[[float], str] = "{:g}".format, subs: Sequence[float] | None = None) -> None:
    """Write the ticks of a logarithmic axis as plain numbers; Matplotlib's formulas need fonts that not all have."""
    if subs is not None:
        axis.set_major_locator(LogLocator(subs=subs, numticks=12))
    axis.set_major_formatter(FuncFormatter(lambda value, _: text(value)))
    axis.set_minor_formatter(NullFormatter())


def png(figure: Figure, *, titled: bool = True) -> bytes:
    """Draw a figure."""
    content = BytesIO()
    width, height = figure.get_size_inches()
    # Some settings are read only now: ticks are made, and fonts found, while drawing.
    with styled():
        shown = None if titled else Bbox.from_extents(0.0, 0.0, width, height - _TITLE)
        figure.savefig(content, format="png", bbox_inches=shown)
    return content.getvalue()


def printed(name: str, figure: Figure, dpi: int) -> dict[str, bytes]:
    """Draw a figure as PDF and PNG under the style in force; the same figure gives the same bytes."""
    drawn = {}
    for ending, metadata in (("pdf", {"CreationDate": None}), ("png", None)):
        content = BytesIO()
        figure.savefig(content, format=ending, dpi=dpi, metadata=metadata)
        drawn[f"{name}.{ending}"] = content.getvalue()
    return drawn


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
