"""A finished run is asked how accurate it is, and run again on what it needs."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace

import numpy as np

from softcat_sym.discretization.grid import choose_grading
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.choosing import Effects
from softcat_sym.effects.free_vibration import ringing
from softcat_sym.error_control.estimate import (
    FIBRE_NUMBERS,
    SECTION_ORDER,
    Before,
    Differences,
    Judge,
    Resolution,
    Runner,
    differences,
    resolution_of,
)
from softcat_sym.progress import Clock
from softcat_sym.results.fields import midpoint_heights
from softcat_sym.results.motion import MIN_PERIODS
from softcat_sym.results.run import Run
from softcat_sym.results.verdict import shortest_hinge_cell
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.single_run import build, run_once
from softcat_sym.solvers.settings import choose_backend
from softcat_sym.solvers.solution import Progress, Silence

AIM = 0.8
"""Share of the accuracy that the estimated error is to come down to: extrapolated, it is a little wrong."""

WORTH = 0.9
"""Share of the error that must be left at most, where the accuracy is out of reach, for another run to be worth it."""

MAX_CELLS, MAX_FIBRES, MIN_RTOL = 1280, 64, 1e-11

MAX_POINTS = 32_000
"""Cells times fibres: what a filament of so many points takes is a matter of minutes, and is not begun unasked."""

_EXPECTED_ORDER = 1.6
"""Of the grid, as an estimated error falls with more cells: one that is far from its order falls more slowly."""

_LEAP, _TIGHTEST = 8, 64
"""At most so many times as many cells, and so much tighter, at once: an error far from its order foretells badly."""

_STEPS = 0.2
"""The number of steps goes with the tolerance to minus this power, of a method of fifth order."""

_STATES = 6
"""Unknowns of a cell that are no fibre's, counted in fibres: there are two of each."""

_COMPILING = 1000.0
"""Time in which the library for another number of fibres is compiled, a second whatever their number."""

ROUNDS = 4
"""Runs that are tried, the first included."""

MISSED_BY_LITTLE = 2.0
"""Times the accuracy asked: an estimated error up to there is an answer with its error bar, beyond it a failure."""

CERTAIN = 3.0
"""An estimate is up to three times too large: one above so many times the accuracy is missed for sure."""

FRAMES_PER_PERIOD = 20
"""Of a ringing that is looked at by its height and amplitude. A string's odd modes are multiples of the first, with
amplitudes that fall as the cube: at eight frames a period the seventh and ninth, 1/400 of it, pass for the first."""

MAX_NUMBERS = 20_000_000
"""Of all output times together: what a run that is looked at closely may hold in memory."""

_STATES_PER_CELL = 10
"""Unknowns of a cell that are no fibre's, or more."""


def refined(at: Resolution, found: Differences, scene: Scene, grading: Callable[[int], float]) -> Resolution:
    """What to run next: of all that should be accurate enough, by the order of each error, the cheapest.

    The same resolution where nothing that the program may choose would help.
    """
    numerics = scene.numerics
    cells, fibres, tolerances = [at.cells], [at.fibres], [at.rtol]
    if numerics.cells is None:
        # An eighth of an octave apart.
        more = {min(MAX_CELLS, math.ceil(at.cells * 2 ** (k / 8))) for k in range(1, 8 * round(math.log2(_LEAP)) + 1)}
        cells += sorted(n for n in more if n > at.cells)
    if at.fibres is not None and numerics.fibres is None and numerics.order is None:
        fibres += [n for n in FIBRE_NUMBERS if at.fibres < n <= MAX_FIBRES]
    if numerics.rtol is None:
        tighter = (at.rtol / 2**k for k in range(1, round(math.log2(_TIGHTEST)) + 1))
        tolerances += [rtol for rtol in tighter if rtol >= MIN_RTOL]
    tried = [
        replace(at, cells=n, fibres=through, rtol=rtol)
        for n, through, rtol in itertools.product(cells, fibres, tolerances)
        if through is None or n == at.cells or n * through <= MAX_POINTS
    ]
    space, time, section = (part or 0.0 for part in (found.space, found.time, found.section))

    def expected(other: Resolution) -> float:
        coarser, fewer = at.cells / other.cells, (at.fibres or 1) / (other.fibres or 1)
        return float(space * coarser**_EXPECTED_ORDER + time * other.rtol / at.rtol + section * fewer**SECTION_ORDER)

    def cost(other: Resolution) -> float:
        """Time that a resolution takes, in that of a cell with one fibre."""
        steps = float((at.rtol / other.rtol) ** _STEPS)
        compiling = _COMPILING if other.fibres != at.fibres else 0.0
        return float(other.cells * ((other.fibres or 0) + _STATES) * steps + compiling)

    best = min(map(expected, tried))
    if best > WORTH * found.total:
        return at
    enough = max(AIM * scene.run.accuracy, best / WORTH)
    now = min((other for other in tried if expected(other) <= enough), key=cost)
    return now if now.cells == at.cells else replace(now, grading=grading(now.cells))


