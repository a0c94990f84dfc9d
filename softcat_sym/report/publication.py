"""Pictures of a run for print: a journal's column or page wide, vectors, fonts embedded, nothing that is not needed."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

import xarray as xr
from matplotlib.figure import Figure

from softcat_sym.report import style
from softcat_sym.report.canvas import constrained, new_figure
from softcat_sym.report.contract import PicturedScene, Summary
from softcat_sym.report.refusal import shown_part, stamp
from softcat_sym.report.units import Unit, length_unit, time_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MILLIMETRE: Final = 1 / 25.4
"""[inch]."""

WIDTHS: Final = {"column": 84.0, "page": 174.0}
"""Widths of a figure [mm]: one column, or the whole page."""

DPI: Final = 400
"""Of the PNG files, and of what is drawn as pixels within a PDF."""

LINES: Final = (
    (style.BLACK, "-"),
    (style.BLUE, "-"),
    (style.VERMILLION, "--"),
    (style.SKY, "-."),
    (style.ORANGE, ":"),
    (style.GREEN, (0, (6, 1.5, 1, 1.5, 1, 1.5))),
)
"""Colours that the colour-blind tell apart, each with a line style of its own for print in black and white."""

_RC: Final[dict[str, Any]] = {
    "font.size": 8.0,
    "axes.labelsize": 8.0,
    "axes.titlesize": 8.0,
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "legend.fontsize": 8.0,
    "lines.linewidth": 0.9,
    "axes.linewidth": 0.5,
    "xtick.major.width": 0.5,
    "ytick.major.width": 0.5,
    "xtick.major.size": 2.5,
    "ytick.major.size": 2.5,
    "axes.labelpad": 2.5,
    "hatch.linewidth": 0.5,
}


@dataclass(frozen=True, slots=True)
class Sheet:
    """What every figure of one run shares.

    Attributes
    ----------
    width : float
        Of the figure [inch].
    data : xarray.Dataset
        Trajectory.
    summary : mapping
        The run's summary.
    scene : PicturedScene
        The scene.
    """

    width: float
    data: xr.Dataset
    summary: Summary
    scene: PicturedScene

    @property
    def clock(self) -> Unit:
        """The unit of time."""
        return time_unit(float(abs(self.data["time"].values).max()))

    @property
    def ruler(self) -> Unit:
        """The unit of length of the midpoint."""
        return length_unit(float(abs(self.data["midpoint"].values).max()), self.scene.filament.span)

    def figure(self, height: float) -> Figure:
        """A figure of this height [inch], laid out by what its axes need, stamped if the result is refused."""
        figure = new_figure(self.width, height)
        constrained(figure, heading=0.0)
        stamp(figure, self.summary)
        return figure

    def framed(self, height: float) -> tuple[Figure, Axes]:
        """A figure of this height [inch] with one pair of axes."""
        figure = self.figure(height)
        axes = figure.add_subplot()
        style.lighten(axes)
        return figure, axes


@contextmanager
def publication_style() -> Iterator[None]:
    """Put the style of print in force for the length of a ``with`` block; what was set before comes back."""
    from matplotlib import rc_context

    settings: Any = _RC
    with style.styled(), rc_context(settings):
        yield


def publication_figures(data: xr.Dataset, summary: Summary, scene: PicturedScene, width: str) -> dict[str, bytes]:
    """Draw a run for print: ``midpoint``, ``shapes``, ``energy`` and ``space-time``, each as PDF and PNG.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory, as :func:`softcat_sym.report.write_pictures` takes it.
    summary : mapping
        The run's summary.
    scene : PicturedScene
        The scene.
    width : str
        ``column`` (84 mm) or ``page`` (174 mm).

    Returns
    -------
    dict of str to bytes
        By file name. The same run gives the same bytes.

    Raises
    ------
    KeyError
        If the width is neither.
    """
    from softcat_sym.report import publication_panels as panels

    sheet = Sheet(WIDTHS[width] * MILLIMETRE, *shown_part(data, summary), scene)
    files: dict[str, bytes] = {}
    with publication_style():
        for name, drawn in (
            ("midpoint", panels.midpoint(sheet)),
            ("shapes", panels.shapes(sheet)),
            ("energy", panels.energy(sheet)),
            ("space-time", panels.space_time(sheet)),
        ):
            files |= printed(name, drawn)
    return files


def printed(name: str, figure: Figure) -> dict[str, bytes]:
    """A figure as PDF and PNG, while the style is in force: fonts and ticks are found only while drawing."""
    from io import BytesIO

    files = {}
    for ending, metadata in (("pdf", {"CreationDate": None}), ("png", None)):
        content = BytesIO()
        figure.savefig(content, format=ending, dpi=DPI, metadata=metadata)
        files[f"{name}.{ending}"] = content.getvalue()
    return files
