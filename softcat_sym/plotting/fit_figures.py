"""Pictures of a fit: data and model, profiles, correlations, starts, features, laws."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.figure import Figure, SubFigure
from matplotlib.ticker import FuncFormatter, MaxNLocator

from softcat_sym.fitting.features import Features, Floats
from softcat_sym.plotting import style
from softcat_sym.plotting.fit_words import display_unit, feature_texts, noise_text
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


@styled()
def correlation_figure(fit: Fit) -> Figure | None:
    """Draw the matrix of the correlations of the estimates."""
    if not np.isfinite(fit.correlation[~np.eye(len(fit.correlation), dtype=bool)]).any():
        return None
    names, count = [free.name for free in fit.problem.free], len(fit.problem.free)
    figure, body = fit_sheet(fit, "correlations of the estimates", max(2.6, 0.8 * count))
    axes = body.subplots()
    drawn = axes.imshow(fit.correlation, cmap="RdBu_r", norm=Normalize(-1.0, 1.0))
    labels = [f"{name}\n{fit.parameters[name].verdict}" for name in names]
    axes.set_xticks(range(count), labels, rotation=0 if count < 5 else 90, parse_math=False)
    axes.set_yticks(range(count), labels, parse_math=False)
    for (row, column), value in np.ndenumerate(fit.correlation):
        text = f"{value:+.3f}".replace("-", "\N{MINUS SIGN}") if np.isfinite(value) else "–"
        axes.text(column, row, text, ha="center", va="center", color="white" if abs(value) > 0.7 else style.BLACK)
    body.colorbar(drawn, ax=axes, label="correlation", pad=0.02)
    return figure


_COLORS = (style.VERMILLION, style.BLUE, style.GREEN, style.PURPLE, style.ORANGE, style.SKY)


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
}
