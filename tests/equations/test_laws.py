"""Every law is what it becomes in the limits where another one rules."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from softcat_sym.physics import closed_forms as from_shear
from softcat_sym.physics.laws import E_2, FIXED, Flow, K, Law, law_of, mode, n
from softcat_sym.physics.rheometry import mu
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.physics.symbols import E, eta, sigma, sigma_Y

MODULUS = 4e6
STRESSES = np.concatenate([-np.logspace(4, -2, 60), [0.0], np.logspace(-2, 4, 60)]) * 10
each_index = pytest.mark.parametrize("index", (0.3, 0.5, 1.0, 2.0))


def flow_of(law: str, *, yields: bool = False) -> Flow:
    (branch,) = law_of(law).branches
    flow = branch.in_force(flows=True, yields=yields).flow
    assert flow is not None
    return flow


def rates(flow: Flow, **material: float) -> np.ndarray:
    known = {"E": MODULUS, "eta": 13.84e3, "K": 13.84e3, "n": 1.0, "sigma_Y": 9.32e3} | material
    at = {symbol: known[symbol.name] for symbol in flow.rate.free_symbols - {sigma}}
    return np.asarray(sp.lambdify(sigma, flow.rate.xreplace(at), modules="numpy")(STRESSES), dtype=float)


def test_herschel_bulkley_of_index_one_is_bingham() -> None:
    one, other = rates(flow_of("herschel-bulkley", yields=True)), rates(flow_of("bingham", yields=True))
    np.testing.assert_allclose(one, other, rtol=1e-12, atol=0)
    assert np.count_nonzero(one)


@each_index
def test_herschel_bulkley_without_yield_stress_is_the_power_law(index: float) -> None:
    wanted = rates(flow_of("power-law"), n=index)
    np.testing.assert_allclose(
        rates(flow_of("herschel-bulkley", yields=True), n=index, sigma_Y=0.0), wanted, rtol=1e-14
    )
    np.testing.assert_array_equal(rates(flow_of("herschel-bulkley"), n=index), wanted)


def test_the_power_law_of_index_one_is_maxwell() -> None:
    np.testing.assert_allclose(rates(flow_of("power-law")), rates(flow_of("maxwell")), rtol=1e-15)
    assert flow_of("bingham") == flow_of("bingham", yields=False)
    np.testing.assert_array_equal(rates(flow_of("bingham")), rates(flow_of("maxwell")))


@each_index
def test_what_makes_the_slope_finite_at_rest_is_not_felt_elsewhere(index: float) -> None:
    felt = np.abs(STRESSES) >= 1e-6 * MODULUS
    exact = np.sign(STRESSES) * (np.abs(STRESSES) / 13.84e3) ** (1 / index)
    found = rates(flow_of("power-law"), n=index)
    np.testing.assert_allclose(found[felt], exact[felt], rtol=2e-6)
    assert np.all(np.diff(found) >= 0)
    np.testing.assert_allclose(found, -found[::-1], rtol=1e-14)
    slope = sp.diff(flow_of("power-law").rate, sigma).subs({sigma: 0, E: MODULUS, K: 13.84e3, n: index})
    assert 0 < float(slope) < 1e9


@pytest.mark.parametrize("section", SECTIONS)
def test_one_mode_is_maxwell(section: str) -> None:
    modulus, viscosity = mode(1)
    (one,), (other,) = law_of("multimode-maxwell", modes=1).branches, law_of("maxwell").branches
    alike = {modulus: E, viscosity: eta}
    assert one.modulus.xreplace(alike) == other.modulus
    assert one.flow is not None and other.flow is not None
    assert one.flow.rate.xreplace(alike) == other.flow.rate
    ours, theirs = (flow.means(SECTIONS[section]) for flow in (one.flow, other.flow))
    assert ours.rate.xreplace(alike) == theirs.rate
    assert ours.bending_rate.xreplace(alike) == theirs.bending_rate


def test_modes_relax_each_in_its_own_time() -> None:
    law = law_of("multimode-maxwell", modes=3)
    assert [constant.name for constant in law.constants] == [
        f"mode_{k}_{name}" for k in (1, 2, 3) for name in ("youngs_modulus", "viscosity")
    ]
    assert len({constant.symbol for constant in law.constants}) == 6
    for number, branch in enumerate(law.branches, 1):
        modulus, viscosity = mode(number)
        assert branch.flow is not None
        # eps_p_t = sigma_j/eta_j: at a held strain sigma_j falls at the rate E_j/eta_j
        assert branch.modulus * sp.diff(branch.flow.rate, sigma) == modulus / viscosity


def test_springs_and_dashpots_of_the_linear_solids() -> None:
    assert law_of("newtonian") == Law("newtonian", branches=(), viscosity=eta)
    voigt, zener = law_of("kelvin-voigt"), law_of("standard-linear")
    assert [branch.modulus for branch in voigt.branches] == [E]
    assert (voigt.viscosity, voigt.flows) == (eta, False)
    spring, arm = zener.branches
    assert (spring.modulus, spring.flow, arm.modulus) == (E, None, E_2)
    assert arm.flow is not None and arm.flow.rate == sigma / eta
    assert (zener.viscosity, zener.flows, zener.yields) == (None, True, False)


def test_laws_by_their_names() -> None:
    for name, law in FIXED.items():
        assert law_of(name) is law
        assert law.name == name
    assert {name for name, law in FIXED.items() if law.yields} == {"bingham", "herschel-bulkley"}
    for name, options in (("glassy", {}), ("multimode-maxwell", {"modes": 0}), ("custom", {})):
        with pytest.raises(ValueError, match=r"law|mode|formula"):
            law_of(name, **options)


@each_index
def test_constants_in_shear_and_in_tension(index: float) -> None:
    """Of von Mises's law: sigma_eq = sqrt(3) tau, and the shear rate is sqrt(3) times the equivalent rate."""
    yielding, trouton, consistency = from_shear.FROM_SHEAR_EQUATIONS
    flow = flow_of("herschel-bulkley", yields=True).rate
    shear = {from_shear.tau_Y: 2.0, from_shear.k_shear: 5.0, n: index, mu: 5.0}
    tensile = {sigma_Y: yielding.right.subs(shear), K: consistency.right.subs(shear), n: index, E: 1e3}
    for tau in (2.1, 3.0, 17.0):
        shear_rate = np.sqrt(3) * float(flow.xreplace(tensile).subs(sigma, np.sqrt(3) * tau))
        assert 2 + 5 * shear_rate**index == pytest.approx(tau, rel=1e-9)
    assert float(trouton.right.subs(shear)) == 15
