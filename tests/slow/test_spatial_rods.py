"""Elastic rods in three dimensions: thin rods, turns as a whole, full turns, a hundred swings."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.discretization.unknowns import Floats
from tests.common.table import show

pytestmark = pytest.mark.slow

AT_REST = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear"]
ARC = 78.5398163  # 45 degrees of a circle of radius 100


def bend(cells: int, force: float, thickness: float = 1.0) -> Floats:
    """Tip of Bathe & Bolourchi's bend [over the radius of 100]; a thinner one is pulled by as much of its stiffness."""
    scene = sc.Scene.from_dict(
        {
            "filament": {"span": ARC, "thickness": thickness, "density": 1.0, "curvature": 0.01},
            "material": {"law": "elastic", "youngs_modulus": 1e7 / thickness**4, "poisson": 0.0},
            "ends": {"right": "free"},
            "load": {"gravity": 0.0, "tip_force": [0, 0, force]},
            "run": {"duration": 1.0, "frames": 2, "effects": AT_REST},
            "numerics": {"cells": cells, "grading": 1.0, "estimate": False},
        }
    )
    run = sc.simulate(scene)
    assert run.outcome.is_success, run.summary["message"]
    return np.array([run.data[name].values[-1, -1] - run.data[name].values[-1, 0] for name in "xyz"])


def test_thin_rods_do_not_lock() -> None:
    """The error of eight elements does not grow as the rod becomes ten times thinner at the same stiffness.

    One that locks is stiffer by (L/h0)^2: a hundred times further off.
    """
    rows, errors = [], []
    for share in (2e-2, 2e-3):
        coarse, fine, finest = (bend(cells, 300.0, share * ARC) for cells in (4, 8, 16))
        limit = finest + (finest - fine) / 3
        errors.append(float(np.linalg.norm(coarse - limit)) / 100)
        rows.append([f"{share:g}", *(f"{one:.3f}" for one in coarse), f"{errors[-1]:.2e}"])
    show("eight elements of a bend under 300 EI-alike", ("h0/L", "x", "y", "z", "error over the radius"), rows)
    assert max(errors) < 1.05 * min(errors) and max(errors) < 2e-3


def twisted(modulus: float, radius: float, twist: float) -> tuple[float, float]:
    """Torque and stretch of a round bar that nothing pulls, of the law at a point.

    W = E (log Lam + gam^2/4)^2/2 + mu gam^2/2 with gam = Lam^-3/2 k r, at the one radius that stands for an elastic
    section; W does not change with Lam.
    """
    ring, shear = radius / np.sqrt(2), modulus / 3

    def stresses(stretch: float) -> tuple[float, float, float]:
        sheared = stretch**-1.5 * twist * ring
        along = modulus * (np.log(stretch) + sheared**2 / 4)
        return along, shear * sheared + along * sheared / 2, sheared

    def pull(stretch: float) -> float:
        along, across, sheared = stresses(stretch)
        return along - 1.5 * across * sheared

    stretch = float(brentq(pull, 0.9, 1.1, xtol=1e-15))
    return np.pi * radius**2 * stresses(stretch)[1] * stretch**-1.5 * ring, stretch


