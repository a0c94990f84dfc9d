"""The section point by point: a chain from (r_X, psi) over the fibres to forces, for a filament that shears or not.

A filament that is not to shear gets a shear stiffness so large that it hardly does, and fibres that yield under their
axial stress alone: what is left is the paper's kinematics (2.5), (2.6) with the section on the cell (A 1, A 2).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations import reissner
from softcat_sym.equations.reissner import FibreFlow, ShearingCell
from softcat_sym.equations.section import Section
from softcat_sym.equations.symbols import h0, s

SHEAR_CORRECTION: dict[str, sp.Rational] = {
    "rectangle": reissner.RECTANGLE_SHEAR,
    "circle": reissner.CIRCLE_SHEAR,
}

RIGIDITY = 1000
"""How many times stiffer in shear a section is made that is not to shear: what remains of the shear is a thousandth."""


@dataclass(frozen=True, slots=True)
class ResolvedSection:
    """What one cell of a filament with a resolved section consists of.

    Attributes
    ----------
    shears : bool
        Whether shear is physics here; otherwise it is only kept small.
    strains : tuple of sympy.Expr
        (Lam, Gam) of (r_X, psi).
    cell : ShearingCell
        The chain from strains over fibres to forces, with the shear correction put in.
    flow : FibreFlow or None
        Plastic rates of a fibre, of (sigma, tau) and ``sigma_eq``; None where the law does not flow.
    relative_thickness : sympy.Expr
        h/h0 of Lam.
    rotary_inertia : sympy.Expr
        rho I0, undeformed.
    """

    shears: bool
    strains: tuple[sp.Expr, sp.Expr]
    cell: ShearingCell
    flow: FibreFlow | None
    relative_thickness: sp.Expr
    rotary_inertia: sp.Expr


def resolve(shape: Section, rate: sp.Expr | None, *, shear: bool) -> ResolvedSection:
    """Assemble the chain for a section that shrinks both ways.

    Parameters
    ----------
    shape : Section
        Rectangle or circle.
    rate : sympy.Expr or None
        Flow rule phi in the symbol ``sigma``; None for an elastic law.
    shear : bool
        Whether the filament shears.
    """
    correction = SHEAR_CORRECTION[shape.name] * (1 if shear else RIGIDITY)
    cell = reissner.cell().corrected(correction)
    flow = None
    if rate is not None:
        flow = reissner.fibre_flow(rate) if shear else reissner.axial_flow(rate)
    return ResolvedSection(
        shears=shear,
        strains=reissner.director_strains(),
        cell=cell,
        flow=flow,
        relative_thickness=(cell.thickness / h0).subs(s, reissner.Lam),
        rotary_inertia=reissner.rotary_inertia(shape),
    )
