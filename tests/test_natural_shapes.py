"""Filaments whose natural shape is an arc, a helix or a polyline: at rest in it, and bent as the elastica says."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_bvp

import softcat_sym as sc
from softcat_sym.discretization.natural_shape import shaped
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import SceneError
from softcat_sym.scene.natural_curve import natural_curve
from tests.common.spatial_statics import Statics

SPAN, THIN, MODULUS, DENSITY = 0.1, 1e-3, 2e6, 1000.0
HEAVY = 5.0  # Gravity that an arch feels [m/s^2]
CURVED = [[0, 0, 0], [0.02, 0.01, 0.01], [0.05, 0, 0.02], [0.08, 0.01, 0], [SPAN, 0, 0]]


def scene_of(shape: Any, **tables: dict[str, Any]) -> sc.Scene:
    """An elastic thread of this shape."""
    table: dict[str, dict[str, Any]] = {
        "filament": {"span": SPAN, "thickness": THIN, "section": "circle", "density": DENSITY, "shape": shape},
        "material": {"law": "elastic", "youngs_modulus": MODULUS},
        "run": {"duration": 0.1, "frames": 3},
        "numerics": {"estimate": False},
    }
    for name, changes in tables.items():
        table[name] = {**table.get(name, {}), **changes}
    return sc.Scene.from_dict(table)


SHAPES = {
    "hanging arc": ("arc", {"rest_length": 0.13}),
    "arch": ("arc", {"curvature": -12.0}),
    "helix": ("helix", {"curvature": 40.0, "twist": -80.0}),
    "polyline": (CURVED, {}),
}


@pytest.mark.parametrize(
    "name", [one if one == "helix" else pytest.param(one, marks=pytest.mark.slow) for one in SHAPES]
)
def test_it_begins_without_stress_with_its_ends_at_the_supports(name: str) -> None:
    shape, filament = SHAPES[name]
    at_rest = Statics(scene_of(shape, filament=filament, load={"gravity": 0.0}, numerics={"cells": 9}))
    shown = at_rest.fields(0.0, at_rest.start, at_rest.p())
    for field in ("tension", "shear_force", "shear_force_3"):
        assert np.abs(shown[field]).max() < 1e-9 * MODULUS, field
    for field in ("torque", "moment", "moment_2"):
        assert np.abs(shown[field]).max() < 1e-8 * MODULUS * THIN, field
    last = [float(shown[axis][-1] - shown[axis][0]) for axis in "xyz"]
    assert last == pytest.approx([SPAN, 0, 0], abs=1e-14)
    if name in ("hanging arc", "arch"):
        assert np.sign(shown["y"][9]) == (-1 if name == "hanging arc" else 1)
        assert np.abs(shown["z"]).max() < 1e-15


def test_nodes_are_on_the_curve_but_for_the_square_of_a_cell() -> None:
    for shape, filament in SHAPES.values():
        scene = scene_of(shape, filament=filament)
        curve = natural_curve(scene)
        missed = []
        for cells in (60, 120):
            nodes = np.linspace(-0.5, 0.5, cells + 1)
            places, turns, _ = shaped(scene, nodes)
            assert np.abs(np.linalg.norm(turns, axis=1) - 1).max() < 1e-14
            assert places[-1] * curve.length == pytest.approx([SPAN, 0, 0], abs=1e-13)
            missed.append(np.abs(places * curve.length - curve.places((nodes + 0.5) * curve.length)).max())
        assert missed[0] / missed[1] == pytest.approx(4, rel=0.15)


@pytest.mark.slow
def test_an_arc_with_a_free_end_is_a_curved_filament() -> None:
    kappa, length = 12.0, 2 / 12 * math.asin(12 * SPAN / 2)
    free: dict[str, Any] = {"ends": {"right": "free"}, "numerics": {"cells": 5}}
    one = Statics(scene_of("arc", **free, filament={"curvature": kappa}))
    other = Statics(
        scene_of(
            "straight",
            filament={"curvature": kappa, "span": length},
            ends={"right": "free", "left_angle": -kappa * length / 2},
            numerics={"cells": 5},
        )
    )
    first, second = (at.fields(0.0, at.start, at.p()) for at in (one, other))
    for axis in "xy":
        found, known = (shown[axis] - shown[axis][0] for shown in (first, second))
        assert found == pytest.approx(known, abs=1e-3 * length)  # The chain ends on the chord, that one beside it
    assert np.ptp(first["y"]) > 0.05 * length


def elastica(curvature: float, length: float) -> Floats:
    """Middle of a clamped arch under its weight, in forces over EI: M' = H sin - V cos; it shortens by T/EA."""
    weight = DENSITY * HEAVY / (MODULUS * THIN**2 / 16)

    def slope(s: Floats, y: Floats) -> Floats:
        theta, M, H, V = y[2:]
        bent = curvature + M
        c, s = np.cos(theta), np.sin(theta)
        stretch = 1 + THIN**2 / 16 * (H * c + V * s)
        return np.vstack([stretch * c, stretch * s, bent, stretch * (H * s - V * c), 0 * H, weight + 0 * V])

    turned = curvature * length / 2

    def ends(first: Floats, last: Floats) -> Floats:
        return np.array([first[0], first[1], first[2] + turned, last[0] - SPAN, last[1], last[2] - turned])

    s = np.linspace(0, length, 101)
    theta = curvature * (s - length / 2)
    x, y = (np.append(0, np.cumsum((f[1:] + f[:-1]) / 2 * np.diff(s))) for f in (np.cos(theta), np.sin(theta)))
    found = solve_bvp(
        slope, ends, s, np.vstack([x, y, theta, 0 * s, 0 * s, weight * (s - length / 2)]), tol=1e-6, max_nodes=20000
    )
    assert found.success
    return np.asarray(found.sol(length / 2)[:2])


