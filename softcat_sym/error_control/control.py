"""A finished run is asked how accurate it is, and run again on what it needs."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Collection, Iterable
from dataclasses import asdict, dataclass, replace

import numpy as np

from softcat_sym.clock import Clock
from softcat_sym.discretization.grid import Floats, choose_grading
from softcat_sym.effects.choosing import Effects
from softcat_sym.effects.free_vibration import ringing
from softcat_sym.error_control.estimate import (
    FIBRE_NUMBERS,
    SECTION_ORDER,
    Before,
    Differences,
    ErrorEstimate,
    Judge,
    Runner,
    differences,
)
from softcat_sym.error_control.resolution import Resolution, resolution_of
from softcat_sym.results.fields import midpoint_heights
from softcat_sym.results.motion import MIN_PERIODS
from softcat_sym.results.trajectory import Trajectory
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

_FORETOLD_ORDER = 1.6
"""Of the grid, as an estimated error falls with more cells: one that is far from its order falls more slowly."""

_LEAP = 8.0
"""At most so many times as many cells at once: an error far from its order foretells badly."""

_TIGHTEST = 64.0
"""At most so much tighter at once."""

_STEPS = 0.2
"""The number of steps goes with the tolerance to minus this power, of a method of fifth order."""

_STATES = 6
"""Unknowns of a cell that are no fibre's, counted in fibres: there are two of each."""

_COMPILING = 1000.0
"""Time in which the library for another number of fibres is compiled, a second whatever their number."""


def refined(at: Resolution, found: Differences, scene: Scene, grading: Callable[[int], float]) -> Resolution:
    """What to run next: of all that should be accurate enough, by the order of each error, the cheapest.

    The same resolution where nothing that the program may choose would help.
    """
    aim = AIM * scene.run.accuracy
    tried = [
        replace(at, cells=cells, fibres=fibres, rtol=rtol)
        for cells, fibres, rtol in itertools.product(_cells(at, scene), _fibres(at, scene), _tolerances(at, scene))
        if fibres is None or cells == at.cells or cells * fibres <= MAX_POINTS
    ]
    best = min(_foretold(one, at, found) for one in tried)
    if best > WORTH * found.total:
        return at
    enough = [one for one in tried if _foretold(one, at, found) <= max(aim, best / WORTH)]
    now = min(enough, key=lambda one: _cost(one, at))
    return now if now.cells == at.cells else replace(now, grading=grading(now.cells))


def _cells(at: Resolution, scene: Scene) -> Iterable[int]:
    """Numbers of cells to choose from, an eighth of an octave apart."""
    if scene.numerics.cells is not None:
        return (at.cells,)
    eighths = range(1, round(8 * math.log2(_LEAP)) + 1)
    more = {min(MAX_CELLS, math.ceil(at.cells * 2 ** (k / 8))) for k in eighths}
    return (at.cells, *sorted(n for n in more if n > at.cells))


def _fibres(at: Resolution, scene: Scene) -> Iterable[int | None]:
    numerics = scene.numerics
    if at.fibres is None or numerics.fibres is not None or numerics.order is not None:
        return (at.fibres,)
    return (at.fibres, *(n for n in FIBRE_NUMBERS if at.fibres < n <= MAX_FIBRES))


def _tolerances(at: Resolution, scene: Scene) -> Iterable[float]:
    if scene.numerics.rtol is not None:
        return (at.rtol,)
    tighter = (at.rtol / 2**k for k in range(1, round(math.log2(_TIGHTEST)) + 1))
    return (at.rtol, *(rtol for rtol in tighter if rtol >= MIN_RTOL))


def _foretold(one: Resolution, at: Resolution, found: Differences) -> float:
    """Estimated error at a resolution, from that at another."""
    space, time, section = (part or 0.0 for part in (found.space, found.time, found.section))
    coarser, fewer = at.cells / one.cells, (at.fibres or 1) / (one.fibres or 1)
    return float(space * coarser**_FORETOLD_ORDER + time * one.rtol / at.rtol + section * fewer**SECTION_ORDER)


def _cost(one: Resolution, at: Resolution) -> float:
    """Time that a resolution takes, in that of a cell with one fibre."""
    fibres = one.fibres or 0
    steps = float((at.rtol / one.rtol) ** _STEPS)
    compiling = _COMPILING if one.fibres != at.fibres else 0.0
    return float(one.cells * (fibres + _STATES) * steps + compiling)


