"""One restrained publication style: colours, fonts, sheets with their headings, numbers along axes, stamps."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from io import BytesIO
from textwrap import fill
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure, SubFigure
from matplotlib.font_manager import findfont, get_font
from matplotlib.legend import Legend
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator
from matplotlib.transforms import ScaledTranslation
from numpy.typing import NDArray

from softcat_sym.errors import SoftcatError
from softcat_sym.plotting.units import Summary, time_unit
from softcat_sym.results.fields import DENSE
from softcat_sym.solvers.outcome import refused

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene

Fields: TypeAlias = Mapping[Any, Any]
"""What a run is drawn from: its fields, or its Dataset; arrays by the names of ``trajectory.nc``."""

WIDTH: Final = 7.2
"""Of a figure [inch]."""


def drawn_radius(asked: float) -> float:
    """Read by how much the thickness is to be drawn swollen."""
    if not 0 < asked < float("inf"):
        raise SoftcatError(f"radius: {asked:g}; accepted: a positive factor of the thickness drawn, such as 5")
    return asked


BLACK, GREY, FILAMENT = "#222222", "#8a8a8a", "#e3eaf0"
BLUE, SKY, GREEN, ORANGE = "#0072B2", "#56B4E9", "#009E73", "#E69F00"
VERMILLION, PURPLE = "#D55E00", "#CC79A7"

_LOOKS = (
    "axes. figure. font. grid. hatch. image. legend. lines. mathtext. patch. pdf. savefig. scatter. text. xtick. ytick."
)
_RC: Final[dict[str, Any]] = {
    # A user's own matplotlibrc neither restyles a report nor calls LaTeX.
    **{name: value for name, value in matplotlib.rcParamsDefault.items() if name.partition(".")[0] in _LOOKS.split()},
    "font.size": 9.0,
    "axes.titlesize": 10.0,
    "axes.labelsize": 9.0,
    "axes.edgecolor": GREY,
    "axes.linewidth": 0.6,
    "axes.axisbelow": True,
    # Units are chosen to fit: neither a power of ten nor an offset stands beside an axis.
    "axes.formatter.limits": (-5, 6),
    "axes.formatter.useoffset": False,
    "axes.xmargin": 0.0,
    # Only the spines that carry an axis; a picture that fills its axes is framed.
    **dict.fromkeys(("axes.spines.top", "axes.spines.right"), False),
    **dict.fromkeys(("xtick.labelsize", "ytick.labelsize", "legend.fontsize"), 8.0),
    **dict.fromkeys(("xtick.color", "ytick.color"), GREY),
    **dict.fromkeys(("text.color", "axes.labelcolor", "xtick.labelcolor", "ytick.labelcolor"), BLACK),
    **dict.fromkeys(("xtick.major.width", "ytick.major.width", "grid.linewidth"), 0.6),
    "grid.color": "#e8e8e8",
    "legend.frameon": False,
    "lines.linewidth": 1.4,
    **dict.fromkeys(("figure.dpi", "savefig.dpi"), 150),
    # TrueType, as journals ask: text in a PDF stays text.
    "pdf.fonttype": 42,
}


@contextmanager
def styled() -> Iterator[None]:
    """Put the style in force for the length of a ``with`` block or of a function; what was set before comes back."""
    # Matplotlib's versions disagree on the type of the keys, not on the keys.
    settings: Any = _RC
    with matplotlib.rc_context(settings):
        yield


def printable(text: str, longest: int = 78) -> str:
    """Make a user's text safe to draw: one line, not too long, only glyphs that the font has.

    A missing glyph would raise a warning and draw a box; it is replaced by a question mark.
    """
    line = " ".join(text.split())
    line = line if len(line) <= longest else line[: longest - 1].rstrip() + "…"
    return line if line.isascii() else "".join(one if ord(one) in _glyphs() else "?" for one in line)


@cache
def _glyphs() -> frozenset[int]:
    """Code points of the report's font."""
    return frozenset(get_font(findfont("DejaVu Sans")).get_charmap())


