"""Necking gradient: the slope of a neck's surface stiffens it, so that strain cannot gather in one place."""

import math
from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate
from softcat_sym.effects.prediction import (
    duration_star,
    first_yield_gravity_number,
    gravity_number_of,
    predicted_strain,
    viscous_number,
)
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.equations.filament import Terms
from softcat_sym.equations.necking import NECKS, aspect
from softcat_sym.scene import Scene

_UNEVENNESS = 4e-4
"""Unevenness that a neck grows from: one e-fold of it changes the sag of the paper's arrested filament by 1 %."""


def neck_length(scene: Scene) -> float:
    """Half the shortest wavelength that grows, pi sqrt(beta) h0 [m]: a neck is not shorter than this."""
    filament = scene.filament
    beta = NECKS[filament.section].beta.subs(aspect, filament.width / filament.thickness)
    return math.pi * math.sqrt(float(beta)) * filament.thickness


def _contribute(terms: Terms) -> Terms:
    return replace(terms, necking_gradient=True)


def _applies(scene: Scene) -> bool:
    return scene.model == "filament" and VISCOUS_FLOW.applies(scene)


def _estimate(scene: Scene) -> Estimate:
    # A neck grows at sigma/eta = sigma_Y/eta + the rate of strain, at the most for as long as the run lasts.
    gravity_number, viscous = gravity_number_of(scene), viscous_number(scene)
    folds = predicted_strain(scene)
    if gravity_number and viscous and gravity_number > first_yield_gravity_number(scene):
        folds += duration_star(scene) / (gravity_number * viscous)
    return Estimate(folds, "growth of a neck in e-folds, sigma/eta times the duration")


def _called_for(scene: Scene, value: float) -> bool:
    return value > math.log(max(1.0, scene.run.accuracy / _UNEVENNESS))


NECKING_GRADIENT = Effect(
    name="necking-gradient",
    summary="axial force - d/dX (b s_X), b = beta h0^2 T/s^4, of a sheet T/s^5",
    source="Audoly & Hutchinson 2016",
    contribute=_contribute,
    applies=_applies,
    without_it=f"the law does not flow, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="largest gradient force over tension",
    needs=("finite-stretch", "thinning", "viscous-flow"),
    in_paper=False,
    called_for=_called_for,
)
