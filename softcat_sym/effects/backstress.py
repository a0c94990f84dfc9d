"""Backstress: flow in one direction lowers the yield stress in the other direction (Bauschinger effect).

Every fibre has kinematic hardening with dynamic recovery; together with the effect structure it is the MIKH model.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, held_up
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.scene.scene import Scene


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    material = scene.material
    decay = material.hardening_recovery * motion.strain
    stress = (material.hardening_modulus or 0.0) * motion.strain * (-math.expm1(-decay) / decay if decay else 1.0)
    change = stress / (stress + material.threshold) if stress else 0.0
    meaning = "backstress over backstress and yield stress, times the stress that flow relaxes"
    change *= motion.relaxed
    return Estimate(motion.amplified(change), meaning, "relaxed chi/(chi + sigma_Y)", held_up(change))


BACKSTRESS = Effect(
    name="backstress",
    summary="kinematic hardening with dynamic recovery, fibre by fibre: the stress minus C A drives the flow",
    source="Armstrong & Frederick 1966; Dimitriou & McKinley 2014",
    contribute=partial(replace, hardens=True),
    applies=lambda scene: (
        scene.model == "filament" and scene.run.closure == "material" and scene.material.hardening_modulus is not None
    ),
    without_it=f"the scene has no material.hardening_modulus, asks for the printed closure, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="the same, from the strain and the share of flow in a run",
    example="modelling-clay",
    derivation="19_structure",
    needs=("fibres", "yielding"),
    in_paper=False,
)
