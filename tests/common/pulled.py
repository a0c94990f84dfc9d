"""A film with the force that a support feels, by the balance of momentum of half the filament: not as a fit has it."""

from __future__ import annotations

from functools import cache

import numpy as np

import softcat_sym as sc
from softcat_sym.scene.scene import undeformed_area
from tests.common.draws import draws
from tests.common.filmed import NOISE, scene

STRING = {"material.law": "maxwell", "material.yield_stress": None}


def string() -> sc.Scene:
    """A Maxwell filament, of the film's scene."""
    return scene().replace(STRING)


@cache
def pulled(seed: int = 0, share: float = 0.02) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Times [s], midpoints [m] and upward forces of one support [N], both with noise; the forces without it."""
    one = string().replace({"run.frames": 2001, "numerics.rtol": 1e-6})
    data, random = sc.simulate(one).data, draws(seed)
    time, x = data.time.values, data.X_node.values
    cells = np.diff(x)
    mass = one.filament.density * undeformed_area(one) / 2 * (np.append(cells, 0) + np.append(0, cells))
    middle = x.size // 2
    mass = mass[middle:]
    mass[0] /= 2
    momentum = np.gradient(data.y.values[:, middle:], time, axis=0) @ mass
    part = np.clip(time / one.load.ramp, 0, 1)
    weight = mass.sum() * one.load.gravity * (10 * part**3 - 15 * part**4 + 6 * part**5)
    force = np.gradient(momentum, time) + weight
    frames = np.arange(20, 2001, 33)
    noisy = force[frames] + share * force.max() * random.standard_normal(frames.size)
    midpoint = data.midpoint.values[frames] + NOISE * random.standard_normal(frames.size)
    return time[frames], midpoint, noisy, force[frames]
