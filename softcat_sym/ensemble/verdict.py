"""Whether a member may be trusted, as far as its first and last frame tell."""

from __future__ import annotations

import numpy as np

from softcat_sym.effects.necking_gradient import NECKING_GRADIENT
from softcat_sym.effects.necks import neck_length
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.ensemble.members import Member
from softcat_sym.scene import rest_length
from softcat_sym.solve import Outcome, Prepared, Solution
from softcat_sym.trajectory.energy import energy_residual
from softcat_sym.trajectory.fields import least_energy, node_positions, whole_span_fields
from softcat_sym.trajectory.localisation import neck_that_the_grid_decides


def verdict(member: Member, prepared: Prepared, solution: Solution) -> tuple[Outcome, str, float]:
    """Outcome, complaint and energy residual of a run.

    Parameters
    ----------
    member : Member
        What was asked.
    prepared : Prepared
        How it was integrated.
    solution : Solution
        Its first and its last frame are enough: the energy balance is closed between these two, where `simulate` looks
        at every frame, and the last one shows whether strain has gathered in one cell.

    Returns
    -------
    Outcome, str, float
        A neck that the grid decides first, then a failed integration, then an energy balance that does not close.
    """
    scene, names = member.scene, member.effects.names
    fields = whole_span_fields(scene, prepared, solution)
    residual = energy_residual(fields, least_energy(scene))
    neck = ""
    if VISCOUS_FLOW.name in names:
        runs_away = {NECKING_GRADIENT.name, YIELDING.name} <= set(names)
        lengths = np.diff(node_positions(prepared.graph, rest_length(scene))[0])
        neck = neck_that_the_grid_decides(fields["stretch"][-1], lengths, neck_length(scene) if runs_away else None)
    if neck:
        return Outcome.localised, "; ".join(filter(None, [neck, solution.complaint])), residual
    if not solution.outcome.is_success:
        return solution.outcome, solution.complaint, residual
    audited = prepared.graph.conserves_energy and prepared.integration is not None
    if audited and residual > scene.run.accuracy:
        complaint = f"energy residual {residual:.2g} against an accuracy of {scene.run.accuracy:g}"
        return Outcome.energy_drift, complaint, residual
    return Outcome.solved, "", residual
