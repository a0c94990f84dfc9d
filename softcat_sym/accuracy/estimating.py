"""A finished run is asked how accurate it is, and run again on what it needs."""

from __future__ import annotations

from dataclasses import asdict, replace

import numpy as np

from softcat_sym.accuracy.companions import Differences
from softcat_sym.accuracy.control import Controlled, controlled
from softcat_sym.accuracy.error_estimate import ErrorEstimate
from softcat_sym.accuracy.resolution import Resolution, resolution_of
from softcat_sym.clock import Clock
from softcat_sym.effects import Effects
from softcat_sym.graph.grading import choose_grading
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, rest_length
from softcat_sym.single_run import build, run_once, run_texts
from softcat_sym.solve import Progress, Silence
from softcat_sym.solve.keeping import Form, kept, packed, unpacked
from softcat_sym.trajectory import Trajectory
from softcat_sym.trajectory.midpoint import midpoint_heights
from softcat_sym.trajectory.validity import shortest_hinge_cell

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
    runs = _Runs(first, effects, clock, progress or Silence())
    guess = resolution_of(first.scene, effects, compiled=first.summary["backend"] == "compiled")
    start = replace(guess, rtol=first.summary["rtol"])
    scene = first.scene

    def grading(cells: int) -> float:
        return scene.numerics.grading or choose_grading(scene, cells, effects)

    found = controlled(scene, start, runs.answer, runs.companion, grading)
    clock.lap("estimate")
    return _told(runs.last, effects, found, clock)


class _Runs:
    """The answer so far, and runs beside it."""

    def __init__(self, first: Trajectory, effects: Effects, clock: Clock, progress: Progress) -> None:
        self.last, self._waiting, self._beside = first, True, 0
        self._effects, self._clock, self._progress = effects, clock, progress

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
            self.last = run_once(scene, at.of(scene), self._effects, self._clock, self._progress)
        return np.asarray(self.last.data["midpoint"]) if self.last.outcome.is_success else None

    def companion(self, at: Resolution) -> Floats | None:
        """Run for the midpoint only, in the same units."""
        scene = at.of(self.last.scene)
        self._beside += 1
        self._progress.stage(f"estimating {self._beside} of {3 if at.fibres or at.order else 2}")
        found = kept(
            lambda: ("companion", scene.to_toml(), *run_texts(self._effects)), lambda: self._midpoint(scene), _MIDPOINT
        )
        return found if found.size else None

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
    errors = ErrorEstimate(parts.space, parts.time, parts.section, sum(answer.summary["checked"].values()))
    told["error_estimate"] = errors.as_table()
    warnings = [f"the error is not fully estimated: the run with {what} has no answer" for what in parts.failed]
    fields = answer.data
    short = shortest_hinge_cell(answer.scene, effects, fields.X_node.values, fields.yielded_fraction.values)
    missed, warning = _missed(answer.scene, parts, undecided=short is not None)
    return answer.estimated(told, [*warnings, *filter(None, [warning])], missed)


def _missed(scene: Scene, parts: Differences, *, undecided: bool) -> tuple[str, str]:
    """By how much the accuracy is missed, or else what to warn of where a number of the user's may miss it.

    Few cells are only coarse, and their error is told. Cells too short for the theory leave the answer `undecided`.
    """
    numerics, accuracy = scene.numerics, scene.run.accuracy
    fixed = {
        "space": "numerics.cells" if numerics.cells is not None else "",
        "time": "numerics.rtol" if numerics.rtol is not None else "",
        "section": "numerics.fibres or numerics.order" if numerics.fibres or numerics.order else "",
    }
    errors = {"space": parts.space or 0.0, "time": parts.time or 0.0, "section": parts.section or 0.0}
    free = sum(error for name, error in errors.items() if not fixed[name])
    total = sum(errors.values())
    if total <= accuracy:
        return "", ""
    by_hand = [fixed[name] for name, error in errors.items() if fixed[name] and error > 0]
    undecided = undecided and total > CERTAIN * accuracy
    if numerics.grading is not None:
        by_hand.append("numerics.grading")
    advice = f": leave out {' and '.join(by_hand)}, and the program chooses" if by_hand else ""
    text = f"the estimated error, {total:.2g}, exceeds the accuracy of {accuracy:g}{advice}"
    return (text, "") if free > accuracy or undecided else ("", text)
