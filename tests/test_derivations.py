"""The equations of the paper from the densities of the cell."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import dblquad
from scipy.special import iv, ivp

from softcat_sym.physics import bulk, kinematics, necking, reissner
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.laws import KELVIN_VOIGT_LAW, bingham_rate
from softcat_sym.physics.reissner import Gam, Lam, S, k
from softcat_sym.physics.sections import CIRCLE, RECTANGLE, SHEET, UNIFORM, WIDE, Contraction, Section


@pytest.mark.parametrize("centreline", [kinematics.LARGE_ROTATION, kinematics.SMALL_SLOPE], ids=["large", "small"])
def test_power_of_the_internal_force(centreline: kinematics.Kinematics) -> None:
    """F.v_X = Q s_t + M_X theta_t, by finite differences along a random motion of the tangent."""
    force = kinematics.internal_force(centreline, bending=True)
    stretch_of = sp.lambdify((sy.x_X, sy.y_X), centreline.stretch)
    angle_of = sp.lambdify((sy.x_X, sy.y_X), centreline.turning.subs({sy.x_X_before: 1, sy.y_X_before: 0}))
    force_of = sp.lambdify((sy.x_X, sy.y_X, sy.s, sy.Q, sy.M_X), (force.horizontal, force.vertical))
    rng = np.random.default_rng(4)
    for _ in range(20):
        tangent, speed = rng.normal((1.5, 0)), rng.normal(size=2)
        axial, change = rng.normal(size=2)
        step = 1e-6
        ahead, behind = tangent + step * speed, tangent - step * speed
        s_t = (stretch_of(*ahead) - stretch_of(*behind)) / (2 * step)
        theta_t = math.remainder(angle_of(*ahead) - angle_of(*behind), 2 * math.pi) / (2 * step)
        power = np.dot(force_of(*tangent, stretch_of(*tangent), axial, change), speed)
        assert power == pytest.approx(axial * s_t + change * theta_t, rel=1e-7, abs=1e-7)


# The shearing filament in numbers: conjugate forces by differencing an energy, J2 flow against the bulk law.
CONSTANTS = {sy.E: 3.0, bulk.nu: 0.45, sy.A0: 1.7, sy.h0: 0.3, reissner.kappa_s: 0.8, sy.sigma_Y: 0.1, sy.eta: 2.0}
STATE = (1.25, 0.07, 0.4)
NODES_GAUSS, WEIGHTS_GAUSS = np.polynomial.legendre.leggauss(8)
WEIGHTS_GAUSS = WEIGHTS_GAUSS / 2
PLASTIC = 0.05 * np.sin(3 * NODES_GAUSS)
PLASTIC_SHEAR = 0.02 * NODES_GAUSS**2
CONTRACTIONS = pytest.mark.parametrize("contraction", [UNIFORM, WIDE], ids=["both ways", "sheet"])


def compiled(inputs: list[sp.Symbol], expression: object) -> Callable[..., np.ndarray]:
    substituted = [sp.sympify(e).subs(CONSTANTS) for e in expression]  # type: ignore[attr-defined]
    return sp.lambdify(inputs, substituted, modules="numpy")


def spring_of(cell: reissner.ShearingCell) -> reissner.FibreSpring:
    return reissner.fibre_spring(sy.E, bulk.shear_modulus(), cell.carry)


def fibre_stresses(cell: reissner.ShearingCell, state: tuple[float, ...]) -> dict[sp.Symbol, np.ndarray]:
    """Strains, stresses and plastic state of eight fibres; each line is evaluated from those before."""
    spring = spring_of(cell)
    found: dict[sp.Symbol, object] = dict(zip((Lam, Gam, k), state, strict=True))
    found |= {sy.zeta: NODES_GAUSS, reissner.eps_p: PLASTIC, reissner.gamma_p: PLASTIC_SHEAR}
    for symbol, expression in (
        (reissner.eps, cell.axial_strain),
        (reissner.gamma, cell.shear_strain),
        (reissner.eps_e, spring.elastic[0]),
        (reissner.gamma_e, spring.elastic[1]),
        (sy.sigma, spring.stress[0]),
        (reissner.tau_f, spring.stress[1]),
        (reissner.tau_d, spring.driving[0]),
        (reissner.sigma_c, spring.conjugate),
    ):
        found[symbol] = compiled(list(found), [expression])(*found.values())[0]
    return found  # type: ignore[return-value]


def stored(cell: reissner.ShearingCell, state: tuple[float, ...]) -> float:
    """Energy per unit material length."""
    fibres = fibre_stresses(cell, state)
    energy = compiled(list(fibres), [spring_of(cell).stored])(*fibres.values())[0]
    return CONSTANTS[sy.A0] * float(WEIGHTS_GAUSS @ energy)


@CONTRACTIONS
def test_conjugate_forces_are_the_slopes_of_the_energy(contraction: Contraction) -> None:
    cell = reissner.shearing_cell(contraction)
    fibres = fibre_stresses(cell, STATE)
    along, shear = fibres[reissner.sigma_c], fibres[reissner.tau_f]
    means = (WEIGHTS_GAUSS @ along, WEIGHTS_GAUSS @ (along * NODES_GAUSS), WEIGHTS_GAUSS @ shear)
    symbols = [reissner.sigma_mean, reissner.sigma_zeta, reissner.tau_mean, Lam]
    resultants = compiled(symbols, (cell.tension, cell.moment, cell.shear_force))(*means, STATE[0])
    forces = compiled([sy.T, sy.M, S, Lam, Gam, k], (cell.normal_force, cell.section_force, cell.couple))(
        *resultants, *STATE
    )
    for n, force in enumerate(forces):
        ahead, behind = (tuple(v + d * (i == n) for i, v in enumerate(STATE)) for d in (1e-5, -1e-5))
        assert force == pytest.approx((stored(cell, ahead) - stored(cell, behind)) / 2e-5, rel=1e-7, abs=1e-9)


def test_a_rigid_rotation_changes_no_strain_and_turns_the_force() -> None:
    cell = reissner.shearing_cell()
    strains = compiled([sy.x_X, sy.y_X, reissner.psi], reissner.director_strains())
    force = compiled([reissner.n_1, reissner.n_2, reissner.psi], cell.force)
    gradient, turn = np.array([1.1, 0.3]), 0.9
    rotation = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    assert strains(*(rotation @ gradient), 0.2 + turn) == pytest.approx(strains(*gradient, 0.2))
    assert force(2.0, -0.7, 0.2 + turn) == pytest.approx(rotation @ force(2.0, -0.7, 0.2))


def test_forces_turn_a_section_by_their_moment_about_it() -> None:
    """Lam n_2 - Gam n_1 is r_X cross F, so that moment of momentum is conserved whatever the law."""
    cell = reissner.shearing_cell()
    gradient, angle, force = np.array([1.1, 0.3]), 0.2, (2.0, -0.7)
    stretch, shear = compiled([sy.x_X, sy.y_X, reissner.psi], reissner.director_strains())(*gradient, angle)
    pull = compiled([reissner.n_1, reissner.n_2, reissner.psi], cell.force)(*force, angle)
    turning = compiled([reissner.n_1, reissner.n_2, Lam, Gam], [cell.turning_moment])(*force, stretch, shear)[0]
    assert turning == pytest.approx(gradient[0] * pull[1] - gradient[1] * pull[0])


def triangular(strain: float, shear: float, carry: float) -> np.ndarray:
    """Deformation gradient that stretches along the fibre and shears, in the frame of the section."""
    stretch = np.exp(strain)
    return np.array([[stretch, 0], [shear * stretch, stretch ** (1 - carry)]])


CARRIES = pytest.mark.parametrize(("contraction", "carry"), [(UNIFORM, 1.5), (WIDE, 2.0)], ids=["both ways", "sheet"])
PLASTIC_STATES = [(0.3, 0.0), (0.3, 0.2), (0.7, -0.4), (-0.2, 0.5)]


@CARRIES
def test_elastic_strains_are_those_of_a_product_of_triangular_gradients(contraction: Contraction, carry: float) -> None:
    """F = F_e F_p: what is left of F once F_p is taken off."""
    spring = spring_of(reissner.shearing_cell(contraction))
    total = (0.5, 0.3)
    for plastic in PLASTIC_STATES:
        left = triangular(*total, carry) @ np.linalg.inv(triangular(*plastic, carry))
        values = dict(
            zip((reissner.eps, reissner.gamma, reissner.eps_p, reissner.gamma_p), (*total, *plastic), strict=True)
        )
        strain = float(spring.elastic[0].subs(values))
        shear = float(spring.elastic[1].subs(values | {reissner.eps_e: strain}))
        assert left == pytest.approx(triangular(strain, shear, carry), rel=1e-13)


@CARRIES
def test_a_fibre_flows_as_the_solid_does(contraction: Contraction, carry: float) -> None:
    """The rate of F_p F_p^-1 that is symmetric is von Mises's, and the power lost is phi sig_eq, whatever the state."""
    cell = reissner.shearing_cell(contraction)
    spring, flow = spring_of(cell), reissner.fibre_flow(bingham_rate(), carry=cell.carry)
    pair = [sy.sigma, reissner.tau_d]
    for axial, shear in [(0.3, 0.0), (0.0, -0.2), (-0.25, 0.15), (0.04, 0.02)]:
        size = compiled(pair, [flow.equivalent])(axial, shear)[0]
        stress = np.array([[axial, shear, 0], [shear, 0, 0], [0, 0, 0]])
        deviator = stress - np.trace(stress) / 3 * np.eye(3)
        assert size == pytest.approx(np.sqrt(1.5 * np.sum(deviator**2)))
        solid = 1.5 * max(size - 0.1, 0) / 2 * deviator / size
        for strain, sheared in PLASTIC_STATES:
            inputs = [*pair, bulk.sigma_eq, reissner.gamma_p]
            rates = compiled(inputs, (flow.axial_rate, flow.shear_rate[0], flow.dissipation))(
                axial, shear, size, sheared
            )
            ahead, behind = (triangular(strain + d * rates[0], sheared + d * rates[1], carry) for d in (1e-6, -1e-6))
            spin_and_rate = (ahead - behind) / 2e-6 @ np.linalg.inv(triangular(strain, sheared, carry))
            assert spin_and_rate[0, 0] == pytest.approx(solid[0, 0], abs=1e-9)
            assert spin_and_rate[1, 0] == pytest.approx(2 * solid[0, 1], abs=1e-9)
            along = compiled([*pair, reissner.gamma_p], [spring.conjugate])(axial, shear, sheared)[0]
            assert along * rates[0] + shear * rates[1] == pytest.approx(rates[2], abs=1e-15)
            assert rates[2] == pytest.approx(np.sum(stress * solid), abs=1e-15)
            assert rates[2] >= 0


