"""Limits of the one-dimensional theory: its error against finite elements as one variable of a scene changes."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext, suppress
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
import pandas as pd
from scipy.optimize import brentq

from softcat_sym.batch.members import is_group, is_number, written
from softcat_sym.batch.plan import read_axes
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Drawable
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.reference.element_loop import Clamp, Mesh, problem_of
from softcat_sym.reference.elements import ElementRun, recalled_elements
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.solution import Progress, Silence
from softcat_sym.studies.compare import Comparison, ComparisonRow, Listening, aligned, compare, late, moments

_FORM = "one variable, such as groups.delta=0.01,0.02,0.03 or groups.V=2.6:260:5:log"


@dataclass(frozen=True)
class Variation:
    """A variable and its values."""

    path: str  # Dotted path in the scene file
    texts: tuple[str, ...]  # Values as ``--set`` takes them, each once


def read_variation(scene: Scene, text: str) -> Variation:
    """Read ``path=value,value,...`` or ``path=first:last:number`` with or without ``:log``."""
    (axis,) = read_axes(scene, [text])
    values = (written(scene, {axis.key: value})[axis.key] for value in axis.values)
    texts = dict.fromkeys(f"{value:.12g}" if isinstance(value, float) else str(value) for value in values)
    if len(texts) < 2:
        raise SceneError([Fault("--vary", f"{text!r} has one value", _FORM)])
    return Variation(axis.key, tuple(texts))


def number_at(scene: Scene, path: str, text: str) -> float:
    """The value as a number for the axis of a chart: dimensionless for a group, otherwise in SI units."""
    table, _, name = path.partition(".")
    value: object = text
    if is_group(path):
        with suppress(ValueError):
            value = float(text)
    else:
        value = getattr(getattr(scene, table, None), name, None)
    if not is_number(value) or not math.isfinite(value):
        raise SceneError([Fault(path, f"{text!r} is no number", "a variable that has one, " + _FORM)])
    return float(value)


DEFINITION = (
    "filament/elements - 1 of the midpoint's height at that instant: positive where the filament sags more; mean: of "
    "the means over the last 6/7 of the duration; largest: with its sign, over all frames from a tenth of the duration"
)


def relative_error(time: Floats, curve: Floats, reference: Floats) -> Floats:
    """Relative error of a midpoint curve: at four times, of the mean, and the largest, shape (6,)."""
    frames = list(moments(len(time)))
    with np.errstate(divide="ignore", invalid="ignore"):
        error = np.where(reference == 0, np.nan, curve / reference - 1)
    since, settled = error[frames[0] :], late(time)
    known = since[np.isfinite(since)]
    average = float(reference[settled].mean())
    mean = float(curve[settled].mean()) / average - 1 if average else math.nan
    return np.array([*error[frames], mean, known[np.abs(known).argmax()] if known.size else math.nan])


_MIN_LINE, _MIN_PARABOLA = 3, 5


def slender_limit(delta: Floats, error: Floats, mesh: Floats) -> dict[str, Any] | None:
    """Extrapolate an error, and that of the coarser elements, to delta = 0; see :data:`LIMIT_DEFINITION`."""
    known = np.isfinite(error) & np.isfinite(mesh)
    x, y = delta[known], error[known]
    if len(x) < _MIN_LINE:
        return None
    powers = np.arange(3 if len(x) >= _MIN_PARABOLA else 2)

    def fit(x: Floats, y: Floats, scale: float) -> Floats:
        found = np.linalg.lstsq((x[:, None] / scale) ** powers, y, rcond=None)[0]
        return np.asarray(found / scale**powers, dtype=np.float64)

    fitted = fit(x, y, x.max())
    shifts = [abs(fit(thin := np.delete(x, k), np.delete(y, k), thin.max())[0] - fitted[0]) for k in range(len(x))]
    # The fit is linear in the errors: with the coarser elements the intercept shifts by that of the mesh error.
    leaving_out, moved = float(max(shifts)), float(abs(fit(x, mesh[known], x.max())[0]))
    first, second = np.argsort(x)[:2]
    ratio = y[second] / y[first] if y[first] else math.nan
    return {
        "intercept": float(fitted[0]),
        "coefficients": tuple(map(float, fitted)),
        "leaving_out": leaving_out,
        "mesh": moved,
        "order": math.log(ratio) / math.log(x[second] / x[first]) if ratio > 0 else math.nan,
        "uncertainty": math.hypot(leaving_out, moved),
    }


ASPECT, _STEEPEST = 1.5, 64.0
"""Length of the elements at the clamp over their height, unless `along` elements of equal length are shorter."""


def mesh_following(thickness: float, along: int = 32, through: int = 4) -> Mesh:
    """A mesh whose elements at the clamp are `ASPECT` times as long as high, and longer towards midspan.

    The bending layer at the clamp is as short as the filament is thin, so that elements of equal length would not
    resolve it. The explicit step is limited by the shortest edge, which is still the height.
    """
    if along < 2 or along % 2 or through < 4 or through % 4:
        raise SoftcatError(
            f"mesh of {along} x {through} elements: half as many must be a mesh too; take an even number along, and "
            "4 or a multiple of it through the thickness"
        )
    share = ASPECT * thickness / through * 2 * along

    def last(grading: float) -> float:
        """Length of the last element over the mean length."""
        ratio = grading ** (-1 / (along - 1))
        return float(along / grading * (1 - ratio) / (1 - ratio**along))

    even = 1 + 1e-9
    grading = 1.0 if share >= last(even) else _STEEPEST
    if last(_STEEPEST) < share < last(even):
        grading = brentq(lambda g: last(g) - share, even, _STEEPEST)
    # Two digits, for the name of the mesh.
    return Mesh(along, through, grading=max(1.0, float(f"{grading:.2g}")))


def coarser(mesh: Mesh) -> Mesh:
    """Half as many elements in both directions, with the same grading."""
    return replace(mesh, along=mesh.along // 2, through=mesh.through // 2)


SLENDER = ("groups.delta", "filament.thickness")
"""Variables that tend to the slender limit when they go to zero."""

_TIGHTER = 0.1
_MAX_STEPS = 5_000
"""Largest number of steps of a run that is repeated on a finer grid; a longer run diverges and would hardly end."""


@dataclass(frozen=True)
class TheoryError:
    """One theory at one value of the variable."""

    row: ComparisonRow  # The run with the program's own cells and tolerance, for its cost
    # Relative error, shape (6,), with twice the cells and a tenth of the tolerance, against the finer elements; of the
    # program's own run if that run fails or diverges.
    error: Floats
    trusted: bool
    grid: float  # Largest change of that error with the program's own cells and tolerance; NaN without another run


@dataclass(frozen=True)
class Measured:
    """One value of the variable."""

    text: str  # As the user wrote it
    value: float  # As a number
    comparison: Comparison  # The finer elements, and the filaments with the program's own settings
    coarse: ElementRun  # Half as many elements in both directions
    mesh: Floats  # Relative error of the coarser elements against the finer, shape (6,)
    theories: dict[str, TheoryError]  # By name, in the order of ``comparison.rows``


class Unmeasured(NamedTuple):
    """A value at which the elements, or a filament, could not be run."""

    text: str
    value: float
    reason: str


LIMIT_DEFINITION = (
    "fit of e0 + a delta (+ b delta^2 from five values on) to the errors; leaving_out: largest change of e0 when one "
    "value is left out; mesh: change of e0 with the coarser elements as reference; order: power of delta between the "
    "two thinnest filaments"
)


@dataclass(frozen=True)
class TheoryEnd(Drawable):
    """Errors of the one-dimensional theories over one variable."""

    scene: Scene  # The scene before the variation
    variation: Variation
    measured: tuple[Measured, ...]  # By increasing value
    unmeasured: tuple[Unmeasured, ...]  # By increasing value
    # By theory, for each error of :func:`relative_error`; empty unless the variable is the thickness.
    limits: dict[str, list[dict[str, Any] | None]]

    @property
    def names(self) -> tuple[str, ...]:
        """Theories that were run at some value, the scene's own first."""
        return tuple(dict.fromkeys(name for each in self.measured for name in each.theories))

    @property
    def moments(self) -> tuple[str, ...]:
        """Labels of the errors: ``t = 46``, ..., ``mean``, ``largest``."""
        run = self.measured[0].comparison.elements
        times = (run.time[frame] / run.elastic_time for frame in moments(len(run.time)))
        return (*(f"t = {time:.4g}" for time in times), "mean", "largest")

    def to_frame(self) -> pd.DataFrame:
        """A row for each value and theory; the rows of the elements compare the coarser with the finer ones."""
        names = [name.replace(" = ", "_") for name in self.moments]
        rows: list[tuple[Any, ...]] = []
        for each in self.measured:
            elements, span = each.comparison.elements, each.comparison.scene.filament.span
            for run, errors in ((elements, np.full(len(names), math.nan)), (each.coarse, each.mesh)):
                rows.append((each.value, mesh_name(run), "", "", run.midpoint[-1] / span, *errors, math.nan))
            for name, theory in each.theories.items():
                summary, final = theory.row.trajectory.summary, theory.row.midpoint[-1] / span
                known = (name.replace(",", ""), summary["outcome"], summary["regime"] or "", final)
                rows.append((each.value, *known, *theory.error, theory.grid))
        rows += [(lost.value, "", "not run", "", *[math.nan] * (len(names) + 2)) for lost in self.unmeasured]
        first = ["value", "theory", "outcome", "regime", "midpoint_final_over_span"]
        return pd.DataFrame(rows, columns=[*first, *names, "grid"])

    def limit_table(self) -> pd.DataFrame:
        """A row for each theory and moment that has a limit."""
        names = ["intercept", "uncertainty", "leaving_out", "mesh"]
        rows = [
            (name.replace(",", ""), moment, *(limit[key] for key in names), limit["coefficients"][1], limit["order"])
            for name, limits in self.limits.items()
            for moment, limit in zip(self.moments, limits, strict=True)
            if limit is not None
        ]
        return pd.DataFrame(rows, columns=["theory", "moment", *names, "slope", "order"])

    def to_dict(self) -> dict[str, Any]:
        """Content of ``compare.json`` for a varied scene; each of ``values`` is a comparison of one scene."""
        limits: dict[str, Any] = {_key(name): each for name, each in self.limits.items()}
        return {
            "title": self.scene.title,
            "vary": self.variation.path,
            "definition": DEFINITION,
            "moments": list(self.moments),
            "values": [_value(each) for each in self.measured],
            "not_run": [{"value": lost.value, "reason": lost.reason} for lost in self.unmeasured],
            "slender_limit": {"definition": LIMIT_DEFINITION, **limits} if limits else None,
        }


