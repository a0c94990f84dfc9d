"""The paper's filaments: against converged values of other programs, its formulas, and the exact limits beside them."""

from __future__ import annotations

from functools import cache

import numpy as np

import softcat_sym as sc
from softcat_sym.discretization.casadi_printer import evaluate
from softcat_sym.physics import closed_forms as far
from softcat_sym.physics.regimes import tau_star
from softcat_sym.physics.rheometry import B, t_star
from softcat_sym.scene.scene import gravity_time
from tests.common.rheology import Array, scene, solved
from tests.common.table import show

CONVERGED = {
    ("arrested-overdamped", "material"): (-0.06256, -0.06386, -0.06534, -0.0666),
    ("arrested-overdamped", "printed"): (-0.06240, -0.06368, -0.06512, -0.0664),
    ("continual-descent", "material"): (-0.12148, -0.16379, -0.20092, -0.24409),
    ("continual-descent", "printed"): (-0.12183, -0.16497, -0.20339, -0.24978),
}
FRAMES = [20, 50, 100, 200]
"""At t~ = (t/L) sqrt(E/rho) = 46, 115, 230, 460; the runs end at 460 with 201 frames."""


@cache
def run(name: str, **numerics: object) -> sc.Run:
    """A bundled scene with the published effects, without an estimate; the same is not run twice."""
    changes = {f"numerics.{key}": value for key, value in numerics.items()}
    return sc.simulate(sc.load_scene(name, {"run.effects": "paper", "numerics.estimate": False, **changes}))


def test_midpoint_is_within_half_a_percent_of_the_converged_value() -> None:
    rows = []
    for (name, closure), expected in CONVERGED.items():
        changes = {"run.effects": "paper", "run.closure": closure, "numerics.cells": 80, "numerics.estimate": False}
        found = sc.simulate(sc.load_scene(name, changes))
        midpoint = found.data.midpoint.values[FRAMES] / found.scene.filament.span
        error = midpoint / np.array(expected) - 1
        rows.append([name, closure, *(f"{m:.5f} ({e:+.2%})" for m, e in zip(midpoint, error, strict=True))])
        assert found.outcome is sc.Outcome.solved
        assert np.max(np.abs(error)) < 0.005
    show("midpoint/L, and its difference from the converged", ("scene", "closure", "46", "115", "230", "460"), rows)


def test_edge_of_rupture_is_refused_as_localised() -> None:
    # The estimate stays: it is what finds that the answer depends on the grid.
    changes = {"run.effects": "paper", "numerics.grading": 1.0}
    runs = [sc.simulate(sc.load_scene("edge-of-rupture", {**changes, "numerics.cells": n})) for n in (20, 40, 80)]
    sags = [-found.summary["midpoint_final_m"] / found.scene.filament.span for found in runs]
    rows = [[found.summary["cells"], f"{sag:.3g}", found.outcome.name] for found, sag in zip(runs, sags, strict=True)]
    show("edge-of-rupture: the answer depends on the grid", ("N", "sag/L at 460", "outcome"), rows)
    assert runs[-1].outcome is sc.Outcome.localised and not runs[-1].outcome.is_success
    # The runs end where the neck cannot bear what hangs on it any more, not at one time.
    assert min(sags[1:]) > 5 * sags[0]


def test_no_yield_oscillates_without_yielding_and_keeps_its_energy() -> None:
    rows, residuals = [], []
    for rtol in (1e-3, 1e-4, 1e-5):
        found = run("no-yield", rtol=rtol)
        turns = int(np.sum(np.diff(np.sign(np.diff(found.data.midpoint.values))) != 0))
        residuals.append(found.summary["energy_residual"])
        rows.append([f"{rtol:g}", f"{residuals[-1]:.1e}", turns, found.summary["regime"], found.summary["steps"]])
        assert found.outcome is sc.Outcome.solved
        assert found.summary["regime"] == "no-yield"
        assert float(found.data.yielded_fraction.max()) == float(found.data.plastic_rate.max()) == 0.0
        assert turns >= 38  # 20 periods in the run
    show("no-yield", ("rtol", "energy residual", "turning points", "regime", "steps"), rows)
    assert residuals[1] < 1e-4
    assert residuals[0] > residuals[1] > residuals[2]


def test_first_period_of_a_thin_stiff_filament_is_that_of_the_clamped_beam() -> None:
    thickness, E = 5e-3, 200e9
    asked = scene(
        {"law": "elastic", "youngs_modulus": E},
        {"thickness": thickness},
        effects="auto",
        load={"gravity": 9.81},
        run={"duration": 0.2, "frames": 401},
    )
    data = solved(asked.replace({"numerics": {"estimate": False}}))
    time, static = data.time.values, data.midpoint.values - data.midpoint.values.mean()
    up = np.flatnonzero((static[:-1] < 0) & (static[1:] >= 0))
    crossings = time[up] - static[up] * np.diff(time)[up] / np.diff(static)[up]
    period = float(np.mean(np.diff(crossings)))
    exact = 2 * np.pi / (4.730041**2 * np.sqrt(E * thickness**2 / 12 / 1000))
    print(f"\nthin stiff clamped rod: {period:.6f} s, clamped beam {exact:.6f} s, {period / exact - 1:+.3%}")
    assert abs(period / exact - 1) < 0.005


