"""Deformation paths for a material point, and an integration of the three-dimensional law that shares no code."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from tests.common.material_point import MaterialPoint

Floats = npt.NDArray[np.float64]
Path = Callable[[float], Floats]

BINGHAM = {"youngs_modulus": 1.0, "poisson": 0.45, "viscosity": 0.5, "yield_stress": 0.02}
MAXWELL = {name: BINGHAM[name] for name in ("youngs_modulus", "poisson", "viscosity")}
ELASTIC = {name: BINGHAM[name] for name in ("youngs_modulus", "poisson")}


def shear_and_stretch(time: float) -> Floats:
    """Stretches to 1.5, shears to 0.8 and back to 0.3, turns, and contracts across; never along fixed axes."""
    turn = 0.7 * time
    spin = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    stretch = 1 + 0.5 * time
    return np.asarray(spin @ np.array([[stretch, 0.8 * np.sin(2.75 * time)], [0.1 * time, stretch**-0.6]]))


def cycle(time: float) -> Floats:
    """A closed loop of stretch and shear, from rest to rest."""
    a, b = 0.08 * np.sin(2 * np.pi * time), 0.1 * (1 - np.cos(2 * np.pi * time))
    return np.array([[1 + a, b], [0.3 * b, 1 - 0.4 * a]])


def march(point: MaterialPoint, path: Path, steps: int, duration: float = 1.0) -> MaterialPoint:
    """Follow a path over times 0 to 1, stretched to a duration."""
    for n in range(1, steps + 1):
        point.step(path(n / steps), duration / steps)
    return point


def _logarithm(metric: Floats) -> Floats:
    values, axes = np.linalg.eigh(metric)
    return np.asarray(axes @ np.diag(np.log(values)) @ axes.T)


def _stress(deformation: Floats, plastic: Floats, material: dict[str, float]) -> tuple[Floats, Floats, float]:
    """Mandel stress, Fe and F_33 for an F that is given in the plane, with M_33 = 0.

    The strain in the width decouples: Fe_33 = F_33/Fp_33, so M_33 = 0 is linear in log Fe_33.
    """
    E, nu = material["youngs_modulus"], material["poisson"]
    bulk_modulus, twice_shear = E / (3 * (1 - 2 * nu)), E / (1 + nu)
    plane = deformation @ np.linalg.inv(plastic[:2, :2])
    strain = np.zeros((3, 3))
    strain[:2, :2] = _logarithm(plane.T @ plane) / 2
    trace = np.trace(strain)
    strain[2, 2] = -(bulk_modulus - twice_shear / 3) * trace / (bulk_modulus + 2 * twice_shear / 3)
    stress = bulk_modulus * np.trace(strain) * np.eye(3) + twice_shear * (strain - np.trace(strain) / 3 * np.eye(3))
    elastic = np.zeros((3, 3))
    elastic[:2, :2], elastic[2, 2] = plane, np.exp(strain[2, 2])
    return stress, elastic, float(elastic[2, 2] * plastic[2, 2])


def _flow(deformation: Floats, plastic: Floats, material: dict[str, float]) -> Floats:
    """Fp_t = Lp Fp (3.7, 3.8 corrected)."""
    stress, _, _ = _stress(deformation, plastic, material)
    deviator = stress - np.trace(stress) / 3 * np.eye(3)
    size = np.sqrt(1.5 * np.sum(deviator * deviator))
    if size <= material["yield_stress"]:
        return np.zeros((3, 3))
    rate = (size - material["yield_stress"]) / material["viscosity"]
    return np.asarray(1.5 * rate * deviator / size @ plastic)


def integrate(path: Path, steps: int, material: dict[str, float]) -> tuple[Floats, Floats, float]:
    """Runge-Kutta of order 4 on the 3 x 3 Fp."""
    plastic, dt = np.eye(3), 1 / steps
    for n in range(steps):
        start, middle, end = (path((n + part) * dt) for part in (0.0, 0.5, 1.0))
        k1 = _flow(start, plastic, material)
        k2 = _flow(middle, plastic + dt / 2 * k1, material)
        k3 = _flow(middle, plastic + dt / 2 * k2, material)
        k4 = _flow(end, plastic + dt * k3, material)
        plastic = plastic + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    stress, elastic, width = _stress(path(1.0), plastic, material)
    # tau = Fe^-T M Fe^T; P = tau F^-T
    kirchhoff = np.linalg.inv(elastic).T @ stress @ elastic.T
    inverse = np.linalg.inv(plastic[:2, :2])
    return kirchhoff[:2, :2] @ np.linalg.inv(path(1.0)).T, inverse @ inverse.T, width
