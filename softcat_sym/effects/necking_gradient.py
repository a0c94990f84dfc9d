"""Necking gradient: the slope of a neck's surface stiffens it, so that strain cannot concentrate in one section."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate, held_up
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.estimates import scaling as scales
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.scene.scene import Scene, carries_moment, is_held, rest_length

_UNEVENNESS = 4e-4
"""Initial unevenness of a neck, fitted so that one e-fold changes the sag of the paper's arrested filament by 1 %."""

_HINGE = 0.03
"""Change of the sag per e-fold with yielding hinges at clamps, which the gradient widens: within a factor of two in
``tests/studies/elements.py``, for up to two e-folds; too large later, when the hinges have stopped."""

_SHORT = 2.0
"""Sag over the length of a neck beyond which the hinges are a small share of what is drawn out."""

_BELOW = 0.5  # Largest fibre stress over the yield stress at which no section is foreseen to yield

_MANY_FOLDS = 30.0  # Limit of the e-folds, beyond which a neck has grown in any case


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    yields, held = motion.overstress > _BELOW, is_held(scene)
    # Below a free end the weight alone draws the filament out.
    drawn = yields and (held or motion.flowing_overstress > 1)
    grown = _UNEVENNESS * math.expm1(min(motion.folds, _MANY_FOLDS)) if drawn else 0.0
    clamped = held and YIELDING.applies(scene) and carries_moment(scene)
    turns = clamped and (scales.gravity_number_of(scene) or 0.0) > scales.collapse_gravity_number(scene)
    share = min(1.0, _SHORT * scales.neck_length(scene) / (motion.sag * rest_length(scene)))
    spread = share * _HINGE * motion.folds**2 / (1 + motion.folds) if turns and yields else 0.0
    formula = f"an unevenness of {_UNEVENNESS:g} grown by {motion.folds:.2g} e-folds n, or {_HINGE:g} n^2/(1 + n)"
    formula += " times the share of the hinges"
    value = min(1.0, max(grown, spread))
    return Estimate(value, "growth of necks, or spread of the hinges at the clamps", formula, held_up(value))


NECKING_GRADIENT = Effect(
    name="necking-gradient",
    summary="axial force - d/dX (b s_X), b = beta h0^2 T/s^4, of a sheet T/s^5",
    source="Audoly & Hutchinson 2016",
    contribute=partial(replace, necking_gradient=True),
    applies=lambda scene: scene.model == "filament" and VISCOUS_FLOW.applies(scene) and not scene.extrusion.present,
    without_it=f"the law does not flow, the strand is laid, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="growth of a neck where the section flows, sigma/eta over time",
    example="arrested-underdamped",
    derivation="08_necking",
    cures="localised",
    needs=("finite-stretch", "thinning", "viscous-flow"),
    in_paper=False,
)
