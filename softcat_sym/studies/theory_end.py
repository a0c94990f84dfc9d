"""Where the one-dimensional theory ends: its error against finite elements as one variable of a scene changes."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas as pd
from scipy.optimize import brentq

from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.reference.element_loop import Clamp, Mesh, element_sources, fingerprint, problem_of
from softcat_sym.reference.elements import ElementRun, run_elements
from softcat_sym.reference.material_point import point_code
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.solvers.solution import Progress, Silence
from softcat_sym.studies.compare import Comparison, Listening, Row, aligned, compare, late, moments

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_FORM = "one variable, such as groups.delta=0.01,0.02,0.03 or groups.V=2.6:260:5:log"
_RANGE = re.compile(r"([^:,]+):([^:,]+):(\d{1,4})(:log)?")
_MAX_VALUES = 1000


@dataclass(frozen=True)
class Variation:
    """A variable and the values it takes."""

    path: str  # Dotted path in the scene file
    texts: tuple[str, ...]  # Values as ``--set`` takes them, each once


def read_variation(text: str) -> Variation:
    """Read ``path=value,value,...`` or ``path=first:last:number`` with or without ``:log``."""
    path, _, values = (part.strip() for part in text.partition("="))
    texts = _range(values) if ":" in values else tuple(part.strip() for part in values.split(","))
    different = tuple(dict.fromkeys(texts))
    if not path or not all(texts) or len(different) < 2:
        found = "has one value" if path and values and len(different) == 1 else "varies nothing"
        raise SceneError([Fault("--vary", f"{text!r} {found}", _FORM)])
    return Variation(path, different)


def number_at(scene: Scene, path: str, text: str) -> float:
    """The value as a number for the axis of a chart: a group as it is, anything else in SI units."""
    value: object = _number(text) if path.startswith("groups.") else scene
    if value is scene:
        for name in path.split("."):
            value = getattr(value, name, None)
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise SceneError([Fault(path, f"{text!r} is no number", "a variable that has one, " + _FORM)])
    return float(value)


def _range(values: str) -> tuple[str, ...]:
    """Values of a range; none if it is no range."""
    found = _RANGE.fullmatch(values)
    if found is None:
        return ()
    first, last, count = _number(found[1]), _number(found[2]), int(found[3])
    sound = math.isfinite(first) and math.isfinite(last) and 2 <= count <= _MAX_VALUES
    if not sound or (found[4] and min(first, last) <= 0):
        return ()
    # Twelve digits: what rounding adds would end up in file names and tables.
    return tuple(f"{number:.12g}" for number in (np.geomspace if found[4] else np.linspace)(first, last, count))


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan


DEFINITION = (
    "filament/elements - 1 of the midpoint's height at that instant: positive where the filament sags more; mean: of "
    "the means over the last 6/7 of the duration; largest: with its sign, over all frames from a tenth of the duration"
)


@dataclass(frozen=True)
class RelativeError:
    """How much more one curve sags than another.

    NaN where there is nothing to compare.
    """

    at: tuple[float, ...]  # At 10, 25, 50 and 100 % of the duration
    mean: float  # Of the means over the last 6/7 of the duration
    largest: float  # Of largest magnitude from the first of the moments on, with its sign
    trusted: bool = True  # Whether the runs behind it are

    @property
    def values(self) -> tuple[float, ...]:
        """All of them: the moments, the mean, the largest."""
        return (*self.at, self.mean, self.largest)


def relative_error(time: Floats, curve: Floats, reference: Floats) -> RelativeError:
    """Compare two midpoint curves."""
    frames = moments(len(time))
    with np.errstate(divide="ignore", invalid="ignore"):
        error = np.where(reference == 0, np.nan, curve / reference - 1)
    since = error[frames[0] :]
    known = since[np.isfinite(since)]
    settled = late(time)
    average = float(reference[settled].mean())
    return RelativeError(
        at=tuple(float(error[frame]) for frame in frames),
        mean=float(curve[settled].mean()) / average - 1 if average else float("nan"),
        largest=float(known[np.abs(known).argmax()]) if known.size else float("nan"),
    )


_MIN_LINE, _MIN_PARABOLA = 3, 5


@dataclass(frozen=True)
class Limit:
    """The intercept of an error fitted by e0 + a delta (+ b delta^2, from five values on)."""

    intercept: float  # e0, the error of the slender limit
    coefficients: tuple[float, ...]  # e0, a and, if fitted, b
    leaving_out: float  # Largest change of the intercept when one value is left out
    mesh: float  # Change of the intercept when the coarser elements judge instead of the finer
    order: float  # Power of delta that the error itself follows, by its two smallest values; NaN where the sign changes

    @property
    def uncertainty(self) -> float:
        """Leaving out and mesh together."""
        return math.hypot(self.leaving_out, self.mesh)

    def at(self, delta: Floats) -> Floats:
        """The fitted error; same shape as `delta`."""
        return np.asarray(np.polynomial.polynomial.polyval(delta, self.coefficients), dtype=np.float64)


def slender_limit(delta: Floats, error: Floats, mesh: Floats) -> Limit | None:
    """Extrapolate an error to delta = 0."""
    known = np.isfinite(error) & np.isfinite(mesh)
    x, y, m = delta[known], error[known], mesh[known]
    if len(x) < _MIN_LINE:
        return None
    degree = 2 if len(x) >= _MIN_PARABOLA else 1
    fitted = _fit(x, y, degree)
    shifts = [abs(_fit(np.delete(x, k), np.delete(y, k), degree)[0] - fitted[0]) for k in range(len(x))]
    thin = np.argsort(x)[:2]
    ratio = y[thin[1]] / y[thin[0]] if y[thin[0]] else math.nan
    return Limit(
        intercept=float(fitted[0]),
        coefficients=tuple(map(float, fitted)),
        leaving_out=float(max(shifts)),
        # A fit is linear in what it fits.
        mesh=float(abs(_fit(x, m, degree)[0])),
        order=float(math.log(ratio) / math.log(x[thin[1]] / x[thin[0]])) if ratio > 0 else math.nan,
    )


def _fit(x: Floats, y: Floats, degree: int) -> Floats:
    scale = float(x.max())
    found = np.linalg.lstsq(np.vander(x / scale, degree + 1, increasing=True), y, rcond=None)[0]
    return np.asarray(found / scale ** np.arange(degree + 1), dtype=np.float64)


ASPECT, _STEEPEST = 1.5, 64.0
"""Length of the elements at the clamp over their height, where `along` elements of equal length would be longer."""


def mesh_following(thickness: float, along: int = 32, through: int = 4) -> Mesh:
    """A mesh whose elements at the clamp are `ASPECT` times as long as high, and longer towards midspan.

    The layer in which the clamp bends the filament is as short as the filament is thin, so that equal elements would
    lose it; the explicit step is that of the shortest edge, which stays the height.
    """
    if along < 2 or along % 2 or through < 4 or through % 4:
        raise SoftcatError(
            f"mesh of {along} x {through} elements: half as many must be a mesh too; take an even number along, and "
            "4 or a multiple of it through the thickness"
        )
    share = ASPECT * thickness / through * 2 * along

    def last(grading: float) -> float:
        """The last element over the mean."""
        ratio = grading ** (-1 / (along - 1))
        return float(along / grading * (1 - ratio) / (1 - ratio**along))

    even = 1 + 1e-9
    grading = 1.0 if share >= last(even) else _STEEPEST
    if last(_STEEPEST) < share < last(even):
        grading = brentq(lambda g: last(g) - share, even, _STEEPEST)
    # Two digits: a mesh that people can name.
    return Mesh(along, through, grading=max(1.0, float(f"{grading:.2g}")))


def coarser(mesh: Mesh) -> Mesh:
    """Half as many elements both ways, graded alike."""
    return replace(mesh, along=mesh.along // 2, through=mesh.through // 2)


SLENDER = ("groups.delta", "filament.thickness")
"""Variables that tend to the slender limit when they go to zero."""

_TIGHTER = 0.1
_MAX_STEPS = 5_000
"""A run that takes more of them runs away; on a finer grid it would hardly end."""


@dataclass(frozen=True)
class TheoryError:
    """One theory at one value of the variable."""

    row: Row  # Its run as the program chooses cells and tolerance: what it costs
    # Of the same theory with twice the cells and a tenth of the tolerance, against the finer elements; of the
    # program's own run where that is not to be trusted, or runs away.
    error: RelativeError
    # Largest change of that error, in magnitude, when the program's own cells and tolerance are taken; NaN where
    # there is no other.
    grid: float


@dataclass(frozen=True)
class Measured:
    """One value of the variable."""

    text: str  # As it was written
    value: float  # As a number
    comparison: Comparison  # The finer elements, and the filaments as the program runs them
    coarse: ElementRun  # Half as many elements both ways
    mesh: RelativeError  # Of the coarser elements against the finer, as though they were a theory
    theories: tuple[TheoryError, ...]  # In the order of ``comparison.rows``


@dataclass(frozen=True)
class Unmeasured:
    """A value at which the elements, or a filament, could not be run."""

    text: str
    value: float
    reason: str


LIMIT_DEFINITION = (
    "fit of e0 + a delta (+ b delta^2 from five values on) to the errors; leaving_out: largest change of e0 when one "
    "value is left out; mesh: change of e0 when the coarser elements judge; order: power of delta between the two "
    "thinnest filaments"
)


@dataclass(frozen=True)
class TheoryEnd:
    """Errors of the one-dimensional theories over one variable."""

    scene: Scene  # What was asked, before it was varied
    variation: Variation
    measured: tuple[Measured, ...]  # By increasing value
    unmeasured: tuple[Unmeasured, ...]  # By increasing value
    # By theory, at the moments of :class:`RelativeError`; empty unless the variable is the thickness.
    limits: dict[str, tuple[Limit | None, ...]]

    @property
    def names(self) -> tuple[str, ...]:
        """Theories that were run at any value, the scene's own first."""
        return tuple(dict.fromkeys(theory.row.name for each in self.measured for theory in each.theories))

    @property
    def moments(self) -> tuple[str, ...]:
        """What the errors of :class:`RelativeError` belong to: ``t = 46``, ..., ``mean``, ``largest``."""
        run = self.measured[0].comparison.elements
        times = (run.time[frame] / run.elastic_time for frame in moments(len(run.time)))
        return (*(f"t = {time:.4g}" for time in times), "mean", "largest")

    def errors(self) -> pd.DataFrame:
        """A row for each value and theory; the elements' own rows are those of the coarser against the finer."""
        names = [name.replace(" = ", "_") for name in self.moments]
        rows: list[dict[str, Any]] = []
        for each in self.measured:
            span, none = each.comparison.scene.filament.span, [math.nan] * len(names)
            for run, values in ((each.comparison.elements, none), (each.coarse, each.mesh.values)):
                row = {"value": each.value, "theory": mesh_name(run), "outcome": "", "regime": ""}
                last = {"midpoint_final_over_span": run.midpoint[-1] / span}
                rows.append({**row, **last, **dict(zip(names, values, strict=True)), "grid": math.nan})
            for theory in each.theories:
                summary, errors = theory.row.trajectory.summary, dict(zip(names, theory.error.values, strict=True))
                row = {"value": each.value, "theory": theory.row.name.replace(",", ""), "outcome": summary["outcome"]}
                last = {"midpoint_final_over_span": theory.row.midpoint[-1] / span}
                rows.append({**row, "regime": summary["regime"] or "", **last, **errors, "grid": theory.grid})
        lost = [{"value": each.value, "theory": "", "outcome": "not run", "regime": ""} for each in self.unmeasured]
        return pd.DataFrame([*rows, *lost])

    def costs(self) -> pd.DataFrame:
        """A row for each value and run, with the ratios of the finer elements over it; seconds are of the solve.

        The finer elements have the error that their coarser companions have against them; the coarser have the same.
        """
        rows = []
        for each in self.measured:
            elements, span = each.comparison.elements, each.mesh.largest
            runs = [(mesh_name(run), run.dofs, run.steps, run.wall, None, span) for run in (elements, each.coarse)]
            for theory in each.theories:
                summary = theory.row.trajectory.summary
                wall, error = summary["wall_s"], theory.error.largest
                name = theory.row.name.replace(",", "")
                runs.append((name, theory.row.dofs, summary["steps"], wall["solve"], wall["total"], error))
            for name, dofs, steps, solve, total, error in runs:
                ratios = _over(elements.dofs, dofs), _over(elements.steps, steps), _over(elements.wall, solve)
                rows.append((each.value, name, dofs, steps, solve, total, error, *ratios))
        columns = ["value", "run", "dofs", "steps", "solve_s", "total_s", "largest_error"]
        return pd.DataFrame(rows, columns=[*columns, "dofs_ratio", "steps_ratio", "solve_ratio"])

    def limit_table(self) -> pd.DataFrame:
        """A row for each theory and moment that has a limit."""
        rows = [
            {"theory": name.replace(",", ""), "moment": moment, "intercept": limit.intercept,
             "uncertainty": limit.uncertainty, "leaving_out": limit.leaving_out, "mesh": limit.mesh,
             "slope": limit.coefficients[1], "order": limit.order}
            for name, limits in self.limits.items()
            for moment, limit in zip(self.moments, limits, strict=True)
            if limit is not None
        ]  # fmt: skip
        return pd.DataFrame(rows)

    def to_frame(self) -> pd.DataFrame:
        """The errors."""
        return self.errors()

    def to_dict(self) -> dict[str, Any]:
        """What ``compare.json`` holds of a varied scene; each of ``values`` as a comparison of that scene alone."""
        limits: dict[str, Any] = {
            _key(name): [limit and {**asdict(limit), "uncertainty": limit.uncertainty} for limit in each]
            for name, each in self.limits.items()
        }
        return {
            "title": self.scene.title,
            "vary": self.variation.path,
            "definition": DEFINITION,
            "moments": list(self.moments),
            "values": [_value(each) for each in self.measured],
            "not_run": [{"value": lost.value, "reason": lost.reason} for lost in self.unmeasured],
            "slender_limit": {"definition": LIMIT_DEFINITION, **limits} if limits else None,
        }

    def figures(self) -> dict[str, Figure]:
        """Errors over the variable."""
        from softcat_sym.plotting.theory_end import theory_end_figure

        return {"compare_vary": theory_end_figure(self)}


