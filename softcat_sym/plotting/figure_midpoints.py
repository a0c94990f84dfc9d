"""The paper's figure 3(b): the midpoint against time in every regime, elements and filaments."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.ticker import MaxNLocator

from softcat_sym.plotting import style
from softcat_sym.plotting.figure_files import facts, printed, table
from softcat_sym.plotting.style import axes_in_inches, new_figure
from softcat_sym.studies.paper_figures import MOMENTS, OWN, PAPER, PRINTED, THEORIES, scene_facts

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from softcat_sym.discretization.grid import Floats
    from softcat_sym.studies.paper_figures import FilmedScene

_WIDTH, _LEFT, _RIGHT, _GAP = 9.6, 0.72, 0.15, 0.62
_PANEL, _TOP, _BETWEEN, _BOTTOM = 2.15, 0.35, 0.72, 2.05

_ELEMENTS: dict[str, Any] = {"color": style.BLACK, "linewidth": 3.2, "alpha": 0.35, "solid_capstyle": "butt"}
_LINES: dict[str, dict[str, Any]] = {
    PAPER: {"color": style.ORANGE, "linewidth": 1.2, "linestyle": (0, (5, 1.5))},
    PRINTED: {"color": style.VERMILLION, "linewidth": 1.1, "linestyle": (0, (1.5, 1.2))},
    OWN: {"color": style.BLUE, "linewidth": 1.0},
}
_COLOURS = (style.BLUE, style.GREEN, style.PURPLE, style.VERMILLION, style.ORANGE)

# The panel with all scenes has the paper's own parameters; ours of the underdamped arrest has a panel to itself.
_LEFT_OUT, _EDGE = "arrested-underdamped", "edge-of-rupture"

# Whose curves stay within a few per cent of one level: there is nothing to see above it.
_LEVEL, _SHOWN = "arrested-overdamped", 0.72

CAPTION = (
    "Figure 3(b). Height of the midpoint, delta = 0.03, gravity switched on over t~ = 10. Top left: the paper's four "
    "parameter sets, finite elements ({along} x {through} over the half span, plane stress) wide and pale, the "
    "filament by the paper's physics thin. Other panels: the elements against the paper's physics in both closures and "
    "against what the program chooses. G and V are the paper's; with its E, rho and L the yield strains are {strains} "
    "where the paper rounds to 0.07, 0.002, 0.0005. At t~ = 460 the paper's physics misses the elements by "
    "{over[0]:+.1f}\u00a0% (overdamped) and {descent[0]:+.1f}\u00a0% (descent), the program's choice by "
    "{over[1]:+.1f}\u00a0% and {descent[1]:+.1f}\u00a0%. Dotted level: the stopping depth (3.13). Sudden loading and "
    "creep carry the filament below it: the overdamped one to {deep:.4f} L, {beyond:.0f}\u00a0% past. With the "
    "paper's underdamped numbers (G = 0.4, V = 0.4) a neck is drawn out at the clamp: elements still stop on this "
    "mesh, at {edge:.3f} L, "
    "a little deeper on each finer one; filaments are refused as localised and drawn as far as the frame. At "
    "G = 0.25 the elements and the program's filament ring about the same sag, {ring[0]:.4f} and {ring[1]:.4f} L in "
    "the mean."
)


def caption(facts_of: Mapping[str, Mapping[str, Any]]) -> str:
    """The caption, every number from the runs."""
    over, descent, ring = (facts_of[name] for name in ("arrested-overdamped", "continual-descent", _LEFT_OUT))
    last = f"{MOMENTS[-1]:g}"
    deep = -over["midpoint_over_L"]["elements"][last]
    strains = ", ".join(
        f"{facts_of[name]['eps_Y']:.2g}" for name in ("no-yield", "arrested-overdamped", "continual-descent")
    )
    return CAPTION.format(
        along=over["mesh"][0],
        through=over["mesh"][1],
        strains=strains,
        over=_misses(over, last),
        descent=_misses(descent, last),
        deep=deep,
        beyond=100 * (deep / over["stopping_depth_over_L"]["paper"] - 1),
        edge=-facts_of[_EDGE]["midpoint_over_L"]["elements"][last],
        ring=[-(ring["midpoint_over_L"][name]["mean"] or np.nan) for name in ("elements", OWN)],
    )


def _misses(of: Mapping[str, Any], moment: str) -> list[float]:
    """Per cent by which the filaments sag more than the elements: the paper's physics, the program's choice."""
    heights = of["midpoint_over_L"]
    return [100 * ((heights[name][moment] or np.nan) / heights["elements"][moment] - 1) for name in (PAPER, OWN)]


def midpoints_figure(scenes: Sequence[FilmedScene]) -> Figure:
    """Draw the paper's axes with all scenes, then each scene by itself."""
    known = {filmed.of.name: scene_facts(filmed) for filmed in scenes}
    width = (_WIDTH - _LEFT - _RIGHT - 2 * _GAP) / 3
    height = _TOP + 2 * _PANEL + _BETWEEN + _BOTTOM
    with style.styled():
        figure = new_figure(_WIDTH, height)
        for k, filmed in enumerate((None, *scenes)):
            row, column = divmod(k, 3)
            bottom = height - _TOP - _PANEL - row * (_PANEL + _BETWEEN)
            axes = axes_in_inches(figure, _LEFT + column * (width + _GAP), bottom, width, _PANEL)
            if filmed is None:
                _together(axes, scenes)
            else:
                _alone(axes, filmed, known[filmed.of.name]["stopping_depth_over_L"]["paper"])
            axes.set_xlim(0, MOMENTS[-1])
            axes.grid(True)
            style.lighten(axes)
            if row == 1:
                axes.set_xlabel("t~ = (t/L) √(E/ρ)")
            if column == 0:
                axes.set_ylabel("y / L of the midpoint")
        handles, labels = figure.axes[1].get_legend_handles_labels()
        place = (_LEFT / _WIDTH, (_BOTTOM - 0.78) / height)
        figure.legend(handles, labels, loc="lower left", bbox_to_anchor=place, ncols=4, borderaxespad=0.0)
        text = fill(caption(known), 158)
        figure.text(_LEFT / _WIDTH, (_BOTTOM - 0.88) / height, text, va="top", fontsize=7.2, parse_math=False)
    return figure


