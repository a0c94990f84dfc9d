"""Pictures of a fit: data and model, profiles, correlations, starts, features, laws."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator

from softcat_sym.fitting.features import Features, Floats, Reading
from softcat_sym.plotting import style
from softcat_sym.plotting.fit_words import display_unit, noise_text, residual_std, starts_text
from softcat_sym.plotting.style import legend, sheet
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


def headed(fit: Fit, what: str, height: float, notes: str = "") -> tuple[Figure, SubFigure]:
    """A sheet with the scene's title, and what is shown below it."""
    return sheet(fit.scene.title or "Filament", what, height=height, notes=notes)


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
    _dress_residuals(under, film)
    above.grid(True)
    style.lighten(above)
    above.set_ylabel(f"height [{ruler.symbol}]")
    under.set_xlabel(f"x from halfway between the supports [{ruler.symbol}]")


_CROWDED = 0.12
"""Where half of the frames lie within this share of the time, the axis is logarithmic."""


def curves_figure(fit: Fit) -> Figure:
    """Draw each film beside its model, with the 95 % band that the parameters' covariance gives it."""
    views = _views(fit)
    with style.styled():
        below = f"{fit.outcome.word} · residuals {fit.checks.verdict} · noise {noise_text(fit)}"
        figure, body = headed(fit, below, 4.0 * len(views))
        panels = body.subplots(2 * len(views), 1, height_ratios=[2.7, 1.0] * len(views))
        for (film, band, std), (above, under) in zip(views, panels.reshape(-1, 2), strict=True):
            if film.of_midpoint.all():
                _draw_midpoint(above, film, band, std)
                clock = time_unit(float(film.time[-1]))
                under.plot(clock.of(film.time), film.residuals, ".", color=style.BLUE, markersize=3.5, clip_on=False)
                _dress_residuals(under, film)
                under.set_xlabel(f"time [{clock.symbol}]")
                for axes in (above, under):
                    time_axis(axes, clock.of(film.time))
            else:
                draw_shapes(above, under, film)
            above.tick_params(labelbottom=False)
            if len(views) > 1:
                above.set_title(style.printable(film.name, 60), loc="left", fontsize=8.5, pad=3, parse_math=False)
            if film is views[0][0]:
                above.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3, borderaxespad=0.2, fontsize=7.5)
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


def _draw_midpoint(axes: Axes, film: FittedFilm, band: NDArray[np.float64], std: NDArray[np.float64] | None) -> None:
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


def _dress_residuals(axes: Axes, film: FittedFilm) -> None:
    """Grid, label, and the lines between which 95 % of white residuals lie."""
    axes.grid(True)
    for edge in (-1.96, 0.0, 1.96):
        axes.axhline(edge, color=style.GREY, linewidth=0.8, linestyle=(0, (4, 2)) if edge else "-", zorder=1)
    far = max(2.6, 1.15 * float(np.abs(film.residuals).max()))
    axes.set_ylim(-far, far)
    axes.yaxis.set_major_formatter("{x:.3g}")
    axes.set_ylabel("residual / std")
    style.lighten(axes)


def time_axis(axes: Axes, times: Floats) -> None:
    """Limits of a time axis, logarithmic where the frames crowd at its beginning."""
    later, start, end = times[times > 0], float(times.min()), float(times.max())
    if later.size > 2 and float(np.median(later)) < _CROWDED * end:
        axes.set_xscale("log")
        axes.set_xlim(float(later.min()) / 1.1, end * 1.1)
        style.plain_log(axes.xaxis, plain)
    else:
        room = 0.02 * (end - start)
        axes.set_xlim(min(0.0, start) - room if start < 0.2 * end else start - room, end + room)


_MOST = 3
"""Panels in a row."""


_DENSE = 400
# Thresholds that the axis is high: what happens far above it is nobody's concern.
_HIGH = 2.2


def profiles_figure(fit: Fit) -> Figure:
    """Draw one panel for each parameter."""
    across = min(len(fit.profiles), _MOST)
    rows = math.ceil(len(fit.profiles) / across)
    with style.styled():
        what = "profile likelihood: how much worse the fit becomes with one parameter held, the others fitted anew"
        figure, body = headed(fit, what, 2.6 * rows + 0.3)
        panels = body.subplots(rows, across, squeeze=False)
        for k, (one, free) in enumerate(zip(fit.profiles, fit.problem.free, strict=True)):
            axes = panels.flat[k]
            _draw_profile(axes, one, free, float(fit.information.standard_errors[k]))
            axes.set_title(fit.parameters[free.name].verdict, loc="left", fontsize=8.5, pad=4)
            if k % across == 0:
                axes.set_ylabel("increase of χ²")
        for axes in panels.flat[len(fit.profiles) :]:
            axes.remove()
        legend(body, handles=panels.flat[0].get_legend_handles_labels()[0], ncols=5)
    return figure


