"""Static curves and drawn bars of the oracles against closed forms, and against themselves by another road."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from tests.common import curves
from tests.common import materials as m
from tests.common.reissner_filament import Filament as Shearing
from tests.common.rk4_filament import Filament, overstress_means, run
from tests.marks import few

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


def test_elastic_section_has_an_energy() -> None:
    """W = EA (log s)^2/2 + EI theta_X^2/(2 s^3), of true strain in a thinning section: Q = W_s, -M = W_theta_X."""
    EA, EI, s, k, small = 3.0, 0.2, 1.1, 0.7, 1e-5

    def energy(s: float, k: float) -> float:
        return EA * np.log(s) ** 2 / 2 + EI * k**2 / (2 * s**3)

    Q = (energy(s + small, k) - energy(s - small, k)) / (2 * small)
    M = -(energy(s, k + small) - energy(s, k - small)) / (2 * small)
    found = curves.uniform(EA, EI, 0.0).deform(np.zeros(1), np.array([Q]), np.array([M]))
    np.testing.assert_allclose(np.ravel(found), [s, k], rtol=1e-8)


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


@pytest.mark.slow
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


# The filaments in plain NumPy that the package is compared with, themselves against closed forms.
MID = {  # midpoint/L at t~ = 46, 115, 230, 460, V = 26, delta = 0.03, converged in N
    (0.4, "material"): (-0.06256, -0.06386, -0.06534, -0.0666),
    (0.4, "printed"): (-0.06240, -0.06368, -0.06512, -0.0664),
    (1.9, "material"): (-0.12148, -0.16379, -0.20092, -0.24409),
    (1.9, "printed"): (-0.12183, -0.16497, -0.20339, -0.24978),
}


def elastic(g: float, N: int, delta: float = 0.03, g_on: float = 0.0, closure: str = "material", **kw) -> Filament:
    return Filament(delta, g, 1.0, 1.0, "elastic", closure, N, g_on, **kw)


def test_section_means_equal_quadrature():
    rng = np.random.default_rng(1)
    S = rng.normal(size=(2, 400)) * 2.0
    S[:, :6] = [[2.0, -2.0, 0.0, 0.0, 1.5, 1.0], [0.0, 0.0, 0.0, 3.0, 1e-13, 0.0]]
    zeta = (np.arange(20000) + 0.5) / 10000 - 1.0
    sigma = S[0, :, None] + S[1, :, None] * zeta
    over = np.sign(sigma) * np.maximum(np.abs(sigma) - 1.0, 0.0)
    out = np.empty_like(S)
    overstress_means(S, 1.0, 1.0, np.empty((5, *S.shape)), out)
    np.testing.assert_allclose(out, [over.mean(1), (over * zeta).mean(1)], atol=1e-7)


@pytest.mark.parametrize("ends", ["clamped", "pinned"])
def test_elastic_material_closure_conserves_energy_at_large_strain(ends: str):
    drift = []
    for part in (1.0, 0.5):
        f = elastic(0.1, 20, delta=0.05, ends=ends)
        Y = f.initial()
        f.advance(Y, 0.0, 8.0, part * f.stable_step())
        kinetic, stored, potential = f.energy(Y, 8.0)
        drift.append(abs(kinetic + stored + potential) / max(kinetic, stored))
    assert stored > 1e-4
    assert f.s_in.max() > 1.01
    assert drift[1] < 1e-4
    assert drift[1] < 0.3 * drift[0]


def test_clamped_beam_sag_and_period() -> None:
    for closure in ["printed", "material"]:
        for section, k2 in [("rectangle", 1 / 3), ("circle", 1 / 4)]:
            delta, g = 0.1, 1e-6
            bending = delta**2 * k2 / 4  # I/(A L^2)
            period = 2 * np.pi / (4.730041**2 * bending**0.5)
            f = elastic(g, 20, delta=delta, closure=closure, section=section)
            Y, n, mid, dt = f.initial(), 200, [], f.stable_step()
            for i in range(2 * n):
                mid.append(f.views(Y)[0][0].imag)
                f.advance(Y, i * period / n, (i + 1) * period / n, dt)
            basis = [np.cos(2 * np.pi * np.arange(2 * n) / n), np.ones(2 * n)]
            first, mean = np.linalg.lstsq(np.stack(basis, 1), np.array(mid), rcond=None)[0]
            assert mean == pytest.approx(-g / (384 * bending), rel=0.01)
            # a sudden load swings about the static sag, almost all of it in the first mode
            assert -first / mean == pytest.approx(1.0, abs=0.03)
            turn = np.argmin(mid[: int(1.3 * n)][int(0.2 * n) :]) + 0.2 * n
            assert turn / n == pytest.approx(0.5, abs=0.05)


def test_fourth_order_in_time():
    end = []
    for part in (1.0, 0.5, 0.25):
        f = elastic(0.02, 8, g_on=2.0, delta=0.05)
        Y = f.initial()
        f.advance(Y, 0.0, 6.0, part * f.stable_step())
        end.append(Y)
    ratio = np.linalg.norm(end[0] - end[1]) / np.linalg.norm(end[1] - end[2])
    assert 11 < ratio < 24


def test_second_order_in_space():
    end = [run(0.06, 1.9, 26, None, "maxwell", "material", N, 20.0, outputs=()).midpoint[-1] for N in (10, 20, 40)]
    assert 3.2 < (end[0] - end[1]) / (end[1] - end[2]) < 4.8


@pytest.mark.slow
@pytest.mark.parametrize(("G", "closure"), list(MID))
def test_converged_midpoints_of_section_3(G: float, closure: str):
    r = run(0.03, G, 26, None, "bingham", closure, 40, 460.0)
    # N = 40: the late creep of the arrested case is 1.3 % short (a hinge at the clamp), at N = 80 0.3 %
    np.testing.assert_allclose(r.midpoint[:3], MID[G, closure][:3], rtol=0.006)
    np.testing.assert_allclose(r.midpoint[3], MID[G, closure][3], rtol=0.014 if G == 0.4 else 0.009)


Array = NDArray[np.float64]

MU = 1 / 2.9  # shear modulus per E
C = (5 / 6) * MU  # shear stiffness per E A0
SKEW = 0.5 * np.linspace(0.0, 1.0, 13) ** 0.7  # finer at the clamp


def gradient(eps: Array, gam: Array) -> tuple[Array, Array, Array]:
    """Entries 11, 21 and 22 of the deformation gradient of a fibre that stretches and shears."""
    return np.exp(eps), gam * np.exp(eps), np.exp(-eps / 2)


def elastic_part(total: tuple[Array, ...], plastic: tuple[Array, ...]) -> tuple[Array, Array, Array]:
    """F F_p^-1."""
    (f, g, a), (f_p, g_p, a_p) = total, plastic
    return f / f_p, (g - a / a_p * g_p) / f_p, a / a_p


def energy(f: Shearing, x_X: Array, y_X: Array, psi: Array, eps_p: Array, gam_p: Array) -> Array:
    """Stored energy, written anew; analytic in its arguments, so that a complex step differentiates it."""
    p, k = (psi[1:] + psi[:-1]) / 2, (psi[1:] - psi[:-1]) / f.dX
    Lam, Gam = x_X * np.cos(p) + y_X * np.sin(p), y_X * np.cos(p) - x_X * np.sin(p)
    eps = np.log(Lam) - k / Lam * (f.delta * Lam**-0.5 / 2) * f.zeta[:, None]
    gam = (5 / 6) ** 0.5 * Gam / Lam + 0 * eps
    stretched, sheared, _ = elastic_part(gradient(eps, gam), gradient(eps_p, gam_p))
    shear = sheared / stretched
    return f.dX @ (f.mean @ ((np.log(stretched) + shear**2 / 4) ** 2 / 2 + MU * shear**2 / 2))


def some_state(beta: float | None = None) -> tuple[Shearing, Array]:
    rng = np.random.default_rng(3)
    f = Shearing(SKEW, 0.2, 0.0, 1.0, 1.0, 5, beta=beta)
    Y = f.initial()
    s = f.views(Y)
    s.z[:] = 1.2 * SKEW - 0.1j * np.cos(np.pi * SKEW) ** 2 + 0.004 * rng.normal(size=SKEW.size)
    s.eps_p[:] = 0.05 * rng.normal(size=s.eps_p.shape)
    s.gam_p[:] = 0.05 * rng.normal(size=s.gam_p.shape)
    return f, Y


def test_accelerations_and_angles_follow_from_the_stored_energy():
    f, Y = some_state()
    s = f.views(Y)
    rate = f.views(f.rhs(0.0, Y))
    x_X, y_X = np.diff(s.z.real) / f.dX, np.diff(s.z.imag) / f.dX
    h = 1e-30
    for i in range(f.n - 1):
        one = np.eye(f.n)[i] * 1j * h
        forces = [
            -energy(f, x_X + dx, y_X + dy, f.psi + dp, s.eps_p, s.gam_p).imag / h
            for dx, dy, dp in ((np.diff(one) / f.dX, 0, 0 * one), (0, np.diff(one) / f.dX, 0 * one), (0, 0, one))
        ]
        if i > 0:
            assert forces[0] == pytest.approx(f.mass[i] * rate.v[i].real, abs=1e-12)
            assert forces[2] == pytest.approx(0.0, abs=1e-12)
        assert forces[1] == pytest.approx(f.mass[i] * rate.v[i].imag, abs=1e-12)
    assert np.abs(f.psi).max() > 0.1
    assert rate.v[-1] == 0.0


def small_motion(delta: float, N: int) -> tuple[Shearing, Array]:
    """Stiffness over mass of small vertical motions about the straight filament."""
    f = Shearing(np.linspace(0.0, 0.5, N + 1), delta, 0.0, np.inf, 1.0, 2)
    A = np.empty((N, N))
    for j in range(N):
        Y = f.initial()
        f.views(Y).z[j] += 1e-7j
        A[:, j] = -f.views(f.rhs(0.0, Y)).v[:-1].imag / 1e-7
    return f, A


def timoshenko_frequency(delta: float) -> float:
    """First symmetric mode of a clamped beam with shear and no rotary inertia: a cosh(rX) + b cos(qX)."""

    def mismatch(w: float) -> float:
        c2, d4 = w * w / C, w * w / (delta**2 / 12)
        r2 = -c2 / 2 + np.sqrt(c2 * c2 / 4 + d4)
        r, q = np.sqrt(r2), np.sqrt(r2 + c2)
        # psi_X = y_XX + (w^2/C) y must vanish in the mean, y at the clamp
        return np.cosh(r / 2) * (-q + c2 / q) * np.sin(q / 2) - np.cos(q / 2) * (r + c2 / r) * np.sinh(r / 2)

    thin = 4.730041**2 * delta / 12**0.5
    return brentq(mismatch, 0.2 * thin, 1.05 * thin, xtol=1e-14)


@pytest.mark.parametrize("delta", [0.2, 0.03, 0.001])
def test_sag_and_frequency_of_a_timoshenko_beam(delta: float):
    sag, w = 12 / (384 * delta**2) + 1 / (8 * C), timoshenko_frequency(delta)
    errors = []
    for N in (10, 20):
        _, A = small_motion(delta, N)
        found = np.linalg.solve(A, np.ones(N))[0], np.sqrt(np.linalg.eigvals(A).real.min())
        errors.append([found[0] / sag - 1, found[1] / w - 1])
    coarse, fine = np.array(errors)
    assert np.all(np.abs(fine) < 4e-3)
    assert np.all(np.abs(4 * fine - coarse) / 3 < 2e-4)  # second order, thin (no locking) or thick


def relaxing(Lam: float, Gam: float, eps_Y: float, tau: float) -> Callable[[float, Array], Array]:
    """F_p_t = L_p F_p of entries 11 and 21 at a held strain, L_p triangular and its symmetric part von Mises's."""
    total = gradient(np.log(Lam), (5 / 6) ** 0.5 * Gam / Lam)

    def rate(_: float, plastic: Array) -> Array:
        sigma, tau_f, turned = stresses(total, plastic)
        drive = turned * tau_f
        size = np.hypot(sigma, 3**0.5 * drive)
        flow = max(size - eps_Y, 0.0) / tau / size
        along, across, shear = flow * sigma, -flow * sigma / 2, 3 * flow * drive
        f_p, g_p = plastic
        return np.array([along * f_p, shear * f_p + across * g_p])

    return rate


