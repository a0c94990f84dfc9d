"""A finished run is asked how accurate it is, and run again on what it needs."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import asdict, replace

import numpy as np

from softcat_sym.accuracy.companions import Differences
from softcat_sym.accuracy.control import Controlled, controlled
from softcat_sym.accuracy.error_estimate import ErrorEstimate
from softcat_sym.accuracy.resolution import Resolution, resolution_of
from softcat_sym.clock import Clock
from softcat_sym.effects import Effects
from softcat_sym.effects.ringing import ringing
from softcat_sym.graph.grading import choose_grading
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, rest_length
from softcat_sym.single_run import build, run_once, run_texts
from softcat_sym.solve import Progress, Silence, choose_backend
from softcat_sym.solve.keeping import Form, kept, packed, unpacked
from softcat_sym.trajectory import Trajectory
from softcat_sym.trajectory.midpoint import midpoint_heights
from softcat_sym.trajectory.settling import FEWEST_PERIODS
from softcat_sym.trajectory.validity import shortest_hinge_cell

MISSED_BY_LITTLE = 2.0
"""Times the accuracy asked: an estimated error up to there is an answer with its error bar, beyond it a failure."""

FRAMES_PER_PERIOD = 20
"""Of a ringing that is looked at by its height and amplitude. A string's odd modes are multiples of the first, with
amplitudes that fall as the cube: at eight frames a period the seventh and ninth, 1/400 of it, pass for the first."""

MOST_NUMBERS = 20_000_000
"""Of all output times together: what a run that is looked at closely may hold in memory."""

_STATES = 10
"""Unknowns of a cell that are no fibre's, or more."""

CERTAIN = 3.0
"""An estimate is up to three times too large: one above so many times the accuracy tells that it is missed for sure."""

_MIDPOINT: Form[Floats] = Form(lambda heights: packed({"heights": heights}), lambda kept: unpacked(kept)["heights"])


def as_accurate_as_asked(
    first: Trajectory, effects: Effects, clock: Clock, progress: Progress | None = None
) -> Trajectory:
    """Estimate the error of a run, and run it on a finer grid, more fibres or shorter steps until it is small enough.

    Parameters
    ----------
    first : Trajectory
        With these effects, at the program's first guess. Returned as it is where it is not to be trusted anyway.
    effects : Effects
        In force.
    clock : Clock
        Told of every stage; whatever is not the answer's own integration counts as ``estimate``.
    progress : Progress
        Told about simulated time.

    Returns
    -------
    Trajectory
        With ``error_estimate``, and with the outcome ``inaccurate`` where the accuracy could not be reached.
    """
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
            self._known[key] = kept(
                lambda: ("companion", key, *run_texts(self._effects)), lambda: self._midpoint(scene), _MIDPOINT
            )
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
    """Periods of the lowest mode in a run whose load sets it ringing; zero where none does.

    Parameters
    ----------
    run : Trajectory
        Any.
    """
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
    if periods < FEWEST_PERIODS:
        return asked
    fits = MOST_NUMBERS // (at.cells * (_STATES + 2 * (at.fibres or 0)))
    wanted = min(math.ceil(FRAMES_PER_PERIOD * periods), fits - 1)
    return max(1, math.ceil(wanted / (asked - 1))) * (asked - 1) + 1


def _periods_in(scene: Scene, effects: Collection[str], duration: float) -> float:
    if "inertia" not in effects:
        return 0.0
    rings = ringing(scene)
    return rings.frequency * duration / (2 * math.pi) if rings.amplitude > 0 else 0.0
