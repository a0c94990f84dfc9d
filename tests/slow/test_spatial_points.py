"""Points of a section in three dimensions against exact laws: thin tubes, twisted shafts beyond yield and in flow."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import softcat_sym as sc
from softcat_sym.discretization.unknowns import Floats
from tests.common.table import show

pytestmark = pytest.mark.slow

# So short that what is squeezed does not buckle.
SPAN, DIAMETER, MODULUS = 0.02, 0.006, 4e6
POISSON = 0.5 - 1e-9  # Energies of Hencky's strain alone are those of what keeps its volume
SHEAR = MODULUS / 3
RADIUS = DIAMETER / 2
AREA = np.pi * RADIUS**2
TUBE = RADIUS / np.sqrt(2)  # Three points on one ring: all of the section at one radius
EFFECTS = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear", "fibres"]
EFFECTS += ["viscous-flow", "yielding"]


def shaft(material: dict[str, Any], rows: list[tuple[float, float, float]], **changes: object) -> Any:
    """A circular shaft between clamps that stretch and twist it: rows of time [s], stretch and twist [1/m]."""
    scene = sc.Scene.from_dict(
        {
            "filament": {"span": SPAN, "thickness": DIAMETER, "section": "circle", "density": 1900.0},
            "material": {"law": "bingham", "youngs_modulus": MODULUS, "poisson": POISSON, **material},
            "load": {"gravity": 0.0},
            "ends": {
                "motion": [[time, SPAN * (stretch - 1), 0.0] for time, stretch, _ in rows],
                "right_twist": [[time, SPAN * twist] for time, _, twist in rows],
            },
            "run": {"duration": rows[-1][0], "frames": 81, "effects": EFFECTS, "dimensions": 3},
            "numerics": {"cells": 4, "grading": 1.0, "estimate": False, "rtol": 1e-9},
        }
    ).replace(changes)
    run = sc.simulate(scene)
    assert run.outcome.is_success, run.summary["message"]
    # What is stretched and twisted at its ends alone is the same all along.
    forces = [run.data.tension.values, run.data.torque.values / RADIUS]
    assert max(np.ptp(one, axis=1).max() for one in forces) < 1e-4 * max(np.abs(one).max() for one in forces)
    return run.data


@dataclass(frozen=True)
class Path:
    """Stretch and shear of the wall of a tube: rows of time [s], stretch and twist times radius."""

    name: str
    rows: tuple[tuple[float, float, float], ...]

    def at(self, time: float | Floats) -> tuple[Any, Any]:
        """Stretch and twist times radius."""
        times, *values = np.array(self.rows).T
        stretch, turn = (np.interp(time, times, one) for one in values)
        return stretch, turn


PATHS = (
    Path("stretch, then twist", ((0, 1, 0), (1, 1.3, 0), (2, 1.3, 0.6))),
    Path("twist, squeeze, untwist", ((0, 1, 0), (1, 1, 0.6), (2, 0.9, 0.6), (3, 0.9, 0))),
)


def bingham(limit: float, stress: float) -> float:
    """Plastic rate of an equivalent stress [1/s]; viscous enough that a neck does not outgrow rounding."""
    return max(stress - limit, 0.0) / (limit * 1.0)


Answer = tuple[Floats, Floats]
"""Tension over the undeformed area, and torque over it and the radius [Pa]."""


def integrated(path: Path, state: Floats, rate: Callable[[float, Floats], Floats], times: Floats) -> Floats:
    """A stiff integration from corner to corner of a path."""
    corners = [row[0] for row in path.rows]
    found = [state[:, None]]
    for start, end in pairwise(corners):
        inside = times[(times > start) & (times < end)]
        part = solve_ivp(rate, (start, end), state, "LSODA", [*inside, end], rtol=1e-10, atol=1e-12)
        assert part.success, part.message
        found.append(part.y[:, : None if end in times else -1])
        state = part.y[:, -1]
    return np.hstack(found)


def multiplied(path: Path, limit: float, times: Floats) -> Answer:
    """F = Fe Fp in matrices of 3 x 3, Hencky's energy mu |log Ue|^2, J2 flow of the Mandel stress without plastic spin.

    Both sides of the wall contract alike, as the theory has them.
    """

    def gradient(time: float) -> Floats:
        stretch, turn = path.at(time)
        contracted = stretch**-0.5
        return np.array([[stretch, 0, 0], [0, contracted, 0], [turn * contracted, 0, contracted]])

    def mandel(F: Floats, plastic: Floats) -> Floats:
        elastic = F @ np.linalg.inv(plastic)
        size, axes = np.linalg.eigh(elastic.T @ elastic)
        stress = SHEAR * (axes * np.log(size)) @ axes.T
        return stress - np.trace(stress) / 3 * np.eye(3)

    def first_piola(F: Floats, plastic: Floats) -> Floats:
        elastic = F @ np.linalg.inv(plastic)
        kirchhoff = np.linalg.inv(elastic).T @ mandel(F, plastic) @ elastic.T
        return kirchhoff @ np.linalg.inv(F).T

    def slope(time: float, way: int) -> Floats:
        """Of F by the stretch, or by the twist times radius."""
        stretch, turn = path.at(time)
        contracted, by = stretch**-0.5, -0.5 / stretch
        if way == 1:
            return np.array([[0, 0, 0], [0, 0, 0], [contracted, 0, 0]])
        return np.array([[1, 0, 0], [0, by * contracted, 0], [turn * by * contracted, 0, by * contracted]])

    def rate(time: float, state: Floats) -> Floats:
        plastic = state.reshape(3, 3)
        stress = mandel(gradient(time), plastic)
        equivalent = max(np.sqrt(1.5) * np.linalg.norm(stress), 1e-12 * MODULUS)
        return np.asarray(1.5 * bingham(limit, equivalent) / equivalent * stress @ plastic).ravel()

    states = integrated(path, np.eye(3).ravel(), rate, times)
    answer = []
    for time, state in zip(times, states.T, strict=True):
        plastic = state.reshape(3, 3)
        stress = first_piola(gradient(time), plastic)
        answer.append([np.sum(stress * slope(time, way)) for way in (0, 1)])
    tension, torque = np.array(answer).T
    return tension, torque


def off(found: Answer, exact: Answer) -> float:
    """Largest error of the tension and of the torque, over the largest of the work that either does."""
    size = max(np.abs(exact[0]).max(), np.abs(exact[1]).max())
    return max(float(np.abs(one - other).max()) for one, other in zip(found, exact, strict=True)) / size


def tube(path: Path, limit: float) -> tuple[Floats, Answer]:
    """A run with all points on one ring."""
    data = shaft(
        {"yield_stress": limit, "viscosity": limit * 1.0},
        [(time, stretch, turn / TUBE) for time, stretch, turn in path.rows],
        **{"numerics.fibres": 3},
    )
    tension, torque, twist, stretch = (data[name].values[:, 3] for name in ("tension", "torque", "twist", "stretch"))
    force = tension - 1.5 * torque * twist / stretch
    return data.time.values, (force / AREA, torque / AREA / TUBE)


LIMITS = (2e4, 8e4)  # 0.5 and 2 % of the modulus


def test_stretched_and_twisted_tubes() -> None:
    """A run is the exact one to the square of the elastic strain."""
    rows, apart = [], dict[tuple[str, float], float]()
    for path in PATHS:
        for limit in LIMITS:
            times, found = tube(path, limit)
            error = off(found, multiplied(path, limit, times))
            apart[path.name, limit] = error
            rows.append([path.name, f"{limit / MODULUS:.1%}", f"{error:.1e}"])
            assert error < 1.2 * (limit / MODULUS) ** 2 + 1e-7
    header = ("path", "yield strain", "from F = Fe Fp")
    show("tension and torque of a thin tube, stretched 1.3 times and sheared 0.6", header, rows)
    assert max(error for (_, limit), error in apart.items() if limit == LIMITS[1]) < 1e-3


RINGS = {3: 15, 6: 60}
"""Points of a section that has so many rings; the first is the usual one."""
LOW = 4e3  # A thousandth of the modulus: elastic strains are small


def at_rings(rings: int, stress: Callable[[Floats], Floats]) -> float:
    """Torque of a shear stress that depends on the radius over that of the surface, by the rings of a section."""
    square, share = np.polynomial.legendre.leggauss(rings)
    radius = np.sqrt((square + 1) / 2)
    return float(np.sum(share / 2 * AREA * RADIUS * radius * stress(radius)))


def torque_at(data: Any, cell: int = 3) -> Floats:
    """Torque of a cell in the middle [N m]."""
    values: Floats = data.torque.values[:, cell]
    return values


def test_torsion_beyond_yield() -> None:
    """T/T_Y = (4/3)(1 - (theta_Y/theta)^3/4), as slowly as a viscosity does not matter."""
    surface, rows = LOW / np.sqrt(3), []
    at_yield, first = np.pi * RADIUS**3 * surface / 2, surface / SHEAR / RADIUS
    strains = np.array([0.5, 1.0, 1.5, 2.0, 3.0, 5.0])
    exact = np.where(strains <= 1, strains, 4 / 3 * (1 - np.maximum(strains, 1.0) ** -3 / 4))
    worst = dict[int, float]()
    for rings, points in RINGS.items():
        material = {"yield_stress": LOW, "viscosity": 1e-4 * LOW / (5 * first * RADIUS)}
        changes = {"numerics.fibres": points, "run.frames": 101, "numerics.rtol": 1e-7}
        data = shaft(material, [(0, 1, 0), (1, 1, 5 * first)], **changes)
        found = np.interp(strains / 5, data.time.values, torque_at(data)) / at_yield
        sampled = [at_rings(rings, lambda r, n=n: surface * np.minimum(r * n, 1)) / at_yield for n in strains]
        worst[rings] = float(np.max(np.abs(found / exact - 1)))
        rows.append([f"{rings}", *(f"{one:.4f}" for one in found), f"{worst[rings]:.1e}"])
        assert np.allclose(found, sampled, rtol=5e-4)
    rows.append(["exact", *(f"{one:.4f}" for one in exact), ""])
    show("T/T_Y at theta/theta_Y", ("rings", *(f"{one:g}" for one in strains), "largest error"), rows)
    assert worst[3] < 0.03 and worst[6] < 5e-3


def test_torsion_in_steady_flow() -> None:
    """T = (2 pi/3) tau_Y R^3 + (eta/3)(pi/2) R^4 theta_t of a Bingham shaft that is turned at a steady rate."""
    surface, rows = LOW / np.sqrt(3), []
    rate = 200.0  # [1/(m s)]: the surface shears at 0.6 /s
    worst = dict[int, float]()
    for number in (0.1, 10.0):
        viscosity = 3 * number * surface / (rate * RADIUS)
        exact = 2 * np.pi / 3 * surface * RADIUS**3 + viscosity / 3 * np.pi / 2 * RADIUS**4 * rate
        # Until the innermost ring flows, too.
        relaxed = 15 * surface / (SHEAR * rate * RADIUS) + 30 * viscosity / MODULUS
        row = [f"{number:g}"]
        for rings, points in RINGS.items():
            material = {"yield_stress": LOW, "viscosity": viscosity}
            rows_of_time = [(0, 1, 0), (relaxed, 1, rate * relaxed)]
            changes = {"numerics.fibres": points, "run.frames": 11, "numerics.rtol": 1e-6}
            data = shaft(material, rows_of_time, **changes)
            found = torque_at(data)[-1]
            sampled = at_rings(rings, lambda r, n=number: surface * (1 + n * r))
            assert found == pytest.approx(sampled, rel=1e-6 + ((1 + number) * surface / SHEAR) ** 2)
            worst[rings] = max(worst.get(rings, 0), abs(found / exact - 1))
            row.append(f"{found / exact - 1:+.1e}")
        rows.append(row)
    show("steady torque of a Bingham shaft over the exact one, less 1", ("eta gamma_t/tau_Y", *RINGS), rows)
    assert worst[3] < 5e-3 and worst[6] < 2e-3
