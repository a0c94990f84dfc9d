"""The oracle of drawn bars against formulas of linear viscoelasticity and viscoplasticity."""

from __future__ import annotations

import numpy as np
import pytest

from . import materials as m

E, ETA, RATE = 3.0, 2.0, 0.1
TIME = np.linspace(0, 2, 9)
STEADY = m.Drawing(((0.0, 1.0), (2.0, float(np.exp(2 * RATE)))), true_rate=True)


def test_path_of_a_bar() -> None:
    path = m.Drawing(((0.0, 1.0), (1.0, 2.0), (2.0, 1.0)))
    np.testing.assert_allclose(path.stretch(np.array([0.5, 1.0, 1.5, 5.0])), [1.5, 2, 1.5, 1])
    np.testing.assert_allclose(path.strain_rate(np.array([0.5, 1.0, 1.5, 5.0])), [1 / 1.5, 0.5, -1 / 1.5, 0])


def test_elastic_newtonian_and_kelvin_voigt_need_no_integration() -> None:
    path = m.Drawing(((0.0, 1.0), (1.0, 2.0)))
    t = np.array([0.25, 0.5, 1.0])
    strain, rate = np.log(1 + t), 1 / (1 + t)
    np.testing.assert_allclose(m.stress(m.elastic(E), path, t), E * strain, rtol=1e-9)
    np.testing.assert_allclose(m.stress(m.newtonian(ETA), path, t), ETA * rate, rtol=1e-14)
    np.testing.assert_allclose(m.stress(m.kelvin_voigt(E, ETA), path, t), E * strain + ETA * rate, rtol=1e-9)
    np.testing.assert_allclose(m.tension(m.newtonian(ETA), path, t, 5.0), 5 * ETA * rate**2, rtol=1e-14)


def test_start_up_and_relaxation_of_maxwell() -> None:
    grown = ETA * RATE * (1 - np.exp(-E * TIME / ETA))
    np.testing.assert_allclose(m.stress(m.maxwell(E, ETA), STEADY, TIME), grown, atol=1e-9)
    held = m.Drawing(((0.0, 1.0), (1e-6, 1.1)))
    t = np.array([1.0, 2.0])
    expected = E * np.log(1.1) * np.exp(-E * t / ETA)
    np.testing.assert_allclose(m.stress(m.maxwell(E, ETA), held, t), expected, rtol=2e-6)
    modes = [(1.0, 0.5), (2.0, 4.0)]
    each = sum(modulus * np.log(1.1) * np.exp(-modulus * t / eta) for modulus, eta in modes)
    np.testing.assert_allclose(m.stress(m.multimode(modes), held, t), each, rtol=2e-6)
    spring = m.stress(m.standard_linear(E, 2.0, ETA), held, t)
    np.testing.assert_allclose(spring, np.log(1.1) * (E + 2.0 * np.exp(-2.0 * t / ETA)), rtol=2e-6)


def test_start_up_of_bingham() -> None:
    """Elastic to sY, then the rest grows as Maxwell's."""
    sY = 0.15
    onset = sY / (E * RATE)
    beyond = np.maximum(TIME - onset, 0)
    expected = np.minimum(E * RATE * TIME, sY) + ETA * RATE * (1 - np.exp(-E * beyond / ETA))
    np.testing.assert_allclose(m.stress(m.bingham(E, ETA, sY), STEADY, TIME), expected, atol=1e-9)


def test_steady_drawing() -> None:
    """sigma -> sY + K rate^n."""
    for index in [0.3, 0.5, 1.0, 2.0]:
        for yield_stress in [0.0, 0.2]:
            bar = m.herschel_bulkley(200.0, 2.0, index, yield_stress)
            found = m.stress(bar, STEADY, np.array([2.0]))[0]
            assert found == pytest.approx(yield_stress + 2.0 * RATE**index, rel=1e-5)


def test_push_is_the_opposite_of_pull() -> None:
    there = m.Drawing(tuple((t, 1 / s) for t, s in STEADY.rows), true_rate=True)
    for bar in (m.herschel_bulkley(E, ETA, 0.5, 0.1), m.power_law(E, ETA, 2.0), m.standard_linear(E, 1.0, ETA)):
        t = np.array([0.5, 2.0])
        np.testing.assert_allclose(m.stress(bar, there, t), -m.stress(bar, STEADY, t), rtol=1e-9)


def test_work_of_a_cycle_is_stored_or_lost() -> None:
    """int sigma eps_t = sum of sigma_j^2/2E_j + dissipated; elastic loses nothing, and no law ever gains."""
    path = m.Drawing(((0.0, 1.0), (1.0, 1.1), (2.0, 0.95), (3.0, 1.05)))
    t = np.linspace(0, 3, 601)
    for bar in (m.elastic(E), m.bingham(E, 0.1, 0.1), m.herschel_bulkley(E, 0.1, 0.5, 0.1), m.kelvin_voigt(E, ETA)):
        sigma, lost = m.respond(bar, path, t)
        middle = (t[1:] + t[:-1]) / 2
        work = np.sum(m.stress(bar, path, middle) * path.strain_rate(middle)) * (t[1] - t[0])
        spring = sigma[-1] - bar.viscosity * path.strain_rate(t[-1:])[0]
        assert work == pytest.approx(spring**2 / (2 * E) + lost[-1], rel=1e-3)
        assert np.diff(lost).min() >= 0
        assert (lost[-1] > 1e-3) == (bar != m.elastic(E))
