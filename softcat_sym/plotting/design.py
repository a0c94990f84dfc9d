"""Pictures and files of critical spans, tables of bridges, and designed experiments."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from softcat_sym import drawing
from softcat_sym.design.bridges import BridgeTable
from softcat_sym.design.critical_span import CriticalSpan
from softcat_sym.design.experiment import Experiment
from softcat_sym.design.information import DURATION, FRAME_RATE, SPAN, THICKNESS
from softcat_sym.drawing import Report, TextTable
from softcat_sym.estimates.span import with_span
from softcat_sym.plotting import style
from softcat_sym.plotting.style import log_axes, plain_log
from softcat_sym.plotting.units import Unit, length_unit, time_unit

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene

_NAMES: dict[str, tuple[str, Callable[[float], Unit]]] = {
    SPAN: ("span", length_unit),
    THICKNESS: ("thickness", length_unit),
    DURATION: ("duration", time_unit),
    FRAME_RATE: ("frame rate", lambda _: Unit("s⁻¹", 1.0)),
}


@drawing.plot.register(Experiment)
@style.styled()
def experiment_figure(experiment: Experiment) -> Figure:
    """Draw the trials over two design variables, those that were open to choice first; colour is the worst error."""
    trials = (experiment.best, *experiment.tried)
    varied = [path for path in _NAMES if len({one.values[path] for one in experiment.tried}) > 1]
    worst = np.array([one.worst for one in trials])
    seen = np.isfinite(worst)
    title = "Worst relative standard error of the experiments that were tried"
    below = "a film of the best duration for each filament; crosses: no answer, or not determined"
    figure, body = style.sheet(title, below, height=3.9, notes="\n".join(experiment.text), columns=112)
    axes, places = body.subplots(), []
    for which, path in zip("xy", dict.fromkeys([*varied, *_NAMES]), strict=False):
        values, (name, unit_of) = np.array([one.values[path] for one in trials]), _NAMES[path]
        unit = unit_of(float(values.max()))
        places.append(unit.of(values))
        axes.set(**{f"{which}label": f"{name} [{unit.symbol}]"})
    x, y = places
    norm = LogNorm(worst[seen].min(), max(worst[seen].max(), 1.01 * worst[seen].min()))
    drawn = axes.scatter(x[seen], y[seen], c=worst[seen], norm=norm, cmap="viridis_r", s=36, linewidths=0)
    axes.plot(x[~seen], y[~seen], "x", color=style.GREY, markersize=5)
    axes.plot(x[:1], y[:1], "o", markersize=11, fillstyle="none", color=style.VERMILLION)
    axes.margins(0.05)
    log_axes(axes)
    bar = body.colorbar(drawn, ax=axes, label="worst relative error", pad=0.02, aspect=22)
    plain_log(bar.ax.yaxis, lambda value: f"{100 * value:.3g} %")
    return figure


@drawing.plot.register(CriticalSpan)
@style.styled()
def critical_span_figure(found: CriticalSpan) -> Figure:
    """Draw sag over span as scanned, with the critical span; crosses at the top: the run has no answer."""
    spans, sags = np.array(found.scan).T
    finite = np.isfinite(sags) & (sags > 0)
    ruler, across = length_unit(found.sag), length_unit(found.span)
    below = "spans that were run; dashed: the limit; ring: the largest span, with its error; crosses: no answer"
    notes = "\n".join(found.text)
    figure, body = style.sheet("Largest span that sags less than a limit", below, height=3.4, notes=notes, columns=112)
    axes = body.subplots()
    axes.plot(across.of(spans[finite]), ruler.of(sags[finite]), ".-", color=style.BLUE, linewidth=1.0)
    top = np.full_like(spans[~finite], ruler.of(sags[finite].max()))
    axes.plot(across.of(spans[~finite]), top, "x", color=style.GREY, markersize=5)
    allowed = [ruler.of(found.limit.at(span)) for span in (spans.min(), spans.max())]
    axes.plot(across.of(spans[[0, -1]]), allowed, "--", color=style.GREY, linewidth=0.9)
    x, y, error = across.of(found.span), ruler.of(found.sag), across.of(found.error or 0.0)
    axes.errorbar(x, y, xerr=error, fmt="o", markersize=10, fillstyle="none", color=style.VERMILLION)
    log_axes(axes, xlabel=f"span [{across.symbol}]", ylabel=f"largest sag [{ruler.symbol}]")
    axes.margins(0.04)
    axes.grid(True)
    return figure


@drawing.plot.register(BridgeTable)
@style.styled()
def bridges_figure(table: BridgeTable) -> Figure:
    """Draw sag against gap, with the band of its error and the limit."""
    rows = [one for one in table.bridges if np.isfinite(one.sag)]
    gaps = np.array([one.length for one in table.bridges])
    limits = np.array([one.limit for one in table.bridges])
    drawn, sags = np.array([one.length for one in rows]), np.array([one.sag for one in rows])
    errors = np.nan_to_num(np.array([one.error for one in rows]))
    ruler, across = length_unit(float(max([*sags, *limits]))), length_unit(float(gaps.max()))
    below = "points: bridges that were run; band: error of the sag; dashed: the limit; crosses: no answer"
    figure, body = style.sheet("Sag against gap", below, height=3.2, notes=table.text[0], columns=112)
    axes = body.subplots()
    axes.fill_between(across.of(drawn), ruler.of(sags - errors), ruler.of(sags + errors), color=style.SKY, alpha=0.4)
    axes.plot(across.of(drawn), ruler.of(sags), ".-", color=style.BLUE, linewidth=1.0)
    axes.plot(across.of(gaps), ruler.of(limits), "--", color=style.GREY, linewidth=0.9)
    lost = np.setdiff1d(gaps, drawn)
    axes.plot(across.of(lost), np.zeros_like(lost), "x", color=style.GREY, markersize=5)
    axes.set(xlabel=f"gap [{across.symbol}]", ylabel=f"largest sag [{ruler.symbol}]", ylim=(0.0, None))
    axes.margins(x=0.04)
    axes.grid(True)
    return figure


@drawing.report.register(BridgeTable)
def bridges_report(table: BridgeTable) -> Report:
    """The longest bridge in a line, and a row for each; with the fields of two slicers."""
    rows = table.bridges
    ruler = length_unit(max((one.sag for one in rows if np.isfinite(one.sag)), default=rows[0].limit))
    across = length_unit(rows[-1].length)
    cells = [
        (
            across.text(one.length),
            ruler.text(one.sag) if np.isfinite(one.sag) else "–",
            ruler.text(one.error) if np.isfinite(one.error) else "–",
            one.within,
            "–" if one.settled is None else time_unit(one.settled).text(one.settled),
            one.outcome,
        )
        for one in rows
    ]
    headings = ("length", "largest sag", "error", "within limit", "settled", "outcome")
    looks = {"yes": "", "no": "red", "undecided": "yellow", "no answer": "dim"}
    shown = TextTable(headings, cells, (0, 1, 2, 4), [looks[one.within] for one in rows], "Bridges")
    files = {
        "bridges.csv": table.to_frame,
        "bridges.json": table.to_dict,
        "bridges.png": partial(bridges_figure, table),
        "orcaslicer.txt": table.slicer_fields("OrcaSlicer"),
        "superslicer.ini": table.slicer_fields("SuperSlicer"),
        "scene.toml": table.scene.to_toml,
    }
    return Report(files, [*table.text, shown])


@drawing.report.register(Experiment)
def experiment_report(experiment: Experiment) -> Report:
    """The experiment in sentences, with the scene of the best one."""
    files = {
        "experiment.json": experiment.to_dict,
        "scene.toml": experiment.scene.to_toml,
        "experiment.csv": experiment.to_frame,
        "experiment.png": partial(experiment_figure, experiment),
    }
    return Report(files, experiment.text)


@drawing.report.register(CriticalSpan)
def span_report(found: CriticalSpan, scene: Scene) -> Report:
    """The longest span in a line, and what limits it; with the scene that has it."""
    files = {
        "span.json": found.to_dict(),
        "span.csv": found.to_frame,
        "span.png": partial(critical_span_figure, found),
        "scene.toml": with_span(scene, found.span).to_toml,
    }
    return Report(files, found.text)
