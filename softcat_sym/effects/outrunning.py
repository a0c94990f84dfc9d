"""A support must not outrun the waves that tell the filament of its motion."""

from __future__ import annotations

import itertools
import math

from softcat_sym.effects.prediction import instant_modulus
from softcat_sym.errors import Fault
from softcat_sym.scene import Scene


def outrunning_faults(scene: Scene) -> list[Fault]:
    """Refuse a support that moves faster than axial waves, sqrt(E/rho): with inertia nothing could follow it.

    Parameters
    ----------
    scene : Scene
        Its support path and material.
    """
    modulus = instant_modulus(scene)
    if modulus is None or not scene.ends.motion:
        return []
    fastest = max(_speeds(scene), default=0.0)
    wave = math.sqrt(modulus / scene.filament.density)
    if fastest <= wave:
        return []
    found = f"the right support moves at {fastest:.3g} m/s, but waves run along the filament at {wave:.3g} m/s"
    return [Fault("ends.motion", found, "a slower path, or run.effects without inertia")]


def _speeds(scene: Scene) -> list[float]:
    return [
        math.hypot(after[1] - before[1], after[2] - before[2]) / (after[0] - before[0])
        for before, after in itertools.pairwise(((0.0, 0.0, 0.0), *scene.ends.motion))
        if after[0] > before[0]
    ]
