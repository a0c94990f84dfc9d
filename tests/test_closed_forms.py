"""Closed forms: regimes, asymptotics and rheometry."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest
import sympy as sp
from scipy.integrate import quad, solve_bvp, solve_ivp
from scipy.optimize import brentq, linprog, minimize_scalar

from softcat_sym.effects import scaling_estimates as prediction
from softcat_sym.physics import closed_forms as asy
from softcat_sym.physics import regimes, rheometry
from softcat_sym.physics.closed_forms import phi, phi_t, phi_tt
from softcat_sym.physics.regimes import (
    BEAMS,
    CLAMPED,
    PINNED,
    G,
    H,
    H_stop,
    delta,
    k_on,
    psi_T,
    tau_star,
    u_L,
)
from softcat_sym.physics.rheometry import I_0, B, R, alpha, chi, d_R, m_load, t_high, t_star, v_mid, var_B, var_R, var_t
from softcat_sym.physics.sections import CIRCLE, RECTANGLE
from softcat_sym.physics.symbols import A0, L, g, rho
from softcat_sym.scene.reading import load_scene
from tests.common.draws import draws, errors_away

# Regimes against numbers that share no formula with them: boundary-value solvers, quadrature, time integration.
SECTIONS = [RECTANGLE, CIRCLE]
MODULUS_OVER_WEIGHT = 4e6 / (1900 * 9.81 * 0.2)


def name(value: object) -> str:
    return getattr(value, "name", None) or (" ".join(value) if isinstance(value, tuple) else str(value))


def beam(ends: tuple[str, str], stiffness: float = 1.0, tension: float = 0.0) -> tuple[float, float]:
    """Largest moment and midspan sag of a beam under unit load, by collocation; pinned ends at will."""

    def ends_hold(left: np.ndarray, right: np.ndarray) -> np.ndarray:
        at = [left, right]
        return np.array([q for end, v in zip(ends, at, strict=True) for q in (v[0], v[1 if end == "clamped" else 2])])

    def rates(x: np.ndarray, w: np.ndarray) -> np.ndarray:
        return np.vstack([w[1], w[2], w[3], (1 + tension * w[2]) / stiffness])

    mesh = np.linspace(0, 1, 201)
    solution = solve_bvp(rates, ends_hold, mesh, np.zeros((4, mesh.size)), tol=1e-9)
    return float(np.max(np.abs(solution.sol(np.linspace(0, 1, 2001))[2]))), float(abs(solution.sol(0.5)[0]))


@pytest.mark.parametrize("ends", BEAMS, ids=name)
def test_beams_against_collocation(ends: tuple[str, str]) -> None:
    moment, sag = beam(ends)
    assert moment == pytest.approx(float(BEAMS[ends].largest_moment), rel=1e-6)
    assert sag == pytest.approx(float(BEAMS[ends].midspan_sag), rel=1e-6)


def test_first_yield_and_what_scenes_predict() -> None:
    for section, ends, wanted in [
        (RECTANGLE, ("clamped", "clamped"), 2),
        (RECTANGLE, ("pinned", "pinned"), 4 / 3),
        (CIRCLE, ("clamped", "clamped"), 1.5),
        (CIRCLE, ("pinned", "pinned"), 1),
        (RECTANGLE, ("clamped", "pinned"), 4 / 3),
        (CIRCLE, ("clamped", "pinned"), 1),
    ]:
        held = regimes.first_yield(section, BEAMS[ends])
        assert float(held / delta) == pytest.approx(wanted)
        change = {"filament.section": section.name, "ends.left": ends[0], "ends.right": ends[1]}
        scene = load_scene("arrested-overdamped", change)
        assert prediction.first_yield_gravity_number(scene) == pytest.approx(wanted * 0.03)


@pytest.mark.parametrize("section", SECTIONS, ids=name)
@pytest.mark.parametrize("slender", [0.01, 0.03])
@pytest.mark.parametrize("psi", [0.3, 2.0, 8.0])
def test_first_yield_of_a_stretching_beam(section: object, slender: float, psi: float) -> None:
    """At that load and tension a collocated beam has just that tension, and just that strain at the clamp."""
    point = regimes.first_yield_stretched(section)
    at = {psi_T: psi, delta: slender}
    strain, weight = float(point.yield_strain.subs(at)), float(point.gravity_number.subs(at))
    K = float(section.zeta_squared) / 4
    load = strain * weight  # rho g L/E
    tension = 4 * psi**2 * K * slender**2  # T/(E A)
    unit = load / (384 * K * slender**2)  # the deflection without tension

    def rates(x: np.ndarray, w: np.ndarray) -> np.ndarray:
        return np.vstack([w[1], w[2], w[3], 384 + 4 * psi**2 * w[2], unit**2 * w[1] ** 2 / (2 * tension)])

    def ends_hold(left: np.ndarray, right: np.ndarray) -> np.ndarray:
        return np.array([left[0], left[1], right[0], right[1], left[4]])

    mesh = np.linspace(0, 1, 401)
    solution = solve_bvp(rates, ends_hold, mesh, np.zeros((5, mesh.size)), tol=1e-6)
    assert solution.success
    assert solution.y[4, -1] == pytest.approx(1, rel=1e-5)
    assert tension + slender / 2 * unit * abs(solution.y[2, 0]) == pytest.approx(strain, rel=1e-5)


def test_tension_first_adds_its_stress_and_then_relieves_the_bending() -> None:
    point = regimes.first_yield_stretched(RECTANGLE)
    weight = sp.lambdify((psi_T, delta), point.gravity_number, "math")
    strain = sp.lambdify((psi_T, delta), point.yield_strain, "math")
    values = [weight(psi, 0.03) for psi in (0.01, 0.5, 1, 2, 5, 20)]
    assert values[0] == pytest.approx(0.06, rel=1e-3)
    assert values[1] < values[0]
    assert values[1:] == sorted(values[1:])
    psi = brentq(lambda p: weight(p, 0.03) * strain(p, 0.03) * MODULUS_OVER_WEIGHT - 1, 0.1, 20)
    assert weight(psi, 0.03) == pytest.approx(0.0682, abs=1e-4)


def ringing_moment(times: np.ndarray, *, clamped: bool, modes: int) -> np.ndarray:
    """Moment over the static one at the clamp, or at midspan between pins, after the weight came on at once."""
    moment = np.ones_like(times)
    for n in range(1, 2 * modes, 2):
        if clamped:
            b = brentq(lambda v: math.cos(v) - 1 / math.cosh(v), (n + 0.5) * math.pi - 0.1, (n + 0.5) * math.pi + 0.1)
            kappa = (math.cosh(b) - math.cos(b)) / (math.sinh(b) - math.sin(b))
            share = 96 * kappa / b**3
        else:
            b, share = n * math.pi, 32 * (-1) ** (n // 2) / (n * math.pi) ** 3
        moment -= share * np.cos(b**2 * times)
    return moment


@pytest.mark.parametrize(("clamped", "beam_held"), [(True, CLAMPED), (False, PINNED)])
def test_overshoot_of_a_weight_applied_at_once(clamped: bool, beam_held: regimes.Beam) -> None:
    moment = ringing_moment(np.linspace(0, 40, 400_001), clamped=clamped, modes=6)
    bound = float(beam_held.overshoot_bound)
    assert abs(moment[0]) < 1e-2
    assert 1.97 < np.max(np.abs(moment)) <= bound
    for section in SECTIONS:
        early, late = regimes.first_yield_at_once(section, beam_held), regimes.first_yield(section, beam_held)
        assert float(late / early) == pytest.approx(bound)


@pytest.mark.parametrize("k", [0.5, 1.94, 6.0, 20.0])
def test_ramp_gain_against_the_oscillator_itself(k: float) -> None:
    """Duhamel's integral by quadrature, after the ramp."""
    rate = lambda v: 30 * v**2 * (1 - v) ** 2  # noqa: E731
    cosine = quad(lambda v: rate(v) * math.cos(k * v), 0, 1)[0]
    sine = quad(lambda v: rate(v) * math.sin(k * v), 0, 1)[0]
    assert abs(float(regimes.ramp_gain().subs(k_on, k))) == pytest.approx(math.hypot(cosine, sine), rel=1e-9)