@pytest.mark.parametrize(
    ("shape", "carry"), [(RECTANGLE, 1.5), (CIRCLE, 1.5), (SHEET, 2.0)], ids=["rectangle", "circle", "sheet"]
)
def test_a_viscous_fibre_resists_the_rate_of_its_whole_deformation(shape: Section, carry: float) -> None:
    """Half of 2/3 eta D:D, D the symmetric part of F_t F^-1 at constant volume."""
    viscous = reissner.resolve(shape, KELVIN_VOIGT_LAW, shear=True).viscous
    assert viscous is not None
    strain, shear, rates = 0.3, -0.4, (0.2, 0.7)
    ahead, behind = (triangular(strain + d * rates[0], shear + d * rates[1], carry) for d in (1e-6, -1e-6))
    gradient = (ahead - behind) / 2e-6 @ np.linalg.inv(triangular(strain, shear, carry))
    rate = (gradient + gradient.T) / 2
    squares = float(np.sum(rate**2) + np.trace(rate) ** 2)
    by = (reissner.gamma, reissner.eps_t, reissner.gamma_t)
    found = viscous.rayleigh.subs(CONSTANTS).subs(dict(zip(by, (shear, *rates), strict=True)))
    assert float(found) == pytest.approx(2.0 / 3 * squares, rel=1e-8)


