"""Implicit exponential-map step of the three-dimensional law (3.1)-(3.8) in plane stress: one scalar equation.

The state is Cp^-1 in the plane. With be = F Cp^-1 F^T the Kirchhoff stress tau = Re M Re^T shares the principal axes of
be, and the step Fe_new = Fe_trial exp(-dt Lp) keeps them. M_33 = 0 holds for the *new* strains (the width is free), so
the sum and the difference of the two elastic Hencky strains relax independently of each other, each by a factor that
holds only x = dt phi(sig_eq)/sig_eq; sig_eq of what remains closes the equation. (Simo, Comput. Methods Appl. Mech.
Eng. 99 (1992) 61-112, for the exponential map in principal axes.)

Each link of the chain is written in the symbols that the link before it computes.
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations import bulk
from softcat_sym.equations.equation import Equation
from softcat_sym.equations.laws.bingham import bingham_rate
from softcat_sym.equations.symbols import ONE, STRESS, enter, sigma

_PLANE = ("11", "12", "21", "22")

# Under equal principal stretches the axes are anything and both strains are one: the floor keeps 0/0 away.
_TINY = sp.Rational(1, 10**200)


def _named(name: str, latex: str, places: tuple[str, ...], meaning: str, source: str) -> tuple[sp.Symbol, ...]:
    return tuple(enter(f"{name}_{p}", f"{latex}_{{{p}}}", ONE, f"{meaning}, component {p}", source) for p in places)


deformation = sp.Matrix(2, 2, _named("F", "F", _PLANE, "deformation gradient in the plane", "3.1"))
jacobian = enter("J_plane", "J_2", ONE, "determinant of F in the plane", "3.1", positive=True)
inverse_jacobian = enter("J_plane_inverse", "J_2^{-1}", ONE, "its inverse", "3.1", positive=True)
state = _named("Cp_inverse", r"(C_p^{-1})", ("11", "12", "22"), "inverse plastic right Cauchy-Green tensor", "3.1")
mean_square = enter(
    "be_mean", r"\bar b_e", ONE, "mean of the squared elastic stretches in the plane", "3.3", positive=True
)
half_gap = enter("be_gap", r"\Delta b_e", ONE, "half the gap of the squared elastic stretches", "3.3")
be_determinant = enter("be_det", r"\det b_e", ONE, "determinant of be in the plane", "3.3", positive=True)
cosine = enter("cos_2a", r"\cos 2a", ONE, "of twice the angle of the first principal axis of be", "3.3")
sine = enter("sin_2a", r"\sin 2a", ONE, "of twice the angle of the first principal axis of be", "3.3")
trial_sum = enter("Ee_sum_trial", r"E^{e,tr}_+", ONE, "sum of the elastic strains if a step were elastic", "3.3")
trial_gap = enter("Ee_gap_trial", r"E^{e,tr}_-", ONE, "difference of the elastic strains if a step were elastic", "3.3")
strain_sum = enter("Ee_sum", r"E^e_+", ONE, "sum of the principal elastic Hencky strains in the plane", "3.3")
strain_gap = enter("Ee_gap", r"E^e_-", ONE, "difference of the principal elastic Hencky strains in the plane", "3.3")
stiffness_sum = enter("K_sum", "K_+", STRESS, "stress sum of a unit strain sum in plane stress", "3.6", positive=True)
stiffness_gap = enter("K_gap", "K_-", STRESS, "stress difference of a unit strain difference", "3.6", positive=True)

_PRINCIPAL = {
    bulk.elastic_strain[0, 0]: (strain_sum + strain_gap) / 2,
    bulk.elastic_strain[1, 1]: (strain_sum - strain_gap) / 2,
}


def no_flow() -> sp.Expr:
    """Nothing flows: the elastic law."""
    return sp.Integer(0)


def plastic_metric() -> sp.Matrix:
    """Cp^-1 in the plane."""
    return sp.Matrix([[state[0], state[1]], [state[1], state[2]]])


def along_axes(mean: sp.Expr, gap: sp.Expr) -> sp.Matrix:
    """Plane tensor with principal values ``mean`` +- ``gap`` along the principal axes of be."""
    return sp.Matrix([[mean + gap * cosine, gap * sine], [gap * sine, mean - gap * cosine]])


def elastic_metric() -> sp.Matrix:
    """Be = Fe Fe^T = F Cp^-1 F^T in the plane."""
    return deformation * plastic_metric() * deformation.T


def axes() -> dict[sp.Symbol, sp.Expr]:
    """Mean, half gap and axes of be, the gap from the components of its deviator."""
    metric = elastic_metric()
    normal, shear = (metric[0, 0] - metric[1, 1]) / 2, metric[0, 1]
    gap = sp.sqrt(normal**2 + shear**2)
    floored = sp.Max(gap, _TINY)
    return {mean_square: metric.trace() / 2, half_gap: gap, cosine: normal / floored, sine: shear / floored}


def trial_determinants() -> dict[sp.Symbol, sp.Expr]:
    """Inverse of det F, and det be without the cancellation in its components."""
    return {inverse_jacobian: 1 / jacobian, be_determinant: jacobian**2 * plastic_metric().det()}


def trial_strains() -> dict[sp.Symbol, sp.Expr]:
    """Sum and difference of the elastic Hencky strains log sqrt(b): of b_1 b_2 = det be and b_1/b_2 = b_1^2/det be."""
    return {
        trial_sum: sp.log(be_determinant) / 2,
        trial_gap: sp.log((mean_square + half_gap) ** 2 / be_determinant) / 2,
    }


def stiffness() -> dict[sp.Symbol, sp.Expr]:
    """M_1 + M_2 = K_+ (Ee_1 + Ee_2) and M_1 - M_2 = K_- (Ee_1 - Ee_2): K_+ = E/(1 - nu), K_- = E/(1 + nu).

    From :func:`softcat_sym.equations.bulk.plane_stress`, into which the flow rule does not enter.
    """
    stress = bulk.plane_stress(no_flow()).stress.subs(_PRINCIPAL)
    return {
        stiffness_sum: sp.simplify((stress[0, 0] + stress[1, 1]) / strain_sum),
        stiffness_gap: sp.simplify((stress[0, 0] - stress[1, 1]) / strain_gap),
    }


def equivalent_stress() -> sp.Expr:
    """sig_eq^2 = (S^2 + 3 D^2)/4 with S, D the sum and the difference of the principal Mandel stresses."""
    return sp.sqrt((stiffness_sum * strain_sum) ** 2 + 3 * (stiffness_gap * strain_gap) ** 2) / 2


def flow_per_stress(rate: sp.Expr) -> sp.Expr:
    """X = dt phi(sig_eq)/sig_eq, for a flow rule in the symbol ``sigma``."""
    return bulk.step * rate.subs(sigma, bulk.sigma_eq) / bulk.sigma_eq


def relaxation(rate: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """By how much the flow of a step divides the sum and the difference of the trial strains.

    Of Ee_trial - dt Lp = Ee, with Lp_1 + Lp_2 = (phi/sig_eq) S/2 and Lp_1 - Lp_2 = (3/2) (phi/sig_eq) D.
    """
    flow = flow_per_stress(rate)
    return 1 + flow * stiffness_sum / 2, 1 + flow * stiffness_gap * sp.Rational(3, 2)


def relaxed_strains(rate: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """What the flow of a step leaves of the trial strains."""
    of_sum, of_gap = relaxation(rate)
    return {strain_sum: trial_sum / of_sum, strain_gap: trial_gap / of_gap}


def residual(rate: sp.Expr) -> sp.Expr:
    """Zero where a step ends: sig_eq less what the relaxed strains give, times both divisors (cheaper, nearly linear).

    A flow rule that never falls as the stress grows leaves one root, between 0 and the equivalent stress of the trial:
    with sig_eq(x) that of the relaxed strains, x sig_eq(x) grows with x while dt phi(sig_eq(x)) does not.
    """
    of_sum, of_gap = relaxation(rate)
    crossed = {strain_sum: trial_sum * of_gap, strain_gap: trial_gap * of_sum}
    return bulk.sigma_eq * of_sum * of_gap - equivalent_stress().subs(crossed, simultaneous=True)


def kirchhoff_stress() -> sp.Matrix:
    """Tau = Re M Re^T in the plane."""
    return along_axes(stiffness_sum * strain_sum / 2, stiffness_gap * strain_gap / 2)


def first_piola_stress() -> sp.Matrix:
    """P = tau F^-T: force per reference area, the slope of the energy per reference volume."""
    return kirchhoff_stress() * _inverse().T


def new_state() -> sp.Matrix:
    """Cp^-1 = F^-1 be F^-T, with be = exp(2 Ee) along the axes of the trial."""
    large, small = sp.exp(strain_sum + strain_gap), sp.exp(strain_sum - strain_gap)
    return _inverse() * along_axes((large + small) / 2, (large - small) / 2) * _inverse().T


def elastic_energy() -> sp.Expr:
    """Stored energy per reference volume, M : Ee/2 = (S Ee_+ + D Ee_-)/4."""
    return (stiffness_sum * strain_sum**2 + stiffness_gap * strain_gap**2) / 4


def width_stretch() -> sp.Expr:
    """F_33 = exp(Ee_33) Fp_33, with Ee_33 from M_33 = 0 and Fp_33 = sqrt(det Cp^-1) from det Fp = 1."""
    return sp.exp(bulk.width_strain().subs(_PRINCIPAL)) * sp.sqrt(plastic_metric().det())


def plastic_work(rate: sp.Expr) -> sp.Expr:
    """Work done on the flow during a step, per reference volume: dt M : Lp."""
    return bulk.step * bulk.dissipation(rate)


def _inverse() -> sp.Matrix:
    """F^-1 by the determinant that is at hand."""
    return deformation.adjugate() * inverse_jacobian


def _equations() -> tuple[Equation, ...]:
    rate = bingham_rate()
    relaxed = relaxed_strains(rate)
    return (
        *(Equation(f"principal axes of be, {symbol}", symbol, value, "3.3") for symbol, value in axes().items()),
        *(Equation(f"stiffness, {symbol}", symbol, value, "3.6") for symbol, value in stiffness().items()),
        *(Equation(f"trial, {symbol}", symbol, value, "3.3") for symbol, value in trial_determinants().items()),
        *(Equation(f"trial strain, {symbol}", symbol, value, "3.3") for symbol, value in trial_strains().items()),
        *(Equation(f"relaxed strain, {symbol}", symbol, value, "3.8, corrected") for symbol, value in relaxed.items()),
        Equation("equivalent stress in plane stress", bulk.sigma_eq, equivalent_stress(), "3.5"),
        Equation("implicit step in plane stress", residual(rate), sp.Integer(0), "3.8, corrected"),
        Equation("plastic state after a step", state[0], new_state()[0, 0], "3.1"),
        Equation("first Piola stress", bulk.mandel[0, 0], first_piola_stress()[0, 0], "3.6"),
        Equation("stored energy in plane stress", bulk.sigma_eq, elastic_energy(), "3.6"),
    )


EQUATIONS: tuple[Equation, ...] = _equations()
