"""What an answer is resolved with: cells, fibres and time steps."""

from __future__ import annotations

from dataclasses import dataclass

from softcat_sym.discretization.assembly import choose_cells, choose_fibres
from softcat_sym.discretization.grid import choose_grading
from softcat_sym.effects.choosing import Effects
from softcat_sym.effects.fibres import FIBRES
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
        changes: dict[str, object] = {
            "numerics.cells": self.cells,
            "numerics.grading": self.grading,
            "numerics.rtol": self.rtol,
        }
        if self.order is not None:
            changes["numerics.order"] = self.order
        elif self.fibres is not None:
            changes["numerics.fibres"] = self.fibres
        return scene.replace(changes)


def resolution_of(scene: Scene, effects: Effects, *, compiled: bool) -> Resolution:
    """What the scene says, and otherwise the program's first guess."""
    cells, numerics = choose_cells(scene, effects), scene.numerics
    resolved = FIBRES.name in effects.names
    return Resolution(
        cells,
        numerics.grading or choose_grading(scene, cells, effects),
        choose_fibres(scene) if resolved and numerics.order is None else None,
        numerics.order if resolved else None,
        settings_for(scene, effects, compiled=compiled).rtol,
    )
