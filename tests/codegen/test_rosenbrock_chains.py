"""Elimination along the chain against dense linear algebra, and whole runs against normal modes."""

from __future__ import annotations

import ctypes as c

import numpy as np
import pytest
from numpy.polynomial.legendre import leggauss

from tests.codegen import rosenbrock_library as rosenbrock
from tests.codegen.chains import Chain, beam, masses_on_relaxing_springs, random_chain, reduced
from tests.codegen.rosenbrock_library import Settings, consistent, doubles, integrate, library


def solve(chain: Chain, shift: float, right: np.ndarray, *, algebraic_only: bool = False) -> np.ndarray:
    """W k = right through softcat_linear."""
    model, code = chain.problem().model, c.c_int()
    linear = c.c_void_p(library().softcat_linear_new(c.byref(model), chain.sites, c.byref(code)))
    assert code.value == rosenbrock.SOLVED
    entries, k = doubles(chain.entries), doubles(right)
    library().softcat_linear_hold(linear, int(algebraic_only))
    code = library().softcat_linear_factorise(linear, entries, c.c_double(shift))
    assert code == rosenbrock.SOLVED
    library().softcat_linear_solve(linear, k)
    library().softcat_linear_free(linear)
    return np.array(k[:])


def dense(chain: Chain, shift: float, free: np.ndarray) -> np.ndarray:
    """W with unit rows for held unknowns."""
    jacobian = chain.jacobian()
    jacobian[~free], jacobian[:, ~free] = 0.0, 0.0
    return np.diag(np.where(free, shift * chain.mass, 1.0)) - jacobian


@pytest.mark.parametrize("algebraic_only", [False, True])
def test_elimination_of_random_chains(*, algebraic_only: bool) -> None:
    """200 patterns: rates, section blocks, held ends, reach 2; to rounding times the condition."""
    random = np.random.default_rng(7)
    for _ in range(200):
        chain, shift = random_chain(random), random.uniform(0.5, 20.0)
        right = random.normal(size=chain.free.size)
        free = chain.free & (chain.mass == 0.0) if algebraic_only else chain.free
        matrix = dense(chain, shift, free)
        exact = np.linalg.solve(matrix, np.where(free, right, 0.0))
        error = np.abs(solve(chain, shift, right, algebraic_only=algebraic_only) - exact).max()
        assert error <= 1e-14 * np.linalg.cond(matrix) * max(np.abs(exact).max(), 1e-300)


@pytest.mark.parametrize("chain", [masses_on_relaxing_springs(40), beam(60)], ids=["reach 1", "reach 2"])
def test_elimination_of_filaments(chain: Chain) -> None:
    """To 1e-10, also with rows in units that differ by 1e12, and steps from short to long."""
    right = np.random.default_rng(1).normal(size=chain.free.size)
    rows = np.array([row for row, _, _ in chain.pattern])
    for shift in (1e-3, 1.0, 1e4):
        exact = np.linalg.solve(dense(chain, shift, chain.free), np.where(chain.free, right, 0.0))
        np.testing.assert_allclose(solve(chain, shift, right), exact, rtol=1e-10, atol=1e-10 * np.abs(exact).max())
        for slot in (slot for slot, differential in enumerate(chain.differential) if not differential):
            chain.entries[:, rows == slot] *= 1e12
            right[slot :: chain.slots] *= 1e12
            np.testing.assert_allclose(solve(chain, shift, right), exact, rtol=1e-9, atol=1e-9 * np.abs(exact).max())
            chain.entries[:, rows == slot] *= 1e-12
            right[slot :: chain.slots] *= 1e-12


@pytest.mark.parametrize("method", [rosenbrock.RODAS5P, rosenbrock.RODAS4])
@pytest.mark.parametrize("chain", [masses_on_relaxing_springs(12), beam(16)], ids=["reach 1", "reach 2"])
def test_runs_of_filaments(chain: Chain, method: int) -> None:
    """Unknowns at three times against the normal modes, integrated powers against quadrature of it."""
    matrix, everything, which = reduced(chain)
    start = np.where(which, np.cos(np.arange(chain.free.size)), 0.0)
    settings = Settings(relative=1e-9, absolute=1e-11, method=method)
    status, begun = consistent(chain.problem(), 0.0, start, settings)
    assert status.code == rosenbrock.SOLVED
    np.testing.assert_allclose(begun, everything @ start[which], atol=1e-12)
    run = integrate(chain.problem(), begun, [0.0, 0.31, 1.0], settings)
    assert run.status.code == rosenbrock.SOLVED

    rates, modes = np.linalg.eig(matrix)
    amplitudes = np.linalg.solve(modes, start[which].astype(complex))

    def exact(t: float) -> np.ndarray:
        return everything @ (modes @ (np.exp(rates * t) * amplitudes)).real

    def powers(t: float) -> np.ndarray:
        return np.array([exact(t).sum(), (exact(t) ** 2).sum()])

    for at, t in enumerate((0.0, 0.31, 1.0)):
        np.testing.assert_allclose(run.states[at], exact(t), atol=3e-8)
    np.testing.assert_allclose(
        run.work[2], sum(w * powers(0.5 + 0.5 * x) for x, w in zip(*leggauss(300), strict=True)) / 2.0, atol=1e-7
    )


def test_held_values_act_on_their_neighbours() -> None:
    """Heat conduction between held ends 1 and 0 ends in a straight line, exactly; the ends never change."""
    pattern, values = [(0, -1, 0), (0, 0, 0), (0, 1, 0)], [1.0, -2.0, 1.0]
    chain = Chain(11, 0, [-1], [1], [1], [1], pattern, np.tile(values, (11, 1)))
    start = np.zeros(11)
    start[0] = 1.0
    run = integrate(chain.problem(), start, [0.0, 1e6], Settings(relative=1e-8, absolute=1e-12))
    np.testing.assert_allclose(run.state, np.linspace(1.0, 0.0, 11), atol=1e-10)
    assert (run.state[0], run.state[-1]) == (1.0, 0.0)


def test_section_states_of_two_sites_are_refused() -> None:
    """Section rows that see section states elsewhere contradict the model."""
    chain = Chain(3, 1, [-1, -1], [1, 1], [0, 0], [0, 0], [(0, 0, 0), (1, 0, 1), (1, 1, 1)], np.ones((3, 3)))
    run = integrate(chain.problem(), np.ones(6), [0.0, 1.0], Settings())
    assert run.status.code == rosenbrock.ARGUMENT
