"""Pictures of a fit: data and model, profiles, correlations, starts, features, laws."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, MaxNLocator

from softcat_sym.fitting.features import Features, Floats
from softcat_sym.plotting import style
from softcat_sym.plotting.fit_words import display_unit, feature_texts, noise_text, starts_text
from softcat_sym.plotting.style import legend, log_axes, number_axis, plain, sheet, styled
from softcat_sym.plotting.time_axis import TimeAxis
from softcat_sym.plotting.units import Unit, length_unit, time_unit

if TYPE_CHECKING:
    from softcat_sym.fitting.closed_form import ClosedForm
    from softcat_sym.fitting.collapse_test import CollapseTest
    from softcat_sym.fitting.free_parameters import FreeParameter
    from softcat_sym.fitting.inference import Profile
    from softcat_sym.fitting.model_selection import LawComparison
    from softcat_sym.fitting.result import Fit, FittedFilm

LOGARITHMIC_FROM = 4.0
"""Ratio of an axis' ends above which it is logarithmic."""

_PANELS = 3
"""Profiles in a row."""


def fit_sheet(fit: Fit, what: str, height: float) -> tuple[Figure, SubFigure]:
    """A sheet with the scene's title, and a subtitle that names its content."""
    return sheet(fit.scene.title or "Filament", what, height=height)


def parameter_axis(axes: Axes, free: FreeParameter, values: Floats, best: float) -> Unit:
    """Set up the horizontal axis for values of a parameter, and return its unit."""
    values = values[np.isfinite(values)]
    low, high = float(values.min()), float(values.max())
    logarithmic = free.logarithmic and high > LOGARITHMIC_FROM * low
    unit = display_unit(free.unit, best if logarithmic else float(np.abs(values).max()))
    number_axis(axes, "x", low / unit.size, high / unit.size, is_log=logarithmic)
    axes.set_xlabel(parameter_label(free, unit), fontsize=8)
    return unit


def parameter_label(free: FreeParameter, unit: Unit) -> str:
    """Name and unit of a parameter."""
    return free.name if free.unit == "1" else f"{free.name} [{unit.symbol}]"


@styled()
def curves_figure(fit: Fit) -> Figure:
    """Draw each film beside its model, with the 95 % band that the parameters' covariance gives it."""
    views: list[tuple[FittedFilm, Floats, Floats | None]] = []
    for film, band, posed in zip(fit.films, model_bands(fit), fit.problem.films, strict=True):
        for chosen in (film.of_midpoint, film.of_shape):
            if chosen.any():
                views.append((film.part(chosen), band[chosen], posed.std[chosen] if fit.noise_known else None))
    below = f"{fit.outcome.word} · residuals {fit.checks.verdict} · noise {noise_text(fit)}"
    figure, body = fit_sheet(fit, below, 4.0 * len(views))
    panels = body.subplots(2 * len(views), 1, height_ratios=[2.7, 1.0] * len(views)).reshape(-1, 2)
    for (film, band, std), (above, under) in zip(views, panels, strict=True):
        draw = _draw_shapes if film.of_shape.all() else _draw_midpoint
        draw(above, under, film, band, std)
        above.grid(True)
        under.grid(True)
        for edge in (-1.96, 0.0, 1.96):
            under.axhline(edge, color=style.GREY, linewidth=0.8, linestyle=(0, (4, 2)) if edge else "-", zorder=1)
        far = max(2.6, 1.15 * float(np.abs(film.residuals).max()))
        under.set(ylim=(-far, far), ylabel="residual / std")
        under.yaxis.set_major_formatter("{x:.3g}")
        above.tick_params(labelbottom=False)
        if len(views) > 1:
            above.set_title(style.printable(film.name, 60), loc="left", fontsize=8.5, pad=3, parse_math=False)
    top = panels[0, 0]
    top.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3, borderaxespad=0.2, fontsize=7.5)
    return figure


def model_bands(fit: Fit) -> list[Floats]:
    """Half-width of the model's 95 % interval at each reading [m], one array for each film, to first order."""
    left, size, _ = np.linalg.svd(fit.starts.best.jacobian, full_matrices=False)
    parts = np.split(left[:, size > 1e-10 * size[0]], np.cumsum([film.data.size for film in fit.problem.films]))
    factor, bands = fit.information.quantile * fit.information.noise, list[Floats]()
    for film, basis in zip(fit.problem.films, parts, strict=False):
        # What is known of a reading without its noise: of the constants, and of the errors of camera and theory.
        noise = film.covariance.noise
        rows = film.covariance.whitened(noise)
        variance = np.diag(noise) - np.sum(rows**2, axis=0) + np.sum((basis.T @ rows) ** 2, axis=0)
        bands.append(factor * np.sqrt(np.maximum(variance, 0.0)))
    return bands


