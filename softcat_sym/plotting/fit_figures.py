"""Pictures of a fit: data and model, profiles, correlations, starts, features, laws."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator, StrMethodFormatter

from softcat_sym.fitting.features import Features, Floats, Reading
from softcat_sym.plotting import style
from softcat_sym.plotting.fit import display_unit, noise_text, residual_std, starts_text
from softcat_sym.plotting.style import HEADING, axes_in_inches, new_figure
from softcat_sym.plotting.units import length_unit, significant, time_unit

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from softcat_sym.fitting.fit import Fit, FittedFilm
    from softcat_sym.fitting.free_parameters import FreeParameter
    from softcat_sym.fitting.inference import Profile
    from softcat_sym.fitting.model_selection import LawComparison, Ranked
    from softcat_sym.plotting.units import Unit

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


_CURVES_LEFT, _CURVES_RIGHT, _CURVES_BOTTOM = 0.85, 0.2, 0.55
_CURVES_TALL, _LOW, _CURVES_GAP, _CURVES_BETWEEN = 2.3, 0.85, 0.12, 0.75

_CURVES_CROWDED = 0.12
"""Where half of the frames lie within this share of the time, the axis is logarithmic."""


def curves_figure(fit: Fit) -> Figure:
    """Draw each film beside its model, with the 95 % band that the parameters' covariance gives it."""
    views = _views(fit)
    films = len(views)
    each = _CURVES_TALL + _CURVES_GAP + _LOW
    height = HEADING + 0.25 + films * each + (films - 1) * _CURVES_BETWEEN + _CURVES_BOTTOM
    with style.styled():
        below = f"{fit.outcome.word} · residuals {fit.checks.verdict} · noise {noise_text(fit)}"
        figure = headed(fit, below, height, _CURVES_LEFT)
        width = style.WIDTH - _CURVES_LEFT - _CURVES_RIGHT
        for k, (film, band, std) in enumerate(views):
            foot = _CURVES_BOTTOM + (films - 1 - k) * (each + _CURVES_BETWEEN)
            above = axes_in_inches(figure, _CURVES_LEFT, foot + _LOW + _CURVES_GAP, width, _CURVES_TALL)
            under = axes_in_inches(figure, _CURVES_LEFT, foot, width, _LOW)
            if film.of_midpoint.all():
                _curves_draw_film(above, film, band, std)
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


def _curves_draw_film(axes: Axes, film: FittedFilm, band: NDArray[np.float64], std: NDArray[np.float64] | None) -> None:
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
    clock = time_unit(float(film.time[-1]))
    later = clock.of(film.time[film.time > 0])
    crowded = later.size > 2 and float(np.median(later)) < _CURVES_CROWDED * float(later[-1])
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


_PROFILES_LEFT, _PROFILES_RIGHT, _PROFILES_BOTTOM = 0.65, 0.2, 0.55
_PROFILES_TALL, _PROFILES_ACROSS, _PROFILES_BETWEEN, _ABOVE = 1.8, 0.35, 0.85, 0.3
_PROFILES_MOST = 3
"""Panels in a row."""

_DENSE = 400
# Thresholds that the axis is high: what happens far above it is nobody's concern.
_HIGH = 2.2


def profiles_figure(fit: Fit) -> Figure:
    """Draw one panel for each parameter."""
    count = len(fit.profiles)
    across = min(count, _PROFILES_MOST)
    rows = math.ceil(count / across)
    height = HEADING + _ABOVE + rows * _PROFILES_TALL + (rows - 1) * _PROFILES_BETWEEN + _PROFILES_BOTTOM + 0.22
    wide = (style.WIDTH - _PROFILES_LEFT - _PROFILES_RIGHT - (across - 1) * _PROFILES_ACROSS) / across
    with style.styled():
        what = "profile likelihood: how much worse the fit becomes with one parameter held, the others fitted anew"
        figure = headed(fit, what, height, _PROFILES_LEFT)
        for k, (one, free) in enumerate(zip(fit.profiles, fit.problem.free, strict=True)):
            row, column = divmod(k, across)
            foot = _PROFILES_BOTTOM + 0.22 + (rows - 1 - row) * (_PROFILES_TALL + _PROFILES_BETWEEN)
            axes = axes_in_inches(
                figure, _PROFILES_LEFT + column * (wide + _PROFILES_ACROSS), foot, wide, _PROFILES_TALL
            )
            _profiles_draw(axes, one, free, float(fit.information.standard_errors[k]))
            axes.set_title(fit.parameters[free.name].verdict, loc="left", fontsize=8.5, pad=4)
            if column == 0:
                axes.set_ylabel("increase of χ²")
        handles = figure.axes[0].get_legend_handles_labels()
        figure.legend(
            *handles, loc="lower left", bbox_to_anchor=(_PROFILES_LEFT / style.WIDTH, 0.0), ncols=5, fontsize=7.5
        )
    return figure


