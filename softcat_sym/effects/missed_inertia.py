"""What a filament that is in balance at every instant misses of one that has inertia."""

from __future__ import annotations

import numpy as np

from softcat_sym.effects.quasi_static import Floats


def missed_inertia(time: Floats, sag: Floats, gravity: float, ramp: float) -> float:
    """Largest difference of the sag at the output times, over the largest sag.

    A filament released at once follows free fall until its balanced sag H(t) ~ t^p is no deeper, at t_i with
    g t_i^2/2 = H(t_i); from then on it is late by about t_i, so that p H t_i/t is missed. Under a slow load what is
    missed is the acceleration over gravity. Ringing is not in it.

    Parameters
    ----------
    time, sag : ndarray, shape (n,)
        Output times [s] and balanced sag [m], from t = 0.
    gravity : float
        [m/s^2].
    ramp : float
        Duration of the ramp of gravity [s].
    """
    largest = float(np.max(np.abs(sag)))
    if largest == 0 or gravity == 0 or len(time) < 2:
        return 0.0
    moved = np.abs(sag - sag[0])
    slow = _accelerated(time, sag, gravity)
    if ramp > 0:
        loaded = time > ramp
        return max(_late(time[loaded], moved[loaded], gravity), slow) / largest
    jump = float(np.abs(sag[0]))
    return max(_late(time[1:], moved[1:] + jump, gravity), jump, slow) / largest


def missed_from_rest(time: Floats, sag: Floats, gravity: float) -> float:
    """Largest difference of the sag, over the largest sag, of a filament that hangs in balance and begins to flow.

    It springs back about its balance at omega^2 = g/H, so that the speed v with which the flow begins sets it ringing
    with v/omega.

    Parameters
    ----------
    time, sag : ndarray, shape (n,)
        Output times [s] and balanced sag [m], from t = 0.
    gravity : float
        [m/s^2].
    """
    largest = float(np.max(np.abs(sag)))
    if largest == 0 or gravity == 0 or len(time) < 2:
        return 0.0
    speed = abs(float(sag[1] - sag[0])) / float(time[1] - time[0])
    return min(1.0, speed * float(np.sqrt(largest / gravity)) / largest)


def _late(time: Floats, sag: Floats, gravity: float) -> float:
    """Largest sag missed by being late [m]."""
    if len(time) < 2 or not np.any(sag > 0):
        return 0.0
    safe = np.maximum(sag, 1e-12 * np.max(sag))
    power = np.clip(np.gradient(np.log(safe), np.log(time)), 0.0, 1.0)
    fallen = 2 * safe / (gravity * time**2)
    return float(np.max(power * safe * np.minimum(1.0, fallen ** (1 / (2 - power)))))


def _accelerated(time: Floats, sag: Floats, gravity: float) -> float:
    """Largest acceleration over gravity, in sags [m]: that much of the load is missing at that time."""
    if len(time) < 3:
        return 0.0
    acceleration = np.abs(np.diff(sag, 2)) / (time[1] - time[0]) ** 2
    return float(np.max(np.minimum(acceleration / gravity, 1.0) * np.abs(sag[1:-1])))
