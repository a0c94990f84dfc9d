"""One restrained publication style: colours, fonts, sheets with their headings, names beside points, stamps."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
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
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator
from matplotlib.transforms import Bbox, ScaledTranslation
from numpy.typing import NDArray

from softcat_sym.errors import SoftcatError
from softcat_sym.plotting.units import Summary, time_unit
from softcat_sym.results.fields import DENSE
from softcat_sym.solvers.outcome import refused

if TYPE_CHECKING:
    from matplotlib.text import Text

    from softcat_sym.scene.scene import Scene

Fields: TypeAlias = Mapping[Any, Any]
"""What a run is drawn from: its fields, or its Dataset; arrays by the names of ``trajectory.nc``."""

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


def drawn_radius(asked: float) -> float:
    """Read by how much the thickness is to be drawn swollen."""
    if not 0 < asked < float("inf"):
        raise SoftcatError(f"radius: {asked:g}; accepted: a positive factor of the thickness drawn, such as 5")
    return asked


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
    # Only the spines that carry an axis; a picture that fills its axes is framed.
    "axes.spines.top": False,
    "axes.spines.right": False,
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


def stamp(figure: Figure, summary: Summary) -> list[Text]:
    """Write across a picture that its result is refused, and what of it is not drawn."""
    outcome = refused(summary)
    if not outcome:
        return []
    width, height = figure.get_size_inches()
    texts = []
    for line, largest, below in ((STAMP + outcome, 30.0, 0.0), (str(summary.get("not_drawn") or ""), 11.0, 0.45)):
        # Letters of a bold font are three quarters as wide as it is high.
        size = min(largest, 72 * 0.8 * width / (0.75 * max(1, len(line))))
        texts.append(
            figure.text(
                0.5, 0.5 - below / height, line, ha="center", va="center", fontsize=size, fontweight="bold",
                color=VERMILLION, alpha=0.75, zorder=100, parse_math=False, in_layout=False,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.6, "pad": 1.5},
            )
        )  # fmt: skip
    return texts if summary.get("not_drawn") else texts[:1]


def shown_part(data: Fields, summary: Summary) -> tuple[Fields, Summary]:
    """A run as it is drawn: one that is refused ends where it hangs deeper than it is long.

    A neck that runs away would otherwise scale the axes, as if its depth were an answer.
    """
    if not refused(summary):
        return data, summary
    x, y, time = (np.asarray(data[name], dtype=np.float64) for name in ("x", "y", "time"))
    line = y[:, :1] + (y[:, -1:] - y[:, :1]) * np.linspace(0.0, 1.0, y.shape[1])
    reach = np.maximum(np.ptp(np.asarray(data["X_node"])), np.hypot(x[:, -1] - x[:, 0], y[:, -1] - y[:, 0]))
    # Written so that what is not a number is beyond it too.
    beyond = ~(np.abs(y - line).max(axis=1) <= reach)
    if not beyond.any():
        return data, summary
    end = max(1, int(beyond.argmax()))
    words = f"not drawn after {time_unit(float(time[-1])).text(float(time[end - 1]))}: deeper than it is long"
    return first_frames(data, end), {**summary, "not_drawn": words}


def first_frames(data: Fields, end: int) -> dict[str, NDArray[Any]]:
    """The beginning of a run, at its frames."""
    whole = ("X_node", "X_cell")
    names = [name for name in data if not str(name).startswith(DENSE)]
    return {name: np.asarray(data[name])[: None if name in whole else end] for name in (*names, "time", *whole)}


HEADING = 0.62
"""Height that a heading takes at the top of a picture [inch]."""

_TITLE = 0.31
"""Height of its first line, the title."""


class Picture(Figure):
    """A figure that a notebook shows, pyplot or not: pyplot, where there is one, knows nothing of it."""

    def _repr_png_(self) -> bytes:
        return png(self)


def new_figure(width: float, height: float) -> Figure:
    """Make an empty figure of the given size [inch] with a canvas of its own."""
    figure = Picture(figsize=(width, height))
    FigureCanvasAgg(figure)
    return figure


def axes_in_inches(figure: Figure, left: float, bottom: float, width: float, height: float) -> Axes:
    """Add axes at a place given in inches, so that a layout needs no solver and an aspect is exact."""
    full_width, full_height = figure.get_size_inches()
    return figure.add_axes((left / full_width, bottom / full_height, width / full_width, height / full_height))


def sheet(
    title: str,
    below: str = "",
    *,
    height: float,
    notes: str = "",
    width: float = WIDTH,
    columns: int = 118,
    is_constrained: bool = True,
) -> tuple[Figure, SubFigure]:
    """A figure with a title and what is shown along its top and notes along its bottom, and the part in between.

    Matplotlib's constrained layout places axes and legends in that part, which is `height` [inch] high.
    """
    text = "\n".join(fill(line, columns) for line in notes.splitlines())
    top = HEADING if below else _TITLE + 0.05 if title else 0.05
    foot = 0.2 + 0.145 * text.count("\n") if text else 0.0
    tall = top + height + foot
    figure = new_figure(width, tall)
    if is_constrained:
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


def headed(scene: Scene, what: str, summary: Summary, **layout: Any) -> tuple[Figure, SubFigure]:
    """A :func:`sheet` with the scene's title, what is shown and how the run ended; stamped if it is refused.

    Without `what` there is no heading, as in print.
    """
    ending = [str(summary[key]) for key in ("regime", "outcome") if summary.get(key)]
    title, below = (scene.title or "Filament", " · ".join([what, *ending])) if what else ("", "")
    figure, body = sheet(title, below, **layout)
    stamp(figure, summary)
    return figure, body


def legend(part: Figure | SubFigure, where: str = "lower left", **settings: Any) -> Legend:
    """A legend outside the axes of a part of a figure."""
    close = {"borderaxespad": 1.0, "columnspacing": 1.1, "handletextpad": 0.5, "fontsize": 7.5, **settings}
    place: Any = f"outside {where}"
    drawn: Legend = part.legend(loc=place, **close)
    return drawn


def plain(value: float, place: object = None) -> str:
    """Write a tick's number with at most six digits, a true minus sign and a short exponent."""
    del place
    text = re.sub(r"e([+-])0*", lambda match: "e" + match[1].strip("+"), f"{value:.6g}")
    return text.replace("-", "\N{MINUS SIGN}")


