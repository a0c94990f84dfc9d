"""Independent integrators find the same motion; a run without inertia begins at rest in equilibrium."""

from __future__ import annotations

from functools import cache

import casadi as ca
import numpy as np
import pytest

from softcat_sym.discretization.assembly import energy_scale
from softcat_sym.discretization.grid import Floats
from softcat_sym.solvers.initial_state import Equilibrium, sagging_guesses
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Silence, Solution

from .filaments import midpoint, prepared, scene_of, without


@cache
def tight(law: str, solver: str, inertia: bool) -> tuple[Floats, Solution]:
    scene = scene_of(law) if inertia else without(scene_of(law), "inertia")
    run = prepared(scene, solver=solver, rtol=1e-8, atol=1e-10)
    solution = run.solve(Silence())
    assert solution.outcome is Outcome.solved
    return midpoint(run, solution.x if inertia else solution.z), solution


@pytest.mark.parametrize("law", ["elastic", "maxwell", "bingham"])
def test_cvodes_and_rosenbrock_find_the_same_motion(law: str) -> None:
    (one, _), (two, _) = (tight(law, solver, True) for solver in ("cvodes", "rosenbrock"))
    assert np.max(np.abs(two)) > 1e-4
    np.testing.assert_allclose(one, two, rtol=0, atol=2e-5 * np.max(np.abs(two)))


@pytest.mark.parametrize("law", ["maxwell", "bingham"])
def test_idas_and_rosenbrock_find_the_same_creep(law: str) -> None:
    (one, first), (two, second) = (tight(law, solver, False) for solver in ("idas", "rosenbrock"))
    assert np.max(np.abs(two)) > 1e-4
    np.testing.assert_allclose(one, two, rtol=0, atol=2e-6 * np.max(np.abs(two)))
    np.testing.assert_allclose(first.quad, second.quad, rtol=0, atol=1e-5 * np.max(np.abs(second.quad)))


@pytest.mark.parametrize("accuracy", [1e-2, 1e-3])
def test_looser_tolerances_lie_within_the_accuracy_of_the_tight_ones(accuracy: float) -> None:
    wanted, _ = tight("bingham", "rosenbrock", True)
    for solver in ("cvodes", "rosenbrock"):
        run = prepared(scene_of().replace({"run.accuracy": accuracy}), solver=solver)
        found = midpoint(run, run.solve(Silence()).x)
        np.testing.assert_allclose(found, wanted, rtol=0, atol=accuracy * np.max(np.abs(wanted)))


def test_without_inertia_a_run_begins_in_equilibrium() -> None:
    for law in ["elastic", "bingham"]:
        for ramp in ["0 s", "0.04 s"]:
            run = prepared(without(scene_of(law, ramp=ramp), "inertia"))
            graph = run.graph
            assert run.start is not None
            forces = ca.Function("forces", [graph.t, graph.x, graph.z, graph.p], [graph.alg])
            left = np.abs(np.asarray(forces(0.0, graph.start, run.start.z, run.p))).max()
            straight = np.abs(np.asarray(forces(1e9, graph.start, graph.straight, run.p))).max()
            assert left <= 1e-8 * straight
            assert midpoint(run, run.start.z) == pytest.approx(
                0 if ramp != "0 s" else midpoint(run, run.start.z), abs=1e-12
            )
            assert midpoint(run, run.start.z) < 0 or ramp != "0 s"


def test_every_frame_of_a_creeping_run_is_in_equilibrium() -> None:
    run = prepared(without(scene_of(), "inertia"), rtol=1e-8, atol=1e-10)
    graph, solution = run.graph, run.solve(Silence())
    forces = ca.Function("forces", [graph.t, graph.x, graph.z, graph.p], [graph.alg])
    size = np.abs(np.asarray(forces(1e9, graph.start, graph.straight, run.p))).max()
    for k, time in enumerate(solution.time):
        left = np.abs(np.asarray(forces(time, solution.x[:, k], solution.z[:, k], run.p))).max()
        assert left <= 1e-5 * size


def test_slow_loading_with_inertia_ends_near_the_equilibrium_without() -> None:
    """An elastic filament that is loaded over many of its periods follows its equilibria."""
    slow = scene_of("elastic", frames=5, duration="2 s", ramp="2 s")
    moving = prepared(slow, solver="rosenbrock", rtol=1e-6, atol=1e-9)
    still = prepared(without(slow, "inertia"))
    one = midpoint(moving, moving.solve(Silence()).x)
    two = midpoint(still, still.solve(Silence()).z)
    np.testing.assert_allclose(one, two, rtol=0, atol=5e-3 * abs(two[-1]))


def test_the_work_of_a_march_is_the_energy_it_stores() -> None:
    """A sequence of equilibria of an elastic filament: work of the load = elastic + potential energy."""
    scene = without(scene_of("elastic", frames=41), "inertia")
    run = prepared(scene)
    solution = run.solve(Silence())
    seen = run.graph.observe(solution.time, solution.x, solution.z, run.p)
    stored = (seen["energy_elastic"] + seen["energy_potential"])[:, 0]
    span = scene.filament.span
    work = solution.quad[1] * energy_scale(scene.filament.density, span, run.scale) * span
    assert abs(work[-1]) > 0
    np.testing.assert_allclose(work, stored - stored[0], rtol=0, atol=2e-3 * np.max(np.abs(stored)))


def test_guesses_sag() -> None:
    run = prepared(without(scene_of(), "inertia"))
    guesses = sagging_guesses(run.graph, run.graph.straight, 0.1)
    assert [float(midpoint(run, guess)) for guess in guesses] == pytest.approx([-0.1, -0.025, 0, -0.3])
    for guess in guesses:
        moved = guess - run.graph.straight
        assert all(shift == 0 for shift, name in zip(moved, run.graph.algebraic_names, strict=True) if name[0] == "x")


def test_no_guess_is_no_equilibrium() -> None:
    run = prepared(without(scene_of(), "inertia"))
    search = Equilibrium(run.graph).search
    assert search(0.0, run.graph.start, run.p, []) is None
    assert search(0.0, run.graph.start, run.p, [np.full(run.graph.straight.shape, np.nan)]) is None
