"""Where the one-dimensional theory ends: its error against finite elements as one variable of a scene changes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.effects import choose_effects
from softcat_sym.errors import SoftcatError
from softcat_sym.reference import Clamp, ElementRun, Mesh, run_elements
from softcat_sym.reference.checkpoint import fingerprint
from softcat_sym.reference.element_loop import element_sources
from softcat_sym.reference.point_code import point_code
from softcat_sym.reference.problem import problem_of
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.study.compare import Comparison, FilamentRow, Listening, compare
from softcat_sym.study.discrepancy import aligned
from softcat_sym.study.theory_end_error import RelativeError, relative_error
from softcat_sym.study.theory_end_limit import Limit, slender_limit
from softcat_sym.study.theory_end_mesh import coarser, mesh_following
from softcat_sym.study.theory_end_values import Variation, number_at

if TYPE_CHECKING:
    from softcat_sym.scene import Scene

SLENDER = ("groups.delta", "filament.thickness")
"""Variables that tend to the slender limit when they go to zero."""

_TIGHTER = 0.1
_MOST_STEPS = 5_000
"""A run that takes more of them runs away; on a finer grid it would hardly end."""


@dataclass(frozen=True)
class TheoryError:
    """One theory at one value of the variable.

    Attributes
    ----------
    row : FilamentRow
        Its run as the program chooses cells and tolerance: what it costs.
    error : RelativeError
        Of the same theory with twice the cells and a tenth of the tolerance, against the finer elements; of the
        program's own run where that is not to be trusted, or runs away.
    grid : float
        Largest change of that error, in magnitude, when the program's own cells and tolerance are taken; NaN
        where there is no other.
    """

    row: FilamentRow
    error: RelativeError
    grid: float


@dataclass(frozen=True)
class Measured:
    """One value of the variable.

    Attributes
    ----------
    text : str
        As it was written.
    value : float
        As a number.
    comparison : Comparison
        The finer elements, and the filaments as the program runs them.
    coarse : ElementRun
        Half as many elements both ways.
    mesh : RelativeError
        Of the coarser elements against the finer, as though they were a theory.
    theories : tuple of TheoryError
        In the order of ``comparison.filaments``.
    """

    text: str
    value: float
    comparison: Comparison
    coarse: ElementRun
    mesh: RelativeError
    theories: tuple[TheoryError, ...]


@dataclass(frozen=True)
class Unmeasured:
    """A value at which the elements, or a filament, could not be run.

    Attributes
    ----------
    text : str
        As it was written.
    value : float
        As a number.
    reason : str
        Why.
    """

    text: str
    value: float
    reason: str


@dataclass(frozen=True)
class TheoryEnd:
    """Errors of the one-dimensional theories over one variable.

    Attributes
    ----------
    scene : Scene
        What was asked, before it was varied.
    variation : Variation
        The variable and its values.
    measured : tuple of Measured
        By increasing value.
    unmeasured : tuple of Unmeasured
        By increasing value.
    limits : dict of str to tuple of Limit or None
        By theory, at the moments of :class:`RelativeError`; empty unless the variable is the thickness.
    """

    scene: Scene
    variation: Variation
    measured: tuple[Measured, ...]
    unmeasured: tuple[Unmeasured, ...]
    limits: dict[str, tuple[Limit | None, ...]]

    @property
    def names(self) -> tuple[str, ...]:
        """Theories that were run at any value, the scene's own first."""
        every = (theory.row.name for one in self.measured for theory in one.theories)
        return tuple(dict.fromkeys(every))


def where_theory_ends(
    scene: Scene,
    variation: Variation,
    scene_with: Callable[[str], Scene],
    folder: Path,
    *,
    along: int = 32,
    through: int = 4,
    clamp: Clamp = Clamp.THINNING,
    progress: Callable[[str, Scene], Listening] | None = None,
) -> TheoryEnd:
    """Run elements on two meshes, and the filament in each of its theories, at every value of a variable.

    Parameters
    ----------
    scene : Scene
        As it is without the variation.
    variation : Variation
        What is varied.
    scene_with : callable
        The scene with one change, ``path=value``.
    folder : pathlib.Path
        Where the elements keep their states; made if need be. What is finished there is not run again.
    along, through : int
        The finer mesh; its grading follows the thickness, the coarser has half of both.
    clamp : Clamp
        What the clamped face of the elements may do.
    progress : callable, optional
        Given the value and its scene, what is told about its runs.

    Raises
    ------
    SceneError
        If a value makes no scene, or one that the elements or the filament cannot have; before anything is run.
    SoftcatError
        If the mesh cannot be halved, or nothing could be measured at any value.
    """
    cases = [(text, scene_with(change)) for text, change in variation.changes()]
    numbered = sorted((number_at(case, variation.path, text), text, case) for text, case in cases if _possible(case))
    meshes = [mesh_following(problem_of(case).thickness, along, through) for *_, case in numbered]

    def tried(value: float, text: str, case: Scene, mesh: Mesh) -> Measured | Unmeasured:
        listening = progress(f"{variation.path} = {text}", case) if progress else None
        try:
            return _measure(text, value, case, mesh, clamp, folder, listening)
        except SoftcatError as error:
            return Unmeasured(text, value, " ".join(str(error).split()))

    done = [tried(*one, mesh) for one, mesh in zip(numbered, meshes, strict=True)]
    return _sorted_out(scene, variation, done)


