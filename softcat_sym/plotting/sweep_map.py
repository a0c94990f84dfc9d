"""Two varied keys on a grid: a map of the sag, with the boundaries between regimes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from matplotlib.colors import LogNorm, Normalize

from softcat_sym.plotting import style
from softcat_sym.plotting.phase_diagram import LOOKS
from softcat_sym.plotting.style import axes_in_inches, new_figure
from softcat_sym.plotting.sweep import NONE, DrawnAxis, drawn_axes, frame, key_of, leads, looks_of, regimes_of

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.discretization.grid import Floats

_LEFT, _PANEL, _TOP, _TALL, _BOTTOM, _BAR = 0.75, 4.75, 0.5, 4.0, 1.05, 0.16
_NOTHING = "#e6e6e6"
_FACTOR = 6.0
_NARROW = 0.2


def map_figure(data: xr.Dataset, title: str) -> Figure:
    """Draw largest sag over span over the plane of two keys, the first across."""
    across, upwards = drawn_axes(data)
    x, y = np.unique(across.values), np.unique(upwards.values)
    regimes, outcomes = regimes_of(data), data.outcome.values.astype(np.str_)
    places = (np.searchsorted(y, upwards.values), np.searchsorted(x, across.values))
    sag = np.full((len(y), len(x)), np.nan)
    sag[places] = data.sag_over_span.values
    marks = np.full((len(y), len(x)), "", dtype=regimes.dtype if regimes.dtype.itemsize else "<U1")
    marks[places] = regimes
    height = _TOP + _TALL + _BOTTOM
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        axes = axes_in_inches(figure, _LEFT, _BOTTOM, _PANEL, _TALL)
        edges = (_edges(x, log=across.is_log), _edges(y, log=upwards.is_log))
        axes.set_facecolor(_NOTHING)
        shown = np.ma.masked_invalid(sag)
        picture = axes.pcolormesh(*edges, shown, cmap="cividis", norm=_norm(sag), rasterized=True, zorder=1)
        across.dress(axes, "x")
        upwards.dress(axes, "y")
        axes.set_xlim(edges[0][0], edges[0][-1])
        axes.set_ylim(edges[1][0], edges[1][-1])
        _boundaries(axes, edges, marks)
        _names(axes, (across, upwards), (x, y), marks)
        bar = axes_in_inches(figure, _LEFT + _PANEL + 0.22, _BOTTOM, _BAR, _TALL)
        scale = figure.colorbar(picture, cax=bar)
        scale.set_label("largest sag / span")
        if isinstance(picture.norm, LogNorm):
            scale.ax.yaxis.set_major_formatter(lambda value, _: f"{value:g}")
            scale.ax.yaxis.set_minor_formatter(lambda value, _: f"{value:g}" if leads(value, (2, 5)) else "")
            scale.ax.tick_params(which="both", labelsize=8)
        frame(figure, title, key_of(regimes, outcomes, hollow=True), _LEFT)
    return figure


def _norm(sag: Floats) -> Normalize:
    """Colours by the logarithm where the sag goes over more than a factor."""
    known = sag[np.isfinite(sag)]
    if len(known) and float(np.min(known)) > 0 and float(np.max(known) / np.min(known)) > _FACTOR:
        return LogNorm(float(np.min(known)), float(np.max(known)))
    return Normalize()


def _edges(values: Floats, *, log: bool) -> Floats:
    """Edges of the pixels around values, half a step beyond the first and the last."""
    at = np.log(values) if log else values
    middles = (at[1:] + at[:-1]) / 2
    edges = np.concatenate([[2 * at[0] - middles[0]], middles, [2 * at[-1] - middles[-1]]])
    return np.asarray(np.exp(edges) if log else edges)


def _boundaries(axes: Axes, edges: tuple[Floats, Floats], marks: npt.NDArray[np.str_]) -> None:
    """A line along each edge between pixels of different regimes, light under dark: seen on every colour."""
    from matplotlib.collections import LineCollection

    x, y = edges
    lines = [[(x[i + 1], y[j]), (x[i + 1], y[j + 1])] for j, i in np.argwhere(marks[:, 1:] != marks[:, :-1])]
    lines += [[(x[i], y[j + 1]), (x[i + 1], y[j + 1])] for j, i in np.argwhere(marks[1:] != marks[:-1])]
    for colour, width in (("white", 2.6), (style.BLACK, 1.2)):
        axes.add_collection(
            LineCollection(lines, colors=colour, linewidths=width, zorder=3, capstyle="round"), autolim=False
        )


def _names(
    axes: Axes, drawn: tuple[DrawnAxis, DrawnAxis], values: tuple[Floats, Floats], marks: npt.NDArray[np.str_]
) -> None:
    """Marks of the regimes in every pixel of a small map, its names in the midst of their regions on every map."""
    x, y = np.meshgrid(*values)
    if marks.size <= 900:
        size = float(np.clip(2600 / marks.size, 3, 16))
        for name, (marker, _) in looks_of(marks.ravel().tolist()).items():
            there = marks == name
            axes.scatter(
                x[there], y[there], s=size, marker=marker, c="white", edgecolors=style.BLACK, linewidths=0.4, zorder=2
            )
    nothing = marks == ""
    axes.scatter(
        x[nothing],
        y[nothing],
        s=float(np.clip(4000 / marks.size, 2, 18)),
        marker=NONE[0],
        c=NONE[1],
        linewidths=0.7,
        zorder=2,
    )
    scales = [np.log if one.is_log else np.asarray for one in drawn]
    places = np.stack([_shares(scale(at)) for scale, at in zip(scales, (x, y), strict=True)], axis=-1)
    for name in looks_of(marks.ravel().tolist()):
        there = marks == name
        if there.sum() < 0.03 * marks.size:
            continue
        j, i = _midst(places, there)
        wide, tall = np.ptp(places[there], axis=0)
        words_up = 90.0 if wide < _NARROW and tall > 2 * wide else 0.0
        words = LOOKS[name].words if name in LOOKS else name
        box = {"boxstyle": "round,pad=0.2", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}
        axes.text(
            x[j, i],
            y[j, i],
            words if words_up else words.replace(", ", ",\n"),
            ha="center",
            va="center",
            rotation=words_up,
            fontsize=7.5,
            bbox=box,
            zorder=4,
            clip_on=True,
        )


def _shares(values: Floats) -> Floats:
    return np.asarray((values - values.min()) / ((values.max() - values.min()) or 1.0))


def _midst(places: Floats, there: npt.NDArray[np.bool_]) -> tuple[int, int]:
    """The pixel of a region that is farthest from everything else, the frame included."""
    inside = np.argwhere(there)
    apart = np.min(np.minimum(places[there], 1 - places[there]), axis=1) * 1.5
    outside = places[~there]
    if len(outside):
        step = max(1, len(outside) // 400)
        gaps = places[there][:, None, :] - outside[None, ::step, :]
        apart = np.minimum(apart, np.min(np.hypot(gaps[..., 0], gaps[..., 1]), axis=1))
    j, i = inside[int(np.argmax(apart))]
    return int(j), int(i)
