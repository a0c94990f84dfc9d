"""What was read from a film of the midpoint, drawn on its frames."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.fitting.features import Features, Floats, Reading
from softcat_sym.plotting import style
from softcat_sym.plotting.style import HEADING, axes_in_inches, length_unit, new_figure, significant, time_unit

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.plotting.style import Unit

_LEFT, _RIGHT, _GAP, _TALL, _BOTTOM = 0.75, 0.2, 0.62, 2.7, 2.05


def features_figure(time: Floats, midpoint: Floats, features: Features, title: str = "Features") -> Figure:
    """Draw the whole film on logarithmic axes, and beside it the stretch in which the oscillation is read."""
    height = HEADING + _TALL + _BOTTOM
    sag = -midpoint
    clock, ruler = time_unit(float(time[-1])), length_unit(float(np.max(np.abs(sag))))
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        place = _LEFT / style.WIDTH
        heading = style.printable(title)
        figure.text(place, 1 - 0.12 / height, heading, va="top", fontsize=10.5, fontweight="bold", parse_math=False)
        below = f"{len(time)} frames of the midpoint · scatter {ruler.text(features.noise)}"
        figure.text(place, 1 - 0.33 / height, below, va="top", fontsize=8.5, color=style.GREY)
        wide = (style.WIDTH - _LEFT - _RIGHT - _GAP) / 2
        left = axes_in_inches(figure, _LEFT, _BOTTOM, wide, _TALL)
        right = axes_in_inches(figure, _LEFT + wide + _GAP, _BOTTOM, wide, _TALL)
        _draw_film(left, time, sag, features, clock, ruler)
        _draw_ringing(right, time, sag, features, clock, ruler)
        for axes in (left, right):
            axes.set_xlabel(f"time [{clock.symbol}]")
            axes.grid(True)
            style.lighten(axes)
            axes.legend(loc="lower right", fontsize=7.5, frameon=True, framealpha=0.85, edgecolor="none")
        left.set_ylabel(f"sag [{ruler.symbol}]")
        for k, line in enumerate(_lines(features, clock, ruler)):
            at = (_BOTTOM - 0.62 - 0.18 * k) / height
            figure.text(place, at, line, va="top", fontsize=8, parse_math=False)
    return figure


def _draw_film(axes: Axes, time: Floats, sag: Floats, features: Features, clock: Unit, ruler: Unit) -> None:
    from matplotlib.ticker import NullFormatter, StrMethodFormatter

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
