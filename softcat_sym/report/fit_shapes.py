"""Whole shapes of a film beside the model's."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.report import style
from softcat_sym.report.units import length_unit, time_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from softcat_sym.inverse.fitted import FittedFilm

_MOST_LABELS = 6


def draw_shapes(above: Axes, under: Axes, film: FittedFilm) -> None:
    """Draw measured points and the model's shape at every time, and the residuals below.

    Parameters
    ----------
    above, under : matplotlib.axes.Axes
        For the shapes, and for the residuals.
    film : FittedFilm
        Points of shapes only.
    """
    from matplotlib import colormaps

    ruler, clock = length_unit(float(np.abs(film.place).max())), time_unit(float(film.time.max()))
    times = np.unique(film.time)
    named = set(times[np.unique(np.linspace(0, times.size - 1, _MOST_LABELS).round().astype(int))].tolist())
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
