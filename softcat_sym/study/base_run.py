"""The run against which effects are priced, and the grid that all runs share."""

from __future__ import annotations

from typing import TYPE_CHECKING

from softcat_sym.graph.grading import choose_grading
from softcat_sym.simulate import simulated
from softcat_sym.solve.keeping import Form, json_form, kept
from softcat_sym.study.priced_run import PricedRun, from_plain, plain, priced_run
from softcat_sym.study.variants import Names, with_effects

if TYPE_CHECKING:
    from softcat_sym.scene import Scene
    from softcat_sym.solve import Progress

_FORM: Form[tuple[int, float, PricedRun]] = json_form(
    lambda found: [*found[:2], plain(found[2])], lambda told: (int(told[0]), told[1], from_plain(told[2]))
)


def base_run(scene: Scene, listener: Progress) -> tuple[int, float, PricedRun]:
    """Run a scene as it is.

    Parameters
    ----------
    scene : Scene
        Without an error estimate.
    listener : Progress
        Told how far it is.

    Returns
    -------
    cells, grading : int, float
        Cells per half span, and longest over shortest cell, of every run.
    run : PricedRun
        The base.
    """
    return kept(lambda: ("base", scene.to_toml()), lambda: _base_run(scene, listener), _FORM)


def _base_run(scene: Scene, listener: Progress) -> tuple[int, float, PricedRun]:
    first = simulated(scene, listener)
    names, cells = tuple(first.summary["effects"]), int(first.summary["cells"])
    listed = on_grid(scene, names, cells)
    # Theories grade their grids differently: on one grid only physics differs.
    grading = scene.numerics.grading or choose_grading(listed, cells)
    return cells, grading, priced_run(listed.replace({"numerics.grading": grading}), listener, first)


def on_grid(scene: Scene, names: Names, cells: int) -> Scene:
    """The scene with these effects, and so many cells per half span."""
    return with_effects(scene.replace({"numerics.cells": cells}), names)
