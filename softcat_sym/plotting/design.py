"""Critical spans and designed experiments: pictures, tables and files."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path
from textwrap import fill
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from softcat_sym.design.experiment import Experiment
from softcat_sym.design.information import DURATION, FRAME_RATE, SPAN, THICKNESS, Trial
from softcat_sym.files import write_all
from softcat_sym.plotting import style
from softcat_sym.plotting.fit_figures import plain
from softcat_sym.plotting.style import HEADING, axes_in_inches, new_figure, png
from softcat_sym.plotting.units import length_unit

if TYPE_CHECKING:
    from softcat_sym.design.critical_span import CriticalSpan

_EXPERIMENT_LEFT, _EXPERIMENT_RIGHT, _EXPERIMENT_TALL = 0.85, 1.25, 3.4
_LABELS = {
    SPAN: ("span [mm]", 1e3),
    THICKNESS: ("thickness [mm]", 1e3),
    DURATION: ("duration [s]", 1.0),
    FRAME_RATE: ("frames a second", 1.0),
}
_EXPERIMENT_LINE = 0.17


def experiment_figure(experiment: Experiment) -> Figure:
    """Draw the trials over two design variables, those that were open to choice first; colour is the worst error."""
    text = [fill(sentence, 112) for sentence in experiment.text]
    lines = sum(paragraph.count("\n") + 1 for paragraph in text)
    bottom = 0.6 + _EXPERIMENT_LINE * lines
    height = HEADING + _EXPERIMENT_TALL + bottom
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        left = 0.2 / style.WIDTH
        title = "Worst relative standard error of the experiments that were tried"
        figure.text(left, 1 - 0.12 / height, title, va="top", fontsize=10.5, fontweight="bold")
        below = "a film of the best duration for each filament; crosses: no answer, or not determined"
        figure.text(left, 1 - 0.33 / height, below, va="top", fontsize=8.5, color=style.GREY)
        axes = axes_in_inches(
            figure, _EXPERIMENT_LEFT, bottom, style.WIDTH - _EXPERIMENT_LEFT - _EXPERIMENT_RIGHT, _EXPERIMENT_TALL
        )
        _draw(axes, experiment)
        written = "\n".join(text)
        figure.text(left, 0.1 / height, written, va="bottom", fontsize=7.5, linespacing=1.4, parse_math=False)
    return figure


def _draw(axes: Axes, experiment: Experiment) -> None:
    across, up = _open_to_choice(experiment.tried)
    places = [tuple(one.values[path] * _LABELS[path][1] for path in (across, up)) for one in experiment.tried]
    pairs = list(zip(places, experiment.tried, strict=True))
    good = [(place, one.worst) for place, one in pairs if math.isfinite(one.worst)]
    bad = [place for place, one in pairs if not math.isfinite(one.worst)]
    worst = [error for _, error in good]
    norm = LogNorm(min(worst), max(max(worst), 1.01 * min(worst)))
    at = np.array([place for place, _ in good])
    drawn = axes.scatter(at[:, 0], at[:, 1], c=worst, norm=norm, cmap="viridis_r", s=36, linewidths=0, clip_on=False)
    if bad:
        lost = np.array(bad)
        axes.plot(lost[:, 0], lost[:, 1], "x", color=style.GREY, markersize=5, clip_on=False)
    x, y = (experiment.best.values[path] * _LABELS[path][1] for path in (across, up))
    axes.plot([x], [y], "o", markersize=11, fillstyle="none", color=style.VERMILLION, clip_on=False)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.margins(0.05)
    for axis in (axes.xaxis, axes.yaxis):
        _plain(axis, lambda value: f"{value:g}")
    axes.set_xlabel(_LABELS[across][0])
    axes.set_ylabel(_LABELS[up][0])
    style.lighten(axes)
    side = axes.inset_axes((1.04, 0.0, 0.03, 1.0))
    bar = axes.figure.colorbar(drawn, cax=side, label="worst relative error")
    _plain(bar.ax.yaxis, lambda value: f"{100 * value:.3g} %")


def _plain(axis: Axis, text: Callable[[float], str]) -> None:
    """Write one, two and five of each decade as plain numbers, without Matplotlib's formulas."""
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: text(value)))
    axis.set_minor_formatter(NullFormatter())


def _open_to_choice(tried: tuple[Trial, ...]) -> tuple[str, str]:
    """The two design variables to be shown: the first two that vary."""
    order = (SPAN, THICKNESS, DURATION, FRAME_RATE)
    varied = [path for path in order if len({one.values[path] for one in tried}) > 1]
    both = [*varied, *(path for path in order if path not in varied)]
    return both[0], both[1]


_DESIGN_LEFT, _DESIGN_RIGHT, _DESIGN_TALL, _DESIGN_LINE = 0.85, 0.25, 2.9, 0.17


