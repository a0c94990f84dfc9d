"""Bias of the closed forms against the full model: a panel for every formula and slenderness."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.files import write_all
from softcat_sym.plotting import style
from softcat_sym.plotting.style import HEADING, axes_in_inches, new_figure, png
from softcat_sym.studies.closed_form_bias import FORMULAS, RESOLUTION, TOLERANCE, BiasPoint

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LEFT, _RIGHT, _GAP, _BETWEEN, _ROW, _BOTTOM = 1.25, 0.15, 0.12, 0.12, 1.45, 1.3
_FULL = 0.6
_UNREAD = "#f1f1f1"

_NAMES = {"(2.22)": "E by (2.22)", "sag": "E by R, d and sag", "cable": "E by cable mode", "eta": "η by 1/3 law"}

CAPTION = (
    "Bias of modulus and viscosity read from noise-free filaments of the full model (published theory; Maxwell; "
    "gravity switched on at once; 20 sqrt(L/g) filmed in 1001 frames, sag known to {resolution:g} of its final value), "
    "in percent. Outlined: within {tolerance:.0f} %. A dash: the film does not show what the formula needs, or it "
    "has no solution. (2.22) takes the time at which R is read for t_high, and the root that the decay picks."
)


def caption() -> str:
    """What is shown."""
    return CAPTION.format(resolution=RESOLUTION, tolerance=100 * TOLERANCE)


def closed_form_bias_figure(points: Sequence[BiasPoint]) -> Figure:
    """Draw the panels: formulas downwards, slenderness to the right; B across and tau upwards in each."""
    deltas = sorted({point.delta for point in points})
    rows = [*FORMULAS, "eta"]
    height = HEADING + len(rows) * _ROW + (len(rows) - 1) * _BETWEEN + _BOTTOM
    width = (style.WIDTH - _LEFT - _RIGHT - (len(deltas) - 1) * _GAP) / len(deltas)
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        left = 0.2 / style.WIDTH
        title = "Closed forms against the full model"
        figure.text(left, 1 - 0.12 / height, title, va="top", fontsize=10.5, fontweight="bold")
        for row, name in enumerate(rows):
            bottom = height - HEADING - (row + 1) * _ROW - row * _BETWEEN
            for column, delta in enumerate(deltas):
                axes = axes_in_inches(figure, _LEFT + column * (width + _GAP), bottom, width, _ROW)
                _draw(axes, [point for point in points if point.delta == delta], name)
                axes.tick_params(labelleft=column == 0, labelbottom=row == len(rows) - 1, length=0)
                if row == 0:
                    axes.set_title(f"δ = {delta:g}", fontsize=9)
                if row == len(rows) - 1:
                    axes.set_xlabel("B")
                if column == 0:
                    axes.set_ylabel("τ (g/L)^½", fontsize=8)
                    middle = (bottom + _ROW / 2) / height
                    figure.text(left, middle, _NAMES[name], rotation=90, va="center", fontsize=9)
        text = fill(caption(), 118)
        figure.text(left, (_BOTTOM - 0.52) / height, text, va="top", fontsize=7.5, parse_math=False)
    return figure


def bias_of(point: BiasPoint, name: str) -> float:
    """Relative bias of the modulus by a formula, or of ``"eta"``; NaN if it is not had."""
    return point.viscosity if name == "eta" else point.modulus[name]


def _draw(axes: Axes, points: Sequence[BiasPoint], name: str) -> None:
    from matplotlib import colormaps
    from matplotlib.patches import Rectangle

    loads, times = (sorted({getattr(point, key) for point in points}) for key in ("B", "tau_star"))
    colours = colormaps["RdBu_r"]
    for point in points:
        x, y = loads.index(point.B), times.index(point.tau_star)
        bias = bias_of(point, name)
        # Beyond the middle of the scale by half: text must stay legible on every colour.
        face = _UNREAD if math.isnan(bias) else colours(0.5 + 0.36 * float(np.clip(bias / _FULL, -1, 1)))
        axes.add_patch(Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor=face, edgecolor="white", linewidth=0.6))
        axes.text(x, y, _text(bias), ha="center", va="center", fontsize=6.5)
    for point in points:
        if abs(bias_of(point, name)) <= TOLERANCE:
            corner = (loads.index(point.B) - 0.46, times.index(point.tau_star) - 0.44)
            axes.add_patch(Rectangle(corner, 0.92, 0.88, fill=False, edgecolor=style.BLACK, linewidth=1.1))
    axes.set_xlim(-0.5, len(loads) - 0.5)
    axes.set_ylim(-0.5, len(times) - 0.5)
    axes.set_xticks(range(len(loads)), [f"{load:.0e}".replace("e-0", "e-") for load in loads])
    axes.set_yticks(range(len(times)), [f"{time:g}" for time in times])
    for spine in axes.spines.values():
        spine.set_visible(False)


def _text(bias: float) -> str:
    if math.isnan(bias):
        return "–"
    if bias > 9.995:
        return "≫"
    return f"{100 * bias:+.0f}".replace("-", "\N{MINUS SIGN}")


def closed_form_bias_csv(points: Sequence[BiasPoint]) -> bytes:
    """One row a filament: what was read, in units of L and sqrt(L/g), and every bias; empty where there is none."""
    names = ["delta", "B", "tau_star", "outcome", "time_read", "frequency", "decay", "sag"]
    lines = [",".join([*names, *(f"bias_{key}" for key in ("E_2_22", "E_sag", "E_cable", "eta"))]) + "\n"]
    for point in points:
        features = point.features
        unit = math.sqrt(features.span / features.gravity)
        ringing = features.ringing
        read = [ringing.middle / unit, ringing.frequency * unit, ringing.decay * unit] if ringing else [math.nan] * 3
        read += [ringing.sag / features.span] if ringing else [math.nan]
        biases = [bias_of(point, name) for name in (*FORMULAS, "eta")]
        numbers = ["" if math.isnan(value) else repr(float(value)) for value in (*read, *biases)]
        head = [repr(point.delta), repr(point.B), repr(point.tau_star), point.outcome]
        lines.append(",".join([*head, *numbers]) + "\n")
    return "".join(lines).encode()


def write_closed_form_bias(points: Sequence[BiasPoint], directory: str | Path) -> list[Path]:
    """Write ``closed_form_bias.png`` and ``closed_form_bias.csv``."""
    contents = {
        "closed_form_bias.png": png(closed_form_bias_figure(points)),
        "closed_form_bias.csv": closed_form_bias_csv(points),
    }
    return write_all(directory, contents)