def _profiles_draw(axes: Axes, one: Profile, free: FreeParameter, error: float) -> None:
    values = np.array([free.value(q) for q in one.q.tolist()])
    unit = parameter_axis(axes, free, values, free.value(one.optimum))
    dense, curve = smooth(one)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6)
    axes.axhline(one.threshold, label="95 % threshold", color=style.GREEN, linewidth=1.0, linestyle=(0, (6, 2)))
    for side in (one.lower, one.upper):
        if side.crossing is not None:
            at = float(unit.of(free.value(side.crossing)))
            axes.plot([at, at], [0, one.threshold], color=style.GREEN, linewidth=0.9, linestyle=":")
    parabola = ((dense - one.optimum) / error) ** 2 if error > 0 else np.zeros_like(dense)
    shown = np.array([float(unit.of(free.value(q))) for q in dense.tolist()])
    axes.plot(shown, parabola, color=style.GREY, linewidth=1.1, linestyle="--", label="curvature only")
    axes.plot(shown, curve, color=style.BLUE, linewidth=1.4, label="profile")
    axes.plot(unit.of(values), one.increase, "o", color=style.BLUE, markersize=2.8)
    axes.plot(
        [unit.of(free.value(one.optimum))], [0], "o", color=style.VERMILLION, markersize=5, label="best fit", zorder=4
    )
    low = min(0.0, float(one.increase.min()))
    axes.set_ylim(low - 0.1 * one.threshold, _HIGH * one.threshold)
    style.lighten(axes)