def _draw_profile(axes: Axes, one: Profile, free: FreeParameter, error: float) -> None:
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


JOINT = 5.991
"""95 % quantile of chi^2 with two degrees of freedom."""

_REACH = 3.6


def correlation_figure(fit: Fit) -> Figure:
    """Draw the matrix of all pairs: below its diagonal regions in standard errors, above it correlations."""
    count = len(fit.problem.free)
    each = min(1.7, 6.6 / count)
    with style.styled():
        what = "joint 95 % regions in standard errors, and correlations of the estimates"
        figure, body = headed(fit, what, count * (each + 0.08) + 0.4)
        panels = body.subplots(count, count, squeeze=False, subplot_kw={"xticks": [], "yticks": []})
        for (row, column), axes in np.ndenumerate(panels):
            axes.set_box_aspect(1)
            if row == column:
                _name(axes, fit, row, each)
            elif row > column:
                _region(axes, fit, column, row)
            else:
                _number(axes, float(fit.correlation[row, column]))
        handles = [Line2D([], [], color=style.BLUE, label="linear theory")]
        if fit.profiles:
            handles.append(Line2D([], [], color=style.VERMILLION, label="profile of the column's parameter"))
            handles.append(Line2D([], [], color=style.PURPLE, label="profile of the row's"))
        legend(body, handles=handles, ncols=3)
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
    axes.set_xlim(-_REACH, _REACH)
    axes.set_ylim(-_REACH, _REACH)


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
        axes.set_facecolor(to_rgba(color, 0.55 * min(abs(correlation), 1.0)))
    text = f"{correlation:+.3f}".replace("-", "\N{MINUS SIGN}") if known else "–"
    axes.text(0.5, 0.5, text, ha="center", va="center", fontsize=10, transform=axes.transAxes)


_COLORS = (style.VERMILLION, style.BLUE, style.GREEN, style.PURPLE, style.ORANGE, style.SKY)
# Ratio of the worst value to the best from which on the axis is logarithmic.
_FAR = 3.0


def starts_figure(fit: Fit) -> Figure:
    """Draw a line for each start, the best on top: what is left of the misfit, and each parameter's way."""
    count = 1 + len(fit.problem.free)
    across = min(count, 4)
    rows = -(-count // across)
    tall = max(1.2, 0.22 * (len(fit.starts.falls) + 1))
    with style.styled():
        figure, body = headed(fit, f"starts: {starts_text(fit)}", rows * (tall + 0.65) + 0.3)
        panels = body.subplots(rows, across, squeeze=False)
        for k, axes in enumerate(panels.flat):
            if k >= count:
                axes.remove()
                continue
            if k == 0:
                _draw_values(axes, fit)
            else:
                _draw_way(axes, fit, k - 1)
            _ranks(axes, len(fit.starts.falls), labelled=k % across == 0)
        legend(body, handles=_handles(fit), ncols=6, handletextpad=0.3)
    return figure


def _color(cluster: int) -> str:
    return _COLORS[cluster] if cluster < len(_COLORS) else style.GREY


def _draw_values(axes: Axes, fit: Fit) -> None:
    values = fit.starts.values
    least = float(values.min())
    # A fit that meets exact data has nothing left to compare with.
    shares = values / least if least > 0 else values
    for rank, (fall, share) in enumerate(zip(fit.starts.falls, shares.tolist(), strict=True), start=1):
        color = _color(fall.cluster)
        face = color if fall.optimum.converged else "white"
        axes.plot([share], [rank], "o", color=color, markerfacecolor=face, markersize=5)
    far = float(shares.max())
    if least > 0 and far > _FAR:
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
            [finish],
            [rank],
            "o",
            color=color,
            markerfacecolor=color if fall.optimum.converged else "white",
            markersize=5,
        )


def _ranks(axes: Axes, count: int, *, labelled: bool) -> None:
    axes.set_ylim(count + 0.7, 0.3)
    axes.yaxis.set_major_locator(MaxNLocator(min(8, count + 1), integer=True))
    axes.grid(True, axis="x")
    axes.tick_params(labelleft=labelled)
    if labelled:
        axes.set_ylabel("start")
    style.lighten(axes)


