"""Whether a member may be trusted, as far as its first and last frame tell."""

from __future__ import annotations

from softcat_sym.ensemble.members import Member
from softcat_sym.scene import rest_length
from softcat_sym.solve import Outcome, Prepared, Solution
from softcat_sym.trajectory.energy import energy_residual
from softcat_sym.trajectory.fields import least_energy, node_positions, whole_span_fields
from softcat_sym.trajectory.verdict import verdict as trajectory_verdict


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
    scene = member.scene
    fields = whole_span_fields(scene, prepared, solution)
    residual = energy_residual(fields, least_energy(scene))
    audited = residual if prepared.graph.conserves_energy and prepared.integration is not None else 0.0
    nodes = node_positions(prepared.graph, rest_length(scene))[0]
    return *trajectory_verdict(scene, member.effects, solution, fields, nodes, audited), residual
