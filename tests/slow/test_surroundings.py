"""Tables of what surrounds a filament, against closed forms: ring-down, terminal velocity, a beam that creeps down."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.draws import deviations, draws, errors_away
from tests.common.table import show
from tests.test_surroundings import RHO, H, L, rings, slender, strand

pytestmark = pytest.mark.slow


def test_ring_down_of_a_beam_in_its_bath() -> None:
    """Decay and frequency over those of theory, of a beam interpreted and of a sheared filament in C."""
    rows = []
    sheared = ("extensibility", "finite-stretch", "thinning", "large-rotation", "shear")
    for kinds, backend in (((), "interpreted"), (sheared, "compiled")):
        for viscosity, density in ((0.005, 0.0), (0.0, 1000.0), (0.005, 1000.0)):
            effects = (*kinds, *(["drag"] if viscosity else []), *(["added-mass"] if density else []))
            found = rings(viscosity, density, effects, 40, backend)
            rows.append([len(kinds), viscosity, density, backend, *found])
            assert found[0] == pytest.approx(1 if viscosity else 0, abs=3e-3), rows[-1]
            assert found[1] == pytest.approx(1, abs=1.5e-3), rows[-1]
            assert found[2] < 1e-4, rows[-1]
    show("ring-down", ("effects", "mu_b", "rho_b", "backend", "decay", "frequency", "energy residual"), rows)


def test_a_pinned_beam_creeps_down_in_a_viscous_bath() -> None:
    """Zeta y_t + E I y_xxxx = -q: y(L/2) = -sum 4 q/(n pi E I k^4) sin(n pi/2) (1 - exp(-E I k^4 t/zeta)), n odd."""
    viscosity, gravity, h = 5000.0, 0.1, 10 * H  # Of a thin one, axial forces of rounding are seen in the velocities
    area, stiffness = math.pi * h**2 / 4, 10e6 * math.pi * h**4 / 64
    zeta, load = slender(viscosity, h)[1], RHO * area * gravity
    n = np.arange(1, 60, 2)
    k = n * math.pi / L
    duration = 3 * zeta / (stiffness * (math.pi / L) ** 4)
    rows = []
    for model in ("filament", "small-deflection"):
        errors = []
        for cells in (10, 20, 40):
            scene = strand(
                {"viscosity": f"{viscosity} Pa*s"},
                model=model,
                filament={"span": f"{L} m", "diameter": f"{h} m", "density": f"{RHO} kg/m^3"},
                ends={"left": "pinned", "right": "pinned"},
                load={"gravity": f"{gravity} m/s^2"},
                run={"duration": f"{duration} s", "frames": 31, "effects": ["bending", "drag"]},
                numerics={"rtol": 1e-7, "estimate": False, "cells": cells, "grading": 1.0},
            )
            run = sc.simulate(scene)
            time = run.data.time.values[:, None]
            series = 4 * load / (n * math.pi * stiffness * k**4) * np.sin(n * math.pi / 2)
            exact = np.sum(series * -np.expm1(-stiffness * k**4 * time / zeta), axis=1)
            ratio = -run.data.midpoint.values[10:] / exact[10:]
            errors.append(float(np.max(np.abs(ratio - 1))))
            rows.append([model, cells, errors[-1], run.summary["energy_residual"]])
            assert run.summary["energy_residual"] < 1e-5
        order = math.log2(errors[0] / errors[1])
        assert order == pytest.approx(2, abs=0.15), errors
        assert errors[-1] < 1e-3
    show("creeping beam", ("model", "cells", "largest error", "energy residual"), rows)


@pytest.mark.statistical
def test_a_fit_reads_the_bath_off_a_film(tmp_path: Path) -> None:
    """Density and viscosity of the bath, from a ringing strand with half a percent of noise."""
    truth = {"bath_viscosity": 0.02, "bath_density": 900.0}
    scene = _in_a_bath(*truth.values())
    run = sc.simulate(scene)
    noise = draws(3).normal(0, 5e-3 * run.summary["midpoint_largest_m"], 81)
    film = np.column_stack([run.data.time, run.data.midpoint + noise])
    np.savetxt(tmp_path / "film.csv", film, delimiter=",", header="time_s,midpoint_m", comments="")
    guess = scene.replace({"surroundings.viscosity": "60 mPa*s", "surroundings.density": "850 kg/m^3"})
    fit = sc.fit(
        tmp_path / "film.csv", guess, ["surroundings.viscosity", "surroundings.density"], profiles=False, starts=1
    )
    rows = [[name, fit.parameters[name].value, fit.parameters[name].std, exact] for name, exact in truth.items()]
    show("fit of a bath", ("constant", "found", "error bar", "truth"), rows)
    # The fit's standard errors are those of the linear theory, from differences between runs, to what 81 readings tell
    # of their noise: 3.1 % of the viscosity, and 1.3 % where no camera is allowed for, whose scale looks like it.
    midpoint, (mu, rho) = run.data.midpoint.values, truth.values()
    columns = [
        (_seen(1.02 * mu, rho) - _seen(0.98 * mu, rho)) / 0.04,
        (_seen(mu, 1.005 * rho) - _seen(mu, 0.995 * rho)) / 0.01,
        *(midpoint, np.ones(81), np.gradient(midpoint, run.data.time.values)),
    ]
    known = np.array([math.inf, math.inf, *(prior for _, _, prior in fit.camera.values())])
    std = 5e-3 * run.summary["midpoint_largest_m"]
    slopes = np.stack(columns, axis=1)[1:] / std
    errors = np.sqrt(np.diag(np.linalg.inv(slopes.T @ slopes + np.diag(known**-2))))
    low, high = deviations(78)
    for (name, found, error, exact), told in zip(rows, errors[:2], strict=True):
        assert abs(found - exact) < errors_away(78) * error, name
        # A tenth for what is not linear between the fit's constants and the true ones.
        assert 0.9 * low < error / (exact * told) < 1.1 * high, name


def _in_a_bath(viscosity: float, density: float) -> sc.Scene:
    """A strand that rings in a bath."""
    return strand(
        {"viscosity": f"{viscosity!r} Pa*s", "density": f"{density!r} kg/m^3"},
        material={"law": "kelvin-voigt", "youngs_modulus": "1 MPa", "viscosity": "500 Pa*s"},
        run={"duration": "3 s", "frames": 81, "accuracy": 1e-3},
    )


def _seen(viscosity: float, density: float) -> np.ndarray:
    fine = {"numerics.cells": 40, "numerics.rtol": 1e-6, "numerics.estimate": False}
    return sc.simulate(_in_a_bath(viscosity, density).replace(fine)).data.midpoint.values
