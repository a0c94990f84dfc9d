"""Discretization error of fitted constants: their shifts by grid, fibres and time steps, and what to refine."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.discretization.assembly import choose_cells
from softcat_sym.discretization.grid import choose_grading
from softcat_sym.effects.selection import Effects, choose_effects
from softcat_sym.error_control.estimate import (
    LOOSER,
    MORE,
    ORDER,
    SECTION_ORDER,
    TIGHTER,
    Differences,
    Resolution,
    resolution_of,
    with_more_fibres,
)
from softcat_sym.error_control.refinement import refined
from softcat_sym.errors import SceneError
from softcat_sym.fitting.identifiability import Information
from softcat_sym.fitting.least_squares import Floats, Optimum
from softcat_sym.fitting.problem import FilamentProblem, FilmReadings
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.settings import compiled_settings

SHARE = 1 / 3
"""Largest share of a standard error by which grid, fibres and time steps together may move a constant."""

_FRAMES = 201
_FEWEST_CELLS = 16
_FEWEST_HALVED = 8
_FIRST_ACCURACY = 0.01


@dataclass(frozen=True)
class Moved:
    """Shifts of the constants by the discretization error."""

    at: Resolution
    shifts: Floats  # shape (3, k); Of the free parameters, by grid, time steps and fibres; NaN where not known
    shares: Differences  # The largest of each over the standard errors, among identified parameters

    @property
    def total(self) -> Floats:
        """Sum of the three magnitudes for each free parameter, shape (k,)."""
        found: Floats = np.nansum(np.abs(self.shifts), axis=0)
        return found


def moved(problem: FilamentProblem, best: Optimum, known: Information) -> Moved:
    """Estimate the shifts by runs of the best fit on half the cells, with a looser tolerance and with more fibres."""
    shifts, found, offset = np.zeros((3, len(known.names))), list[Resolution](), 0
    for film in problem.films:
        scene, begin = film.run_scene(best.q)
        scene = scene.replace({"run.frames": _FRAMES})
        effects = choose_effects(scene)
        at = resolution_of(scene, effects, compiled=film.model.compiled)
        found.append(at)
        rows = np.zeros((best.residuals.size, 3))
        changes = np.array(_changes(film, scene, effects, at, begin)).T
        rows[offset : offset + film.data.size] = film.covariance.whitened(changes)
        offset += film.data.size
        shifts += np.linalg.lstsq(best.jacobian, rows, rcond=1e-8)[0].T
    first = found[0]
    sure = known.identified
    over = np.abs(shifts[:, sure]) / known.standard_errors[sure] if sure.any() else np.zeros((3, 1))
    space, time, section = (float(row.max()) if np.all(np.isfinite(row)) else None for row in over)
    return Moved(first, shifts, Differences(space, time, section if first.fibres else None, None, ()))


def beside_optimum(found: Moved, offset: float, known: Information) -> Moved:
    """Add the remaining distance to the optimum, in standard errors, to the shifts by time steps."""
    shifts = found.shifts.copy()
    shifts[1, known.identified] += offset * known.standard_errors[known.identified]
    return replace(found, shifts=shifts, shares=replace(found.shares, time=(found.shares.time or 0.0) + offset))


def first_look(scene: Scene) -> Scene:
    """The scene for the first rounds: on half the cells of a run, with time steps accurate to a hundredth of the sag.

    Values of either that the scene sets are kept.
    """
    effects = choose_effects(scene)
    if scene.numerics.rtol is None and scene.run.accuracy < _FIRST_ACCURACY:
        loose = scene.replace({"run.accuracy": _FIRST_ACCURACY})
        scene = scene.replace({"numerics.rtol": compiled_settings(loose, effects).rtol})
    if scene.numerics.cells is not None:
        return scene
    cells = max(_FEWEST_CELLS, choose_cells(scene, effects) // 2)
    changes = {
        "numerics.cells": cells,
        "numerics.grading": scene.numerics.grading or choose_grading(scene, cells, effects),
    }
    return scene.replace(changes)


def finer(found: Moved, given: Scene) -> Resolution | None:
    """Resolution of the next fit; None if the present one suffices, or if the scene fixes what would be refined."""
    if found.shares.total <= SHARE:
        return None
    effects = choose_effects(given)
    asked = given.model_copy(update={"run": given.run.model_copy(update={"accuracy": SHARE})})
    following = refined(found.at, found.shares, asked, lambda cells: choose_grading(given, cells, effects))
    return None if following == found.at else following


def _changes(film: FilmReadings, scene: Scene, effects: Effects, at: Resolution, begin: float) -> list[Floats]:
    """Error of the readings from grid, time steps and fibres each; NaN where a run has no answer."""
    # A grid too coarse to be halved is compared with a finer one, by the same formula.
    coarse = replace(at, cells=at.cells // 2 if at.cells >= _FEWEST_HALVED else 2 * at.cells)
    loose = replace(coarse, rtol=min(LOOSER * at.rtol, 0.5))
    fuller = with_more_fibres(coarse, MORE)
    curves = {one: _midpoint(one, scene) for one in {at, coarse, loose, fuller}}
    grid = 1 / ((at.cells / coarse.cells) ** ORDER - 1)
    steps = 1 / (LOOSER - 1)
    if np.isnan(curves[loose]).any():
        # The run with larger steps has no answer: compare with smaller steps instead.
        loose, steps = replace(coarse, rtol=TIGHTER * at.rtol), 1 / (1 - TIGHTER)
        curves[loose] = _midpoint(loose, scene)
    ratio = (fuller.fibres or 1) / (coarse.fibres or 1)
    section = 0.0 if fuller == coarse else 1 / (1 - ratio**-SECTION_ORDER)
    parts = [(at, coarse, grid), (loose, coarse, steps), (fuller, coarse, section)]
    frames = np.linspace(0.0, scene.run.duration, _FRAMES)
    size, result = max(float(np.max(np.abs(curves[at]))), np.finfo(float).tiny), []
    for one, other, factor in parts:
        change = np.interp(film.time - begin, frames, factor * (curves[one] - curves[other]))
        # Assumption: points of whole shapes err by the same share of their height as the midpoint.
        result.append(np.where(np.isnan(film.place), change, change / size * np.abs(film.data)))
    return result


def _midpoint(resolution: Resolution, scene: Scene) -> Floats:
    """Height of the midpoint [m], shape (frames,), NaN without an answer."""
    try:
        run = recalled(without_estimate(resolution.of(scene)))
    except SceneError:
        return np.full(_FRAMES, np.nan)
    found = run.outcome.is_success and run.data.time.size == _FRAMES
    return np.asarray(run.data["midpoint"].values if found else np.full(_FRAMES, np.nan))