@pytest.mark.parametrize("ends", BEAMS, ids=name)
def test_collapse_by_linear_programming(ends: tuple[str, str]) -> None:
    """Static theorem on a grid: the largest load with |M| <= 1 and M'' = -load."""
    n = 200
    step = 1 / n
    rows = np.zeros((n - 1, n + 2))
    for i in range(1, n):
        rows[i - 1, i - 1 : i + 2] = 1, -2, 1
        rows[i - 1, -1] = step**2
    limits = [(-1.0, 1.0)] * (n + 1) + [(0.0, None)]
    for end, node in zip(ends, (0, n), strict=True):
        if end == "pinned":
            limits[node] = (0.0, 0.0)
    cost = np.zeros(n + 2)
    cost[-1] = -1
    found = linprog(cost, A_eq=rows, b_eq=np.zeros(n - 1), bounds=limits)
    assert -found.fun == pytest.approx(float(BEAMS[ends].collapse), rel=1e-3)


def test_collapse_number() -> None:
    for section, wanted in ((RECTANGLE, 4.0), (CIRCLE, 32 / (3 * math.pi))):
        assert float(regimes.plastic_collapse(section) / delta) == pytest.approx(wanted)


def test_lightest_stressed_catenary() -> None:
    least = minimize_scalar(
        lambda a: a * math.cosh(1 / (2 * a)), bounds=(0.2, 2), options={"xatol": 1e-12}, method="bounded"
    )
    assert least.fun == pytest.approx(0.754440, abs=1e-6)
    assert float(regimes.arrest_threshold_exact()) == pytest.approx(1 / least.fun, rel=1e-10)
    assert float(1 / (2 * regimes.arrest_parameter())) == pytest.approx(least.x, rel=1e-5)
    assert float(regimes.ARREST_THRESHOLD) == pytest.approx(math.sqrt(2))
    # twice the Laplace limit
    assert str(regimes.arrest_threshold_exact(20)).startswith("1.325486838698363161")