def _draw_midpoint(above: Axes, under: Axes, film: FittedFilm, band: Floats, std: Floats | None) -> None:
    """Measured midpoints, the model with its band, and residuals, over time."""
    largest = float(np.abs(film.measured).max())
    ruler = length_unit(largest)
    axis = TimeAxis.of(film.time, film.model)
    time, data, model, half = axis.unit.of(film.time), ruler.of(film.measured), ruler.of(film.model), ruler.of(band)
    above.axhline(0.0, color=style.GREY, linewidth=0.6)
    if std is not None:
        bars: dict[str, Any] = {"ecolor": style.BLACK, "elinewidth": 0.7, "alpha": 0.45, "zorder": 1.5}
        above.errorbar(time, data, yerr=ruler.of(std), fmt="none", **bars)
    label = "measured" if std is None else "measured ± std"
    above.plot(time, data, ".", color=style.BLACK, markersize=4, alpha=0.6, label=label, clip_on=False)
    look: dict[str, Any] = {"color": style.VERMILLION, "alpha": 0.25, "linewidth": 0, "label": "95 % band"}
    above.fill_between(time, model - half, model + half, **look)
    above.plot(time, model, color=style.VERMILLION, linewidth=1.2, label="model")
    low, high = min(float(data.min()), float(model.min())), max(float(data.max()), float(model.max()), 0.0)
    above.set_ylim(low - 0.06 * (high - low), high + 0.06 * (high - low))
    above.set_ylabel(f"midpoint height [{ruler.symbol}]")
    under.plot(time, film.residuals, ".", color=style.BLUE, markersize=3.5, clip_on=False)
    for axes in (above, under):
        axis.dress(axes, label=axis.label if axes is under else "")


def _draw_shapes(above: Axes, under: Axes, film: FittedFilm, band: Floats, std: Floats | None) -> None:
    """Measured points and the model's shape at every time, and residuals, over x."""
    del band, std
    ruler, clock = length_unit(float(np.abs(film.place).max())), time_unit(float(film.time.max()))
    times = np.unique(film.time)
    named = set(np.unique(np.linspace(0, times.size - 1, 6).round().astype(int)).tolist())
    for number, time in enumerate(times.tolist()):
        color = colormaps["viridis"](0.9 * number / max(times.size - 1, 1))
        here = np.flatnonzero(film.time == time)
        here = here[np.argsort(film.place[here])]
        place = ruler.of(film.place[here])
        above.plot(place, ruler.of(film.measured[here]), ".", color=color, markersize=4, alpha=0.7)
        label = f"{float(clock.of(time)):.3g} {clock.symbol}" if number in named else None
        above.plot(place, ruler.of(film.model[here]), color=color, linewidth=1.1, label=label)
        under.plot(place, film.residuals[here], ".", color=color, markersize=3.5, clip_on=False)
    above.set_ylabel(f"height [{ruler.symbol}]")
    under.set_xlabel(f"x from halfway between the supports [{ruler.symbol}]")


@styled()
def profiles_figure(fit: Fit) -> Figure | None:
    """Draw the profile likelihood of each parameter."""
    if not fit.profiles:
        return None
    across = min(len(fit.profiles), _PANELS)
    rows = math.ceil(len(fit.profiles) / across)
    what = "profile likelihood: increase of χ² with one parameter held, the others re-optimised"
    figure, body = fit_sheet(fit, what, 2.6 * rows + 0.3)
    panels = body.subplots(rows, across, squeeze=False)
    for k, (one, free) in enumerate(zip(fit.profiles, fit.problem.free, strict=False)):
        axes = panels.flat[k]
        _draw_profile(axes, one, free, float(fit.information.standard_errors[k]))
        axes.set_title(fit.parameters[free.name].verdict, loc="left", fontsize=8.5, pad=4)
        axes.set_ylabel("" if k % across else "increase of χ²")
    for axes in panels.flat[len(fit.profiles) :]:
        axes.remove()
    legend(body, of=panels.flat[0], ncols=5)
    return figure