ROUNDS = 4
"""Runs that are tried, the first included."""


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
    at, said, before = first, list[str](), None
    for left in reversed(range(ROUNDS)):
        midpoint = answer(at)
        if midpoint is None:
            return Controlled(at, None, tuple(said))
        judge = Judge.of(midpoint, periods, scene.run.accuracy)
        found = differences(midpoint, at, companion, judge, scene.run.accuracy, before)
        following = refined(at, found, scene, grading)
        if found.total <= scene.run.accuracy or following == at or not left:
            break
        said.append(f"{_worded(at, following)}: estimated error {found.total:.2g} against {scene.run.accuracy:g}")
        at, before = following, Before(at, found)
    return Controlled(at, found, tuple(said))


def _worded(before: Resolution, after: Resolution) -> str:
    """``40 -> 96 cells, 8 -> 16 fibres``."""
    pairs = (
        ("cells", before.cells, after.cells),
        ("fibres", before.fibres, after.fibres),
        ("rtol", f"{before.rtol:.2g}", f"{after.rtol:.2g}"),
    )
    return ", ".join(f"{old} -> {new} {name}" for name, old, new in pairs if old != new)


MISSED_BY_LITTLE = 2.0
"""Times the accuracy asked: an estimated error up to there is an answer with its error bar, beyond it a failure."""

FRAMES_PER_PERIOD = 20
"""Of a ringing that is looked at by its height and amplitude. A string's odd modes are multiples of the first, with
amplitudes that fall as the cube: at eight frames a period the seventh and ninth, 1/400 of it, pass for the first."""

MAX_NUMBERS = 20_000_000
"""Of all output times together: what a run that is looked at closely may hold in memory."""

_STATES_PER_CELL = 10
"""Unknowns of a cell that are no fibre's, or more."""

CERTAIN = 3.0
"""An estimate is up to three times too large: one above so many times the accuracy tells that it is missed for sure."""


def as_accurate_as_asked(
    first: Trajectory, effects: Effects, clock: Clock, progress: Progress | None = None
) -> Trajectory:
    """Estimate the error of a run, and refine grid, fibres or steps until it is small enough."""
    guess = resolution_of(first.scene, effects, compiled=first.summary["backend"] == "compiled")
    start = replace(guess, rtol=first.summary["rtol"])
    scene, periods = first.scene, periods_of(first)
    runs = _Runs(first, effects, clock, progress or Silence(), frames_to_see(scene, guess, periods))

    def grading(cells: int) -> float:
        return scene.numerics.grading or choose_grading(scene, cells, effects)

    found = controlled(scene, start, runs.answer, runs.companion, grading, periods)
    clock.lap("estimate")
    return _told(runs.last, effects, found, clock)


class _Runs:
    """The answer so far, and runs beside it; all of them have `frames` output times, so that they can be compared."""

    def __init__(self, first: Trajectory, effects: Effects, clock: Clock, progress: Progress, frames: int) -> None:
        self.last, self._waiting, self._beside = first, True, 0
        self._effects, self._clock, self._progress, self._frames = effects, clock, progress, frames
        self._known: dict[str, Floats] = {}

    def answer(self, at: Resolution) -> Floats | None:
        """Run for good; the first answer is there already."""
        if self._waiting:
            self._waiting = False
        else:
            self._clock.lap("estimate")
            self._clock.set_aside()
            scene = self.last.scene
            self._progress.stage(f"refining to {at.cells} cells" + (f", {at.fibres} fibres" if at.fibres else ""))
            self._beside = 0
            self.last = run_once(scene, at.of(scene), self._effects, self._clock, self._progress, self._frames)
        if not self.last.outcome.is_success:
            return None
        if self._frames == self.last.scene.run.frames:
            return np.asarray(self.last.data["midpoint"])
        heights = self.last.heights
        return heights if heights is not None and len(heights) == self._frames else self.companion(at)

    def companion(self, at: Resolution) -> Floats | None:
        """Run for the midpoint only, in the same units."""
        scene = at.of(self.last.scene).replace({"run.frames": self._frames})
        key = scene.to_toml()
        if key not in self._known:
            self._beside += 1
            usual = 3 if at.fibres or at.order else 2
            self._progress.stage(f"estimating {self._beside} of {max(usual, self._beside)}")
            self._known[key] = self._midpoint(scene)
        return self._known[key] if self._known[key].size else None

    def _midpoint(self, scene: Scene) -> Floats:
        """Heights of the midpoint [m]; none without an answer."""
        prepared = build(scene, self._effects, progress=self._progress)
        self._progress.doing("solving")
        solution = prepared.solve(self._progress)
        if not solution.outcome.is_success:
            return np.zeros(0)
        return midpoint_heights(prepared.graph, solution) * rest_length(scene)


