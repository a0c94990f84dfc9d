"""Orders of the compiled integrator, measured on exact solutions with steps of one length."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from tests.codegen import rosenbrock_library as rosenbrock
from tests.codegen.rosenbrock_library import RODAS3P, RODAS4, RODAS5P, Settings, fixed, integrate, problem, slopes

ORDER = {RODAS5P: 5.0, RODAS4: 4.0, RODAS3P: 3.0}
DENSE = {RODAS5P: 4.0, RODAS4: 3.0, RODAS3P: 3.0}


@pytest.fixture(scope="module")
def smooth_solution() -> np.ndarray:
    """Unknowns of the smooth problem at 0, 0.74 and 2, by an explicit method of order 8, shape (3, 2)."""
    solved = solve_ivp(
        lambda t, y: [-0.5 * y[0] ** 2 + math.cos(t) * y[0], -y[1] * y[0]],
        (0.0, 2.0),
        [1.0, 1.0],
        method="DOP853",
        rtol=1e-13,
        atol=1e-15,
        t_eval=[0.0, 0.74, 2.0],
    )
    return solved.y.T


@pytest.mark.parametrize("method", rosenbrock.METHODS)
def test_order_on_a_smooth_problem(method: int, smooth_solution: np.ndarray) -> None:
    """At the end, between the steps, and of the work, whose exact value is 1 - u."""
    ends, between, work = [], [], []
    for count in (16, 32, 64):
        run = integrate(problem("smooth"), [1.0, 1.0], [0.0, 0.74, 2.0], fixed(2.0 / count, method))
        assert (run.status.code, run.status.steps, run.status.rejected) == (rosenbrock.SOLVED, count, 0)
        errors = np.abs(run.states - smooth_solution).max(axis=1)
        ends.append(errors[2])
        between.append(errors[1])
        work.append(np.abs(run.work[:, 0] - (1.0 - smooth_solution[:, 1])).max())
    assert np.all(slopes(ends) > ORDER[method] - 0.1)
    assert np.all(slopes(between) > DENSE[method] - 0.1)
    assert np.all(slopes(work) > min(ORDER[method], DENSE[method]) - 0.1)
    assert ends[-1] < {RODAS5P: 1e-10, RODAS4: 1e-9, RODAS3P: 3e-6}[method]


@pytest.mark.parametrize("method", rosenbrock.METHODS)
def test_error_follows_the_tolerance(method: int, smooth_solution: np.ndarray) -> None:
    """A thousand times finer tolerance, a hundred times smaller error at least, near what was asked for."""
    errors = []
    for relative in (1e-4, 1e-7):
        run = integrate(
            problem("smooth"),
            [1.0, 1.0],
            [0.0, 0.74, 2.0],
            Settings(relative=relative, absolute=1e-2 * relative, method=method),
        )
        errors.append(np.abs(run.states - smooth_solution).max())
        assert errors[-1] < 30.0 * relative
    assert errors[1] < 0.01 * errors[0]


@pytest.mark.parametrize("method", rosenbrock.METHODS)
def test_dahlquist(method: int) -> None:
    """One step h = 1 of y' = lambda y: R(-1e8) vanishes, R is close to exp near 0, |R(iy)| <= 1."""
    decayed = integrate(problem("dahlquist", -1e8, 0.0), [1.0, 0.0], [0.0, 1.0], fixed(1.0, method)).state
    assert np.hypot(*decayed) < 1e-6
    for y in (0.1, 1.0, 3.0, 10.0, 1e2, 1e4, 1e8):
        turned = integrate(problem("dahlquist", 0.0, y), [1.0, 0.0], [0.0, 1.0], fixed(1.0, method)).state
        assert np.hypot(*turned) <= 1.0 + 1e-13
    small = integrate(problem("dahlquist", -0.01, 0.02), [1.0, 0.0], [0.0, 1.0], fixed(1.0, method)).state
    exact = np.exp(-0.01 + 0.02j)
    assert abs(complex(*small) - exact) < 0.1 * abs(-0.01 + 0.02j) ** (ORDER[method] + 1)


@pytest.mark.parametrize(("method", "order"), [(RODAS5P, 4.0), (RODAS4, 1.1), (RODAS3P, 3.0)])
def test_prothero_robinson(method: int, order: float) -> None:
    """Stiffness lambda h = -1e4 in every step; measured 4.1, 1.0 to 1.2, 3.0: Rodas4 loses its order."""
    errors = []
    for count in (16, 32, 64):
        stiff = problem("prothero", 1e4 * count / 2.0)
        run = integrate(stiff, [math.sin(0.25 * math.pi)], [0.0, 2.0], fixed(2.0 / count, method))
        errors.append(abs(run.state[0] - math.sin(2.0 + 0.25 * math.pi)))
    assert np.all(slopes(errors) > order - 0.2)


@pytest.mark.parametrize(("method", "least"), [(RODAS5P, 4.4), (RODAS4, 3.9), (RODAS3P, 2.8)])
def test_index_one(method: int, least: float) -> None:
    """Differential and algebraic unknown against the exact solution y = exp(-t) + sin(t), z = log(y)."""
    exact = math.exp(-2.0) + math.sin(2.0)
    errors = []
    for count in (16, 32, 64):
        run = integrate(problem("algebraic", 1.0), [1.0, 0.0], [0.0, 2.0], fixed(2.0 / count, method))
        assert run.status.code == rosenbrock.SOLVED
        errors.append(np.abs(run.state - [exact, math.log(exact)]).max())
    assert slopes(errors)[-1] > least


def test_units_of_an_algebraic_row_do_not_matter() -> None:
    """The row times 1e9 or 1e-9: the same steps, the same result to rounding."""
    runs = [
        integrate(problem("algebraic", scale), [1.0, 0.0], [0.0, 2.0], Settings(relative=1e-8))
        for scale in (1.0, 1e9, 1e-9)
    ]
    assert len({run.status.steps for run in runs}) == 1
    for run in runs[1:]:
        np.testing.assert_allclose(run.state, runs[0].state, rtol=1e-11)


@pytest.mark.parametrize("method", rosenbrock.METHODS)
def test_outputs_do_not_move_the_steps(method: int) -> None:
    """Dense output: a hundred times more outputs, the same steps and end; the work is cut, not changed."""
    few = integrate(problem("smooth"), [1.0, 1.0], [0.0, 2.0], Settings(method=method))
    many = integrate(problem("smooth"), [1.0, 1.0], np.linspace(0.0, 2.0, 101), Settings(method=method))
    assert many.status.steps == few.status.steps
    np.testing.assert_array_equal(many.states[-1], few.states[-1])
    np.testing.assert_array_equal(many.state, many.states[-1])
    np.testing.assert_allclose(many.work[-1], few.work[-1], rtol=1e-6)