def _draw_profile(axes: Axes, one: Profile, free: FreeParameter, error: float) -> None:
    values, best = np.array([free.value(q) for q in one.q.tolist()]), free.value(one.optimum)
    unit = parameter_axis(axes, free, values, best)
    dense, curve = smooth(one)
    axes.axhline(0.0, color=style.GREY, linewidth=0.6)
    axes.axhline(one.threshold, label="95 % threshold", color=style.GREEN, linewidth=1.0, linestyle=(0, (6, 2)))
    for side in (one.lower, one.upper):
        if side.crossing is not None:
            at = float(unit.of(free.value(side.crossing)))
            axes.plot([at, at], [0, one.threshold], color=style.GREEN, linewidth=0.9, linestyle=":")
    parabola = ((dense - one.optimum) / error) ** 2 if error > 0 else np.zeros_like(dense)
    shown = unit.of([free.value(q) for q in dense.tolist()])
    axes.plot(shown, parabola, color=style.GREY, linewidth=1.1, linestyle="--", label="curvature only")
    axes.plot(shown, curve, color=style.BLUE, linewidth=1.4, label="profile")
    axes.plot(unit.of(values), one.increase, "o", color=style.BLUE, markersize=2.8)
    axes.plot(unit.of([best]), [0], "o", color=style.VERMILLION, markersize=5, label="best fit", zorder=4)
    # The range far above the threshold is not of interest.
    axes.set_ylim(min(0.0, float(one.increase.min())) - 0.1 * one.threshold, 2.2 * one.threshold)


def smooth(one: Profile) -> tuple[Floats, Floats]:
    """Interpolate a profile: linearly in its root, which is nearly linear in q on either side of the optimum."""
    root = np.sqrt(np.maximum(one.increase, 0.0))
    dense = np.union1d(np.linspace(one.q[0], one.q[-1], 400), one.q)
    inside = np.interp(dense, one.q, root)
    return dense, inside**2


JOINT = 5.991
"""95 % quantile of chi^2 with two degrees of freedom."""


@styled()
def correlation_figure(fit: Fit) -> Figure | None:
    """Draw the matrix of all pairs: joint regions in standard errors below its diagonal, correlations above it."""
    if not np.isfinite(fit.correlation[~np.eye(len(fit.correlation), dtype=bool)]).any():
        return None
    count = len(fit.problem.free)
    size = min(1.7, 6.6 / count)
    what = "joint 95 % regions in standard errors, and correlations of the estimates"
    figure, body = fit_sheet(fit, what, count * (size + 0.08) + 0.4)
    panels = body.subplots(count, count, squeeze=False, subplot_kw={"xticks": [], "yticks": []})
    for (row, column), axes in np.ndenumerate(panels):
        axes.set_box_aspect(1)
        if row > column:
            _draw_region(axes, fit, column, row)
            axes.spines[:].set_visible(True)
            continue
        correlation = float(fit.correlation[row, column])
        text = f"{correlation:+.3f}".replace("-", "\N{MINUS SIGN}") if math.isfinite(correlation) else "–"
        if row == column:
            name = fit.problem.free[row].name
            # Ten letters fill an inch at eight points; a long name is broken at its underscores.
            words = name.replace("_", "_\n") if len(name) > 11 * size else name
            text = f"{words}\n{fit.parameters[name].verdict}"
            axes.set_frame_on(False)
        elif math.isfinite(correlation):
            color = style.VERMILLION if correlation < 0 else style.BLUE
            axes.set_facecolor(to_rgba(color, 0.55 * min(abs(correlation), 1.0)))
        look: dict[str, Any] = {"ha": "center", "va": "center", "transform": axes.transAxes, "parse_math": False}
        axes.text(0.5, 0.5, text, fontsize=8 if row == column else 10, **look)
    names = {"linear theory": style.BLUE}
    if fit.profiles:
        names |= {"profile of the column's parameter": style.VERMILLION, "profile of the row's": style.PURPLE}
    legend(body, handles=[Line2D([], [], color=color, label=name) for name, color in names.items()], ncols=3)
    return figure


