"""The paper's figure 2: sag of Maxwell filaments on logarithmic axes, against every formula of section 2.2."""

from __future__ import annotations

import json
from collections.abc import Sequence
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.plotting import style
from softcat_sym.plotting.figure_files import printed
from softcat_sym.plotting.style import axes_in_inches, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.studies.paper_figures import Panel

_WIDTH, _LEFT, _RIGHT, _GAP = 9.6, 0.75, 0.2, 0.35
_PANEL, _BOTTOM, _TOP, _BETWEEN = 3.1, 1.85, 0.35, 0.75

_LINES: dict[str, Any] = {
    "full model": {"color": style.BLACK, "linewidth": 2.0},
    "reduced model (2.18)": {"color": style.SKY, "linewidth": 1.2, "linestyle": "--"},
    "free fall": {"color": style.GREEN, "linewidth": 1.2, "linestyle": ":"},
    "(2.20) from rest": {"color": style.BLUE, "linewidth": 1.2, "linestyle": "-."},
    "(2.20) as printed": {"color": style.BLUE, "linewidth": 0.8, "linestyle": ":"},
    "1/3 law": {"color": style.PURPLE, "linewidth": 1.2, "linestyle": ":"},
    "(2.21) integrated": {"color": style.ORANGE, "linewidth": 1.4},
    "(2.22)": {"color": style.VERMILLION, "linewidth": 1.2, "linestyle": "--"},
}

CAPTION = (
    "Figure 2. Sag of the midpoint of a Maxwell filament, gravity switched on at once, B = 3.3e-5; times in sqrt(L/g). "
    "Vertical lines: t_low and t_high. The curves of (2.21) and (2.22) carry three constants each, fitted to the full "
    "model over one and a half periods after t_high; (2.20) from rest starts at phi(0) = (6 B tau)^(1/3), the "
    "elastic string; as printed its constant is another, and the 1/3 law alone is nearer. "
    "Above, delta = 0.0025: at t_high tension carries {slender:.1f} times what bending does, and the filament falls "
    "freely, rings and follows the 1/3 law, as the text says. Below, delta = 0.025 as printed under the figure: "
    "tension carries only {thick:.2f} of what bending does at t_high, bending rules until t* of about 10, and neither "
    "the ringing of (2.22) nor the 1/3 law is what the filament does."
)


def caption(panels: Sequence[Panel]) -> str:
    """The caption, with the share of tension at t_high measured for both slendernesses."""
    shares = {panel.delta: panel.tension_over_bending for panel in panels}
    return CAPTION.format(slender=shares[min(shares)], thick=shares[max(shares)])


def maxwell_descent_figure(panels: Sequence[Panel]) -> Figure:
    """Draw the panels, two a row, with the caption below."""
    rows = (len(panels) + 1) // 2
    height = _TOP + rows * _PANEL + (rows - 1) * _BETWEEN + _BOTTOM
    width = (_WIDTH - _LEFT - _RIGHT - _GAP) / 2
    with style.styled():
        figure = new_figure(_WIDTH, height)
        for k, panel in enumerate(panels):
            row, column = divmod(k, 2)
            bottom = height - _TOP - _PANEL - row * (_PANEL + _BETWEEN)
            axes = axes_in_inches(figure, _LEFT + column * (width + _GAP), bottom, width, _PANEL)
            _draw(axes, panel, first=column == 0, last=row == rows - 1)
        handles, labels = figure.axes[0].get_legend_handles_labels()
        place = (_LEFT / _WIDTH, (_BOTTOM - 0.9) / height)
        figure.legend(handles, labels, loc="lower left", bbox_to_anchor=place, ncols=4, borderaxespad=0.0)
        text = fill(caption(panels), 152)
        figure.text(_LEFT / _WIDTH, (_BOTTOM - 1.0) / height, text, va="top", fontsize=7.5, parse_math=False)
    return figure


def _draw(axes: Axes, panel: Panel, *, first: bool, last: bool) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    for curve in panel.curves:
        shown = (curve.sag > 0) & (curve.time > 0)
        axes.plot(curve.time[shown], curve.sag[shown], label=curve.name, **_LINES[curve.name])
    deepest = max(float(np.max(curve.sag)) for curve in panel.curves[:2])
    axes.set_xlim(0.02, 20)
    axes.set_ylim(1.5e-4, 2.2 * deepest)
    for time, name, side in ((panel.t_low, "t_low", "right"), (panel.t_high, "t_high", "left")):
        axes.axvline(time, color=style.GREY, linewidth=0.8)
        axes.text(time * (0.95 if side == "right" else 1.06), 1.8e-4, name, ha=side, fontsize=7.5, color=style.GREY)
    axes.set_title(f"tau* = {panel.tau_star:g}, delta = {panel.delta:g}", fontsize=9)
    axes.grid(True)
    style.lighten(axes)
    if last:
        axes.set_xlabel("t* = t sqrt(g/L)")
    if first:
        axes.set_ylabel("sag / L")
    else:
        axes.tick_params(labelleft=False)


def maxwell_descent_files(panels: Sequence[Panel]) -> dict[str, bytes]:
    """Picture, data and facts of figure 2, by file name."""
    lines = ["delta,tau_star,curve,time_star,sag_over_span\n"]
    for panel in panels:
        for curve in panel.curves:
            head = f'{panel.delta!r},{panel.tau_star!r},"{curve.name}"'
            pairs = zip(curve.time.tolist(), curve.sag.tolist(), strict=True)
            lines += [f"{head},{time!r},{sag!r}\n" for time, sag in pairs]
    facts = {
        "caption": caption(panels),
        "panels": [
            {
                "delta": panel.delta,
                "tau_star": panel.tau_star,
                "t_low": panel.t_low,
                "t_high": panel.t_high,
                "tension_over_bending_at_t_high": panel.tension_over_bending,
                "outcomes": panel.outcomes,
            }
            for panel in panels
        ],
    }
    return {
        **printed("figure2", maxwell_descent_figure(panels)),
        "figure2.csv": "".join(lines).encode(),
        "figure2.json": (json.dumps(facts, indent=2) + "\n").encode(),
    }
