"""Films that finite elements made: midpoints of a plane continuum, whose constants are known.

Each is run once and kept in the user's cache, as all of :mod:`tests.common.elements`; together they take a quarter of
an hour. `KNOWN` are those by which :mod:`softcat_sym.fitting.discrepancy` was measured, `HELD` were kept from it.
"""

from __future__ import annotations

from collections.abc import Mapping

from softcat_sym.reference.element_loop import Mesh
from softcat_sym.scene.reading import as_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.studies.theory_end import mesh_following
from tests.common.elements import Floats, elements

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


def film(name: str) -> tuple[Scene, Floats, Floats]:
    """The scene of a film, times [s] and heights of the midpoint [m] by elements; the start is left out."""
    scene = scene_of(name)
    mesh = FINER.get(name) or mesh_following(scene.filament.thickness / scene.filament.span)
    run = elements(scene, mesh)
    return scene, run.time[1:], run.midpoint[1:]
