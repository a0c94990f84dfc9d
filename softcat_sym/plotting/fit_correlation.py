"""How estimates depend on one another: joint 95 % regions and correlations of every pair."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.plotting import style
from softcat_sym.plotting.fit_panels import headed
from softcat_sym.plotting.style import HEADING, axes_in_inches

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from softcat_sym.fitting.fit import Fit

_LEFT, _RIGHT, _BOTTOM, _GAP = 0.3, 0.3, 0.45, 0.08
_LARGEST, _TALLEST = 1.7, 6.0

JOINT = 5.991
"""95 % quantile of chi^2 with two degrees of freedom."""

_FAR = 3.6


def correlation_figure(fit: Fit) -> Figure:
    """Draw the matrix of all pairs: below its diagonal regions in standard errors, above it correlations."""
    count = len(fit.problem.free)
    room = style.WIDTH - _LEFT - _RIGHT
    each = min(_LARGEST, (room - (count - 1) * _GAP) / count)
    height = HEADING + count * each + (count - 1) * _GAP + _BOTTOM
    with style.styled():
        figure = headed(fit, "joint 95 % regions in standard errors, and correlations of the estimates", height, _LEFT)
        for row in range(count):
            for column in range(count):
                left = _LEFT + column * (each + _GAP)
                foot = _BOTTOM + (count - 1 - row) * (each + _GAP)
                axes = axes_in_inches(figure, left, foot, each, each)
                axes.set_xticks([])
                axes.set_yticks([])
                if row == column:
                    _name(axes, fit, row, each)
                elif row > column:
                    _region(axes, fit, column, row)
                else:
                    _number(axes, float(fit.correlation[row, column]))
        _legend(figure, traced=bool(fit.profiles))
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
    axes.set_xlim(-_FAR, _FAR)
    axes.set_ylim(-_FAR, _FAR)


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


def _legend(figure: Figure, *, traced: bool) -> None:
    from matplotlib.lines import Line2D

    handles = [Line2D([], [], color=style.BLUE, label="linear theory")]
    if traced:
        handles.append(Line2D([], [], color=style.VERMILLION, label="profile of the column's parameter"))
        handles.append(Line2D([], [], color=style.PURPLE, label="profile of the row's"))
    figure.legend(handles=handles, loc="lower left", bbox_to_anchor=(_LEFT / style.WIDTH, 0.0), ncols=3, fontsize=7.5)
