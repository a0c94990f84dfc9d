"""A block whose section is held straight, stretched and sheared by dead forces: by the law of section and of bulk."""

from __future__ import annotations

import copy

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import root

from tests.common.material_point import MaterialPoint
from tests.common.one_cell import sheared_cell

FORCES, DURATION = np.array([1.4, 1.0]), 10.0
"""n_1 and n_2 over the area, from the start on."""

MATERIAL = {"youngs_modulus": 1200.0, "poisson": 0.45, "yield_stress": 2.0, "viscosity": 25.0}

BY_LAW, IN_THREE_DIMENSIONS = (1.07346, 0.15835), (1.07379, 0.15940)
"""Lam and Gam in the end by section 12a of THEORY.md, and by the three-dimensional law."""

_UNEVEN = 5 / 6
"""kappa_s of the package's rectangle. Of a block whose shear is the same everywhere it is one: its Gam is sqrt(kappa_s)
times that of the section under a force of n_2 sqrt(kappa_s)."""


def by_section() -> tuple[float, float]:
    """Lam and Gam in the end of one cell of the package."""
    cell = sheared_cell({"law": "bingham", **MATERIAL})
    forces, last = FORCES * [1.0, np.sqrt(_UNEVEN)], [np.array([1.0, 0.0])]

    def strains(state: np.ndarray) -> np.ndarray:
        found = root(lambda at: np.ravel(cell.resultants(*at, state)) - forces, last[-1], tol=1e-12)
        last[:] = [found.x]
        return np.asarray(found.x)

    def rates(_: float, state: np.ndarray) -> np.ndarray:
        return np.asarray(cell.rates(*strains(state), state)).ravel()

    flown = solve_ivp(rates, (0.0, DURATION), np.zeros(cell.states), method="BDF", rtol=1e-8, atol=1e-11)
    stretch, shear = strains(flown.y[:, -1])
    return float(stretch), float(shear * np.sqrt(_UNEVEN))


def by_bulk(steps: int = 160) -> np.ndarray:
    """Lam and Gam in the end of the law of the finite elements, with sides that are free across the section.

    Two step lengths are extrapolated, since the step is of first order.
    """

    def end(steps: int) -> np.ndarray:
        point, at = MaterialPoint("bingham", MATERIAL), np.array([1.0, 0.0, 1.0])

        def stepped(at: np.ndarray) -> MaterialPoint:
            trial = copy.copy(point)
            trial.step([[at[0], 0.0], [at[1], at[2]]], DURATION / steps)
            return trial

        def unbalanced(at: np.ndarray) -> np.ndarray:
            return stepped(at).stress[[0, 1, 1], [0, 0, 1]] - np.append(FORCES, 0.0)

        for _ in range(steps):
            at = root(unbalanced, at, tol=1e-12).x
            point = stepped(at)
        return at[:2]

    return 2 * end(2 * steps) - end(steps)
