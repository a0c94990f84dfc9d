"""The oracle against what needs no other program: closed forms, conservation, order, and converged values."""

from __future__ import annotations

import numpy as np
import pytest

from .rk4_filament import E_STAR, Filament, overstress_means, run

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