def _key(name: str) -> str:
    """A theory's name as a key: ``published_material_closure``."""
    return name.replace(",", "").replace(" ", "_")


def mesh_name(run: ElementRun) -> str:
    """``elements 32 x 4``, with the grading if there is one."""
    mesh = run.mesh
    return f"elements {mesh.along} x {mesh.through}" + (f" graded {mesh.grading:g}" if mesh.grading != 1 else "")


def _over(value: float, other: float) -> float:
    return value / other if other else math.nan


def _value(each: Measured) -> dict[str, Any]:

    coarse, elements = each.coarse, each.comparison.elements
    theories = {}
    for theory in each.theories:
        summary = theory.row.trajectory.summary
        theories[_key(theory.row.name)] = {
            "errors": list(theory.error.values),
            "trusted": theory.error.trusted,
            "grid": theory.grid,
            "dofs_ratio": _over(elements.dofs, theory.row.dofs),
            "steps_ratio": _over(elements.steps, summary["steps"]),
            "solve_ratio": _over(elements.wall, summary["wall_s"]["solve"]),
        }
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
            "errors": list(each.mesh.values),
        },
        "theory_errors": theories,
    }


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
    """Run elements on two meshes, and the filament in each of its theories, at every value of a variable."""
    cases = [(text, scene_with(f"{variation.path}={text}")) for text in variation.texts]
    for _, case in cases:
        # The elements and the filament may refuse the scene: before anything is run.
        problem_of(case)
        choose_effects(case)
    numbered = sorted((number_at(case, variation.path, text), text, case) for text, case in cases)
    meshes = [mesh_following(problem_of(case).thickness, along, through) for *_, case in numbered]
    measured: list[Measured] = []
    unmeasured: list[Unmeasured] = []
    for (value, text, case), mesh in zip(numbered, meshes, strict=True):
        listening = progress(f"{variation.path} = {text}", case) if progress else None
        try:
            measured.append(_measure(text, value, case, mesh, clamp, folder, listening))
        except SoftcatError as error:
            unmeasured.append(Unmeasured(text, value, " ".join(str(error).split())))
    if not measured:
        raise SoftcatError(f"{variation.path}: nothing could be compared; {unmeasured[0].reason}")
    end = TheoryEnd(scene, variation, tuple(measured), tuple(unmeasured), {})
    return replace(end, limits={name: _limits(end, name) for name in end.names}) if variation.path in SLENDER else end


