"""Added mass: what surrounds the filament moves with it across its tangent (Lighthill 1960)."""

from __future__ import annotations

import math
from dataclasses import replace

import sympy as sp

from softcat_sym.effects.effect import Effect, Estimate, Motion
from softcat_sym.physics.densities import Densities
from softcat_sym.physics.filament import Terms
from softcat_sym.physics.laws import Constant
from softcat_sym.physics.necking import aspect
from softcat_sym.physics.symbols import A0, rho_b, s, x_t, x_X, y_t, y_X
from softcat_sym.scene.scene import Scene

_v_n = (x_X * y_t - y_X * x_t) / s

# Of a cylinder its own volume, whatever the stretch: rho_b A s = rho_b A_0. Of a rectangle pi D_0/(4 h_0) of it.
_BATH = (Constant("bath_density", rho_b),)
ADDED = {
    "circle": Densities("added-mass", kinetic=rho_b * A0 * _v_n**2 / 2, constants=_BATH),
    "rectangle": Densities("added-mass", kinetic=sp.pi / 4 * aspect * rho_b * A0 * _v_n**2 / 2, constants=_BATH),
}


def _adapted(scene: Scene, terms: Terms) -> Terms:
    return replace(terms, densities=(*terms.densities, ADDED[scene.filament.section]))


def _applies(scene: Scene) -> bool:
    return scene.filament.section in ADDED and scene.surroundings.density > 0


def mass_ratio(scene: Scene) -> float:
    """Added mass over the filament's own."""
    filament = scene.filament
    coefficient = math.pi / 4 * filament.width / filament.thickness if filament.section == "rectangle" else 1.0
    return coefficient * scene.surroundings.density / filament.density


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    # A ringing loses step by that in every radian; without it, inertia matters as far as the motion lags.
    slower = math.sqrt(1 + mass_ratio(scene)) - 1
    value = slower * max(motion.missed, motion.swings)
    return Estimate(
        min(1.0, value), "change of every period, times what inertia matters", "sqrt(1 + C_m rho_b/rho) - 1"
    )


ADDED_MASS = Effect(
    name="added-mass",
    summary="inertia of what surrounds the filament, across its tangent",
    source="Lighthill 1960",
    adapt=_adapted,
    applies=_applies,
    without_it="surroundings.density is zero, or the section is a sheet, around which no flow is local",
    estimate=_estimate,
    observable="change of every period, times the lag behind the balanced sag",
    example="embedded-strand",
    derivation="17_surroundings",
    needs=("inertia",),
    in_paper=False,
    causes=("bath",),
)