@pytest.mark.parametrize("number", [0.05, 0.4, 1.0, 1.3, 1.32])
def test_exact_stopping_depth(number: float) -> None:
    """A catenary of that sag, by its parameter, has the yield stress at its supports, and no shallower one has."""
    depth = float(regimes.stopping_depth_exact(number))
    parameter = brentq(lambda a: a * (math.cosh(1 / (2 * a)) - 1) - depth, 0.4, 1e3)
    assert number * parameter * math.cosh(1 / (2 * parameter)) == pytest.approx(1, rel=1e-9)
    shallower = parameter * 1.01
    assert number * shallower * math.cosh(1 / (2 * shallower)) > 1


def test_orders_of_the_shallow_expansions() -> None:
    """(3.13) is off by G^3, the consistent formula by G^5."""
    errors: dict[str, list[float]] = {"printed": [], "consistent": []}
    for number in (sp.Rational(1, 5), sp.Rational(1, 10)):
        exact = regimes.stopping_depth_exact(number, 30)
        for label, equation in (("printed", regimes.STOPPING_DEPTH), ("consistent", regimes.STOPPING_DEPTH_SECOND)):
            errors[label].append(float(abs(equation.right.subs(G, number).n(30) - exact)))
    orders = {label: math.log2(coarse / fine) for label, (coarse, fine) in errors.items()}
    assert orders["printed"] == pytest.approx(3, abs=0.05)
    assert orders["consistent"] == pytest.approx(5, abs=0.1)


@pytest.mark.parametrize(
    ("equation", "threshold"),
    [
        (regimes.STOPPING_DEPTH, regimes.ARREST_THRESHOLD),
        (regimes.STOPPING_DEPTH_SECOND, regimes.ARREST_THRESHOLD_SECOND),
    ],
)
def test_stopping_depth_ends_at_its_own_threshold(equation: regimes.Equation, threshold: sp.Expr) -> None:
    assert equation.left == H_stop / L
    slope = sp.diff(equation.right, G)
    assert sp.im(equation.right.subs(G, threshold * sp.Rational(1001, 1000)).n()) != 0
    assert abs(slope.subs(G, threshold * (1 - sp.Rational(1, 10**8))).n()) > 100


