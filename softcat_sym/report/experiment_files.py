"""All files of one design of an experiment."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from softcat_sym.files import write_all
from softcat_sym.report.canvas import png
from softcat_sym.report.critical_span import critical_span_csv, critical_span_document, critical_span_figure
from softcat_sym.report.experiment import experiment_figure

if TYPE_CHECKING:
    from softcat_sym.inverse.design import CriticalSpan, Experiment, Trial

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
    noise, limit = experiment.noise, experiment.sag_at_most
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

    Parameters
    ----------
    experiment : Experiment
        As from :func:`softcat_sym.inverse.design_experiment`.
    directory : str or pathlib.Path
        Where the files go; made if missing.
    critical : CriticalSpan, optional
        An entry of ``experiment.json``, ``critical_span.csv`` and ``critical_span.png``.

    Raises
    ------
    OSError
        If the directory cannot be made or written.
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
