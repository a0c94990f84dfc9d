"""What the pictures of a fit share, and whole shapes of a film beside the model's."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.plotting import style
from softcat_sym.plotting.fit_words import display_unit
from softcat_sym.plotting.style import length_unit, new_figure, time_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from softcat_sym.fitting.fit import Fit, FittedFilm
    from softcat_sym.fitting.free_parameters import FreeParameter
    from softcat_sym.plotting.style import Unit

LOGARITHMIC_FROM = 4.0
"""Ratio of an axis' ends from which on it is logarithmic."""


def headed(fit: Fit, what: str, height: float, left: float) -> Figure:
    """Make a figure of the full width with the scene's title, and what is shown below it."""
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
    """Set up the horizontal axis for values of a parameter: unit, limits, few ticks with plain numbers."""
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


_MAX_LABELS = 6


def draw_shapes(above: Axes, under: Axes, film: FittedFilm) -> None:
    """Draw measured points and the model's shape at every time, and the residuals below."""
    from matplotlib import colormaps

    ruler, clock = length_unit(float(np.abs(film.place).max())), time_unit(float(film.time.max()))
    times = np.unique(film.time)
    named = set(times[np.unique(np.linspace(0, times.size - 1, _MAX_LABELS).round().astype(int))].tolist())
    for number, time in enumerate(times.tolist()):
        color = colormaps["viridis"](0.9 * number / max(times.size - 1, 1))
        here = np.flatnonzero(film.time == time)
        here = here[np.argsort(film.place[here])]
        place = ruler.of(film.place[here])
        above.plot(place, ruler.of(film.measured[here]), ".", color=color, markersize=4, alpha=0.7)
        label = f"{float(clock.of(time)):.3g} {clock.symbol}" if time in named else None
        above.plot(place, ruler.of(film.model[here]), color=color, linewidth=1.1, label=label)
        under.plot(place, film.residuals[here], ".", color=color, markersize=3.5, clip_on=False)
    for axes in (above, under):
        axes.grid(True)
        style.lighten(axes)
    above.set_ylabel(f"height [{ruler.symbol}]")
    above.tick_params(labelbottom=False)
    under.set_xlabel(f"x from halfway between the supports [{ruler.symbol}]")
    under.set_ylabel("residual / std")
    far = max(2.6, 1.15 * float(np.abs(film.residuals).max()))
    under.set_ylim(-far, far)
    for edge in (-1.96, 0.0, 1.96):
        under.axhline(edge, color=style.GREY, linewidth=0.8, linestyle=(0, (4, 2)) if edge else "-")