def _draw_region(axes: Axes, fit: Fit, across: int, up: int) -> None:
    """Draw the joint region of two parameters, and the paths of the best fit while one of them is held."""
    x, y = np.sqrt(JOINT) * unit_ellipse(float(fit.correlation[across, up]))
    axes.axhline(0.0, color="#e8e8e8", linewidth=0.6)
    axes.axvline(0.0, color="#e8e8e8", linewidth=0.6)
    axes.fill(x, y, color=style.SKY, alpha=0.25, linewidth=0)
    axes.plot(x, y, color=style.BLUE, linewidth=1.1)
    error = fit.information.standard_errors
    for held, color in ((across, style.VERMILLION), (up, style.PURPLE)):
        if fit.profiles:
            way = np.insert(fit.profiles[held].others, held, fit.profiles[held].q, axis=1) - fit.starts.best.q
            scaled = way[:, : error.size] / np.where(error > 0, error, 1.0)
            axes.plot(scaled[:, across], scaled[:, up], color=color, linewidth=0.9)
    axes.plot([0], [0], "o", color=style.VERMILLION, markersize=3.5)
    axes.set(xlim=(-3.6, 3.6), ylim=(-3.6, 3.6))


def unit_ellipse(correlation: float) -> Floats:
    """Points x, y, shape (2, n), at which the quadratic form of the inverse correlation matrix is one."""
    r = float(np.clip(np.nan_to_num(correlation), -1.0, 1.0))
    angle = np.linspace(0.0, 2 * np.pi, 200)
    return np.array([np.cos(angle), r * np.cos(angle) + np.sqrt(1 - r * r) * np.sin(angle)])


_COLORS = (style.VERMILLION, style.BLUE, style.GREEN, style.PURPLE, style.ORANGE, style.SKY)


def _color(cluster: int) -> str:
    return _COLORS[cluster] if cluster < len(_COLORS) else style.GREY


@styled()
def starts_figure(fit: Fit) -> Figure | None:
    """Draw a line for each start, the best on top: its final misfit, and each parameter from start to end."""
    if len(fit.starts.results) < 2:
        return None
    results, count = fit.starts.results, 1 + len(fit.problem.free)
    across, ranks = min(count, 4), np.arange(1, len(results) + 1)
    rows = math.ceil(count / across)
    values = np.array([result.optimum.value for result in results])
    least = float(values.min())
    colors = [_color(result.cluster) for result in results]
    faces = [color if result.optimum.converged else "white" for color, result in zip(colors, results, strict=True)]
    tall = max(1.2, 0.22 * (len(results) + 1))
    figure, body = fit_sheet(fit, f"starts: {starts_text(fit)}", rows * (tall + 0.65) + 0.3)
    panels = body.subplots(rows, across, squeeze=False)
    for axes in panels.flat[count:]:
        axes.remove()
    for k, axes in enumerate(panels.flat[:count]):
        if k == 0:
            # A fit to exact data has no misfit to compare with.
            ends = values / least if least > 0 else values
            is_log = bool(least > 0 and ends.max() > 3)
            number_axis(axes, "x", float(ends.min()), float(ends.max()), is_log=is_log)
            axes.set_xlabel("misfit / least misfit" if least > 0 else "misfit", fontsize=8)
        else:
            free = fit.problem.free[k - 1]
            ways = [(result.start[k - 1], result.optimum.q[k - 1]) for result in results]
            inside = np.array([[free.value(float(q)) for q in way] for way in ways])
            begins, ends = parameter_axis(axes, free, inside.ravel(), float(inside[0, 1])).of(inside).T
            axes.hlines(ranks, begins, ends, color=colors, linewidth=0.9, alpha=0.6)
            axes.scatter(begins, ranks, marker="|", color=colors, s=49)
        axes.scatter(ends, ranks, s=25, edgecolors=colors, facecolors=faces, zorder=3)
        axes.set(ylim=(len(results) + 0.7, 0.3), ylabel="" if k % across else "start")
        axes.yaxis.set_major_locator(MaxNLocator(min(8, len(results) + 1), integer=True))
        axes.grid(True, axis="x")
        axes.tick_params(labelleft=k % across == 0)
    marks: dict[str, Any] = {"color": style.BLACK, "linestyle": "", "markersize": 5}
    named = [{"marker": "|", "label": "start"}, {"marker": "o", "label": "end"}]
    if "white" in faces:
        named.append({"marker": "o", "markerfacecolor": "white", "label": "not converged"})
    clusters = sorted({result.cluster for result in results})[: len(_COLORS)]
    for cluster in clusters if len(clusters) > 1 else ():
        name = "the best fit" if cluster == 0 else f"another fit ({cluster + 1})"
        named.append({"marker": "s", "label": name, "color": _color(cluster)})
    handles = [Line2D([], [], **{**marks, **look}) for look in named]
    legend(body, handles=handles, ncols=6, handletextpad=0.3)
    return figure


