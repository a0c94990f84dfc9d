"""Surface tension at length: the bundled ink against an independent solver."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.reissner_filament import run as oracle

pytestmark = pytest.mark.slow

EFFECTS = (
    *("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow"),
    *("yielding", "gravity-ramp", "shear", "fibres", "necking-gradient", "surface-tension"),
)


def test_the_bundled_ink_is_that_of_an_independent_solver() -> None:
    """NumPy, RK4 and Newton, its own circle: 16 equal cells, nine fibres."""
    # An odd number of fibres is one Gauss rule in both; even ones are in halves here.
    cells, fibres, frames, duration = 16, 9, 6, 0.12
    ink, gamma = sc.load_scene("ink-bridge"), 0.072
    span, h, rho, g = ink.filament.span, ink.filament.thickness, ink.filament.density, ink.load.gravity
    E, limit, eta = ink.material.youngs_modulus, ink.material.yield_stress, ink.material.viscosity
    unit = span * (rho / E) ** 0.5
    expected = oracle(
        h / span,
        rho * g * span / limit,
        eta / (rho * (g * span**3) ** 0.5),
        cells,
        fibres=fibres,
        duration=duration / unit,
        ramp=ink.load.ramp / unit,
        times=tuple(np.linspace(0, duration / unit, frames)[1:]),
        beta=1 / 32,
        kappa_s=0.9,
        surface=2 * gamma / h / E,
        circle=True,
        stiffness=E / (rho * g * span),
    )
    numerics = {"cells": cells, "grading": 1.0, "fibres": fibres, "rtol": 1e-7, "estimate": False}
    changes = {
        "surroundings.surface_tension": f"{gamma} N/m",
        "run.duration": f"{duration} s",
        "run.frames": frames,
        "run.effects": EFFECTS,
        **{f"numerics.{name}": value for name, value in numerics.items()},
    }
    found = sc.simulate(ink.replace(changes)).data["midpoint"].values[1:]
    np.testing.assert_allclose(found, expected.midpoint * span, rtol=2e-5)