def _measure(
    text: str, value: float, scene: Scene, mesh: Mesh, clamp: Clamp, folder: Path, listening: Listening | None
) -> Measured:
    problem = problem_of(scene)
    sources = element_sources(point_code(problem.law))

    def checkpoint(grid: Mesh) -> Path:
        return folder / f"{fingerprint(problem, grid, clamp, 1.0, sources)}.npz"

    def named(what: str) -> AbstractContextManager[Progress]:
        if listening is None:
            return nullcontext(Silence())
        return listening(f"{mesh.along} x {mesh.through} {what}" if what == "elements" else what)

    comparison = compare(scene, mesh, clamp=clamp, checkpoint=checkpoint(mesh), progress=named)
    fine, half = comparison.elements, coarser(mesh)
    with named(f"{half.along} x {half.through} elements") as listener:
        coarse = run_elements(scene, half, clamp=clamp, checkpoint=checkpoint(half), progress=listener)
    error = relative_error(fine.time, coarse.midpoint, fine.midpoint)
    return Measured(text, value, comparison, coarse, error, tuple(_theory(row, fine) for row in comparison.rows))


def _theory(row: Row, elements: ElementRun) -> TheoryError:
    """Run a theory again on a grid and to a tolerance that no longer show."""
    run = row.trajectory
    chosen = relative_error(elements.time, row.midpoint, elements.midpoint)
    # What is not to be trusted is not made better by a finer grid.
    if not run.outcome.is_success or run.summary["steps"] > _MAX_STEPS:
        return TheoryError(row, replace(chosen, trusted=run.outcome.is_success), math.nan)
    finer = {"numerics.cells": 2 * run.summary["cells"], "numerics.rtol": _TIGHTER * run.summary["rtol"]}
    refined = recalled(without_estimate(run.scene.replace(finer)))
    heights = aligned(refined.data["time"].values, refined.data["midpoint"].values, elements.time)
    error = relative_error(elements.time, heights, elements.midpoint)
    apart = np.abs(np.subtract(chosen.values, error.values))
    apart = apart[np.isfinite(apart)]
    trusted = replace(error, trusted=refined.outcome.is_success)
    return TheoryError(row, trusted, float(apart.max()) if apart.size else math.nan)


def _limits(end: TheoryEnd, name: str) -> tuple[Limit | None, ...]:
    """The limit of each error of a theory; values where it was not run, or not to be trusted, are left out."""
    filaments = [each.comparison.scene.filament for each in end.measured]
    delta = np.array([filament.thickness / filament.span for filament in filaments])
    # Against the coarser elements every error is smaller by what lies between the meshes.
    meshes = np.array([each.mesh.values for each in end.measured])
    errors = np.full_like(meshes, math.nan)
    for k, each in enumerate(end.measured):
        for theory in each.theories:
            if theory.row.name == name and theory.error.trusted:
                errors[k] = theory.error.values
    return tuple(slender_limit(delta, errors[:, k], meshes[:, k]) for k in range(errors.shape[1]))