def _handles(fit: Fit) -> list[Line2D]:
    grey: dict[str, Any] = {"color": style.BLACK, "linestyle": "", "markersize": 5}
    handles = [
        Line2D([], [], marker="|", label="start", **grey),
        Line2D([], [], marker="o", label="end", **grey),
    ]
    if not all(one.optimum.converged for one in fit.starts.falls):
        handles.append(Line2D([], [], marker="o", markerfacecolor="white", label="not converged", **grey))
    clusters = sorted({one.cluster for one in fit.starts.falls})[: len(_COLORS)]
    for cluster in clusters if len(clusters) > 1 else ():
        name = "the best fit" if cluster == 0 else f"another fit ({cluster + 1})"
        handles.append(Line2D([], [], marker="s", label=name, **{**grey, "color": _color(cluster)}))
    return handles


def features_figure(time: Floats, midpoint: Floats, features: Features, title: str = "Features") -> Figure:
    """Draw the whole film on logarithmic axes, and beside it the stretch in which the oscillation is read."""
    sag = -midpoint
    clock, ruler = time_unit(float(time[-1])), length_unit(float(np.max(np.abs(sag))))
    below = f"{len(time)} frames of the midpoint · scatter {ruler.text(features.noise)}"
    with style.styled():
        figure, body = sheet(title, below, height=3.1, notes="\n".join(_lines(features, clock, ruler)))
        left, right = body.subplots(1, 2)
        _draw_film(left, time, sag, features, clock, ruler)
        _draw_ringing(right, time, sag, features, clock, ruler)
        for axes in (left, right):
            axes.set_xlabel(f"time [{clock.symbol}]")
            axes.grid(True)
            style.lighten(axes)
            axes.legend(loc="lower right", fontsize=7.5, frameon=True, framealpha=0.85, edgecolor="none")
        left.set_ylabel(f"sag [{ruler.symbol}]")
    return figure


def _draw_film(axes: Axes, time: Floats, sag: Floats, features: Features, clock: Unit, ruler: Unit) -> None:
    shown = (time > 0) & (sag > 0)
    at, deep = time[shown], sag[shown]
    axes.set_xscale("log")
    axes.set_yscale("log")
    for axis in (axes.xaxis, axes.yaxis):
        style.plain_log(axis)
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


_ROOM, _FURTHER = 1.1, 3.0
"""Of the scale over the best law's largest residual; how much larger those of others may make it."""


def laws_figure(found: LawComparison) -> Figure:
    """Draw the residuals [m] of every law over time on one scale, the best law first.

    What leaves the scale is a cross at its edge: a law that is far off would make the others' residuals a line.
    """
    rows = [row for row in found.choice.table if not row.law.failure]
    fits = [found.fits[row.law.name] for row in rows]
    reaches = [_reach(one) for one in fits]
    far = _ROOM * min(max(reaches), _FURTHER * reaches[0])
    ruler = length_unit(far)
    with style.styled():
        figure, body = headed(found.best, found.sentence, 1.35 * len(rows) + 0.4)
        for axes, row, one in zip(body.subplots(len(rows), 1, squeeze=False).flat, rows, fits, strict=True):
            clock = time_unit(max(float(film.time.max()) for film in one.films))
            _draw_law(axes, one, far, ruler, clock)
            time_axis(axes, clock.of(np.concatenate([film.time for film in one.films])))
            axes.set_title(_title(row, one, found.choice.criterion), loc="left", fontsize=8.5, pad=3, parse_math=False)
            axes.set_xlabel(f"time [{clock.symbol}]")
            axes.label_outer()
        body.supylabel(f"residual [{ruler.symbol}]", fontsize=8)
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


def _draw_law(axes: Axes, one: Fit, far: float, ruler: Unit, clock: Unit) -> None:

    colours = (style.BLUE, style.VERMILLION, style.GREEN, style.ORANGE, style.PURPLE, style.SKY)
    axes.grid(True)
    axes.axhline(0.0, color=style.GREY, linewidth=0.8)
    for k, film in enumerate(one.films):
        colour, left = colours[k % len(colours)], film.model - film.measured
        out = np.abs(left) > far
        time, height = clock.of(film.time), ruler.of(np.clip(left, -far, far))
        axes.plot(time[~out], height[~out], ".", color=colour, markersize=3.5, clip_on=False)
        if np.any(out):  # an empty line would claim room for itself
            axes.plot(time[out], height[out], "x", color=colour, markersize=3.5, clip_on=False)
    edge = float(ruler.of(far))
    axes.set_ylim(-edge, edge)
    axes.yaxis.set_major_locator(MaxNLocator(4, symmetric=True))
    axes.yaxis.set_major_formatter(FuncFormatter(plain))
    style.lighten(axes)


FIGURES = {
    "curves": curves_figure,
    "profiles": profiles_figure,
    "correlation": correlation_figure,
    "starts": starts_figure,
}
