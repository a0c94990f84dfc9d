"""What lies in one plane, followed in three dimensions: the planar answer, with points at the same heights.

The Gauss points of a rectangle are at the heights of the planar fibres. Those of a circle are on rings: the planar run
is given their heights and weights as its fibres.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.discretization import assembly
from softcat_sym.discretization.section_rule import SectionRule
from softcat_sym.physics.terms import Terms
from tests.common.table import show

pytestmark = pytest.mark.slow

EFFECTS = ["inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear"]
FLOW, YIELDING = ["fibres", "viscous-flow"], ["fibres", "viscous-flow", "yielding"]
E, ETA, LIMIT = 4e6, 1.4e4, 9e3
LAWS: dict[str, tuple[dict[str, Any], list[str]]] = {
    "elastic": ({}, []),
    "kelvin-voigt": ({"viscosity": 1e4}, ["viscous-stress"]),
    "standard-linear": ({"second_modulus": 2e6, "viscosity": 1e5}, FLOW),
    "maxwell": ({"viscosity": 1e5}, FLOW),
    "multimode-maxwell": (
        {
            "youngs_modulus": None,
            "modes": [{"youngs_modulus": 3e6, "viscosity": 1e4}, {"youngs_modulus": 1e6, "viscosity": 1e5}],
        },
        FLOW,
    ),
    "newtonian": ({"youngs_modulus": None, "viscosity": 1e5}, ["viscous-stress"]),
    "custom": (
        {"flow": "sinh(sigma/s0)/t0", "parameters": {"s0": "9 kPa", "t0": "1 s"}},
        FLOW,
    ),
    "power-law": ({"viscosity": 4e4, "index": 0.6}, FLOW),
    "bingham": ({"viscosity": ETA, "yield_stress": LIMIT}, YIELDING),
    "herschel-bulkley": ({"viscosity": 4 * ETA, "yield_stress": LIMIT, "index": 0.6}, YIELDING),
}
SCENES: dict[str, dict[str, Any]] = {
    "clamped strand": {},
    "curled, one end free": {"filament": {"curvature": 4.0, "span": 0.1}, "ends": {"right": "free"}},
    "slope that is drawn": {
        "ends": {
            "drop": 0.02,
            "left": "pinned",
            "right_angle": -float(np.arctan(0.1)),
            "motion": [[0.0, 0.0, 0.0], [0.1, 0.01, -0.01]],
        },
    },
}
COMPARED = ("x", "y", "stretch", "curvature", "tension", "moment", "shear_force")
HEIGHTS, RINGS = 4, 15
"""Heights in a rectangle, with as many points beside each other in three dimensions; points of a circle, 3 x 5."""


def heights_of_points(scene: sc.Scene, terms: Terms) -> SectionRule:
    """Fibres of a planar section where the points in three dimensions are, some of them beside each other."""
    points = assembly.choose_theory(scene, terms).rule
    each = np.eye(points.points)
    return SectionRule(points.Y, points.weight, each, each)


def strand(law: str, section: str, scene: str, dimensions: int) -> sc.Scene:
    """A strand whose section has points at the same heights in the plane and in three dimensions."""
    material, effects = LAWS[law]
    table: dict[str, Any] = {
        "filament": {"span": 0.2, "thickness": 0.006, "section": section, "density": 1900.0},
        "material": {"law": law, "poisson": 0.45, "youngs_modulus": E, **material},
        "run": {"duration": 0.2, "frames": 21, "effects": [*EFFECTS, *effects], "dimensions": dimensions},
        "numerics": {"cells": 6, "grading": 1.0, "estimate": False, "rtol": 1e-9, "backend": "compiled"},
    }
    table["material"] = {name: value for name, value in table["material"].items() if value is not None}
    if "fibres" in effects:
        in_rectangle = HEIGHTS if dimensions == 2 else HEIGHTS**2
        table["numerics"]["fibres"] = RINGS if section == "circle" else in_rectangle
    for name, changes in SCENES[scene].items():
        table[name] = {**table.get(name, {}), **changes}
    if law == "newtonian":
        table["filament"].pop("curvature", None)  # A fluid has no shape of its own
    return sc.Scene.from_dict(table)


@pytest.mark.parametrize("section", ["rectangle", "circle"])
@pytest.mark.parametrize("law", LAWS)
def test_planar_scenes_in_three_dimensions(law: str, section: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """To 1e-6 of the largest value of each field, over the whole run."""
    if section == "circle":
        monkeypatch.setattr(assembly, "choose_rule", heights_of_points)
    rows, worst = [], 0.0
    for scene in SCENES:
        flat, deep = (sc.simulate(strand(law, section, scene, dimensions)) for dimensions in (2, 3))
        assert flat.outcome.is_success and deep.outcome.is_success, (flat.summary["message"], deep.summary["message"])
        assert (flat.summary["dimensions"], deep.summary["dimensions"]) == (2, 3)
        whole = flat.data.sizes["cell"] == deep.data.sizes["cell"]
        assert whole or flat.data.sizes["cell"] * 2 == deep.data.sizes["cell"]
        found = []
        for name in COMPARED:
            one, other = flat.data[name].values, deep.data[name].values
            found.append(np.abs(one - other).max() / np.abs(one).max())
        if "yielding" in LAWS[law][1]:
            assert flat.data.yielded_fraction.max() > 0.5
        aside = np.abs(deep.data.z.values).max() / np.abs(deep.data.y.values).max()
        rows.append([scene, *(f"{one:.0e}" for one in found), f"{aside:.0e}"])
        worst = max(worst, *found, aside)
    show(f"{law}, {section}: largest difference over the largest value", ("scene", *COMPARED, "z/y"), rows)
    assert worst < 1e-6
