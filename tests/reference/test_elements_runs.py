"""Runs of the elements over scenes: energies, steps, meshes, what is recorded, what is refused."""

from __future__ import annotations

from dataclasses import fields

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.reference.element_loop import Clamp, Mesh
from softcat_sym.reference.elements import ElementRun, March, run_elements
from tests.acceptance.table import show
from tests.reference.strips import shortened

COARSE = Mesh(24, 2)
YIELDING = shortened(sc.load_scene("continual-descent"), 15.0, 6)
STIFF = shortened(sc.load_scene("arrested-underdamped"), 15.0, 6)
ELASTIC = shortened(sc.load_scene("no-yield", {"load.ramp": "0 s"}), 15.0, 6)
SPAN = YIELDING.filament.span


def drop(run: ElementRun) -> float:
    return float(run.midpoint[-1]) / SPAN


@pytest.fixture(scope="module")
def descent() -> ElementRun:
    return run_elements(YIELDING, COARSE)


def test_energy_is_balanced_and_half_the_step_changes_nothing(descent: ElementRun) -> None:
    rows = []
    for name, scene in (("elastic", ELASTIC), ("yielding", YIELDING), ("yielding, stiff flow", STIFF)):
        whole = descent if scene is YIELDING else run_elements(scene, COARSE)
        half = run_elements(scene, COARSE, step_factor=0.5)
        change = abs(drop(half) - drop(whole))
        rows.append(
            (name, f"{drop(whole):.6f}", f"{whole.energy_error:.1e}", f"{half.energy_error:.1e}", f"{change:.1e}")
        )
        assert whole.energy_error < 1e-4
        assert half.energy_error < 0.6 * whole.energy_error
        assert change < 1e-5
        assert 1.95 < half.steps / whole.steps < 2.05
    show(
        "Energy error over work; change of midpoint/L by half the step",
        ["case", "midpoint/L", "h", "h/2", "change"],
        rows,
    )


def test_energies_are_of_the_whole_filament(descent: ElementRun) -> None:
    stored = descent.energy_kinetic + descent.energy_elastic + descent.energy_potential + descent.energy_dissipated
    assert descent.energy_residual == pytest.approx(stored - descent.work_external, abs=1e-12 * descent.work)
    filament = YIELDING.filament
    weight = filament.density * YIELDING.load.gravity * filament.span * filament.thickness * filament.width
    mean = np.trapezoid(descent.y, descent.X, axis=1)[-1] / (filament.span / 2)
    assert descent.energy_potential[-1] == pytest.approx(weight * mean, rel=5e-3)
    assert descent.energy_dissipated[-1] > 3 * descent.energy_elastic[-1] > 0
    assert np.all(np.diff(descent.energy_dissipated) >= 0)


def test_what_is_recorded(descent: ElementRun) -> None:
    assert descent.time == pytest.approx(np.linspace(0, YIELDING.run.duration, 6))
    assert descent.time[-1] / descent.elastic_time == pytest.approx(15.0)
    assert descent.x.shape == descent.y.shape == (6, 49)
    assert descent.X == pytest.approx(np.linspace(0, SPAN / 2, 49))
    assert np.all(descent.midpoint == descent.y[:, 0])
    assert np.all(descent.x[:, 0] == 0)
    assert np.all(descent.y[:, -1] == 0)
    assert descent.thinning[0] == 1
    assert 0.9 < descent.thinning[-1] < 0.999
    assert 0 < descent.clamp_strain[-1] < descent.clamp_strain_largest[-1]
    assert descent.rate.shape == (6, 48, 4)
    assert descent.rate_time == pytest.approx(descent.time)
    assert descent.point.shape == (48, 4, 2)
    # Dissipation is sY + eta rate times the rate, at each point that flows.
    material = YIELDING.material
    assert material.viscosity is not None and material.yield_stress is not None
    power = (material.yield_stress + material.viscosity * descent.rate[-1]) * descent.rate[-1]
    volume = SPAN * YIELDING.filament.thickness * YIELDING.filament.width / descent.rate[-1].size
    earlier = run_elements(shortened(YIELDING, 14.9, 2), COARSE)
    rate = (descent.energy_dissipated[-1] - earlier.energy_dissipated[-1]) / (descent.time[-1] - earlier.time[-1])
    assert power.sum() * volume == pytest.approx(rate, rel=2e-2)
    # Everything finite, everything there.
    for field in fields(descent):
        value = getattr(descent, field.name)
        if isinstance(value, np.ndarray):
            assert np.all(np.isfinite(value)), field.name
    # 49 x 5 lattice points without the middles; symmetry holds 5, the face 10 less its thinning.
    assert descent.dofs == 2 * (49 * 5 - 48) - 5 - 10 + 1
    assert descent.wall > 0