def stamp(figure: Figure, summary: Summary) -> list[Any]:
    """Write across a picture that its result is refused, and what of it is not drawn."""
    outcome = refused(summary)
    lines = (f"REFUSED: {outcome}", str(summary.get("not_drawn") or "")) if outcome else ()
    width, height = figure.get_size_inches()
    look: dict[str, Any] = {"fontweight": "bold", "color": VERMILLION, "alpha": 0.75, "zorder": 100}
    box = {"facecolor": "white", "edgecolor": "none", "alpha": 0.6, "pad": 1.5}
    return [
        # Letters of a bold font are three quarters as wide as it is high.
        figure.text(0.5, 0.5 - 0.45 * k / height, line, fontsize=min(largest, 72 * 0.8 * width / (0.75 * len(line))),
                    ha="center", va="center", parse_math=False, in_layout=False, bbox=box, **look)
        for k, (line, largest) in enumerate(zip(lines, (30.0, 11.0), strict=False)) if line
    ]  # fmt: skip


def shown_part(data: Fields, summary: Summary) -> tuple[Fields, Summary]:
    """A run as it is drawn: one that is refused ends where it hangs deeper than it is long.

    A neck that runs away would otherwise scale the axes, as if its depth were an answer.
    """
    if not refused(summary):
        return data, summary
    x, y, time = (np.asarray(data[name], dtype=np.float64) for name in ("x", "y", "time"))
    line = np.linspace(y[:, 0], y[:, -1], y.shape[1], axis=1)
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


_TITLE = 0.31
"""Height of the first line of a heading, the title [inch]."""


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
    wide, tall = figure.get_size_inches()
    return figure.add_axes((left / wide, bottom / tall, width / wide, height / tall))


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
    top = 2 * _TITLE if below else _TITLE + 0.05 if title else 0.05
    foot = 0.2 + 0.145 * text.count("\n") if text else 0.0
    tall = top + height + foot
    figure = new_figure(width, tall)
    if is_constrained:
        figure.set_layout_engine("constrained", w_pad=0.06, h_pad=0.04)
    ratios = [top, height, *([foot] if foot else [])]
    body: SubFigure = figure.subfigures(len(ratios), 1, squeeze=False, height_ratios=ratios)[1, 0]
    for words, down, look in (
        (printable(title), 0.12, {"fontsize": 10.5, "fontweight": "bold"}),
        (printable(below, 118), 0.33, {"fontsize": 8.5, "color": GREY}),
        (text, tall - foot + 0.03, {"fontsize": 7.5, "linespacing": 1.3}),
    ):
        place = figure.transFigure + ScaledTranslation(0.2, -down, figure.dpi_scale_trans)
        figure.text(0.0, 1.0, words, va="top", parse_math=False, transform=place, **look)
    return figure, body


def titled_figure(scene: Scene, what: str, summary: Summary, **layout: Any) -> tuple[Figure, SubFigure]:
    """A :func:`sheet` with the scene's title, what is shown and how the run ended; stamped if it is refused."""
    figure, body = sheet(scene.title or "Filament", " · ".join([what, *ending_of(summary)]), **layout)
    stamp(figure, summary)
    return figure, body


def ending_of(summary: Summary) -> list[str]:
    """Regime and outcome, as far as they are known."""
    return [str(summary[key]) for key in ("regime", "outcome") if summary.get(key)]


def legend(part: Figure | SubFigure, where: str = "lower left", of: Axes | None = None, **settings: Any) -> Legend:
    """A legend outside the axes of a part of a figure, by default of all its lines, or of those of one of its axes."""
    close = {"borderaxespad": 1.0, "columnspacing": 1.1, "handletextpad": 0.5, "fontsize": 7.5, **settings}
    if of is not None:
        close["handles"] = of.get_legend_handles_labels()[0]
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


def log_axes(axes: Axes, **settings: Any) -> None:
    """Make both axes logarithmic, with plain numbers along them."""
    axes.set(xscale="log", yscale="log", **settings)
    for axis in (axes.xaxis, axes.yaxis):
        plain_log(axis)


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


@styled()
def png(figure: Figure) -> bytes:
    """Draw a figure; it is laid out once, as it is."""
    # Some settings are read only now: ticks are made, and fonts found, while drawing.
    if (engine := figure.get_layout_engine()) is not None:
        engine.execute(figure)
        figure.set_layout_engine("none")
    content = BytesIO()
    # Packed a little larger than by default, in a third of the time.
    figure.savefig(content, format="png", pil_kwargs={"compress_level": 2})
    return content.getvalue()