@styled()
def collapse_figure(test: CollapseTest) -> Figure:
    """Draw the levelled contour of a strand on its pillars, with the fitted filament over each gap."""
    ends = [edge for gap in test.gaps for edge in (gap.left_x, gap.left_x + gap.span)]
    top = [height for gap in test.gaps for height in (gap.left_y, gap.left_y - gap.drop)]
    ruler = length_unit(ends[-1] - ends[0])
    foot = min(top) - (test.contour.pillar_height or 1.5 * max(gap.sag for gap in test.gaps))
    below = f"{test.fit.outcome.word} · turned back by {np.degrees(test.tilt):.3g}°"
    figure, body = fit_sheet(test.fit, below, 3.0)
    axes, outer = body.subplots(), 0.04 * (ends[-1] - ends[0])
    edges, heights = [ends[0] - outer, *ends, ends[-1] + outer], [top[0], *top, top[-1]]
    for k in range(0, len(edges), 2):
        block, level = [edges[k], edges[k], edges[k + 1], edges[k + 1]], [foot, heights[k], heights[k + 1], foot]
        axes.fill(ruler.of(block), ruler.of(level), color=style.GREY, alpha=0.3, linewidth=0)
    for gap, film in zip(test.gaps, test.fit.films, strict=True):
        place, first = ruler.of(gap.x + gap.left_x + gap.span / 2), gap is test.gaps[0]
        look: dict[str, Any] = {"color": style.BLACK, "markersize": 2, "alpha": 0.5}
        axes.plot(place, ruler.of(gap.y + gap.left_y), ".", label="contour" if first else None, **look)
        fitted: dict[str, Any] = {"color": style.VERMILLION, "label": "fitted filament" if first else None}
        axes.plot(place, ruler.of(film.model + gap.left_y), linewidth=1.2, **fitted)
        sag = f"{length_unit(gap.span).text(gap.span)}\n{length_unit(max(gap.sag, 1e-9)).text(gap.sag)}"
        axes.annotate(sag, (float(place.mean()), 1.0), (0, 2), ("data", "axes fraction"), "offset points",
                      ha="center", va="bottom", fontsize=7)  # fmt: skip
    axes.set(xlabel=f"x [{ruler.symbol}], gaps and their sags above", ylabel=f"height [{ruler.symbol}]")
    axes.set_ylim(float(ruler.of(min(foot, *(float(gap.y.min()) + gap.left_y for gap in test.gaps)))))
    axes.legend(loc="lower right", fontsize=7.5)
    return figure


