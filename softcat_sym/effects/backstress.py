"""Backstress: flow in one direction lowers the yield stress in the other direction (Bauschinger effect).

Every fibre has kinematic hardening with dynamic recovery; together with the effect structure it is the MIKH model.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, Motion, held_up
from softcat_sym.scene.scene import Scene


def _applies(scene: Scene) -> bool:
    given = scene.material.hardening_modulus is not None
    return scene.model == "filament" and scene.run.closure == "material" and given


def _hardened(scene: Scene, strain: float) -> float:
    """Backstress after flow by this strain [Pa]."""
    material = scene.material
    decay = material.hardening_recovery * strain
    return (material.hardening_modulus or 0.0) * strain * (-math.expm1(-decay) / decay if decay else 1.0)


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    stress = _hardened(scene, motion.strain)
    limit = scene.material.threshold
    change = stress / (stress + limit) if stress else 0.0
    meaning = "backstress over backstress and yield stress, times the stress that flow relaxes"
    change *= motion.relaxed
    return Estimate(motion.amplified(change), meaning, "relaxed chi/(chi + sigma_Y)", held_up(change))


BACKSTRESS = Effect(
    name="backstress",
    summary="kinematic hardening with dynamic recovery, fibre by fibre: the stress minus C A drives the flow",
    source="Armstrong & Frederick 1966; Dimitriou & McKinley 2014",
    contribute=partial(replace, hardens=True),
    applies=_applies,
    without_it=f"the scene has no material.hardening_modulus, asks for the printed closure, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="the same, from the strain and the share of flow in a run",
    example="modelling-clay",
    derivation="19_structure",
    needs=("fibres", "yielding"),
    in_paper=False,
)
