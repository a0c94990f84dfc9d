"""Backstress: kinematic hardening of a material that yields, with Armstrong & Frederick's dynamic recovery.

A fibre has a back strain A beside its plastic strain, A_t = D - q A |D| of the plastic rate D, and flows by its stress
less the backstress C A (Armstrong & Frederick 1966, reprinted 2007; Dimitriou & McKinley 2014 with the power m = 1 of
the recovery). It stores C A^2/2 and dissipates q C A^2 |D| besides the power of what drives the flow. Without recovery
this is Prager's linear hardening (1956). The shear component of a fibre that shears hardens by C/3 (von Mises).
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.physics.constitutive_laws import Constant
from softcat_sym.physics.symbols import ONE, STRESS, enter

SOURCE = "Armstrong & Frederick 1966; Dimitriou & McKinley 2014"

modulus = enter("C_h", "C", STRESS, "modulus of kinematic hardening in tension", SOURCE, positive=True)
recovery = enter("q_h", "q", ONE, "dynamic recovery of the back strain per plastic strain", SOURCE)
axial = enter("A_h", "A", ONE, "axial back strain of a fibre", SOURCE)
shear = enter("A_hs", "A_s", ONE, "back strain of a fibre in shear", SOURCE)
axial_stress = enter("chi_b", r"\chi", STRESS, "axial backstress of a fibre", SOURCE)
shear_stress = enter("chi_bs", r"\chi_s", STRESS, "shear component of the backstress of a fibre", SOURCE)

CONSTANTS = (Constant("material_hardening_modulus", modulus), Constant("material_hardening_recovery", recovery))


def stored(share: sp.Expr) -> sp.Expr:
    """Energy of the back strain per unit undeformed volume; `share` is 3/4 where the width is held, otherwise 1."""
    return modulus / share * axial**2 / 2 + modulus / 3 * shear**2 / 2


def back_stress(share: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Axial and shear backstress, the derivatives of the stored energy."""
    axially, across = (sp.diff(stored(share), one) for one in (axial, shear))
    return axially, across


def back_rate(plastic: sp.Expr, strain: sp.Expr, speed: sp.Expr) -> sp.Expr:
    """Rate of a component of the back strain, of the plastic rate of that component [1/s]."""
    return plastic - recovery * strain * speed


def recovered(share: sp.Expr, speed: sp.Expr) -> sp.Expr:
    """Power that recovery dissipates per unit undeformed volume."""
    return 2 * recovery * speed * stored(share)