def test_fixing_the_whole_face_is_stiffer(descent: ElementRun) -> None:
    fixed = run_elements(YIELDING, COARSE, clamp=Clamp.FIXED)
    assert np.all(fixed.thinning == 1)
    ratio = drop(fixed) / drop(descent)
    print(f"\nmidpoint: thinning {drop(descent):.6f}, fixed {drop(fixed):.6f} ({100 * (ratio - 1):+.3f} %)")
    assert 0.99 < ratio < 0.9999


def test_grading_helps_at_the_clamp() -> None:
    fine = drop(run_elements(YIELDING, Mesh(48, 2)))
    equal, graded = (drop(run_elements(YIELDING, Mesh(16, 2, grading=g))) for g in (1.0, 3.0))
    print(f"\n48 x 2 {fine:.6f}; 16 x 2 equal {equal:.6f}, graded {graded:.6f}")
    assert abs(graded - fine) < 0.7 * abs(equal - fine)


def test_meshes_converge() -> None:
    rows = []
    for name, scene in (("elastic", ELASTIC), ("yielding", YIELDING)):
        found = [drop(run_elements(scene, Mesh(*m))) for m in ((8, 2), (16, 4), (24, 6))]
        first, second = abs(found[1] - found[0]), abs(found[2] - found[1])
        rows.append((name, *(f"{y:.6f}" for y in found), f"{first / second:.2f}"))
        # Even at first order the ratio would be 3.
        assert first > 3 * second
    show("Midpoint/L on meshes of one shape", ["case", "8 x 2", "16 x 4", "24 x 6", "ratio of differences"], rows)


@pytest.mark.slow
def test_the_meshes_of_the_comparison_converge() -> None:
    rows = []
    for name, scene in (("elastic", ELASTIC), ("yielding", YIELDING)):
        found = [drop(run_elements(scene, Mesh(*m))) for m in ((32, 2), (64, 4), (96, 6))]
        rows.append((name, *(f"{y:.6f}" for y in found)))
        assert abs(found[2] - found[1]) < abs(found[1] - found[0])
        assert abs(found[2] - found[1]) < 1e-3 * abs(found[2])
    show("Midpoint/L at 15 elastic times", ["case", "32 x 2", "64 x 4", "96 x 6"], rows)


def test_without_gravity_nothing_moves() -> None:
    run = run_elements(YIELDING.replace({"load.gravity": "0 m/s^2", "run.duration": "1 ms"}), Mesh(2, 2))
    assert np.all(run.midpoint == 0)
    assert run.energy_error == 0


def test_a_step_beyond_the_stable_one_is_refused_not_returned(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("softcat_sym.reference.elements.SAFETY", 1.3)
    with pytest.raises(SoftcatError, match=r"shorten the steps"):
        run_elements(ELASTIC, COARSE)


def test_energies_that_do_not_add_up_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("softcat_sym.reference.elements._UNBALANCED", 1e-9)
    with pytest.raises(SoftcatError, match="energies miss the work of gravity"):
        run_elements(YIELDING, COARSE)


def test_the_step_follows_the_strip_as_it_thins(monkeypatch: pytest.MonkeyPatch) -> None:
    steps: list[float] = []
    advance = March.advance

    def watched(self: March) -> None:
        steps.append(self.step)
        advance(self)

    monkeypatch.setattr(March, "advance", watched)
    run_elements(shortened(YIELDING, 46.0, 3), Mesh(24, 2))
    assert 0.8 < steps[-1] / steps[0] < 0.99


@pytest.mark.parametrize(
    ("changes", "paths"),
    [
        ({"model": "small-deflection"}, ["model"]),
        ({"ends.left": "pinned", "ends.right": "pinned"}, ["ends.left", "ends.right"]),
    ],
)
def test_scenes_that_the_elements_do_not_know_are_refused(changes: dict[str, object], paths: list[str]) -> None:
    scene = sc.load_scene("maxwell-slow") if "model" in changes else YIELDING
    with pytest.raises(SceneError) as refusal:
        run_elements(scene.replace(changes), COARSE)
    assert [fault.path for fault in refusal.value.faults] == paths


def test_a_circle_is_refused() -> None:
    with pytest.raises(SceneError, match=r"filament\.section"):
        run_elements(sc.load_scene("ink-bridge"), COARSE)


def test_step_factors_beyond_the_stable_step_are_refused() -> None:
    for factor in [0.0, -1.0, 1.5, float("nan")]:
        with pytest.raises(SoftcatError, match="step_factor"):
            run_elements(YIELDING, COARSE, step_factor=factor)
