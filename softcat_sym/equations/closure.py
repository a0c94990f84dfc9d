"""The two closures for the plastic state (THEORY 4): the paper's, as printed, and the material one, the default.

A closure fixes together how the plastic state enters the stress, which bending strain goes with theta_X, and which
axial force is conjugate to the stretch.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.kinematics import StrainMeasure
from softcat_sym.equations.section import Contraction
from softcat_sym.equations.symbols import A0, E, M, Q, T, a_0, a_1, h0, s, sigma_0, sigma_1, theta_X


@dataclass(frozen=True, slots=True)
class ClosedSection:
    """What a closure makes of a strain measure and a contraction.

    Attributes
    ----------
    lever : sympy.Expr
        Bending strain at zeta = 1 per unit -theta_X.
    recall_mean, recall_bending : sympy.Expr
        Factors with which the states a_0 and a_1 count as plastic strain.
    axial_correction : sympy.Expr
        Q - T in terms of M, theta_X and s.
    """

    lever: sp.Expr
    recall_mean: sp.Expr
    recall_bending: sp.Expr
    axial_correction: sp.Expr


def material(measure: StrainMeasure, contraction: Contraction) -> ClosedSection:
    """Fibres keep their zeta: eps = log s - theta_s (h/2) zeta, and Q = T + (3/2) M theta_s by work conjugacy.

    The correction to T is what the bending strain gains when the stretch changes at a fixed turning.
    """
    lever = contraction.thickness / (2 * measure.arc_stretch)
    return ClosedSection(
        lever=lever,
        recall_mean=sp.Integer(1),
        recall_bending=sp.Integer(1),
        axial_correction=-M * theta_X * sp.powsimp(sp.diff(lever, s) / lever),
    )


def printed(measure: StrainMeasure, contraction: Contraction) -> ClosedSection:
    """(2.6), (2.9)-(2.12): eps = log s - theta_X z, P and C as states, Q = T.

    P_t = integral of phi over the *current* section, so that P/A grows or shrinks with the section: the terms that the
    shrinking adds (A_t P/A and the like) are missing, and at finite stretch the tension is too small.
    """
    del measure
    shrink = A0 / contraction.area
    return ClosedSection(
        lever=contraction.thickness / 2,
        recall_mean=shrink,
        recall_bending=shrink * h0 / contraction.thickness,
        axial_correction=sp.Integer(0),
    )


CLOSURES = {"material": material, "printed": printed}

EQUATIONS: tuple[Equation, ...] = (
    Equation("axial force, material closure", Q, T + sp.Rational(3, 2) * M * theta_X / s, "THEORY 4"),
    Equation("axial force of a sheet, material closure", Q, T + 2 * M * theta_X / s, "THEORY 4"),
    Equation("axial force, printed closure", Q, T, "2.4"),
    Equation("mean stress, material closure", sigma_0, E * (sp.log(s) - a_0), "THEORY 4"),
    Equation("mean stress, printed closure", sigma_0, E * (sp.log(s) - s * a_0), "2.11"),
    Equation(
        "bending stress, material closure",
        sigma_1,
        -E * (h0 * theta_X / (2 * s ** sp.Rational(3, 2)) + a_1),
        "THEORY 4",
    ),
    Equation(
        "bending stress, printed closure",
        sigma_1,
        -E * (h0 * theta_X / (2 * sp.sqrt(s)) + s ** sp.Rational(3, 2) * a_1),
        "2.11",
    ),
)
