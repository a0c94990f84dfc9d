"""The converged one-dimensional answer that programs are judged by, and how far it can be trusted.

Space: the compiled fifth-order Rosenbrock method on three nested grids, each with twice the cells and the fibres of
the one before; the error falls as the square, and is extrapolated away (Richardson 1911). Time: on the middle grid,
with the scene's own section, the same method is held against BDF, another family in another code.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.graph.grid import Floats
from softcat_sym.study.work_precision_task import Measured, Task

_GRIDS = (40, 80, 160)
_MIDDLE = 1
_TIGHT = 1e-7
_BDF_TOLERANCES = (1e-7, 1e-6, 1e-5)
_REMAINDER = 7
"""What is left of an extrapolated answer falls at least as the third power: by 8 from grid to grid."""

Measure = Callable[[Task], Measured]


@dataclass(frozen=True)
class Reference:
    """A midpoint for vanishing cells and steps.

    Attributes
    ----------
    midpoint : ndarray, shape (frames,)
        In rest lengths.
    space : float
        How much the answer may still change with the grid, of its largest.
    time : float
        How far the two families are apart on one grid, of the largest; NaN if the second gave no answer.
    families : tuple of str
        Of the two.
    note : str
        What was run.
    """

    midpoint: Floats
    space: float
    time: float
    families: tuple[str, str]
    note: str

    @property
    def floor(self) -> float:
        """The error below which nothing can be read off."""
        return max(self.space, self.time if np.isfinite(self.time) else 0.0)

    def error_of(self, midpoint: tuple[float, ...]) -> float:
        """Largest difference from it over the largest it has; infinite where the midpoint is not finite."""
        if len(midpoint) != len(self.midpoint):
            return np.inf
        difference = np.max(np.abs(np.array(midpoint) - self.midpoint))
        return float(difference / self.scale) if np.isfinite(difference) else np.inf

    @property
    def scale(self) -> float:
        """Largest distance of the midpoint from the chord."""
        return float(np.max(np.abs(self.midpoint)))


def reference_of(measure: Measure, grading: float, section: int, *, compiled: bool) -> Reference:
    """Measure the reference.

    Parameters
    ----------
    measure : callable
        Runs a task.
    grading : float
        Of all grids, so that they are nested.
    section : int
        Fibres of the scene itself, 0 if it has none.
    compiled : bool
        Whether there is a compiler.

    Raises
    ------
    SoftcatError
        If the scene cannot be solved tightly, or its midpoint does not move.
    """
    first = "compiled-rodas5p" if compiled else "rosenbrock"
    found = [_solved(measure, Task(first, n, grading, section * n // _GRIDS[0], rtol=_TIGHT)) for n in _GRIDS]
    scale = float(np.max(np.abs(found[-1])))
    if scale == 0:
        raise SoftcatError("the midpoint does not move: there is no error to measure")
    finer, coarser = (b + (b - a) / 3 for a, b in ((found[1], found[2]), (found[0], found[1])))
    space = float(np.max(np.abs(finer - coarser)) / _REMAINDER / scale)
    time, second = _of_time(measure, Task(first, _GRIDS[_MIDDLE], grading, section, rtol=_TIGHT), scale)
    grids = ", ".join(map(str, _GRIDS))
    note = f"{first} at rtol {_TIGHT:.0e} on {grids} cells, extrapolated; {second} on {_GRIDS[_MIDDLE]} cells"
    return Reference(finer, space, time, ("Rosenbrock", "BDF"), note)


def _of_time(measure: Measure, task: Task, scale: float) -> tuple[float, str]:
    """How far BDF is from a tight answer on one grid, and what it was run with."""
    own = _solved(measure, task)
    for rtol in _BDF_TOLERANCES:
        other = measure(Task("idas", task.cells, task.grading, task.section, rtol=rtol))
        if not other.complaint:
            return float(np.max(np.abs(np.array(other.midpoint) - own)) / scale), f"IDAS at rtol {rtol:.0e}"
    return float("nan"), f"IDAS gave no answer ({other.complaint})"


def _solved(measure: Measure, task: Task) -> Floats:
    found = measure(task)
    if found.complaint:
        raise SoftcatError(f"no reference: {task.program}, {task.text}: {found.complaint}")
    return np.array(found.midpoint)
