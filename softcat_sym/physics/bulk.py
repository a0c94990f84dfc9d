"""The three-dimensional law (3.1)-(3.8), corrected, and its implicit exponential-map step in plane stress."""

from __future__ import annotations

import sympy as sp

from softcat_sym.physics.symbols import ONE, RATE, STRESS, TIME, E, enter, sigma

nu = enter("nu", r"\nu", ONE, "elastic Poisson's ratio", "3.6")
sigma_eq = enter("sigma_eq", r"\sigma_{eq}", STRESS, "equivalent tensile stress, sqrt 3 tau", "3.5", positive=True)
step = enter("step", r"\Delta t", TIME, "time step of an implicit update", "3.8", positive=True)

_AXES = ("1", "2", "3")


def _tensor(name: str, latex: str, dimension: tuple[int, int, int], meaning: str, source: str) -> sp.Matrix:
    """Symmetric 3 x 3 tensor whose six components stand in the table."""
    components = {
        i + j: enter(f"{name}_{i}{j}", f"{latex}_{{{i}{j}}}", dimension, f"{meaning}, component {i}{j}", source)
        for i in _AXES
        for j in _AXES
        if i <= j
    }
    return sp.Matrix(3, 3, lambda i, j: components["".join(sorted(_AXES[i] + _AXES[j]))])


elastic_strain = _tensor("Ee", "E^e", ONE, "elastic Hencky strain", "3.3")
mandel = _tensor("Mandel", "M", STRESS, "Mandel stress", "3.4")
plastic_rate = _tensor("Lp", "L^p", RATE, "plastic rate of deformation", "3.7")


def deviator(tensor: sp.Matrix) -> sp.Matrix:
    """A' = A - tr(A)/3 1."""
    return tensor - sp.eye(3) * tensor.trace() / 3


def double_dot(a: sp.Matrix, b: sp.Matrix) -> sp.Expr:
    """A : B = sum of A_ij B_ij."""
    return sum((p * q for p, q in zip(a, b, strict=True)), sp.Integer(0))


def shear_modulus() -> sp.Expr:
    """Mu = E/(2 (1 + nu))."""
    return E / (2 * (1 + nu))


def mandel_stress(strain: sp.Matrix) -> sp.Matrix:
    """M = E/(3 (1 - 2 nu)) tr(Ee) 1 + E/(1 + nu) Ee' (3.6)."""
    return sp.eye(3) * E * strain.trace() / (3 * (1 - 2 * nu)) + deviator(strain) * E / (1 + nu)


def elastic_energy(strain: sp.Matrix) -> sp.Expr:
    """Stored energy per reference volume, the potential of :func:`mandel_stress`."""
    return double_dot(mandel_stress(strain), strain) / 2


def equivalent_stress(stress: sp.Matrix) -> sp.Expr:
    """sig_eq = sqrt(3/2 M' : M') = sqrt 3 tau (3.5); the tensile stress in a tensile test."""
    return sp.sqrt(sp.Rational(3, 2) * double_dot(deviator(stress), deviator(stress)))


def flow_direction(stress: sp.Matrix) -> sp.Matrix:
    """(3/2) M'/sig_eq, of unit equivalent rate."""
    return deviator(stress) * sp.Rational(3, 2) / sigma_eq


def plastic_flow(stress: sp.Matrix, rate: sp.Expr) -> sp.Matrix:
    """Lp = (3/2) phi(sig_eq) M'/sig_eq (3.7, corrected): in a tensile test the rate phi of (2.25).

    The paper's 3/eta with the Frobenius norm |M'| is sqrt 2 times too fast.
    """
    return flow_direction(stress) * rate.subs(sigma, sigma_eq)


def dissipation(rate: sp.Expr) -> sp.Expr:
    """M : Lp = sig_eq phi(sig_eq), plastic power per reference volume."""
    return sigma_eq * rate.subs(sigma, sigma_eq)


def flat_strain() -> sp.Matrix:
    """Elastic strain in principal axes of plane stress, M_33 = 0: Ee_33 in the other two. Lp_33 does not vanish."""
    return sp.diag(elastic_strain[0, 0], elastic_strain[1, 1], width_strain())


def width_strain() -> sp.Expr:
    """Ee_33 = -nu/(1 - nu) (Ee_11 + Ee_22) that makes M_33 vanish."""
    return -nu * (elastic_strain[0, 0] + elastic_strain[1, 1]) / (1 - nu)


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

_PRINCIPAL = {elastic_strain[0, 0]: (strain_sum + strain_gap) / 2, elastic_strain[1, 1]: (strain_sum - strain_gap) / 2}


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
    """M_1 + M_2 = K_+ (Ee_1 + Ee_2) and M_1 - M_2 = K_- (Ee_1 - Ee_2): K_+ = E/(1 - nu), K_- = E/(1 + nu)."""
    stress = mandel_stress(flat_strain()).applyfunc(sp.factor).subs(_PRINCIPAL)
    return {
        stiffness_sum: sp.cancel((stress[0, 0] + stress[1, 1]) / strain_sum),
        stiffness_gap: sp.cancel((stress[0, 0] - stress[1, 1]) / strain_gap),
    }


def plane_stress_equivalent_stress() -> sp.Expr:
    """sig_eq^2 = (S^2 + 3 D^2)/4 with S, D the sum and the difference of the principal Mandel stresses."""
    return sp.sqrt((stiffness_sum * strain_sum) ** 2 + 3 * (stiffness_gap * strain_gap) ** 2) / 2


def flow_per_stress(rate: sp.Expr) -> sp.Expr:
    """X = dt phi(sig_eq)/sig_eq, for a flow rule in the symbol ``sigma``."""
    return step * rate.subs(sigma, sigma_eq) / sigma_eq


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
    return sigma_eq * of_sum * of_gap - plane_stress_equivalent_stress().subs(crossed, simultaneous=True)


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


def plane_stress_elastic_energy() -> sp.Expr:
    """Stored energy per reference volume, M : Ee/2 = (S Ee_+ + D Ee_-)/4."""
    return (stiffness_sum * strain_sum**2 + stiffness_gap * strain_gap**2) / 4


def width_stretch() -> sp.Expr:
    """F_33 = exp(Ee_33) Fp_33, with Ee_33 from M_33 = 0 and Fp_33 = sqrt(det Cp^-1) from det Fp = 1."""
    return sp.exp(width_strain().subs(_PRINCIPAL)) * sp.sqrt(plastic_metric().det())


def plastic_work(rate: sp.Expr) -> sp.Expr:
    """Work done on the flow during a step, per reference volume: dt M : Lp."""
    return step * dissipation(rate)


def _inverse() -> sp.Matrix:
    """F^-1 by the determinant that is at hand."""
    return deformation.adjugate() * inverse_jacobian