def smooth(one: Profile) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A profile between its points: their roots, nearly straight in q on either side, joined by lines, and squared."""
    root = np.sqrt(np.maximum(one.increase, 0.0))
    dense = np.union1d(np.linspace(one.q[0], one.q[-1], _DENSE), one.q)
    inside = np.interp(dense, one.q, root)
    return dense, inside**2


_CORRELATION_LEFT, _CORRELATION_RIGHT, _CORRELATION_BOTTOM, _CORRELATION_GAP = 0.3, 0.3, 0.45, 0.08
_LARGEST, _TALLEST = 1.7, 6.0

JOINT = 5.991
"""95 % quantile of chi^2 with two degrees of freedom."""

_CORRELATION_FAR = 3.6


def correlation_figure(fit: Fit) -> Figure:
    """Draw the matrix of all pairs: below its diagonal regions in standard errors, above it correlations."""
    count = len(fit.problem.free)
    room = style.WIDTH - _CORRELATION_LEFT - _CORRELATION_RIGHT
    each = min(_LARGEST, (room - (count - 1) * _CORRELATION_GAP) / count)
    height = HEADING + count * each + (count - 1) * _CORRELATION_GAP + _CORRELATION_BOTTOM
    with style.styled():
        figure = headed(
            fit, "joint 95 % regions in standard errors, and correlations of the estimates", height, _CORRELATION_LEFT
        )
        for row in range(count):
            for column in range(count):
                left = _CORRELATION_LEFT + column * (each + _CORRELATION_GAP)
                foot = _CORRELATION_BOTTOM + (count - 1 - row) * (each + _CORRELATION_GAP)
                axes = axes_in_inches(figure, left, foot, each, each)
                axes.set_xticks([])
                axes.set_yticks([])
                if row == column:
                    _name(axes, fit, row, each)
                elif row > column:
                    _region(axes, fit, column, row)
                else:
                    _number(axes, float(fit.correlation[row, column]))
        _correlation_legend(figure, traced=bool(fit.profiles))
    return figure


def _name(axes: Axes, fit: Fit, index: int, size: float) -> None:
    one = fit.problem.free[index]
    # Ten letters fill an inch at eight points; underscores are where a name may be broken.
    parts = one.name.replace("_", "_\n") if len(one.name) > 11 * size else one.name
    text = f"{parts}\n{fit.parameters[one.name].verdict}"
    axes.text(0.5, 0.5, text, ha="center", va="center", fontsize=8, transform=axes.transAxes, parse_math=False)
    for spine in axes.spines.values():
        spine.set_visible(False)


def _region(axes: Axes, fit: Fit, across: int, up: int) -> None:
    ellipse = np.sqrt(JOINT) * unit_ellipse(float(fit.correlation[across, up]))
    axes.axhline(0.0, color="#e8e8e8", linewidth=0.6)
    axes.axvline(0.0, color="#e8e8e8", linewidth=0.6)
    axes.fill(ellipse[0], ellipse[1], color=style.SKY, alpha=0.25, linewidth=0)
    axes.plot(ellipse[0], ellipse[1], color=style.BLUE, linewidth=1.1)
    for held, color in ((across, style.VERMILLION), (up, style.PURPLE)):
        if fit.profiles:
            path = _path(fit, held, across, up)
            axes.plot(path[0], path[1], color=color, linewidth=0.9)
    axes.plot([0], [0], "o", color=style.VERMILLION, markersize=3.5)
    axes.set_xlim(-_CORRELATION_FAR, _CORRELATION_FAR)
    axes.set_ylim(-_CORRELATION_FAR, _CORRELATION_FAR)


def unit_ellipse(correlation: float) -> NDArray[np.float64]:
    """Points x, y, shape (2, n), at which the quadratic form of the inverse correlation matrix is one."""
    r = float(np.clip(np.nan_to_num(correlation), -1.0, 1.0))
    angle = np.linspace(0.0, 2 * np.pi, 200)
    return np.array([np.cos(angle), r * np.cos(angle) + np.sqrt(1 - r * r) * np.sin(angle)])


def _path(fit: Fit, held: int, across: int, up: int) -> NDArray[np.float64]:
    """Way of the best fit, shape (2, points), as one unknown is held, in standard errors from the optimum."""
    profile = fit.profiles[held]
    everything = np.insert(profile.others, held, profile.q, axis=1)
    error = fit.information.standard_errors
    safe = np.where(error > 0, error, 1.0)
    scaled: NDArray[np.float64] = ((everything - fit.starts.best.q) / safe)[:, [across, up]].T
    return scaled


def _number(axes: Axes, correlation: float) -> None:
    known = np.isfinite(correlation)
    color = style.VERMILLION if correlation < 0 else style.BLUE
    if known:
        axes.set_facecolor((*_rgb(color), 0.55 * min(abs(correlation), 1.0)))
    text = f"{correlation:+.3f}".replace("-", "\N{MINUS SIGN}") if known else "–"
    axes.text(0.5, 0.5, text, ha="center", va="center", fontsize=10, transform=axes.transAxes)


def _rgb(color: str) -> tuple[float, float, float]:
    red, green, blue = (int(color[k : k + 2], 16) / 255 for k in (1, 3, 5))
    return red, green, blue


def _correlation_legend(figure: Figure, *, traced: bool) -> None:
    handles = [Line2D([], [], color=style.BLUE, label="linear theory")]
    if traced:
        handles.append(Line2D([], [], color=style.VERMILLION, label="profile of the column's parameter"))
        handles.append(Line2D([], [], color=style.PURPLE, label="profile of the row's"))
    figure.legend(
        handles=handles, loc="lower left", bbox_to_anchor=(_CORRELATION_LEFT / style.WIDTH, 0.0), ncols=3, fontsize=7.5
    )


_STARTS_LEFT, _STARTS_RIGHT, _STARTS_BOTTOM, _STARTS_ACROSS, _STARTS_BETWEEN = 0.6, 0.25, 0.75, 0.25, 0.75
_STEP, _LEAST = 0.22, 1.2
_STARTS_MOST = 4
"""Panels in a row."""

_COLORS = (style.VERMILLION, style.BLUE, style.GREEN, style.PURPLE, style.ORANGE, style.SKY)
# Ratio of the worst value to the best from which on the axis is logarithmic.
_STARTS_FAR = 3.0


def starts_figure(fit: Fit) -> Figure:
    """Draw a line for each start, the best on top: what is left of the misfit, and each parameter's way."""
    panels = 1 + len(fit.problem.free)
    across = min(panels, _STARTS_MOST)
    rows = -(-panels // across)
    tall = max(_LEAST, _STEP * (len(fit.starts.falls) + 1))
    height = HEADING + rows * tall + (rows - 1) * _STARTS_BETWEEN + _STARTS_BOTTOM + 0.05
    wide = (style.WIDTH - _STARTS_LEFT - _STARTS_RIGHT - (across - 1) * _STARTS_ACROSS) / across
    with style.styled():
        figure = headed(fit, f"starts: {starts_text(fit)}", height, _STARTS_LEFT)
        for k in range(panels):
            row, column = divmod(k, across)
            foot = _STARTS_BOTTOM + (rows - 1 - row) * (tall + _STARTS_BETWEEN)
            axes = axes_in_inches(figure, _STARTS_LEFT + column * (wide + _STARTS_ACROSS), foot, wide, tall)
            if k == 0:
                _draw_values(axes, fit)
            else:
                _draw_way(axes, fit, k - 1)
            _ranks(axes, len(fit.starts.falls), labelled=column == 0)
        _starts_legend(figure, fit)
    return figure


def _color(cluster: int) -> str:
    return _COLORS[cluster] if cluster < len(_COLORS) else style.GREY


def _face(converged: bool, color: str) -> str:
    return color if converged else "white"


def _draw_values(axes: Axes, fit: Fit) -> None:
    values = fit.starts.values
    least = float(values.min())
    # A fit that meets exact data has nothing left to compare with.
    shares = values / least if least > 0 else values
    for rank, (fall, share) in enumerate(zip(fit.starts.falls, shares.tolist(), strict=True), start=1):
        color = _color(fall.cluster)
        face = _face(fall.optimum.converged, color)
        axes.plot([share], [rank], "o", color=color, markerfacecolor=face, markersize=5)
    far = float(shares.max())
    if least > 0 and far > _STARTS_FAR:
        axes.set_xscale("log")
        axes.set_xlim(0.7, 1.5 * far)
        decades = np.log10(far)
        axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if decades < 1 else (1.0,), numticks=5))
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_minor_formatter(NullFormatter())
    else:
        room = max(0.08 * (far - float(shares.min())), 0.02 * abs(far), 1e-300)
        axes.set_xlim(float(shares.min()) - room, far + room)
        axes.xaxis.set_major_locator(MaxNLocator(3))
    axes.xaxis.set_major_formatter(FuncFormatter(plain))
    axes.set_xlabel("misfit / least misfit" if least > 0 else "misfit", fontsize=8)