def critical_span_figure(found: CriticalSpan) -> Figure:
    """Draw sag over span as scanned, with the critical span; crosses at the top: the run has no answer."""
    text = [fill(sentence, 112) for sentence in found.text]
    bottom = 0.6 + _DESIGN_LINE * sum(paragraph.count("\n") + 1 for paragraph in text)
    height = HEADING + _DESIGN_TALL + bottom
    spans, sags = np.array(found.scan).T
    finite = np.isfinite(sags) & (sags > 0)
    ruler, across = length_unit(found.sag), length_unit(found.span)
    with style.styled():
        figure = new_figure(style.WIDTH, height)
        left = 0.2 / style.WIDTH
        title = "Largest span that sags less than a limit"
        figure.text(left, 1 - 0.12 / height, title, va="top", fontsize=10.5, fontweight="bold")
        below = "spans that were scanned; ring: the critical span; crosses: the filament has no answer"
        figure.text(left, 1 - 0.33 / height, below, va="top", fontsize=8.5, color=style.GREY)
        axes = axes_in_inches(figure, _DESIGN_LEFT, bottom, style.WIDTH - _DESIGN_LEFT - _DESIGN_RIGHT, _DESIGN_TALL)
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.plot(across.of(spans[finite]), ruler.of(sags[finite]), ".-", color=style.BLUE, linewidth=1.0)
        if not finite.all():
            top = np.full(int((~finite).sum()), float(ruler.of(sags[finite].max())))
            axes.plot(across.of(spans[~finite]), top, "x", color=style.GREY, markersize=5)
        axes.plot(
            [found.span / across.size], [found.sag / ruler.size], "o", markersize=10, fillstyle="none",
            color=style.VERMILLION,
        )  # fmt: skip
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(LogLocator(numticks=8))
            axis.set_major_formatter(FuncFormatter(plain))
            axis.set_minor_formatter(NullFormatter())
        axes.margins(0.04)
        axes.grid(True)
        axes.set_xlabel(f"span [{across.symbol}]")
        axes.set_ylabel(f"largest sag [{ruler.symbol}]")
        style.lighten(axes)
        figure.text(left, 0.1 / height, "\n".join(text), va="bottom", fontsize=7.5, linespacing=1.4, parse_math=False)
    return figure


def critical_span_csv(found: CriticalSpan) -> bytes:
    """Tabulate the scan [m], the critical span among it; an empty sag is no answer."""
    rows = sorted([(span, sag, "scanned") for span, sag in found.scan] + [(found.span, found.sag, "critical")])
    lines = [f"{span!r},{'' if math.isinf(sag) else repr(sag)},{what}\n" for span, sag, what in rows]
    return "".join(["span_m,sag_m,what\n", *lines]).encode()


def critical_span_document(found: CriticalSpan) -> dict[str, Any]:
    """Everything of a critical span that a program may want, in SI; the gradient is of logarithms."""
    return {
        "span_m": found.span,
        "sag_m": found.sag,
        "gradient": dict(found.gradient),
        "crossings_m": [list(pair) for pair in found.crossings],
        "effects": list(found.effects),
        "notes": list(found.notes),
        "text": list(found.text),
    }


_OF_SAG = ("critical_span.png", "critical_span.csv")


def experiment_csv(experiment: Experiment) -> bytes:
    """One row a trial in SI, the best and the scene as given first; errors are relative, of the camera's own in SI."""
    names = list(experiment.best.errors)
    head = ["what", "span_m", "thickness_m", "frame_rate_1_s", "duration_s", "frames", "sag_m", "worst"]
    lines = [",".join([*head, *(f"error_{name.rpartition('.')[2]}" for name in names), "note"]) + "\n"]
    rows = [("best", experiment.best), ("as given", experiment.as_given)]
    for what, one in [*rows, *(("tried", one) for one in experiment.tried)]:
        numbers = [one.span, one.thickness, one.frame_rate, one.duration, one.frames, one.sag, one.worst]
        numbers += [one.errors[name] for name in names]
        written = [repr(number) if math.isfinite(number) else "" for number in numbers]
        note = " ".join(one.note.split()).replace('"', "'")
        lines.append(",".join([what, *written, f'"{note}"']) + "\n")
    return "".join(lines).encode()


def experiment_document(experiment: Experiment, critical: CriticalSpan | None = None) -> dict[str, Any]:
    """Everything of a design that a program may want, in SI; null for an error that is infinite."""
    noise, limit = experiment.noise, experiment.max_sag
    found = {
        "best": _trial(experiment.best),
        "as_given": _trial(experiment.as_given),
        "gain": _finite(experiment.gain),
        "counted": list(experiment.counted),
        "noise_m": noise.of(experiment.best.sag),
        "noise_of_sag": noise.value if noise.of_sag else None,
        "rough": experiment.rough,
        "sag_at_most_m": None if limit is None else limit.at(experiment.best.span),
        "at_bounds": dict(experiment.at_bounds),
        "tried": len(experiment.tried),
        "text": list(experiment.text),
    }
    return found if critical is None else {**found, "critical_span": critical_span_document(critical)}


def write_experiment(experiment: Experiment, directory: str | Path, critical: CriticalSpan | None = None) -> list[Path]:
    """Write ``experiment.json``, ``scene.toml`` (the best experiment), ``experiment.csv`` and ``experiment.png``.

    Everything is drawn before anything is written, and each file replaces its predecessor whole.
    """
    document = experiment_document(experiment, critical)
    contents = {
        "experiment.json": (json.dumps(document, indent=2, allow_nan=False, ensure_ascii=False) + "\n").encode(),
        "scene.toml": experiment.scene.to_toml().encode(),
        "experiment.csv": experiment_csv(experiment),
        "experiment.png": png(experiment_figure(experiment)),
    }
    if critical is not None:
        contents |= dict(zip(_OF_SAG, (png(critical_span_figure(critical)), critical_span_csv(critical)), strict=True))
    written = write_all(directory, contents)
    for name in _OF_SAG:
        # Of an earlier design in the same folder.
        if name not in contents:
            (Path(directory) / name).unlink(missing_ok=True)
    return written


def _trial(one: Trial) -> dict[str, Any]:
    return {
        "span_m": one.span,
        "thickness_m": one.thickness,
        "frame_rate_1_s": one.frame_rate,
        "duration_s": one.duration,
        "frames": one.frames,
        "sag_m": _finite(one.sag),
        "worst": _finite(one.worst),
        "errors": {name: _finite(error) for name, error in one.errors.items()},
        "note": one.note,
    }


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None