@dataclass(frozen=True)
class Controlled:
    """How the loop ended."""

    resolution: Resolution  # Of the answer
    found: Differences | None  # Its estimated errors; None if the answer itself is not to be trusted
    refinements: tuple[str, ...]  # What was made finer, and why, run by run


def controlled(
    scene: Scene,
    first: Resolution,
    answer: Runner,
    companion: Runner,
    grading: Callable[[int], float],
    periods: float = 0.0,
) -> Controlled:
    """Run until the estimated error is below the accuracy asked, or nothing that may be chosen would help."""
    at, refinements, before = first, list[str](), None
    for left in reversed(range(ROUNDS)):
        midpoint = answer(at)
        if midpoint is None:
            return Controlled(at, None, tuple(refinements))
        judge = Judge.of(midpoint, periods, scene.run.accuracy)
        found = differences(midpoint, at, companion, judge, scene.run.accuracy, before)
        following = refined(at, found, scene, grading)
        if found.total <= scene.run.accuracy or following == at or not left:
            break
        changes = (
            ("cells", at.cells, following.cells),
            ("fibres", at.fibres, following.fibres),
            ("rtol", f"{at.rtol:.2g}", f"{following.rtol:.2g}"),
        )
        finer = ", ".join(f"{old} -> {new} {name}" for name, old, new in changes if old != new)
        refinements.append(f"{finer}: estimated error {found.total:.2g} against {scene.run.accuracy:g}")
        at, before = following, Before(at, found)
    return Controlled(at, found, tuple(refinements))


def as_accurate_as_asked(first: Run, effects: Effects, clock: Clock, progress: Progress | None = None) -> Run:
    """Estimate the error of a run, and refine grid, fibres or steps until it is small enough."""
    scene, periods = first.scene, periods_of(first)
    guess = resolution_of(scene, effects, compiled=first.summary["backend"] == "compiled")
    runs = _Runs(first, effects, clock, progress or Silence(), frames_to_see(scene, guess, periods))

    def grading(cells: int) -> float:
        return scene.numerics.grading or choose_grading(scene, cells, effects)

    start = replace(guess, rtol=first.summary["rtol"])
    found = controlled(scene, start, runs.answer, runs.companion, grading, periods)
    clock.lap("estimate")
    answer, errors = runs.last, found.found
    summary: dict[str, object] = {
        "resolution": asdict(found.resolution),
        "refinements": list(found.refinements),
        "wall_s": clock.laps(),
    }
    if errors is None:
        return answer.estimated(summary, (), "")
    summary["error_estimate"] = errors.to_dict(effects=sum(answer.summary["checked"].values()))
    warnings = [f"the error is not fully estimated: the run with {what} has no answer" for what in errors.failed]
    short = shortest_hinge_cell(scene, effects, answer.fields["X_node"], answer.fields["yielded_fraction"])
    missed, warning = _missed(answer.scene, errors, undecided=short is not None)
    return answer.estimated(summary, [*warnings, *filter(None, [warning])], missed)


