"""Whether an answer may be trusted."""

from __future__ import annotations

import numpy as np

from softcat_sym.effects import Effects
from softcat_sym.effects.necking_gradient import NECKING_GRADIENT
from softcat_sym.effects.necks import neck_length
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene
from softcat_sym.solve import Outcome, Solution
from softcat_sym.trajectory.localisation import neck_that_the_grid_decides


def verdict(
    scene: Scene, effects: Effects, solution: Solution, fields: dict[str, Floats], nodes: Floats, residual: float
) -> tuple[Outcome, str]:
    """Decide: first a neck that the grid decides, then a failed integration, then an energy balance that stays open.

    Parameters
    ----------
    scene, effects
        What was asked.
    solution : Solution
        How the integration ended.
    fields : dict of str to ndarray
        Of the whole span; strain is looked at in the last frame.
    nodes : ndarray
        X of the nodes [m].
    residual : float
        Of the energy balance; zero where it says nothing.

    Returns
    -------
    Outcome, str
        And the complaint.
    """
    # Without a yield stress a neck only grows with the strain itself: one is drawn out where the filament is.
    runs_away = {NECKING_GRADIENT.name, YIELDING.name} <= set(effects.names)
    length = neck_length(scene) if runs_away else None
    # An elastic filament is as uneven as its load: only flow gathers strain.
    flows = VISCOUS_FLOW.name in effects.names
    neck = neck_that_the_grid_decides(fields["stretch"][-1], np.diff(nodes), length) if flows else ""
    if neck:
        return Outcome.localised, "; ".join(filter(None, [neck, solution.complaint]))
    if not solution.outcome.is_success:
        return solution.outcome, solution.complaint
    if residual > scene.run.accuracy:
        return Outcome.energy_drift, f"energy residual {residual:.2g} against an accuracy of {scene.run.accuracy:g}"
    return Outcome.solved, ""
