"""IPOPT's optimum against SciPy's, and what it does with noise, holes and exceptions."""

from __future__ import annotations

import os
import signal

import numpy as np
import pytest
from scipy.optimize import least_squares

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.least_squares import Loss, check_derivatives, minimise
from tests.inverse.problems import Problem, decay, line, problem, product, saturation, unused

PROBLEMS = [
    ("offset slope", line, [1.0, 2.0], 0.1),
    ("A k", decay, [0.5, 0.2], 0.01),
    ("A k", decay, [0.5, 0.2], 1e-4),
    ("v K", saturation, [0.5, 0.2], 0.01),
]


def scipy_optimum(p: Problem, start: list[float], loss: str = "linear", scale: float = 1.0):
    return least_squares(
        p.residuals,
        start,
        jac=lambda q: p.linearised(q)[1],
        bounds=(p.lower, p.upper),
        loss=loss,
        f_scale=scale,
        xtol=1e-15,
        ftol=1e-15,
        gtol=1e-15,
    )


@pytest.mark.parametrize("start", [0.0, 2.0, -3.0])
@pytest.mark.parametrize("seed", [0, None])
@pytest.mark.parametrize(("names", "model", "truth", "std"), PROBLEMS)
def test_optimum_is_that_of_scipy(names, model, truth, std, seed, start) -> None:
    p = problem(names, model, truth, std, seed)
    found = minimise(p, np.full(2, start))
    asked = len(p.asked)
    other = scipy_optimum(p, [start, start])
    assert found.converged
    assert found.value <= other.cost * (1 + 1e-9) + 1e-9
    np.testing.assert_allclose(found.q, other.x, atol=1e-7)
    assert found.evaluations == asked <= 20
    assert len({point.tobytes() for point in p.asked[:asked]}) == asked
    assert not found.at_bound.any()


@pytest.mark.parametrize(("kind", "scale"), [("soft-l1", 2.0), ("cauchy", 2.0), ("cauchy", 0.5)])
def test_robust_losses_are_those_of_scipy(kind: str, scale: float) -> None:
    p = problem("A k", decay, [0.5, 0.2], 0.01)
    p.data[::7] += 1
    found = minimise(p, np.array([0.4, 0.0]), loss=Loss(kind, scale))
    other = scipy_optimum(p, [0.4, 0.2], kind.replace("-", "_"), scale)
    assert found.converged
    np.testing.assert_allclose(found.q, other.x, atol=1e-6)
    assert found.value == pytest.approx(other.cost, rel=1e-9)
    plain = minimise(p, np.array([0.4, 0.0]))
    assert np.abs(found.q - [0.5, 0.2]).max() < 0.02 < np.abs(plain.q - [0.5, 0.2]).max()


@pytest.mark.parametrize("kind", ["linear", "soft-l1", "cauchy"])
def test_weights_and_curvatures_are_derivatives_of_the_loss(kind: str) -> None:
    loss = Loss(kind, 1.7)
    for r in (-1.5, -0.1, 0.3, 1.2):
        h = 1e-4
        low, middle, high = (loss.value(np.array([r + s])) for s in (-h, 0.0, h))
        assert (high - low) / (2 * h) == pytest.approx(float(loss.weights(np.array([r]))[0]) * r, rel=1e-6)
        assert (high - 2 * middle + low) / h**2 == pytest.approx(float(loss.curvatures(np.array([r]))[0]), rel=1e-5)


def test_a_bound_holds_the_optimum() -> None:
    p = problem("A k", decay, [0.5, 0.2], 0.01)
    p.upper = np.array([6.0, 0.0])
    found = minimise(p, np.array([-2.0, -4.0]))
    np.testing.assert_allclose(found.q, scipy_optimum(p, [0.0, -1.0]).x, atol=1e-5)
    assert found.converged
    assert found.at_bound.tolist() == [False, True]
    assert np.all(np.array(p.asked) <= p.upper)


@pytest.mark.parametrize("model", [product, unused])
def test_what_is_not_identified_does_not_stop_the_fit(model) -> None:
    p = problem("A a b", model, [0.5, 0.2, 0.3], 0.01)
    for start in (np.zeros(3), np.full(3, -3.0)):
        found = minimise(p, start)
        assert found.converged
        assert found.value == pytest.approx(scipy_optimum(p, start.tolist()).cost, rel=1e-9)


