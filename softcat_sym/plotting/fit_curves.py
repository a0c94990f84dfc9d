"""Data, model and residuals of every film."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.plotting import style
from softcat_sym.plotting.fit_panels import draw_shapes, headed, plain
from softcat_sym.plotting.fit_words import noise_text
from softcat_sym.plotting.style import HEADING, axes_in_inches, length_unit, time_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from softcat_sym.fitting.fit import Fit, FittedFilm

_LEFT, _RIGHT, _BOTTOM = 0.85, 0.2, 0.55
_TALL, _LOW, _GAP, _BETWEEN = 2.3, 0.85, 0.12, 0.75

_CROWDED = 0.12
"""Where half of the frames lie within this share of the time, the axis is logarithmic."""


def curves_figure(fit: Fit) -> Figure:
    """Draw each film beside its model, with the 95 % band that the parameters' covariance gives it."""
    views = _views(fit)
    films = len(views)
    each = _TALL + _GAP + _LOW
    height = HEADING + 0.25 + films * each + (films - 1) * _BETWEEN + _BOTTOM
    with style.styled():
        below = f"{fit.outcome.word} · residuals {fit.checks.verdict} · noise {noise_text(fit)}"
        figure = headed(fit, below, height, _LEFT)
        width = style.WIDTH - _LEFT - _RIGHT
        for k, (film, band, std) in enumerate(views):
            foot = _BOTTOM + (films - 1 - k) * (each + _BETWEEN)
            above = axes_in_inches(figure, _LEFT, foot + _LOW + _GAP, width, _TALL)
            under = axes_in_inches(figure, _LEFT, foot, width, _LOW)
            if film.of_midpoint.all():
                _draw_film(above, film, band, std)
                _draw_residuals(under, film)
                _time_axes(above, under, film)
            else:
                draw_shapes(above, under, film)
            if films > 1:
                name = style.printable(film.name, 60)
                above.set_title(name, loc="left", fontsize=8.5, pad=3, parse_math=False)
            if k == 0:
                spot = (1.0, 1.0)
                above.legend(loc="lower right", bbox_to_anchor=spot, ncols=3, borderaxespad=0.2, fontsize=7.5)
    return figure


def model_bands(fit: Fit) -> list[NDArray[np.float64]]:
    """Half-width of the model's 95 % interval at each reading [m], one array for each film, to first order."""
    jacobian = fit.starts.best.jacobian
    variance = np.einsum("ij,jk,ik->i", jacobian, fit.information.covariance, jacobian)
    half = fit.information.quantile * np.sqrt(np.maximum(variance, 0.0))
    parts = fit.problem.by_film(half)
    return [part * film.std for part, film in zip(parts, fit.problem.films, strict=True)]


_View = tuple["FittedFilm", "NDArray[np.float64]", "NDArray[np.float64] | None"]


def _views(fit: Fit) -> list[_View]:
    """Midpoints and whole shapes of every film, with their bands and stated standard errors [m]."""
    found: list[_View] = []
    for film, band, posed in zip(fit.films, model_bands(fit), fit.problem.films, strict=True):
        for chosen in (film.of_midpoint, ~film.of_midpoint):
            if chosen.any():
                found.append((film.part(chosen), band[chosen], posed.std[chosen] if fit.noise_known else None))
    return found


def _draw_film(axes: Axes, film: FittedFilm, band: NDArray[np.float64], std: NDArray[np.float64] | None) -> None:
    clock, ruler = time_unit(float(film.time[-1])), length_unit(float(np.abs(film.measured).max()))
    time, data, model = clock.of(film.time), ruler.of(film.measured), ruler.of(film.model)
    half = ruler.of(band)
    axes.grid(True)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6)
    if std is not None:
        axes.errorbar(
            time, data, yerr=ruler.of(std), fmt="none", ecolor=style.BLACK, elinewidth=0.7, alpha=0.45, zorder=1.5
        )
    label = "measured" if std is None else "measured ± std"
    axes.plot(time, data, ".", color=style.BLACK, markersize=4, alpha=0.6, label=label, clip_on=False)
    axes.fill_between(
        time, model - half, model + half, color=style.VERMILLION, alpha=0.25, linewidth=0, label="95 % band"
    )
    axes.plot(time, model, color=style.VERMILLION, linewidth=1.2, label="model")
    low, high = min(float(data.min()), float(model.min())), max(float(data.max()), float(model.max()), 0.0)
    room = 0.06 * (high - low)
    axes.set_ylim(low - room, high + room)
    axes.set_ylabel(f"midpoint height [{ruler.symbol}]")
    axes.tick_params(labelbottom=False)
    style.lighten(axes)


def _draw_residuals(axes: Axes, film: FittedFilm) -> None:
    clock = time_unit(float(film.time[-1]))
    axes.grid(True)
    axes.axhline(0.0, color=style.GREY, linewidth=0.8)
    for edge in (-1.96, 1.96):
        axes.axhline(edge, color=style.GREY, linewidth=0.8, linestyle=(0, (4, 2)))
    axes.plot(clock.of(film.time), film.residuals, ".", color=style.BLUE, markersize=3.5, clip_on=False)
    far = max(2.6, 1.15 * float(np.abs(film.residuals).max()))
    axes.set_ylim(-far, far)
    axes.yaxis.set_major_formatter("{x:.3g}")
    axes.set_xlabel(f"time [{clock.symbol}]")
    axes.set_ylabel("residual / std")
    style.lighten(axes)


def _time_axes(above: Axes, under: Axes, film: FittedFilm) -> None:
    from matplotlib.ticker import FuncFormatter, NullFormatter

    clock = time_unit(float(film.time[-1]))
    later = clock.of(film.time[film.time > 0])
    crowded = later.size > 2 and float(np.median(later)) < _CROWDED * float(later[-1])
    for axes in (above, under):
        if crowded:
            axes.set_xscale("log")
            axes.set_xlim(float(later[0]) / 1.1, float(later[-1]) * 1.1)
            axes.xaxis.set_major_formatter(FuncFormatter(plain))
            axes.xaxis.set_minor_formatter(NullFormatter())
        else:
            start, end = float(clock.of(film.time[0])), float(clock.of(film.time[-1]))
            room = 0.02 * (end - start)
            axes.set_xlim(min(0.0, start) - room if start < 0.2 * end else start - room, end + room)
