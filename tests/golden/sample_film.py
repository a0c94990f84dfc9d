"""The film that ``softcat samples`` copies: ``python -m tests.golden.sample_film`` renders it anew.

It is the fall of ``film.csv``, at 1000 frames a second: the ink of my-ink.toml across 10 mm, loaded within 20 ms, here
seven frames after the film begins.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

import softcat_sym as sc
from tests.common.rendered_films import MJPEG, film, simulated

FOLDER = Path(sc.__file__).parent / "samples"
SPAN, RATE, AT_REST = 400.0, 1000, 7
"""Span [px], frames a second, and frames before the release."""


def write(path: Path = FOLDER / "film.mov") -> Path:
    changes = {"filament.span": "10 mm", "load.ramp": "20 ms", "run.duration": "40 ms", "run.frames": 401}
    run = sc.simulate(sc.load_scene(FOLDER / "my-ink.toml", changes))
    depth = simulated(run.data, SPAN / 10e-3, AT_REST / RATE)
    picture = {"rows": 144, "columns": 480, "span": SPAN, "centre": 240.3, "level": 60.4, "thickness": 16.0}
    light = {"tilt": 0.01, "gradient": 0.2, "vignette": 0.2}
    film(path, MJPEG, **picture, **light, depth=depth, times=np.arange(AT_REST + 41) / RATE)
    return path


if __name__ == "__main__":
    print(write())