@styled()
def features_figure(
    time: Floats, midpoint: Floats, features: Features, closed: ClosedForm | None = None, title: str = "Features"
) -> Figure:
    """Draw the whole film on logarithmic axes, and beside it the stretch in which the oscillation is read."""
    sag = -midpoint
    clock, ruler = time_unit(float(time[-1])), length_unit(float(np.max(np.abs(sag))))
    below = f"{len(time)} frames of the midpoint · scatter {ruler.text(features.noise)}"
    notes = "\n".join(f"{name}: {text}" for name, text in feature_texts(time, midpoint, features, closed))
    figure, body = sheet(title, below, height=3.1, notes=notes)

    def draw(axes: Axes, at: Floats, depth: Floats, look: str = "-", **settings: Any) -> None:
        axes.plot(clock.of(at), ruler.of(depth), look, **settings)

    left, right = body.subplots(1, 2)
    shown, ringing = (time > 0) & (sag > 0), features.ringing
    at, deep = time[shown], sag[shown]
    draw(left, at, deep, ".", color=style.BLACK, markersize=2.5, alpha=0.5, label="frames")
    # Noise dominates the first frames: they do not extend the axis below a thousandth of the largest sag.
    low, high = max(float(deep.min()), 1e-3 * float(deep.max())), 1.5 * float(deep.max())
    fall = 0.5 * features.gravity * at**2
    inside = (fall > low) & (fall < high)
    draw(left, at[inside], fall[inside], ":", color=style.GREEN, label="free fall")
    if features.late is not None:
        dense = np.geomspace(features.late.first, features.late.last, 200)
        draw(left, dense, features.late.sag(dense), color=style.PURPLE, label="1/3 law")
    if features.t_high.value is not None:
        place = float(clock.of(features.t_high.value))
        left.axvline(place, color=style.GREY, linewidth=0.8)
        left.text(place, float(ruler.of(low)), " t_high", fontsize=7.5, color=style.GREY)
    if ringing is None:
        draw(right, time, sag, ".", color=style.BLACK, markersize=3, alpha=0.5, label="frames")
    else:
        first, last = ringing.stretch.time[[0, -1]]
        part, dense = (time >= first) & (time <= last), np.linspace(first, last, 1200)
        draw(left, dense, ringing.curve(dense), color=style.VERMILLION, linewidth=1.0)
        draw(right, time[part], sag[part], ".", color=style.BLACK, markersize=3.5, label="frames")
        draw(right, dense, ringing.curve(dense), color=style.VERMILLION, linewidth=1.0, label="oscillation")
        draw(right, dense, ringing.trend(dense), "--", color=style.BLUE, linewidth=1.0, label="trend")
        middle, depth = np.array([ringing.middle]), np.array([ringing.sag])
        draw(right, middle, depth, "o", color=style.BLUE, markersize=5, label="R, d, H read")
    log_axes(left, xlim=clock.of(at[[0, -1]]), ylim=(float(ruler.of(low)) / 1.3, float(ruler.of(high))))
    left.set_ylabel(f"sag [{ruler.symbol}]")
    for axes in (left, right):
        axes.set_xlabel(f"time [{clock.symbol}]")
        axes.grid(True)
        axes.legend(loc="lower right", fontsize=7.5, frameon=True, framealpha=0.85, edgecolor="none")
    return figure


@styled()
def laws_figure(found: LawComparison) -> Figure:
    """Draw the residuals [m] of every law over time on one scale, the best law first.

    Residuals beyond the scale are crosses at its edge, so that one poor law does not flatten the residuals of the
    others.
    """
    rows = [row for row in found.choice.table if not row.law.failure]
    fits = [found.fits[row.law.name] for row in rows]
    left = [[film.model - film.measured for film in one.films] for one in fits]
    reaches = [max(float(np.abs(part).max()) for part in parts) or 1e-12 for parts in left]
    far = 1.1 * min(max(reaches), 3.0 * reaches[0])
    ruler = length_unit(far)
    figure, body = fit_sheet(found.best, found.sentence, 1.35 * len(rows) + 0.4)
    panels = body.subplots(len(rows), 1, squeeze=False).flat
    for axes, row, one, parts in zip(panels, rows, fits, left, strict=True):
        longest = max(one.films, key=lambda film: float(film.time.max()))
        axis = TimeAxis.of(longest.time, longest.model)
        axes.grid(True)
        axes.axhline(0.0, color=style.GREY, linewidth=0.8)
        for k, (film, part) in enumerate(zip(one.films, parts, strict=True)):
            time, height = axis.unit.of(film.time), ruler.of(np.clip(part, -far, far))
            for mark, chosen in ((".", np.abs(part) <= far), ("x", np.abs(part) > far)):
                if chosen.any():  # An empty line would widen the axis
                    color = (style.BLUE, *_COLORS)[k % 6]
                    axes.plot(time[chosen], height[chosen], mark, color=color, markersize=3.5, clip_on=False)
        axes.set_ylim(-float(ruler.of(far)), float(ruler.of(far)))
        axes.yaxis.set_major_locator(MaxNLocator(4, symmetric=True))
        axes.yaxis.set_major_formatter(FuncFormatter(plain))
        axis.dress(axes)
        above = f"criterion {row.difference:.1f} above the best" if row.difference else "least criterion"
        rms = length_unit(one.residual_std).text(one.residual_std)
        title = f"{row.law.name} · {above} · residuals {one.checks.verdict} · rms {rms}"
        axes.set_title(title, loc="left", fontsize=8.5, pad=3, parse_math=False)
        axes.label_outer()
    body.supylabel(f"residual [{ruler.symbol}]", fontsize=8)
    return figure


FIGURES = {
    "curves": curves_figure,
    "profiles": profiles_figure,
    "correlation": correlation_figure,
    "starts": starts_figure,
}
