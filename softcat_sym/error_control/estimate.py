"""The error of an answer, split by where it comes from, by companion runs on other grids, steps and fibres."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from softcat_sym.discretization.assembly import choose_cells, choose_fibres
from softcat_sym.discretization.grid import choose_grading
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import Effects
from softcat_sym.results.motion import MIN_PERIODS
from softcat_sym.results.observed import DISPLACEMENT, OWN, Series, Watched
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
    """Of one run from another."""

    sizes: Mapping[str, float]  # Largest difference of each quantity over the run, relative to its largest value
    # Periods by which the one is ahead of the other at the end; None where runs are compared instant by instant.
    phase: float | None

    @property
    def size(self) -> float:
        """That of the displacement."""
        return self.sizes[DISPLACEMENT]

    def over(self, share: float) -> Deviation:
        """The error of which this is a share."""
        sizes = {name: size / share for name, size in self.sizes.items()}
        return Deviation(sizes, None if self.phase is None else self.phase / share)


@dataclass(frozen=True)
class Judge:
    """Compares what was observed of runs, by the size of an answer."""

    scale: Mapping[str, float]  # Largest value of each quantity
    # Stretches over which height and amplitude are taken; none where it is compared instant by instant.
    windows: tuple[slice, ...]
    of_modes: float = 0.0  # Error of an answer that ends by its modes of vibration, as companions do that share it

    @classmethod
    def of(cls, answer: Series, watched: Watched, periods: float, accuracy: float) -> Judge:
        """Judge by an answer, and by how large it is."""
        moved, scale = answer[DISPLACEMENT], {name: watched.scale[name] for name in watched.at}
        frames = len(moved)
        number = int(min(periods / WINDOW_PERIODS, frames / WINDOW_FRAMES))
        if periods < MIN_PERIODS or number < 2:
            return cls(scale, ())
        edges = np.linspace(0, frames, number + 1).astype(int)
        windows = tuple(slice(int(a), int(b)) for a, b in pairwise(edges))
        rings = np.max(_swings(moved[windows[-1]].T)[:, 1]) > accuracy * scale[DISPLACEMENT]
        return cls(scale, windows if rings else ())

    def between(self, one: Series, other: Series) -> Deviation:
        """Deviation of two runs of the same scene at other resolutions."""
        if not self.windows:
            apart = {name: np.sqrt(np.sum((one[name] - other[name]) ** 2, axis=-1)) for name in self.scale}
            return Deviation({name: float(np.max(apart[name])) / scale for name, scale in self.scale.items()}, None)
        sizes, phase, widest = dict[str, float](), 0.0, 0.0
        for name, scale in self.scale.items():
            for ours, theirs in zip(one[name].T, other[name].T, strict=True):
                a, b = (self._swings(run) for run in (ours, theirs))
                sizes[name] = max(sizes.get(name, 0.0), float(np.max(np.abs(a[:, :2] - b[:, :2]))) / scale)
                if name == DISPLACEMENT and a[-1, 1] > widest:
                    turned = np.unwrap(a[:, 2] - b[:, 2]) / (2 * np.pi)
                    widest, phase = a[-1, 1], abs(float(turned[-1]))
        return Deviation(sizes, phase)

    def _swings(self, run: Floats) -> Floats:
        """Height, amplitude and phase in each window, shape (windows, 3)."""
        lengths, found = np.array([each.stop - each.start for each in self.windows]), np.empty((len(self.windows), 3))
        for length in np.unique(lengths):
            alike = np.flatnonzero(lengths == length)
            found[alike] = _swings(np.stack([run[self.windows[k]] for k in alike]))
        return found


def _swings(heights: Floats) -> Floats:
    """Height, amplitude and phase in the middle of windows of one length, shape (windows, 3).

    A constant, a drift and one oscillation are fitted by least squares, weighted towards the middle of the window, so
    that it matters little where in their swing other modes are cut off. What they leave counts as amplitude too.
    """
    windows, count = heights.shape
    along, weight = np.arange(count) - (count - 1) / 2, np.hanning(count + 2)[1:-1]
    base = np.stack([np.ones(count), along / count], axis=1)

    def fitted(columns: Floats) -> Floats:
        """Coefficients (windows, columns) of columns (windows, count, columns)."""
        weighted = np.swapaxes(columns * weight[:, None], 1, 2)
        # Of what does not swing, or from frame to frame, one column is nothing.
        matrix = weighted @ columns + 1e-13 * np.sum(weight) * np.eye(columns.shape[-1])
        return np.asarray(np.linalg.solve(matrix, weighted @ heights[..., None])[..., 0])

    flat = heights - fitted(base + np.zeros((windows, 1, 1))) @ base.T
    spectrum = np.abs(np.fft.rfft(flat * weight, _FINER * count))
    # Less than a cycle a window is drift.
    spectrum[:, :_FINER] = 0.0
    turn = 2 * np.pi * np.argmax(spectrum, axis=1)[:, None] / (_FINER * count) * along
    columns = np.stack([*np.broadcast_arrays(*base.T, turn)[:2], np.cos(turn), np.sin(turn)], axis=-1)
    found = fitted(columns)
    left = (heights - (columns @ found[..., None])[..., 0]) ** 2 @ weight / np.sum(weight)
    amplitude = np.sqrt(found[:, 2] ** 2 + found[:, 3] ** 2 + 2 * left)
    return np.stack([found[:, 0], amplitude, np.arctan2(-found[:, 3], found[:, 2])], axis=1)


Runner = Callable[[Resolution], Series | None]
"""What is observed of a run at a resolution; None where that run has no answer."""

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

FINER = 1.5
"""Factor of the cells from which an answer before is a coarse companion: closer grids tell their difference badly."""

FIBRE_NUMBERS = (8, 12, 16, 24, 32, 48, 64, 96)
"""Numbers of fibres that are tried."""

SECTION_ORDER = 2
"""Of the fibres: where a section yields from its surface inwards, the edge lies between two of them."""

SMALL = 0.2
"""Share of the accuracy below which an error of the time steps is not looked at again when they have become shorter."""

_MIN_CELLS = 4


PARTS = ("space", "time", "section")
"""Of an error."""


@dataclass(frozen=True)
class Differences:
    """Estimated errors of places over one run, relative to the largest displacement; None where they were not found.

    They are those of the midpoint and of the node that moves farthest. Of a filament that rings on to the end for ten
    periods or more they are those of the height about which it rings and of the amplitude, over every five periods.
    """

    space: float | None  # Of the grid, by Richardson's extrapolation from a coarser one
    time: float | None  # Of the time steps, from a looser tolerance, or a tighter one of a filament that rings on
    section: float | None  # Of the fibres or the order k, from more of them; None also where nothing is to be resolved
    phase: float | None  # Periods by which a ringing may be ahead or late at its end
    failed: tuple[str, ...]  # Companions that have no answer
    # Parts of what has errors of its own in three dimensions, relative to its own largest value, by name.
    own: Mapping[str, Mapping[str, float]] = field(default_factory=dict)

    def part(self, name: str) -> Deviation | None:
        """One of :data:`PARTS`; without a phase."""
        size = getattr(self, name)
        return None if size is None else Deviation({**self.own.get(name, {}), DISPLACEMENT: size}, None)

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
        parts = {name: getattr(self, name) for name in PARTS}
        known = self.own.values() if total is not None else ()
        own = {name: sum(each) if (each := [part[name] for part in known if name in part]) else None for name in OWN}
        return {"total": total, **parts, "effects": effects, "phase": self.phase, **own}


@dataclass(frozen=True)
class Before:
    """Errors found at an earlier resolution of the same scene."""

    at: Resolution
    found: Differences


def differences(
    answer: Series, at: Resolution, run: Runner, judge: Judge, accuracy: float, before: Before | None = None
) -> Differences:
    """Estimate the errors of an answer from its companions, or from the answer before it."""
    if before is not None and (known := _of_more_fibres(answer, at, run, judge, before)) is not None:
        return known
    coarser = _coarser(at, before)
    beside = run(coarser)
    if beside is None or coarser.cells == at.cells:
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
    space = apart.over(1 / grid)
    time = _time_known(at, before, accuracy)
    if time is None:
        order = RINGING_ORDER if judge.windows else 1
        # What has no answer with larger steps has one with smaller ones.
        for factor in (TIGHTER,) if judge.windows else (LOOSER, TIGHTER):
            stepped = replace(coarser, rtol=min(factor * at.rtol, 0.5))
            failed.clear()
            time = change(stepped, f"a tolerance of {stepped.rtol:.2g}", (stepped.rtol / at.rtol) ** order - 1)
            if time is not None:
                break
    same_section = before is not None and (before.at.fibres, before.at.order) == (at.fibres, at.order)
    section = before.found.part("section") if before is not None and same_section else None
    if section is None and (other := _other_fibres(coarser, before)) != coarser:
        ratio = (other.fibres or 1) / (coarser.fibres or 1) if other.order is None else MORE
        section = change(other, f"{other.fibres or other.order} fibres", 1 - ratio**-SECTION_ORDER)
    if time is not None:
        time = replace(time, sizes={**time.sizes, DISPLACEMENT: time.size + judge.of_modes})
    phases = [part.phase for part in (space, time) if part is not None and part.phase is not None]
    own = {name: part.sizes for name, part in zip(PARTS, (space, time, section), strict=True) if part is not None}
    a, b, c = (None if part is None else part.size for part in (space, time, section))
    return Differences(a, b, c, sum(phases) if phases else None, tuple(failed), own)


def _coarser(at: Resolution, before: Before | None) -> Resolution:
    """The answer before, if it differs only by fewer cells on the same map, and by enough; otherwise half the cells."""
    if before is not None and replace(before.at, cells=at.cells) == at and at.cells >= FINER * before.at.cells:
        return before.at
    return replace(at, cells=max(_MIN_CELLS, at.cells // 2))


def _of_more_fibres(answer: Series, at: Resolution, run: Runner, judge: Judge, before: Before) -> Differences | None:
    """Errors of an answer that has only more fibres than the one before: what grid and steps miss is what they did."""
    fewer, more = before.at.fibres, at.fibres
    if fewer is None or more is None or fewer >= more or replace(before.at, fibres=more) != at:
        return None
    earlier = run(before.at)
    if earlier is None or before.found.space is None:
        return None
    section = judge.between(answer, earlier).over((more / fewer) ** SECTION_ORDER - 1)
    return replace(before.found, section=section.size, failed=(), own={**before.found.own, "section": section.sizes})


def _time_known(at: Resolution, before: Before | None, accuracy: float) -> Deviation | None:
    """Error of the time steps by an earlier one, where it was small; it falls at least as fast as the tolerance."""
    known = None if before is None else before.found.part("time")
    if before is None or known is None or known.size > SMALL * accuracy:
        return None
    return known.over(before.at.rtol / at.rtol)


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
