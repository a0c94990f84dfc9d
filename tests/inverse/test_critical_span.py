"""Critical spans: closed forms of beams and strings, dimensional analysis, finite differences, refusals."""

from __future__ import annotations

import math
from dataclasses import dataclass

import pytest

import softcat_sym as sc
from softcat_sym.design.critical_span import Limit, critical_span, crossings, illinois, polished

_GRAVITY, _DENSITY, _THICKNESS, _DURATION, _VISCOSITY = 9.81, 1300.0, 2e-3, 3.0, 5e7


def _beam(ends: str, changes: dict[str, object] | None = None) -> sc.Scene:
    """A viscous beam of rectangular section without inertia."""
    return sc.Scene.model_validate(
        {
            "filament": {
                "span": "60 mm",
                "thickness": f"{_THICKNESS!r} m",
                "section": "rectangle",
                "density": f"{_DENSITY!r} kg/m^3",
            },
            "material": {"law": "newtonian", "viscosity": f"{_VISCOSITY!r} Pa*s"},
            "ends": {"left": ends, "right": ends},
            "run": {"duration": f"{_DURATION!r} s", "effects": ["bending", "viscous-stress"]},
        }
    ).replace(changes or {})


@pytest.mark.parametrize(("ends", "factor"), [("clamped", 1 / 384), ("pinned", 5 / 384)])
def test_a_viscous_beam_in_small_deflection(ends: str, factor: float) -> None:
    """Sag = factor q L^4 t/(eta I) by Stokes' analogy: L goes as (eta h^2/(rho t))^(1/4)."""
    limit = 2e-5
    found = critical_span(_beam(ends), f"{limit!r} m", within=("20 mm", "200 mm"))
    stiffness = _VISCOSITY * _THICKNESS**2 / (12 * _DENSITY * _GRAVITY * _DURATION)
    assert found.span == pytest.approx((limit * stiffness / factor) ** 0.25, rel=2e-3)
    assert found.sag == pytest.approx(limit, rel=1e-8)
    expected = {"material.viscosity": 0.25, "filament.density": -0.25, "filament.thickness": 0.5}
    assert {path: found.gradient[path] for path in expected} == pytest.approx(expected, abs=3e-3)
    assert found.gradient["filament.width"] == 0.0
    assert len(found.crossings) == 1


def test_a_fraction_of_the_span_and_a_time() -> None:
    """With a limit of c L the exponents are thirds; the sag at a time is that of a run of this length."""
    fraction, time = 2e-4, 0.7
    found = critical_span(_beam("clamped"), fraction, time=f"{time} s", within=("20 mm", "200 mm"))
    stiffness = _VISCOSITY * _THICKNESS**2 / (12 * _DENSITY * _GRAVITY * time)
    assert found.span == pytest.approx((384 * fraction * stiffness) ** (1 / 3), rel=3e-3)
    assert found.gradient["material.viscosity"] == pytest.approx(1 / 3, abs=3e-3)
    assert found.gradient["filament.thickness"] == pytest.approx(2 / 3, abs=5e-3)
    assert found.sag == pytest.approx(fraction * found.span, rel=1e-8)


def test_equilibria_have_no_forward_model() -> None:
    """An elastic beam without inertia: q L^4/(384 E I), by differences of runs."""
    modulus, limit = 1e6, 1e-4
    beam = _beam(
        "clamped",
        {
            "material.law": "elastic",
            "material.viscosity": None,
            "run.frames": 2,
            "run.effects": ["bending"],
            "load.ramp": f"{_DURATION!r} s",
            "material.youngs_modulus": f"{modulus!r} Pa",
        },
    )
    found = critical_span(beam, f"{limit!r} m", within=("20 mm", "60 mm"))
    stiffness = modulus * _THICKNESS**2 / (12 * _DENSITY * _GRAVITY)
    assert found.span == pytest.approx((384 * limit * stiffness) ** 0.25, rel=2e-3)
    assert found.gradient["material.youngs_modulus"] == pytest.approx(0.25, abs=1e-3)
    assert found.gradient["filament.thickness"] == pytest.approx(0.5, abs=1e-3)


