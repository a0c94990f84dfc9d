"""Whether an answer may be trusted."""

from __future__ import annotations

import numpy as np

from softcat_sym.effects import Effects
from softcat_sym.effects.necking_gradient import NECKING_GRADIENT
from softcat_sym.effects.necks import neck_length
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.graph.grid import Floats
from softcat_sym.graph.parameters import time_scale
from softcat_sym.scene import Scene
from softcat_sym.solve import Outcome, Solution
from softcat_sym.trajectory.fields import least_energy
from softcat_sym.trajectory.localisation import neck_that_the_grid_decides
from softcat_sym.trajectory.rupture import gained_energy, rupture

_COMPRESSION = 0.02
"""Of the largest tension: what a string that does not bend may be compressed by."""


def verdict(
    scene: Scene, effects: Effects, solution: Solution, fields: dict[str, Floats], nodes: Floats, residual: float
) -> tuple[Outcome, str]:
    """Decide: a neck that the grid decides, a rupture, a failed integration, an energy balance that stays open.

    Parameters
    ----------
    scene, effects
        What was asked.
    solution : Solution
        How the integration ended.
    fields : dict of str to ndarray
        Of the whole span; a neck is looked for in the last frame, rupture in all.
    nodes : ndarray
        X of the nodes [m].
    residual : float
        Of the energy balance; zero where it says nothing.

    Returns
    -------
    Outcome, str
        And the complaint.
    """
    if solution.outcome is Outcome.no_equilibrium and not solution.steps:
        # Nothing was found to begin from: what the frame holds is no state of the filament.
        return solution.outcome, solution.complaint
    # Without a yield stress a neck only grows with the strain itself: one is drawn out where the filament is.
    runs_away = {NECKING_GRADIENT.name, YIELDING.name} <= set(effects.names)
    length = neck_length(scene) if runs_away else None
    # An elastic filament is as uneven as its load: only flow gathers strain.
    flows = VISCOUS_FLOW.name in effects.names
    neck = neck_that_the_grid_decides(fields["stretch"][-1], np.diff(nodes), length) if flows else ""
    if neck:
        return Outcome.localised, "; ".join(filter(None, [neck, solution.complaint]))
    torn = rupture(scene, solution.time * time_scale(scene), fields["stretch"], nodes)
    if torn:
        return Outcome.ruptured, "; ".join(filter(None, [torn, solution.complaint]))
    if not solution.outcome.is_success:
        return solution.outcome, solution.complaint
    if "bending" not in effects.names:
        pushed = _pushed_string(solution.time * time_scale(scene), fields.get("axial_force", fields["tension"]))
        if pushed:
            return Outcome.compressed, pushed
    gained = gained_energy(fields, least_energy(scene)) if solution.steps else ""
    if gained:
        return Outcome.energy_drift, gained
    if residual > scene.run.accuracy:
        return Outcome.energy_drift, f"energy residual {residual:.2g} against an accuracy of {scene.run.accuracy:g}"
    return Outcome.solved, ""


def _pushed_string(time: Floats, tension: Floats) -> str:
    """When a string without bending is pushed together, or an empty text: it has no stiffness against folds."""
    # Waves along a string leave traces of compression in the first order of the grid.
    pushed = np.flatnonzero(np.min(tension, axis=1) < -_COMPRESSION * np.max(tension))
    if not len(pushed):
        return ""
    share = -float(np.min(tension[pushed[0]])) / float(np.max(tension))
    return (
        f"by t = {time[pushed[0]]:.6g} s the string is pushed together with {share:.0%} of its largest tension: "
        "without bending that is ill-posed"
    )
