"""How much shorter the cells at a clamp are than those at midspan: the ratio that a scene calls for.

Next to a clamp the curvature changes over a short length: that of a bending layer, sqrt(EI/T) where tension carries the
weight, or of a hinge, where the section yields. Equal cells spend themselves where nothing happens. The ratios below
were measured on the bundled scenes, as the largest error of the midpoint over the run at 10 to 80 cells a half span.
"""

from __future__ import annotations

import numpy as np

from softcat_sym.effects import Effects, choose_effects
from softcat_sym.effects.prediction import beam_of, first_yield_gravity_number, gravity_number_of
from softcat_sym.effects.quasi_static import load_factor
from softcat_sym.effects.resonance import shaken_share
from softcat_sym.scene import Scene, groups_of

LEAST = 3.0
"""Without a hinge a shearing filament is smooth at its clamps, and so is the small-deflection model: cells are soon
missed at midspan, and a ratio of 10 costs more than it gains."""

MOST = 30.0
"""Beyond it the cells at midspan, 3.5 times as long as equal ones, carry the error."""

SMOOTH_KIRCHHOFF = 10.0
"""A filament that does not shear has its moment, and with it the largest error, at the clamp even while elastic."""

_HEAVY = 2.0
"""Load of weight and filament, in that of the filament, from which on the weight makes a hinge of its own."""

HINGE_CELL = 1 / 15
"""Shortest cell over thickness at the hinge of a shearing filament: it bends and shears within about a thickness, and
at h0/L = 0.03 the error of the arrested filament falls from 1 % to 0.1 % as that cell shrinks from 1/5 to 1/10."""


def choose_grading(scene: Scene, cells: int, effects: Effects | None = None) -> float:
    """Choose the ratio of the longest cell to the shortest; 1 where no end is clamped or nothing bends.

    Parameters
    ----------
    scene : Scene
        Its ends, effects and groups decide.
    cells : int
        Cells per half span. Only a hinge depends on them: the more there are, the sooner its cell is short enough. Who
        compares grids to estimate an error keeps the ratio of the coarsest, so that all lie on one map.
    effects : Effects
        Those in force; without them, what the scene calls for.

    Returns
    -------
    float
        Between 1 and 30; what ``grading`` of :func:`softcat_sym.graph.half_span` takes.
    """
    names = (effects or choose_effects(scene)).names
    if "clamped" not in (scene.ends.left, scene.ends.right) or "bending" not in names:
        return 1.0
    hinge = "yielding" in names and may_yield(scene)
    if scene.model == "small-deflection":
        return LEAST
    if "shear" in names or "fibres" in names:
        return _ratio_for(HINGE_CELL * groups_of(scene).delta, cells) if hinge else LEAST
    return MOST if hinge else SMOOTH_KIRCHHOFF


def towards_middle(scene: Scene, effects: Effects | None = None) -> bool:
    """Whether cells are to be short at midspan too: a weight that hangs there makes a hinge under it.

    With a weight of the filament's own, cells that are long there leave 0.15 % of error on 40 cells, of first order,
    which a comparison of two grids finds too small by a factor of three; short ones leave 0.02 %. A weight of less than
    half the filament's own makes no such hinge.
    """
    names = (effects or choose_effects(scene)).names
    return {"bending", "yielding"} <= set(names) and load_factor(scene) > _HEAVY and may_yield(scene)


def may_yield(scene: Scene) -> bool:
    """Whether a fibre yields under a load at once, with at most twice the static moment, and what shaking adds."""
    gravity_number = gravity_number_of(scene)
    bound = float(beam_of(scene).overshoot_bound) + shaken_share(scene)
    return gravity_number is not None and gravity_number * bound > first_yield_gravity_number(scene)


def _ratio_for(shortest: float, cells: int) -> float:
    """Ratio r at which the shortest of many cells in geometric progression, L ln r/(2 N (r - 1)), is `shortest` L."""
    ratios = np.geomspace(LEAST, MOST, 100)
    found = np.log(ratios) / (2 * cells * (ratios - 1))
    # np.interp wants ascending abscissae, and stays at the ends of the range beyond them.
    return float(np.interp(-shortest, -found, ratios))
