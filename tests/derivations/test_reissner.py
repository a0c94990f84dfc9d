"""The shearing filament in numbers: conjugate forces by differencing an energy, J2 flow against the bulk law."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
import sympy as sp

from softcat_sym.physics import bulk, reissner
from softcat_sym.physics.equation import check
from softcat_sym.physics.laws import bingham_rate
from softcat_sym.physics.reissner import Gam, Lam, S, k
from softcat_sym.physics.sections import UNIFORM, WIDE, Contraction
from softcat_sym.physics.symbols import A0, E, M, T, eta, h0, sigma, sigma_Y, x_X, y_X, zeta

CONSTANTS = {E: 3.0, bulk.nu: 0.45, A0: 1.7, h0: 0.3, reissner.kappa_s: 0.8, sigma_Y: 0.1, eta: 2.0}
STATE = (1.25, 0.07, 0.4)
NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)
WEIGHTS = WEIGHTS / 2
PLASTIC = 0.05 * np.sin(3 * NODES)
PLASTIC_SHEAR = 0.02 * NODES**2
CONTRACTIONS = pytest.mark.parametrize("contraction", [UNIFORM, WIDE], ids=["both ways", "sheet"])


def compiled(inputs: list[sp.Symbol], expression: object) -> Callable[..., np.ndarray]:
    substituted = [sp.sympify(e).subs(CONSTANTS) for e in expression]  # type: ignore[attr-defined]
    return sp.lambdify(inputs, substituted, modules="numpy")


def fibre_stresses(cell: reissner.ShearingCell, state: tuple[float, ...]) -> tuple[np.ndarray, np.ndarray]:
    inputs = [Lam, Gam, k, zeta, reissner.eps_p, reissner.gamma_p]
    axial, shear = compiled(inputs, (cell.axial_stress, cell.shear_stress))(*state, NODES, PLASTIC, PLASTIC_SHEAR)
    return axial, shear


def stored(cell: reissner.ShearingCell, state: tuple[float, ...]) -> float:
    """Energy per unit material length."""
    energy = compiled([sigma, reissner.tau_f], [cell.elastic_energy])(*fibre_stresses(cell, state))[0]
    return CONSTANTS[A0] * float(WEIGHTS @ energy)


@CONTRACTIONS
def test_conjugate_forces_are_the_slopes_of_the_energy(contraction: Contraction) -> None:
    cell = reissner.shearing_cell(contraction)
    axial, shear = fibre_stresses(cell, STATE)
    means = (WEIGHTS @ axial, WEIGHTS @ (axial * NODES), WEIGHTS @ shear)
    symbols = [reissner.sigma_mean, reissner.sigma_zeta, reissner.tau_mean, Lam]
    resultants = compiled(symbols, (cell.tension, cell.moment, cell.shear_force))(*means, STATE[0])
    forces = compiled([T, M, S, Lam, Gam, k], (cell.normal_force, cell.section_force, cell.couple))(*resultants, *STATE)
    for n, force in enumerate(forces):
        ahead, behind = (tuple(v + d * (i == n) for i, v in enumerate(STATE)) for d in (1e-5, -1e-5))
        assert force == pytest.approx((stored(cell, ahead) - stored(cell, behind)) / 2e-5, rel=1e-7, abs=1e-9)


def test_a_rigid_rotation_changes_no_strain_and_turns_the_force() -> None:
    cell = reissner.shearing_cell()
    strains = compiled([x_X, y_X, reissner.psi], reissner.director_strains())
    force = compiled([reissner.n_1, reissner.n_2, reissner.psi], cell.force)
    gradient, turn = np.array([1.1, 0.3]), 0.9
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    assert strains(*(rotation @ gradient), 0.2 + turn) == pytest.approx(strains(*gradient, 0.2))
    assert force(2.0, -0.7, 0.2 + turn) == pytest.approx(rotation @ force(2.0, -0.7, 0.2))


def test_forces_turn_a_section_by_their_moment_about_it() -> None:
    """Lam n_2 - Gam n_1 is r_X cross F, so that moment of momentum is conserved whatever the law."""
    cell = reissner.shearing_cell()
    gradient, angle, force = np.array([1.1, 0.3]), 0.2, (2.0, -0.7)
    stretch, shear = compiled([x_X, y_X, reissner.psi], reissner.director_strains())(*gradient, angle)
    pull = compiled([reissner.n_1, reissner.n_2, reissner.psi], cell.force)(*force, angle)
    turning = compiled([reissner.n_1, reissner.n_2, Lam, Gam], [cell.turning_moment])(*force, stretch, shear)[0]
    assert turning == pytest.approx(gradient[0] * pull[1] - gradient[1] * pull[0])


def test_a_fibre_flows_as_the_solid_does() -> None:
    for axial, shear in [(0.3, 0.0), (0.0, -0.2), (-0.25, 0.15), (0.04, 0.02)]:
        flow = reissner.fibre_flow(bingham_rate())
        pair = [sigma, reissner.tau_f]
        size = compiled(pair, [flow.equivalent])(axial, shear)[0]
        rates = compiled([*pair, bulk.sigma_eq], (flow.axial_rate, flow.shear_rate, flow.dissipation))(
            axial, shear, size
        )
        stress = np.array([[axial, shear, 0], [shear, 0, 0], [0, 0, 0]])
        deviator = stress - np.trace(stress) / 3 * np.eye(3)
        assert size == pytest.approx(np.sqrt(1.5 * np.sum(deviator**2)))
        solid = 1.5 * max(size - 0.1, 0) / 2 * deviator / size
        assert rates == pytest.approx([solid[0, 0], 2 * solid[0, 1], np.sum(stress * solid)], abs=1e-15)
        assert rates[2] >= 0


def test_a_stiff_shear_leaves_the_force_of_the_thin_filament() -> None:
    """n_1 tends to T + 3/2 M theta_s as Gam falls with the shear modulus."""
    cell = reissner.shearing_cell()
    values = {T: 1.0, M: 0.02, S: 0.3, Lam: 1.2, k: 0.4}
    limit = 1.0 + 1.5 * 0.02 * 0.4 / 1.2
    for stiffness in (1e2, 1e4, 1e6):
        tilt = 0.3 * 1.2**2 / stiffness
        assert float(cell.normal_force.subs(values | {Gam: tilt})) == pytest.approx(
            limit, abs=0.3 * 1.2 / stiffness + 1e-12
        )


def test_shear_correction_of_the_circle_agrees_with_elasticity_when_incompressible() -> None:
    assert float(reissner.cowper_circle().subs(bulk.nu, 0.5)) == pytest.approx(float(reissner.CIRCLE_SHEAR))
    height = np.linspace(-1, 1, 20001)
    parabola = 1 - height**2
    for weight, held in ((np.ones_like(height), reissner.RECTANGLE_SHEAR), (np.sqrt(parabola), reissner.CIRCLE_SHEAR)):
        total = weight.sum()
        mean, square = (parabola * weight).sum() / total, (parabola**2 * weight).sum() / total
        assert mean**2 / square == pytest.approx(float(held), rel=1e-4)


def test_dimensions() -> None:
    for equation in reissner.EQUATIONS:
        assert check(equation) is not None
