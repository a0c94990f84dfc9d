"""Closed forms: regimes, asymptotics and rheometry."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad, solve_bvp
from scipy.optimize import brentq, linprog, minimize_scalar

from softcat_sym.estimates import scaling as prediction
from softcat_sym.physics import beams
from softcat_sym.physics import closed_forms as asy
from softcat_sym.physics.closed_forms import phi
from softcat_sym.physics.cross_sections import CROSS_SECTIONS
from softcat_sym.physics.regimes import tau_star
from softcat_sym.physics.rheometry import B, alpha, t_star
from softcat_sym.scene.ends import SUPPORTS
from softcat_sym.scene.reading import load_scene

# Regimes against numbers that share no formula with them: boundary-value solvers, quadrature, time integration.
RECTANGLE, CIRCLE = (CROSS_SECTIONS[name] for name in ("rectangle", "circle"))
BEAMS = {
    ends: beams.beam_between(*(SUPPORTS[end] for end in ends))
    for ends in (("clamped", "clamped"), ("clamped", "pinned"), ("pinned", "pinned"))
}


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
        assert beams.first_yield(section, beams.beam_between(*(SUPPORTS[end] for end in ends)), 1.0) == pytest.approx(
            wanted
        )
        change = {"filament.section": section.name, "ends.left": ends[0], "ends.right": ends[1]}
        scene = load_scene("arrested-overdamped", change)
        assert prediction.first_yield_gravity_number(scene) == pytest.approx(wanted * 0.03)


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


@pytest.mark.parametrize(("clamped", "beam_held"), [(True, beams.CLAMPED), (False, beams.PINNED)])
def test_overshoot_of_a_weight_applied_at_once(clamped: bool, beam_held: beams.Beam) -> None:
    moment = ringing_moment(np.linspace(0, 40, 400_001), clamped=clamped, modes=6)
    assert abs(moment[0]) < 1e-2
    assert 1.97 < np.max(np.abs(moment)) <= beam_held.overshoot_bound


@pytest.mark.parametrize("k", [0.5, 1.94, 6.0, 20.0])
def test_ramp_gain_against_the_oscillator_itself(k: float) -> None:
    """Duhamel's integral by quadrature, after the ramp."""
    rate = lambda v: 30 * v**2 * (1 - v) ** 2  # noqa: E731
    cosine = quad(lambda v: rate(v) * math.cos(k * v), 0, 1)[0]
    sine = quad(lambda v: rate(v) * math.sin(k * v), 0, 1)[0]
    assert abs(beams.ramp_gain(k)) == pytest.approx(math.hypot(cosine, sine), rel=1e-9)


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
        assert beams.plastic_collapse(section, beams.CLAMPED, 1.0) == pytest.approx(wanted)


def test_lightest_stressed_catenary() -> None:
    least = minimize_scalar(
        lambda a: a * math.cosh(1 / (2 * a)), bounds=(0.2, 2), options={"xatol": 1e-12}, method="bounded"
    )
    assert least.fun == pytest.approx(0.754440, abs=1e-6)
    assert pytest.approx(1 / least.fun, rel=1e-10) == beams.ARREST_THRESHOLD_EXACT
    # twice the Laplace limit
    assert pytest.approx(1.325486838698363161, rel=1e-15) == beams.ARREST_THRESHOLD_EXACT


@pytest.mark.parametrize("number", [0.05, 0.4, 1.0, 1.3, 1.32])
def test_exact_stopping_depth(number: float) -> None:
    """A catenary of that sag, by its parameter, has the yield stress at its supports, and no shallower one has."""
    depth = beams.stopping_depth_exact(number)
    parameter = brentq(lambda a: a * (math.cosh(1 / (2 * a)) - 1) - depth, 0.4, 1e3)
    assert number * parameter * math.cosh(1 / (2 * parameter)) == pytest.approx(1, rel=1e-9)
    shallower = parameter * 1.01
    assert number * shallower * math.cosh(1 / (2 * shallower)) > 1


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
