"""Structure: a thixotropic material builds up its yield stress at rest, and loses it in flow.

Every fibre has a structure parameter, so that a flowing hinge is soft while the rest of the strand is not (Moore 1959;
Roussel 2006; de Souza Mendes & Thompson 2013).
"""

from __future__ import annotations

from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.scene import Scene


def _adapted(scene: Scene, terms: Terms) -> Terms:
    structure = scene.material.structure
    if structure is None:
        return terms
    given, linear = tuple(sorted(structure.numbers)), structure.growth == "linear"
    return replace(terms, structure=given, builds_up_without_limit=linear)


def _share(scene: Scene, strain: float) -> float:
    """Largest relative change of yield stress or viscosity within the run, by rest and by flow to this strain."""
    structure, material = scene.material.structure, scene.material
    if structure is None:
        return 0.0
    limit, viscosity = (
        None if value is None else float(value) for value in (material.yield_stress, material.viscosity)
    )
    start = structure.start(limit)
    begin, duration = structure.grown(start, structure.rest), scene.run.duration
    broken = (structure.breakdown_time * strain / duration) ** structure.exponent
    settled = 1 / broken if structure.growth == "linear" and broken else 1 / (1 + broken)
    moved = max(
        abs(structure.grown(begin, duration) - start), abs(settled - begin) if broken else 0.0, abs(begin - start)
    )
    changes = [0.0]
    high, low = structure.structured_yield_stress, structure.destroyed_yield_stress
    if limit and (high is not None or low is not None):
        changes.append(((limit if high is None else high) - (limit if low is None else low)) / limit * moved)
    if viscosity and structure.structured_viscosity is not None:
        changes.append(abs(structure.structured_viscosity / viscosity - 1) / (1 - start) * moved)
    if viscosity and structure.destroyed_viscosity is not None:
        changes.append(abs(1 - structure.destroyed_viscosity / viscosity) / start * moved)
    return max(changes)


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    change = motion.amplified(min(1.0, _share(scene, motion.strain) * motion.relaxed))
    meaning = "change of the yield stress or the viscosity within the run, times the stress that flow relaxes"
    return Estimate(change, meaning, "relaxed (sigma_Y(T)/sigma_Y - 1)")


STRUCTURE = Effect(
    name="structure",
    summary="build-up at rest and breakdown in flow of yield stress and viscosity, fibre by fibre",
    source="Moore 1959; Roussel 2006; de Souza Mendes & Thompson 2013",
    adapt=_adapted,
    applies=lambda scene: (
        scene.model == "filament" and scene.run.closure == "material" and scene.material.structure is not None
    ),
    without_it=f"the scene has no [material.structure], asks for the printed closure, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="the same, from the strain and the share of flow in a run",
    example="printed-lintel",
    derivation="19_structure",
    needs=("fibres",),
    in_paper=False,
)
