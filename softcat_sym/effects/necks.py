"""Growth of a neck."""

from __future__ import annotations

import math

from softcat_sym.effects.law import is_solid
from softcat_sym.effects.prediction import (
    effective_viscosity,
    first_yield_gravity_number,
    gravity_number_of,
    pull_of_surface,
    yield_stress_of,
)
from softcat_sym.equations.necking import NECKS, aspect
from softcat_sym.scene import Scene


def neck_length(scene: Scene) -> float:
    """Half the shortest wavelength that grows, pi sqrt(beta) h0 [m]: a neck is not shorter than this."""
    filament = scene.filament
    beta = NECKS[filament.section].beta.subs(aspect, filament.width / filament.thickness)
    return math.pi * math.sqrt(float(beta)) * filament.thickness


def neck_folds(scene: Scene, strain: float) -> float:
    """E-folds by which an unevenness grows, sigma/eta = sigma_Y/eta + the rate of strain, as long as the run lasts.

    Surface tension adds half its pull to sigma (Plateau & Rayleigh).
    """
    gravity_number, limit = gravity_number_of(scene), yield_stress_of(scene)
    viscosity = effective_viscosity(scene)
    stress = (limit or 0.0) + pull_of_surface(scene) / 2
    yields = limit is None or (gravity_number or 0.0) > first_yield_gravity_number(scene)
    return strain + (stress / viscosity * scene.run.duration if viscosity and yields and not is_solid(scene) else 0.0)
