"""Backstress: fibres against the point law, Bauschinger effect in closed form, energy, limits, backends, refusals."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from tests.test_structure import BINGHAM, RATE, STRUCTURE, L
from tests.test_structure import EFFECTS as WITH_STRUCTURE

PLAIN = [name for name in WITH_STRUCTURE if name != "structure"]
EFFECTS = [*PLAIN, "backstress"]
C, Q = 2e3, 5.0


def bar(**changes: Any) -> sc.Scene:
    """A weightless bar of 10 cm that hardens, pulled by 2 mm/s."""
    return sc.Scene.from_dict(
        {
            "filament": {"span": L, "diameter": "2 mm", "density": "1000 kg/m^3"},
            "material": {**BINGHAM, "hardening_modulus": C, "hardening_recovery": Q},
            "ends": {"motion": [["0 s", "0 m", "0 m"], ["20 s", "40 mm", "0 m"]]},
            "load": {"gravity": 0},
            "run": {"duration": "10 s", "frames": 41, "effects": EFFECTS},
            "numerics": {"estimate": False, "cells": 4, "fibres": 4, "rtol": 1e-8},
        }
    ).replace(changes)


def stress_and_backstress(
    time: Any, rise: float = 0.0, build_up: float = 4.0, breakdown: float = 30.0, root: float = 1.0
) -> Any:
    """Stress, backstress and structure of the bar, whose yield stress rises by `rise`, by another program.

    Stress^root less yield stress^root is (eta rate)^root: 1 of Bingham's law, 1/2 of Casson's.
    """

    def rates(t: float, state: Any) -> list[float]:
        sigma, back, lam = state
        driving = sigma - back
        beyond = max(abs(driving) ** root - (300.0 + rise * lam) ** root, 0.0)
        flow = math.copysign(beyond ** (1 / root) / 5e4, driving)
        kinetics = (1 - lam - lam * breakdown * abs(flow)) / build_up
        return [1e5 * (RATE / (L + RATE * t) - flow), C * flow - Q * back * abs(flow), kinetics]

    return solve_ivp(rates, (0, time[-1]), [0.0] * 3, t_eval=time, rtol=1e-10, atol=1e-8, max_step=0.01).y


@pytest.mark.parametrize(
    ("law", "structured", "backend"),
    [("bingham", False, "interpreted"), ("bingham", True, "compiled"), ("casson", True, "compiled")],
)
def test_a_bar_that_is_pulled_follows_the_law_of_a_point(law: str, backend: str, structured: bool) -> None:
    """Alone, and beside structure as in the MIKH model."""
    changes: dict[str, Any] = {"numerics.backend": backend, "material.law": law}
    if structured:
        changes |= {"material.structure": STRUCTURE, "run.effects": [*EFFECTS, "structure"]}
    run = sc.simulate(bar(**changes))
    sigma, back, _ = stress_and_backstress(
        run.data.time.values, 600.0 if structured else 0.0, root=0.5 if law == "casson" else 1.0
    )
    assert run.outcome.is_success
    assert np.allclose(run.data.stress_mean.values, sigma[:, None], atol=2e-5 * np.max(sigma))
    assert np.allclose(run.data.backstress.values, back[:, None], atol=2e-5 * np.max(back))
    assert run.summary["energy_residual"] < 1e-6


def cycle(**changes: Any) -> sc.Scene:
    """Pulled by 5 % and let back to 3 %, still taut, with an overstress of a thousandth of the yield stress."""
    motion = [["0 s", "0 m", "0 m"], ["1000 s", "5 mm", "0 m"], ["1400 s", "3 mm", "0 m"]]
    slow = {"ends.motion": motion, "run.duration": "1400 s", "material.viscosity": "5 kPa*s"}
    return bar(**{**slow, **changes})


def test_prager_bar_yields_sooner_the_other_way() -> None:
    """Bauschinger: a linear hardening bar in closed form, loaded to sigma_m, yields again at sigma_m - 2 sigma_Y."""
    run = sc.simulate(cycle(**{"material.hardening_recovery": 0, "material.hardening_modulus": "20 kPa"}))
    time, E, limit = run.data.time.values, 1e5, 300.0
    strain = np.log1p(5e-2 * np.minimum(time, 2000 - time) / 1000)
    tangent = E * 2e4 / (E + 2e4)
    top = limit + tangent * (math.log(1.05) - limit / E)
    loading = np.minimum(E * strain, limit + tangent * (strain - limit / E))
    turned = math.log(1.05) - strain
    unloading = np.maximum(top - E * turned, top - 2 * limit - tangent * (turned - 2 * limit / E))
    exact = np.where(time <= 1000, loading, unloading)
    assert np.max(np.abs(run.data.stress_mean.values[:, 0] - exact)) < 2e-3 * limit
    # A method of order p whose steps err by rtol errs by about rtol^(p/(p+1)) in all.
    order = 5 if run.summary["solver"] == "rosenbrock" else 2
    assert run.summary["energy_residual"] < 4 * run.summary["rtol"] ** (order / (order + 1))


def test_backstress_saturates() -> None:
    """Armstrong and Frederick: chi = C/q (1 - exp(-q e)) of plastic strain e, at length C/q."""
    run = sc.simulate(bar(**{"material.hardening_recovery": 200.0}))
    sigma, chi = run.data.stress_mean.values[:, 0], run.data.backstress.values[:, 0]
    plastic = np.log1p(RATE / L * run.data.time.values) - sigma / 1e5
    assert np.allclose(chi, C / 200 * -np.expm1(-200 * plastic), atol=1e-5 * C / 200)
    assert chi[-1] == pytest.approx(C / 200, rel=2e-4)


def strand(section: str, *more: str) -> sc.Scene:
    """A strand that bends and hardens where it flows, with these effects besides."""
    filament = {"span": "60 mm", "thickness": "10 mm", "density": 2000, "section": section}
    filament |= {"width": "10 mm"} if section == "rectangle" else {}
    return sc.Scene.from_dict(
        {
            "filament": filament,
            "material": {**BINGHAM, "viscosity": 2e3, "hardening_modulus": 3e3, "hardening_recovery": 3.0},
            "run": {"duration": "1 s", "frames": 6, "effects": [*EFFECTS, *more]},
            "numerics": {"estimate": False, "cells": 4, "fibres": 4, "rtol": 1e-7},
        }
    )


def test_energy_is_closed_where_sections_bend() -> None:
    run = sc.simulate(strand("rectangle"))
    assert np.max(np.abs(run.data.backstress.values)) > 1
    assert run.summary["energy_residual"] < 1e-6


def test_a_small_modulus_is_the_law_without() -> None:
    """The error is of first order in C."""
    plain = sc.simulate(
        bar(**{"material.hardening_modulus": None, "material.hardening_recovery": 0, "run.effects": PLAIN})
    )
    assert "backstress" not in plain.data
    apart = [
        float(run.data.stress_mean.values[-1, 0] - plain.data.stress_mean.values[-1, 0])
        for run in (sc.simulate(bar(**{"material.hardening_modulus": f"{value} Pa"})) for value in (20.0, 10.0))
    ]
    assert math.log2(apart[0] / apart[1]) == pytest.approx(1, abs=0.01)


def test_auto_takes_it_in_where_it_matters() -> None:
    ink = {
        "filament": {"span": "20 mm", "diameter": "2 mm", "density": "1500 kg/m^3"},
        "material": {"law": "bingham", "youngs_modulus": "50 kPa", "viscosity": "2 kPa*s", "yield_stress": "300 Pa"},
        "run": {"duration": "5 s"},
    }
    for modulus, expected in (("5 kPa", True), ("1 mPa", False)):
        scene = sc.Scene.from_dict(ink).replace({"material.hardening_modulus": modulus})
        assert ("backstress" in choose_effects(scene).names) is expected, modulus


@pytest.mark.parametrize(
    ("change", "path"),
    [
        ({"hardening_modulus": 0}, "material.hardening_modulus"),
        ({"hardening_modulus": "-1 Pa"}, "material.hardening_modulus"),
        ({"hardening_modulus": "3 s"}, "material.hardening_modulus"),
        ({"hardening_modulus": True}, "material.hardening_modulus"),
        ({"hardening_modulus": "stiff"}, "material.hardening_modulus"),
        ({"hardening_modulus": math.nan}, "material.hardening_modulus"),
        ({"hardening_recovery": -1}, "material.hardening_recovery"),
        ({"hardening_recovery": "3 Pa"}, "material.hardening_recovery"),
        ({"hardening_recovery": math.inf}, "material.hardening_recovery"),
        ({"hardening_modulus": None}, "material.hardening_recovery"),
    ],
)
def test_bad_numbers_are_one_clear_error(change: dict[str, Any], path: str) -> None:
    with pytest.raises(sc.SceneError, match=path) as caught:
        bar(**{f"material.{key}": value for key, value in change.items()})
    assert len(caught.value.faults) == 1


@pytest.mark.parametrize(
    "material",
    [
        {"law": "elastic", "youngs_modulus": "1 kPa"},
        {"law": "maxwell", "youngs_modulus": "1 kPa", "viscosity": "1 kPa*s"},
        {"law": "kelvin-voigt", "youngs_modulus": "1 kPa", "viscosity": "1 kPa*s"},
        {"law": "power-law", "youngs_modulus": "1 kPa", "viscosity": "1 kPa*s^0.5", "index": 0.5},
    ],
)
def test_laws_without_a_yield_stress_refuse_it(material: dict[str, Any]) -> None:
    filament = {"span": L, "diameter": "2 mm", "density": "1000 kg/m^3"}
    hardening = {"hardening_modulus": "2 kPa", "hardening_recovery": 3}
    with pytest.raises(sc.SceneError, match=r"material\.hardening_modulus") as caught:
        sc.Scene.from_dict({"filament": filament, "run": {"duration": "1 s"}, "material": {**material, **hardening}})
    assert len(caught.value.faults) == 1