def _told(answer: Trajectory, effects: Effects, found: Controlled, clock: Clock) -> Trajectory:
    """Put the estimate into the summary, and decide whether it will do."""
    parts = found.found
    told: dict[str, object] = {
        "resolution": asdict(found.resolution),
        "refinements": list(found.refinements),
        "wall_s": clock.laps(),
    }
    if parts is None:
        return answer.estimated(told, (), "")
    errors = ErrorEstimate(parts.space, parts.time, parts.section, sum(answer.summary["checked"].values()), parts.phase)
    told["error_estimate"] = errors.as_table()
    warnings = [f"the error is not fully estimated: the run with {what} has no answer" for what in parts.failed]
    fields = answer.data
    short = shortest_hinge_cell(answer.scene, effects, fields.X_node.values, fields.yielded_fraction.values)
    missed, warning = _missed(answer.scene, parts, undecided=short is not None)
    return answer.estimated(told, [*warnings, *filter(None, [warning])], missed)


def _missed(scene: Scene, parts: Differences, *, undecided: bool) -> tuple[str, str]:
    """By how much the accuracy is missed, or else what to warn of where it is missed by little or by the user's choice.

    Few cells are only coarse, and their error is told. Cells too short for the theory leave the answer `undecided`.
    """
    numerics, accuracy = scene.numerics, scene.run.accuracy
    errors = {"space": parts.space or 0.0, "time": parts.time or 0.0, "section": parts.section or 0.0}
    fixed = {
        "space": ["numerics.cells"] if numerics.cells is not None else [],
        "time": ["numerics.rtol"] if numerics.rtol is not None else [],
        "section": [f"numerics.{name}" for name in ("fibres", "order") if getattr(numerics, name) is not None],
    }
    free, total = sum(error for name, error in errors.items() if not fixed[name]), sum(errors.values())
    if total <= accuracy:
        return "", ""
    by_hand = [key for name, error in errors.items() if error > 0 for key in fixed[name]]
    by_hand += ["numerics.grading"] if numerics.grading is not None else []
    advice = f": leave out {' and '.join(by_hand)}, and the program chooses" if by_hand else ""
    if free > MISSED_BY_LITTLE * accuracy or (undecided and total > CERTAIN * accuracy):
        parts_called = {"space": "the grid", "time": "the time steps", "section": "the fibres"}
        most = parts_called[max(errors, key=errors.__getitem__)]
        text = f"the estimated error, {total:.2g}, most of it of {most}, exceeds twice the accuracy of {accuracy:g}"
        return f"{text}{advice}", ""
    return "", f"accuracy {total:.2g} instead of {accuracy:g}{advice}"


def periods_of(run: Trajectory) -> float:
    """Periods of the lowest mode in a run whose load sets it ringing; zero where none does."""
    return _periods_in(run.scene, run.summary["effects"], run.summary["time_final_s"])


def frames_of_first(scene: Scene, effects: Effects) -> int:
    """Output times of the first run of a scene that is to be estimated, from :func:`frames_to_see`."""
    if not scene.numerics.estimate:
        return scene.run.frames
    at = resolution_of(scene, effects, compiled=choose_backend(scene, effects).compiled)
    return frames_to_see(scene, at, _periods_in(scene, effects.names, scene.run.duration))


def frames_to_see(scene: Scene, at: Resolution, periods: float) -> int:
    """Output times that show a long ringing, which is not told frame by frame; the frames asked for are among them."""
    asked = scene.run.frames
    if periods < MIN_PERIODS:
        return asked
    fits = MAX_NUMBERS // (at.cells * (_STATES_PER_CELL + 2 * (at.fibres or 0)))
    wanted = min(math.ceil(FRAMES_PER_PERIOD * periods), fits - 1)
    return max(1, math.ceil(wanted / (asked - 1))) * (asked - 1) + 1


def _periods_in(scene: Scene, effects: Collection[str], duration: float) -> float:
    if "inertia" not in effects:
        return 0.0
    rings = ringing(scene)
    return rings.frequency * duration / (2 * math.pi) if rings.amplitude > 0 else 0.0
