"""Where the one-dimensional theory ends: its error against finite elements as one variable of a scene changes."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.reference.element_loop import Clamp, Mesh, element_sources, fingerprint, problem_of
from softcat_sym.reference.elements import ElementRun, run_elements
from softcat_sym.reference.material_point import point_code
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.studies.compare import Comparison, FilamentRow, Listening, aligned, compare, late, moments

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene

_FORM = "one variable, such as groups.delta=0.01,0.02,0.03 or groups.V=2.6:260:5:log"
_RANGE = re.compile(r"([^:,]+):([^:,]+):(\d{1,4})(:log)?")
_MOST = 1000


@dataclass(frozen=True)
class Variation:
    """A variable and the values it takes."""

    path: str  # Dotted path in the scene file
    texts: tuple[str, ...]  # Values as ``--set`` takes them, each once

    def changes(self) -> list[tuple[str, str]]:
        """Each value, and the change of the scene that sets it."""
        return [(text, f"{self.path}={text}") for text in self.texts]


def read_variation(text: str) -> Variation:
    """Read ``path=value,value,...`` or ``path=first:last:number`` with or without ``:log``."""
    path, equals, values = (part.strip() for part in text.partition("="))
    if not equals or not path or not values:
        raise _refuse(f"{text!r} varies nothing")
    texts = _range(values) if ":" in values else tuple(part.strip() for part in values.split(","))
    if not all(texts):
        raise _refuse(f"{text!r} has an empty value")
    different = tuple(dict.fromkeys(texts))
    if len(different) < 2:
        raise _refuse(f"{text!r} has one value")
    return Variation(path, different)


def number_at(scene: Scene, path: str, text: str) -> float:
    """The value as a number for the axis of a chart: a group as it is, anything else in SI units."""
    if path.startswith("groups."):
        value: object = _plain(text)
    else:
        value = scene
        for name in path.split("."):
            value = getattr(value, name, None)
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise SceneError([Fault(path, f"{text!r} is no number", "a variable that has one, " + _FORM)])
    return float(value)


def _range(values: str) -> tuple[str, ...]:
    found = _RANGE.fullmatch(values)
    if found is None:
        raise _refuse(f"{values!r} is no range")
    first, last, count = _plain(found[1]), _plain(found[2]), int(found[3])
    if first is None or last is None or not 2 <= count <= _MOST:
        raise _refuse(f"{values!r} is no range")
    if found[4] and not (first > 0 and last > 0):
        raise _refuse(f"{values!r} is logarithmic and not positive")
    numbers = np.geomspace(first, last, count) if found[4] else np.linspace(first, last, count)
    # Twelve digits: what rounding adds would end up in file names and tables.
    return tuple(f"{number:.12g}" for number in numbers)


def _plain(text: str) -> float | None:
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def _refuse(found: str) -> SceneError:
    return SceneError([Fault("--vary", found, _FORM)])


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
    without = (np.delete(np.arange(len(x)), k) for k in range(len(x)))
    shifts = [abs(_fit(x[kept], y[kept], degree)[0] - fitted[0]) for kept in without]
    return Limit(
        intercept=float(fitted[0]),
        coefficients=tuple(map(float, fitted)),
        leaving_out=float(max(shifts)),
        # A fit is linear in what it fits.
        mesh=float(abs(_fit(x, m, degree)[0])),
        order=_order(x, y),
    )


def _fit(x: Floats, y: Floats, degree: int) -> Floats:
    scale = float(x.max())
    found = np.linalg.lstsq(np.vander(x / scale, degree + 1, increasing=True), y, rcond=None)[0]
    return np.asarray(found / scale ** np.arange(degree + 1), dtype=np.float64)


def _order(x: Floats, y: Floats) -> float:
    thin = np.argsort(x)[:2]
    ratio = y[thin[1]] / y[thin[0]] if y[thin[0]] else math.nan
    return float(math.log(ratio) / math.log(x[thin[1]] / x[thin[0]])) if ratio > 0 else math.nan


ASPECT = 1.5
"""Length of the elements at the clamp over their height, where `along` elements of equal length would be longer."""

_STEEPEST = 64.0


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
    equal, wanted = 0.5 / along, ASPECT * thickness / through
    return Mesh(along, through, grading=_grading(wanted / equal, along))


def coarser(mesh: Mesh) -> Mesh:
    """Half as many elements both ways, graded alike."""
    return replace(mesh, along=mesh.along // 2, through=mesh.through // 2)


def _grading(share: float, along: int) -> float:
    """The grading that makes the last element `share` times as long as the mean; by bisection, rounded."""
    if share >= 1:
        return 1.0

    def last(grading: float) -> float:
        ratio = grading ** (-1 / (along - 1))
        return float(along * (1 / grading) * (1 - ratio) / (1 - ratio**along))

    low, high = 1.0, _STEEPEST
    for _ in range(60):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if last(middle) > share else (low, middle)
    # Two digits: a mesh that people can name.
    return max(1.0, float(f"{low:.2g}"))


SLENDER = ("groups.delta", "filament.thickness")
"""Variables that tend to the slender limit when they go to zero."""

_TIGHTER = 0.1
_MAX_STEPS = 5_000
"""A run that takes more of them runs away; on a finer grid it would hardly end."""


@dataclass(frozen=True)
class TheoryError:
    """One theory at one value of the variable."""

    row: FilamentRow  # Its run as the program chooses cells and tolerance: what it costs
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
    theories: tuple[TheoryError, ...]  # In the order of ``comparison.filaments``


@dataclass(frozen=True)
class Unmeasured:
    """A value at which the elements, or a filament, could not be run."""

    text: str  # As it was written
    value: float  # As a number
    reason: str  # Why


@dataclass(frozen=True)
class TheoryEnd:
    """Errors of the one-dimensional theories over one variable."""

    scene: Scene  # What was asked, before it was varied
    variation: Variation  # The variable and its values
    measured: tuple[Measured, ...]  # By increasing value
    unmeasured: tuple[Unmeasured, ...]  # By increasing value
    # By theory, at the moments of :class:`RelativeError`; empty unless the variable is the thickness.
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
    """Run elements on two meshes, and the filament in each of its theories, at every value of a variable."""
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
    if not run.outcome.is_success or run.summary["steps"] > _MAX_STEPS:
        return TheoryError(row, replace(chosen, trusted=run.outcome.is_success), math.nan)
    finer = {"numerics.cells": 2 * run.summary["cells"], "numerics.rtol": _TIGHTER * run.summary["rtol"]}
    refined = recalled(without_estimate(run.scene.replace(finer)))
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
