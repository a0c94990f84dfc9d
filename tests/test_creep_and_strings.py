"""Beams and strings that creep, against their exact histories, with their prefactors.

A parabola of sag H carries sigma = q/H with q = rho g L^2/8 and has the strain (8/3)(H/L)^2. A power law in line with a
spring, eps_t = (sigma/K)^(1/n) + sigma_t/E, makes that
(16/3L^2) H^(2+1/n)/(2+1/n) + (q/E) H^(1/n-1)/(1/n-1) = (q/K)^(1/n) t + constant: H goes as t^(n/(2n+1)) in the end.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from tests.common import curves
from tests.common.rheology import GEOMETRY, Array, flow_of, limit_of, scene, solved
from tests.common.table import show
from tests.common.viscous_string import breaking_time, viscous_string

STRESS = 1e4
"""rho g L [Pa], L = 1 m."""
LAWS, ARM = ("kelvin-voigt", "standard-linear"), 3.0
"""Solids that creep; second modulus over the lasting one."""
PULL = STRESS / 8
"""Stress times sag over L [Pa]."""
INDICES = (0.3, 0.5, 1.0, 2.0)
FINAL = 0.03
"""Sag of a power-law string in the end, over L."""


def solid(law: str, E: float, retardation: float) -> dict[str, Any]:
    """A material that comes to rest within a few retardation times: eta/E, or eta (1/E + 1/E_2)."""
    if law == "kelvin-voigt":
        return {"law": law, "youngs_modulus": E, "viscosity": E * retardation}
    arm = ARM * E
    return {"law": law, "youngs_modulus": E, "second_modulus": arm, "viscosity": retardation / (1 / E + 1 / arm)}


def compliance(law: str, part: Array) -> Array:
    """Creep J(t) E at t over the retardation time (Findley, Lai and Onaran 1976, table 5.1)."""
    late = 0.0 if law == "kelvin-voigt" else 1 / (1 + ARM)
    return late + (1 - late) * -np.expm1(-part)


def test_a_linear_beam_creeps_as_its_material() -> None:
    """Midpoint rho g L^4 J(t)/(32 h^2), by the correspondence of linear viscoelasticity and elasticity."""
    thickness, static, rows = 0.02, 2e-5, []
    E = STRESS / (32 * thickness**2 * static)
    for law in LAWS:
        asked = {"effects": (*GEOMETRY, *flow_of(law)), "run": {"frames": 11}, "rtol": 1e-7}
        material, filament = solid(law, E, 0.2), {"thickness": thickness}
        runs = [solved(scene(material, filament, cells=cells, **asked)) for cells in (10, 20)]
        found = limit_of(*(-data["midpoint"].values / static for data in runs))
        part = runs[0]["time"].values / 0.2
        expected = compliance(law, part)
        rows += [[law, f"{t:.1f}", f"{a:.6f}", f"{b:.6f}"] for t, a, b in zip(part, found, expected, strict=True)][::2]
        np.testing.assert_allclose(found, expected, atol=2e-4)
    show("sag of a beam over its static one", ("law", "t/retardation", "found", "exact"), rows)


def test_a_soft_filament_comes_to_rest_in_its_elastic_shape() -> None:
    """The whole static theory between clamps, by a boundary-value solver; 30 retardation times."""
    thickness, X, clamp, rows = 0.05, np.linspace(0, 1, 41), ("clamped", 0.0), []
    area = thickness**2
    for law in LAWS:
        for E_star in (10.0, 300.0):
            E, shapes = E_star * STRESS, []
            asked = {"effects": (*GEOMETRY, *flow_of(law)), "run": {"frames": 31}}
            for cells in (20, 40):
                data = solved(scene(solid(law, E, 1 / 30), {"thickness": thickness}, cells=cells, **asked))
                shapes.append(np.array([data["x"].values[-1], data["y"].values[-1]])[:, :: cells // 20])
            section = curves.uniform(E * area, E * area * thickness**2 / 12)
            exact = curves.held(section, STRESS * area, 1.0, 1.0, X, clamp, clamp)
            sag = -float(exact.y[20])
            error = float(np.max(np.abs(limit_of(*shapes) - [exact.x - 0.5, exact.y]))) / sag
            fine = abs(float(shapes[1][1].min()) + sag) / sag
            rows.append([law, f"{E_star:g}", f"{sag:.6f} L", f"{fine:.1e}", f"{error:.1e}"])
            assert fine < 5e-3 and error < 5e-4, rows[-1]
    show("filaments at rest", ("law", "E*", "static sag", "N = 40, error", "shape, extrapolated"), rows)


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


def power_law_string(index: float, E: float, frames: int) -> tuple[Array, Array]:
    """Times and sags of a bare string, extrapolated from two grids."""
    material = {"law": "power-law", "youngs_modulus": E, "viscosity": consistency(index), "index": index}
    asked = {"effects": flow_of("power-law"), "run": {"frames": frames}, "rtol": 1e-7}
    runs = [solved(scene(material, {"thickness": 0.01}, cells=cells, **asked)) for cells in (10, 20)]
    return runs[0]["time"].values, limit_of(*(-data["midpoint"].values for data in runs))


def test_power_law_string_with_its_spring() -> None:
    """The whole history, from the elastic sag on."""
    rows = []
    for index in INDICES:
        time, found = power_law_string(index, 1e5 * STRESS, 11)
        error = found / power_law_sag(time, index, 1e5 * STRESS) - 1
        rows.append([f"{index:g}", f"{found[0]:.6f}", f"{found[-1]:.6f}", f"{np.max(np.abs(error)):.1e}"])
        assert np.max(np.abs(error)) < 1e-5
    show("power-law strings, E* = 1e5", ("n", "sag/L at first", "in the end", "largest error"), rows)


def test_power_law_string_scaling_with_its_prefactor() -> None:
    """H = [(2 + 1/n)(3 L^2/16)(rho g L^2/8K)^(1/n) t]^(n/(2n+1)) once the elastic sag is forgotten."""
    rows = []
    for index in INDICES:
        time, found = power_law_string(index, 1e8 * STRESS, 21)
        power = 2 + 1 / index
        exact = (power * 3 / 16 * (PULL / consistency(index)) ** (1 / index) * time) ** (1 / power)
        late = time > 0.3
        exponent = float(np.polyfit(np.log(time[late]), np.log(found[late]), 1)[0])
        error = float(np.max(np.abs(found[late] / exact[late] - 1)))
        expected = index / (2 * index + 1)
        rows.append([f"{index:g}", f"{exponent:.5f}", f"{expected:.5f}", f"{error:.1e}"])
        assert exponent == pytest.approx(expected, rel=1e-3)
        assert error < 1e-3
    show("power-law strings, E* = 1e8", ("n", "exponent", "n/(2n+1)", "error of the prefactor"), rows)


def test_viscous_and_elastic_prefactors() -> None:
    """Newtonian 9/128 and elastic 3/64, thin filaments with every term of the theory, bending included."""
    final, eta, E_star, thin = 0.02, 1e6, 1e5, {"thickness": 1e-4}
    duration = final**3 * 128 * eta / (9 * STRESS)
    run, effects = {"duration": duration, "frames": 6}, (*GEOMETRY, "viscous-stress")
    fluid, elastic = {"law": "newtonian", "viscosity": eta}, {"law": "elastic", "youngs_modulus": E_star * STRESS}
    viscous = solved(scene(fluid, thin, effects=effects, run=run, cells=40, rtol=1e-6))
    flowed = float(-viscous["midpoint"][-1]) ** 3 * eta / (STRESS * duration)
    hung = float(-solved(scene(elastic, thin, effects=GEOMETRY, cells=40))["midpoint"][-1]) ** 3 * E_star
    rows = [
        ["H^3 eta/(rho g L^4 t), Newtonian", f"{flowed:.6f}", f"{9 / 128:.6f}", f"{flowed * 128 / 9 - 1:+.1e}"],
        ["H^3 E/(rho g L^4), elastic", f"{hung:.6f}", f"{3 / 64:.6f}", f"{hung * 64 / 3 - 1:+.1e}"],
    ]
    show("string prefactors, h/L = 1e-4", ("prefactor", "found", "exact", "error"), rows)
    assert flowed == pytest.approx(9 / 128, rel=5e-3)
    assert hung == pytest.approx(3 / 64, rel=5e-3)


def test_viscous_string_begins_by_its_power_law_and_breaks_in_a_finite_time() -> None:
    """The judge of ``slow/test_viscous_catenary`` alone: a correction that vanishes, a breaking time without a grid."""
    times = np.array([1e-6, 1e-5, 1e-4])
    excess = viscous_string(times, elements=60).sag / (9 * times / 128) ** (1 / 3) - 1
    assert excess == pytest.approx(0, abs=1e-3)
    assert np.log(excess[2] / excess[1]) / np.log(10) == pytest.approx(2 / 3, abs=0.02)
    coarse, fine = breaking_time(30), breaking_time(60)
    assert coarse == pytest.approx(fine, rel=1e-6)
    # Below that of a straight thread as long as half the span, which bears its own weight alone: 2 eta/(rho g L).
    assert 1 < fine < 2
