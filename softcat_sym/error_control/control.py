"""A finished run is asked how accurate it is, and run again on what it needs."""

from __future__ import annotations

import math
from dataclasses import asdict, replace

import numpy as np

from softcat_sym.discretization.grid import choose_grading
from softcat_sym.effects.selection import Effects
from softcat_sym.error_control.estimate import Differences, Judge, Resolution, resolution_of
from softcat_sym.error_control.price import Timed, next_digit
from softcat_sym.error_control.refinement import controlled
from softcat_sym.estimates.free_vibration import ringing
from softcat_sym.progress import Stopwatch
from softcat_sym.results.breaking import breakable
from softcat_sym.results.motion import MIN_PERIODS
from softcat_sym.results.observed import DISPLACEMENT, Series
from softcat_sym.results.run import Run
from softcat_sym.results.verdict import shortest_hinge_cell
from softcat_sym.scene.scene import Scene
from softcat_sym.single_run import build, run_once
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import choose_backend
from softcat_sym.solvers.solution import Progress, Silence

MISSED_BY_LITTLE = 2.0
"""Times the accuracy asked: an estimated error up to there is an answer with its error bar, beyond it a failure."""

CERTAIN = 3.0
"""An estimate is up to three times too large: one above so many times the accuracy is missed for sure."""

FRAMES_PER_PERIOD = 20
"""Of a ringing that is looked at by its height and amplitude. A string's odd modes are multiples of the first, with
amplitudes that fall as the cube: at eight frames a period the seventh and ninth, 1/400 of it, pass for the first."""

SECOND_MODE = 3.0
"""Times as many frames where a filament may break: on a wave of its second mode, six times as fast in a beam."""

MAX_NUMBERS = 20_000_000
"""Of all output times together: what a run that is looked at closely may hold in memory."""

_STATES_PER_CELL = 10
"""Unknowns of a cell that are no fibre's, or more."""


def refine_to_accuracy(first: Run, effects: Effects, clock: Stopwatch, progress: Progress | None = None) -> Run:
    """Estimate the error of a run, and refine grid, fibres or steps until it is small enough."""
    scene, periods = first.scene, periods_of(first)
    guess = resolution_of(scene, effects, compiled=first.summary["backend"] == "compiled")
    runs = _Runs(first, effects, clock, progress or Silence(), frames_to_see(scene, guess, periods))

    def grading(cells: int) -> float:
        return scene.numerics.grading or choose_grading(scene, cells, effects)

    start = replace(guess, rtol=first.summary["rtol"])

    def judged(seen: Series) -> Judge:
        judge = Judge.of(seen, runs.last.watched, periods, scene.run.accuracy)
        return replace(judge, of_modes=runs.last.summary["tail_error"])

    found = controlled(scene, start, runs.answer, runs.companion, grading, judged)
    clock.lap("estimate")
    answer, errors = runs.last, found.found
    summary: dict[str, object] = {
        "resolution": asdict(found.resolution),
        "refinements": list(found.refinements),
        "wall_s": clock.laps(),
    }
    if errors is None:
        return answer.revised(summary)
    summary["error_estimate"] = errors.to_dict(effects=sum(answer.summary["checked"].values()))
    warnings = [f"the error is not fully estimated: the run with {what} has no answer" for what in errors.failed]
    short = shortest_hinge_cell(scene, effects, answer.fields["X_node"], answer.fields["yielded_fraction"])
    missed, warning = _missed(answer.scene, errors, undecided=short is not None)
    if answer.outcome.is_success and not missed:
        laps = clock.laps()
        besides = laps["total"] - laps["compile"] - runs.compiling - sum(run.solve + run.besides for run in runs.made)
        summary["next_digit"] = asdict(next_digit(scene, effects, (found.resolution, errors), runs.made, besides))
    warnings = [*answer.summary["warnings"], *warnings, *filter(None, [warning])]
    return answer.revised({**summary, "warnings": warnings}, Outcome.inaccurate if missed else None, missed)


class _Runs:
    """The answer so far, and runs beside it; all of them have `frames` output times, so that they can be compared."""

    def __init__(self, first: Run, effects: Effects, clock: Stopwatch, progress: Progress, frames: int) -> None:
        self.last, self._waiting, self._beside = first, True, 0
        self._effects, self._clock, self._progress, self._frames = effects, clock, progress, frames
        self._known: dict[str, Series | None] = {}
        self.watched = first.watched
        self.made: list[Timed] = []
        self.compiling = 0.0  # Of the runs beside [s]

    def answer(self, at: Resolution) -> Series | None:
        """Run for good; the first answer is there already."""
        clock = self._clock
        if not self._waiting:
            clock.lap("estimate")
            clock.set_aside()
        before, scene = clock.laps()["estimate"], self.last.scene
        if not self._waiting:
            self._progress.stage(f"refining to {at.cells} cells" + (f", {at.fibres} fibres" if at.fibres else ""))
            self._beside = 0
            resolved = at.of(scene)
            self.last = run_once(scene, resolved, self._effects, clock, self._progress, self._frames, self.watched)
        self._waiting = False
        clock.lap("estimate")
        laps = clock.laps()
        besides = laps["build"] + laps["estimate"] - before
        self.made.append(Timed(at, True, self.last.summary["steps"], laps["solve"], besides))
        if not self.last.outcome.is_success:
            return None
        seen = self.last.series
        if len(seen.get(DISPLACEMENT, ())) == self._frames:
            self._known[self._compared(at).to_toml()] = seen
        return self.companion(at)

    def _compared(self, at: Resolution) -> Scene:
        return at.of(self.last.scene).replace({"run.frames": self._frames})

    def companion(self, at: Resolution) -> Series | None:
        """Run for what is compared only, unless it was run before; None without an answer."""
        scene = self._compared(at)
        key = scene.to_toml()
        if key not in self._known:
            self._beside += 1
            usual = 3 if at.fibres or at.order else 2
            self._progress.stage(f"estimating {self._beside} of {max(usual, self._beside)}")
            clock = Stopwatch()
            prepared = build(scene, self._effects, clock, self._progress)
            clock.lap("build")
            self._progress.doing("solving")
            solution = prepared.solve(self._progress)
            clock.lap("solve")
            laps = clock.laps()
            self.compiling += laps["compile"]
            self.made.append(Timed(at, False, solution.steps, laps["solve"], laps["build"]))
            sound = solution.outcome.is_success
            self._known[key] = self.watched.series(scene, prepared, solution) if sound else None
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
    if not scene.numerics.estimate and not breakable(scene):
        return scene.run.frames
    at = resolution_of(scene, effects, compiled=choose_backend(scene, effects).compiled)
    periods = _periods_in(scene, scene.run.duration, inertial=effects.terms().inertia)
    return frames_to_see(scene, at, max(MIN_PERIODS, SECOND_MODE * periods) if breakable(scene) else periods)


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