@CARRIES
def test_a_sheared_fibre_stores_what_a_solid_of_constant_volume_does(contraction: Contraction, carry: float) -> None:
    """Hencky's energy mu sum log^2 of principal stretches, to third order in the strains."""
    cell = reissner.shearing_cell(contraction)
    modulus = {1.5: 3.0, 2.0: 4.0}[carry]  # 3 mu, in plane strain 4 mu
    energy = reissner.fibre_spring(sp.Float(modulus), sp.Integer(1), cell.carry).stored
    errors = []
    for size in (0.04, 0.02):
        strain, shear = size, -1.5 * size
        plane = np.linalg.svd(triangular(strain, shear, carry), compute_uv=False)
        stretches = np.array([*plane, 1 / np.prod(plane)])
        exact = float(np.sum(np.log(stretches) ** 2))
        errors.append(abs(float(energy.subs({reissner.eps_e: strain, reissner.gamma_e: shear})) - exact))
    assert errors[0] / errors[1] == pytest.approx(16, rel=0.1)


def test_a_small_strain_adds_the_shears() -> None:
    """gamma - gamma_p, E (eps - eps_p) and mu gamma_e remain: the difference falls with the square of the strain."""
    cell = reissner.shearing_cell()
    spring, flow = spring_of(cell), reissner.fibre_flow(bingham_rate())
    by = (reissner.eps, reissner.gamma, reissner.eps_p, reissner.gamma_p)
    apart = []
    for size in (1e-2, 1e-3):
        at = dict(zip(by, (3 * size, 2 * size, size, -size), strict=True)) | CONSTANTS
        at[reissner.eps_e] = spring.elastic[0].subs(at)
        at[reissner.gamma_e] = spring.elastic[1].subs(at)
        at[sy.sigma] = spring.stress[0].subs(at)
        at[reissner.tau_f] = tau = float(spring.stress[1].subs(at))
        at[reissner.tau_d] = spring.driving[0].subs(at)
        at[bulk.sigma_eq] = flow.equivalent.subs(at)
        shear_modulus = 3.0 / 2.9
        wanted = (3.0 * 2 * size, shear_modulus * 3 * size)
        rate = 3 * max(float(at[bulk.sigma_eq]) / 2 - 0.05, 0) * tau / float(at[bulk.sigma_eq])
        found = (float(spring.conjugate.subs(at)), tau)
        assert float(flow.shear_rate[0].subs(at)) == pytest.approx(rate, rel=3 * size, abs=1e-30)
        apart.append(max(abs(f / w - 1) for f, w in zip(found, wanted, strict=True)))
    assert apart[0] / apart[1] == pytest.approx(10, rel=0.2)


