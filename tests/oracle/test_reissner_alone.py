"""The shearing oracle against what needs no other program: derivatives of its energy, closed forms, conservation."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq

from . import rk4_filament
from .reissner_filament import Filament, run

Array = NDArray[np.float64]

C = (5 / 6) / 2.9  # shear stiffness per E A0
HALF = np.linspace(0.0, 0.5, 21)
SKEW = 0.5 * np.linspace(0.0, 1.0, 13) ** 0.7  # finer at the clamp


def energy(f: Filament, x_X: Array, y_X: Array, psi: Array, eps_p: Array, gam_p: Array) -> Array:
    """Stored energy, written anew; analytic in its arguments, so that a complex step differentiates it."""
    p, k = (psi[1:] + psi[:-1]) / 2, (psi[1:] - psi[:-1]) / f.dX
    Lam, Gam = x_X * np.cos(p) + y_X * np.sin(p), y_X * np.cos(p) - x_X * np.sin(p)
    eps = np.log(Lam) - k / Lam * (f.delta * Lam**-0.5 / 2) * f.zeta[:, None]
    return f.dX @ (f.mean @ ((eps - eps_p) ** 2 / 2 + C * (Gam / Lam - gam_p) ** 2 / 2))


def some_state(beta: float | None = None) -> tuple[Filament, Array]:
    rng = np.random.default_rng(3)
    f = Filament(SKEW, 0.2, 0.0, 1.0, 1.0, 5, beta=beta)
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


def small_motion(delta: float, N: int) -> tuple[Filament, Array]:
    """Stiffness over mass of small vertical motions about the straight filament."""
    f = Filament(np.linspace(0.0, 0.5, N + 1), delta, 0.0, np.inf, 1.0, 2)
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
    f = Filament(np.linspace(-0.5, 0.5, 5), 1e5, 0.0, 2.0, eps_Y, 3)
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
            f = Filament(SKEW, 0.1, 0.05, tau, eps_Y, 5, 4.0, beta)
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
    half = Filament(SKEW, 0.05, 0.01, 1.0, 0.005, 4, 3.0, 1 / 48)
    whole = Filament(np.concatenate([-SKEW[:0:-1], SKEW]), 0.05, 0.01, 1.0, 0.005, 4, 3.0, 1 / 48)
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
        f = Filament(X, 0.1, 0.0, 1.0, 1.0, 2, beta=0.5)
        mid, zero = (X[1:] + X[:-1]) / 2, np.zeros(N)
        plain = f.section(stretch(mid) + 0j, np.zeros(N + 1), (zero, zero, zero))
        added = f.add_gradient(plain).n1 - plain.n1
        exact = -double_force(mid + 1e-30j).imag / 1e-30
        error.append(np.sqrt(f.dX @ (added - exact) ** 2) / np.abs(exact).max())
        assert f.dX @ added == pytest.approx(0.0, abs=1e-15)
    assert error[1] < 0.32 * error[0] < 0.01


def test_compressed_cells_have_no_gradient_term():
    f = Filament(HALF, 0.1, 0.0, 1.0, 1.0, 2, beta=0.5)
    zero = np.zeros(20)
    plain = f.section(0.9 + 0.05 * np.cos(7.0 * HALF[1:]) + 0j, np.zeros(21), (zero, zero, zero))
    np.testing.assert_array_equal(f.add_gradient(plain).n1, plain.n1)


def test_thinner_filaments_come_closer_to_the_published_kinematics():
    def extrapolated(coarse: float, fine: float) -> float:
        return (4 * fine - coarse) / 3

    apart = []
    for delta in (0.06, 0.03):
        scene = {"delta": delta, "G": 1.9, "V": 26}
        shearing = [run(**scene, nodes=N, fibres=6, duration=20.0, times=()).midpoint[-1] for N in (15, 30)]
        rigid = [
            rk4_filament.run(
                **scene, eps_Y=None, law="bingham", closure="material", N=N, t_end_elastic=20.0, outputs=()
            ).midpoint[-1]
            for N in (15, 30)
        ]
        apart.append(extrapolated(*shearing) / extrapolated(*rigid) - 1.0)
    assert 0.0 < apart[1] < 0.006
    assert apart[1] < 0.4 * apart[0]
