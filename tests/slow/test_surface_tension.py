"""Surface tension at length: the bundled ink against an independent solver, and what it is worth in other scenes."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.forecast import forecast
from tests.common.reissner_filament import run as oracle
from tests.common.table import show

pytestmark = pytest.mark.slow

EFFECTS = (
    *("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow"),
    *("yielding", "gravity-ramp", "shear", "fibres", "necking-gradient"),
)
SCENES = (
    *("ink-bridge", "cold-honey", "silicone-thread", "oobleck", "drawn-blob", "hot-glue-string"),
    *("polyethylene-melt", "toothpaste", "transient-gel", "thermoforming-sheet", "putty-arch"),
)


def test_the_bundled_ink_is_that_of_an_independent_solver() -> None:
    """NumPy, RK4 and Newton, its own circle: 16 equal cells, nine fibres, with and without surface tension."""
    # An odd number of fibres is one Gauss rule in both; even ones are in halves here.
    cells, fibres, frames, duration = 16, 9, 6, 0.12
    ink, rows = sc.load_scene("ink-bridge"), []
    span, h, rho, g = ink.filament.span, ink.filament.thickness, ink.filament.density, ink.load.gravity
    E, limit, eta = ink.material.youngs_modulus, ink.material.yield_stress, ink.material.viscosity
    unit = span * (rho / E) ** 0.5
    for gamma in (0.0, 0.072):
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
            "run.effects": [*EFFECTS, *(["surface-tension"] if gamma else [])],
            **{f"numerics.{name}": value for name, value in numerics.items()},
        }
        found = sc.simulate(ink.replace(changes)).data["midpoint"].values[1:]
        exact = expected.midpoint * span
        worst = float(np.max(np.abs(found / exact - 1)))
        rows.append((gamma, f"{-1e6 * found[-1]:.4f}", f"{-1e6 * exact[-1]:.4f}", f"{worst:.0e}"))
        assert worst < 2e-5
    show("Ink, sag [um]", ("gamma [N/m]", "package", "oracle", "largest error"), rows)


def test_what_surface_tension_is_worth_in_the_bundled_scenes() -> None:
    """The share foretold is that of the runs to a factor of 2.5; the energy is closed in all of them."""
    rows = []
    for name in SCENES:
        pulled = sc.simulate(sc.load_scene(name))
        bare = sc.simulate(sc.load_scene(name, {"surroundings.surface_tension": "0 N/m"}))
        sags = [-1e3 * run.summary["midpoint_final_m"] for run in (bare, pulled)]
        taken, foretold = 1 - sags[1] / sags[0], forecast(pulled.scene).capillary
        residual = pulled.summary["energy_residual"]
        rows.append((name, f"{sags[0]:.4g}", f"{sags[1]:.4g}", f"{taken:.3f}", f"{foretold:.3f}", f"{residual:.0e}"))
        # The forecast knows no supports that move.
        assert pulled.scene.ends.motion or taken / 2.5 < foretold < 2.5 * taken, name
        assert residual < max(1e-5, 2 * bare.summary["energy_residual"]), name
        assert name != "ink-bridge" or 27.5e-3 < sags[1] < 28.4e-3
    show("Sag [mm]", ("scene", "without", "with", "taken", "foretold", "energy residual"), rows)