def _draw_way(axes: Axes, fit: Fit, index: int) -> None:
    free = fit.problem.free[index]
    ways = [(free.value(float(one.start[index])), free.value(float(one.optimum.q[index]))) for one in fit.starts.falls]
    unit = parameter_axis(axes, free, np.array(ways).ravel(), ways[0][1])
    for rank, (fall, (start, end)) in enumerate(zip(fit.starts.falls, ways, strict=True), start=1):
        color = _color(fall.cluster)
        begin, finish = float(unit.of(start)), float(unit.of(end))
        axes.plot([begin, finish], [rank, rank], color=color, linewidth=0.9, alpha=0.6)
        axes.plot([begin], [rank], "|", color=color, markersize=7)
        axes.plot(
            [finish], [rank], "o", color=color, markerfacecolor=_face(fall.optimum.converged, color), markersize=5
        )


def _ranks(axes: Axes, count: int, *, labelled: bool) -> None:
    axes.set_ylim(count + 0.7, 0.3)
    axes.yaxis.set_major_locator(MaxNLocator(min(8, count + 1), integer=True))
    axes.grid(True, axis="x")
    axes.tick_params(labelleft=labelled)
    if labelled:
        axes.set_ylabel("start")
    style.lighten(axes)


def _starts_legend(figure: Figure, fit: Fit) -> None:
    grey: dict[str, object] = {"color": style.BLACK, "linestyle": ""}
    handles = [
        Line2D([], [], marker="|", markersize=7, label="start", **grey),  # type: ignore[arg-type]
        Line2D([], [], marker="o", markersize=5, label="end", **grey),  # type: ignore[arg-type]
    ]
    if not all(one.optimum.converged for one in fit.starts.falls):
        handles.append(Line2D([], [], marker="o", markersize=5, markerfacecolor="white", label="not converged", **grey))  # type: ignore[arg-type]
    clusters = sorted({one.cluster for one in fit.starts.falls})[: len(_COLORS)]
    for cluster in clusters if len(clusters) > 1 else ():
        name = "the best fit" if cluster == 0 else f"another fit ({cluster + 1})"
        handles.append(Line2D([], [], marker="s", linestyle="", markersize=5, color=_color(cluster), label=name))
    spot = (_STARTS_LEFT / style.WIDTH, 0.0)
    figure.legend(handles=handles, loc="lower left", bbox_to_anchor=spot, ncols=6, fontsize=7.5, handletextpad=0.3)


