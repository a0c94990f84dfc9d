"""Orders of magnitude of a law's constants, from how far a filament sags: where a fit starts that knows no better."""

from __future__ import annotations

import numpy as np

from softcat_sym.inverse.measurements.series import Measurements
from softcat_sym.scene import Scene

_STIFFER = 50.0
"""Young's modulus of what flows over the one that alone would hold it: then most of the sag is flow."""

_SOONER = 0.1
"""Viscosity of what a solid or a yield stress holds, over the one that alone would slow it: it arrives early."""

# Where nothing was seen, or nothing pulls: a sag of a tenth, and a soft material.
_SAG, _WEIGHT = 0.1, 1e3


def rough_constants(scene: Scene, films: Measurements, law: str) -> dict[str, float]:
    """Guess constants by what they would be if each alone were to explain the largest sag.

    A string of modulus E under its weight hangs down by w with E = (3/64) rho g L (L/w)^3, a clamped beam with E = rho
    g L^4/(32 h^2 w) (THEORY, small slopes); both share the load. A viscosity is that modulus times the time that it
    took, a yield stress the tension rho g L^2/(8 w).

    Parameters
    ----------
    scene : Scene
        The filament.
    films : Measurements
        Of it.
    law : str
        Whether something holds it for good.

    Returns
    -------
    dict of str to float
        ``youngs_modulus``, ``second_modulus``, ``yield_stress`` [Pa], ``viscosity`` [Pa s].
    """
    span, thickness = scene.filament.span, scene.filament.thickness
    weight = scene.filament.density * scene.load.gravity * span or _WEIGHT
    seen = [(one.time, one.midpoint) for one in films.series if one.time.size]
    seen += [(one.shapes.time, one.shapes.y) for one in films.series if one.shapes is not None]
    longest = max((float(np.max(time)) for time, _ in seen), default=0.0) or scene.run.duration
    sag = max((float(np.max(np.abs(height))) for _, height in seen), default=0.0) / span or _SAG
    as_string, as_beam = 3 / 64 * weight / sag**3, weight * span**2 / (32 * sag * thickness**2)
    modulus = 1 / (1 / as_string + 1 / as_beam)
    held = law in ("kelvin-voigt", "standard-linear", "bingham", "herschel-bulkley")
    solid = law in ("elastic", "kelvin-voigt")
    return {
        "youngs_modulus": modulus * (1.0 if solid else _STIFFER),
        "second_modulus": modulus,
        "yield_stress": weight / (8 * sag),
        "viscosity": modulus * longest * (_SOONER if held else 1.0),
    }
