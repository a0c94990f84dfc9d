"""Ends of every kind against exact curves: elasticas, catenaries, beams of varying section."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from tests.common import curves
from tests.common.rheology import GEOMETRY, STRING, Array, flow_of, limit_of, scene, solved
from tests.common.viscous_string import breaking_time, viscous_string

STRESS = 1e4
"""rho g times 1 m [Pa]."""
PINS = {"left": "pinned", "right": "pinned"}
CANTILEVER = {"left": "clamped", "right": "free"}
GRIDS = (20, 40)
TAPER = (1.0, 0.8, 0.6, 0.5, 0.5)
BULGE = (0.6, 1.0, 1.4, 1.0, 0.6)

Compared = tuple[Array, Array, Array]
"""The exact shape, that on forty cells, and that extrapolated from two grids: x and y, or y alone."""


def points(length: float) -> Array:
    return np.linspace(0, length, 2 * GRIDS[0] + 1)


def shape(
    exact: Any,
    E: float,
    filament: Mapping[str, Any],
    effects: tuple[str, ...],
    ends: Mapping[str, Any],
    gravity: float = 10.0,
) -> Compared:
    """Static shape of an elastic filament from its left support, on the nodes of the coarser of two grids."""
    found = []
    for cells in GRIDS:
        material = {"law": "elastic", "youngs_modulus": E}
        data = solved(scene(material, filament, effects=effects, ends=ends, load={"gravity": gravity}, cells=cells))
        place = np.array([data["x"].values[-1], data["y"].values[-1]])[:, :: cells // GRIDS[0]]
        found.append(place - place[:, :1])
    return np.array(exact), found[1], limit_of(*found)


def heavy_elastica(load: float, angle: float) -> Compared:
    """A cantilever of w L^3/EI = load; the oracle stretches and thins as the filament does."""
    thickness = 0.01
    E = 12 * STRESS / (load * thickness**2)
    section = curves.uniform(E * thickness**2, E * thickness**4 / 12)
    exact = curves.held(section, STRESS * thickness**2, 1.0, 0.0, points(1.0), ("clamped", angle), ("free", 0.0))
    return shape([exact.x, exact.y], E, {"thickness": thickness}, GEOMETRY, {**CANTILEVER, "left_angle": angle})


def natural_curvature() -> Compared:
    """An unloaded cantilever is an arc."""
    curvature, X = 1.5, points(1.0)
    exact = np.array([np.sin(curvature * X), 1 - np.cos(curvature * X)]) / curvature
    return shape(exact, 1e9, {"thickness": 0.01, "curvature": curvature}, GEOMETRY, CANTILEVER, gravity=0.0)


def catenary(drop: float) -> Compared:
    """Thin, pinned, inextensible to 1e-5: no bending at all."""
    length = 1.3
    exact = curves.catenary(1.0, drop, length).at(points(length))
    filament = {"thickness": 0.01, "rest_length": length}
    return shape(exact, 1e5 * STRESS, filament, ("large-rotation",), {**PINS, "drop": drop})


def elastic_catenary(
    effects: tuple[str, ...], E_star: float, length: float = 1.2, drop: float = 0.2, thickness: float = 0.01
) -> Compared:
    """Irvine's with T = EA (s - 1), and that of constant volume with T = EA log(s)/s."""
    stretch = (curves.linear_stretch if len(effects) == 1 else curves.true_strain_stretch)(E_star)
    exact = curves.hanging_string(stretch, 1.0, length, 1.0, points(length), drop=drop)
    filament = {"thickness": thickness, "rest_length": length}
    return shape([exact.x, exact.y], E_star * STRESS, filament, effects, {**PINS, "drop": drop})


def varying_section(section: str, profile: tuple[float, ...], left: str, right: str) -> Compared:
    """A0 ~ p and I0 ~ p^3 of a rectangle of fixed width, p^2 and p^4 of a circle; linear beam, sag of 1e-3 h."""
    thickness, sag, X = 0.02, 2e-5, points(1.0)
    power, gyration = (1, 1 / 12) if section == "rectangle" else (2, 1 / 16)

    def relative(X: Array) -> Array:
        return np.interp(X, np.linspace(0, 1, len(profile)), profile)

    unit = curves.linear_beam(
        lambda at: gyration * thickness**2 * relative(at) ** (power + 2),
        lambda at: relative(at) ** power,
        1.0,
        X,
        (left, 0.0),
        (right, 0.0),
    )
    E = STRESS * float(-unit.min()) / sag
    filament = {"thickness": thickness, "section": section, "profile": list(profile)}
    exact, fine, limit = shape([X, STRESS / E * unit], E, filament, GEOMETRY, {"left": left, "right": right})
    return exact[1:], fine[1:], limit[1:]


def arc_between_turned_clamps() -> Compared:
    """Length a/sin(a) times the span: a circular arc without any force; a weight too small to be felt."""
    angle = 0.6
    length = angle / np.sin(angle)
    radius, X = length / (2 * angle), points(length)
    exact = radius * np.array([np.sin(X / radius - angle) + np.sin(angle), np.cos(angle) - np.cos(X / radius - angle)])
    ends = {"left_angle": -angle, "right_angle": angle}
    return shape(exact, 1e9, {"thickness": 0.005, "rest_length": length}, GEOMETRY, ends, gravity=1e-6)


