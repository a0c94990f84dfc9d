"""Energy of a material point: the potential of its stress, what flow takes from it, and nothing lost in between."""

from __future__ import annotations

import copy
import math

import numpy as np
import pytest

from softcat_sym.reference.material_point import MaterialPoint

from ..acceptance.table import show
from .paths import BINGHAM, ELASTIC, MAXWELL, cycle, march, shear_and_stretch

LAWS = [("elastic", ELASTIC), ("maxwell", MAXWELL), ("bingham", BINGHAM)]


@pytest.mark.parametrize(("law", "constants"), LAWS, ids=lambda value: value if isinstance(value, str) else "")
def test_the_stress_is_the_slope_of_the_energy(law: str, constants: dict[str, float]) -> None:
    point = march(MaterialPoint(law, constants), shear_and_stretch, 40)
    point.step(point.deformation, 0.0)
    small = 1e-5
    for i in range(2):
        for j in range(2):
            energies = []
            for side in (1, -1):
                moved = copy.copy(point)
                deformation = point.deformation.copy()
                deformation[i, j] += side * small
                moved.step(deformation, 0.0)
                energies.append(moved.energy)
            assert (energies[0] - energies[1]) / (2 * small) == pytest.approx(point.stress[i, j], abs=1e-9)
    assert point.energy > 1e-4


def test_a_held_maxwell_point_relaxes_exponentially() -> None:
    """Held, M_1 + M_2 decays with rate E/(2 (1 - nu) eta) and M_1 - M_2 with 3E/(2 (1 + nu) eta)."""
    E, nu, eta = MAXWELL["youngs_modulus"], MAXWELL["poisson"], MAXWELL["viscosity"]
    held, time = np.array([[1.12, 0.05], [0.05, 0.97]]), 0.8
    start = MaterialPoint("maxwell", MAXWELL)
    start.step(held, 0.0)
    rows, errors = [], []
    wanted = np.array([math.exp(-E * time / (2 * (1 - nu) * eta)), math.exp(-1.5 * E * time / ((1 + nu) * eta))])
    for steps in (50, 100, 200):
        point = copy.copy(start)
        for _ in range(steps):
            point.step(held, time / steps)
        left = []
        for tau in (point.kirchhoff, start.kirchhoff):
            left.append([np.trace(tau), math.hypot(tau[0, 0] - tau[1, 1], 2 * tau[0, 1])])
        found = np.array(left[0]) / np.array(left[1])
        errors.append(np.abs(found - wanted))
        rows.append([steps, *(f"{f:.6f} ({w:.6f})" for f, w in zip(found, wanted, strict=True))])
    show("stress left after holding; in brackets the exact value", ("steps", "sum", "difference"), rows)
    assert errors[0] / errors[1] == pytest.approx([2, 2], abs=0.05)
    assert errors[1] / errors[2] == pytest.approx([2, 2], abs=0.05)
    assert errors[2].max() < 2e-3


@pytest.mark.parametrize(("law", "constants"), LAWS[1:], ids=lambda value: value if isinstance(value, str) else "")
def test_flow_never_gives_energy_back(law: str, constants: dict[str, float]) -> None:
    rng, done = np.random.default_rng(9), 0.0
    point = MaterialPoint(law, constants)
    for _ in range(300):
        point.step(np.eye(2) + 0.2 * rng.uniform(-1, 1, size=(2, 2)), rng.uniform(0, 1))
        assert point.work >= done
        assert point.energy >= 0
        assert point.rate >= 0
        done = point.work
    assert done > 0.1


@pytest.mark.parametrize(("law", "constants"), LAWS, ids=lambda value: value if isinstance(value, str) else "")
def test_the_energy_of_a_cycle_balances(law: str, constants: dict[str, float]) -> None:
    rows, misses = [], []
    for steps in (200, 400, 800, 1600):
        point, given = MaterialPoint(law, constants), 0.0
        for n in range(1, steps + 1):
            before, stress = point.deformation, point.stress
            point.step(cycle(n / steps), 1 / steps)
            given += float(np.sum((stress + point.stress) / 2 * (point.deformation - before)))
        misses.append(given - point.energy - point.work)
        rows.append([steps, f"{given:.3e}", f"{point.energy:.3e}", f"{point.work:.3e}", f"{misses[-1]:.1e}"])
    show(f"{law}: energy of a closed cycle", ("steps", "work given", "stored", "dissipated", "missing"), rows)
    if law == "elastic":
        assert abs(given) < 1e-6
        assert point.energy == pytest.approx(0, abs=1e-30)
    else:
        assert given > 1e-4
        assert misses[-2] / misses[-1] == pytest.approx(2, abs=0.15)
    assert abs(misses[-1]) < 0.01 * max(point.work, 1e-4)


def test_below_the_yield_stress_a_bingham_point_is_the_elastic_one() -> None:
    elastic, bingham = MaterialPoint("elastic", ELASTIC), MaterialPoint("bingham", {**BINGHAM, "yield_stress": 10.0})
    for point in (elastic, bingham):
        march(point, shear_and_stretch, 10)
    assert np.array_equal(elastic.stress, bingham.stress)
    assert np.array_equal(bingham.state, [1, 0, 1])
    assert bingham.work == bingham.rate == 0
