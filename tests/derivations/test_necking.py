"""The gradient term of a neck in numbers: exact viscous necks, a discrete bar, quadrature of the sections."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import dblquad
from scipy.special import iv, ivp

from softcat_sym.physics import necking
from softcat_sym.physics.equation import check
from softcat_sym.physics.laws import bingham_rate, maxwell_rate
from softcat_sym.physics.symbols import T, eta, h0, s, sigma, sigma_Y

STRETCH, STRESS, VISCOSITY, THICKNESS = 1.3, 0.7, 2.0, 0.4
VALUES = {s: STRETCH, sigma: STRESS, eta: VISCOSITY, h0: THICKNESS, necking.aspect: 2.0, sigma_Y: 0.1}


def growth(neck: necking.Neck, material_wavenumber: float) -> float:
    return float(neck.growth_rate(maxwell_rate()).subs(VALUES | {necking.wavenumber: material_wavenumber}))


def thread(x: float) -> float:
    """Growth over sigma/eta of a neck of wavenumber x/radius in a viscous thread: Stokes flow, Bessel functions."""
    # v_r = A I1(r) + B r I0(r), v_x = -A I0 - B (2 I0 + r I1), p = 2 B I0, shear viscosity 1, lengths in 1/k.
    shear = [-2 * iv(1, x), -(2 * ivp(0, x) + iv(1, x) + x * ivp(1, x)) - x * iv(0, x)]
    normal = [2 * ivp(1, x), 2 * (iv(0, x) + x * ivp(0, x)) - 2 * iv(0, x)]
    a, b = np.linalg.solve([shear, normal], [-1.0, 0.0])
    return 3 * float(a * iv(1, x) + b * x * iv(0, x))


def layer(x: float) -> float:
    """Growth over sigma/(4 mu) of a neck of wavenumber x/half thickness in a viscous layer."""
    return 2 / (1 + np.sinh(2 * x) / (2 * x))


@pytest.mark.parametrize(("name", "exact"), [("circle", thread), ("sheet", layer)])
def test_long_necks_grow_as_in_a_viscous_liquid(name: str, exact: object) -> None:
    neck = necking.NECKS[name]
    thickness = float(neck.contraction.thickness.subs(VALUES))
    errors = []
    for x in (0.2, 0.1):
        current = 2 * x / thickness
        ours = growth(neck, current * STRETCH) * VISCOSITY / STRESS
        errors.append(abs(ours - exact(x)))  # type: ignore[operator]
        assert abs(ours - 1) > 10 * errors[-1]
    assert errors[0] / errors[1] == pytest.approx(16, rel=0.05)


def second_moment(name: str) -> float:
    """<y^2 + z^2> over h^2, or <y^2>, of the section by quadrature."""
    if name == "circle":
        area = dblquad(
            lambda z, y: y**2 + z**2, -0.5, 0.5, lambda y: -np.sqrt(0.25 - y**2), lambda y: np.sqrt(0.25 - y**2)
        )
        return area[0] / (np.pi / 4)
    width = {"rectangle": 2.0, "plane stress": 1e-9, "square": 1.0}[name]
    return dblquad(lambda z, y: y**2 + z**2, -0.5, 0.5, -width / 2, width / 2)[0] / width


def test_beta_is_a_quarter_of_the_squared_radius_of_gyration() -> None:
    for name in ["rectangle", "plane stress", "square", "circle"]:
        assert float(necking.NECKS[name].beta.subs(VALUES)) == pytest.approx(second_moment(name) / 4)


def test_a_discrete_bar_grows_at_the_stated_rate() -> None:
    """Solve T - (b(T) s_X)_X = Q spectrally for a bar with a small neck, and see how fast the neck grows."""
    for name in list(necking.NECKS):
        for wave in [1, 3, 8]:
            neck, points, small = necking.NECKS[name], 64, 1e-7
            X = np.arange(points) / points
            derivative = np.real(
                np.fft.ifft(
                    2j * np.pi * np.fft.fftfreq(points, 1 / points)[:, None] * np.fft.fft(np.eye(points), axis=0),
                    axis=0,
                )
            )
            stretch = STRETCH * (1 + small * np.cos(2 * np.pi * wave * X))
            per_tension = sp.lambdify(s, (neck.stiffness() / T).subs(T, 1).subs(VALUES | {s: s}), "numpy")
            coefficient = per_tension(stretch) if neck.stiffness().has(s) else None
            assert coefficient is not None
            operator = np.eye(points) - derivative @ np.diag(coefficient * (derivative @ stretch))
            tension = np.linalg.solve(operator, np.full(points, STRESS / STRETCH))
            rate = tension * stretch / VISCOSITY
            found = 2 * np.mean(rate * np.cos(2 * np.pi * wave * X)) / small
            assert found == pytest.approx(growth(neck, 2 * np.pi * wave), rel=1e-5, abs=1e-6)


def test_the_force_does_the_stated_power() -> None:
    """Over a bar with s_X = 0 at both ends, - integral of (b s_X)_X s_t is the integral of b s_X s_Xt."""
    for neck in necking.NECKS.values():
        X, t = necking.X, necking.t
        profile = 1.3 + sp.cos(2 * sp.pi * X) / 5 + t * sp.cos(sp.pi * X) / 10
        pull = 1 + X**2 / 2
        here = {necking.tension: pull, necking.stretch: profile}
        force = neck.force().subs(here).doit() * sp.diff(profile, t)
        local = {
            T: pull,
            s: profile,
            necking.s_slope: sp.diff(profile, X),
            necking.s_slope_rate: sp.diff(profile, X, t),
        }
        nodes, weights = np.polynomial.legendre.leggauss(40)
        works = []
        for density in (force, neck.gradient_power().subs(local)):
            value = sp.lambdify(X, density.subs(t, 0).subs({h0: THICKNESS, necking.aspect: 2.0}), "numpy")
            works.append(float(weights @ value((nodes + 1) / 2)) / 2)
        assert abs(works[1]) > 1e-5
        assert works[0] == pytest.approx(works[1], rel=1e-9)


def test_the_shortest_neck_does_not_grow() -> None:
    for neck in necking.NECKS.values():
        wavelength = float(neck.shortest_neck().subs(VALUES))
        assert growth(neck, 2 * np.pi / wavelength * STRETCH) == pytest.approx(0, abs=1e-12)
        assert growth(neck, 2 * np.pi / (2 * wavelength) * STRETCH) > 0
        assert float(neck.stiffness().subs(VALUES | {T: -1})) == 0


def test_folds_count_the_overstress_law_only_while_it_flows() -> None:
    count = necking.folds(bingham_rate())
    time = necking.t
    assert float(count.subs(VALUES | {time: 3.0})) == pytest.approx(STRESS / VISCOSITY * 3)
    assert float(count.subs(VALUES | {time: 3.0, sigma: 0.05})) == 0


def test_dimensions() -> None:
    for equation in necking.EQUATIONS:
        assert check(equation) is not None
