"""Problems of the stiff test set of Hairer & Wanner against the published digits.

Reference values: Mazzia & Magherini, Test Set for Initial Value Problem Solvers, release 2.4 (2008), problems HIRES,
ROBER and VDPOL; the value of Robertson's problem at t = 40 is that of Hairer & Wanner, Solving ODEs II (1996).
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.codegen import rosenbrock_library as rosenbrock
from tests.codegen.rosenbrock_library import RODAS3P, RODAS4, RODAS5P, Settings, integrate, problem

HIRES = [
    0.7371312573325668e-3,
    0.1442485726316185e-3,
    0.5888729740967575e-4,
    0.1175651343283149e-2,
    0.2386356198831331e-2,
    0.6238968252742796e-2,
    0.2849998395185769e-2,
    0.2850001604814231e-2,
]
ROBERTSON = {40.0: [0.7158270688, 0.9185534764e-5, 0.2841637457], 1e11: [0.2083340149701255e-7, 0.8333360770334713e-13]}
OSCILLATOR = [0.1706167732170483e1, -0.8928097010247975]


@pytest.mark.parametrize(
    ("method", "relative", "digits"), [(RODAS5P, 1e-8, 1e-6), (RODAS4, 1e-8, 1e-6), (RODAS3P, 1e-6, 1e-3)]
)
def test_hires(method: int, relative: float, digits: float) -> None:
    """Photomorphogenesis, 8 unknowns, t = 321.8122."""
    settings = Settings(relative=relative, absolute=1e-4 * relative, method=method)
    run = integrate(problem("hires"), [1.0, 0, 0, 0, 0, 0, 0, 0.0057], [0.0, 321.8122], settings)
    assert run.status.code == rosenbrock.SOLVED
    np.testing.assert_allclose(run.state, HIRES, rtol=digits)


@pytest.mark.parametrize("method", [RODAS5P, RODAS4])
def test_robertson(method: int) -> None:
    """Rates from 0.04 to 3e7, t = 40 and t = 1e11: steps grow by ten orders."""
    settings = Settings(relative=1e-8, absolute=[1e-14, 1e-19, 1e-12], method=method)
    run = integrate(problem("robertson"), [1.0, 0.0, 0.0], [0.0, *ROBERTSON], settings)
    assert run.status.code == rosenbrock.SOLVED
    np.testing.assert_allclose(run.states[1], ROBERTSON[40.0], rtol=1e-7)
    np.testing.assert_allclose(run.states[2][:2], ROBERTSON[1e11], rtol=1e-5)
    assert run.status.steps < 3000


@pytest.mark.parametrize("method", [RODAS5P, RODAS4])
def test_van_der_pol(method: int) -> None:
    """Epsilon = 1e-6, two jumps of width 1e-6, t = 2."""
    settings = Settings(relative=1e-7, absolute=1e-7, method=method)
    run = integrate(problem("oscillator", 1e-6), [2.0, -0.66], [0.0, 2.0], settings)
    assert run.status.code == rosenbrock.SOLVED
    np.testing.assert_allclose(run.state, OSCILLATOR, rtol=2e-5)