def _sorted_out(scene: Scene, variation: Variation, done: Sequence[Measured | Unmeasured]) -> TheoryEnd:
    measured = tuple(one for one in done if isinstance(one, Measured))
    unmeasured = tuple(one for one in done if isinstance(one, Unmeasured))
    if not measured:
        raise SoftcatError(f"{variation.path}: nothing could be compared; {unmeasured[0].reason}")
    limits = dict(_limits(measured)) if variation.path in SLENDER else {}
    return TheoryEnd(scene, variation, measured, unmeasured, limits)


def _possible(scene: Scene) -> bool:
    """Let the elements and the filament refuse the scene."""
    problem_of(scene)
    choose_effects(scene)
    return True


def _measure(
    text: str, value: float, scene: Scene, mesh: Mesh, clamp: Clamp, folder: Path, listening: Listening | None
) -> Measured:
    said = _prefixed(listening, f"{mesh.along} x {mesh.through} ")
    comparison = compare(scene, mesh, clamp=clamp, checkpoint=_place(folder, scene, mesh, clamp), progress=said)
    coarse = _coarse(scene, coarser(mesh), clamp, folder, listening)
    fine = comparison.elements
    theories = tuple(_theory(row, fine) for row in comparison.filaments)
    return Measured(
        text, value, comparison, coarse, relative_error(fine.time, coarse.midpoint, fine.midpoint), theories
    )


def _prefixed(listening: Listening | None, mesh: str) -> Listening | None:
    if listening is None:
        return None
    return lambda what: listening(f"{mesh}{what}" if what == "elements" else what)


def _coarse(scene: Scene, mesh: Mesh, clamp: Clamp, folder: Path, listening: Listening | None) -> ElementRun:
    place = _place(folder, scene, mesh, clamp)
    if listening is None:
        return run_elements(scene, mesh, clamp=clamp, checkpoint=place)
    with listening(f"{mesh.along} x {mesh.through} elements") as listener:
        return run_elements(scene, mesh, clamp=clamp, checkpoint=place, progress=listener)


def _place(folder: Path, scene: Scene, mesh: Mesh, clamp: Clamp) -> Path:
    problem = problem_of(scene)
    key = fingerprint(problem, mesh, clamp, 1.0, element_sources(point_code(problem.law)))
    return folder / f"{key}.npz"


def _theory(row: FilamentRow, elements: ElementRun) -> TheoryError:
    """Run a theory again on a grid and to a tolerance that no longer show."""
    run = row.trajectory
    chosen = relative_error(elements.time, row.midpoint, elements.midpoint)
    # What is not to be trusted is not made better by a finer grid.
    if not run.outcome.is_success or run.summary["steps"] > _MOST_STEPS:
        return TheoryError(row, replace(chosen, trusted=run.outcome.is_success), math.nan)
    finer = {"numerics.cells": 2 * run.summary["cells"], "numerics.rtol": _TIGHTER * run.summary["rtol"]}
    refined = simulated(without_estimate(run.scene.replace(finer)))
    time, own = refined.data["time"].values, refined.data["midpoint"].values
    error = relative_error(elements.time, aligned(time, own, elements.time), elements.midpoint)
    apart = np.abs(np.subtract(chosen.values, error.values))
    known = apart[np.isfinite(apart)]
    largest = float(known.max()) if known.size else math.nan
    return TheoryError(row, replace(error, trusted=refined.outcome.is_success), largest)


def _limits(measured: Sequence[Measured]) -> Iterator[tuple[str, tuple[Limit | None, ...]]]:
    delta = np.array([one.comparison.scene.filament.thickness / one.comparison.scene.filament.span for one in measured])
    names = dict.fromkeys(theory.row.name for one in measured for theory in one.theories)
    for name in names:
        errors = np.array([_errors_of(one, name) for one in measured])
        # Against the coarser elements every error is smaller by what lies between the meshes.
        meshes = np.array([one.mesh.values for one in measured])
        yield name, tuple(slender_limit(delta, errors[:, k], meshes[:, k]) for k in range(errors.shape[1]))


def _errors_of(one: Measured, name: str) -> tuple[float, ...]:
    """NaN at a value where the theory was not run, or not to be trusted."""
    for theory in one.theories:
        if theory.row.name == name and theory.error.trusted:
            return theory.error.values
    return (math.nan,) * len(one.mesh.values)