_FEATURES_LEFT, _FEATURES_RIGHT, _FEATURES_GAP, _FEATURES_TALL, _FEATURES_BOTTOM = 0.75, 0.2, 0.62, 2.7, 2.05


def features_figure(time: Floats, midpoint: Floats, features: Features, title: str = "Features") -> Figure:
    """Draw the whole film on logarithmic axes, and beside it the stretch in which the oscillation is read."""
    height = HEADING + _FEATURES_TALL + _FEATURES_BOTTOM
    sag = -midpoint
    clock, ruler = time_unit(float(time[-1])), length_unit(float(np.max(np.abs(sag))))
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        place = _FEATURES_LEFT / style.WIDTH
        heading = style.printable(title)
        figure.text(place, 1 - 0.12 / height, heading, va="top", fontsize=10.5, fontweight="bold", parse_math=False)
        below = f"{len(time)} frames of the midpoint · scatter {ruler.text(features.noise)}"
        figure.text(place, 1 - 0.33 / height, below, va="top", fontsize=8.5, color=style.GREY)
        wide = (style.WIDTH - _FEATURES_LEFT - _FEATURES_RIGHT - _FEATURES_GAP) / 2
        left = axes_in_inches(figure, _FEATURES_LEFT, _FEATURES_BOTTOM, wide, _FEATURES_TALL)
        right = axes_in_inches(figure, _FEATURES_LEFT + wide + _FEATURES_GAP, _FEATURES_BOTTOM, wide, _FEATURES_TALL)
        _features_draw_film(left, time, sag, features, clock, ruler)
        _draw_ringing(right, time, sag, features, clock, ruler)
        for axes in (left, right):
            axes.set_xlabel(f"time [{clock.symbol}]")
            axes.grid(True)
            style.lighten(axes)
            axes.legend(loc="lower right", fontsize=7.5, frameon=True, framealpha=0.85, edgecolor="none")
        left.set_ylabel(f"sag [{ruler.symbol}]")
        for k, line in enumerate(_lines(features, clock, ruler)):
            at = (_FEATURES_BOTTOM - 0.62 - 0.18 * k) / height
            figure.text(place, at, line, va="top", fontsize=8, parse_math=False)
    return figure


