"""The undamped clamped rod here, and in PyElastica: with clamps of second order, and in our material too.

PyElastica (Gazzola, Dudte, McCormick & Mahadevan, R. Soc. Open Sci. 5, 171628 (2018); Tekinalp et al., version 1.0.0)
integrates Cosserat rods by position Verlet. Its forces follow from n = S (sigma - sigma_0)/e and M = B kappa/e^3 with
constant S = diag(a G A0, a G A0, E A0), a = 27/28, and B, where e is the dilatation: the volume is kept and the axial
stress is E (e - 1), engineering strain.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any, Literal

import elastica as ea
import numpy as np
import numpy.typing as npt

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence

Array = npt.NDArray[np.float64]
Rod = Literal["second order", "our material"]

DENSITY, RADIUS, SPAN, GRAVITY = 636.62, 0.01, 1.0, 9.80665
TIMES = (0.05, 0.1, 0.2)
POISSON, OUR_SHEAR, ITS_SHEAR = 0.45, 9 / 10, 27 / 28
"""Of a circle: the scene's Poisson ratio, and the shear corrections of the two codes."""


@dataclass(frozen=True, slots=True)
class Fall:
    """Midpoints [m] at ``TIMES``, and the seconds of the processor that the loop over time steps took."""

    midpoints: Array
    seconds: float


class _Simulator(ea.BaseSystemCollection, ea.Constraints, ea.Forcing):
    """What the rod needs of PyElastica."""


class _OurMaterial(ea.NoForces):
    """Give the rod the section of the filament that shears, through its public stiffness and rest strain.

    n_1 = E A0 log(Lam)/Lam - (3/2) E I0 k^2/Lam^4 - S Gam/Lam and S = kappa_s G A0 Gam/Lam^2: true strain, and the work
    of the moment and of the shear force on a section that thins. The values are those of the force evaluation before.
    """

    def __init__(self, stiffness: Array, bending: float) -> None:
        super().__init__()
        self._stiffness, self._bending = stiffness, bending

    def apply_forces(self, system: Any, time: float = 0.0) -> None:
        axial, shear = self._stiffness[2, 2], self._stiffness[0, 0]
        stretch = 1 + system.sigma[2]
        slip = system.sigma[0] ** 2 + system.sigma[1] ** 2
        at_nodes = system.kappa[0] ** 2 + system.kappa[1] ** 2
        bent = np.empty_like(stretch)
        bent[1:-1] = (at_nodes[1:] + at_nodes[:-1]) / 2
        bent[0], bent[-1] = (max(1.5 * a - 0.5 * b, 0.0) for a, b in (at_nodes[:2], at_nodes[:-3:-1]))
        force = axial * np.log(stretch) / stretch
        force -= 1.5 * self._bending * bent / stretch**4 + shear * slip / stretch**3
        system.rest_sigma[2] = system.sigma[2] - force * system.dilatation / axial
        for k in (0, 1):
            system.shear_matrix[k, k] = self._stiffness[k, k] * system.dilatation / stretch**2


def set_up(elements: int, E: float, kind: Rod) -> tuple[_Simulator, Any]:
    """Make the simulator and its rod; arguments as of :func:`fall`."""
    simulator = _Simulator()
    # The same G A times shear correction in both codes: of the two models only the material is left to differ.
    modulus = E / (2 * (1 + POISSON)) * OUR_SHEAR / ITS_SHEAR
    along, across = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
    rod = ea.CosseratRod.straight_rod(
        elements, np.zeros(3), along, across, SPAN, RADIUS, DENSITY, youngs_modulus=E, shear_modulus=modulus
    )
    stiffness, bending = rod.shear_matrix.copy(), float(rod.bend_matrix[0, 0, 1])
    # A clamp holds the direction of the first element, half an element inside the rod. From the wall to the middle of
    # the second it is one and a half elements: with that length in B/length the error is of second order.
    rod.bend_matrix[:2, :2, [0, -1]] *= 2 / 3
    simulator.append(rod)
    clamped = {"constrained_position_idx": (0, -1), "constrained_director_idx": (0, -1)}
    simulator.constrain(rod).using(ea.FixedConstraint, **clamped)
    simulator.add_forcing_to(rod).using(ea.GravityForces, acc_gravity=np.array([0.0, -GRAVITY, 0.0]))
    if kind == "our material":
        simulator.add_forcing_to(rod).using(_OurMaterial, stiffness, bending)
    simulator.finalize()
    return simulator, rod


