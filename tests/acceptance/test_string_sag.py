"""Strings, which carry their weight by tension alone, with their prefactors; and Trouton's ratio on a straight bar.

A parabola of sag H carries sigma = q/H with q = rho g L^2/8 and has the strain (8/3)(H/L)^2. A power law in line with a
spring, eps_t = (sigma/K)^(1/n) + sigma_t/E, makes that
(16/3L^2) H^(2+1/n)/(2+1/n) + (q/E) H^(1/n-1)/(1/n-1) = (q/K)^(1/n) t + constant: H goes as t^(n/(2n+1)) in the end.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from .rheology import GEOMETRY, Array, flow_of, limit_of, scene, solved
from .table import show

STRESS = 1e4
"""rho g L [Pa], L = 1 m."""
PULL = STRESS / 8
"""Stress times sag over L [Pa]."""
INDICES = (0.3, 0.5, 1.0, 2.0)
FINAL = 0.03
"""Sag to end with, over L."""


def consistency(index: float) -> float:
    """K of the string that has its final sag after 1 s, if it is rigid before it flows."""
    power = 2 + 1 / index
    return float(PULL * (3 * power / 16 / FINAL**power) ** index)


def power_law_sag(time: Array, index: float, E: float) -> Array:
    """Sag of the spring and the flow together; it starts as the elastic cable."""
    K, power = consistency(index), 1 / index

    def passed(H: float) -> float:
        spring = np.log(H) if index == 1 else H ** (power - 1) / (power - 1)
        return float(16 / 3 * H ** (2 + power) / (2 + power) + PULL / E * spring)

    start = (3 * STRESS / (64 * E)) ** (1 / 3)
    goals = passed(start) + (PULL / K) ** power * np.asarray(time)
    return np.array([brentq(lambda H, goal=goal: passed(H) - goal, 0.5 * start, 1.0, xtol=1e-15) for goal in goals])


def histories(index: float, E: float, frames: int) -> tuple[Array, Array]:
    """Times and sags of a bare string, extrapolated from two grids."""
    law = "power-law"
    found = []
    for cells in (10, 20):
        material = {"law": law, "youngs_modulus": E, "viscosity": consistency(index), "index": index}
        asked = scene(
            material, {"thickness": 0.01}, effects=flow_of(law), run={"frames": frames}, cells=cells, rtol=1e-7
        )
        data = solved(asked)
        found.append(-data["midpoint"].values)
    return data["time"].values, limit_of(*found)


def test_power_law_string_with_its_spring() -> None:
    """The whole history, from the elastic sag on."""
    for index in INDICES:
        E = 1e5 * STRESS
        time, found = histories(index, E, 11)
        error = found / power_law_sag(time, index, E) - 1
        rows = [[f"{t:.1f}", f"{H:.6f}", f"{e:+.1e}"] for t, H, e in zip(time, found, error, strict=True)][::2]
        show(f"power-law string, n = {index:g}, E* = 1e5", ("t [s]", "sag/L", "error"), rows)
        assert np.max(np.abs(error)) < 1e-5


def test_power_law_string_scaling_with_its_prefactor() -> None:
    """H = [(2 + 1/n)(3 L^2/16)(rho g L^2/8K)^(1/n) t]^(n/(2n+1)) once the elastic sag is forgotten."""
    rows = []
    for index in INDICES:
        time, found = histories(index, 1e8 * STRESS, 21)
        power = 2 + 1 / index
        exact = (power * 3 / 16 * (PULL / consistency(index)) ** (1 / index) * time) ** (1 / power)
        late = time > 0.3
        exponent = float(np.polyfit(np.log(time[late]), np.log(found[late]), 1)[0])
        error = float(np.max(np.abs(found[late] / exact[late] - 1)))
        wanted = index / (2 * index + 1)
        rows.append([f"{index:g}", f"{exponent:.5f}", f"{wanted:.5f}", f"{error:.1e}"])
        assert exponent == pytest.approx(wanted, rel=1e-3)
        assert error < 1e-3
    show("power-law strings, E* = 1e8", ("n", "exponent", "n/(2n+1)", "error of the prefactor"), rows)


def test_viscous_and_elastic_prefactors() -> None:
    """Newtonian 9/128 and elastic 3/64, thin filaments with every term of the theory, bending included."""
    final, eta = 0.02, 1e6
    duration = final**3 * 128 * eta / (9 * STRESS)
    viscous = scene(
        {"law": "newtonian", "viscosity": eta},
        {"thickness": 1e-4},
        effects=(*GEOMETRY, "viscous-stress"),
        run={"duration": duration, "frames": 6},
        cells=40,
        rtol=1e-6,
    )
    data = solved(viscous)
    flowed = float(-data["midpoint"][-1]) ** 3 * eta / (STRESS * duration)
    E_star = 1e5
    elastic = scene(
        {"law": "elastic", "youngs_modulus": E_star * STRESS}, {"thickness": 1e-4}, effects=GEOMETRY, cells=40
    )
    hung = float(-solved(elastic)["midpoint"][-1]) ** 3 * E_star
    rows = [
        ["H^3 eta/(rho g L^4 t), Newtonian", f"{flowed:.6f}", f"{9 / 128:.6f}", f"{flowed * 128 / 9 - 1:+.1e}"],
        ["H^3 E/(rho g L^4), elastic", f"{hung:.6f}", f"{3 / 64:.6f}", f"{hung * 64 / 3 - 1:+.1e}"],
    ]
    show("string prefactors, h/L = 1e-4", ("prefactor", "found", "exact", "error"), rows)
    assert flowed == pytest.approx(9 / 128, rel=5e-3)
    assert hung == pytest.approx(3 / 64, rel=5e-3)


@pytest.mark.parametrize("ends", ["clamped", "pinned"])
def test_troutons_ratio_on_a_bar_drawn_to_twice_its_length(ends: str) -> None:
    """T s/(A0 eps_t) = 3 mu, from the shear viscosity in the scene, with the section of constant volume."""
    mu, thickness = 100.0, 0.02
    asked = scene(
        {"law": "newtonian", "shear_viscosity": mu},
        {"thickness": thickness},
        effects=(*GEOMETRY, "viscous-stress"),
        ends={"left": ends, "right": ends, "motion": [(0, 0, 0), (1, 1, 0)]},
        load={"gravity": 0.0},
        run={"duration": 0.9999, "frames": 6},
        rtol=1e-6,
    )
    data = solved(asked)
    length = 1 + data["time"].values
    stretch, tension = data["stretch"].values, data["tension"].values
    ratio = (tension * stretch / thickness**2).T / (mu / length)
    rows = [[f"{s:.3f}", f"{r.min():.9f}", f"{r.max():.9f}"] for s, r in zip(length, ratio.T, strict=True)]
    show(f"Trouton's ratio of a {ends} bar", ("stretch", "least over the cells", "largest"), rows)
    np.testing.assert_allclose(stretch.T, np.broadcast_to(length, stretch.T.shape), rtol=1e-6)
    np.testing.assert_allclose(ratio[:, 1:], 3, rtol=1e-6)