class LogTicks(LogLocator):
    """Ticks of a logarithmic axis: at 1, 2, 5 or 1, 3 where powers of ten would be few, evenly within a decade."""

    def __init__(self, ticks: int) -> None:
        super().__init__(numticks=ticks + 1)
        self._ticks = ticks

    def tick_values(self, vmin: float, vmax: float) -> Any:
        """Places of the ticks between two values."""
        low, high = sorted((vmin, vmax))
        decades = math.log10(high / low) if low > 0 else 1.0
        if decades < 0.7:
            return MaxNLocator(self._ticks).tick_values(low, high)
        self.set_params(subs=(1.0, 2.0, 5.0) if decades < 1.5 else (1.0, 3.0) if decades < 2.5 else (1.0,))
        return super().tick_values(low, high)


def plain_log(axis: Axis, text: Callable[[float], str] = plain, ticks: int = 8) -> None:
    """Write the ticks of a logarithmic axis as plain numbers; Matplotlib's formulas need fonts that not all have."""
    axis.set_major_locator(LogTicks(ticks))
    axis.set_major_formatter(FuncFormatter(lambda value, _: text(value)))
    axis.set_minor_formatter(NullFormatter())


def number_axis(
    axes: Axes, which: str, low: float, high: float, *, is_log: bool, ticks: int = 4, room: float = 0.05
) -> None:
    """Limits of the x or y axis with a little room, and a few ticks of plain numbers."""
    axis = axes.xaxis if which == "x" else axes.yaxis
    if is_log:
        factor = max((high / low) ** room, 10 ** (0.4 * room))
        limits = low / factor, high * factor
    else:
        margin = room * ((high - low) or abs(high) or 1 / room) if room else 0.0
        limits = low - margin, high + margin
    axes.set(**{f"{which}scale": "log" if is_log else "linear", f"{which}lim": limits})
    axis.set_major_locator(LogTicks(ticks) if is_log else MaxNLocator(ticks))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(plain))


def pixel_edges(values: NDArray[np.float64], *, is_log: bool) -> NDArray[np.float64]:
    """Edges of the pixels around values, half a step beyond the first and the last."""
    at = np.log(values) if is_log else values
    middles = (at[1:] + at[:-1]) / 2
    edges = np.concatenate([[2 * at[0] - middles[0]], middles, [2 * at[-1] - middles[-1]]])
    return np.asarray(np.exp(edges) if is_log else edges)


_PACKING: Final = {"compress_level": 2}
"""Of PNG files: a little larger than by default, in a third of the time."""


def png(figure: Figure, *, titled: bool = True) -> bytes:
    """Draw a figure; it is laid out once, as it is."""
    content = BytesIO()
    width, height = figure.get_size_inches()
    # Some settings are read only now: ticks are made, and fonts found, while drawing.
    with styled():
        engine = figure.get_layout_engine()
        if engine is not None:
            engine.execute(figure)
            figure.set_layout_engine("none")
        shown = None if titled else Bbox.from_extents(0.0, 0.0, width, height - _TITLE)
        figure.savefig(content, format="png", bbox_inches=shown, pil_kwargs=_PACKING)
    return content.getvalue()


def printed(name: str, figure: Figure, dpi: int) -> dict[str, bytes]:
    """Draw a figure as PDF and PNG under the style in force; the same figure gives the same bytes."""
    drawn = {}
    for ending, metadata in (("pdf", {"CreationDate": None}), ("png", None)):
        content = BytesIO()
        figure.savefig(content, format=ending, dpi=dpi, metadata=metadata)
        drawn[f"{name}.{ending}"] = content.getvalue()
    return drawn