def test_a_mirrored_shear_mirrors_its_stress_alone() -> None:
    spring, flow = spring_of(reissner.shearing_cell()), reissner.fibre_flow(bingham_rate())
    by = [reissner.eps, reissner.gamma, reissner.gamma_p, reissner.eps_p]
    even, odd = [], []
    for sign in (1, -1):
        at = dict(zip(by, (0.3, sign * 0.2, sign * 0.05, 0.1), strict=True)) | CONSTANTS
        for symbol, expression in (
            *zip((reissner.eps_e, reissner.gamma_e), spring.elastic, strict=True),
            *zip((sy.sigma, reissner.tau_f), spring.stress, strict=True),
            (reissner.tau_d, spring.driving[0]),
            (bulk.sigma_eq, flow.equivalent),
        ):
            at[symbol] = expression.subs(at)
        even.append([float(e.subs(at)) for e in (spring.stored, spring.conjugate, flow.axial_rate, flow.dissipation)])
        odd.append([sign * float(e.subs(at)) for e in (spring.stress[1], spring.driving[0], flow.shear_rate[0])])
    assert even[1] == pytest.approx(even[0], rel=1e-14)
    assert odd[1] == pytest.approx(odd[0], rel=1e-14)


def test_a_stiff_shear_leaves_the_force_of_the_thin_filament() -> None:
    """n_1 tends to T + 3/2 M theta_s as Gam falls with the shear modulus."""
    cell = reissner.shearing_cell()
    values = {sy.T: 1.0, sy.M: 0.02, S: 0.3, Lam: 1.2, k: 0.4}
    limit = 1.0 + 1.5 * 0.02 * 0.4 / 1.2
    for stiffness in (1e2, 1e4, 1e6):
        tilt = 0.3 * 1.2**2 / stiffness
        assert float(cell.normal_force.subs(values | {Gam: tilt})) == pytest.approx(
            limit, abs=0.3 * 1.2 / stiffness + 1e-12
        )