def _together(axes: Axes, scenes: Sequence[FilmedScene]) -> None:
    chosen = [filmed for filmed in scenes if filmed.of.name != _LEFT_OUT]
    for filmed, colour in zip(chosen, _COLOURS, strict=False):
        axes.plot(*filmed.elements, color=colour, linewidth=2.6, alpha=0.4)
        if filmed.filaments[PAPER].outcome.is_success:
            axes.plot(*filmed.filament(PAPER), color=colour, linewidth=0.9)
        time, height = filmed.elements
        # Named where there is room: beside the end of its curve, at its usual height.
        level = float(np.min(height[time > time[-1] / 2]))
        title = "arrested, underdamped" if filmed.of.name == _EDGE else filmed.of.title
        axes.text(455, level - 0.004, title, ha="right", va="top", fontsize=6.8, color=colour)
    axes.set_ylim(-0.27, 0.005)
    axes.set_title("the paper's parameters", fontsize=9)


def _alone(axes: Axes, filmed: FilmedScene, stop: float | None) -> None:
    time, height = filmed.elements
    deepest = float(-height.min())
    axes.plot(time, height, label="elements", **_ELEMENTS)
    refused = []
    for name in THEORIES:
        when, where = filmed.filament(name)
        axes.plot(when, where, label=name, **_LINES[name])
        if not filmed.filaments[name].outcome.is_success:
            refused.append(name)
    top = -_SHOWN * deepest if filmed.of.name == _LEVEL else 0.03 * deepest
    axes.set_ylim(-(1.45 if refused else 1.05) * deepest, top)
    if stop is not None and filmed.of.name != "no-yield":
        axes.axhline(-stop, color=style.GREY, linewidth=1.0, linestyle=":")
        axes.text(455, -stop, "(3.13)", ha="right", va="bottom", fontsize=7, color=style.GREY)
    if refused:
        which = "all filaments" if len(refused) == len(THEORIES) else "paper's physics"
        label = f"{which}: refused, localised"
        axes.text(455, -1.42 * deepest, label, fontsize=7, ha="right", va="bottom", color=style.GREY)
    axes.set_title(f"{filmed.of.title}: {filmed.of.parameters}", fontsize=8.3)
    axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))
    axes.yaxis.set_major_formatter("{x:.3g}")


def midpoint_files(scenes: Sequence[FilmedScene]) -> dict[str, bytes]:
    """Picture, data and facts of figure 3(b), by file name."""
    known = {filmed.of.name: scene_facts(filmed) for filmed in scenes}
    rows = (row for filmed in scenes for row in _rows(filmed))
    return {
        **printed("figure3b", midpoints_figure(scenes)),
        "figure3b.csv": table(("scene", "curve", "t_tilde", "midpoint_over_L"), rows),
        "figure3b.json": facts({"caption": caption(known), "scenes": list(known.values())}),
    }


def _rows(filmed: FilmedScene) -> Iterator[tuple[object, ...]]:
    curves: dict[str, tuple[Floats, Floats]] = {"elements": filmed.elements}
    curves |= {name.replace(",", " with"): filmed.filament(name) for name in THEORIES}
    for name, (time, height) in curves.items():
        for t, y in zip(time.tolist(), height.tolist(), strict=True):
            yield filmed.of.name, name, t, y
