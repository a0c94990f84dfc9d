"""Static curves and drawn bars of the oracles against closed forms, and against themselves by another road."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from tests.common import curves
from tests.common import materials as m

X = np.linspace(0, 1.0, 11)
FLAT = ("clamped", 0.0)
PIN = ("pinned", 0.0)
FREE = ("free", 0.0)


def cantilever(section: curves.Elastic, weight: float, X: np.ndarray, angle: float = 0.0) -> curves.Shape:
    return curves.held(section, weight, 1.0, 0.0, X, ("clamped", angle), FREE)


@pytest.mark.parametrize("drop", [0.0, 0.3, -0.5])
def test_catenary_meets_its_supports_and_balances(drop: float) -> None:
    length = 1.4
    chain = curves.catenary(1.0, drop, length)
    x, y = chain.at(np.array([0.0, length]))
    np.testing.assert_allclose(x, [0, 1], atol=1e-12)
    np.testing.assert_allclose(y, [0, -drop], atol=1e-12)
    # tension differs by the weight of the drop, and the vertical ones carry the whole weight
    assert chain.tensions[0] - chain.tensions[1] == pytest.approx(drop, abs=1e-12)
    vertical = [np.sqrt(tension**2 - chain.a**2) for tension in chain.tensions]
    assert sum(vertical) == pytest.approx(length, rel=1e-12)
    arc = np.linspace(0, length, 20001)
    assert np.hypot(*(np.diff(part) for part in chain.at(arc))).sum() == pytest.approx(length, rel=1e-8)


def test_catenary_refuses_a_short_chain() -> None:
    with pytest.raises(ValueError, match="too short"):
        curves.catenary(1.0, 0.5, 1.1)


@pytest.mark.parametrize(("length", "drop"), [(1.0, 0.0), (1.2, 0.3), (0.9, 0.2)])
def test_string_is_irvines_elastic_catenary(length: float, drop: float) -> None:
    """Irvine, Cable Structures (1981), section 1.3: x and y in closed form of H and V_0."""
    EA, at = 3.0, np.linspace(0, length, 9)
    found = curves.hanging_string(curves.linear_stretch(EA), 1.0, length, 1.0, at, drop=drop)
    H, V0 = found.horizontal, found.vertical
    x = H * at / EA + H * (np.arcsinh((V0 + at) / H) - np.arcsinh(V0 / H))
    y = (V0 * at + at**2 / 2) / EA + np.hypot(H, V0 + at) - np.hypot(H, V0)
    np.testing.assert_allclose(found.x, x, atol=1e-12)
    np.testing.assert_allclose(found.y, y, atol=1e-12)
    assert found.x[-1] == pytest.approx(1.0, abs=1e-12)
    assert found.y[-1] == pytest.approx(-drop, abs=1e-12)


def test_stiff_string_is_the_catenary() -> None:
    at = np.linspace(0, 1.3, 14)
    for stretch in (curves.linear_stretch(1e9), curves.true_strain_stretch(1e9)):
        found = curves.hanging_string(stretch, 1.0, 1.3, 1.0, at, drop=0.2)
        x, y = curves.catenary(1.0, 0.2, 1.3).at(at)
        np.testing.assert_allclose(found.x, x, atol=1e-8)
        np.testing.assert_allclose(found.y, y, atol=1e-8)


def test_stretch_of_constant_volume() -> None:
    s = curves.true_strain_stretch(2.0)(np.array([-0.5, 0.0, 0.1, 0.7]))
    np.testing.assert_allclose(2.0 * np.log(s) / s, [-0.5, 0.0, 0.1, 0.7], atol=1e-14)
    assert s[-1] > 1.9


def test_elastic_section_has_an_energy() -> None:
    """W = EA (log s)^2/2 + EI theta_X^2/(2 s^3), of true strain in a thinning section: Q = W_s, -M = W_theta_X."""
    EA, EI, s, k, small = 3.0, 0.2, 1.1, 0.7, 1e-5

    def energy(s: float, k: float) -> float:
        return EA * np.log(s) ** 2 / 2 + EI * k**2 / (2 * s**3)

    Q = (energy(s + small, k) - energy(s - small, k)) / (2 * small)
    M = -(energy(s, k + small) - energy(s, k - small)) / (2 * small)
    found = curves.uniform(EA, EI, 0.0).deform(np.zeros(1), np.array([Q]), np.array([M]))
    np.testing.assert_allclose(np.ravel(found), [s, k], rtol=1e-8)


def test_light_cantilever_is_the_beam() -> None:
    assert cantilever(curves.uniform(np.inf, 1.0), 1e-4, X).y[-1] == pytest.approx(-1e-4 / 8, rel=1e-6)


@pytest.mark.parametrize("EA", [np.inf, 1000.0])
def test_heavy_cantilever_balances(EA: float) -> None:
    fine = np.linspace(0, 1, 2001)
    heavy = cantilever(curves.uniform(EA, 1.0), 12.0, fine)
    # moment at the clamp is the weight times the distance of its centre
    assert heavy.M[0] == pytest.approx(12.0 * np.trapezoid(heavy.x, fine), rel=1e-6)
    assert heavy.theta[-1] < -1.1


def test_heavy_elastica_by_shooting() -> None:
    """EI theta'' = w (L - s) cos theta (Bickley 1934), from the free end with theta' = 0."""
    load = 12.0
    found = cantilever(curves.uniform(np.inf, 1.0), load, X)

    def shoot(tip: float) -> np.ndarray:
        def rates(s: float, u: np.ndarray) -> list[float]:
            return [u[1], load * (1 - s) * np.cos(u[0]), np.cos(u[0]), np.sin(u[0])]

        return solve_ivp(rates, (1, 0), [tip, 0, 0, 0], "DOP853", rtol=1e-11, atol=1e-13).y[:, -1]

    end = shoot(brentq(lambda tip: shoot(tip)[0], -1.57, 0, xtol=1e-13))
    assert found.x[-1] == pytest.approx(-end[2], rel=1e-8)
    assert found.y[-1] == pytest.approx(-end[3], rel=1e-8)


