"""The closed forms of the sagging Maxwell filament against quadrature, root finding and integration."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pytest
import sympy as sp
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from softcat_sym.physics import closed_forms as asy
from softcat_sym.physics.closed_forms import phi, phi_t, phi_tt
from softcat_sym.physics.equation import check
from softcat_sym.physics.regimes import tau_star
from softcat_sym.physics.rheometry import B, R, alpha, t_high, t_star

Floats = npt.NDArray[np.float64]
LOAD = 3.3e-5
PAPER = {B: LOAD, alpha: asy.TOLERANCE}


def test_every_term_has_one_dimension() -> None:
    for equation in asy.ASYMPTOTICS_EQUATIONS:
        check(equation)


@pytest.mark.parametrize("tau", [0.01, 0.1, 3.0])
def test_early_ratio_is_the_memory_of_a_falling_parabola(tau: float) -> None:
    end = 0.07
    memory = quad(lambda s: np.exp((s - end) / tau) * 4 * s**3 / 3, 0, end, epsabs=0, epsrel=1e-12)[0]
    ratio = 4 * end**2 * memory / (LOAD * tau)
    assert float(asy.EARLY_RATIO.subs({B: LOAD, tau_star: tau, t_star: end})) == pytest.approx(ratio, rel=1e-8)


@pytest.mark.parametrize(("tau", "law"), [(1e-4, asy.T_LOW_LONG), (1e2, asy.T_LOW_SHORT)])
def test_free_fall_ends_where_each_limit_says(tau: float, law: sp.Expr) -> None:
    ratio = sp.lambdify(t_star, (asy.EARLY_RATIO - alpha).subs({**PAPER, tau_star: sp.Float(tau, 50)}), "mpmath")
    guess = float(law.subs({**PAPER, tau_star: tau}))
    root = brentq(lambda s: float(ratio(sp.Float(s, 50))), guess / 2, guess * 2)
    assert guess == pytest.approx(root, rel=5e-3)


def test_onset_of_the_third_law_in_figure_2() -> None:
    onset = float(asy.T_HIGH.subs(PAPER))
    assert onset == pytest.approx(0.1766, abs=1e-4)
    assert float(asy.LATE_RATIO.subs({B: LOAD, t_star: onset})) == pytest.approx(1 / 15)
    step = 1e-4
    law = sp.lambdify(t_star, asy.THIRD_LAW.subs(B, LOAD))
    acceleration = (law(onset + step) - 2 * law(onset) + law(onset - step)) / step**2
    assert acceleration == pytest.approx(1 / 15, rel=1e-4)
    assert -law(onset) == pytest.approx(0.0094, abs=1e-4)


@pytest.mark.parametrize("tau", [0.35, 0.035])
def test_outer_solution_from_rest_satisfies_the_integral_equation(tau: float) -> None:
    values = {B: LOAD, tau_star: tau}
    time = sp.lambdify(phi, asy.OUTER_TIME_FROM_REST.subs(values))
    first = float(asy.ELASTIC_START.subs(values))
    assert time(first) == pytest.approx(0, abs=1e-12)
    for last in (1.2 * first, 3 * first):
        fading = quad(lambda p, last=last: np.exp((time(p) - time(last)) / tau) * p / 6, first, last, epsrel=1e-11)[0]
        memory = np.exp(-time(last) / tau) * first**2 / 12 + fading
        assert 2 * last * memory == pytest.approx(LOAD * tau, rel=1e-8)


def test_printed_outer_solution_runs_at_the_same_rate_and_ends_on_the_third_law() -> None:
    values = {B: LOAD, tau_star: 0.35}
    printed, from_rest = (sp.lambdify(phi, e.subs(values)) for e in (asy.OUTER_TIME, asy.OUTER_TIME_FROM_REST))
    assert printed(0.2) - printed(0.1) == pytest.approx(from_rest(0.2) - from_rest(0.1))
    late = 1e6
    root = brentq(lambda p: from_rest(p) - late, 1, 100)
    assert -root / 4 == pytest.approx(float(asy.THIRD_LAW.subs({B: LOAD, t_star: late})), rel=1e-6)


def test_third_law_is_the_viscous_string() -> None:
    # sag^3 = 9 rho g L^4 t/(128 eta) in SI units
    density, gravity, span, viscosity, seconds = 1900.0, 9.81, 0.2, 3e5, 40.0
    load = density * np.sqrt(gravity * span**3) / (2 * viscosity)
    in_clock = seconds * np.sqrt(gravity / span)
    sag = (9 * density * gravity * span**4 * seconds / (128 * viscosity)) ** (1 / 3)
    assert -span * float(asy.THIRD_LAW.subs({B: load, t_star: in_clock})) == pytest.approx(sag, rel=1e-12)


def _parabola(tau: float) -> sp.Expr:
    """phi_ttt from the held equation of motion, in plain symbols."""
    field, third = asy.phi_of(t_star), sp.Symbol("third")
    plain = {
        sp.Derivative(field, (t_star, 3)): third,
        sp.Derivative(field, (t_star, 2)): phi_tt,
        sp.Derivative(field, t_star): phi_t,
        field: phi,
    }
    residual = asy.PARABOLA_MOTION.residual().subs(plain).subs({B: LOAD, tau_star: tau})
    return sp.solve(residual, third)[0]


@pytest.mark.parametrize("tau", [0.35, 0.035])
def test_motion_of_the_parabola_is_the_averaged_balance(tau: float) -> None:
    # phi, phi_t and the memory q, straight from q y_xx = B tau (y_tt + 1) averaged over x
    def by_memory(t: float, u: Floats) -> list[float]:
        return [u[1], 6 - 12 * u[2] * u[0] / (LOAD * tau), u[0] * u[1] / 6 - u[2] / tau]

    third = sp.lambdify((phi, phi_t, phi_tt), _parabola(tau))
    kwargs = {"rtol": 1e-10, "atol": 1e-13, "method": "LSODA"}
    start = solve_ivp(by_memory, (0, 0.1), [0, 0, 0], **kwargs).y[:, -1]
    memory = solve_ivp(by_memory, (0, 1), start, **kwargs).y[0, -1]
    jerk = [start[0], start[1], by_memory(0, start)[1]]
    held = solve_ivp(lambda t, u: [u[1], u[2], third(*u)], (0, 1), jerk, **kwargs).y[0, -1]
    assert held == pytest.approx(memory, rel=1e-6)


def test_departures_follow_the_complete_oscillation() -> None:
    tau, end = 0.05, 0.4
    third = sp.lambdify((phi, phi_t, phi_tt), _parabola(tau))
    coefficients = sp.lambdify(
        (phi, phi_t, phi_tt), [c.subs({B: LOAD, tau_star: tau}) for c in asy.OSCILLATION_COMPLETE]
    )

    def rate(t: float, u: Floats) -> list[float]:
        c3, c2, c1, c0 = coefficients(*u[:3])
        f = u[3:]
        return [u[1], u[2], third(*u[:3]), f[1], f[2], -(c2 * f[2] + c1 * f[1] + c0 * f[0]) / c3]

    base = [float(asy.THIRD_LAW_FACTOR.subs({B: LOAD, t_star: 0.2}))]
    base += [base[0] / 0.6, -2 * base[0] / 9 / 0.04]
    nudge, small = [1e-3, 0.02, 0.5], 1e-4
    kwargs = {"rtol": 1e-11, "atol": 1e-14, "method": "LSODA"}
    linear = solve_ivp(rate, (0, end), [*base, *nudge], **kwargs).y[3, -1]
    up, down = (
        solve_ivp(rate, (0, end), [*(b + s * n for b, n in zip(base, nudge, strict=True)), 0, 0, 0], **kwargs).y[0, -1]
        for s in (small, -small)
    )
    assert (up - down) / (2 * small) == pytest.approx(linear, rel=1e-4)


@pytest.mark.parametrize("tau", [0.35, 0.035])
def test_frequency_and_decay_are_the_roots_of_2_21(tau: float) -> None:
    onset = float(asy.T_HIGH.subs(PAPER))
    values = {B: LOAD, tau_star: tau, t_star: onset, t_high: onset}
    roots = np.roots([float(c.subs(values)) for c in asy.OSCILLATION])
    assert roots.real == pytest.approx(-float(asy.DECAY_RATE.subs(values)))
    assert roots.imag.max() == pytest.approx(float(asy.FREQUENCY.subs(values)))


def test_ringing_solves_2_21_with_its_coefficient_frozen() -> None:
    values = {B: LOAD, tau_star: 0.035, t_high: 0.1766}
    frequency = float(asy.FREQUENCY.subs(values))
    amplitudes = {asy.f_rest: 0.3, asy.f_cos: -0.7, asy.f_sin: 1.1}
    ringing = sp.lambdify(t_star, asy.RINGING.subs(amplitudes).subs({R: frequency, **values}))
    c3, c2, c1 = (float(c.subs({**values, t_star: 0.1766})) for c in asy.OSCILLATION)
    run = solve_ivp(
        lambda t, u: [u[1], u[2], -(c2 * u[2] + c1 * u[1]) / c3],
        (0, 0.2),
        [
            float(sp.diff(asy.RINGING.subs(amplitudes), t_star, n).subs({t_star: 0, R: frequency, **values}))
            for n in range(3)
        ],
        rtol=1e-10,
        atol=1e-12,
        dense_output=True,
    )
    at = np.linspace(0, 0.2, 21)
    assert run.sol(at)[0] == pytest.approx(ringing(at), rel=1e-6)
    assert float(asy.PERIOD.subs(R, frequency)) * frequency == pytest.approx(2 * np.pi)


def test_expressions_take_arrays() -> None:
    times = np.geomspace(1e-3, 10, 5)
    for law in (asy.FREE_FALL, asy.THIRD_LAW):
        assert sp.lambdify(t_star, law.subs(B, LOAD))(times).shape == times.shape
    assert (np.diff(sp.lambdify(phi, asy.OUTER_TIME.subs({B: LOAD, tau_star: 0.35}))(times)) > 0).all()


def test_tension_against_bending_in_figure_2() -> None:
    ratio = asy.TENSION_TO_BENDING.subs({asy.K_I: sp.Rational(1, 12), phi: 4 * 0.0094})
    assert float(ratio.subs(asy.delta, 0.025)) == pytest.approx(0.094, abs=1e-3)
    assert float(ratio.subs(asy.delta, 0.0025)) == pytest.approx(9.4, abs=0.1)