@pytest.mark.parametrize("noise", [1e-9, 1e-7, 1e-5])
@pytest.mark.parametrize("start", [-3.0, 0.0, 2.0])
def test_noise_of_the_model_does_not_stall_the_fit(noise: float, start: float) -> None:
    def noisy(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, derivatives = decay(q)
        random = np.random.default_rng(np.frombuffer(q.tobytes(), dtype=np.uint32))
        errors = random.standard_normal((values.size, 3))
        return values * (1 + noise * errors[:, 0]), derivatives * (1 + 10 * noise * errors[:, 1:])

    exact = problem("A k", decay, [0.5, 0.2], 0.01)
    p = Problem(exact.names, exact.lower, exact.upper, noisy, exact.data, exact.std)
    reference = minimise(exact, np.zeros(2))
    errors = np.sqrt(np.diag(np.linalg.inv(reference.jacobian.T @ reference.jacobian)))
    found = minimise(p, np.full(2, start))
    assert found.converged
    assert np.all(np.abs(found.q - reference.q) < 0.05 * errors)
    assert found.evaluations < 60


def test_ipopt_steps_back_where_the_model_has_no_answer() -> None:
    def partly(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, derivatives = decay(q)
        return (values if q[1] < 0.5 else values * np.nan), derivatives

    exact = problem("A k", decay, [0.5, 0.2], 0.01)
    p = Problem(exact.names, exact.lower, exact.upper, partly, exact.data, exact.std)
    for start in ([-2.0, -4.0], [-3.0, -3.0], [-4.0, 0.0]):
        found = minimise(p, np.array(start))
        assert found.converged
        np.testing.assert_allclose(found.q, minimise(exact, np.zeros(2)).q, atol=1e-6)
    assert any(q[1] >= 0.5 for q in p.asked)
    with pytest.raises(SoftcatError, match="no answer"):
        minimise(p, np.array([0.0, 1.0]))


@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt, SystemExit])
@pytest.mark.parametrize("when", [1, 2, 5])
def test_what_the_model_raises_reaches_the_caller(error: type[BaseException], when: int) -> None:
    def failing(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        if len(p.asked) == when:
            raise error("deep inside")
        return decay(q)

    exact = problem("A k", decay, [0.5, 0.2], 0.01)
    p = Problem(exact.names, exact.lower, exact.upper, failing, exact.data, exact.std)
    with pytest.raises(error, match="deep inside"):
        minimise(p, np.array([-2.0, -4.0]))
    assert len(p.asked) == when


def test_ctrl_c_interrupts() -> None:
    def pressed(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        if len(p.asked) == 4:
            os.kill(os.getpid(), signal.SIGINT)
        return decay(q)

    exact = problem("A k", decay, [0.5, 0.2], 0.01)
    p = Problem(exact.names, exact.lower, exact.upper, pressed, exact.data, exact.std)
    with pytest.raises(KeyboardInterrupt):
        minimise(p, np.array([-2.0, -4.0]))
    assert len(p.asked) == 4


def test_a_fit_that_is_cut_short_is_no_success() -> None:
    found = minimise(problem("A k", decay, [0.5, 0.2], 0.01), np.array([-5.0, -5.0]), max_evaluations=3)
    assert not found.converged
    assert found.status == "Maximum_Evaluations_Exceeded"
    assert found.evaluations == 3


def test_the_fit_is_quiet(capfd: pytest.CaptureFixture[str]) -> None:
    p = problem("A k", decay, [0.5, 0.2], 0.01)
    minimise(p, np.zeros(2))
    check_derivatives(p, np.zeros(2))
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("model", [decay, saturation])
def test_derivative_checker_is_clean_and_sees_a_wrong_derivative(model) -> None:
    p = problem("one two", model, [0.5, 0.2], 0.01)
    checked = check_derivatives(p, np.array([0.3, -0.4]))
    assert checked.clean, checked.text

    def wrong(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        values, derivatives = model(q)
        return values, derivatives * [1.0, 1.01]

    p.model = wrong
    checked = check_derivatives(p, np.array([0.3, -0.4]))
    assert not checked.clean
    assert "grad_f" in checked.text


def test_a_start_outside_the_box_is_refused() -> None:
    p = problem("A k", decay, [0.5, 0.2], 0.01)
    with pytest.raises(SoftcatError, match=r"k: starts at q = 7; accepted: between -6 and 6"):
        minimise(p, np.array([0.0, 7.0]))
    with pytest.raises(SoftcatError, match="1 starting values for 2 unknowns"):
        minimise(p, np.zeros(1))
    with pytest.raises(SoftcatError, match="inside the box"):
        check_derivatives(p, np.array([0.0, 6.0]))
    with pytest.raises(SoftcatError, match="accepted: linear, soft-l1, cauchy"):
        Loss("huber")  # type: ignore[arg-type]
    with pytest.raises(SoftcatError, match="positive"):
        Loss("cauchy", 0.0)
