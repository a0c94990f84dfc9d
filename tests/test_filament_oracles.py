"""The oracles of the moving filament against closed forms, conservation, order, and converged values."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq

from tests.common import rk4_filament
from tests.common.reissner_filament import Filament as Shearing
from tests.common.reissner_filament import run as run_shearing
from tests.common.rk4_filament import E_STAR, Filament, overstress_means, run

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


@pytest.mark.parametrize("closure", ["printed", "material"])
def test_free_fall_until_the_ends_are_felt(closure: str):
    r = run(0.002, 1.9, 26, None, "bingham", closure, 40, 3.0, g_on=0.0, outputs=(1.0, 2.0))
    np.testing.assert_allclose(r.midpoint, -(r.times**2) / (2 * E_STAR), rtol=1e-6)


def test_ramped_free_fall():
    r = run(0.005, 1.9, 26, None, "elastic", "material", 40, 2.0, g_on=10.0, outputs=())
    q = r.times[-1] / 10.0  # twice integrated smooth step
    np.testing.assert_allclose(r.midpoint, -(100 / E_STAR) * (q**5 / 2 - q**6 / 2 + q**7 / 7), rtol=1e-3)


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


def test_step_is_stable_for_waves_and_for_stiff_relaxation() -> None:
    for tau in [1e-4, 1e-3, 0.02, 1.0]:
        f = Filament(0.03, 1e-3, tau, 1.0, "maxwell", "material", 8, 0.0)
        Y = f.initial()
        Y += 1e-9 * np.random.default_rng(2).normal(size=Y.size) * (Y == 0)
        z, v, *_ = f.views(Y)
        z[-1], v[-1], z[0], v[0] = 0.5, 0.0, 1j * z[0].imag, 1j * v[0].imag
        f.advance(Y, 0.0, 200 * f.stable_step(), f.stable_step())
        assert np.abs(v).max() < 0.1


@pytest.mark.slow
@pytest.mark.parametrize(("G", "closure"), list(MID))
def test_converged_midpoints_of_section_3(G: float, closure: str):
    r = run(0.03, G, 26, None, "bingham", closure, 40, 460.0)
    # N = 40: the late creep of the arrested case is 1.3 % short (a hinge at the clamp), at N = 80 0.3 %
    np.testing.assert_allclose(r.midpoint[:3], MID[G, closure][:3], rtol=0.006)
    np.testing.assert_allclose(r.midpoint[3], MID[G, closure][3], rtol=0.014 if G == 0.4 else 0.009)


Array = NDArray[np.float64]

C = (5 / 6) / 2.9  # shear stiffness per E A0
HALF = np.linspace(0.0, 0.5, 21)
SKEW = 0.5 * np.linspace(0.0, 1.0, 13) ** 0.7  # finer at the clamp


def energy(f: Shearing, x_X: Array, y_X: Array, psi: Array, eps_p: Array, gam_p: Array) -> Array:
    """Stored energy, written anew; analytic in its arguments, so that a complex step differentiates it."""
    p, k = (psi[1:] + psi[:-1]) / 2, (psi[1:] - psi[:-1]) / f.dX
    Lam, Gam = x_X * np.cos(p) + y_X * np.sin(p), y_X * np.cos(p) - x_X * np.sin(p)
    eps = np.log(Lam) - k / Lam * (f.delta * Lam**-0.5 / 2) * f.zeta[:, None]
    return f.dX @ (f.mean @ ((eps - eps_p) ** 2 / 2 + C * (Gam / Lam - gam_p) ** 2 / 2))


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


def test_thin_beam_is_the_limit():
    assert timoshenko_frequency(1e-3) * 12**0.5 / 1e-3 == pytest.approx(4.730041**2, rel=1e-4)


def test_first_mode_returns_after_its_period():
    f, A = small_motion(0.1, 10)
    squares, modes = np.linalg.eig(A)
    first = squares.real.argmin()
    shape, period = modes[:, first].real, 2 * np.pi / squares[first].real ** 0.5
    Y = f.initial()
    f.views(Y).z[:-1] += 1e-6j * shape
    f.advance(Y, 0.0, period / 2, f.stable_step())
    np.testing.assert_allclose(f.views(Y).z[:-1].imag, -1e-6 * shape, atol=1e-11)
    f.advance(Y, period / 2, period, f.stable_step())
    np.testing.assert_allclose(f.views(Y).z[:-1].imag, 1e-6 * shape, atol=1e-11)


@pytest.mark.parametrize(
    ("Lam", "Gam", "eps_Y"), [(1.2, 0.0, 0.05), (1.0, 0.3, 0.05), (1.2, 0.3, 0.05), (0.9, 0.2, 0.0)]
)
def test_held_strain_relaxes_as_von_mises(Lam: float, Gam: float, eps_Y: float):
    # So thick that the sections cannot turn: homogeneous stretch and shear, nothing moves.
    f = Shearing(np.linspace(-0.5, 0.5, 5), 1e5, 0.0, 2.0, eps_Y, 3)
    Y = f.initial()
    f.views(Y).z[:] *= Lam + 1j * Gam
    sigma, tau = np.log(Lam), C * Gam / Lam
    for before, t in ((0.0, 1.0), (1.0, 3.0), (3.0, 40.0)):
        f.advance(Y, before, t, 0.05)
        q = f.solve_angles(f.views(Y).z, f.means(f.views(Y)))
        stress = [part[1, 2] for part in f.fibre_stresses(q, f.views(Y))]
        if Gam == 0.0:
            assert stress[0] == pytest.approx(eps_Y + (sigma - eps_Y) * np.exp(-t / 2.0), rel=1e-7)
        elif Lam == 1.0:  # 3 tau^2 = eps_Y^2 at yield, relaxing 3 C times as fast
            left = (tau - eps_Y / 3**0.5) * np.exp(-3 * C * t / 2.0)
            assert stress[1] == pytest.approx(eps_Y / 3**0.5 + left, rel=1e-7)
        elif t < 40.0:  # whatever phi does in time, d log tau = 3 C d log sigma
            assert stress[1] / tau == pytest.approx((stress[0] / sigma) ** (3 * C), rel=1e-7)
            assert abs(stress[0]) < abs(0.9 * sigma)
    if eps_Y:
        assert stress[0] ** 2 + 3 * stress[1] ** 2 == pytest.approx(eps_Y**2, rel=1e-4)


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
        mid, zero = (X[1:] + X[:-1]) / 2, np.zeros(N)
        plain = f.section(stretch(mid) + 0j, np.zeros(N + 1), (zero, zero, zero))
        added = f.add_gradient(plain).n1 - plain.n1
        exact = -double_force(mid + 1e-30j).imag / 1e-30
        error.append(np.sqrt(f.dX @ (added - exact) ** 2) / np.abs(exact).max())
        assert f.dX @ added == pytest.approx(0.0, abs=1e-15)
    assert error[1] < 0.32 * error[0] < 0.01


def test_compressed_cells_have_no_gradient_term():
    f = Shearing(HALF, 0.1, 0.0, 1.0, 1.0, 2, beta=0.5)
    zero = np.zeros(20)
    plain = f.section(0.9 + 0.05 * np.cos(7.0 * HALF[1:]) + 0j, np.zeros(21), (zero, zero, zero))
    np.testing.assert_array_equal(f.add_gradient(plain).n1, plain.n1)


def test_thinner_filaments_come_closer_to_the_published_kinematics():
    def extrapolated(coarse: float, fine: float) -> float:
        return (4 * fine - coarse) / 3

    apart = []
    for delta in (0.06, 0.03):
        scene = {"delta": delta, "G": 1.9, "V": 26}
        shearing = [run_shearing(**scene, nodes=N, fibres=6, duration=20.0, times=()).midpoint[-1] for N in (15, 30)]
        rigid = [
            rk4_filament.run(
                **scene, eps_Y=None, law="bingham", closure="material", N=N, t_end_elastic=20.0, outputs=()
            ).midpoint[-1]
            for N in (15, 30)
        ]
        apart.append(extrapolated(*shearing) / extrapolated(*rigid) - 1.0)
    assert 0.0 < apart[1] < 0.006
    assert apart[1] < 0.4 * apart[0]