@pytest.mark.slow
def test_the_gradient_agrees_with_finite_differences() -> None:
    """A Maxwell filament that rings: critical spans of scenes with another viscosity, everything chosen anew."""
    scene = sc.load_scene("maxwell-fast", {"run.effects": "paper", "groups.duration": 4, "numerics.cells": 16})
    within = ("0.2 m", "0.5 m")
    found = critical_span(scene, 0.03, within=within)
    step, viscosity = 0.02, scene.material.viscosity
    assert viscosity is not None
    spans = [
        critical_span(
            scene.replace({"material.viscosity": f"{viscosity * math.exp(sign * step)!r} Pa*s"}), 0.03, within=within
        ).span
        for sign in (-1, 1)
    ]
    slope = math.log(spans[1] / spans[0]) / (2 * step)
    assert found.gradient["material.viscosity"] == pytest.approx(slope, abs=2e-3)
    # Only these have mass in their dimension: scaled alike, nothing moves.
    massive = ("material.viscosity", "material.youngs_modulus", "filament.density")
    assert sum(found.gradient[path] for path in massive) == pytest.approx(0.0, abs=1e-4)


@pytest.mark.slow
def test_a_yield_stress_string_is_arrested() -> None:
    """A stiff string stops as a catenary whose largest stress is the yield stress: G cosh u = 2 u [3.13, exact]."""
    scene = sc.load_scene("arrested-overdamped", {"groups.delta": 0.005, "groups.eps_Y": 2e-4})
    named = ["bending", "extensibility", "large-rotation", "finite-stretch", "viscous-flow", "yielding", "gravity-ramp"]
    scene = scene.replace({"run.duration": "60 s", "run.effects": named, "load.ramp": "1 s", "run.frames": 31})
    fraction, material = 0.07, scene.material
    assert material.yield_stress is not None
    found = critical_span(scene, fraction, within=("150 mm", "400 mm"))
    u, _ = illinois(lambda u: (math.cosh(u) - 1) / (2 * u) - fraction, (0.1, -1.0), (1.0, 1.0), 1e-12)
    ideal = 2 * u / math.cosh(u) * material.yield_stress / (scene.filament.density * scene.load.gravity)
    assert found.span == pytest.approx(ideal, rel=0.03)
    assert found.gradient["material.yield_stress"] == pytest.approx(1.0, abs=0.05)
    assert found.gradient["filament.density"] == pytest.approx(-1.0, abs=0.05)


def test_refusals() -> None:
    """Each says what would do."""
    beam = _beam("clamped")
    with pytest.raises(sc.SceneError, match=r"limit: .*no unit"):
        critical_span(beam, "12")
    with pytest.raises(sc.SceneError, match=r"limit: .*not positive"):
        critical_span(beam, -0.1)
    with pytest.raises(sc.SceneError, match=r"within filament\.span"):
        critical_span(beam, "1 mm", within=("50 mm", "20 mm"))
    with pytest.raises(sc.SoftcatError, match="even a span of 20 mm sags"):
        critical_span(beam, "1e-9 m", within=("20 mm", "40 mm"))
    with pytest.raises(sc.SoftcatError, match="no span from 20 mm to 40 mm reaches the limit"):
        critical_span(beam, "1 m", within=("20 mm", "40 mm"))


def test_the_scan_finds_every_crossing_and_illinois_the_root() -> None:
    """Infinite values count as above; a root is closed in from an infinite end too."""
    assert crossings([-1.0, 2.0, math.inf, -3.0, -math.inf]) == (0, 2)

    def function(x: float) -> float:
        return math.inf if x > 1.5 else x**3 - 2

    root, value = illinois(function, (0.0, -2.0), (4.0, math.inf), 1e-12)
    assert root == pytest.approx(2 ** (1 / 3), rel=1e-9)
    assert abs(value) < 1e-8


@dataclass
class _Scattered:
    """Sag L^2 with one slope that is wild at one span only."""

    wild: float

    def at(self, span: float) -> tuple[float, float, dict[str, float]]:
        slope = 40.0 if abs(span - self.wild) < 1e-4 * span else -1.0
        return span**2, 2.0, {"p": slope}


def test_a_wild_slope_is_outvoted() -> None:
    """At a fibre that yields just then differences are no derivatives: the median of the neighbours is taken."""
    root = polished(_Scattered(2.0), Limit(4.0, of_span=False), 2.001)
    assert root.span == pytest.approx(2.0, rel=1e-9)
    assert root.gradient == pytest.approx({"p": 0.5})
    assert polished(_Scattered(9.0), Limit(0.5, of_span=True), 0.5).gradient == pytest.approx({"p": 1.0})