def _features_draw_film(axes: Axes, time: Floats, sag: Floats, features: Features, clock: Unit, ruler: Unit) -> None:
    shown = (time > 0) & (sag > 0)
    at, deep = time[shown], sag[shown]
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        # The default writes powers of ten with fonts that not every machine has.
        axis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axis.set_minor_formatter(NullFormatter())
    axes.plot(clock.of(at), ruler.of(deep), ".", color=style.BLACK, markersize=2.5, alpha=0.5, label="frames")
    # Noise makes the first frames anything; free fall says how deep they may be.
    low, high = max(float(deep.min()), 1e-3 * float(deep.max())), 1.5 * float(deep.max())
    fall = 0.5 * features.gravity * at**2
    inside = (fall > low) & (fall < high)
    axes.plot(clock.of(at[inside]), ruler.of(fall[inside]), ":", color=style.GREEN, label="free fall")
    if features.late is not None:
        law = features.late
        dense = np.geomspace(law.first, law.last, 200)
        axes.plot(clock.of(dense), ruler.of(law.sag(dense)), color=style.PURPLE, label="1/3 law")
    if features.ringing is not None:
        dense = _dense(features)
        axes.plot(clock.of(dense), ruler.of(features.ringing.curve(dense)), color=style.VERMILLION, linewidth=1.0)
    for reading, name in ((features.t_low, "t_low"), (features.t_high, "t_high")):
        if reading.value is not None:
            axes.axvline(float(clock.of(reading.value)), color=style.GREY, linewidth=0.8)
            axes.text(float(clock.of(reading.value)), float(ruler.of(low)), f" {name}", fontsize=7.5, color=style.GREY)
    axes.set_xlim(float(clock.of(at[0])), float(clock.of(at[-1])))
    axes.set_ylim(float(ruler.of(low)) / 1.3, float(ruler.of(high)))


def _draw_ringing(axes: Axes, time: Floats, sag: Floats, features: Features, clock: Unit, ruler: Unit) -> None:
    one = features.ringing
    if one is None:
        axes.plot(clock.of(time), ruler.of(sag), ".", color=style.BLACK, markersize=3, alpha=0.5, label="frames")
        return
    part = (time >= one.stretch.time[0]) & (time <= one.stretch.time[-1])
    dense = _dense(features)
    axes.plot(clock.of(time[part]), ruler.of(sag[part]), ".", color=style.BLACK, markersize=3.5, label="frames")
    axes.plot(clock.of(dense), ruler.of(one.curve(dense)), color=style.VERMILLION, linewidth=1.0, label="oscillation")
    axes.plot(clock.of(dense), ruler.of(one.trend(dense)), "--", color=style.BLUE, linewidth=1.0, label="trend")
    axes.plot([clock.of(one.middle)], [ruler.of(one.sag)], "o", color=style.BLUE, markersize=5, label="R, d, H read")


def _dense(features: Features) -> Floats:
    if features.ringing is None:
        return np.empty(0)
    frames = features.ringing.stretch.time
    return np.linspace(frames[0], frames[-1], 1200)


def _lines(features: Features, clock: Unit, ruler: Unit) -> list[str]:
    rows: list[tuple[str, Reading, float, str]] = [
        ("t_low", features.t_low, clock.size, f" {clock.symbol}"),
        ("t_high", features.t_high, clock.size, f" {clock.symbol}"),
        ("frequency R", features.frequency, 1.0, " rad/s"),
        ("decay d", features.decay, 1.0, " 1/s"),
        ("sag H", features.sag, ruler.size, f" {ruler.symbol}"),
        ("B", features.prefactor, 1.0, ""),
    ]
    return [f"{name}: {_text(one, size, unit)}" for name, one, size, unit in rows]


def _text(one: Reading, size: float, unit: str) -> str:
    if one.value is None or one.error is None:
        return f"not read: {one.reason}"
    return f"{significant(one.value / size)} ± {one.error / size:.1g}{unit}"


_LAWS_LEFT, _LAWS_RIGHT, _LAWS_BOTTOM, _EACH, _LAWS_BETWEEN = 0.85, 0.2, 0.55, 1.0, 0.35

_LAWS_CROWDED = 0.12
"""Where half of the frames lie within this share of the time, the axis is logarithmic."""

