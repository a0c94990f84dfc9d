"""The posterior of a fit as a picture: densities of each parameter and of each pair."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from scipy.stats import gaussian_kde

from softcat_sym import drawing
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.fitting.posterior import Posterior
from softcat_sym.fitting.priors import Prior
from softcat_sym.fitting.result import Fit
from softcat_sym.plotting import style
from softcat_sym.plotting.fit_figures import fit_sheet, parameter_axis, parameter_label
from softcat_sym.plotting.style import legend, number_axis, styled
from softcat_sym.plotting.units import Unit

_GRID = 200
_COARSE = 60
_SHARES = (0.95, 0.5)
"""Of the draws, within the contours of a pair."""


@drawing.plot.register(Posterior)
@styled()
def posterior_figure(posterior: Posterior, fit: Fit) -> Figure:
    """Draw the density of each parameter on the diagonal, of each pair below it, and correlations above.

    Parameters
    ----------
    posterior : Posterior
        What was drawn.
    fit : Fit
        Whose best values and 95 % intervals are marked.
    """
    priors = posterior.priors
    count = len(priors)
    draws = [posterior.data.posterior[one.free.name].values.ravel() for one in priors]
    scaled = [
        np.array([one.free.scaled(x) for x in values.tolist()]) for one, values in zip(priors, draws, strict=True)
    ]
    outcome = f"posterior: {posterior.outcome.word} · {posterior.message}"
    figure, body = fit_sheet(fit, outcome, max(count * min(2.4, 6.9 / count), 2.6) + 0.4)
    panels: Any = body.subplots(count, count, squeeze=False)
    units = [_draw_one(panels[k, k], fit, one, draws[k], scaled[k]) for k, one in enumerate(priors)]
    for (row, column), axes in np.ndenumerate(panels):
        if row > column:
            for which, one in (("x", panels[column, column]), ("y", panels[row, row])):
                number_axis(axes, which, *one.get_xlim(), is_log=one.get_xscale() == "log", room=0.0)
            pair = (column, row)
            _draw_pair(axes, fit, [priors[k] for k in pair], [scaled[k] for k in pair], [units[k] for k in pair])
        elif row < column:
            axes.set_axis_off()
            text = f"{np.corrcoef(scaled[row], scaled[column])[0, 1]:+.3f}".replace("-", "\N{MINUS SIGN}")
            axes.text(0.5, 0.5, text, ha="center", va="center", fontsize=10, transform=axes.transAxes)
        if row >= column:
            is_last, is_first = row == count - 1, row > column == 0
            axes.set_xlabel(parameter_label(priors[column].free, units[column]) if is_last else "", fontsize=8)
            axes.set_ylabel(parameter_label(priors[row].free, units[row]) if is_first else "", fontsize=8)
            axes.tick_params(labelbottom=is_last, labelleft=is_first)
    handles: list[Any] = [
        Line2D([], [], color=style.BLUE, label="posterior"),
        Patch(color=style.SKY, alpha=0.3, linewidth=0, label="its 95 % interval"),
        Line2D([], [], color=style.GREY, linestyle="--", label="prior"),
        Line2D([], [], color=style.VERMILLION, label="best fit"),
        Line2D([], [], color=style.VERMILLION, linewidth=4, alpha=0.5, label="95 % interval of the fit"),
    ]
    legend(body, handles=handles, ncols=5)
    return figure


def _draw_one(axes: Axes, fit: Fit, prior: Prior, values: Floats, scaled: Floats) -> Unit:
    """Density of the draws, of the prior, and the fit's best value and interval."""
    free, found = prior.free, fit.parameters[prior.free.name]
    ends = [end for end in found.ci95 if end is not None]
    # The few draws far out would make the rest a line; what the fit says stays in sight, unless it is far away.
    low, high = np.quantile(values, [0.001, 0.999])
    near = [end for end in ends if low - (high - low) < end < high + (high - low)]
    reach = np.array([low, high, *near])
    unit = parameter_axis(axes, free, reach, found.best)
    q = np.linspace(free.scaled(float(reach.min())), free.scaled(float(reach.max())), _GRID)
    x = np.array([free.value(one) for one in q.tolist()])
    # Densities over the axis: of the logarithm where it is one.
    stretch = 1.0 if axes.get_xscale() == "log" else np.array([abs(free.slope(one)) for one in q.tolist()])
    density = (gaussian_kde(scaled)(q) if np.ptp(scaled) > 0 else np.ones_like(q)) / stretch
    before = np.exp([prior.log_density(one) for one in q.tolist()]) / stretch
    if prior.law is None:
        before = before / (prior.upper - prior.lower)
    low, high = np.quantile(values, [0.025, 0.975])
    inside = (x >= low) & (x <= high)
    axes.fill_between(unit.of(x[inside]), density[inside], color=style.SKY, alpha=0.3, linewidth=0)
    axes.plot(unit.of(x), density, color=style.BLUE)
    axes.plot(unit.of(x), before, color=style.GREY, linestyle="--", linewidth=1.0)
    top = 1.08 * float(density.max())
    axes.axvline(float(unit.of(found.best)), color=style.VERMILLION, linewidth=1.0)
    if len(ends) == 2:
        bar: dict[str, Any] = {"color": style.VERMILLION, "alpha": 0.5, "solid_capstyle": "butt"}
        axes.plot(unit.of(ends), [0.02 * top] * 2, linewidth=4, **bar)
    axes.set(ylim=(0.0, top), yticks=[])
    axes.spines["left"].set_visible(False)
    return unit


def _draw_pair(axes: Axes, fit: Fit, pair: list[Prior], scaled: list[Floats], units: list[Unit]) -> None:
    """Draws of two parameters, contours of their density, and the best fit."""
    shown = [
        unit.of([one.free.value(x) for x in values.tolist()])
        for one, values, unit in zip(pair, scaled, units, strict=True)
    ]
    axes.plot(*shown, ".", color=style.BLUE, markersize=1.5, alpha=0.35)
    cloud = np.array(scaled)
    if np.linalg.matrix_rank(np.cov(cloud)) == 2:
        kernel = gaussian_kde(cloud)
        limits = (axes.get_xlim(), axes.get_ylim())
        grids = [
            np.linspace(one.free.scaled(low * unit.size), one.free.scaled(high * unit.size), _COARSE)
            for one, unit, (low, high) in zip(pair, units, limits, strict=True)
        ]
        across, up = np.meshgrid(*grids)
        density = kernel(np.array([across.ravel(), up.ravel()])).reshape(across.shape)
        levels = np.quantile(kernel(cloud), [1 - share for share in _SHARES])
        x, y = (
            unit.of([one.free.value(q) for q in grid.tolist()])
            for one, unit, grid in zip(pair, units, grids, strict=True)
        )
        axes.contour(x, y, density, levels=levels, colors=style.BLUE, linewidths=(0.8, 1.2))
    best = [unit.of(fit.parameters[one.free.name].best) for one, unit in zip(pair, units, strict=True)]
    axes.plot(*best, "o", color=style.VERMILLION, markersize=4)
