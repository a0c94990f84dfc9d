"""The clamped rod in this package, and the runs of both codes from which their work-precision diagrams are drawn."""

from __future__ import annotations

import time

import numpy as np

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.plotting.accuracy import WorkCurve, WorkPoint
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence

from .pyelastica_rod import DENSITY, GRAVITY, POISSON, RADIUS, SPAN, TIMES, Array, Fall, Rod, fall, set_up

EFFECTS = (
    "inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear", "rotary-inertia",
)  # fmt: skip
"""All that an elastic rod can have; what PyElastica's rod has, too."""
_FRAMES = [1, 2, 4]
"""Of the five over 0.2 s, those at ``TIMES``."""
_CELLS, _TOLERANCES = (5, 10, 20, 40, 80, 160), (3e-2, 1e-2, 1e-3, 1e-4)
_ELEMENTS, _FRACTIONS = (10, 20, 40, 80, 160, 320, 640), (0.95, 0.5)
KNOWN = 1e-6
"""To this part of the sag the converged answers are known: smaller errors are not told apart."""
_QUICK, _REPEATS = 0.5, 5


def filament(E: float, cells: int, rtol: float) -> Fall:
    """The rod as this package solves it: seconds of the solve stage, the best of five runs if they are short."""
    prepared = build(_scene(E, cells, rtol), choose_effects(_scene(E, cells, rtol)))
    row = prepared.graph.x_kinds.index("y")
    prepared.solve(Silence())
    seconds = []
    while len(seconds) < _REPEATS and sum(seconds) < _QUICK:
        began = time.process_time()
        solution = prepared.solve(Silence())
        seconds.append(time.process_time() - began)
    return Fall(SPAN * np.asarray(solution.x[row, _FRAMES]).ravel(), min(seconds))


def _scene(E: float, cells: int, rtol: float) -> sc.Scene:
    return sc.Scene.model_validate(
        {
            "filament": {
                "span": f"{SPAN} m",
                "thickness": f"{2 * RADIUS} m",
                "section": "circle",
                "density": f"{DENSITY} kg/m^3",
            },
            "material": {"law": "elastic", "youngs_modulus": f"{E!r} Pa", "poisson": POISSON},
            "load": {"gravity": f"{GRAVITY} m/s^2"},
            "run": {"duration": f"{TIMES[-1]} s", "frames": 5, "effects": list(EFFECTS)},
            "numerics": {"cells": cells, "rtol": rtol},
        }
    )


def peer(elements: int, E: float, fraction: float, kind: Rod) -> Fall:
    """The rod as PyElastica solves it, the best of five runs if they are short."""
    runs = [fall(elements, E, fraction, kind)]
    while len(runs) < _REPEATS and sum(run.seconds for run in runs) < _QUICK:
        runs.append(fall(elements, E, fraction, kind))
    return Fall(runs[0].midpoints, min(run.seconds for run in runs))


def setting_up(E: float) -> tuple[float, float]:
    """Seconds of the processor before either code takes its first step, kernels and compiled rod at hand: ours, its."""
    asked, spent = _scene(E, 20, 1e-2), []
    for prepare in (lambda: build(asked, choose_effects(asked)), lambda: set_up(80, E, "second order")):
        runs = []
        for _ in range(_REPEATS):
            began = time.process_time()
            prepare()
            runs.append(time.process_time() - began)
        spent.append(min(runs))
    return spent[0], spent[1]


def error_of(found: Array, converged: Array) -> float:
    """Largest error of the three midpoints over the largest sag, at least ``KNOWN``; NaN past the stability limit."""
    worst = np.max(np.abs(found - converged)) / np.max(np.abs(converged))
    return max(float(worst), KNOWN) if np.isfinite(worst) and worst < 0.3 else float("nan")


def extrapolated(coarse: Array, fine: Array) -> Array:
    """Limit of a second-order sequence from a grid and one twice as fine."""
    return fine + (fine - coarse) / 3


def our_limit(E: float) -> Array:
    """Midpoints of this package for vanishing cells and steps."""
    coarse, fine = (filament(E, cells, 1e-6).midpoints for cells in (80, 160))
    return extrapolated(coarse, fine)


def peer_limit(E: float, kind: Rod) -> Array:
    """Midpoints of PyElastica for vanishing elements and steps, with the clamps of second order."""
    coarse, fine = (fall(elements, E, 0.5, kind).midpoints for elements in (400, 800))
    return extrapolated(coarse, fine)


def our_curve(E: float, converged: Array) -> WorkCurve:
    """Every grid with every tolerance."""
    points = []
    for cells in _CELLS:
        for rtol in _TOLERANCES:
            run = filament(E, cells, rtol)
            points.append(WorkPoint(run.seconds, error_of(run.midpoints, converged), f"{cells} cells, rtol {rtol:g}"))
    return WorkCurve("softcat_sym", tuple(points))


def peer_curve(E: float, converged: Array, kind: Rod, name: str) -> WorkCurve:
    """Every number of elements with every share of the largest step."""
    points = []
    for elements in _ELEMENTS:
        for fraction in _FRACTIONS:
            run = peer(elements, E, fraction, kind)
            setting = f"{elements} elements, {fraction:g} of the largest step"
            points.append(WorkPoint(run.seconds, error_of(run.midpoints, converged), setting))
    return WorkCurve(name, tuple(points))
