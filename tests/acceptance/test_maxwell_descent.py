"""The small-deflection model against the full one, and the paper's formulas against both."""

from __future__ import annotations

from functools import cache

import numpy as np

import softcat_sym as sc
from softcat_sym.discretization.casadi_printer import evaluate
from softcat_sym.physics import closed_forms as far
from softcat_sym.physics.regimes import tau_star
from softcat_sym.physics.rheometry import B, t_star
from softcat_sym.scene.scene import gravity_time

from .table import show

LOAD = 3.3e-5
STATIC = {
    "filament": {"span": "1 m", "thickness": "0.25 mm", "density": "1000 kg/m^3"},
    "run": {"duration": "1 s", "frames": 2},
    # One grid for both models: what is left is the difference of the theories.
    "numerics": {"grading": 1.0, "estimate": False},
}


@cache
def descent(name: str, model: str = "filament") -> sc.Trajectory:
    """A bundled scene run once."""
    return sc.simulate(sc.load_scene(name, {"model": model, "numerics.estimate": False}))


def test_full_and_reduced_model_agree_within_two_percent_while_the_sag_is_small() -> None:
    rows, worst = [], 0.0
    for name in ("maxwell-slow", "maxwell-fast"):
        full, reduced = (descent(name), descent(name, "small-deflection"))
        assert full.outcome is reduced.outcome is sc.Outcome.solved
        sag, other = (-run.data.midpoint.values / run.scene.filament.span for run in (full, reduced))
        small = (sag > 0) & (sag < 0.03)
        difference = np.abs(other - sag) / np.max(sag[small])
        worst = max(worst, float(np.max(difference[small])))
        rows.append([name, f"{np.max(difference[small]):.2%}", f"{abs(other[-1] / sag[-1] - 1):.2%}", f"{sag[-1]:.4f}"])
    show("full and reduced model", ("scene", "difference while sag < 0.03 L", "at the end", "sag/L there"), rows)
    assert worst < 0.02


def test_their_relative_difference_grows_as_the_square_of_the_sag() -> None:
    sags, differences = [], []
    for modulus in np.geomspace(3e5, 3e8, 7):
        material = {"law": "elastic", "youngs_modulus": f"{modulus} Pa"}
        exact = ["bending", "finite-stretch", "thinning", "large-rotation"]
        full = _static({"material": material}, "filament", exact)
        reduced = _static({"material": material}, "small-deflection", ["bending"])
        sags.append(full)
        differences.append(abs(reduced / full - 1))
    slopes = np.diff(np.log(differences)) / np.diff(np.log(sags))
    fitted = float(np.polyfit(np.log(sags), np.log(differences), 1)[0])
    rows = [[f"{s:.4f}", f"{d:.2e}"] for s, d in zip(sags, differences, strict=True)]
    show(f"static elastic filament: slope {fitted:.3f}", ("sag/L", "relative difference"), rows)
    assert abs(fitted - 2) < 0.1
    assert np.all(np.abs(slopes - 2) < 0.15)


def _static(scene: dict[str, object], model: str, effects: list[str]) -> float:
    whole = {**STATIC, **scene, "model": model, "run": {**STATIC["run"], "effects": effects}}
    run = sc.simulate(sc.Scene.model_validate(whole))
    assert run.outcome is sc.Outcome.solved
    return -float(run.summary["midpoint_final_m"]) / run.scene.filament.span


def test_the_outer_solution_is_exact_for_a_string_without_inertia_and_the_third_law_is_not() -> None:
    rows = []
    for relaxation in (0.35, 3.5):
        changes = {
            "model": "small-deflection",
            "groups.tau": relaxation,
            "groups.duration": 20.0,
            "run.effects": ["viscous-flow"],
            "run.accuracy": 1e-5,
            "numerics.solver": "rosenbrock",
            "numerics.cells": 80,
        }
        run = sc.simulate(sc.load_scene("maxwell-slow", changes))
        assert run.outcome is sc.Outcome.solved
        time = run.data.time.values / gravity_time(run.scene)
        sag = -run.data.midpoint.values / run.scene.filament.span
        known = {B: LOAD, tau_star: relaxation}
        phi = np.geomspace(float(evaluate(far.ELASTIC_START, known)[0]), 4.5 * sag[-1], 20_000)
        outer = np.interp(time, evaluate(far.OUTER_TIME_FROM_REST, {**known, far.phi: phi}), phi / 4)
        law = -evaluate(far.THIRD_LAW, {**known, t_star: np.maximum(time, 1e-9)})
        with_log, bare = np.abs(outer / sag - 1), np.abs(law / sag - 1)
        for instant in (1.0, 5.0, 20.0):
            k = int(np.argmin(np.abs(time - instant)))
            rows.append([relaxation, f"{instant:g}", f"{with_log[k]:.1e}", f"{bare[k]:.1e}"])
        assert np.max(with_log[1:]) < 1e-3
        assert np.all(bare[1:] > with_log[1:])
    show("string without inertia", ("tau*", "t*", "(2.20) with its log term", "bare 1/3 law"), rows)
    assert float(rows[0][3]) > 0.01


def test_the_outer_solution_beats_the_third_law_for_the_full_filament_too() -> None:
    rows = []
    for name in ("maxwell-slow", "maxwell-fast"):
        run = descent(name)
        time = run.data.time.values / gravity_time(run.scene)
        sag = -run.data.midpoint.values / run.scene.filament.span
        relaxation = 0.35 if name == "maxwell-slow" else 0.035
        known = {B: LOAD, tau_star: relaxation}
        phi = np.geomspace(float(evaluate(far.ELASTIC_START, known)[0]), 5 * sag[-1], 20_000)
        outer = np.interp(time, evaluate(far.OUTER_TIME_FROM_REST, {**known, far.phi: phi}), phi / 4)
        law = -evaluate(far.THIRD_LAW, {**known, t_star: np.maximum(time, 1e-9)})
        late = time >= 4
        with_log, bare = (np.abs(curve[late] / sag[late] - 1) for curve in (outer, law))
        rows.append([name, f"{np.mean(with_log):.2%}", f"{np.mean(bare):.2%}"])
        assert np.all(with_log < bare)
    show("full model, mean difference over 4 < t* < 20", ("scene", "(2.20) with its log term", "bare 1/3 law"), rows)
