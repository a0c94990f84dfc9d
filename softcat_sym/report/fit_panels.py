"""What the pictures of a fit share: headings, axes of parameters, units in which their numbers read well."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.report import style
from softcat_sym.report.canvas import new_figure
from softcat_sym.report.fit_words import display_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from softcat_sym.inverse.fitted import Fit
    from softcat_sym.inverse.forward.free import FreeParameter
    from softcat_sym.report.units import Unit

LOGARITHMIC_FROM = 4.0
"""Ratio of an axis' ends from which on it is logarithmic."""


def headed(fit: Fit, what: str, height: float, left: float) -> Figure:
    """Make a figure of the full width with the scene's title, and what is shown below it.

    Parameters
    ----------
    fit : Fit
        Its scene's title is written.
    what : str
        What the picture shows.
    height, left : float
        Of the figure, and where its text begins [inch].
    """
    figure = new_figure(style.WIDTH, height)
    place = left / style.WIDTH
    title = style.printable(fit.scene.title) or "Filament"
    figure.text(place, 1 - 0.12 / height, title, va="top", fontsize=10.5, fontweight="bold", parse_math=False)
    below = style.printable(what, 118)
    figure.text(place, 1 - 0.33 / height, below, va="top", fontsize=8.5, color=style.GREY, parse_math=False)
    return figure


def label_of(one: FreeParameter, unit: Unit) -> str:
    """Name and unit, as an axis says them."""
    return one.name if one.unit == "1" else f"{one.name} [{unit.symbol}]"


def plain(value: float, place: object = None) -> str:
    """Write a tick's number with at most six digits, a true minus sign and a short exponent."""
    del place
    text = re.sub(r"e([+-])0*", lambda match: "e" + match[1].strip("+"), f"{value:.6g}")
    return text.replace("-", "\N{MINUS SIGN}")


def parameter_axis(axes: Axes, one: FreeParameter, values: NDArray[np.float64], best: float) -> Unit:
    """Set up the horizontal axis for values of a parameter: unit, limits, few ticks with plain numbers.

    Parameters
    ----------
    axes : matplotlib.axes.Axes
        Whose axis it is.
    one : FreeParameter
        What is drawn along it.
    values : ndarray
        That are to be seen [SI].
    best : float
        The fitted one, for which the unit is chosen [SI].

    Returns
    -------
    Unit
        In which values are to be drawn.
    """
    from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator

    values = values[np.isfinite(values)]
    far = float(np.abs(values).max())
    low, high = float(values.min()), float(values.max())
    logarithmic = one.logarithmic and high > LOGARITHMIC_FROM * low
    unit = display_unit(one.unit, best if logarithmic else far)
    low, high = low / unit.size, high / unit.size
    axis = axes.xaxis
    if logarithmic:
        axes.set_xscale("log")
        room = (high / low) ** 0.05
        axes.set_xlim(low / room, high * room)
        decades = np.log10(high / low)
        subs = (1.0, 2.0, 5.0) if decades < 1.5 else (1.0, 3.0) if decades < 2.5 else (1.0,)
        axis.set_major_locator(LogLocator(subs=subs, numticks=5))
        axis.set_minor_locator(NullLocator())
        axis.set_minor_formatter(NullFormatter())
    else:
        room = 0.05 * (high - low) or 0.05 * abs(high) or 1.0
        axes.set_xlim(low - room, high + room)
        axis.set_major_locator(MaxNLocator(3))
    axis.set_major_formatter(FuncFormatter(plain))
    axes.set_xlabel(label_of(one, unit), fontsize=8)
    return unit