def test_shear_correction_of_the_circle_agrees_with_elasticity_when_incompressible() -> None:
    assert 6 * 1.5 / (7 + 6 * 0.5) == pytest.approx(float(CIRCLE.shear_correction))
    height = np.linspace(-1, 1, 20001)
    parabola = 1 - height**2
    for weight, held in (
        (np.ones_like(height), RECTANGLE.shear_correction),
        (np.sqrt(parabola), CIRCLE.shear_correction),
    ):
        total = weight.sum()
        mean, square = (parabola * weight).sum() / total, (parabola**2 * weight).sum() / total
        assert mean**2 / square == pytest.approx(float(held), rel=1e-4)


# The gradient term of a neck in numbers: exact viscous necks, a discrete bar, quadrature of the sections.
STRETCH, STRESS, VISCOSITY, THICKNESS_NECK = 1.3, 0.7, 2.0, 0.4
VALUES = {
    sy.s: STRETCH,
    sy.sigma: STRESS,
    sy.eta: VISCOSITY,
    sy.h0: THICKNESS_NECK,
    necking.aspect: 2.0,
    sy.sigma_Y: 0.1,
}


def thickness_of(neck: necking.Neck) -> float:
    return float((WIDE if neck.name == "sheet" else UNIFORM).thickness.subs(VALUES))


def growth(neck: necking.Neck, material_wavenumber: float) -> float:
    current = thickness_of(neck) * material_wavenumber / STRETCH
    return STRESS / VISCOSITY * (1 - float(neck.beta.subs(VALUES)) * current**2)


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
    thickness = thickness_of(neck)
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
    width = float(VALUES[necking.aspect])
    return dblquad(lambda z, y: y**2 + z**2, -0.5, 0.5, -width / 2, width / 2)[0] / width


def test_beta_is_a_quarter_of_the_squared_radius_of_gyration() -> None:
    for name in ["rectangle", "circle"]:
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
            per_tension = sp.lambdify(
                sy.s, (neck.stiffness() / sy.T).subs(sy.T, 1).subs(VALUES | {sy.s: sy.s}), "numpy"
            )
            coefficient = per_tension(stretch) if neck.stiffness().has(sy.s) else None
            assert coefficient is not None
            operator = np.eye(points) - derivative @ np.diag(coefficient * (derivative @ stretch))
            tension = np.linalg.solve(operator, np.full(points, STRESS / STRETCH))
            rate = tension * stretch / VISCOSITY
            found = 2 * np.mean(rate * np.cos(2 * np.pi * wave * X)) / small
            assert found == pytest.approx(growth(neck, 2 * np.pi * wave), rel=1e-5, abs=1e-6)
