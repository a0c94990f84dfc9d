"""The error of an answer, split by where it comes from, by companion runs on other grids, steps and fibres."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from softcat_sym.discretization.assembly import choose_cells, choose_fibres
from softcat_sym.discretization.grid import choose_grading
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.choosing import Effects
from softcat_sym.results.motion import MIN_PERIODS
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.settings import settings_for


@dataclass(frozen=True, slots=True)
class Resolution:
    """Numerical parameters of one run."""

    cells: int  # N, cells per half span
    # Ratio of the longest cell to the shortest; the same on both grids of an estimate, so that they lie on one map.
    grading: float
    fibres: int | None  # Fibres through the thickness; None where no fibre yields by itself
    order: int | None  # k of the appendix, in the place of fibres
    rtol: float  # Relative tolerance of the integrator

    def of(self, scene: Scene) -> Scene:
        """The scene at this resolution."""
        changes: dict[str, object] = {f"numerics.{name}": getattr(self, name) for name in ("cells", "grading", "rtol")}
        if self.order is not None:
            changes["numerics.order"] = self.order
        elif self.fibres is not None:
            changes["numerics.fibres"] = self.fibres
        return scene.replace(changes)


def resolution_of(scene: Scene, effects: Effects, *, compiled: bool) -> Resolution:
    """What the scene says, and otherwise the program's first guess."""
    cells, numerics = choose_cells(scene, effects), scene.numerics
    resolved = effects.terms().resolved
    return Resolution(
        cells,
        numerics.grading or choose_grading(scene, cells, effects),
        choose_fibres(scene) if resolved and numerics.order is None else None,
        numerics.order if resolved else None,
        settings_for(scene, effects, compiled=compiled).rtol,
    )


WINDOW_PERIODS, WINDOW_FRAMES = 5.0, 20
"""Least length of a window."""

_FINER = 16
"""Frequencies looked at per frequency that a window resolves."""


@dataclass(frozen=True, slots=True)
class Deviation:
    """Of one midpoint from another."""

    size: float  # Largest difference over the run, relative to the largest midpoint
    # Periods by which the one is ahead of the other at the end; None where midpoints are compared instant by instant.
    phase: float | None

    def over(self, share: float) -> Deviation:
        """The error of which this is a share."""
        return Deviation(self.size / share, None if self.phase is None else self.phase / share)


@dataclass(frozen=True)
class Judge:
    """Compares midpoints with those of an answer."""

    answer: Floats  # shape (frames,)
    # Stretches over which height and amplitude are taken; none where it is compared instant by instant.
    windows: tuple[slice, ...]

    @classmethod
    def of(cls, answer: Floats, periods: float, accuracy: float) -> Judge:
        """Judge by an answer."""
        frames, scale = len(answer), float(np.max(np.abs(answer)))
        number = int(min(periods / WINDOW_PERIODS, frames / WINDOW_FRAMES))
        if periods < MIN_PERIODS or scale == 0 or number < 2:
            return cls(answer, ())
        edges = np.linspace(0, frames, number + 1).astype(int)
        windows = tuple(slice(int(a), int(b)) for a, b in pairwise(edges))
        rings = _swing(answer[windows[-1]])[1] > accuracy * scale
        return cls(answer, windows if rings else ())

    def between(self, one: Floats, other: Floats) -> Deviation:
        """Deviation of two runs of the same scene at other resolutions, relative to the answer's largest midpoint."""
        scale = float(np.max(np.abs(self.answer)))
        if not self.windows:
            return Deviation(float(np.max(np.abs(one - other))) / scale, None)
        ours, theirs = (np.array([_swing(run[window]) for window in self.windows]) for run in (one, other))
        apart = np.abs(ours[:, :2] - theirs[:, :2])
        turned = np.unwrap(ours[:, 2] - theirs[:, 2]) / (2 * np.pi)
        return Deviation(float(np.max(apart)) / scale, abs(float(turned[-1])))


def _swing(heights: Floats) -> tuple[float, float, float]:
    """Height, amplitude and phase in the middle of a window.

    A constant, a drift and one oscillation are fitted by least squares, weighted towards the middle of the window, so
    that it matters little where in their swing other modes are cut off. What they leave counts as amplitude too.
    """
    count = len(heights)
    along, weight = np.arange(count) - (count - 1) / 2, np.hanning(count + 2)[1:-1]
    root = np.sqrt(weight)

    def fitted(columns: Floats) -> Floats:
        return np.asarray(np.linalg.lstsq(columns * root[:, None], heights * root, rcond=None)[0])

    base = np.vstack([np.ones(count), along]).T
    flat = heights - base @ fitted(base)
    spectrum = np.abs(np.fft.rfft(flat * weight, _FINER * count))
    # Less than a cycle a window is drift.
    spectrum[:_FINER] = 0.0
    turn = 2 * np.pi * int(np.argmax(spectrum)) / (_FINER * count) * along
    columns = np.hstack([base, np.cos(turn)[:, None], np.sin(turn)[:, None]])
    found = fitted(columns)
    left = float(np.average((heights - columns @ found) ** 2, weights=weight))
    amplitude = float(np.sqrt(found[2] ** 2 + found[3] ** 2 + 2 * left))
    return float(found[0]), amplitude, float(np.arctan2(-found[3], found[2]))


Runner = Callable[[Resolution], Floats | None]
"""Midpoint over the run at a resolution, shape (frames,); None where that run has no answer."""

ORDER = 2
"""Of the grid: differences and averages are central."""

LOOSER = 8.0
"""Factor of the tolerance; the error of the time steps grows by five to twenty times with it, so about as much."""

