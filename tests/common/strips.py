"""Strips of elements for tests, and the beam theory they are measured against."""

from __future__ import annotations

from functools import cache

import numpy as np
import numpy.typing as npt

from softcat_sym.reference.element_loop import Clamp, ElementLoop, HalfFilament, Mesh, Restraints, half_span_supports
from softcat_sym.reference.material_point import PointCode, point_code
from softcat_sym.scene.scene import Scene

Floats = npt.NDArray[np.float64]

POISSON = 0.45
BINGHAM = {"youngs_modulus": 1.0, "poisson": POISSON, "viscosity": 0.8, "yield_stress": 0.02}
ELASTIC = {"youngs_modulus": 1.0, "poisson": POISSON}


@cache
def code_of(law: str) -> PointCode:
    return point_code(law)


def unheld(strip: HalfFilament) -> Restraints:
    return Restraints(np.zeros(strip.position.shape, dtype=bool), strip.face[:0])


def free_loop(
    mesh: Mesh, thickness: float, law: str = "elastic", gravity: float = 0.0, pull: float = 0.0, ramp: float = 0.0
) -> ElementLoop:
    strip = HalfFilament(mesh, thickness)
    material = ELASTIC if law == "elastic" else BINGHAM
    return ElementLoop(strip, unheld(strip), code_of(law), material, gravity=gravity, pull=pull, ramp=ramp)


def clamped_loop(mesh: Mesh, thickness: float, gravity: float, poisson: float) -> ElementLoop:
    """An elastic half strip under sudden gravity."""
    strip = HalfFilament(mesh, thickness)
    material = {"youngs_modulus": 1.0, "poisson": poisson}
    return ElementLoop(strip, half_span_supports(strip, Clamp.THINNING), code_of("elastic"), material, gravity=gravity)


def internal_force(loop: ElementLoop) -> Floats:
    """Internal forces on the nodes of an unheld strip without gravity, where it is now; shape (nodes, 2)."""
    loop.evaluate(0.0, 0.0)
    return -loop.strip.mass[:, None] * loop.acceleration


def deformed(strip: HalfFilament, gradient: npt.ArrayLike) -> Floats:
    """Displacements of a uniform deformation gradient; shape (nodes, 2)."""
    return strip.position @ (np.asarray(gradient, dtype=float) - np.eye(2)).T


def shortened(scene: Scene, elastic_times: float, frames: int) -> Scene:
    """The scene over another time, in L sqrt(rho/E)."""
    from softcat_sym.scene.scene import elastic_time

    return scene.replace({"run.duration": f"{elastic_times * elastic_time(scene)!r} s", "run.frames": frames})


def timoshenko_sag(thickness: float, gravity: float, kappa: float, poisson: float) -> float:
    """Sag of a clamped beam of span, modulus and density 1: q L^4/(384 E I) + q L^2/(8 kappa mu A)."""
    area, inertia, shear = thickness, thickness**3 / 12, 1 / (2 * (1 + poisson))
    load = gravity * area
    return load / (384 * inertia) + load / (8 * kappa * shear * area)


def timoshenko_frequency(thickness: float, kappa: float, poisson: float) -> float:
    """First frequency of a clamped beam with shear and rotary inertia, solved from w = psi = 0 at both ends."""
    area, inertia, shear = thickness, thickness**3 / 12, kappa * thickness / (2 * (1 + poisson))

    def mismatch(omega: float) -> float:
        # w' = Q/(kappa mu A) + psi, psi' = M/(E I), M' = -Q - rho I omega^2 psi, Q' = -rho A omega^2 w.
        matrix = np.array(
            [
                [0, 1, 0, 1 / shear],
                [0, 0, 1 / inertia, 0],
                [0, -inertia * omega**2, 0, -1],
                [-area * omega**2, 0, 0, 0],
            ]
        )
        values, vectors = np.linalg.eig(matrix)
        transfer = (vectors * np.exp(values / 2)) @ np.linalg.inv(vectors)
        # Half the span: from w, M at the plane of symmetry (psi = Q = 0) to w, psi at the clamp.
        return float(np.linalg.det(transfer[:2][:, [0, 2]]).real)

    thin = 4.730040744862704**2 * np.sqrt(inertia / area)
    low, high = 0.5 * thin, 1.01 * thin
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if mismatch(low) * mismatch(middle) > 0 else (low, middle)
    return (low + high) / 2
