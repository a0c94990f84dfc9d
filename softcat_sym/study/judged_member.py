"""A member of a table run once and judged as a single run is: every frame looked at, its regime named."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

from softcat_sym.ensemble.members import Member
from softcat_sym.ensemble.running import Stop
from softcat_sym.ensemble.shared import Workshop
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import rest_length
from softcat_sym.solve import Outcome, Prepared, Solution
from softcat_sym.trajectory.checking import measures, overlooked
from softcat_sym.trajectory.energy import energy_residual
from softcat_sym.trajectory.fields import least_energy, node_positions, whole_span_fields
from softcat_sym.trajectory.regime import regime_of
from softcat_sym.trajectory.seen import seen
from softcat_sym.trajectory.verdict import verdict

_SORTS = 16
"""Sorts of filament that are remembered from block to block: their graphs are what takes memory."""


@dataclass(frozen=True)
class JudgedMember:
    """A finished run.

    Attributes
    ----------
    prepared : Prepared
        How it was integrated.
    solution : Solution
        What came out.
    fields : dict of str to ndarray
        Over the whole span, as from :func:`softcat_sym.trajectory.fields.whole_span_fields`.
    nodes, cells : ndarray
        Their material coordinates [m].
    midpoint : ndarray, shape (frames,)
        Height of midspan [m].
    outcome : Outcome
        How it ended.
    complaint : str
        Why, if that was no success.
    energy_residual : float
        Of the balance at every frame.
    regime : str or None
        What the run shows; None if it is no answer.
    overlooked : dict of str to str
        Effects that ``auto`` has left out and that the run shows to matter, and how: a single run would be repeated.
    """

    prepared: Prepared
    solution: Solution
    fields: dict[str, Floats]
    nodes: Floats
    cells: Floats
    midpoint: Floats
    outcome: Outcome
    complaint: str
    energy_residual: float
    regime: str | None
    overlooked: dict[str, str]


def judged(member: Member, workshop: Workshop, stop: Stop) -> JudgedMember:
    """Integrate a member and judge it by all its frames.

    Parameters
    ----------
    member : Member
        Which.
    workshop : Workshop
        What it shares with others.
    stop : Stop
        Ends it from outside.

    Raises
    ------
    KeyboardInterrupt
        If it is told to stop.
    SoftcatError
        If the compiler refuses.
    """
    stop.update(0.0, None)
    scene = member.scene
    prepared = workshop.prepare(member)
    solution = prepared.solve(stop)
    fields = whole_span_fields(scene, prepared, solution)
    nodes, cells = node_positions(prepared.graph, rest_length(scene))
    residual = energy_residual(fields, least_energy(scene))
    audits = prepared.graph.conserves_energy and prepared.integration is not None
    outcome, complaint = verdict(scene, member.effects, solution, fields, nodes, residual if audits else 0.0)
    midpoint = fields["y"][:, fields["y"].shape[1] // 2]
    regime = regime_of(scene, member.effects, fields, midpoint) if outcome.is_success else None
    missing = _overlooked(member, solution.time * prepared.scale, (nodes, cells), fields, outcome)
    return JudgedMember(
        prepared, solution, fields, nodes, cells, midpoint, outcome, complaint, residual, regime, missing
    )


def _overlooked(
    member: Member, time: Floats, places: tuple[Floats, Floats], fields: dict[str, Floats], outcome: Outcome
) -> dict[str, str]:
    """What the program has left out of a member and the finished run calls for."""
    if member.scene.run.effects != "auto":
        return {}
    motion = seen(member.scene, member.effects, time, places, fields)
    return overlooked(member.scene, member.effects, measures(member.scene, member.effects, motion), outcome)


@lru_cache(maxsize=2)
def shared_workshop(plan: str) -> Workshop:
    """What the blocks of a plan share in this process; `plan` is any text that tells plans apart."""
    del plan
    return Workshop(_SORTS)
