"""Ends of every kind against exact curves: elasticas, catenaries, beams of varying section."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from tests.common import curves
from tests.common.rheology import GEOMETRY, STRING, Array, limit_of, scene, solved
from tests.common.table import show

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


def slightly_turned_clamps() -> Compared:
    """y = -a x (1 - x/L): no force, a constant moment."""
    angle, X = 1e-3, points(1.0)
    ends = {"left_angle": -angle, "right_angle": angle}
    return shape([X, -angle * X * (1 - X)], 1e9, {"thickness": 0.05}, GEOMETRY, ends, gravity=0.0)


Cases = Mapping[str, tuple[Callable[[], Compared], float]]
"""By name: a shape, and the tolerance of its limit."""

SHAPES: Cases = {
    "cantilever, w L^3/EI = 12": (partial(heavy_elastica, 12.0, 0.0), 2e-4),
    "natural curvature 1.5/m": (natural_curvature, 1e-5),
    "catenary, drop 0.3 m": (partial(catenary, 0.3), 5e-5),
    "elastic catenary, E* = 3, linear": (partial(elastic_catenary, ("large-rotation",), 3.0), 2e-5),
    "elastic catenary, E* = 3, true strain": (partial(elastic_catenary, STRING, 3.0), 2e-5),
    "clamps at -0.6 and 0.6": (arc_between_turned_clamps, 2e-4),
    "clamps at -0.2 and 0.1, drop 0.1 m": (partial(turned_clamps, -0.2, 0.1, 0.1), 5e-4),
    "clamps at -1e-3 and 1e-3": (slightly_turned_clamps, 2e-3),
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
    """Print and compare, in parts of the largest excursion from the straight line between the ends or along x."""
    rows, missed = [], []
    for name, (case, tolerance) in cases.items():
        exact, *found = case()
        size = max(float(np.ptp(exact[-1])), 1e-9)
        errors = [float(np.max(np.abs(one - exact))) / size for one in found]
        rows.append([name, f"{size:.6f}", *(f"{error:.1e}" for error in errors)])
        if not (errors[0] < fine and errors[1] < tolerance):
            missed.append(name)
    show("shapes of elastic filaments", ("", "depth [m]", "N = 40", "without a grid"), rows)
    assert not missed


def test_filaments_hang_as_the_exact_curves() -> None:
    judge(SHAPES, 1e-2)


def test_varying_section_is_the_beam() -> None:
    judge(BEAMS, 5e-3)
