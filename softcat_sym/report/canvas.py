"""Figures without pyplot: made on the Agg canvas, laid out in inches, read back as PNG bytes."""

from __future__ import annotations

from io import BytesIO

from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from softcat_sym.report.contract import PicturedScene, Summary
from softcat_sym.report.refusal import stamp
from softcat_sym.report.style import GREY, printable, styled

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
    """Add axes at a place given in inches, so that a layout needs no solver and an aspect is exact.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure.
    left, bottom, width, height : float
        Lower left corner and size [inch].

    Returns
    -------
    matplotlib.axes.Axes
        The new axes.
    """
    full_width, full_height = figure.get_size_inches()
    return figure.add_axes((left / full_width, bottom / full_height, width / full_width, height / full_height))


def head(figure: Figure, what: str, summary: Summary, scene: PicturedScene, left: float) -> None:
    """Write the scene's title, what is shown and how the run ended along the top; stamp what is refused.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure.
    what : str
        What the picture shows.
    summary : mapping
        ``regime`` and ``outcome`` are read, where present.
    scene : PicturedScene
        ``title`` is read.
    left : float
        Left edge of the text [inch].
    """
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
    """Draw a figure.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure.
    titled : bool
        False leaves out the first line of its :func:`head`, for a page that has the same title above it.

    Returns
    -------
    bytes
        The PNG file's content.
    """
    content = BytesIO()
    # Some settings are read only now: ticks are made, and fonts found, while drawing.
    width, height = figure.get_size_inches()
    shown = None if titled else Bbox.from_extents(0.0, 0.0, width, height - _TITLE)
    with styled():
        figure.savefig(content, format="png", bbox_inches=shown)
    return content.getvalue()