def largest_step(elements: int, E: float) -> float:
    """Stability limit 2/omega [s] of the shortest wave, in which neighbouring sections turn against each other.

    omega^2 = (E/rho) 4/dx^2 + kappa_s G A/(rho I): for fine grids the time of sound along an element.
    """
    dx, sound = SPAN / elements, np.sqrt(E / DENSITY)
    shear = OUR_SHEAR / (2 * (1 + POISSON)) * 4 / RADIUS**2
    return float(2 / (sound * np.sqrt(4 / dx**2 + shear)))


def fall(elements: int, E: float, fraction: float, kind: Rod) -> Fall:
    """Let the rod fall from rest."""
    simulator, rod = set_up(elements, E, kind)
    stepper, now, found = ea.PositionVerlet(), np.float64(0.0), []
    limit = fraction * largest_step(elements, E)
    began = time.process_time()
    for start, end in zip((0.0, *TIMES), TIMES, strict=False):
        steps = max(1, int(np.ceil((end - start) / limit - 1e-9)))
        for _ in range(steps):
            now = stepper.step(simulator, now, np.float64((end - start) / steps))
        found.append(rod.position_collection[1, elements // 2])
    return Fall(np.array(found), time.process_time() - began)


EFFECTS = (
    "inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear", "rotary-inertia",
)  # fmt: skip
"""All that an elastic rod can have; what PyElastica's rod has, too."""
_FRAMES = [1, 2, 4]
"""Of the five over 0.2 s, those at ``TIMES``."""
_QUICK, _REPEATS = 0.5, 5


def filament(E: float, cells: int, rtol: float) -> Fall:
    """The rod as this package solves it: seconds of the solve stage, the best of five runs if they are short."""
    prepared = build(_scene(E, cells, rtol), choose_effects(_scene(E, cells, rtol)))
    row = prepared.graph.differential.kinds.index("y")
    prepared.solve(Silence())
    seconds = []
    while len(seconds) < _REPEATS and sum(seconds) < _QUICK:
        began = time.process_time()
        solution = prepared.solve(Silence())
        seconds.append(time.process_time() - began)
    return Fall(SPAN * np.asarray(solution.x[row, _FRAMES]).ravel(), min(seconds))


def _scene(E: float, cells: int, rtol: float) -> sc.Scene:
    return sc.Scene.model_validate(
        {
            "filament": {
                "span": f"{SPAN} m",
                "thickness": f"{2 * RADIUS} m",
                "section": "circle",
                "density": f"{DENSITY} kg/m^3",
            },
            "material": {"law": "elastic", "youngs_modulus": f"{E!r} Pa", "poisson": POISSON},
            "load": {"gravity": f"{GRAVITY} m/s^2"},
            "run": {"duration": f"{TIMES[-1]} s", "frames": 5, "effects": list(EFFECTS)},
            "numerics": {"cells": cells, "rtol": rtol},
        }
    )


def peer(elements: int, E: float, fraction: float, kind: Rod) -> Fall:
    """The rod as PyElastica solves it, the best of five runs if they are short."""
    runs = [fall(elements, E, fraction, kind)]
    while len(runs) < _REPEATS and sum(run.seconds for run in runs) < _QUICK:
        runs.append(fall(elements, E, fraction, kind))
    return Fall(runs[0].midpoints, min(run.seconds for run in runs))


def error_of(found: Array, converged: Array) -> float:
    """Largest error of the three midpoints over the largest sag."""
    return float(np.max(np.abs(found - converged)) / np.max(np.abs(converged)))


def extrapolated(coarse: Array, fine: Array) -> Array:
    """Limit of a second-order sequence from a grid and one twice as fine."""
    return fine + (fine - coarse) / 3


def our_limit(E: float) -> Array:
    """Midpoints of this package for vanishing cells and steps."""
    coarse, fine = (filament(E, cells, 1e-6).midpoints for cells in (80, 160))
    return extrapolated(coarse, fine)


def peer_limit(E: float, kind: Rod) -> Array:
    """Midpoints of PyElastica for vanishing elements and steps, with the clamps of second order."""
    coarse, fine = (fall(elements, E, 0.5, kind).midpoints for elements in (400, 800))
    return extrapolated(coarse, fine)
