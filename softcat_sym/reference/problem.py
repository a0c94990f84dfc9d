"""From a scene to the dimensionless problem of the elements, or a refusal that names what they cannot do."""

from __future__ import annotations

import math
from dataclasses import dataclass

from softcat_sym.errors import Fault, SceneError
from softcat_sym.reference.point_code import LAWS
from softcat_sym.scene import Scene, rest_length
from softcat_sym.scene.scales import elastic_time

# The only value of each key that the elements know.
_ONLY: tuple[tuple[str, object], ...] = (
    ("model", "filament"),
    ("filament.section", "rectangle"),
    ("filament.profile", ()),
    ("filament.curvature", 0.0),
    ("ends.left", "clamped"),
    ("ends.right", "clamped"),
    ("ends.drop", 0.0),
    ("ends.left_angle", 0.0),
    ("ends.right_angle", 0.0),
    ("ends.motion", ()),
    ("material.loss_tangent", 0.0),
    ("material.solid_viscosity", None),
    ("run.until", "duration"),
    ("load.point_mass", 0.0),
    ("load.shake", 0.0),
    ("surroundings.surface_tension", 0.0),
    ("initial.stretch", 1.0),
    ("initial.P", ()),
    ("initial.C", ()),
)


@dataclass(frozen=True, slots=True)
class Problem:
    """What the elements solve, in units of span, Young's modulus and density.

    Attributes
    ----------
    law : str
        A name of ``point_code.LAWS``.
    thickness : float
        h0/L.
    material : tuple of (str, float)
        Constants of the law over E and the elastic time.
    poisson : float
        Poisson's ratio.
    gravity : float
        rho g L/E.
    ramp, duration : float
        Over the elastic time.
    frames : int
        Evenly spaced output times, the first at 0.
    """

    law: str
    thickness: float
    material: tuple[tuple[str, float], ...]
    poisson: float
    gravity: float
    ramp: float
    duration: float
    frames: int


def problem_of(scene: Scene) -> Problem:
    """Make a scene dimensionless.

    Parameters
    ----------
    scene : Scene
        A filament of rectangular section between two clamps at equal height.

    Raises
    ------
    SceneError
        With every key whose value the elements do not know.
    """
    faults = [_fault(path, value, wanted) for path, wanted in _ONLY if (value := _value(scene, path)) != wanted]
    if not math.isclose(rest_length(scene), scene.filament.span, rel_tol=1e-12):
        faults.append(_fault("filament.rest_length", rest_length(scene), scene.filament.span))
    if scene.material.law not in LAWS:
        faults.append(Fault("material.law", f"'{scene.material.law}' has no finite elements", ", ".join(LAWS)))
    if faults or scene.material.youngs_modulus is None:
        raise SceneError(faults)
    modulus, time = scene.material.youngs_modulus, elastic_time(scene)
    scales = {"youngs_modulus": modulus, "poisson": 1.0, "viscosity": modulus * time, "yield_stress": modulus}
    constants = ((name, getattr(scene.material, name), scale) for name, scale in scales.items())
    return Problem(
        law=scene.material.law,
        thickness=scene.filament.thickness / scene.filament.span,
        material=tuple((name, value / scale) for name, value, scale in constants if value is not None),
        poisson=scene.material.poisson,
        gravity=scene.filament.density * scene.load.gravity * scene.filament.span / modulus,
        ramp=scene.load.ramp / time,
        duration=scene.run.duration / time,
        frames=scene.run.frames,
    )


def _value(scene: Scene, path: str) -> object:
    value: object = scene
    for name in path.split("."):
        value = getattr(value, name)
    return value


def _fault(path: str, value: object, wanted: object) -> Fault:
    return Fault(path, f"{value!r} has no finite elements", "leaving it out" if wanted in ((), None) else f"{wanted!r}")
