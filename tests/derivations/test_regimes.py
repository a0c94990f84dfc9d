"""Regimes against numbers that share no formula with them: boundary-value solvers, quadrature, time integration."""

from __future__ import annotations

import math

import mpmath
import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad, solve_bvp
from scipy.optimize import brentq, linprog, minimize_scalar

from softcat_sym.effects import scaling_estimates as prediction
from softcat_sym.effects.expected_regime import expected_regime
from softcat_sym.physics import equation as dimensions
from softcat_sym.physics import regimes
from softcat_sym.physics.regimes import BEAMS, CLAMPED, PINNED, G, H, H_stop, delta, k_on, psi_T, u_L
from softcat_sym.physics.sections import CIRCLE, RECTANGLE
from softcat_sym.physics.symbols import L
from softcat_sym.scene.reading import load_scene

SECTIONS = [RECTANGLE, CIRCLE]
MODULUS_OVER_WEIGHT = 4e6 / (1900 * 9.81 * 0.2)


def name(value: object) -> str:
    return getattr(value, "name", None) or (" ".join(value) if isinstance(value, tuple) else str(value))


def test_every_term_has_one_dimension() -> None:
    for equation in regimes.EQUATIONS:
        dimensions.check(equation)


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


@pytest.mark.parametrize(("section", "wanted"), [(RECTANGLE, 4.0), (CIRCLE, 32 / (3 * math.pi))], ids=name)
def test_collapse_number(section: object, wanted: float) -> None:
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


def test_no_depth_beyond_the_threshold() -> None:
    for number in (1.3255, 1.4, 0):
        with pytest.raises(ValueError, match="no catenary"):
            regimes.stopping_depth_exact(number)


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


def test_paper_value_of_the_stopping_depth() -> None:
    assert float(regimes.STOPPING_DEPTH.right.subs(G, 0.4)) == pytest.approx(0.05, abs=2e-3)
    scene = load_scene("arrested-overdamped", {"groups.duration": 1e9})
    forecast_motion = expected_regime(scene, ("inertia", "bending", "viscous-flow", "yielding")).stopping_depth_paper
    assert forecast_motion == pytest.approx(float(regimes.STOPPING_DEPTH.right.subs(G, 0.4)))


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


def test_regimes_share_out_the_plane() -> None:
    for slender in np.linspace(0.01, 0.95, 9):
        for number in np.linspace(0.013, 3.1, 17):
            at = {delta: sp.Float(slender), G: sp.Float(number)}
            labels = [regimes.no_yield(), regimes.arrested(), regimes.descending()]
            held = [bool(label.subs(at)) for label in labels]
            assert held == [
                number < 2 * slender,
                2 * slender <= number < math.sqrt(2),
                number >= max(2 * slender, math.sqrt(2)),
            ]


def test_the_paper_s_groups() -> None:
    """Three of the paper's four scenes; the yield strain of the first is misprinted."""
    for bundled, strain in (("no-yield", 0.0932), ("arrested-overdamped", 0.00233), ("continual-descent", 0.00049)):
        scene = load_scene(bundled)
        assert scene.material.yield_stress / scene.material.youngs_modulus == pytest.approx(strain, rel=2e-3)
    assert mpmath.mpf(1) / MODULUS_OVER_WEIGHT / mpmath.mpf("0.01") == pytest.approx(0.0932, rel=1e-3)