def test_upright_column_falls_over_beyond_greenhills_height() -> None:
    """w L^3/EI = 7.8373 (Greenhill 1881): near it a lean of the clamp is multiplied by 1/(1 - load/critical)."""
    gain = []
    for load in (7.4, 7.6):
        lean = cantilever(curves.uniform(np.inf, 1.0), load, X, np.pi / 2 - 1e-5)
        gain.append(1e-5 / (np.pi / 2 - lean.theta[-1]))
    critical = 7.6 + 0.2 * gain[1] / (gain[0] - gain[1])
    assert critical == pytest.approx(7.8373, rel=1e-3)


def test_unloaded_cantilever_is_its_natural_arc() -> None:
    arc = cantilever(curves.uniform(np.inf, 1.0, 1.5), 0.0, X)
    np.testing.assert_allclose(arc.x, np.sin(1.5 * X) / 1.5, atol=1e-9)
    np.testing.assert_allclose(arc.y, (1 - np.cos(1.5 * X)) / 1.5, atol=1e-9)


@pytest.mark.parametrize(("ends", "constant"), [((FLAT, FLAT), 384.0), ((FLAT, PIN), 192.0), ((PIN, PIN), 384 / 5)])
def test_linear_beams(ends: tuple[curves.End, curves.End], constant: float) -> None:
    """Midpoint w L^4/(C EI), and the same from the whole theory at small load."""
    EI, weight = 2.0, 2e-3
    beam = curves.linear_beam(lambda at: np.full_like(at, EI), lambda at: np.full_like(at, weight), 1.0, X, *ends)
    assert beam[5] == pytest.approx(-weight / (constant * EI), rel=1e-9)
    assert abs(beam[-1]) < 1e-15
    whole = curves.held(curves.uniform(1e4, EI), weight, 1.0, 1.0, X, *ends)
    np.testing.assert_allclose(whole.y, beam, atol=2e-4 * abs(beam[5]))


def test_beams_with_a_load_at_midspan() -> None:
    EI = 2.0

    def sag(left: curves.End, right: curves.End) -> float:
        none = curves.linear_beam(np.ones_like, np.zeros_like, 1.0, X, left, right)
        assert not none.any()
        stiff = curves.linear_beam(lambda at: 0 * at + EI, np.zeros_like, 1.0, X, left, right, point_load=1.0)
        return -float(stiff[5])

    assert sag(PIN, PIN) == pytest.approx(1 / (48 * EI), rel=1e-10)
    assert sag(FLAT, FLAT) == pytest.approx(1 / (192 * EI), rel=1e-10)
    tip = curves.linear_beam(np.ones_like, np.ones_like, 1.0, X, FLAT, FREE)[-1]
    assert tip == pytest.approx(-1 / 8, rel=1e-10)


def test_tapered_cantilever() -> None:
    """EI = (1 - x/2)^4, weight (1 - x/2)^2: theta' = M/EI with M = -int (u - x) w du, integrated once more by hand."""
    found = curves.linear_beam(lambda x: (1 - x / 2) ** 4, lambda x: (1 - x / 2) ** 2, 1.0, X, FLAT, FREE)
    x = np.linspace(0, 1, 4001)
    p, end = 1 - x / 2, 0.5
    moment = (p**4 - 4 * p * end**3 + 3 * end**4) / 3  # int from x to 1 of (u - x) (1 - u/2)^2 du
    expected = -np.trapezoid((1 - x) * moment / p**4, x)
    assert found[-1] == pytest.approx(expected, rel=1e-6)


def test_beam_with_turned_clamps_is_a_parabola() -> None:
    turned = curves.linear_beam(np.ones_like, np.zeros_like, 1.0, X, ("clamped", -0.01), ("clamped", 0.01))
    np.testing.assert_allclose(turned, -0.01 * X * (1 - X), atol=1e-15)


def test_turned_clamps_at_the_length_of_their_arc_are_that_arc() -> None:
    angle = 0.6
    length = angle / np.sin(angle)
    radius, at = length / (2 * angle), np.linspace(0, length, 7)
    arc = curves.held(curves.uniform(1e6, 1.0), 0.0, length, 1.0, at, ("clamped", -angle), ("clamped", angle))
    np.testing.assert_allclose(arc.x, radius * (np.sin(at / radius - angle) + np.sin(angle)), atol=1e-5)
    np.testing.assert_allclose(arc.y, radius * (np.cos(angle) - np.cos(at / radius - angle)), atol=1e-5)


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