def stresses(total: tuple[Array, ...], plastic: Array) -> tuple[float, float, float]:
    """Sigma, tau and the ratio of entries 22 and 11 of F_e."""
    f, g, a = elastic_part(total, (*plastic, plastic[0] ** -0.5))
    shear = g / f
    sigma = np.log(f) + shear**2 / 4
    return sigma, MU * shear + sigma * shear / 2, a / f


@pytest.mark.parametrize(
    ("Lam", "Gam", "eps_Y"),
    few(
        [(1.2, 0.0, 0.05), (1.0, 1e-3, 1e-4), (1.0, 0.3, 0.05), (1.2, 0.3, 0.05), (0.9, 0.2, 0.0), (1.5, -0.6, 0.1)],
        *((1.2, 0.3, 0.05), (0.9, 0.2, 0.0)),
    ),
)
def test_held_strain_relaxes_as_von_mises(Lam: float, Gam: float, eps_Y: float):
    # So thick that the sections cannot turn: homogeneous stretch and shear, nothing moves.
    f = Shearing(np.linspace(-0.5, 0.5, 5), 1e5, 0.0, 2.0, eps_Y, 3)
    Y = f.initial()
    f.views(Y).z[:] *= Lam + 1j * Gam
    strained = np.log(Lam), (5 / 6) ** 0.5 * Gam / Lam
    times = (0.0, 1.0, 3.0, 40.0)
    rule = relaxing(Lam, Gam, eps_Y, 2.0)
    wanted = solve_ivp(rule, (0.0, 40.0), [1.0, 0.0], "DOP853", times, rtol=1e-11, atol=1e-14).y.T
    for before, t, plastic in zip(times, times[1:], wanted[1:], strict=False):
        f.advance(Y, before, t, 0.05)
        q = f.solve_angles(f.views(Y))
        found = [part[1, 2] for part in (q.fibres.sigma, q.fibres.tau, q.fibres.driving)]
        sigma, tau, turned = stresses(gradient(*strained), plastic)
        assert found == pytest.approx([sigma, tau, turned * tau], rel=1e-7, abs=1e-9)
        if Gam == 0.0:
            assert found[0] == pytest.approx(eps_Y + (strained[0] - eps_Y) * np.exp(-t / 2.0), rel=1e-7)
        elif abs(Gam) < 0.01:  # 3 tau^2 = eps_Y^2 at yield, relaxing 3 mu times as fast
            left = (MU * strained[1] - eps_Y / 3**0.5) * np.exp(-3 * MU * t / 2.0)
            assert found[1] == pytest.approx(eps_Y / 3**0.5 + left, rel=1e-5)
    if eps_Y:
        assert found[0] ** 2 + 3 * found[2] ** 2 == pytest.approx(eps_Y**2, rel=1e-4)


