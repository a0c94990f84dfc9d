"""The right-hand side that rivals are given: exact Jacobian, held ends, and RK4 at its true stability limit."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SoftcatError
from softcat_sym.single_run import build
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.work_precision_programs import Bench, CompiledRates, Task, program_of, scene_of, stable_step

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")

SHORT = {"run.effects": "paper", "run.duration": "0.05 s", "run.frames": 6, "numerics.estimate": False}


def short_scene(**changes: object) -> sc.Scene:
    scene = sc.load_scene("continual-descent", {**SHORT, **changes})
    return scene.replace({"run.effects": list(choose_effects(scene).names)})


@pytest.fixture(scope="module")
def prepared() -> Prepared:
    task = Task("compiled-rodas5p", 12, 1.0, rtol=1e-9)
    scene = scene_of(short_scene(), task, program_of(task.program))
    return build(scene, choose_effects(scene))


def moved(prepared: Prepared, rates: CompiledRates) -> np.ndarray:
    solution = prepared.solve(Silence())
    whole = prepared.integration
    return whole.filament.sites.state(solution.x[:, -1], solution.z[:, -1]).ravel()  # type: ignore[union-attr]


def test_jacobian_is_that_of_differences_and_sparse_and_banded_agree(prepared: Prepared) -> None:
    rates = CompiledRates(prepared)
    state, step, time = moved(prepared, rates), 1e-7, float(prepared.times[-1])
    columns = [
        (rates.rates(time, state + step * unit) - rates.rates(time, state - step * unit)) / (2 * step)
        for unit in np.eye(rates.size)
    ]
    expected = np.array(columns).T
    sparse = rates.sparse(time, state).toarray()
    rows, across = np.nonzero(sparse)
    np.testing.assert_allclose(
        sparse, np.where(sparse != 0, expected, 0), rtol=1e-5, atol=1e-6 * np.abs(expected).max()
    )
    live = np.abs(sparse).sum(axis=1) > 0
    np.testing.assert_allclose(
        sparse[np.ix_(live, live)], expected[np.ix_(live, live)], rtol=1e-5, atol=1e-6 * np.abs(expected).max()
    )
    packed = rates.banded(time, state)
    np.testing.assert_array_equal(packed[rows - across + rates.band, across], sparse[rows, across])
    assert np.count_nonzero(packed) == len(rows)


def test_what_is_held_does_not_move(prepared: Prepared) -> None:
    rates = CompiledRates(prepared)
    state = moved(prepared, rates)
    still = rates.rates(0.0, state) == 0
    assert rates.size - prepared.graph.x.numel() <= np.count_nonzero(still)


@pytest.mark.parametrize(("matrix", "step"), [([[0, 1], [-25, 0]], 8**0.5 / 5), ([[-4.0]], 2.785293563405282 / 4)])
def test_stable_step_of_a_spring_and_of_a_decay(matrix: list[list[float]], step: float) -> None:
    """The ends of RK4's region of stability: 2 sqrt 2 on the imaginary axis, 2.7853 on the real one."""
    assert stable_step(np.array(matrix, dtype=float)) == pytest.approx(step, rel=1e-4)


def test_nothing_that_moves_has_no_max_step() -> None:
    assert stable_step(np.zeros((2, 2))) == np.inf


@pytest.mark.parametrize("program", ["compiled-rk4", "numpy-rk4"])
def test_rk4_agrees_below_its_limit_and_is_lost_above_it(program: str, prepared: Prepared) -> None:
    bench = Bench(short_scene(), 60.0)
    exact = bench.ready(Task("compiled-rodas5p", 12, 1.0, rtol=1e-9))().midpoint
    found = bench.ready(Task(program, 12, 1.0, rtol=0.95))().midpoint
    assert np.abs(found - exact).max() < 1e-6 * np.abs(exact).max()
    # Beyond it the shortest wave grows, until large rotations bound it or nothing is finite any more.
    try:
        lost = bench.ready(Task(program, 12, 1.0, rtol=1.3))().midpoint
    except SoftcatError as error:
        assert "not finite" in str(error)
    else:
        assert np.abs(lost - exact).max() > 1e-4 * np.abs(exact).max()


@pytest.mark.parametrize("program", ["compiled-rodas4", "scipy-radau", "scipy-bdf", "scipy-lsoda", "cvodes-5"])
def test_programs_solve_the_same_equations(program: str) -> None:
    if program.startswith("scipy"):
        pytest.importorskip("scipy")
    bench = Bench(short_scene(), 60.0)
    exact = bench.ready(Task("compiled-rodas5p", 12, 4.0, rtol=1e-9))().midpoint
    found = bench.ready(Task(program, 12, 4.0, rtol=1e-6))().midpoint
    assert np.abs(found - exact).max() < 1e-4 * np.abs(exact).max()


@pytest.mark.parametrize("program", ["compiled-rk4", "scipy-radau"])
def test_algebraic_unknowns_are_refused(program: str) -> None:
    scene = short_scene()
    scene = scene.replace({"run.effects": [*scene.run.effects, "shear"]})
    with pytest.raises(SoftcatError, match=r"cannot: .* algebraic unknowns"):
        Bench(scene, 60.0).ready(Task(program, 12, 1.0, section=2))


def test_what_would_take_too_long_is_not_begun() -> None:
    with pytest.raises(SoftcatError, match="steps would take"):
        Bench(short_scene(), 1e-4).ready(Task("compiled-rk4", 40, 4.0, rtol=0.95))
