"""The reduced model, numerically: von Karman's beam, memory by quadrature, energy, both forms of the memory."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import numpy.typing as npt
import pytest
import sympy as sp
from scipy.integrate import quad, solve_bvp, solve_ivp

from softcat_sym.physics import small_deflection as sd
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.equation import check
from softcat_sym.physics.sections import CIRCLE, RECTANGLE

Floats = npt.NDArray[np.float64]


def test_every_term_has_one_dimension() -> None:
    for equation in sd.EQUATIONS:
        check(equation)


@pytest.mark.parametrize(("modulus", "sag"), [(1e5, 0.139709), (1e6, 0.062621), (1e7, 0.025403), (1e8, 0.005982)])
def test_at_rest_it_is_von_karmans_clamped_beam(modulus: float, sag: float) -> None:
    values = {
        sy.E: modulus,
        sy.rho: 636.62,
        sy.g: 9.80665,
        sy.h0: 0.02,
        sy.A0: np.pi * 0.01**2,
        sy.L: 1.0,
    }
    section = sd.small_deflection(CIRCLE, flows=False)
    moment = section.moment.subs(sy.sigma_1, section.stress_bending)
    F = sp.Symbol("F")
    curvature = sp.lambdify(sy.M, sp.solve(moment - sy.M, sd.y_XX)[0].subs(values))
    moment_change = sp.lambdify((F, sy.T, sy.y_X), sp.solve(section.vertical_force - F, sy.M_X)[0])
    weight = float(sp.solve(section.acceleration, sd.F_X)[0].subs(values))
    elongation = sp.lambdify(sy.y_X, section.elongation)
    tension = sp.lambdify(sd.e_mean, section.tension.subs(sy.sigma_0, section.stress_mean).subs(values))

    def slopes(x: Floats, u: Floats, p: Floats) -> Floats:
        _, y_x, m, f, _ = u
        return np.array(
            [y_x, curvature(m), moment_change(f, p[0] * tension(1e-3), y_x), weight + 0 * x, elongation(y_x)]
        )

    def ends(mid: Floats, end: Floats, p: Floats) -> Floats:
        return np.array([mid[1], mid[3], end[0], end[1], mid[4], (tension(2 * end[4]) / tension(1e-3)) - p[0]])

    x = np.linspace(0, 0.5, 101)
    guess = np.array(
        [
            -16 * sag * (x**2 - 0.25) ** 2,
            -64 * sag * x * (x**2 - 0.25),
            np.zeros_like(x),
            weight * x,
            sag**2 * x * 8 / 3,
        ]
    )
    solution = solve_bvp(slopes, ends, x, guess, p=[sag**2 * 8 / 3 / 1e-3], tol=1e-8, max_nodes=20000)
    assert solution.success
    assert -solution.y[0, 0] == pytest.approx(sag, rel=1e-4)


def test_plastic_strains_remember_as_the_integrals_do() -> None:
    values = {sy.E: 3.0, sy.eta: 2.0, sy.A0: 0.7, sy.h0: 0.4}
    section = sd.small_deflection(RECTANGLE, flows=True)
    stress = sp.lambdify((sd.e_mean, sy.a_0), section.stress_mean.subs(values))
    bending = sp.lambdify((sd.y_XX, sy.a_1), section.stress_bending.subs(values))
    rates = sp.lambdify((sy.sigma_0, sy.sigma_1), [section.rate_mean.subs(values), section.rate_bending.subs(values)])
    strain, curvature, end = (lambda t: np.sin(2 * t) ** 2), (lambda t: t * np.cos(3 * t)), 2.5
    run = solve_ivp(
        lambda t, a: rates(stress(strain(t), a[0]), bending(curvature(t), a[1])),
        (0, end),
        [0.0, 0.0],
        rtol=1e-10,
        atol=1e-12,
    )
    sigma_0, sigma_1 = stress(strain(end), run.y[0, -1]), bending(curvature(end), run.y[1, -1])
    tension = float(section.tension.subs(values).subs(sy.sigma_0, sigma_0))
    moment = float(section.moment.subs(values).subs(sy.sigma_1, sigma_1))

    def memory(rate: Callable[[float], float]) -> float:
        return float(quad(lambda s: np.exp((s - end) * 3.0 / 2.0) * rate(s), 0, end, epsabs=1e-12)[0])

    assert tension == pytest.approx(3.0 * 0.7 * memory(lambda t: 2 * np.sin(4 * t)), rel=1e-7)
    inertia = 0.7 * 0.4**2 / 12
    assert moment == pytest.approx(-3.0 * inertia * memory(lambda t: np.cos(3 * t) - 3 * t * np.sin(3 * t)), rel=1e-7)


N, DELTA, V, TAU = 12, 0.02, 400.0, 0.3
VALUES = {sy.rho: 1.0, sy.g: 1.0, sy.A0: 1.0, sy.h0: DELTA, sy.eta: V, sy.E: V / TAU}  # spans and sqrt(L/g)
DX = 0.5 / N
CELLS, NODES = np.full(N, DX), np.r_[DX / 2, np.full(N - 1, DX), DX / 2]


def curvature_of(slope: Floats) -> Floats:
    """On nodes, with no slope at midspan and at the clamp."""
    return np.diff(np.r_[0.0, slope, 0.0]) / NODES


def held_end(v: Floats) -> Floats:
    return np.r_[v, 0.0]


class Staggered:
    """The reduced filament from the expressions of one section: y and a_1 on nodes, a_0 once."""

    def __init__(self, flows: bool) -> None:
        section = sd.small_deflection(RECTANGLE, flows=flows)
        strains = (sd.e_mean, sd.y_XX, sy.a_0, sy.a_1)
        stress = {sy.sigma_0: section.stress_mean, sy.sigma_1: section.stress_bending}

        def of_strain(*names: str) -> Callable[..., list[Floats]]:
            return sp.lambdify(strains, [getattr(section, n).subs(stress).subs(VALUES) for n in names])

        self.resultants = of_strain("tension", "moment", "rate_mean", "rate_bending")
        self.powers = of_strain("elastic_mean", "elastic_bending", "dissipation_mean", "dissipation_bending")
        self.elongation = sp.lambdify(sy.y_X, section.elongation)
        self.force = sp.lambdify((sy.T, sy.y_X, sy.M_X), section.vertical_force)
        self.acceleration = sp.lambdify(sd.F_X, section.acceleration.subs(VALUES))

    def strains(self, u: Floats) -> tuple[Floats, tuple[float, Floats, float, Floats]]:
        slope = np.diff(held_end(u[:N])) / DX
        e_mean = 2 * float(np.sum(self.elongation(slope) * DX))
        return slope, (e_mean, curvature_of(slope), u[2 * N], u[2 * N + 1 : 3 * N + 2])

    def __call__(self, t: float, u: Floats) -> Floats:
        slope, strains = self.strains(u)
        T, M, rate_0, rate_1 = self.resultants(*strains)
        F = self.force(T, slope, np.diff(M) / DX)
        y_tt = self.acceleration(np.diff(np.r_[0.0, F]) / NODES[:N])
        _, _, lost_0, lost_1 = self.powers(*strains)
        dissipation = lost_0 / 2 + np.sum((lost_1 + 0 * M) * NODES)
        return np.r_[u[N : 2 * N], y_tt, rate_0, rate_1 + 0 * M, dissipation]

    def energy(self, u: Floats) -> float:
        stored_0, stored_1, _, _ = self.powers(*self.strains(u)[1])
        mass = NODES[:N]
        motion = np.sum(mass * (u[N : 2 * N] ** 2 / 2 + u[:N]))
        return float(motion + stored_0 / 2 + np.sum(stored_1 * NODES) + u[-1])

    def run(self, end: float) -> Floats:
        done = solve_ivp(self, (0, end), np.zeros(3 * N + 3), method="LSODA", rtol=1e-9, atol=1e-12)
        assert done.success
        return np.asarray(done.y)


@pytest.mark.parametrize("flows", [True, False])
def test_energy_closes(flows: bool) -> None:
    model = Staggered(flows)
    states = model.run(0.3)
    fallen = -float(np.sum(NODES[:N] * states[:N, -1]))
    assert fallen > 1e-3
    assert max(abs(model.energy(u)) for u in states.T) < 1e-6 * fallen
    assert (states[-1, -1] > 1e-3 * fallen) == flows


def test_memories_of_2_18_give_the_same_motion_as_plastic_strains() -> None:
    y_tt, y_xx, q, m = sp.symbols("y_tt y_xx q m")
    y = sd.y_bar(sd.x_bar, sd.t_star)
    plain: Mapping[sp.Expr, sp.Expr] = {
        sp.Derivative(y, (sd.t_star, 2)): y_tt,
        sp.Derivative(y, (sd.x_bar, 2)): y_xx,
        sd.q_bar(sd.t_star): q,
        sd.m_bar(sd.x_bar, sd.t_star): m,
        sd.K_I: sd.form_factor(RECTANGLE),
        sd.delta: DELTA,
        sd.V: V,
        sd.tau_star: TAU,
    }
    acceleration = sp.lambdify((y_xx, q, m), sp.solve(sd.REDUCED.residual().subs(plain), y_tt)[0])

    def rate(t: float, u: Floats) -> Floats:
        y, v, bent, q = u[:N], u[N : 2 * N], u[2 * N : 3 * N + 1], u[-1]
        slope, slope_t = np.diff(held_end(y)) / DX, np.diff(held_end(v)) / DX
        m = np.diff(np.r_[0.0, np.diff(bent) / DX]) / NODES[:N]
        accelerated = acceleration(curvature_of(slope)[:N], q, m)
        return np.r_[v, accelerated, curvature_of(slope_t) - bent / TAU, np.sum(slope * slope_t * DX) - q / TAU]

    done = solve_ivp(rate, (0, 0.3), np.zeros(3 * N + 2), method="LSODA", rtol=1e-9, atol=1e-12)
    assert done.y[0, -1] == pytest.approx(Staggered(flows=True).run(0.3)[0, -1], rel=1e-5)