def test_turns_by_four_pi() -> None:
    """A rod that is twisted two turns and back, and one that is rolled up twice by nature."""
    length, radius, modulus = 1.0, 5e-3, 4e6
    base: dict[str, Any] = {
        "filament": {"span": length, "diameter": 2 * radius, "density": 1000.0},
        "material": {"law": "elastic", "youngs_modulus": modulus, "poisson": 0.5 - 1e-9},
        "load": {"gravity": 0.0},
        "ends": {"right_slides": True, "right_twist": [[0, 0], [1, 4 * np.pi], [2, 0]]},
        "run": {"duration": 2.0, "frames": 41, "effects": AT_REST},
        "numerics": {"cells": 10, "estimate": False, "rtol": 1e-8},
    }
    run = sc.simulate(sc.Scene.from_dict(base))
    assert run.outcome.is_success, run.summary["message"]
    torque, stretch = (run.data[name].values[:, 5] for name in ("torque", "stretch"))
    exact, longer = twisted(modulus, radius, 4 * np.pi / length)
    linear = modulus / 3 * np.pi * radius**4 / 2 * 4 * np.pi / length
    rolled = sc.simulate(
        sc.Scene.from_dict(
            {
                "filament": {
                    "span": length,
                    "diameter": 2 * radius,
                    "density": 1000.0,
                    "curvature": 4 * np.pi,
                    "twist": 1.0,
                },
                "material": base["material"],
                "load": {"gravity": 0.0},
                "ends": {"right": "free"},
                "run": {"duration": 1.0, "frames": 2, "effects": AT_REST},
                "numerics": {"cells": 40, "estimate": False},
            }
        )
    )
    stress = float(np.abs(rolled.data.moment.values).max()) / (modulus * radius**4)
    rows = [
        ["torque after two turns over G J k", f"{torque[20] / linear:.6f}"],
        ["torque over that of the law at a point, less 1", f"{torque[20] / exact - 1:.1e}"],
        ["lengthening over that of the law at a point, less 1", f"{(stretch[20] - 1) / (longer - 1) - 1:.1e}"],
        ["torque after as many back over that", f"{torque[-1] / exact:.1e}"],
        ["energy residual", f"{run.summary['energy_residual']:.1e}"],
        ["moment of a rod at rest in two coils, over E R^4", f"{stress:.1e}"],
    ]
    show("turns by 4 pi", ("", "found"), rows)
    assert torque[20] == pytest.approx(exact, rel=1e-8) and abs(torque[-1]) < 1e-8 * exact
    assert stretch[20] - 1 == pytest.approx(longer - 1, rel=1e-6)
    assert run.summary["energy_residual"] < 1e-6 and stress < 1e-8


def test_energy_over_a_hundred_swings() -> None:
    """A cantilever twice as wide as thick that swings about both axes at once."""
    length, h, b, modulus, density, swings = 0.2, 6e-3, 12e-3, 4e6, 1900.0, 100
    period = 2 * np.pi / (3.516 * np.sqrt(modulus * h**2 / (12 * density * length**4)))
    scene = sc.Scene.from_dict(
        {
            "filament": {"span": length, "thickness": h, "width": b, "density": density},
            "material": {"law": "elastic", "youngs_modulus": modulus, "poisson": 0.45},
            "ends": {"right": "free"},
            "load": {"gravity": 1.5, "direction": [0, -1, 1]},
            "run": {"duration": swings * period, "frames": 2001, "effects": ["inertia", *AT_REST]},
            "numerics": {"cells": 4, "grading": 1.0, "estimate": False, "rtol": 1e-6, "backend": "compiled"},
        }
    )
    run = sc.simulate(scene)
    assert run.outcome.is_success, run.summary["message"]
    kinetic, elastic, weight = (run.fields[f"energy_{name}"] for name in ("kinetic", "elastic", "potential"))
    drift = float(np.ptp(kinetic + elastic + weight) / kinetic.max())
    tip = [float(np.ptp(run.data[name].values[:, -1])) / length for name in "yz"]
    swing = run.data.y.values[:, -1] - run.data.y.values[:, -1].mean()
    crossings = int(np.sum(np.diff(np.sign(swing)) != 0)) // 2
    row = [f"{drift:.1e}", crossings, *(f"{one:.2f}" for one in tip), run.summary["steps"]]
    header = ("energy lost over the kinetic", "swings in y", "y/L", "z/L", "steps")
    show("a hundred swings of a cantilever about both axes", header, [row])
    assert drift < 1e-5 and min(tip) > 0.05 and crossings >= 80 and np.abs(run.fields["twist"]).max() > 0.1
