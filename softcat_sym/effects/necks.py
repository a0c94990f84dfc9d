"""Growth of a neck."""

from __future__ import annotations

import math

from softcat_sym.effects.prediction import (
    duration_star,
    first_yield_gravity_number,
    gravity_number_of,
    viscous_number,
)
from softcat_sym.equations.necking import NECKS, aspect
from softcat_sym.scene import Scene


def neck_length(scene: Scene) -> float:
    """Half the shortest wavelength that grows, pi sqrt(beta) h0 [m]: a neck is not shorter than this."""
    filament = scene.filament
    beta = NECKS[filament.section].beta.subs(aspect, filament.width / filament.thickness)
    return math.pi * math.sqrt(float(beta)) * filament.thickness


def neck_folds(scene: Scene, strain: float) -> float:
    """E-folds by which an unevenness grows: sigma/eta = sigma_Y/eta + the rate of strain, as long as the run lasts."""
    gravity_number, viscous = gravity_number_of(scene), viscous_number(scene)
    folds = strain
    if gravity_number and viscous and gravity_number > first_yield_gravity_number(scene):
        folds += duration_star(scene) / (gravity_number * viscous)
    return folds
