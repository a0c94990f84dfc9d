"""Critical spans and designed experiments: pictures, tables and files."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from softcat_sym.design.experiment import Experiment
from softcat_sym.design.information import DURATION, FRAME_RATE, SPAN, THICKNESS, Trial
from softcat_sym.plotting import style
from softcat_sym.plotting.files import Quoted, csv_bytes, json_bytes, write_results
from softcat_sym.plotting.fit_figures import plain
from softcat_sym.plotting.style import plain_log
from softcat_sym.plotting.units import length_unit

if TYPE_CHECKING:
    from softcat_sym.design.critical_span import CriticalSpan

_LABELS = {
    SPAN: ("span [mm]", 1e3),
    THICKNESS: ("thickness [mm]", 1e3),
    DURATION: ("duration [s]", 1.0),
    FRAME_RATE: ("frames a second", 1.0),
}


def experiment_figure(experiment: Experiment) -> Figure:
    """Draw the trials over two design variables, those that were open to choice first; colour is the worst error."""
    title = "Worst relative standard error of the experiments that were tried"
    below = "a film of the best duration for each filament; crosses: no answer, or not determined"
    with style.styled():
        figure, body = style.sheet(title, below, height=3.9, notes="\n".join(experiment.text), columns=112)
        _draw(body.subplots(), experiment)
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
        plain_log(axis, subs=(1.0, 2.0, 5.0))
    axes.set_xlabel(_LABELS[across][0])
    axes.set_ylabel(_LABELS[up][0])
    style.lighten(axes)

    bar = axes.figure.colorbar(drawn, ax=axes, label="worst relative error", pad=0.02, aspect=22)
    plain_log(bar.ax.yaxis, lambda value: f"{100 * value:.3g} %", (1.0, 2.0, 5.0))


def _open_to_choice(tried: tuple[Trial, ...]) -> tuple[str, str]:
    """The two design variables to be shown: the first two that vary."""
    order = (SPAN, THICKNESS, DURATION, FRAME_RATE)
    varied = [path for path in order if len({one.values[path] for one in tried}) > 1]
    both = [*varied, *(path for path in order if path not in varied)]
    return both[0], both[1]


def critical_span_figure(found: CriticalSpan) -> Figure:
    """Draw sag over span as scanned, with the critical span; crosses at the top: the run has no answer."""
    spans, sags = np.array(found.scan).T
    finite = np.isfinite(sags) & (sags > 0)
    ruler, across = length_unit(found.sag), length_unit(found.span)
    title = "Largest span that sags less than a limit"
    below = "spans that were scanned; ring: the critical span; crosses: the filament has no answer"
    with style.styled():
        figure, body = style.sheet(title, below, height=3.4, notes="\n".join(found.text), columns=112)
        axes = body.subplots()
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.plot(across.of(spans[finite]), ruler.of(sags[finite]), ".-", color=style.BLUE, linewidth=1.0)
        if not finite.all():
            top = np.full(int((~finite).sum()), float(ruler.of(sags[finite].max())))
            axes.plot(across.of(spans[~finite]), top, "x", color=style.GREY, markersize=5)
        ring: dict[str, Any] = {"markersize": 10, "fillstyle": "none", "color": style.VERMILLION}
        axes.plot([found.span / across.size], [found.sag / ruler.size], "o", **ring)
        for axis in (axes.xaxis, axes.yaxis):
            plain_log(axis, plain, (1.0,))
        axes.margins(0.04)
        axes.grid(True)
        axes.set_xlabel(f"span [{across.symbol}]")
        axes.set_ylabel(f"largest sag [{ruler.symbol}]")
        style.lighten(axes)
    return figure


def critical_span_csv(found: CriticalSpan) -> bytes:
    """Tabulate the scan [m], the critical span among it; an empty sag is no answer."""
    rows = sorted([(span, sag, "scanned") for span, sag in found.scan] + [(found.span, found.sag, "critical")])
    return csv_bytes(("span_m", "sag_m", "what"), rows)


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


def experiment_csv(experiment: Experiment) -> bytes:
    """One row a trial in SI, the best and the scene as given first; errors are relative, of the camera's own in SI."""
    names = list(experiment.best.errors)
    head = ["what", "span_m", "thickness_m", "frame_rate_1_s", "duration_s", "frames", "sag_m", "worst"]
    head += [*(f"error_{name.rpartition('.')[2]}" for name in names), "note"]
    rows = []
    named = [("best", experiment.best), ("as given", experiment.as_given)]
    for what, one in [*named, *(("tried", one) for one in experiment.tried)]:
        numbers = (one.span, one.thickness, one.frame_rate, one.duration, one.frames, one.sag, one.worst)
        rows.append((what, *numbers, *(one.errors[name] for name in names), Quoted(" ".join(one.note.split()))))
    return csv_bytes(head, rows)


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
    """Write ``experiment.json``, ``scene.toml`` (the best experiment), ``experiment.csv`` and ``experiment.png``."""
    contents: dict[str, object] = {
        "experiment.json": json_bytes(experiment_document(experiment, critical), is_ascii=False),
        "scene.toml": experiment.scene.to_toml(),
        "experiment.csv": experiment_csv(experiment),
        "experiment.png": experiment_figure(experiment),
    }
    if critical is not None:
        contents["critical_span.png"] = critical_span_figure(critical)
        contents["critical_span.csv"] = critical_span_csv(critical)
    written = write_results(directory, contents)
    for name in ("critical_span.png", "critical_span.csv"):
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
