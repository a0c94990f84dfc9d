"""Casson's law, a formula in the table of laws: against its closed form in shear, by hand and on every command."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.special import lambertw

import softcat_sym as sc
from softcat_sym.errors import SceneError
from softcat_sym.fitting.flow_curve import FlowCurve, fit_flow_curve
from softcat_sym.fitting.flow_readings import steady_shear_stress
from softcat_sym.physics.constitutive_laws import law_of
from softcat_sym.physics.symbols import eta, sigma, sigma_Y
from softcat_sym.scene.scene import Scene
from softcat_sym.web.page import live_page
from tests.common.draws import draws
from tests.common.fitting import film
from tests.common.scenes import faults_of
from tests.marks import few

E, MU, TAU_Y, LENGTH, DENSITY, GRAVITY = 4e6, 5e3, 1e3, 0.2, 1900.0, 9.81
SHEAR = {"law": "casson", "youngs_modulus": "4 MPa", "shear_viscosity": "5 kPa*s", "shear_yield_stress": "1 kPa"}
BAR: dict[str, Any] = {
    "filament": {"span": "0.2 m", "thickness": "6 mm", "section": "circle", "density": "1900 kg/m^3"},
    "material": SHEAR,
    "ends": {"right": "free", "left_angle": "-90 deg"},
    "run": {"duration": "8 s", "frames": 5, "effects": ["bending", "extensibility", "finite-stretch", "thinning"]},
    "numerics": {"cells": 4, "estimate": False, "rtol": 1e-9},
}
"""A bar that hangs from a clamp and creeps in its own weight."""
BAR["run"]["effects"] += ["large-rotation", "viscous-flow", "yielding"]

compiled_and_interpreted = few(("compiled", "interpreted"), "compiled")


def rate_in_tension(stress: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Casson's own rate in shear, (sqrt(tau) - sqrt(tau_Y))^2/mu, of tau = sigma/sqrt(3), over sqrt(3)."""
    tau = np.maximum(np.abs(stress) / math.sqrt(3), TAU_Y)
    return np.asarray(np.sign(stress) * (np.sqrt(tau) - math.sqrt(TAU_Y)) ** 2 / MU / math.sqrt(3))


def test_the_flow_rule_is_that_in_shear() -> None:
    (branch,) = law_of("casson").branches
    material = sc.Scene.from_dict(BAR).material
    known = {eta: material.viscosity, sigma_Y: material.yield_stress}
    flows = [branch.in_force(flows=True, yields=yields).flow for yields in (True, False)]
    stresses = [-9e3, -1733.0, -1e3, 0.0, 500.0, 1732.0, 1732.1, 4e3, 1e9]
    found, fluid = ([float(flow.rate.subs(known | {sigma: one})) for one in stresses] for flow in flows)
    # Close to yield the difference of the roots in the closed form keeps six digits.
    assert found == pytest.approx(rate_in_tension(stresses), rel=1e-6, abs=1e-14)
    assert fluid == pytest.approx(np.array(stresses) / (3 * MU), rel=1e-12)
    assert float(sp.diff(flows[0].rate, sigma).subs(known | {sigma: 3e3})) > 0


