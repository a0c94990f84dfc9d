"""Units and scales: nothing but the dimensionless groups decides the shape."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.scene.scene import Scene

from .scenes import GEOMETRY, run, scene

RTOL = 1e-6


def asked(*texts: str) -> Scene:
    """A Bingham scene from quantities with their units."""
    span, thickness, density, E, eta, yield_stress, gravity, ramp, duration = texts
    table = {
        "filament": {"span": span, "thickness": thickness, "density": density},
        "material": {"law": "bingham", "youngs_modulus": E, "viscosity": eta, "yield_stress": yield_stress},
        "load": {"gravity": gravity, "ramp": ramp},
        "run": {"duration": duration, "frames": 11},
        "numerics": {"cells": 20},
    }
    return Scene.model_validate(table)


def test_metres_and_millimetres() -> None:
    metres = asked(
        "0.2 m", "0.006 m", "1900 kg/m^3", "4e6 Pa", "14000 Pa*s", "9000 Pa", "9.81 m/s^2", "0.04 s", "0.25 s"
    )
    small = asked("200 mm", "6 mm", "1.9 g/cm^3", "4 MPa", "14 kPa*s", "0.09 bar", "981 cm/s^2", "40 ms", "250 ms")
    one, two = run(metres), run(small)
    assert one.outcome.is_success
    np.testing.assert_allclose(two.data["time"], one.data["time"], rtol=1e-14)
    heights = one.data["midpoint"].values
    apart = np.max(np.abs(two.data["midpoint"].values - heights)) / np.max(np.abs(heights))
    print(f"metres against millimetres: {apart:.0e}")
    assert apart < 1e-12


def fallen(law: str, solver: str, L: float, rho: float, g: float) -> np.ndarray:
    """Midpoint over L of a scene with E* = 500, V = 20, G = 1, delta = 1/32, for 2 sqrt(L/g)."""
    stress, time = rho * g * L, (L / g) ** 0.5
    flow = {"elastic": (), "maxwell": ("viscous-flow",), "bingham": ("viscous-flow", "yielding")}[law]
    asked = scene(
        span=L,
        thickness=L / 32,
        density=rho,
        gravity=g,
        E=500 * stress,
        eta=None if law == "elastic" else 20 * stress * time,
        yield_stress=stress if law == "bingham" else None,
        ramp=0.5 * time,
        duration=2 * time,
        frames=11,
        cells=10,
        rtol=RTOL,
        solver=solver,
        effects=(*GEOMETRY, "gravity-ramp", *flow, *(() if solver == "idas" else ("inertia",))),
    )
    done = run(asked)
    assert done.outcome.is_success
    return done.data["midpoint"].values / L


@pytest.mark.parametrize(
    ("law", "solver"),
    [
        ("elastic", "rosenbrock"),
        ("maxwell", "cvodes"),
        ("maxwell", "idas"),
        ("bingham", "cvodes"),
        ("bingham", "rosenbrock"),
        ("bingham", "idas"),
    ],
)
def test_same_groups_same_shape(law: str, solver: str) -> None:
    """Scales that are powers of two change no digit of BDF; others only what rounding tells the step-size control."""
    reference = fallen(law, solver, 1.0, 1024.0, 1.0)
    binary = [fallen(law, solver, 2.0**-8, 2.0**11, 0.25), fallen(law, solver, 64.0, 512.0, 2.0**-4)]
    decimal = [fallen(law, solver, 3e-3, 2400.0, 9.81)]
    apart = [float(np.max(np.abs(found - reference)) / np.max(np.abs(reference))) for found in (*binary, *decimal)]
    print(f"{law}, {solver}: sag {-reference[-1]:.5f} L, scales apart {', '.join(f'{one:.0e}' for one in apart)}")
    assert max(apart[:2]) == 0
    assert max(apart) < 10 * RTOL
