"""The price of the next digit: what a run ten times as accurate would take, by the errors and the times of this one."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations

import numpy as np

from softcat_sym.effects.selection import SHARE, Effects, choose_effects
from softcat_sym.error_control.estimate import ORDER, Deviation, Differences, Judge, Resolution, resolution_of
from softcat_sym.error_control.refinement import EXPECTED_ORDER, STATES, controlled, errors_expected
from softcat_sym.progress import seconds_text
from softcat_sym.results.observed import DISPLACEMENT, Series
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.settings import choose_backend

DIGIT = 10
"""By so much the next accuracy is smaller, or by a power of it: the first that this run does not have already."""

_FLATTEST, _STEEPEST = 0.2, 0.5
"""Powers of the tolerance by which steps grow: of methods of fifth and of second order. Between loose tolerances they
grow less, since output times and kinks bound them, and that does not go on."""

_LIBRARY = 1.0
"""Seconds of the compiler for a section with another number of fibres, or for other effects."""


@dataclass(frozen=True)
class Timed:
    """A run that was made."""

    at: Resolution
    answer: bool  # Whether it was judged and kept, no companion
    steps: int
    solve: float  # [s]
    besides: float  # What else it took [s]: building before it, judging after it, the compiler apart


@dataclass(frozen=True)
class Price:
    """What the next digit would take."""

    accuracy: float
    seconds: float | None  # [s]; None where it is out of reach
    compiling: float  # [s]; the first time, beside it
    text: str


def next_digit(
    scene: Scene, effects: Effects, answer: tuple[Resolution, Differences], made: Sequence[Timed], besides: float
) -> Price:
    """Foretell what a run with the next digit would take: the loop that refines, on errors that are foretold.

    `answer` is at what the answer was found, and its errors; `made` are that run and those beside it, and `besides` is
    the time [s] that was spent on none of them, compilers apart.
    """
    at, found = answer
    digits = max(1, math.ceil(math.log10(scene.run.accuracy / found.total) - 1e-9)) if found.total > 0 else 1
    accuracy = float(f"{scene.run.accuracy / DIGIT**digits:.3g}")
    asked = scene.replace({"run.accuracy": accuracy})
    more = scene.run.effects == "auto" and any(worth > SHARE * accuracy for worth in effects.left_out.values())
    in_force = choose_effects(asked) if more else effects
    compiled = choose_backend(asked, in_force).compiled
    first = resolution_of(asked, in_force, compiled=compiled)
    # Such that the same is estimated of the answer, where its grid's error falls as it is expected to.
    space = None if found.space is None else found.space * (2**ORDER - 1) / (2**EXPECTED_ORDER - 1)

    def judged(seen: Series) -> Judge:
        return _Known({DISPLACEMENT: float(seen[DISPLACEMENT][0, 0])}, windows)

    foretold = _Foretold(at, replace(found, space=space), made)
    windows = () if found.phase is None else (slice(0),)
    ended = controlled(asked, first, foretold.answer, foretold.companion, lambda cells: at.grading, judged)
    percent = f"{100 * accuracy:.3g} %"
    if ended.found is None or ended.found.total > accuracy:
        limits = f"N = {ended.resolution.cells}"
        limits += f" and {ended.resolution.fibres} fibres" if ended.resolution.fibres else ""
        return Price(accuracy, None, 0.0, f"{percent} is out of reach of {limits}")
    known = {run.at.fibres for run in made}
    compiling = _LIBRARY * (len(foretold.fibres - known) + (in_force.names != effects.names)) if compiled else 0.0
    seconds = besides + foretold.seconds
    once = f", and {seconds_text(compiling)} of the compiler once" if compiling else ""
    return Price(accuracy, seconds, compiling, f"{percent} would take about {seconds_text(seconds)}{once}")


class _Known(Judge):
    """Compares displacements that hold nothing but their error."""

    def between(self, one: Series, other: Series) -> Deviation:
        return Judge(self.scale, ()).between(one, other)


@dataclass
class _Foretold:
    """Runs that are not made: their displacement is one plus their error, and what they would take is added up."""

    at: Resolution
    found: Differences
    made: Sequence[Timed]
    seconds: float = 0.0
    fibres: set[int | None] = field(default_factory=set)
    _done: set[Resolution] = field(default_factory=set)

    def answer(self, at: Resolution) -> Series:
        """Run for good."""
        self._done.add(at)
        return self._run(at, answer=True)

    def companion(self, at: Resolution) -> Series:
        """Run beside; what was run before is known."""
        if at in self._done:
            return self._moved(at)
        self._done.add(at)
        return self._run(at, answer=False)

    def _run(self, at: Resolution, *, answer: bool) -> Series:
        alike = [run.besides for run in self.made if run.answer == answer]
        self.seconds += self._solving(at) + sum(alike) / len(alike)
        self.fibres.add(at.fibres)
        return self._moved(at)

    def _moved(self, at: Resolution) -> Series:
        numbers = (np.array([float(number)]) for number in (at.cells, at.fibres or 0, at.rtol))
        return {DISPLACEMENT: 1 + errors_expected(self.at, self.found, *numbers)[:, None]}

    def _solving(self, at: Resolution) -> float:
        """As many steps as the runs that were made foretell, each as long as there are unknowns.

        The number of steps goes with the cells and the tolerance by powers that two runs show each.
        """
        a_step = sum(run.solve for run in self.made) / max(1.0, sum(_size(run.at) * run.steps for run in self.made))
        last = next(run for run in reversed(self.made) if run.answer)
        cells = min(max(self._power("cells"), -_STEEPEST), _STEEPEST)
        tolerance = min(max(-self._power("rtol"), _FLATTEST), _STEEPEST)
        steps = last.steps * (at.cells / last.at.cells) ** cells * (last.at.rtol / at.rtol) ** tolerance
        return float(a_step * _size(at) * steps)

    def _power(self, name: str) -> float:
        """Of cells or tolerance, by which the steps of two runs differ that differ in nothing else."""
        for one, other in combinations(self.made, 2):
            ratio = getattr(one.at, name) / getattr(other.at, name)
            if ratio != 1 and one.at == replace(other.at, **{name: getattr(one.at, name)}):
                return math.log(max(1, one.steps) / max(1, other.steps)) / math.log(ratio)
        return 0.0


def _size(at: Resolution) -> float:
    return float(at.cells * ((at.fibres or 0) + STATES))