def _key(name: str) -> str:
    """A theory's name as a key: ``published_material_closure``."""
    return name.replace(",", "").replace(" ", "_")


def mesh_name(run: ElementRun) -> str:
    """``elements 32 x 4``, with the grading if there is one."""
    mesh = run.mesh
    return f"elements {mesh.along} x {mesh.through}" + (f" graded {mesh.grading:g}" if mesh.grading != 1 else "")


def _value(each: Measured) -> dict[str, Any]:
    coarse, elements = each.coarse, each.comparison.elements
    theories = {}
    for name, theory in each.theories.items():
        theories[_key(name)] = {"errors": theory.error.tolist(), "trusted": theory.trusted, "grid": theory.grid}
    return {
        "value": each.value,
        **each.comparison.to_dict(),
        "mesh_grading": elements.mesh.grading,
        "elements_coarser": {
            "along": coarse.mesh.along,
            "through": coarse.mesh.through,
            "midpoint_final_m": float(coarse.midpoint[-1]),
            "wall_s": coarse.wall,
            "dofs": coarse.dofs,
            "steps": coarse.steps,
            "errors": each.mesh.tolist(),
        },
        "theory_errors": theories,
    }


def where_theory_ends(
    scene: Scene,
    variation: Variation,
    scene_with: Callable[[str], Scene],
    *,
    along: int = 32,
    through: int = 4,
    clamp: Clamp = Clamp.THINNING,
    progress: Callable[[str, Scene], Listening] | None = None,
) -> TheoryEnd:
    """Run elements on two meshes, and the filament in each of its theories, at every value of a variable."""
    cases = [(text, scene_with(f"{variation.path}={text}")) for text in variation.texts]
    for _, case in cases:
        # The elements and the filament may refuse the scene here, before anything is run.
        problem_of(case)
        choose_effects(case)
    numbered = sorted((number_at(case, variation.path, text), text, case) for text, case in cases)
    meshes = [mesh_following(problem_of(case).thickness, along, through) for *_, case in numbered]
    measured: list[Measured] = []
    unmeasured: list[Unmeasured] = []
    for (value, text, case), mesh in zip(numbered, meshes, strict=True):
        listening = progress(f"{variation.path} = {text}", case) if progress else None
        try:
            measured.append(_measure(text, value, case, mesh, clamp, listening))
        except SoftcatError as error:
            unmeasured.append(Unmeasured(text, value, " ".join(str(error).split())))
    if not measured:
        raise SoftcatError(f"{variation.path}: nothing could be compared; {unmeasured[0].reason}")
    end = TheoryEnd(scene, variation, tuple(measured), tuple(unmeasured), {})
    return replace(end, limits={name: _limits(end, name) for name in end.names}) if variation.path in SLENDER else end


