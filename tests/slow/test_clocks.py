"""Tables of materials that change while the filament hangs: exact bars, limits and their orders, the audit."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

import softcat_sym as sc
from tests.common.table import show
from tests.test_clocks import BACKENDS, HANGING, scene

pytestmark = pytest.mark.slow

LENGTH, WEIGHT = 0.1, 2000.0 * 9.81  # [m], [N/m^3]
SMALL = ["bending", "extensibility", "large-rotation", "viscous-flow", "curing"]


def hung(material: dict[str, Any], effects: list[str], backend: str, **run: Any) -> sc.Run:
    """A bar that hangs straight down from its upper end."""
    filament = {"span": LENGTH, "thickness": 0.002, "density": 2000.0}
    ends = {"left": "clamped", "right": "free", "left_angle": -math.pi / 2}
    run = {"effects": effects, "accuracy": 1e-5, **run}
    numerics = {"backend": backend, "cells": 40, "grading": 1.0}
    given = scene(material, filament=filament, ends=ends, load={"gravity": 9.81}, run=run, numerics=numerics)
    return sc.simulate(given)


def test_a_bar_whose_yield_stress_grows_stops() -> None:
    """At t = (rho g L - s_0)/r nothing flows; by then the bar is longer by (rho g L - s_0)^3/(6 r eta rho g)."""
    young, viscosity, start, rate = 1e7, 1e5, 800.0, 500.0
    # Of the uppermost of 80 cells, whose middle carries less than the support.
    stops = (WEIGHT * LENGTH * (1 - 1 / 160) - start) / rate
    law = {"law": "bingham", "youngs_modulus": young, "viscosity": viscosity}
    law["yield_stress"] = f"{start!r} Pa + {rate!r} Pa/s*t"
    rows = []
    for finite in (False, True):
        names = [*SMALL, "yielding", *(["finite-stretch", "thinning"] if finite else [])]

        def stretch(place: float, finite: bool = finite) -> float:
            """Strain at the end of the section that carries what hangs below it; written without the package."""

            def sigma(strain: float) -> float:
                carried = WEIGHT * (LENGTH - place)
                elongated = strain
                for _ in range(50 if finite else 0):
                    elongated = carried * math.exp(elongated) / young + strain
                return carried * (math.exp(elongated) if finite else 1.0)

            def flow(time: float, strain: list[float]) -> list[float]:
                return [max(0.0, sigma(strain[0]) - start - rate * time) / viscosity]

            end = 1.2 * stops
            strain = solve_ivp(flow, (0, end), [0.0], rtol=1e-9, atol=1e-13, max_step=end / 200).y[0, -1]
            whole = strain + sigma(strain) / young
            return math.exp(whole) - 1 if finite else whole

        exact = quad(stretch, 0, LENGTH, limit=200, epsabs=1e-10)[0]
        closed = (WEIGHT * LENGTH - start) ** 3 / (6 * rate * viscosity * WEIGHT) + WEIGHT * LENGTH**2 / (2 * young)
        if not finite:
            assert exact == pytest.approx(closed, rel=1e-6)
        for backend in BACKENDS:
            run = hung(law, names, backend, duration=1.2 * stops, frames=241)
            longer = -float(run.data["y"][-1, -1]) - LENGTH
            flows = run.data["plastic_rate"].values.max(axis=1) > 1e-9
            stopped = float(run.data["time"][np.flatnonzero(flows)[-1] + 1])
            first = run.data["time"].values[1]
            rows.append([finite, backend, f"{longer * 1e6:.3f}", f"{exact * 1e6:.3f}", f"{longer / exact - 1:.1e}"])
            rows[-1] += [f"{stopped:.3f}", f"{stops:.3f}", f"{run.summary['energy_residual']:.1e}"]
            assert longer == pytest.approx(exact, rel=5e-4), rows[-1]
            # Where it thins its stress is larger by the stretch: it stops that much later.
            assert stopped == pytest.approx(stops, abs=2 * first + finite * 0.02 * stops), rows[-1]
            assert run.summary["regime"] == "arrested-overdamped"
    header = ["finite", "backend", "longer [um]", "exact", "error", "stops [s]", "exact", "energy residual"]
    show("a hanging bar whose yield stress grows", header, rows)


def test_a_bar_whose_viscosity_grows_exponentially_creeps() -> None:
    """Of eta_0 exp(t/tau): longer by rho g L^2/2 (1/E + tau/eta_0 (1 - exp(-t/tau)))."""
    young, viscosity, tau = 1e6, 1e4, 0.7
    law = {"law": "maxwell", "youngs_modulus": young, "viscosity": f"{viscosity!r} Pa*s*exp(t/{tau!r} s)"}
    rows = []
    for backend in BACKENDS:
        run = hung(law, SMALL, backend, duration=3.0, frames=31)
        time = run.data["time"].values
        exact = WEIGHT * LENGTH**2 / 2 * (1 / young - tau / viscosity * np.expm1(-time / tau))
        error = float(np.max(np.abs((-run.data["y"].values[:, -1] - LENGTH) / exact - 1)))
        rows.append([backend, f"{error:.1e}", f"{run.summary['energy_residual']:.1e}"])
        assert error < 1e-4
    show("Maxwell creep of a viscosity that grows", ["backend", "largest error", "energy residual"], rows)


def test_the_limits_of_a_history() -> None:
    """A history that does not change is none to 1e-12; one that changes slowly leaves it at first order in its rate."""
    material, given = HANGING["bingham"], {"filament": {"thickness": 0.006, "density": 1900.0}}
    given |= {
        "load": {"gravity": 9.81},
        "numerics": {"backend": "compiled", "cells": 16, "estimate": False, "rtol": 1e-9},
    }
    names = ["inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation"]
    names += ["viscous-flow", "yielding"]

    def last(changes: dict[str, Any], *more: str) -> float:
        run = sc.simulate(scene({**material, **changes}, run={"effects": [*names, *more]}, **given))
        return float(run.data["midpoint"][-1])

    rows, plain = [], last({})
    for name, of_rate in (
        ("yield_stress", "4 kPa*(1 + {} 1/s*t)"),
        ("youngs_modulus", "4 MPa*(1 + {} 1/s*t)"),
        ("viscosity", "13.84 kPa*s*(1 + {} 1/s*t)"),
        ("natural_strain", "-{} 1/s*t"),
    ):
        effect = "natural-strain" if name == "natural_strain" else "curing"
        changes = [last({name: of_rate.format(rate)}, effect) / plain - 1 for rate in (0.0, 2e-4, 4e-4)]
        order = math.log2(changes[2] / changes[1])
        rows.append([name, *(f"{change:.2e}" for change in changes), f"{order:.3f}"])
        assert abs(changes[0]) < (1e-9 if name == "youngs_modulus" else 1e-12), rows[-1]
        assert order == pytest.approx(1, abs=0.05), rows[-1]
    show("change of the midpoint", ["history", "rate 0", "2e-4", "4e-4 /s", "order"], rows)


LAWS: dict[str, dict[str, Any]] = {
    "elastic": {"youngs_modulus": "2 MPa"},
    "maxwell": {"youngs_modulus": "2 MPa", "viscosity": "5 kPa*s"},
    "newtonian": {"viscosity": "5 kPa*s"},
    "kelvin-voigt": {"youngs_modulus": "300 kPa", "viscosity": "2 kPa*s"},
    "standard-linear": {"youngs_modulus": "300 kPa", "second_modulus": "500 kPa", "viscosity": "2 kPa*s"},
    "bingham": {"youngs_modulus": "2 MPa", "viscosity": "5 kPa*s", "yield_stress": "4 kPa"},
    "power-law": {"youngs_modulus": "2 MPa", "viscosity": "5 kPa*s^0.7", "index": 0.7},
}


@pytest.mark.parametrize("law", LAWS)
def test_the_audit_closes_whatever_changes(law: str) -> None:
    """Every constant of every law by its own history, the material shrinking and curling; random numbers."""
    generator = np.random.default_rng(sorted(LAWS).index(law))
    material: dict[str, Any] = {"law": law, **LAWS[law]}
    for name in [key for key in material if key not in ("law", "index")]:
        rate, tau = generator.uniform(-0.8, 3.0), generator.uniform(0.05, 0.4)
        material[name] = f"{material[name]}*(1 + {rate:.3g}*(1 - exp(-t/{tau:.3g} s)))"
    material["natural_strain"] = f"{generator.uniform(-0.03, 0.01):.3g}*(1 - exp(-t/0.1 s))"
    material["natural_strain_difference"] = {"0 s": 0, "0.1 s": 0.004, "0.2 s": float(generator.uniform(-0.01, 0))}
    # What yields takes many steps where its time error is a billionth.
    tight = {} if "yield_stress" in material else {"rtol": 1e-9}
    run = sc.simulate(
        scene(
            material,
            filament={"thickness": 0.006, "density": 1900.0},
            load={"gravity": 9.81},
            run={"duration": 0.3, "frames": 16, "accuracy": 1e-3},
            numerics={"cells": 8, "estimate": False, "backend": "compiled", **tight},
        )
    )
    assert run.outcome.is_success
    assert run.summary["energy_residual"] < (1e-6 if tight else 1e-3)