LOAD = 3.3e-5
"""B of the Maxwell scenes."""
RELAXATION = {"maxwell-slow": 0.35, "maxwell-fast": 0.035}


@cache
def descent(name: str, model: str = "filament") -> sc.Run:
    """A Maxwell scene run once."""
    changes = {"model": model, "numerics.cells": 40, "numerics.estimate": False}
    return sc.simulate(sc.load_scene(name, changes))


def histories(found: sc.Run) -> tuple[Array, Array]:
    """t* and sag/L."""
    return found.data.time.values / gravity_time(found.scene), -found.data.midpoint.values / found.scene.filament.span


def published(time: Array, relaxation: float, deepest: float) -> tuple[Array, Array]:
    """The outer solution (2.20) with its log term, and the bare 1/3 law."""
    known = {B: LOAD, tau_star: relaxation}
    phi = np.geomspace(float(evaluate(far.ELASTIC_START, known)[0]), deepest, 20_000)
    outer = np.interp(time, evaluate(far.OUTER_TIME_FROM_REST, {**known, far.phi: phi}), phi / 4)
    return outer, -evaluate(far.THIRD_LAW, {**known, t_star: np.maximum(time, 1e-9)})


def test_full_and_reduced_model_agree_within_two_percent_while_the_sag_is_small() -> None:
    rows = []
    for name in RELAXATION:
        full, reduced = descent(name), descent(name, "small-deflection")
        assert full.outcome is reduced.outcome is sc.Outcome.solved
        sag, other = histories(full)[1], histories(reduced)[1]
        small = (sag > 0) & (sag < 0.03)
        worst = float(np.max(np.abs(other - sag)[small]) / np.max(sag[small]))
        rows.append([name, f"{worst:.2%}", f"{abs(other[-1] / sag[-1] - 1):.2%}", f"{sag[-1]:.4f}"])
        assert worst < 0.02
    show("full and reduced model", ("scene", "difference while sag < 0.03 L", "at the end", "sag/L there"), rows)


def test_their_relative_difference_grows_as_the_square_of_the_sag() -> None:
    sags, differences = [], []
    exact = ["bending", "finite-stretch", "thinning", "large-rotation"]
    for modulus in np.geomspace(3e5, 3e8, 7):
        material = {"law": "elastic", "youngs_modulus": float(modulus)}
        asked = scene(material, {"thickness": 0.25e-3}, effects="auto", load={"gravity": 9.81}, cells=40)
        full, reduced = (
            -float(solved(asked.replace({"model": model, "run.effects": effects}))["midpoint"][-1])
            for model, effects in (("filament", exact), ("small-deflection", ["bending"]))
        )
        sags.append(full)
        differences.append(abs(reduced / full - 1))
    slopes = np.diff(np.log(differences)) / np.diff(np.log(sags))
    fitted = float(np.polyfit(np.log(sags), np.log(differences), 1)[0])
    rows = [[f"{s:.4f}", f"{d:.2e}"] for s, d in zip(sags, differences, strict=True)]
    show(f"static elastic filament: slope {fitted:.3f}", ("sag/L", "relative difference"), rows)
    assert abs(fitted - 2) < 0.1
    assert np.all(np.abs(slopes - 2) < 0.15)


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
            "numerics.estimate": False,
        }
        found = sc.simulate(sc.load_scene("maxwell-slow", changes))
        assert found.outcome is sc.Outcome.solved
        time, sag = histories(found)
        with_log, bare = (np.abs(curve / sag - 1) for curve in published(time, relaxation, 4.5 * sag[-1]))
        for instant in (1.0, 5.0, 20.0):
            k = int(np.argmin(np.abs(time - instant)))
            rows.append([relaxation, f"{instant:g}", f"{with_log[k]:.1e}", f"{bare[k]:.1e}"])
        assert np.max(with_log[1:]) < 1e-3
        assert np.all(bare[1:] > with_log[1:])
    show("string without inertia", ("tau*", "t*", "(2.20) with its log term", "bare 1/3 law"), rows)
    assert float(rows[0][3]) > 0.01


def test_the_outer_solution_beats_the_third_law_for_the_full_filament_too() -> None:
    rows = []
    for name, relaxation in RELAXATION.items():
        time, sag = histories(descent(name))
        late = time >= 4
        with_log, bare = (np.abs(curve[late] / sag[late] - 1) for curve in published(time, relaxation, 5 * sag[-1]))
        rows.append([name, f"{np.mean(with_log):.2%}", f"{np.mean(bare):.2%}"])
        assert np.all(with_log < bare)
    show("full model, mean difference over 4 < t* < 20", ("scene", "(2.20) with its log term", "bare 1/3 law"), rows)
