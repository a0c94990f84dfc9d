"""What lies in one plane, followed in three dimensions: the planar answer, with points at the same heights."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
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
    "power-law": ({"viscosity": 2e4, "index": 0.6}, FLOW),
    "bingham": ({"viscosity": ETA, "yield_stress": LIMIT}, YIELDING),
    "herschel-bulkley": ({"viscosity": 4 * ETA, "yield_stress": LIMIT, "index": 0.6}, YIELDING),
}
SCENES: dict[str, dict[str, Any]] = {
    "clamped strand": {},
    "curled, one end free": {"filament": {"curvature": 4.0, "span": 0.1}, "ends": {"right": "free"}},
    "slope that is drawn": {
        "ends": {"drop": 0.02, "left": "pinned", "motion": [[0.0, 0.0, 0.0], [0.1, 0.01, -0.01]]},
    },
}
COMPARED = ("x", "y", "stretch", "curvature", "tension", "moment", "shear_force")
HEIGHTS = 4


def strand(law: str, scene: str, dimensions: int) -> sc.Scene:
    """A rectangular strand whose section has points at four heights, and in three dimensions four beside each other."""
    material, effects = LAWS[law]
    table: dict[str, Any] = {
        "filament": {"span": 0.2, "thickness": 0.006, "density": 1900.0},
        "material": {"law": law, "poisson": 0.45, "youngs_modulus": E, **material},
        "run": {"duration": 0.2, "frames": 21, "effects": [*EFFECTS, *effects], "dimensions": dimensions},
        "numerics": {"cells": 6, "grading": 1.0, "estimate": False, "rtol": 1e-9, "backend": "compiled"},
    }
    table["material"] = {name: value for name, value in table["material"].items() if value is not None}
    if effects and law != "kelvin-voigt":
        table["numerics"]["fibres"] = HEIGHTS if dimensions == 2 else HEIGHTS**2
    for name, changes in SCENES[scene].items():
        table[name] = {**table.get(name, {}), **changes}
    return sc.Scene.from_dict(table)


@pytest.mark.parametrize("law", LAWS)
def test_planar_scenes_in_three_dimensions(law: str) -> None:
    """To 1e-6 of the largest value of each field, over the whole run."""
    rows, worst = [], 0.0
    for scene in SCENES:
        flat, deep = (sc.simulate(strand(law, scene, dimensions)) for dimensions in (2, 3))
        assert flat.outcome.is_success and deep.outcome.is_success, (flat.summary["message"], deep.summary["message"])
        assert (flat.summary["dimensions"], deep.summary["dimensions"]) == (2, 3)
        whole = flat.data.sizes["cell"] == deep.data.sizes["cell"]
        assert whole or flat.data.sizes["cell"] * 2 == deep.data.sizes["cell"]
        found = []
        for name in COMPARED:
            one, other = flat.data[name].values, deep.data[name].values
            found.append(np.abs(one - other).max() / np.abs(one).max())
        aside = np.abs(deep.data.z.values).max() / np.abs(deep.data.y.values).max()
        rows.append([scene, *(f"{one:.0e}" for one in found), f"{aside:.0e}"])
        worst = max(worst, *found, aside)
    show(f"{law}: largest difference over the largest value", ("scene", *COMPARED, "z/y"), rows)
    assert worst < 1e-6