@pytest.mark.slow
def test_energy_balance_closes_with_the_order_of_the_integrator() -> None:
    for tau, eps_Y, beta in [
        (np.inf, 1.0, None),
        (2.0, 0.0, None),
        (2.0, 0.01, None),
        (2.0, 0.01, 1 / 48),
        (2.0, 0.0, 0.1),
    ]:
        gap = []
        for part in (1.0, 0.5):
            f = Shearing(SKEW, 0.1, 0.05, tau, eps_Y, 5, 4.0, beta)
            Y = f.initial()
            f.advance(Y, 0.0, 6.0, part * f.stable_step())
            e = f.energies(Y)
            spent = e["kinetic"] + e["elastic"] + e["dissipated"] + e["gradient"]
            gap.append(abs(spent - e["work"]) / e["work"])
        assert f.views(Y).z[0].imag < -0.1
        assert gap[1] < 1e-8
        assert gap[1] < gap[0] / 8 or beta is not None
        assert e["dissipated"] > 0.1 * e["work"] or tau == np.inf
        assert (e["gradient"] > 10 * gap[1] * e["work"]) == (beta is not None)


def test_whole_span_is_the_half_and_its_mirror_image():
    half = Shearing(SKEW, 0.05, 0.01, 1.0, 0.005, 4, 3.0, 1 / 48)
    whole = Shearing(np.concatenate([-SKEW[:0:-1], SKEW]), 0.05, 0.01, 1.0, 0.005, 4, 3.0, 1 / 48)
    found = []
    for f in (half, whole):
        Y = f.initial()
        f.advance(Y, 0.0, 15.0, half.stable_step())
        found.append((f.views(Y).z, f.psi, f.energies(Y)))
    (z, psi, e), (z2, psi2, e2) = found
    assert z[0].imag < -0.1
    np.testing.assert_allclose(z2, np.concatenate([-z[:0:-1].conj(), z]), atol=1e-9)
    np.testing.assert_allclose(psi2, np.concatenate([-psi[:0:-1], psi]), atol=1e-8)
    assert all(e2[name] == pytest.approx(2 * e[name], rel=1e-6) for name in e)


@pytest.mark.parametrize("grading", [1e-6, 1.5])
def test_gradient_term_is_minus_the_change_of_b_times_slope(grading: float):
    def stretch(X):
        return 1.2 + 0.1 * np.cos(2 * np.pi * X)  # level at both ends

    def double_force(X):
        slope = -0.2 * np.pi * np.sin(2 * np.pi * X)
        return 0.5 * 0.1**2 * np.log(stretch(X)) / stretch(X) ** 5 * slope

    error = []
    for N in (40, 80):
        X = 0.5 * np.tanh(grading * np.linspace(0.0, 1.0, N + 1)) / np.tanh(grading)
        f = Shearing(X, 0.1, 0.0, 1.0, 1.0, 2, beta=0.5)
        mid = (X[1:] + X[:-1]) / 2
        plain = f.section(stretch(mid) + 0j, np.zeros(N + 1), f.views(f.initial()))
        added = f.add_gradient(plain).n1 - plain.n1
        exact = -double_force(mid + 1e-30j).imag / 1e-30
        error.append(np.sqrt(f.dX @ (added - exact) ** 2) / np.abs(exact).max())
        assert f.dX @ added == pytest.approx(0.0, abs=1e-15)
    assert error[1] < 0.32 * error[0] < 0.01
