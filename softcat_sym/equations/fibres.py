"""The section point by point: a chain from (r_X, psi) over the fibres to forces, for a filament that shears or not.

A filament that is not to shear gets a shear stiffness so large that it hardly does, and fibres that yield under their
axial stress alone: what is left is the paper's kinematics (2.5), (2.6) with the section on the cell (A 1, A 2).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations import reissner
from softcat_sym.equations.bulk import shear_modulus
from softcat_sym.equations.law import Branch, Law
from softcat_sym.equations.reissner import FibreFlow, ShearingCell, eps_p, gamma_p, tau_f
from softcat_sym.equations.section import Section
from softcat_sym.equations.section_response import PLANE_STRAIN, resistance, stiffness
from softcat_sym.equations.symbols import E, h0, kappa_0, s, sigma, zeta

SHEAR_CORRECTION: dict[str, sp.Rational] = {
    "rectangle": reissner.RECTANGLE_SHEAR,
    "circle": reissner.CIRCLE_SHEAR,
    "sheet": reissner.RECTANGLE_SHEAR,
}

RIGIDITY = 1000
"""How many times stiffer in shear a section is made that is not to shear: what remains of the shear is a thousandth."""


@dataclass(frozen=True, slots=True)
class FibreBranch:
    """One spring of a fibre with its flow rule.

    Attributes
    ----------
    axial_stress, shear_stress : sympy.Expr
        sigma and tau of (Lam, Gam, k, zeta) and the plastic state (eps_p, gamma_p) of the branch.
    elastic_energy : sympy.Expr
        Stored energy per unit undeformed volume, of (sigma, tau).
    flow : FibreFlow or None
        Plastic rates, of (sigma, tau) and ``sigma_eq``; None where it does not flow.
    """

    axial_stress: sp.Expr
    shear_stress: sp.Expr
    elastic_energy: sp.Expr
    flow: FibreFlow | None


@dataclass(frozen=True, slots=True)
class ViscousFibre:
    """The viscous stress of a fibre.

    Attributes
    ----------
    axial_stress, shear_stress : sympy.Expr
        Of (Lam, Gam, k, zeta) and their rates.
    dissipation, speed : sympy.Expr
        Power per unit undeformed volume and equivalent strain rate, of (sigma, tau).
    """

    axial_stress: sp.Expr
    shear_stress: sp.Expr
    dissipation: sp.Expr
    speed: sp.Expr


@dataclass(frozen=True, slots=True)
class ResolvedSection:
    """What one cell of a filament with a resolved section consists of.

    Attributes
    ----------
    shears : bool
        Whether shear is physics here; otherwise it is only kept small.
    strains, strain_rates : tuple of sympy.Expr
        (Lam, Gam) of (r_X, psi), and their rates.
    cell : ShearingCell
        The chain from strains to forces.
    branches : tuple of FibreBranch
        Springs in parallel.
    viscous : ViscousFibre or None
        What acts beside them.
    relative_thickness : sympy.Expr
        h/h0 of Lam.
    rotary_inertia : sympy.Expr
        rho I0, undeformed.
    """

    shears: bool
    strains: tuple[sp.Expr, sp.Expr]
    strain_rates: tuple[sp.Expr, sp.Expr]
    cell: ShearingCell
    branches: tuple[FibreBranch, ...]
    viscous: ViscousFibre | None
    relative_thickness: sp.Expr
    rotary_inertia: sp.Expr

    @property
    def flows(self) -> bool:
        """Whether there is a plastic state."""
        return any(branch.flow is not None for branch in self.branches)


def resolve(shape: Section, law: Law, *, shear: bool, curved: bool = False) -> ResolvedSection:
    """Assemble the chain for a section that shrinks as its shape does.

    Parameters
    ----------
    shape : Section
        Rectangle, circle or sheet.
    law : Law
        With the one flow rule of each branch that is in force.
    shear : bool
        Whether the filament shears.
    curved : bool
        Whether the relaxed filament is curved.
    """
    correction = SHEAR_CORRECTION[shape.name] * (1 if shear else RIGIDITY)
    cell = reissner.cell(shape.contraction).corrected(correction)
    relaxed = -h0 * kappa_0 / 2 * zeta if curved else sp.Integer(0)
    return ResolvedSection(
        shears=shear,
        strains=reissner.director_strains(),
        strain_rates=reissner.director_rates(),
        cell=cell,
        branches=tuple(_branch(shape, cell, branch, correction, relaxed, shear=shear) for branch in law.branches),
        viscous=None if law.viscosity is None else _viscous(shape, cell, law.viscosity, correction),
        relative_thickness=(cell.thickness / h0).subs(s, reissner.Lam),
        rotary_inertia=reissner.rotary_inertia(shape),
    )


def _branch(
    shape: Section, cell: ShearingCell, branch: Branch, correction: sp.Expr, relaxed: sp.Expr, *, shear: bool
) -> FibreBranch:
    modulus, shearing = stiffness(shape, branch.modulus), correction * shear_modulus().subs(E, branch.modulus)
    flow = None
    if branch.flow is not None:
        share = PLANE_STRAIN**2 if shape.plane_strain else sp.S.One
        flow = (reissner.fibre_flow if shear else reissner.axial_flow)(branch.flow.rate, share)
    return FibreBranch(
        axial_stress=modulus * (cell.axial_strain - relaxed - eps_p),
        shear_stress=shearing * (cell.shear_strain - gamma_p),
        elastic_energy=sigma**2 / (2 * modulus) + tau_f**2 / (2 * shearing),
        flow=flow,
    )


def _viscous(shape: Section, cell: ShearingCell, viscosity: sp.Expr, correction: sp.Expr) -> ViscousFibre:
    # Shear viscosity eta/3 (Trouton), with the same correction as the shear modulus.
    axial, shearing = resistance(shape, viscosity), correction * viscosity / 3
    rates = reissner.strain_rates(cell)
    dissipation = sigma**2 / axial + tau_f**2 / shearing
    return ViscousFibre(
        axial_stress=axial * rates[0],
        shear_stress=shearing * rates[1],
        dissipation=dissipation,
        speed=sp.Abs(sigma) / axial,
    )
