"""Where the theory itself ends: what a run must warn of."""

from __future__ import annotations

import numpy as np

from softcat_sym.effects.prediction import effective_viscosity
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene

_SMALL = 0.1


def warnings_of(scene: Scene, time: Floats, midpoint: Floats) -> list[str]:
    """Warnings in words, none if the theory holds.

    Parameters
    ----------
    time, midpoint : ndarray, shape (frames,)
        [s], [m].
    """
    return [*_surface_tension(scene, time, midpoint)]


def _surface_tension(scene: Scene, time: Floats, midpoint: Floats) -> list[str]:
    """Capillary forces are left out: Ca = eta U/gamma must be large, or gamma/(rho g R L) small."""
    gamma = scene.surroundings.surface_tension
    if gamma == 0 or len(time) < 2:
        return []
    filament, viscosity = scene.filament, effective_viscosity(scene)
    weight = filament.density * scene.load.gravity * filament.thickness / 2 * filament.span
    static = gamma / weight if weight > 0 else np.inf
    speed = float(np.max(np.abs(np.diff(midpoint) / np.diff(time))))
    dynamic = gamma / (viscosity * speed) if viscosity and speed > 0 else np.inf
    if min(static, dynamic) < _SMALL:
        return []
    return [
        f"surface tension is left out, but gamma/(rho g R L) = {static:.2g} and 1/Ca = {dynamic:.2g}: "
        f"neither is below {_SMALL}"
    ]