@pytest.mark.slow
def test_an_arch_sags_as_the_elastica_does() -> None:
    curvature, sags = -12.0, []
    for cells in (12, 24):
        scene = scene_of("arc", filament={"curvature": curvature}, load={"gravity": HEAVY}, numerics={"cells": cells})
        arch, length = Statics(scene), natural_curve(scene).length
        unloaded = shaped(scene, arch.graph.grid.nodes)[0][cells, 1] * length
        sags.append(unloaded - float(arch.fields(0.0, arch.start, arch.p())["y"][cells]))
    known = natural_curve(scene).places(np.array([length / 2]))[0, 1] - elastica(curvature, length)[1]
    # Of the second order; what is left is shear.
    assert sags[1] == pytest.approx(known, rel=0.02)
    assert sags[1] + (sags[1] - sags[0]) / 3 == pytest.approx(known, rel=4e-3)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "the file holds no data"),
        ("x_m,z_m\n0,0\n", "line 1: no column y"),
        ("x_m,y_m,z_m\n0,0,0\n0.05,,0\n", "line 3: not a number"),
    ],
)
def test_a_bad_file_is_one_fault_with_its_line(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "curve.csv").write_text(text)
    with pytest.raises(
        SceneError, match=f"scene: 1 fault\n  filament.shape: 'curve.csv': {said}.*; accepted: straight"
    ):
        scene_of(str(tmp_path / "curve.csv"))


BAD: dict[str, tuple[Any, dict[str, Any], str]] = {
    "an unknown word": ("arch", {}, "filament.shape: 'arch' is neither"),
    "no such file": ("nowhere.csv", {}, "filament.shape: .*no such file"),
    "three points": ([[0, 0, 0], [0.05, 0.01, 0], [SPAN, 0, 0]], {}, "filament.shape: a polyline of 3 points"),
    "twice the same": ([*CURVED[:2], *CURVED[1:]], {}, "filament.shape: .*two neighbouring points"),
    "beside its support": ([*CURVED[:-1], [0.2, 0, 0]], {}, "filament.shape: a right end at"),
    "an arc of nothing": ("arc", {}, "filament.shape: 'arc', but nothing says how much"),
    "an arc of both": ("arc", {"filament": {"curvature": 2.0, "rest_length": 0.2}}, "filament.shape: 'arc', with a"),
    "a short arc": ("arc", {"filament": {"rest_length": 0.09}}, "filament.rest_length: 0.09 m, no longer"),
    "a small circle": ("arc", {"filament": {"curvature": 25.0}}, "filament.curvature: 25.0 1/m, of a circle"),
    "a twisted arc": ("arc", {"filament": {"curvature": 2.0, "twist": 1.0}}, "filament.twist: given"),
    "a flat helix": ("helix", {"filament": {"curvature": 100.0}}, "filament.shape: 'helix' without twist"),
    "a turned clamp": ("arc", {"filament": {"curvature": 2.0}, "ends": {"left_angle": 0.1}}, "ends.left_angle: given"),
    "a fluid": (CURVED, {"material": {"law": "newtonian", "viscosity": 1.0}}, "filament.shape: .*a fluid"),
    "a stretch": (CURVED, {"initial": {"stretch": 1.1}}, "initial.stretch: given"),
    "in the plane": (CURVED, {"run": {"dimensions": 2}}, "run.dimensions: 2, but filament.shape"),
}


@pytest.mark.parametrize("what", BAD)
def test_what_is_no_shape_is_refused(what: str) -> None:
    shape, tables, said = BAD[what]
    if what == "a fluid":
        tables = {"material": {**tables["material"], "youngs_modulus": None}}
    with pytest.raises(SceneError, match=said):
        scene_of(shape, **tables)
