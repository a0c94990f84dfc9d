"""The loop: run, estimate, refine, until the answer is as accurate as was asked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from softcat_sym.accuracy.companions import Before, Differences, Runner, differences
from softcat_sym.accuracy.deviation import Judge
from softcat_sym.accuracy.refining import refined
from softcat_sym.accuracy.resolution import Resolution
from softcat_sym.scene import Scene

ROUNDS = 4
"""Runs that are tried, the first included."""


@dataclass(frozen=True)
class Controlled:
    """How the loop ended.

    Attributes
    ----------
    resolution : Resolution
        Of the answer.
    found : Differences or None
        Its estimated errors; None if the answer itself is not to be trusted.
    refinements : tuple of str
        What was made finer, and why, run by run.
    """

    resolution: Resolution
    found: Differences | None
    refinements: tuple[str, ...]


def controlled(
    scene: Scene,
    first: Resolution,
    answer: Runner,
    companion: Runner,
    grading: Callable[[int], float],
    periods: float = 0.0,
) -> Controlled:
    """Run until the estimated error is below the accuracy asked, or nothing that may be chosen would help.

    Parameters
    ----------
    scene : Scene
        What is asked.
    first : Resolution
        Where to begin.
    answer : Runner
        Runs for good; the last call is the answer. None if a run is not to be trusted for another reason.
    companion : Runner
        Runs for the estimate.
    grading : callable
        Of grids of so many cells.
    periods : float
        Of the lowest mode in the run; zero where nothing rings.
    """
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