def turned_clamps(left: float, right: float, drop: float) -> Compared:
    """Against the boundary-value solver, at a stiffness where weight, angles and stretching all matter."""
    thickness, E_star = 0.05, 100.0
    area, length = thickness**2, float(np.hypot(1.0, drop))
    section = curves.uniform(E_star * STRESS * area, E_star * STRESS * area * thickness**2 / 12)
    clamps = ("clamped", left), ("clamped", right)
    exact = curves.held(section, STRESS * area, length, 1.0, points(length), *clamps, drop=drop)
    ends = {"left_angle": left, "right_angle": right, "drop": drop}
    return shape([exact.x, exact.y], E_star * STRESS, {"thickness": thickness}, GEOMETRY, ends)


Cases = Mapping[str, tuple[Callable[[], Compared], float]]
"""By name: a shape, and the tolerance of its limit."""

SHAPES: Cases = {
    "elastic catenary, E* = 3, true strain": (partial(elastic_catenary, STRING, 3.0), 2e-5),
    "clamps at -0.2 and 0.1, drop 0.1 m": (partial(turned_clamps, -0.2, 0.1, 0.1), 5e-4),
}
BEAMS: Cases = {
    f"{section}, {name}": (partial(varying_section, section, profile, *ends), 5e-4)
    for section in ("rectangle", "circle")
    for name, profile, ends in (
        ("tapered cantilever", TAPER, ("clamped", "free")),
        ("tapered, clamped", TAPER, ("clamped", "clamped")),
        ("bulging, clamped and pinned", BULGE, ("clamped", "pinned")),
    )
}


def judge(cases: Cases, fine: float) -> None:
    """Compare, in parts of the largest excursion from the straight line between the ends or along x."""
    missed = []
    for name, (case, tolerance) in cases.items():
        exact, *found = case()
        size = max(float(np.ptp(exact[-1])), 1e-9)
        errors = [float(np.max(np.abs(one - exact))) / size for one in found]
        if not (errors[0] < fine and errors[1] < tolerance):
            missed.append((name, errors))
    assert not missed


def test_filaments_hang_as_the_exact_curves() -> None:
    judge(SHAPES, 1e-2)


def test_varying_section_is_the_beam() -> None:
    judge(BEAMS, 5e-3)


# Histories of creep: beams by correspondence, strings of power-law and viscous fluids.
STRESS_CREEP = 1e4
"""rho g L [Pa], L = 1 m."""
LAWS, ARM = ("kelvin-voigt", "standard-linear"), 3.0
"""Solids that creep; second modulus over the lasting one."""
PULL = STRESS_CREEP / 8
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
    thickness, static = 0.02, 2e-05
    E = STRESS_CREEP / (32 * thickness**2 * static)
    for law in LAWS:
        asked = {"effects": (*GEOMETRY, *flow_of(law)), "run": {"frames": 11}, "rtol": 1e-7}
        material, filament = solid(law, E, 0.2), {"thickness": thickness}
        runs = [solved(scene(material, filament, cells=cells, **asked)) for cells in (10, 20)]
        found = limit_of(*(-data["midpoint"].values / static for data in runs))
        part = runs[0]["time"].values / 0.2
        expected = compliance(law, part)
        np.testing.assert_allclose(found, expected, atol=2e-4)


def test_a_soft_filament_comes_to_rest_in_its_elastic_shape() -> None:
    """The whole static theory between clamps, by a boundary-value solver; 30 retardation times."""
    thickness, X, clamp = 0.05, np.linspace(0, 1, 41), ("clamped", 0.0)
    area = thickness**2
    for E_star in (10.0, 300.0):
        E = E_star * STRESS_CREEP
        section = curves.uniform(E * area, E * area * thickness**2 / 12)
        exact = curves.held(section, STRESS_CREEP * area, 1.0, 1.0, X, clamp, clamp)
        sag = -float(exact.y[20])
        for law in LAWS:
            shapes = []
            asked = {"effects": (*GEOMETRY, *flow_of(law)), "run": {"frames": 31}}
            for cells in (20, 40):
                data = solved(scene(solid(law, E, 1 / 30), {"thickness": thickness}, cells=cells, **asked))
                shapes.append(np.array([data["x"].values[-1], data["y"].values[-1]])[:, :: cells // 20])
            error = float(np.max(np.abs(limit_of(*shapes) - [exact.x - 0.5, exact.y]))) / sag
            fine = abs(float(shapes[1][1].min()) + sag) / sag
            assert fine < 5e-3 and error < 5e-4, (law, E_star, sag, fine, error)


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

    start = (3 * STRESS_CREEP / (64 * E)) ** (1 / 3)
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
    for index in INDICES:
        time, found = power_law_string(index, 1e5 * STRESS_CREEP, 11)
        error = found / power_law_sag(time, index, 1e5 * STRESS_CREEP) - 1
        assert np.max(np.abs(error)) < 1e-5


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