def creep(scene: Scene, where: npt.NDArray[np.float64], times: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Stretch of points of a hanging bar: sigma = w s, w the weight below, and log s = sigma/E + eps_p."""
    below = DENSITY * GRAVITY * (LENGTH - where)

    def rate(_: float, strain: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        stress = below * np.exp(strain)
        return rate_in_tension(stress) / (1 - stress / E)

    at_once = -np.real(lambertw(-below / E))
    found = solve_ivp(rate, (0, times[-1]), at_once, "DOP853", times, rtol=1e-11, atol=1e-13)
    return np.exp(found.y.T)


def assert_creeps(run: sc.Run) -> None:
    data = run.data
    exact = creep(run.scene, data["X_cell"].values + LENGTH / 2, data["time"].values)
    assert run.outcome.is_success and exact.max() > 1.2 and exact[-1].min() < 1.0001
    assert data["stretch"].values == pytest.approx(exact, rel=1e-6)


@pytest.mark.parametrize("backend", compiled_and_interpreted)
def test_a_hanging_bar_creeps_by_its_flow_rule(backend: str) -> None:
    assert_creeps(sc.simulate(Scene.from_dict(BAR).replace({"numerics.backend": backend})))


@pytest.mark.slow
@pytest.mark.parametrize("backend", ["compiled", "interpreted"])
def test_a_hanging_bar_creeps_so_in_space(backend: str) -> None:
    changes = {"run.dimensions": 3, "run.effects": "auto", "numerics.backend": backend, "numerics.rtol": 1e-7}
    run = sc.simulate(Scene.from_dict(BAR).replace({**changes, "run.duration": "4 s", "numerics.fibres": 2}))
    exact = creep(run.scene, run.data["X_cell"].values + LENGTH / 2, run.data["time"].values)
    # The weight of a bar that bends has no moment here; inertia is of the order 1e-4.
    assert run.data["stretch"].values == pytest.approx(exact, rel=2e-3)


def test_constants_of_a_flow_curve_come_back() -> None:
    rate = np.geomspace(0.05, 200, 24)
    stress = (math.sqrt(12.0) + np.sqrt(2.5 * rate)) ** 2
    found = fit_flow_curve(FlowCurve(rate, stress))
    assert found.best.law == "casson"
    assert (found.best.tau_Y.value, found.best.k.value) == pytest.approx((12.0, 2.5), rel=1e-9)
    material = Scene.from_dict(BAR).replace(found.overrides()).material
    assert material.values() == pytest.approx(
        {"youngs_modulus": E, "viscosity": 7.5, "yield_stress": 12 * math.sqrt(3)}
    )
    assert steady_shear_stress(material, rate) == pytest.approx(stress, rel=1e-12)
    # The standard errors are those of the Jacobian, here by differences, of relative residuals.
    noisy = FlowCurve(rate, stress * (1 + 0.01 * draws(0).standard_normal(rate.size)))
    one = fit_flow_curve(noisy).candidate("casson")
    x = np.array([one.tau_Y.value, one.k.value])
    residuals = [
        ((np.sqrt(y[0]) + np.sqrt(y[1] * rate)) ** 2 / noisy.shear_stress - 1)
        for y in (x, *(x * (1 + 1e-6 * row) for row in np.eye(2)))
    ]
    slopes = np.column_stack([(residuals[1 + k] - residuals[0]) / (1e-6 * x[k]) for k in (0, 1)])
    covariance = np.linalg.inv(slopes.T @ slopes) * np.sum(residuals[0] ** 2) / (rate.size - 2)
    errors = [one.tau_Y.standard_error, one.k.standard_error]
    assert errors == pytest.approx(np.sqrt(np.diag(covariance)), rel=1e-4)
    assert slopes.T @ residuals[0] == pytest.approx([0, 0], abs=1e-4)


def test_without_a_yield_stress_a_fluid_is_found() -> None:
    rate = np.geomspace(0.05, 200, 12)
    found = fit_flow_curve(FlowCurve(rate, 3.0 * rate)).candidate("casson")
    assert (found.tau_Y.value, found.k.value) == pytest.approx((0.0, 3.0), abs=1e-12)
    assert "newtonian" in (found.unfit or "")


@pytest.mark.parametrize(
    ("changes", "path", "says"),
    [
        ({"shear_yield_stress": None}, "material.yield_stress", "missing: the law 'casson' needs it"),
        ({"shear_viscosity": None}, "material.viscosity", "missing: the law 'casson' needs it"),
        ({"youngs_modulus": None}, "material.youngs_modulus", "missing: the law 'casson' needs it"),
        ({"viscosity": "15 kPa*s"}, "material.viscosity", "given twice"),
        ({"shear_yield_stress": "1 kPa*s"}, "material.shear_yield_stress", "is a viscosity, not a stress"),
        ({"shear_yield_stress": "-1 kPa"}, "material.shear_yield_stress", "is negative"),
        ({"shear_viscosity": "0 Pa*s"}, "material.shear_viscosity", "is zero"),
        (
            {"shear_viscosity": None, "shear_consistency": "5 Pa*s^0.5"},
            "material.shear_consistency",
            "has no consistency",
        ),
        ({"index": 0.5}, "material.index", "has no index"),
        ({"second_modulus": "1 MPa"}, "material.second_modulus", "does not use it"),
        ({"flow": "sigma"}, "material.flow", "does not use it"),
        ({"law": "cason"}, "material.law", "did you mean 'casson'"),
    ],
)
def test_bad_input_is_refused(changes: dict[str, Any], path: str, says: str) -> None:
    material = {key: value for key, value in (SHEAR | changes).items() if value is not None}
    faults = {fault.path: str(fault) for fault in faults_of({**BAR, "material": material})}
    assert says in faults[path]


def test_the_model_of_small_deflections_refuses_it() -> None:
    with pytest.raises(SceneError, match=r"material\.law: 'casson' with model 'small-deflection'"):
        Scene.from_dict({**BAR, "model": "small-deflection", "ends": {}})


@pytest.mark.slow
def test_fit_card_and_page_have_it(tmp_path: Path) -> None:
    scene = Scene.from_dict({**BAR, "ends": {}, "run": {"duration": "0.5 s"}, "numerics": {}})
    scene = scene.replace({"material.shear_yield_stress": "400 Pa"})
    wrong = scene.replace({"material.shear_yield_stress": "500 Pa", "material.shear_viscosity": "4 kPa*s"})
    names = ["shear_yield_stress", "shear_viscosity"]
    found = sc.fit(film(scene, 60, 1e-4), wrong, free=names, profiles=False).parameters
    # Six standard errors of two constants: by chance less than once in 2e8.
    for name, truth in zip(names, (400.0, 5e3), strict=True):
        assert found[name].std < 0.05 * truth
        assert found[name].best == pytest.approx(truth, abs=6 * found[name].std)
    assert sc.card(scene).run.outcome.is_success
    assert "casson" in live_page(scene, tmp_path).read_text(encoding="utf-8")
