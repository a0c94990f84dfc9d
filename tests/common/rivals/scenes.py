"""The filaments that rivals run, and where their midpoints end, as `python -m tests.common.rivals.scenes` finds."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

import softcat_sym as sc
from softcat_sym.discretization.assembly import choose_grid
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.single_run import build
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Silence

Physics = Literal["paper", "fibres"]

CELLS = 40
FIBRES = 6
_TIGHT = 1e-6
_FINE = (160, 320)


@dataclass(frozen=True, slots=True)
class Converged:
    """A midpoint at the end of the run, in rest lengths, for vanishing cells and steps."""

    value: float
    error: float


# Of the grids of 160 and 320 cells with the rosenbrock method at rtol 1e-6; the error is a third of the correction.
_CONVERGED: dict[tuple[str, Physics], Converged] = {
    ("continual-descent", "paper"): Converged(-0.24427817, 2.8e-7),
    ("arrested-overdamped", "paper"): Converged(-0.06656782, 3.4e-7),
    ("continual-descent", "fibres"): Converged(-0.24936181, 0.6e-7),
    ("arrested-overdamped", "fibres"): Converged(-0.06645224, 1.7e-7),
}


def converged_midpoint(name: str, physics: Physics = "paper") -> float:
    """Midpoint at t~ = 460 in rest lengths, for vanishing cells and steps."""
    return _CONVERGED[name, physics].value


def converged_error(name: str, physics: Physics = "paper") -> float:
    """How far that number may be off."""
    return _CONVERGED[name, physics].error


def prepare(
    name: str,
    physics: Physics = "paper",
    cells: int = CELLS,
    *,
    frames: int = 2,
    numerics: Mapping[str, object] | None = None,
) -> Prepared:
    """A bundled scene, ready to be solved: with the paper's effects, or with shear and six fibres besides."""
    effects: str | list[str] = "paper"
    extra: dict[str, Any] = {"run.frames": frames}
    if physics == "fibres":
        published = choose_effects(sc.load_scene(name, {"run.effects": "paper"})).names
        effects = [*published, "shear", "fibres"]
        extra["numerics.fibres"] = FIBRES
    extra["run.effects"] = effects
    lengths = choose_grid(sc.load_scene(name, {**extra, "numerics.cells": CELLS})).cell_length
    extra |= {"numerics.cells": cells, "numerics.grading": float(lengths[0] / lengths[-1])}
    scene = sc.load_scene(name, {**extra, **{f"numerics.{key}": value for key, value in (numerics or {}).items()}})
    return build(scene, choose_effects(scene))


def extrapolate(name: str, physics: Physics = "paper") -> Converged:
    """Compute the converged midpoint."""
    found = []
    for cells in _FINE:
        run = prepare(name, physics, cells, numerics={"solver": "rosenbrock", "rtol": _TIGHT})
        solution = run.solve(Silence())
        found.append(float(solution.x[run.graph.x_kinds.index("y"), -1]))
    correction = (found[1] - found[0]) / 3
    return Converged(found[1] + correction, float(np.abs(correction) / 3))


if __name__ == "__main__":
    for key in _CONVERGED:
        print(key, extrapolate(*key))
