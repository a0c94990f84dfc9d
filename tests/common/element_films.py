"""Films that finite elements made: midpoints of a plane continuum, whose constants are known.

Some are on record (``tests/cases/elements.json``), as are centre lines of strands over gaps; ``python -m
tests.studies.elements`` makes the record, half a minute of the processor for a film. `KNOWN` are those by which
:mod:`softcat_sym.fitting.likelihood` was measured, `HELD` were kept from it.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from softcat_sym.reference.element_loop import Mesh
from softcat_sym.scene.reading import as_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.studies.theory_end import mesh_following
from tests.common.elements import Floats, elements
from tests.common.strand import Line, strand

Groups = Mapping[str, object]


def _bingham(delta: float, G: float, V: float, **more: object) -> Groups:
    return {"law": "bingham", "delta": delta, "G": G, "V": V, "duration": 460, **more}


def _maxwell(delta: float, V: float, **more: object) -> Groups:
    return {"law": "maxwell", "delta": delta, "V": V, "duration": 180, **more}


def _elastic(delta: float, **more: object) -> Groups:
    return {"law": "elastic", "delta": delta, "duration": 180, **more}


KNOWN: Mapping[str, Groups] = {
    "continual-descent": _bingham(0.03, 1.9, 26),
    "arrested-overdamped": _bingham(0.03, 0.4, 26),
    "descent, thin": _bingham(0.015, 1.9, 26),
    "descent, thick": _bingham(0.06, 1.9, 26),
    "descent, thickest": _bingham(0.1, 1.9, 26),
    "descent, viscous": _bingham(0.03, 1.9, 80),
    "descent, soft": _bingham(0.03, 1.9, 26, E_star=100, duration=140),
    "slow arrest": _bingham(0.03, 1, 26),
    "arrest, thin": _bingham(0.015, 0.7, 26),
    "arrest, thick": _bingham(0.06, 0.4, 26, duration=230),
    "ringing arrest": _bingham(0.03, 0.25, 2, duration=180),
    "Maxwell": _maxwell(0.03, 940),
    "Maxwell, thin": _maxwell(0.01, 200),
    "elastic": _elastic(0.03),
    "elastic, thick": _elastic(0.1),
}
HELD: Mapping[str, Groups] = {
    "held descent": _bingham(0.045, 2.5, 60),
    "held arrest": _bingham(0.02, 0.8, 15),
    "held Maxwell": _maxwell(0.05, 300),
    "held elastic": _elastic(0.02, E_star=300),
}
"""Groups by which a scene is made; E* is that of the paper's filament unless given, times are in L sqrt(rho/E)."""

FINER: Mapping[str, Mesh] = {
    "arrested-overdamped": Mesh(48, 6, grading=10.0),
    "arrest, thick": Mesh(48, 6, grading=4.0),
    "ringing arrest": Mesh(48, 6, grading=10.0),
}
"""Elements of a film, where 32 x 4 that follow the thickness are too coarse."""


def scene_of(name: str) -> Scene:
    """The scene of a film, narrow."""
    groups = {"ramp": 10, "time_unit": "elastic", **{**KNOWN, **HELD}[name]}
    run = {"accuracy": 0.001, "dimensions": 2}
    return as_scene({"title": name, "groups": groups, "run": run, "filament": {"width": "0.06 mm"}})


def by_elements(name: str) -> Floats:
    """Heights of the midpoint [m], without the start."""
    scene = scene_of(name)
    mesh = FINER.get(name) or mesh_following(scene.filament.thickness / scene.filament.span)
    return elements(scene, mesh).midpoint[1:]


def line_by_elements(span: float) -> Line:
    """Centre line [m] over a gap a second after the strand was laid: later the elements neck at their clamps."""
    run = elements(strand(span, {"run.duration": "1 s", "run.frames": 11}), Mesh(24, 4, grading=4.0))
    x, y = run.x[-1], run.y[-1]
    return np.array([*-x[:0:-1], *x]), np.array([*y[:0:-1], *y])


RECORD = Path(__file__).parents[1] / "cases" / "elements.json"


@cache
def record() -> dict[str, dict[str, Any]]:
    """Heights by film, and lines by span."""
    found: dict[str, dict[str, Any]] = json.loads(RECORD.read_text(encoding="utf-8"))
    return found


def film(name: str) -> tuple[Scene, Floats, Floats]:
    """The scene of a film on record, times [s] and heights of the midpoint [m]; the start is left out."""
    scene, heights = scene_of(name), np.array(record()["films"][name])
    return scene, scene.run.duration * np.arange(1, heights.size + 1) / heights.size, heights


def line(span: float) -> Line:
    """The centre line over a gap on record."""
    x, y = record()["lines"][f"{span:g}"]
    return np.array(x), np.array(y)
