"""Runs whose errors are known: midpoint = exact + a/N^2 + b rtol + c/n^2, so that estimates can be judged."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from softcat_sym import Scene, load_scene
from softcat_sym.discretization.grid import Floats
from softcat_sym.error_control.resolution import Resolution

TIMES = np.linspace(0.0, 1.0, 11)
EXACT: Floats = -0.02 * TIMES
LARGEST = 0.02


@dataclass
class Known:
    """A runner with an error of each kind, relative to the largest midpoint."""

    space: float = 0.0
    time: float = 0.0
    section: float = 0.0
    order: float = 2.0
    fails_below: int = 0
    asked: list[Resolution] = field(default_factory=list)

    def parts(self, at: Resolution) -> tuple[float, float, float]:
        """Errors at a resolution."""
        return self.space / at.cells**self.order, self.time * at.rtol, self.section / at.fibres**2 if at.fibres else 0.0

    def __call__(self, at: Resolution) -> Floats | None:
        """Run."""
        self.asked.append(at)
        if at.cells < self.fails_below:
            return None
        return EXACT * (1 + sum(self.parts(at)))


def scene_of(accuracy: float = 1e-3, **numerics: object) -> Scene:
    """A scene that asks for an accuracy and fixes some numbers."""
    changes: dict[str, object] = {"run.accuracy": accuracy}
    return load_scene("continual-descent", changes | {f"numerics.{name}": value for name, value in numerics.items()})


FIRST = Resolution(cells=40, grading=10.0, fibres=8, order=None, rtol=1e-4)
LINEAR = Resolution(cells=40, grading=10.0, fibres=None, order=None, rtol=1e-4)


def graded(cells: int) -> float:
    """One grading for all grids."""
    return FIRST.grading
