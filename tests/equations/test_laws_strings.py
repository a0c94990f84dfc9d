"""The sag of a string, against its own equation integrated by a machine."""

from __future__ import annotations

import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from softcat_sym.physics import closed_forms as strings
from softcat_sym.physics.laws import K, n
from softcat_sym.physics.regimes import H
from softcat_sym.physics.symbols import E, L, eta, g, rho, sigma, t

AT = {rho: 1e3, g: 9.81, L: 0.2, K: 700.0, eta: 700.0, E: 3e5}


@pytest.mark.parametrize("index", (0.3, 0.5, 1.0, 2.0))
def test_a_power_law_string_creeps_by_its_own_flow_rule(index: float) -> None:
    known = {**AT, n: index}
    # (d eps/dH) H_t = (sigma/K)^(1/n)
    rate = (sigma / K) ** (1 / n) / sp.diff(strings.string_strain(), H)
    of_sag = sp.lambdify(H, rate.subs(sigma, strings.string_stress()).subs(known), modules="math")
    closed = sp.lambdify(t, strings.power_law_string_sag().subs(known), modules="math")
    start, end = 1e-3, 10.0
    found = solve_ivp(lambda _, sag: [of_sag(sag[0])], (start, end), [closed(start)], rtol=1e-10, atol=1e-14)
    assert found.y[0, -1] == pytest.approx(closed(end), rel=1e-7)
    assert closed(2.0) / closed(1.0) == pytest.approx(2 ** (index / (2 * index + 1)), rel=1e-12)


def test_a_power_law_string_of_index_one_is_viscous() -> None:
    one = strings.power_law_string_sag().subs({n: 1, K: eta})
    assert sp.simplify((one / strings.viscous_string_sag()) ** 3 - 1) == 0


def test_an_elastic_string_carries_its_weight() -> None:
    sag = strings.elastic_string_sag()
    assert sp.simplify(E * strings.string_strain(sag) / strings.string_stress(sag) - 1) == 0
