"""The inverse map of rheometry against numbers: round trips, finite differences, random errors, other beams."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_bvp, solve_ivp

from softcat_sym.physics import equation as dimensions
from softcat_sym.physics import rheometry
from softcat_sym.physics.regimes import E_star, H, V, tau_star
from softcat_sym.physics.rheometry import I_0, B, R, alpha, chi, d_R, m_load, t_high, t_star, v_mid, var_B, var_R, var_t
from softcat_sym.physics.symbols import A0, E, L, eta, g, rho

PAPER_B = 3.3e-5
ONSET = (PAPER_B / 3) ** 0.2 * (6 / 15) ** -0.6
RINGING = [0.02, 0.035, 0.35]
FADING = [0.0030, 0.0045]


def frequency(relaxation: float, clock: float = ONSET, load: float = PAPER_B) -> float:
    """Imaginary part of the roots of tau r^2 + r + 6 c, found by numpy."""
    roots = np.roots([relaxation, 1, 6 * (3 * clock**2 / load) ** (1 / 3)])
    return float(abs(roots[0].imag))


def invert(measured: np.ndarray, *, ringing: bool) -> np.ndarray:
    """(log E*, log V) of (log R, log t_high, log B)."""
    values = dict(zip((R, t_high, B), np.exp(measured), strict=True))
    both = rheometry.relaxation_times()
    relaxation = (both.ringing if ringing else both.fading).subs(values)
    viscous = rheometry.VISCOUS_NUMBER.right.subs(values)
    return np.array([math.log(float(viscous / relaxation)), math.log(float(viscous))])


def test_every_term_has_one_dimension() -> None:
    for equation in rheometry.RHEOMETRY_EQUATIONS:
        dimensions.check(equation)


def test_round_trip() -> None:
    for relaxation in [*RINGING, *FADING]:
        read = frequency(relaxation)
        seen = {R: read, t_high: ONSET, B: PAPER_B}
        assert float(rheometry.RINGING_FREQUENCY.right.subs({**seen, tau_star: relaxation})) == pytest.approx(read)
        both = rheometry.relaxation_times()
        held, other = (both.ringing, both.fading) if relaxation in RINGING else (both.fading, both.ringing)
        assert float(held.subs(seen)) == pytest.approx(relaxation, rel=1e-9)
        # the other root rings at the same frequency
        assert frequency(float(other.subs(seen))) == pytest.approx(read, rel=1e-9)


def test_the_decay_rate_selects_the_root() -> None:
    for relaxation in [*RINGING, *FADING]:
        read, decay = frequency(relaxation), 1 / (2 * relaxation)
        assert (decay < read) is (relaxation in RINGING)
        at = {R: read, d_R: decay, t_high: ONSET, B: PAPER_B}
        assert float(rheometry.CIRCLE_OF_DECAY.residual().subs(at)) == pytest.approx(0, abs=1e-8 * read**2)
        assert float(rheometry.DECAY.right.subs(tau_star, relaxation)) == decay
        if relaxation in FADING:
            assert math.exp(-decay * 2 * math.pi / read) < 1 / 535


def test_no_filament_rings_faster_than_the_double_root() -> None:
    rates = [frequency(relaxation) for relaxation in np.geomspace(0.0030, 1, 4000)]
    largest = float(rheometry.LARGEST_FREQUENCY.right.subs({t_high: ONSET, B: PAPER_B}))
    assert max(rates) == pytest.approx(largest, rel=1e-5)
    assert largest == pytest.approx(15 / ONSET)
    assert float(rheometry.LARGEST_FREQUENCY_AT_ONSET.right.subs({alpha: 1 / 15, t_high: ONSET})) == pytest.approx(
        largest
    )
    beyond = rheometry.relaxation_times().ringing.subs({R: 1.01 * largest, t_high: ONSET, B: PAPER_B})
    assert abs(sp.im(beyond.n())) > 0


def test_sensitivity_against_finite_differences() -> None:
    for relaxation in [*RINGING, *FADING]:
        measured = np.log([frequency(relaxation), ONSET, PAPER_B])
        at = {chi: 2 * frequency(relaxation) * relaxation}
        held = np.array(rheometry.sensitivity().subs(at).tolist(), dtype=float)
        step = 1e-6
        for column in range(3):
            shift = np.eye(3)[column] * step
            ringing = relaxation in RINGING
            slope = (invert(measured + shift, ringing=ringing) - invert(measured - shift, ringing=ringing)) / (2 * step)
            assert held[:, column] == pytest.approx(slope, rel=1e-5, abs=1e-6)
        assert float(rheometry.condition_number().subs(at)) == pytest.approx(np.linalg.cond(held))
        tied = np.array(rheometry.sensitivity_at_onset().subs(at).tolist(), dtype=float)
        assert tied == pytest.approx(held @ np.array([[1, 0], [0, 1], [0, 5]]))


def test_condition_number_blows_up_at_the_double_root_only() -> None:
    number = sp.lambdify(chi, rheometry.condition_number(), "math")
    assert number(1e3) == pytest.approx(math.sqrt(45 / 8), rel=1e-4)
    assert number(1 + 1e-6) > 1e5 < number(1 - 1e-6)
    assert number(1e-3) < 5


def test_errors_of_many_noisy_measurements() -> None:
    """Both covariances against the scatter of inverted random measurements."""
    relaxation = 0.035
    deviations = np.array([0.002, 0.004, 0.003])
    true = np.log([frequency(relaxation), ONSET, PAPER_B])
    draws = true + np.random.default_rng(5).normal(size=(4000, 3)) * deviations
    variances = dict(zip((var_R, var_t, var_B), deviations**2, strict=True))
    at = {chi: 2 * frequency(relaxation) * relaxation, **variances}
    plain = sp.lambdify((R, t_high, B), rheometry.relaxation_times().ringing, "numpy")

    def estimates(rates: np.ndarray, clocks: np.ndarray, loads: np.ndarray) -> np.ndarray:
        viscous = 1 / (2 * loads)
        return np.log(np.array([viscous / plain(rates, clocks, loads), viscous]))

    rates, clocks, loads = np.exp(draws).T
    wanted = np.array(rheometry.covariance().subs(at).tolist(), dtype=float)
    assert np.cov(estimates(rates, clocks, loads)) == pytest.approx(wanted, rel=0.08)

    known = {**variances, alpha: sp.Rational(1, 15)}
    average = sp.lambdify((t_high, B), rheometry.combined_log_B().subs(known), "numpy")
    better = np.exp(average(clocks, loads))
    onset = (better / 3) ** 0.2 * (6 / 15) ** -0.6
    wanted = np.array(rheometry.combined_covariance().subs(at).tolist(), dtype=float)
    assert np.cov(estimates(rates, onset, better)) == pytest.approx(wanted, rel=0.08)

    disagreement = sp.lambdify((t_high, B), rheometry.misfit().subs(known), "numpy")
    assert np.mean(disagreement(clocks, loads)) == pytest.approx(1, abs=0.08)


def test_onset_and_late_sag_give_the_same_viscosity() -> None:
    assert float(rheometry.B_FROM_T_HIGH.right.subs({t_high: ONSET, alpha: 1 / 15})) == pytest.approx(PAPER_B)
    # quasi-static viscous string: y_xx q = tau B with q = tau (strain)_t, far from its start
    late = solve_ivp(lambda t, f: 3 * PAPER_B / f**2, (0, 1e4), [1e-4], rtol=1e-10, atol=1e-14).y[0, -1]
    assert float(rheometry.B_FROM_SAG.right.subs({H: late / 4, L: 1, t_star: 1e4})) == pytest.approx(PAPER_B, rel=1e-6)


def test_what_is_neglected_is_neglected() -> None:
    """Relative to 6 c = 2 phi^2/B the stiffness of the weight is 6 tau/phi."""
    relaxation, factor = 0.035, (9 * PAPER_B * ONSET) ** (1 / 3)
    wanted = (6 * relaxation / factor) / (2 * factor**2 / PAPER_B)
    assert float(rheometry.neglected().subs({tau_star: relaxation, t_high: ONSET})) == pytest.approx(wanted)


@pytest.mark.parametrize("modulus", [500.0, 2e4])
def test_modulus_from_a_ringing_elastic_string(modulus: float) -> None:
    """An elastic parabola at rest, pushed a little: 2 phi q = (1 - phi''/6)/(2 E*), q the strain that it remembers."""
    rest = (3 / modulus) ** (1 / 3)
    held = 1 / (4 * modulus * rest)

    def rates(_: float, state: np.ndarray) -> list[float]:
        factor, speed = state
        memory = held + (factor**2 - rest**2) / 12
        return [speed, 6 - 24 * modulus * factor * memory]

    def passes(_: float, state: np.ndarray) -> float:
        return state[0] - rest

    passes.direction = 1  # type: ignore[attr-defined]
    crossings = solve_ivp(rates, (0, 20), [rest * 1.001, 0], rtol=1e-10, atol=1e-13, events=passes).t_events[0]
    read = 2 * math.pi / np.mean(np.diff(crossings))
    found = rheometry.MODULUS_FROM_SAG.right.subs({R: read, d_R: 0, H: rest / 4, L: 1})
    assert float(found) == pytest.approx(modulus, rel=1e-4)


def test_moduli_agree_with_each_other() -> None:
    """E in Pa over rho g L is E*; V/tau* = E*."""
    si = {rho: 1900.0, g: 9.81, L: 0.2, tau_star: 0.035, B: PAPER_B}
    viscosity = rheometry.VISCOSITY_FROM_B.right.subs(si)
    modulus = rheometry.MODULUS.right.subs({**si, eta: viscosity})
    assert float(modulus / (1900 * 9.81 * 0.2)) == pytest.approx(float(rheometry.MODULUS_BY_GROUPS.right.subs(si)))
    assert float(rheometry.B_FROM_VISCOSITY.right.subs({**si, eta: viscosity})) == pytest.approx(PAPER_B)
    assert (rheometry.MODULUS.left, rheometry.MODULUS_BY_GROUPS.left, rheometry.VISCOUS_NUMBER.left) == (E, E_star, V)


@pytest.mark.parametrize("load", [0.0, 0.05])
def test_beam_viscometry_against_a_collocated_beam(load: float) -> None:
    """A viscous rod of 1e12 Pa s on knife edges, half of it, in SI."""
    span, diameter, density, shear, gravity = 0.05, 0.003, 2500.0, 1e12, 9.81
    area, inertia = math.pi * diameter**2 / 4, math.pi * diameter**4 / 64
    resistance = 3 * shear * inertia

    def rates(x: np.ndarray, w: np.ndarray) -> np.ndarray:
        return np.vstack([w[1], w[2], w[3], np.full_like(x, density * area * gravity * span**3 / (8 * resistance))])

    def ends_hold(left: np.ndarray, right: np.ndarray) -> np.ndarray:
        # x = 2 X/L from an edge to midspan, speeds in L/2; no turning there and half of the load
        return np.array([left[0], left[2], right[1], right[3] + load * gravity * span**2 / (8 * resistance)])

    mesh = np.linspace(0, 1, 101)
    solution = solve_bvp(rates, ends_hold, mesh, np.zeros((4, mesh.size)), tol=1e-10)
    speed = abs(solution.y[0, -1]) * span / 2
    at = {g: gravity, L: span, rho: density, A0: area, I_0: inertia, m_load: load}
    assert float(rheometry.BEAM_VISCOMETRY.right.subs({**at, v_mid: speed})) == pytest.approx(shear, rel=1e-6)
    assert float(rheometry.ASTM_C598.right.subs({**at, v_mid: speed * 60})) == pytest.approx(shear, rel=1e-6)
