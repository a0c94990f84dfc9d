"""Thixotropic filaments: fibres against the point law of another program, limits, backends, refusals."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.scene.thixotropy import Thixotropy

L, RATE = 0.1, 2e-3
EFFECTS = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow", "yielding"]
EFFECTS += ["fibres", "structure"]
BINGHAM: dict[str, Any] = {"law": "bingham", "youngs_modulus": 1e5, "viscosity": 5e4, "yield_stress": 300.0}
STRUCTURE = {"build_up_time": "4 s", "breakdown_time": "30 s", "structured_yield_stress": "900 Pa"}


def bar(structure: dict[str, Any] | None = None, **changes: Any) -> sc.Scene:
    """A weightless bar of 10 cm, pulled by 2 mm/s."""
    return sc.Scene.from_dict(
        {
            "filament": {"span": L, "diameter": "2 mm", "density": "1000 kg/m^3"},
            "material": {**BINGHAM, "structure": {**STRUCTURE, **(structure or {})}},
            "ends": {"motion": [["0 s", "0 m", "0 m"], ["20 s", "40 mm", "0 m"]]},
            "load": {"gravity": 0},
            "run": {"duration": "10 s", "frames": 41, "effects": EFFECTS},
            "numerics": {"estimate": False, "cells": 4, "fibres": 4, "rtol": 1e-8},
        }
    ).replace(changes)


def stress_and_structure(structure: Thixotropy, time: Any) -> tuple[Any, Any]:
    """sigma and lambda of a bar pulled at a constant speed, integrated by another program."""
    E, eta, limit = 1e5, 5e4, 300.0
    high, low = structure.structured_yield_stress or limit, structure.destroyed_yield_stress
    low = limit if low is None else low
    start = (limit - low) / (high - low)
    begin = structure.grown(start, structure.rest)

    def rates(t: float, state: Any) -> list[float]:
        sigma, lam = state
        holds = limit + (high - low) * (lam - start)
        flow = max(sigma - holds, 0.0) / eta
        build = 1.0 if structure.growth == "linear" else 1.0 - lam
        broken = lam * (structure.breakdown_time * flow) ** structure.exponent
        return [E * (RATE / (L + RATE * t) - flow), (build - broken) / structure.build_up_time]

    found = solve_ivp(rates, (0, time[-1]), [0.0, begin], t_eval=time, rtol=1e-10, atol=[1e-6, 1e-12], max_step=0.01)
    return found.y[0], found.y[1]


@pytest.mark.parametrize(
    ("structure", "backend"),
    [
        ({}, "compiled"),
        ({"destroyed_yield_stress": "100 Pa", "exponent": 0.5, "rest": "3 s"}, "interpreted"),
        ({"growth": "linear", "destroyed_yield_stress": "150 Pa", "breakdown_time": "60 s"}, "compiled"),
    ],
)
def test_a_bar_that_is_pulled_follows_the_law_of_a_point(backend: str, structure: dict[str, Any]) -> None:
    scene = bar(structure, **{"numerics.backend": backend})
    run, stated = sc.simulate(scene), scene.material.structure
    assert run.outcome.is_success and stated is not None
    sigma, lam = stress_and_structure(stated, run.data.time.values)
    assert np.allclose(run.data.structure.values, lam[:, None], atol=2e-5)
    assert np.allclose(run.data.stress_mean.values, sigma[:, None], atol=2e-5 * np.max(sigma))
    assert run.summary["energy_residual"] < 1e-5


def test_what_stays_as_it_is_is_the_law_without() -> None:
    """A build-up that takes for ever, and one that has ended before anything moves."""
    frozen = sc.simulate(bar({"build_up_time": "1e9 s"}))
    plain = sc.simulate(bar().replace({"material.structure": None, "run.effects": EFFECTS[:-1]}))
    assert np.allclose(frozen.data.stress_mean, plain.data.stress_mean, rtol=1e-5, atol=1e-3)
    rested = sc.simulate(bar({"rest": "1000 s", "breakdown_time": "0 s"}))
    strong = plain.scene.replace({"material.yield_stress": "900 Pa"})
    assert np.allclose(rested.data.stress_mean, sc.simulate(strong).data.stress_mean, rtol=1e-5, atol=1e-3)


def test_data_of_a_rheometer_in_shear_are_converted() -> None:
    """Stresses by sqrt 3, rates by it the other way: an equivalent shear rate is sqrt 3 times that in tension."""
    root = math.sqrt(3)
    shear = {"breakdown_time": f"{30 / root!r} s", "structured_yield_stress": f"{900 / root!r} Pa", "measured": "shear"}
    found, stated = bar(shear).material.structure, bar().material.structure
    assert found is not None and stated is not None
    assert found.breakdown_time == pytest.approx(stated.breakdown_time)
    assert found.structured_yield_stress == pytest.approx(stated.structured_yield_stress)


def test_auto_takes_it_in_where_it_matters() -> None:
    ink = {
        "filament": {"span": "20 mm", "diameter": "2 mm", "density": "1500 kg/m^3"},
        "material": {"law": "bingham", "youngs_modulus": "50 kPa", "viscosity": "2 kPa*s", "yield_stress": "300 Pa"},
        "run": {"duration": "5 s"},
    }
    for table, expected in (
        ({"build_up_time": "2 s", "structured_yield_stress": "900 Pa"}, True),
        ({"build_up_time": "2 h", "structured_yield_stress": "310 Pa"}, False),
        ({"build_up_time": "2 h", "structured_yield_stress": "900 Pa", "rest": "1 h"}, True),
    ):
        scene = sc.Scene.from_dict(ink).replace({"material.structure": table})
        assert ("structure" in choose_effects(scene).names) is expected, table
        assert "structure" in choose_effects(scene.replace({"run.effects": EFFECTS})).names


@pytest.mark.parametrize(
    ("change", "path"),
    [
        ({"build_up_time": "0 s"}, "material.structure.build_up_time"),
        ({"build_up_time": "5 Pa"}, "material.structure.build_up_time"),
        ({"breakdown_time": "-1 s"}, "material.structure.breakdown_time"),
        ({"exponent": 0}, "material.structure.exponent"),
        ({"structured_yield_stress": "100 Pa"}, "material.structure.structured_yield_stress"),
        ({"destroyed_yield_stress": "400 Pa"}, "material.structure.destroyed_yield_stress"),
        ({"initial": 0.5}, "material.structure.initial"),
        ({"destroyed_viscosity": "1 kPa*s"}, "material.structure.destroyed_viscosity"),
        ({"rest": "soon"}, "material.structure.rest"),
        ({"growth": "quick"}, "material.structure.growth"),
        ({"builds": 1}, "material.structure.builds"),
    ],
)
def test_bad_tables_are_one_clear_error(change: dict[str, Any], path: str) -> None:
    with pytest.raises(sc.SceneError, match=path) as caught:
        bar(change)
    assert len(caught.value.faults) == 1


@pytest.mark.parametrize(
    "changes",
    [
        {"material": {"law": "elastic", "youngs_modulus": "1 kPa", "structure": STRUCTURE}},
        {"material": {**BINGHAM, "structure": 3}},
        {"material": {**BINGHAM, "structure": {"build_up_time": "3 s"}}},
        {"material": {**BINGHAM, "yield_stress": "300 Pa + 5 Pa/s * t", "structure": STRUCTURE}},
    ],
)
def test_what_builds_nothing_up_is_refused(changes: dict[str, Any]) -> None:
    filament = {"span": L, "diameter": "2 mm", "density": "1000 kg/m^3"}
    with pytest.raises(sc.SceneError, match=r"material\.structure") as caught:
        sc.Scene.from_dict({"filament": filament, "run": {"duration": "1 s"}, **changes})
    assert len(caught.value.faults) == 1
