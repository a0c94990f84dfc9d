"""What holds a filament with a surface, in a bath: sigma_Y + gamma P/(2 A) against runs, less weight, less moment."""

from __future__ import annotations

import dataclasses

import pytest
import sympy as sp

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.estimates import scaling as scales
from softcat_sym.estimates.expected_regime import expected_regime
from softcat_sym.estimates.forecast import forecast
from softcat_sym.physics import beams, regimes
from softcat_sym.physics.cross_sections import CROSS_SECTIONS
from softcat_sym.physics.symbols import L, g, rho
from softcat_sym.scene.ends import SUPPORTS

LIMIT, SPAN, THICK, RHO = 400.0, 0.02, 2e-4, 1500.0
STRING = (
    *("extensibility", "large-rotation", "viscous-flow", "yielding", "gravity-ramp"),
    *("surface-tension", "buoyancy"),
)


def thread(bath: float, tension: float, **changes: object) -> sc.Scene:
    """A soft thread without bending stiffness that is loaded slowly, and too viscous to gather into necks."""
    law = {"law": "bingham", "youngs_modulus": "400 kPa", "viscosity": "2 kPa*s", "yield_stress": f"{LIMIT} Pa"}
    scene = sc.Scene.from_dict(
        {
            "filament": {"span": f"{SPAN} m", "diameter": f"{THICK} m", "density": f"{RHO} kg/m^3"},
            "material": law,
            "surroundings": {"density": f"{bath} kg/m^3", "surface_tension": f"{tension} N/m"},
            "ends": {"left": "pinned", "right": "pinned"},
            "load": {"ramp": "20 s"},
            "run": {"duration": "30 s", "frames": 61, "effects": list(STRING)},
            "numerics": {"cells": 20, "estimate": False},
        }
    )
    return scene.replace(changes)


@pytest.mark.parametrize(("bath", "tension"), [(0.0, 0.004), (0.0, 0.04), (600.0, 0.04)])
def test_a_thread_stops_where_yield_stress_and_surface_carry_its_weight(bath: float, tension: float) -> None:
    """At the depth of the exact catenary of G = (rho - rho_b) g L/(sigma_Y + gamma/R), from which sigma_Y is read."""
    effects = [name for name in STRING if bath or name != "buoyancy"]
    scene = thread(bath, tension, **{"run.effects": effects})
    pull, weight = 2 * tension / THICK, (RHO - bath) * 9.81 * SPAN
    assert scales.gravity_number_of(scene) == pytest.approx(weight / (LIMIT + pull), rel=1e-3)
    found = expected_regime(scene, effects)
    sag = -sc.simulate(scene).summary["midpoint_final_m"]
    assert found.stopping_depth_exact is not None and sag == pytest.approx(found.stopping_depth_exact * SPAN, rel=0.02)
    stress = regimes.SHALLOW_STRESS.right.subs({rho: RHO - bath, g: 9.81, L: SPAN, regimes.H: sag})
    assert float(stress) - pull == pytest.approx(LIMIT, rel=0.02)
    # Of the fully plastic moment nothing comes from the surface.
    plain = beams.plastic_collapse(CROSS_SECTIONS["circle"], beams.PINNED, THICK / SPAN)
    assert (found.collapse or 0) * (LIMIT + pull) / LIMIT == pytest.approx(plain)


@pytest.mark.parametrize("ends", [("clamped", "clamped"), ("clamped", "pinned"), ("pinned", "pinned")])
def test_tension_takes_from_the_moment_of_a_beam_what_its_equation_says(ends: tuple[str, str]) -> None:
    """E I y'''' - T y'' = -q between clamps, pins and both, solved in closed form."""
    x, q = sp.symbols("x q", positive=True)
    psi = sp.Rational(7, 4)
    k = 2 * psi  # E I = L = 1, T = k^2
    constants = sp.symbols("c_0:4")
    y = sum(c * f for c, f in zip(constants, (1, x, sp.cosh(k * x), sp.sinh(k * x)), strict=True))
    y += q * x**2 / (2 * k**2)
    assert sp.simplify(y.diff(x, 4) - k**2 * y.diff(x, 2) + q) == 0
    held = [y.subs(x, at) for at in (0, 1)]
    held += [y.diff(x, 1 if end == "clamped" else 2).subs(x, at) for end, at in zip(ends, (0, 1), strict=True)]
    shape = y.subs(sp.solve(held, constants)).subs(q, 1)
    moment = shape.diff(x, 2)
    beam = beams.beam_between(*(SUPPORTS[end] for end in ends))
    largest = max(abs(moment.subs(x, at).evalf()) for at in (0, sp.Rational(1, 2)))
    assert float(largest / sp.Rational(beam.largest_moment)) == pytest.approx(beam.relief(float(psi)))
    assert sp.limit(beams.CLAMPED.relief(x, sp), x, 0) == 1


INERTIAL = ("swings", "relaxed", "overstress", "missed", "speed", "retarded", "damped")
"""Of a motion: what its ringing enters."""


def test_a_bath_is_a_lesser_gravity_to_all_that_is_foreseen() -> None:
    """But not to the inertia: sag, strain, shares and effects chosen are those of (1 - rho_b/rho) g."""
    for name in ("ink-bridge", "silicone-thread", "gelatin-strand", "toothpaste"):
        scene = sc.load_scene(name)
        bath = {"surroundings.density": f"{0.4 * scene.filament.density!r} kg/m^3"}
        light = scene.replace({"load.gravity": f"{0.6 * scene.load.gravity!r} m/s^2"})
        motions = [dataclasses.asdict(forecast(one)) for one in (scene.replace(bath), light)]
        # The mass that the bath adds slows the ringing.
        still = {key for key in motions[0] if key not in INERTIAL}
        assert {key: motions[0][key] for key in still} == pytest.approx(
            {key: motions[1][key] for key in still}, rel=1e-9
        )
        chosen = [choose_effects(one) for one in (scene.replace(bath), light)]
        names = [frozenset(one.reasons) for one in chosen]
        assert names[0] - {"added-mass"} == names[1] | {"buoyancy"}, name
        seen = [dataclasses.asdict(expected_regime(one, names[1])) for one in (scene.replace(bath), light)]
        numbers = [{key: value for key, value in one.items() if isinstance(value, float)} for one in seen]
        assert numbers[0] == pytest.approx(numbers[1], rel=1e-9) and seen[0]["name"] == seen[1]["name"], name