def _measure(text: str, value: float, scene: Scene, mesh: Mesh, clamp: Clamp, listening: Listening | None) -> Measured:

    def named(what: str) -> AbstractContextManager[Progress]:
        if listening is None:
            return nullcontext(Silence())
        return listening(f"{mesh.along} x {mesh.through} {what}" if what == "elements" else what)

    comparison = compare(scene, mesh, clamp=clamp, progress=named)
    fine, half = comparison.elements, coarser(mesh)
    with named(f"{half.along} x {half.through} elements") as listener:
        coarse = recalled_elements(scene, half, clamp=clamp, progress=listener)
    error = relative_error(fine.time, coarse.midpoint, fine.midpoint)
    return Measured(text, value, comparison, coarse, error, {row.name: _theory(row, fine) for row in comparison.rows})


def _theory(row: ComparisonRow, elements: ElementRun) -> TheoryError:
    """Run a theory again with a negligible discretization error."""
    run = row.trajectory
    chosen = relative_error(elements.time, row.midpoint, elements.midpoint)
    # A finer grid does not improve a run that fails.
    if not run.outcome.is_success or run.summary["steps"] > _MAX_STEPS:
        return TheoryError(row, chosen, run.outcome.is_success, math.nan)
    finer = {"numerics.cells": 2 * run.summary["cells"], "numerics.rtol": _TIGHTER * run.summary["rtol"]}
    refined = recalled(without_estimate(run.scene.replace(finer)))
    heights = aligned(refined.data["time"].values, refined.data["midpoint"].values, elements.time)
    error = relative_error(elements.time, heights, elements.midpoint)
    apart = np.abs(chosen - error)
    apart = apart[np.isfinite(apart)]
    return TheoryError(row, error, refined.outcome.is_success, float(apart.max()) if apart.size else math.nan)


def _limits(end: TheoryEnd, name: str) -> list[dict[str, Any] | None]:
    """The limit of each error of a theory; values without a run, or with one that fails, are left out."""
    filaments = [each.comparison.scene.filament for each in end.measured]
    delta = np.array([filament.thickness / filament.span for filament in filaments])
    meshes = np.array([each.mesh for each in end.measured])
    errors = np.full_like(meshes, math.nan)
    for k, each in enumerate(end.measured):
        if name in each.theories and each.theories[name].trusted:
            errors[k] = each.theories[name].error
    return [slender_limit(delta, *columns) for columns in zip(errors.T, meshes.T, strict=True)]