TIGHTER = 1 / 3
"""Factor of the tolerance, of a filament that rings on. Looser steps tell nothing there: they lose all that there is of
the higher modes, as the judged ones may have done. Of six strands that ring for 300 to 600 periods the error is 0.9 to
1.5 times what is found so; an eightfold tolerance misses it by factors of 0.7 to 10, whatever order is supposed."""

RINGING_ORDER = 2
"""Power of the tolerance by which that is extrapolated."""

MORE = 1.5
"""Factor of the fibres: fewer than half as many again may be as wrong in the same direction."""

FIBRE_NUMBERS = (8, 12, 16, 24, 32, 48, 64, 96)
"""Numbers of fibres that are tried."""

SECTION_ORDER = 2
"""Of the fibres: where a section yields from its surface inwards, the edge lies between two of them."""

SMALL = 0.2
"""Share of the accuracy below which an error of the time steps is not looked at again when they have become shorter."""

_MIN_CELLS = 4


@dataclass(frozen=True)
class Differences:
    """Estimated errors of the midpoint over one run, relative to its largest; None where they were not found.

    Of a filament that rings on to the end for ten periods or more they are those of the height about which it rings and
    of the amplitude, over every five periods.
    """

    space: float | None  # Of the grid, by Richardson's extrapolation from a coarser one
    time: float | None  # Of the time steps, from a looser tolerance, or a tighter one of a filament that rings on
    section: float | None  # Of the fibres or the order k, from more of them; None also where nothing is to be resolved
    phase: float | None  # Periods by which a ringing may be ahead or late at its end
    failed: tuple[str, ...]  # Companions that have no answer

    @property
    def total(self) -> float:
        """Of all that is known."""
        return sum(part for part in (self.space, self.time, self.section) if part is not None)

    def to_dict(self, effects: float) -> dict[str, float | None]:
        """What ``summary.json`` holds; no total unless grid and time steps were both looked at.

        What the effects that were left out would change is no part of it: the answer is held to the accuracy asked with
        the effects in force. Nor is the phase.
        """
        total = None if self.space is None or self.time is None else self.total
        parts = {name: getattr(self, name) for name in ("space", "time", "section")}
        return {"total": total, **parts, "effects": effects, "phase": self.phase}


@dataclass(frozen=True)
class Before:
    """Errors found at an earlier resolution of the same scene."""

    at: Resolution
    found: Differences


def differences(
    answer: Floats, at: Resolution, run: Runner, judge: Judge, accuracy: float, before: Before | None = None
) -> Differences:
    """Estimate the errors of an answer from its companions."""
    coarser = replace(at, cells=max(_MIN_CELLS, at.cells // 2))
    beside = run(coarser)
    if beside is None or not np.any(answer) or coarser.cells == at.cells:
        return Differences(None, None, None, None, (f"{coarser.cells} cells",))
    failed: list[str] = []

    def change(resolution: Resolution, name: str, share: float) -> Deviation | None:
        found = run(resolution)
        if found is None:
            failed.append(name)
            return None
        return judge.between(found, beside).over(abs(share))

    apart = judge.between(answer, beside)
    grid = 1 / ((at.cells / coarser.cells) ** ORDER - 1)
    space = Deviation(apart.size * grid, None if apart.phase is None else apart.phase * grid)
    late = None
    time = _time_known(at, before, accuracy)
    if time is None:
        order = RINGING_ORDER if judge.windows else 1
        # What has no answer with larger steps has one with smaller ones.
        for factor in (TIGHTER,) if judge.windows else (LOOSER, TIGHTER):
            stepped = replace(coarser, rtol=min(factor * at.rtol, 0.5))
            failed.clear()
            late = change(stepped, f"a tolerance of {stepped.rtol:.2g}", (stepped.rtol / at.rtol) ** order - 1)
            if late is not None:
                break
        time = None if late is None else late.size
    same_section = before is not None and (before.at.fibres, before.at.order) == (at.fibres, at.order)
    section = before.found.section if before is not None and same_section else None
    if section is None and (other := _other_fibres(coarser, before)) != coarser:
        ratio = (other.fibres or 1) / (coarser.fibres or 1) if other.order is None else MORE
        across = change(other, f"{other.fibres or other.order} fibres", 1 - ratio**-SECTION_ORDER)
        section = None if across is None else across.size
    phases = [part.phase for part in (space, late) if part is not None and part.phase is not None]
    return Differences(space.size, time, section, sum(phases) if phases else None, tuple(failed))


def _time_known(at: Resolution, before: Before | None, accuracy: float) -> float | None:
    """Error of the time steps by an earlier one, where it was small; it falls at least as fast as the tolerance."""
    if before is None or before.found.time is None or before.found.time > SMALL * accuracy:
        return None
    return before.found.time * at.rtol / before.at.rtol


def _other_fibres(coarser: Resolution, before: Before | None) -> Resolution:
    """More fibres; or else fewer, those of an earlier answer: their library is there, and runs fast."""
    if before is not None and before.at.fibres is not None and coarser.order is None:
        return replace(coarser, fibres=before.at.fibres)
    return with_more_fibres(coarser, MORE)


def with_more_fibres(resolution: Resolution, factor: float) -> Resolution:
    """More fibres by about a factor, or a higher order; the same where the section has neither.

    Fibres come in few numbers, so that scenes share what is compiled for them.
    """
    if resolution.order is not None:
        return replace(resolution, order=max(resolution.order + 1, round(factor * resolution.order)))
    if resolution.fibres is not None:
        enough = factor * resolution.fibres
        return replace(resolution, fibres=next((n for n in FIBRE_NUMBERS if n >= enough), 2 * round(enough / 2)))
    return resolution