class _Runs:
    """The answer so far, and runs beside it; all of them have `frames` output times, so that they can be compared."""

    def __init__(self, first: Run, effects: Effects, clock: Clock, progress: Progress, frames: int) -> None:
        self.last, self._waiting, self._beside = first, True, 0
        self._effects, self._clock, self._progress, self._frames = effects, clock, progress, frames
        self._known: dict[str, Floats | None] = {}

    def answer(self, at: Resolution) -> Floats | None:
        """Run for good; the first answer is there already."""
        if not self._waiting:
            self._clock.lap("estimate")
            self._clock.set_aside()
            scene = self.last.scene
            self._progress.stage(f"refining to {at.cells} cells" + (f", {at.fibres} fibres" if at.fibres else ""))
            self._beside = 0
            self.last = run_once(scene, at.of(scene), self._effects, self._clock, self._progress, self._frames)
        self._waiting = False
        if not self.last.outcome.is_success:
            return None
        if self._frames == self.last.scene.run.frames:
            return self.last.fields["midpoint"]
        heights = self.last.heights
        return heights if heights is not None and len(heights) == self._frames else self.companion(at)

    def companion(self, at: Resolution) -> Floats | None:
        """Run for the midpoint only [m]; None without an answer."""
        scene = at.of(self.last.scene).replace({"run.frames": self._frames})
        key = scene.to_toml()
        if key not in self._known:
            self._beside += 1
            usual = 3 if at.fibres or at.order else 2
            self._progress.stage(f"estimating {self._beside} of {max(usual, self._beside)}")
            prepared = build(scene, self._effects, progress=self._progress)
            self._progress.doing("solving")
            solution = prepared.solve(self._progress)
            sound = solution.outcome.is_success
            self._known[key] = midpoint_heights(prepared.graph, solution) * rest_length(scene) if sound else None
        return self._known[key]


def _missed(scene: Scene, parts: Differences, *, undecided: bool) -> tuple[str, str]:
    """By how much the accuracy is missed, or else what to warn of where it is missed by little or by the user's choice.

    Few cells are only coarse, and their error is stated. Cells too short for the theory leave the answer `undecided`.
    """
    numerics, accuracy = scene.numerics, scene.run.accuracy
    errors = {"space": parts.space or 0.0, "time": parts.time or 0.0, "section": parts.section or 0.0}
    keys = {"space": ("cells",), "time": ("rtol",), "section": ("fibres", "order")}
    fixed = {part: [name for name in keys[part] if getattr(numerics, name) is not None] for part in keys}
    free, total = sum(error for name, error in errors.items() if not fixed[name]), sum(errors.values())
    if total <= accuracy:
        return "", ""
    by_hand = [f"numerics.{key}" for name, error in errors.items() if error > 0 for key in fixed[name]]
    by_hand += ["numerics.grading"] if numerics.grading is not None else []
    advice = f": leave out {' and '.join(by_hand)}, and the program chooses" if by_hand else ""
    if free > MISSED_BY_LITTLE * accuracy or (undecided and total > CERTAIN * accuracy):
        names = {"space": "the grid", "time": "the time steps", "section": "the fibres"}
        most = names[max(errors, key=errors.__getitem__)]
        text = f"the estimated error, {total:.2g}, most of it of {most}, exceeds twice the accuracy of {accuracy:g}"
        return f"{text}{advice}", ""
    return "", f"accuracy {total:.2g} instead of {accuracy:g}{advice}"


def periods_of(run: Run) -> float:
    """Periods of the lowest mode in a run whose load sets it ringing; zero where none does."""
    inertial = bool(np.any(run.fields["energy_kinetic"] > 0))
    return _periods_in(run.scene, run.summary["time_final_s"], inertial=inertial)


def frames_of_first(scene: Scene, effects: Effects) -> int:
    """Output times of the first run of a scene that is to be estimated, from :func:`frames_to_see`."""
    if not scene.numerics.estimate:
        return scene.run.frames
    at = resolution_of(scene, effects, compiled=choose_backend(scene, effects).compiled)
    return frames_to_see(scene, at, _periods_in(scene, scene.run.duration, inertial=effects.terms().inertia))


def frames_to_see(scene: Scene, at: Resolution, periods: float) -> int:
    """Output times that show a long ringing, whose phase is not compared; the frames asked for are among them."""
    frames = scene.run.frames
    if periods < MIN_PERIODS:
        return frames
    fits = MAX_NUMBERS // (at.cells * (_STATES_PER_CELL + 2 * (at.fibres or 0)))
    enough = min(math.ceil(FRAMES_PER_PERIOD * periods), fits - 1)
    return max(1, math.ceil(enough / (frames - 1))) * (frames - 1) + 1


def _periods_in(scene: Scene, duration: float, *, inertial: bool) -> float:
    if not inertial:
        return 0.0
    rings = ringing(scene)
    return rings.frequency * duration / (2 * math.pi) if rings.amplitude > 0 else 0.0
