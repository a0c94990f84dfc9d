"""Bars of polymer solution that are drawn, and the same chains integrated as a whole tensor, by other means."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp

import softcat_sym as sc
from softcat_sym.scene.scene import Scene

Floats = npt.NDArray[np.float64]

G, LAMBDA, SOLVENT = 1.0, 1.0, 0.3
"""Shear modulus [Pa], relaxation time [s] and tensile viscosity of the solvent [Pa s] of all bars."""

OWN: dict[str, dict[str, float]] = {
    "oldroyd-b": {},
    "fene-p": {"finite_extensibility": 60.0},
    "giesekus": {"mobility": 0.2},
    "ptt": {"ptt_epsilon": 0.1},
}
"""Constants that only one law has."""

STRING = ("inertia", "extensibility", "finite-stretch", "thinning", "large-rotation")
FLOWING = (*STRING, "viscous-flow", "viscous-stress")


def bar(law: str, path: Callable[[Floats], Floats], duration: float, rows: int = 60, **changes: Any) -> Scene:
    """A bar without weight, next to massless, whose right end is drawn along straight pieces of a path."""
    time = np.linspace(0.0, duration, rows + 1)
    drawn = [[float(t), float(s - 1), 0.0] for t, s in zip(time, path(time), strict=True)]
    return Scene.from_dict(
        {
            "filament": {"span": 1.0, "thickness": 0.05, "section": "circle", "density": 1e-9},
            "material": {"law": law, "youngs_modulus": 3 * G, "relaxation_time": LAMBDA, **OWN[law]}
            | {"solvent_viscosity": SOLVENT},
            "ends": {"left": "pinned", "right": "pinned", "motion": drawn},
            "load": {"gravity": 0.0},
            "run": {"duration": duration, "frames": 121, "effects": list(FLOWING)},
            "numerics": {"cells": 4, "rtol": 1e-10, "estimate": False, "backend": "interpreted"},
        }
    ).replace(changes)


def relaxation(law: str, A: Floats) -> Floats:
    """What relaxation takes from the conformation, over the relaxation time."""
    own, one = OWN[law], np.eye(3)
    if law == "fene-p":
        limit = own["finite_extensibility"]
        return np.asarray((limit - 3) / (limit - np.trace(A)) * A - one)
    if law == "giesekus":
        return np.asarray((A - one) + own["mobility"] * (A - one) @ (A - one))
    if law == "ptt":
        return np.asarray((1 + own["ptt_epsilon"] * (np.trace(A) - 3)) * (A - one))
    return A - one


def stress_of(law: str, A: Floats) -> float:
    """Tensile stress of the chains: the difference of two components of their tensor."""
    limit = OWN[law].get("finite_extensibility", math.inf)
    factor = (limit - 3) / (limit - np.trace(A)) if math.isfinite(limit) else 1.0
    return float(G * factor * (A[0, 0] - A[1, 1]))


def whole_tensor(law: str, pace: Callable[[float], float], times: Floats, *, width: bool = False) -> list[Floats]:
    """A at some times by dA/dt = L A + A L^T - relaxation/lambda, of a fibre drawn at a pace; a wide one keeps it."""
    shape = np.diag([1.0, -1.0, 0.0] if width else [1.0, -0.5, -0.5])

    def rate(t: float, a: Floats) -> Floats:
        A, L = a.reshape(3, 3), pace(t) * shape
        return np.asarray(L @ A + A @ L.T - relaxation(law, A) / LAMBDA).ravel()

    found = solve_ivp(rate, (0.0, float(times[-1])), np.eye(3).ravel(), "DOP853", times, rtol=1e-12, atol=1e-13)
    return [column.reshape(3, 3) for column in found.y.T]


def drawn_by_pieces(law: str, run: sc.Run, *, width: bool = False) -> list[Floats]:
    """The same of a bar that was drawn along straight pieces, each integrated by itself."""
    path = run.scene.ends.motion
    ends = [0.0, *(row[0] for row in path if row[0] > 0)]
    lengths = [1.0, *(1 + row[1] for row in path if row[0] > 0)]
    shape = np.diag([1.0, -1.0, 0.0] if width else [1.0, -0.5, -0.5])
    times, found, A = run.data.time.values, [np.eye(3)], np.eye(3)
    for (a, b), (s, longer) in zip(pairwise(ends), pairwise(lengths), strict=True):
        speed = (longer - s) / (b - a)

        def rate(t: float, flat: Floats, a: float = a, s: float = s, speed: float = speed) -> Floats:
            A, L = flat.reshape(3, 3), speed / (s + speed * (t - a)) * shape
            return np.asarray(L @ A + A @ L.T - relaxation(law, A) / LAMBDA).ravel()

        asked = times[(times > a + 1e-12) & (times <= b + 1e-12)]
        piece = solve_ivp(rate, (a, b), A.ravel(), "DOP853", dense_output=True, rtol=1e-11, atol=1e-12)
        found += [piece.sol(min(t, b)).reshape(3, 3) for t in asked]
        A = piece.y[:, -1].reshape(3, 3)
    return found