def test_catenary_in_its_parameter() -> None:
    """Sag by integrating the slope, stress by adding up the weight."""
    a = 0.37
    at = {
        u_L: 1 / (2 * a),
        L: 1,
        **{s: 1 for s in regimes.CATENARY_STRESS.right.free_symbols if s.name in ("rho", "g")},
    }
    fall = quad(lambda x: math.sinh(x / a), 0, 0.5)[0]
    weight = quad(lambda x: math.sqrt(1 + math.sinh(x / a) ** 2), 0, 0.5)[0]
    assert float(regimes.CATENARY_SAG.right.subs(at)) == pytest.approx(fall)
    assert float(regimes.CATENARY_STRESS.right.subs(at)) == pytest.approx(math.hypot(a, weight))
    assert regimes.CATENARY_SAG.left == H


# The closed forms of the sagging Maxwell filament against quadrature, root finding and integration.
Floats = npt.NDArray[np.float64]
LOAD = 3.3e-5
PAPER = {B: LOAD, alpha: asy.TOLERANCE}


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


def test_tension_against_bending_in_figure_2() -> None:
    ratio = asy.TENSION_TO_BENDING.subs({asy.K_I: sp.Rational(1, 12), phi: 4 * 0.0094})
    assert float(ratio.subs(asy.delta, 0.025)) == pytest.approx(0.094, abs=1e-3)
    assert float(ratio.subs(asy.delta, 0.0025)) == pytest.approx(9.4, abs=0.1)


# The inverse map of rheometry against numbers: round trips, finite differences, random errors, other beams.
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


@pytest.mark.statistical
def test_errors_of_many_noisy_measurements() -> None:
    """Both covariances against the scatter of inverted random measurements.

    A variance of N draws is known to sqrt(2/N), a covariance of two quantities of correlation r to sqrt(1 + 1/r^2)/
    sqrt(N) of itself, which is 1.1 of the former at r = 0.8, the least here; far is how far a normal deviate goes. The
    rest of the 4 % is for what the linear theory of errors leaves out, some 0.1 %.
    """
    relaxation = 0.035
    deviations = np.array([0.002, 0.004, 0.003])
    true = np.log([frequency(relaxation), ONSET, PAPER_B])
    drawn = true + draws(5).normal(size=(40_000, 3)) * deviations
    far = errors_away() * math.sqrt(2 / 40_000)  # 3.8 %
    variances = dict(zip((var_R, var_t, var_B), deviations**2, strict=True))
    at = {chi: 2 * frequency(relaxation) * relaxation, **variances}
    plain = sp.lambdify((R, t_high, B), rheometry.relaxation_times().ringing, "numpy")

    def estimates(rates: np.ndarray, clocks: np.ndarray, loads: np.ndarray) -> np.ndarray:
        viscous = 1 / (2 * loads)
        return np.log(np.array([viscous / plain(rates, clocks, loads), viscous]))

    rates, clocks, loads = np.exp(drawn).T
    wanted = np.array(rheometry.covariance().subs(at).tolist(), dtype=float)
    assert np.cov(estimates(rates, clocks, loads)) == pytest.approx(wanted, rel=1.15 * far)

    known = {**variances, alpha: sp.Rational(1, 15)}
    average = sp.lambdify((t_high, B), rheometry.combined_log_B().subs(known), "numpy")
    better = np.exp(average(clocks, loads))
    onset = (better / 3) ** 0.2 * (6 / 15) ** -0.6
    wanted = np.array(rheometry.combined_covariance().subs(at).tolist(), dtype=float)
    assert np.cov(estimates(rates, onset, better)) == pytest.approx(wanted, rel=1.15 * far)

    disagreement = sp.lambdify((t_high, B), rheometry.misfit().subs(known), "numpy")
    # A square of a normal deviate: the same sqrt(2/N).
    assert np.mean(disagreement(clocks, loads)) == pytest.approx(1, abs=1.05 * far)


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
