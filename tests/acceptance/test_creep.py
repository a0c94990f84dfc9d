"""Kelvin-Voigt and standard linear filaments creep, and come to rest in the elastic shape of their lasting modulus."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.common import curves

from .rheology import GEOMETRY, Array, flow_of, limit_of, scene, solved
from .table import show

LAWS = ("kelvin-voigt", "standard-linear")
ARM = 3.0
"""Second modulus over the lasting one."""
STRESS = 1e4
"""rho g L [Pa]."""


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


@pytest.mark.parametrize("law", LAWS)
def test_a_linear_beam_creeps_as_its_material(law: str) -> None:
    """Midpoint rho g L^4 J(t)/(32 h^2), by the correspondence of linear viscoelasticity and elasticity."""
    thickness, static = 0.02, 2e-5
    E = STRESS / (32 * thickness**2 * static)
    histories = []
    for cells in (10, 20):
        asked = scene(
            solid(law, E, 0.2),
            {"thickness": thickness},
            effects=(*GEOMETRY, *flow_of(law)),
            run={"frames": 11},
            cells=cells,
            rtol=1e-7,
        )
        data = solved(asked)
        histories.append(-data["midpoint"].values / static)
    part = data["time"].values / 0.2
    found, expected = limit_of(*histories), compliance(law, part)
    rows = [[f"{t:.1f}", f"{a:.6f}", f"{b:.6f}"] for t, a, b in zip(part, found, expected, strict=True)][::2]
    show(f"{law} beam, sag over its static one", ("t/retardation", "found", "exact"), rows)
    np.testing.assert_allclose(found, expected, atol=2e-4)


def test_a_soft_filament_comes_to_rest_in_its_elastic_shape() -> None:
    """The whole static theory between clamps, by a boundary-value solver; 30 retardation times."""
    for law in LAWS:
        for E_star in [10.0, 300.0]:
            thickness = 0.05
            area = thickness**2
            shapes = []
            for cells in (20, 40):
                asked = scene(
                    solid(law, E_star * STRESS, 1 / 30),
                    {"thickness": thickness},
                    effects=(*GEOMETRY, *flow_of(law)),
                    run={"frames": 31},
                    cells=cells,
                )
                data = solved(asked)
                shapes.append(np.array([data["x"].values[-1], data["y"].values[-1]])[:, :: cells // 20])
            section = curves.uniform(E_star * STRESS * area, E_star * STRESS * area * thickness**2 / 12)
            X = np.linspace(0, 1, 41)
            clamp = ("clamped", 0.0)
            exact = curves.held(section, STRESS * area, 1.0, 1.0, X, clamp, clamp)
            found = limit_of(*shapes)
            sag = -float(exact.y[20])
            error = float(np.max(np.abs(found - [exact.x - 0.5, exact.y]))) / sag
            fine = abs(float(shapes[1][1].min()) + sag) / sag
            show(
                f"{law} at E* = {E_star:g}",
                ("static sag", "N = 40, error of the sag", "shape, extrapolated"),
                [[f"{sag:.6f} L", f"{fine:.1e}", f"{error:.1e}"]],
            )
            assert fine < 5e-3
            assert error < 5e-4
