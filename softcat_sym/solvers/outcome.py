"""Outcomes of runs; the value of each member is the advice."""

from __future__ import annotations

from collections.abc import Mapping
from enum import Enum
from typing import Any

THREAD = 1000.0
"""Stretch beyond which a filament is a mere thread, a thirtieth as thick, for which the theory does not hold."""

POLYMER_THREAD = 1e6
"""The same limit for polymer chains, which stiffen and draw out an even thread: a thousandth of the thickness."""


class Outcome(Enum):
    """End of a run; ``Outcome.x.name`` goes into the summary, ``Outcome.x.value`` tells the user what to do."""

    solved = "the whole run was integrated; no check refuses the answer"
    broken = (
        "a fibre has reached what the material bears, and the filament breaks: the answer holds up to then; for a span "
        "that lasts, shorten it, thicken the filament, or take a material that bears more"
    )
    localised = (
        "strain gathers in one cell and the answer changes with the grid: without the effect necking-gradient nothing "
        "stops a neck, and with it the filament is near rupture; do not trust the sag: take the effect in, or lower "
        "gravity, thicken the filament or raise the yield stress"
    )
    ruptured = (
        "the filament is drawn out beyond what its material can bear: the run ends there; it is too heavy or too weak, "
        "or its supports go too far: lower gravity, shorten run.duration, thicken the filament or stiffen the material"
    )
    descends = (
        "nothing holds the filament and it falls for ever: the run ends there, what it shows up to then holds, and no "
        "later time shows more; for a filament that stops, raise the yield stress, thicken it or shorten the span, and "
        "for its fall alone shorten run.duration"
    )
    interrupted = (
        "the run was stopped before it was finished, by Ctrl-C or a time limit: what there is was computed as asked, "
        "but not checked; run it again, with more time, a shorter run.duration or a larger run.accuracy"
    )
    compressed = (
        "a string that does not bend is pushed together: it would fold at every length, and the answer changes with "
        "the grid; take in the effect bending, or keep the supports apart"
    )
    penetrated = (
        "the filament sinks into a floor or a pillar by more than the accuracy allows: state a smaller penetration in "
        "its table, or more numerics.cells where an edge is sharp"
    )
    energy_drift = (
        "the energy balance is off by more than the accuracy asked: tighten numerics.rtol, take more numerics.cells, "
        "or ask for a smaller run.accuracy"
    )
    inaccurate = (
        "the estimated error stayed above twice the accuracy asked after whatever refinement the scene allows: ask for "
        "a larger run.accuracy, or shorten the run"
    )
    missing_effect = (
        "an effect that was left out matters more than the accuracy asked, and the run was not repeated once more: "
        "name the effects in run.effects, or ask for a larger run.accuracy"
    )
    step_limit = (
        "the integrator ran out of steps: loosen numerics.rtol, shorten run.duration, or try another numerics.solver"
    )
    no_convergence = (
        "the integrator could not converge with its smallest step: try another numerics.solver, a tighter "
        "numerics.rtol, or a load.ramp"
    )
    non_finite = "the state became infinite or undefined: the filament has run away or ruptured; shorten run.duration"
    no_equilibrium = (
        "without inertia the filament must begin in equilibrium and none was found: keep the inertia effect, or bending"
    )

    @property
    def is_success(self) -> bool:
        """Whether the answer may be used."""
        return self is Outcome.solved

    @property
    def is_answer(self) -> bool:
        """Whether the run shows what the filament does, as far as it goes: breaking is not a failure of the run."""
        return self in (Outcome.solved, Outcome.broken)


ANSWERS = tuple(outcome.name for outcome in Outcome if outcome.is_answer)
"""Names of the outcomes whose answer may be used."""


def refused(summary: Mapping[str, Any]) -> str:
    """Outcome of a result that is refused; empty of one that may be used, or of which nothing is known."""
    outcome = str(summary.get("outcome") or "")
    return "" if outcome in ANSWERS else outcome
