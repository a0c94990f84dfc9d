"""Derivatives by copies in lock-step, against the matrix exponential's and against neighbouring runs."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy.linalg import expm

from tests.codegen import rosenbrock_library as rosenbrock
from tests.codegen.chains import Chain, masses_on_relaxing_springs, reduced
from tests.codegen.rosenbrock_library import Moved, Settings, consistent, integrate, problem

TIGHT = Settings(relative=1e-11, absolute=1e-13)


@pytest.mark.parametrize(("two_sided", "size", "accuracy"), [(False, 1e-7, 1e-6), (True, 1e-5, 1e-9)])
def test_linear_decay(two_sided: bool, size: float, accuracy: float) -> None:
    """z' = (a + ib) z: dz/da = t z, dz/db = i t z, and dz/dz(0) = exp((a + ib) t)."""
    what, times = problem("dahlquist", -0.3, 2.0), np.array([0.0, 0.7, 2.0])
    moved = Moved(
        [size] * 3, np.array([[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]), None, np.array([[0, 0], [0, 0], [1.0, 0]])
    )
    moved.two_sided = two_sided
    run = integrate(what, [1.0, 0.5], times, TIGHT, moved)
    assert run.derivatives is not None
    growth = np.exp((-0.3 + 2.0j) * times)
    solution = (1.0 + 0.5j) * growth
    for found, exact in zip(run.derivatives, (times * solution, 1j * times * solution, growth), strict=True):
        np.testing.assert_allclose(found, np.stack([exact.real, exact.imag], axis=1), atol=accuracy)


def test_the_run_itself_is_not_touched() -> None:
    """Steps and numbers are those of a run without derivatives."""
    what, times = problem("oscillator", 1e-3), [0.0, 0.5, 2.0]
    alone = integrate(what, [2.0, -0.66], times, Settings())
    accompanied = integrate(what, [2.0, -0.66], times, Settings(), Moved([1e-8], np.ones((1, 1))))
    assert accompanied.status.steps == alone.status.steps
    np.testing.assert_array_equal(accompanied.states, alone.states)


def test_steps_make_no_noise() -> None:
    """At a loose tolerance the derivative has the error of the run, not of steps chosen anew divided by the size."""
    what, times, loose = problem("smooth"), [0.0, 2.0], Settings(relative=1e-4, absolute=1e-6)
    found = integrate(what, [1.0, 1.0], times, loose, Moved([1e-7], None, None, np.array([[1.0, 0.0]])))
    exact = integrate(what, [1.0, 1.0], times, TIGHT, Moved([1e-5], None, None, np.array([[1.0, 0.0]]), two_sided=True))
    assert found.derivatives is not None
    assert exact.derivatives is not None
    np.testing.assert_allclose(found.derivatives[0, 1], exact.derivatives[0, 1], rtol=2e-3)
    assert found.work_derivatives is not None
    # The work is 1 - u.
    np.testing.assert_allclose(found.work_derivatives[0, 1, 0], -found.derivatives[0, 1, 1], rtol=1e-3)


def test_algebraic_unknowns_follow() -> None:
    """A chain with springs' forces as algebraic unknowns: by initial state and by the entries (places)."""
    chain = masses_on_relaxing_springs(8)
    start = np.where(chain.free & (chain.mass == 1.0), np.cos(np.arange(chain.free.size)), 0.0)
    _, begun = consistent(chain.problem(), 0.0, start, TIGHT)
    stiffer = np.zeros_like(chain.entries)
    stiffer[:, [1, 2]] = chain.entries[:, [1, 2]]
    turned = np.where(chain.free & (chain.mass == 1.0), 1.0, 0.0)
    zero = np.zeros_like(turned)
    moved = Moved([1e-5, 1e-5], None, np.array([stiffer, 0.0 * stiffer]), np.array([zero, turned]), two_sided=True)
    run = integrate(chain.problem(), begun, [0.0, 0.5], TIGHT, moved)
    assert run.status.code == rosenbrock.SOLVED
    assert run.derivatives is not None
    np.testing.assert_allclose(run.derivatives[0, 1], _by_exponential(chain, begun, stiffer), atol=1e-6)
    along = [integrate(chain.problem(), begun + sign * turned, [0.0, 0.5], TIGHT).state for sign in (-1.0, 1.0)]
    np.testing.assert_allclose(run.derivatives[1, 1], 0.5 * (along[1] - along[0]), atol=1e-6)


def _by_exponential(chain: Chain, start: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """Central difference of exact solutions."""
    ends = []
    for step in (-1e-5, 1e-5):
        matrix, everything, which = reduced(dataclasses.replace(chain, entries=chain.entries + step * direction))
        ends.append(everything @ (expm(0.5 * matrix) @ start[which]))
    return (ends[1] - ends[0]) / 2e-5
