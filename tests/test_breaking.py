"""Filaments that break: when and where, against closed forms; what a card, a sweep and the command line make of it."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import softcat_sym as sc
from softcat_sym.design.critical_span import critical_span
from tests.common.in_process import Softcat

L, RATE = 0.1, 0.01
STRETCHING = ["bending", "extensibility", "finite-stretch", "thinning"]


def bar(law: dict[str, Any], **tables: Any) -> sc.Scene:
    """A weightless bar of 10 cm, pulled by 1 cm/s."""
    return sc.Scene.from_dict(
        {
            "filament": {"span": L, "diameter": "2 mm", "density": "1000 kg/m^3"},
            "material": law,
            "ends": {"motion": [["0 s", "0 m", "0 m"], ["20 s", "20 cm", "0 m"]]},
            "load": {"gravity": 0},
            "run": {"duration": "19 s", "effects": STRETCHING},
            "numerics": {"estimate": False, "cells": 4, "rtol": 1e-7},
            **tables,
        }
    )


@pytest.mark.parametrize("backend", ["interpreted", "compiled"])
def test_a_bar_that_is_pulled_breaks_at_its_strain(backend: str) -> None:
    """log(1 + v t/L) = eps_b, whatever the law; the frames end there, and its midpoint is in the middle."""
    scene = bar({"law": "maxwell", "youngs_modulus": "100 kPa", "viscosity": "1 MPa*s", "breaking_strain": 0.5})
    run = sc.simulate(scene.replace({"numerics.backend": backend, "run.effects": [*STRETCHING, "viscous-flow"]}))
    expected = math.expm1(0.5) * L / RATE
    assert run.outcome is sc.Outcome.broken and run.outcome.is_answer and not run.outcome.is_success
    assert run.summary["broken"]["time_s"] == pytest.approx(expected, rel=1e-6)
    assert run.summary["broken"]["strain"] == pytest.approx(0.5, rel=2e-4)
    assert run.summary["broken"]["side"] == "section" and run.summary["broken"]["by"] == "strain"
    assert run.data.time.values[-1] == pytest.approx(expected, rel=1e-4) and len(run.data.time) == scene.run.frames


def test_a_bar_that_is_pulled_breaks_at_its_stress() -> None:
    """Start-up of a Maxwell fluid, integrated by another program: sigma_t = E (v/(L + v t) - sigma/eta)."""
    E, eta, limit = 1e5, 1e6, 3e4
    law = {"law": "maxwell", "youngs_modulus": E, "viscosity": eta, "breaking_stress": limit}
    scene = bar(law).replace(
        {"run.effects": ["bending", "extensibility", "finite-stretch", "thinning", "viscous-flow"]}
    )

    def rate(t: float, stress: Any) -> Any:
        return E * (RATE / (L + RATE * t) - stress / eta)

    def reached(t: float, stress: Any) -> float:
        return float(stress[0]) - limit

    reached.terminal = True  # type: ignore[attr-defined]
    exact = solve_ivp(rate, (0, 19), [0.0], events=reached, rtol=1e-11, atol=1e-6).t_events[0][0]
    found = sc.simulate(scene).summary["broken"]
    assert found["time_s"] == pytest.approx(exact, rel=1e-5) and found["by"] == "stress"


def test_a_beam_breaks_at_its_clamp_from_the_top() -> None:
    """The outer fibre at a clamp is strained by (q L^2/12) (h/2)/(E I)."""
    h, E, rho, limit = 2e-3, 1e9, 1000.0, 2e-5
    run = sc.simulate(
        {
            "filament": {"span": L, "thickness": h, "width": h, "density": rho},
            "material": {"law": "elastic", "youngs_modulus": E, "breaking_strain": limit},
            "load": {"ramp": "10 s"},
            "run": {"duration": "10 s", "effects": ["bending", "gravity-ramp"]},
            "numerics": {"estimate": False, "cells": 40},
        }
    )
    found, area, inertia = run.summary["broken"], h * h, h**4 / 12
    X = abs(found["X_m"])
    share = found["time_s"] / 10
    gravity = 9.81 * share**3 * (10 - 15 * share + 6 * share**2)
    moment = rho * area * gravity * (L**2 / 24 - X**2 / 2)  # Clamped beam, 0 at midspan
    assert X == pytest.approx(L / 2) and found["side"] == "top"
    assert abs(moment) * h / 2 / (E * inertia) == pytest.approx(limit, rel=5e-3)


def cantilever(**changes: Any) -> tuple[sc.Scene, float, float]:
    """A cantilever of a Maxwell fluid; strain of its outer fibre when it is loaded, and relaxation time.

    Its clamp bears rho g h^2 L^2/2, so that the outer fibre is strained by eps0 = 3 rho g L^2/(E h) at once and by eps0
    (1 + t/tau) later.
    """
    h, rho, eps0, tau = 2e-3, 1000.0, 0.004, 1.801
    E = 3 * rho * 9.81 * (L / 2) ** 2 / (h * eps0)
    tables = {
        "filament": {"span": L / 2, "thickness": h, "width": h, "density": rho},
        "material": {"law": "maxwell", "youngs_modulus": E, "viscosity": E * tau, "breaking_strain": 0.012},
        "ends": {"right": "free"},
        "load": {"gravity": 9.81},
        "run": {"duration": "6 s"},
    }
    return sc.Scene.from_dict(tables).replace(changes), eps0, tau


def test_a_creeping_cantilever_breaks_at_the_true_strain_of_its_outer_fibre_and_says_how_exactly_when() -> None:
    """At log(1 + eps0 (1 + t/tau)) = eps_b; a linear strain would reach 0.012 at 3.602 s."""
    for frames in (11, 201):
        scene, eps0, tau = cantilever(**{"run.effects": ["bending", "viscous-flow"], "run.frames": frames})
        run = sc.simulate(scene)
        exact, found = tau * (math.expm1(0.012) / eps0 - 1), run.summary["broken"]
        assert exact == pytest.approx(3.6345, rel=1e-4)
        assert abs(found["time_s"] - exact) < found["time_error_s"] < 1e-3 * exact
        assert found["rate_per_s"] == pytest.approx(eps0 / tau / math.exp(0.012) / 0.012, rel=1e-3)
        assert f"{found['time_s']:.6g} s ± {found['time_error_s']:.2g} s" in run.summary["message"]
        assert "true strain 0.012," in run.summary["message"]


def test_one_that_rings_breaks_in_a_swing_whatever_the_frames() -> None:
    """Of an elastic cantilever dropped at once, at tip and clamp, the swing reaches less than twice its rest."""
    found = []
    for frames in (5, 60):
        scene, eps0, _ = cantilever(
            **{"material.law": "elastic", "material.viscosity": None, "material.breaking_strain": 0.0074}
            | {"run.effects": ["inertia", "bending"], "run.frames": frames, "run.duration": "1 s"}
        )
        assert eps0 < 0.0074 < 2 * eps0
        found.append(sc.simulate(scene).summary["broken"])
    few, many = found
    assert few["time_s"] == pytest.approx(many["time_s"], abs=few["time_error_s"] + many["time_error_s"])
    assert few["time_s"] == pytest.approx(many["time_s"], rel=1e-3)


@pytest.mark.slow
def test_one_that_bears_all_that_it_is_asked_to_is_as_without() -> None:
    law = {"law": "maxwell", "youngs_modulus": "100 kPa", "viscosity": "1 MPa*s"}
    limits, run = {"breaking_strain": 0.7, "breaking_stress": "1 MPa"}, {"duration": "9 s", "effects": STRETCHING}
    plain, strong = (sc.simulate(bar(law | more, run=run)) for more in ({}, limits))
    assert strong.outcome is sc.Outcome.solved and strong.summary["broken"] is None
    assert np.array_equal(plain.data.midpoint, strong.data.midpoint)


GEL = {
    "title": "Gel",
    "filament": {"span": "20 mm", "diameter": "1 mm", "density": "1100 kg/m^3"},
    "material": {"law": "kelvin-voigt", "youngs_modulus": "5 kPa", "viscosity": "50 Pa*s", "breaking_strain": 0.2},
    "run": {"duration": "1 s"},
    "numerics": {"estimate": False},
}


@pytest.mark.slow
def test_the_longest_span_is_the_longest_that_does_not_break() -> None:
    """It sags less than the limit; a little longer it breaks."""
    scene = sc.Scene.from_dict(GEL)
    longest = critical_span(scene, "20 %", within=("8 mm", "30 mm"), exponents=False)
    assert longest.breaks and longest.sag < 0.2 * longest.span and "breaks" in longest.text[0]
    for factor, outcome in ((0.99, sc.Outcome.solved), (1.05, sc.Outcome.broken)):
        assert sc.simulate(scene.replace({"filament.span": f"{factor * longest.span!r} m"})).outcome is outcome


@pytest.mark.slow
def test_what_breaks_is_an_answer_for_the_command_line_and_an_outcome_of_sweeps(
    softcat: Softcat, tmp_path: Path
) -> None:
    scene = sc.Scene.from_dict(GEL)
    (tmp_path / "gel.toml").write_text(scene.to_toml())
    found = softcat("run", str(tmp_path / "gel.toml"), "-o", str(tmp_path / "out"))
    assert found.status in (0, None) and "it breaks after" in found.out
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["outcome"] == "broken" and summary["regime"] is None
    assert sc.open_run(tmp_path / "out").outcome is sc.Outcome.broken
    sweep = sc.sweep(scene, {"filament.span": [10e-3, 20e-3]})
    assert list(sweep.data.outcome.values) == ["solved", "broken"]


@pytest.mark.parametrize("key", ["breaking_strain", "breaking_stress"])
@pytest.mark.parametrize("value", [0, -1, "5 m", "much", True, float("nan"), []])
def test_bad_limits_are_one_clear_error(key: str, value: object) -> None:
    with pytest.raises(sc.SceneError, match=f"material.{key}") as caught:
        bar({"law": "newtonian", "viscosity": "1 kPa*s", key: value})
    assert len(caught.value.faults) == 1


def test_one_that_is_broken_from_the_start_is_refused() -> None:
    stretched = {"stretch": 1.5, "relaxed": False}
    law = {"law": "elastic", "youngs_modulus": "1 MPa", "breaking_strain": 0.3}
    scene = bar(law, initial=stretched, ends={})
    # From rest, a limit that is reached before any step can tell when.
    soon = sc.load_scene("no-yield", {"material.breaking_strain": 1e-300, "numerics.cells": 6, "run.frames": 21})
    for one in (scene, soon):
        with pytest.raises(sc.SceneError, match=r"material\.breaking_strain: exceeded as soon as anything moves"):
            sc.simulate(one)
