"""One restrained publication style: Okabe-Ito colours, light spines, a font that every machine has."""

from __future__ import annotations

from contextlib import AbstractContextManager
from functools import cache
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from matplotlib.axes import Axes

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
    """Take away the spines that carry no axis.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        The axes.
    twin : bool
        Whether right and top carry secondary axes of their own, which draw those lines.
    """
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
