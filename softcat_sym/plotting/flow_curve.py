"""A fitted flow curve: picture, tables, JSON."""

from __future__ import annotations

from itertools import cycle
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from softcat_sym.files import write_results
from softcat_sym.fitting.flow_curve import CONVERSION, FITTED, Floats
from softcat_sym.plotting import style
from softcat_sym.plotting.style import legend
from softcat_sym.plotting.terminal import text_table
from softcat_sym.plotting.units import significant

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.fitting.flow_curve import Candidate, FlowCurveFit
    from softcat_sym.fitting.identifiability import Estimate
    from softcat_sym.scene.scene import Scene

_LOOKS: tuple[tuple[str, Any, str], ...] = (
    (style.GREY, "-.", "v"),
    (style.BLUE, (0, (5, 1.5)), "s"),
    (style.GREEN, (0, (1.5, 1.2)), "^"),
    (style.VERMILLION, "-", "o"),
    (style.PURPLE, (0, (3, 1, 1, 1)), "D"),
)
"""Of the laws that are fitted, in their order."""


def flow_curve_figure(fit: FlowCurveFit) -> Figure:
    """Draw data and fitted laws on logarithmic axes, their relative residuals below."""
    curve = fit.curve
    title = curve.path.name if curve.path else "Flow curve"
    found = f"flow curve, {len(curve.shear_rate)} points · {fit.best.law} by the criterion · rms relative residuals"
    with style.styled():
        figure, body = style.sheet(title, found, height=5.2)
        above, below = body.subplots(2, 1, height_ratios=[3.4, 1])
        rate, order = curve.shear_rate, np.argsort(curve.shear_rate, kind="stable")
        dense = np.geomspace(rate.min(), rate.max(), 400)
        measured: dict[str, Any] = {"color": style.BLACK, "marker": "o", "markersize": 4.5, "linestyle": ""}
        above.plot(rate, curve.shear_stress, label="measured", alpha=0.6, **measured)
        below.axhline(0.0, color=style.GREY, linewidth=0.8)
        looks = {law.name: look for law, look in zip(FITTED, cycle(_LOOKS), strict=False)}
        for one in fit.candidates:
            color, dashes, marker = looks[one.law]
            percent = 100 * one.relative_rms
            name = f"{one.law} ({significant(percent) if percent >= 0.01 else '< 0.01'} %)"
            wide = 2.0 if one is fit.best else 1.2
            above.plot(dense, one.stress(dense), label=name, color=color, linestyle=dashes, linewidth=wide)
            residual = 100 * one.residuals[order]
            below.plot(rate[order], residual, color=color, linewidth=0.8, marker=marker, markersize=3.0)
        _log(above, "y", np.concatenate([curve.shear_stress, *(one.fitted for one in fit.candidates)]))
        # Exact data leave rounding only, which is not worth a look.
        far = max(1.12 * max(float(np.abs(100 * one.residuals).max()) for one in fit.candidates), 1e-3)
        below.set_ylim(-far, far)
        below.yaxis.set_major_formatter("{x:.3g}")
        above.set_ylabel("shear stress [Pa]")
        below.set_ylabel("residual [%]")
        for axes in (above, below):
            _log(axes, "x", curve.shear_rate)
            axes.grid(True)
            style.lighten(axes)
        above.tick_params(labelbottom=False)
        below.set_xlabel("shear rate [1/s]")
        legend(body, "upper left", handles=above.get_legend_handles_labels()[0], ncols=4, handlelength=1.9)
    return figure


def _log(axes: Axes, which: Literal["x", "y"], values: Floats) -> None:
    """Make an axis logarithmic, with a little room and ticks written as plain numbers."""
    from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter, NullLocator, StrMethodFormatter

    low, high = float(np.log10(values.min())), float(np.log10(values.max()))
    room = max(0.04 * (high - low), 0.02)
    axes.set(**{f"{which}scale": "log"})
    axes.set(**{f"{which}lim": (10 ** (low - room), 10 ** (high + room))})
    axis = axes.xaxis if which == "x" else axes.yaxis
    if high - low < 0.7:
        # Powers of ten, or 1, 2 and 5 times them, would leave one tick or none.
        axis.set_major_locator(MaxNLocator(5))
        axis.set_minor_locator(NullLocator())
    else:
        axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if high - low < 2.5 else (1.0,), numticks=12))
    axis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axis.set_minor_formatter(NullFormatter())


def flow_curve_table(fit: FlowCurveFit) -> Table:
    """A row for each candidate, the best first."""
    header = ("law", "τ_Y [Pa]", "k [Pa sⁿ]", "n", "√3 τ_Y [Pa]", "K [Pa sⁿ]", "rms [%]", "above best")
    rows = [_row(one, fit) for one in fit.candidates]
    title = fit.curve.path.name if fit.curve.path else "Flow curve"
    caption = f"± 95 %; rms of the relative residuals; above best: of the criterion\n{CONVERSION}"
    looks: dict[str, Any] = {"right": range(1, len(header)), "whole": [0], "padding": (0, 1, 0, 0)}
    return text_table(header, rows, title=title, caption=caption, **looks)


def _row(one: Candidate, fit: FlowCurveFit) -> tuple[str, ...]:
    tensile = one.tensile
    return (
        one.law,
        _with_interval(one.tau_Y),
        _with_interval(one.k),
        _with_interval(one.n) if one.n else "1",
        "–" if tensile.yield_stress is None else significant(tensile.yield_stress),
        significant(tensile.viscosity),
        significant(100 * one.relative_rms),
        f"{one.criterion - fit.best.criterion:.1f}",
    )


def _with_interval(constant: Estimate | None) -> str:
    if constant is None:
        return "–"
    if constant.half_width is None:
        return f"{significant(constant.value)} (bound)" if constant.verdict == "on a bound" else "–"
    return f"{significant(constant.value)} ± {constant.half_width:.2g}"


def print_flow_curve(fit: FlowCurveFit, console: Console | None = None) -> None:
    """Print the table and the warnings."""
    from rich.console import Console
    from rich.text import Text

    screen = console or Console()
    screen.print(flow_curve_table(fit))
    for text in fit.warnings:
        screen.print(Text(f"warning: {text}", style="yellow"))


def write_flow_curve(
    fit: FlowCurveFit, directory: str | Path, law: str | None = None, scene: Scene | None = None
) -> list[Path]:
    """Write ``flow_curve.json``, ``flow_curve.csv``, ``flow_curve.png`` and, of a scene, ``scene.toml``."""
    contents = {
        "flow_curve.json": fit.to_dict(law),
        "flow_curve.csv": fit.to_frame().to_csv(index=False, lineterminator="\n"),
        "flow_curve.png": flow_curve_figure(fit),
        "scene.toml": None if scene is None else scene.to_toml(),
    }
    return write_results(directory, contents)
