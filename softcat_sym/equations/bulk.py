"""The three-dimensional law (3.1)-(3.8), corrected: isotropic, frame-indifferent, for any overstress flow rule.

F = Fe Fp, Ee = log sqrt(Fe^T Fe), M = K tr(Ee) 1 + E/(1 + nu) Ee', Fp_t = Lp Fp, Lp = (3/2) phi(sig_eq)/sig_eq M'.
The chain is strain -> Mandel stress -> equivalent stress -> plastic rate; each link is written in the symbols that the
link before it computes, so that sig_eq stands as one symbol. Where nothing is stressed sig_eq vanishes: a consumer
floors it before it divides.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.laws.bingham import bingham_rate
from softcat_sym.equations.symbols import ONE, RATE, STRESS, TIME, E, enter, eta, sigma, sigma_Y

nu = enter("nu", r"\nu", ONE, "elastic Poisson's ratio", "3.6")
sigma_eq = enter("sigma_eq", r"\sigma_{eq}", STRESS, "equivalent tensile stress, sqrt 3 tau", "3.5", positive=True)
sigma_trial = enter(
    "sigma_trial", r"\sigma_{eq}^{tr}", STRESS, "equivalent stress if a step were elastic", "3.8", positive=True
)
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

    Parameters
    ----------
    stress : sympy.Matrix
        Mandel stress.
    rate : sympy.Expr
        Flow rule phi in the symbol ``sigma``, as in :mod:`softcat_sym.equations.laws`.
    """
    return flow_direction(stress) * rate.subs(sigma, sigma_eq)


def plastic_evolution(flow: sp.Matrix, plastic: sp.Matrix) -> sp.Matrix:
    """Fp_t = Lp Fp (3.8, corrected: the paper prints the inverse of Fp)."""
    return flow * plastic


def dissipation(rate: sp.Expr) -> sp.Expr:
    """M : Lp = sig_eq phi(sig_eq), plastic power per reference volume."""
    return sigma_eq * rate.subs(sigma, sigma_eq)


def return_residual(rate: sp.Expr) -> sp.Expr:
    """Zero where an implicit exponential-map step ends: sig_eq + 3 mu dt phi(sig_eq) - sig_trial.

    With Fp_new = exp(dt Lp) Fp the stress deviator keeps the direction of the trial and only shrinks, by
    sig_eq/sig_trial, so that one scalar equation is left for each point.
    """
    return sigma_eq + 3 * shear_modulus() * step * rate.subs(sigma, sigma_eq) - sigma_trial


def bingham_return() -> sp.Expr:
    """The root of :func:`return_residual` for the Bingham rule."""
    overstress = sp.Max(sigma_trial - sigma_Y, 0)
    return sigma_trial - overstress * (1 - 1 / (1 + 3 * shear_modulus() * step / eta))


@dataclass(frozen=True, slots=True)
class BulkLaw:
    """The chain from elastic strain to plastic rate for one point.

    Attributes
    ----------
    strain : sympy.Matrix
        Symbols of the elastic Hencky strain, a 3 x 3 tensor or three principal values (as a diagonal).
    stress : sympy.Matrix
        Mandel stress in these symbols.
    equivalent : sympy.Expr
        sig_eq in the symbols of ``mandel``.
    flow : sympy.Matrix
        Lp in the symbols of ``mandel`` and ``sigma_eq``.
    dissipation : sympy.Expr
        Plastic power per reference volume, in ``sigma_eq``.
    residual : sympy.Expr
        Scalar equation of an implicit step, in ``sigma_eq``, ``sigma_trial`` and ``step``.
    """

    strain: sp.Matrix
    stress: sp.Matrix
    equivalent: sp.Expr
    flow: sp.Matrix
    dissipation: sp.Expr
    residual: sp.Expr


def general(rate: sp.Expr) -> BulkLaw:
    """Law for a symmetric 3 x 3 elastic strain."""
    return _law(elastic_strain, mandel_stress(elastic_strain), mandel, rate)


def principal(rate: sp.Expr) -> BulkLaw:
    """Law in principal axes."""
    strain = _diagonal(elastic_strain)
    return _law(strain, mandel_stress(strain), _diagonal(mandel), rate)


def plane_stress(rate: sp.Expr) -> BulkLaw:
    """Law in principal axes with M_33 = 0: Ee_33 is eliminated, ``strain[2, 2]`` gives it in the other two.

    Lp_33 does not vanish. What an implicit step makes of it stands in :mod:`softcat_sym.equations.bulk_step`: sum and
    difference of the stresses relax each by itself, and one scalar equation in sig_eq is left.
    """
    strain = sp.diag(elastic_strain[0, 0], elastic_strain[1, 1], width_strain())
    stress = mandel_stress(strain).applyfunc(sp.factor)
    return _law(strain, stress, sp.diag(mandel[0, 0], mandel[1, 1], 0), rate)


def width_strain() -> sp.Expr:
    """Ee_33 = -nu/(1 - nu) (Ee_11 + Ee_22) that makes M_33 vanish."""
    return -nu * (elastic_strain[0, 0] + elastic_strain[1, 1]) / (1 - nu)


def _diagonal(tensor: sp.Matrix) -> sp.Matrix:
    return sp.diag(*(tensor[i, i] for i in range(3)))


def _law(strain: sp.Matrix, stress: sp.Matrix, symbols: sp.Matrix, rate: sp.Expr) -> BulkLaw:
    return BulkLaw(
        strain=strain,
        stress=stress,
        equivalent=equivalent_stress(symbols),
        flow=plastic_flow(symbols, rate),
        dissipation=dissipation(rate),
        residual=return_residual(rate),
    )


def _equations() -> tuple[Equation, ...]:
    law, flat = general(bingham_rate()), plane_stress(bingham_rate())
    zero = sp.Integer(0)
    return (
        Equation("elasticity, normal", mandel[0, 0], law.stress[0, 0], "3.6"),
        Equation("elasticity, shear", mandel[0, 1], law.stress[0, 1], "3.6"),
        Equation("elasticity in plane stress", mandel[0, 0], flat.stress[0, 0], "3.6"),
        Equation("equivalent stress", sigma_eq, law.equivalent, "3.5"),
        Equation("plastic rate, normal", plastic_rate[0, 0], law.flow[0, 0], "3.7, corrected"),
        Equation("plastic rate, shear", plastic_rate[0, 1], law.flow[0, 1], "3.7, corrected"),
        Equation("plastic power", double_dot(mandel, plastic_rate), law.dissipation, "3.7"),
        Equation("implicit step", law.residual, zero, "3.8, corrected"),
        Equation("implicit step, Bingham", sigma_eq, bingham_return(), "3.8, corrected"),
    )


EQUATIONS: tuple[Equation, ...] = _equations()
