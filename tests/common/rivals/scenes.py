"""The filaments that rivals run, and where their midpoints end, as `python -m tests.common.rivals.scenes` finds."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

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


# Of the grids of 160 and 320 cells with the rosenbrock method at rtol 1e-6; off by less than 4e-7.
_CONVERGED: dict[tuple[str, Physics], float] = {
    ("continual-descent", "paper"): -0.24427817,
    ("arrested-overdamped", "paper"): -0.06656782,
    ("continual-descent", "fibres"): -0.24936181,
    ("arrested-overdamped", "fibres"): -0.06645224,
}


def converged_midpoint(name: str, physics: Physics = "paper") -> float:
    """Midpoint at t~ = 460 in rest lengths, for vanishing cells and steps."""
    return _CONVERGED[name, physics]


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


if __name__ == "__main__":
    for case in _CONVERGED:
        ends = []
        for fine in _FINE:
            run = prepare(*case, fine, numerics={"solver": "rosenbrock", "rtol": _TIGHT})
            ends.append(float(run.solve(Silence()).x[run.graph.x_kinds.index("y"), -1]))
        print(case, ends[1] + (ends[1] - ends[0]) / 3)