_ROOM, _FURTHER = 1.1, 3.0
"""Of the scale over the best law's largest residual; how much larger those of others may make it."""


def laws_figure(found: LawComparison) -> Figure:
    """Draw the residuals [m] of every law over time on one scale, the best law first.

    What leaves the scale is a cross at its edge: a law that is far off would make the others' residuals a line.
    """
    rows = [row for row in found.choice.table if not row.law.failure]
    fits = [found.fits[row.law.name] for row in rows]
    height = HEADING + 0.2 + len(rows) * (_EACH + _LAWS_BETWEEN) - _LAWS_BETWEEN + _LAWS_BOTTOM
    reaches = [_reach(one) for one in fits]
    far = _ROOM * min(max(reaches), _FURTHER * reaches[0])
    ruler = length_unit(far)
    with style.styled():
        figure = headed(found.best, found.sentence, height, _LAWS_LEFT)
        width = style.WIDTH - _LAWS_LEFT - _LAWS_RIGHT
        for k, (row, one) in enumerate(zip(rows, fits, strict=True)):
            foot = _LAWS_BOTTOM + (len(rows) - 1 - k) * (_EACH + _LAWS_BETWEEN)
            axes = axes_in_inches(figure, _LAWS_LEFT, foot, width, _EACH)
            _laws_draw(axes, one, far, ruler)
            _time_axis(axes, one, last=k == len(rows) - 1)
            axes.set_title(_title(row, one, found.choice.criterion), loc="left", fontsize=8.5, pad=3, parse_math=False)
            axes.set_ylabel(f"residual [{ruler.symbol}]", fontsize=8)
    return figure


def _title(row: Ranked, one: Fit, criterion: str) -> str:
    spread = residual_std(one)
    parts = [
        row.law.name,
        f"{criterion} {row.difference:.1f} above the best" if row.difference else f"least {criterion}",
    ]
    return " · ".join([*parts, f"residuals {one.checks.verdict}", f"rms {length_unit(spread).text(spread)}"])


def _reach(one: Fit) -> float:
    """Largest residual [m]."""
    return max(float(np.abs(film.model - film.measured).max()) for film in one.films) or 1e-12


def _laws_draw(axes: Axes, one: Fit, far: float, ruler: Unit) -> None:
    clock = _clock(one)
    colours = (style.BLUE, style.VERMILLION, style.GREEN, style.ORANGE, style.PURPLE, style.SKY)
    axes.grid(True)
    axes.axhline(0.0, color=style.GREY, linewidth=0.8)
    for k, film in enumerate(one.films):
        colour, left = colours[k % len(colours)], film.model - film.measured
        out = np.abs(left) > far
        time, height = clock.of(film.time), ruler.of(np.clip(left, -far, far))
        axes.plot(time[~out], height[~out], ".", color=colour, markersize=3.5, clip_on=False)
        axes.plot(time[out], height[out], "x", color=colour, markersize=3.5, clip_on=False)
    edge = float(ruler.of(far))
    axes.set_ylim(-edge, edge)
    axes.yaxis.set_major_locator(MaxNLocator(4, symmetric=True))
    axes.yaxis.set_major_formatter(FuncFormatter(plain))
    style.lighten(axes)


def _clock(one: Fit) -> Unit:
    return time_unit(max(float(film.time.max()) for film in one.films))


def _time_axis(axes: Axes, one: Fit, *, last: bool) -> None:
    clock = _clock(one)
    times = clock.of(np.concatenate([film.time for film in one.films]))
    later = times[times > 0]
    end = float(later.max())
    if later.size > 2 and float(np.median(later)) < _LAWS_CROWDED * end:
        axes.set_xscale("log")
        axes.set_xlim(float(later.min()) / 1.1, end * 1.1)
        axes.xaxis.set_major_formatter(FuncFormatter(plain))
        axes.xaxis.set_minor_formatter(NullFormatter())
    else:
        axes.set_xlim(min(0.0, float(times.min())) - 0.02 * end, 1.02 * end)
    axes.tick_params(labelbottom=last)
    if last:
        axes.set_xlabel(f"time [{clock.symbol}]")
