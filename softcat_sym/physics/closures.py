"""The closures for the plastic state (THEORY 4): the paper's, as printed, and the material one, the default."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics.kinematics import StrainMeasure
from softcat_sym.physics.sections import Contraction
from softcat_sym.physics.symbols import (
    A0,
    AREA,
    LENGTH,
    M,
    enter,
    h0,
    s,
    theta_X,
)


@dataclass(frozen=True, slots=True)
class ClosedSection:
    """What a closure makes of a strain measure and a contraction."""

    lever: sp.Expr  # Bending strain at zeta = 1 per unit -theta_X
    recall_mean: sp.Expr  # Factors with which the states a_0 and a_1 count as plastic strain
    recall_bending: sp.Expr
    axial_correction: sp.Expr  # Q - T in terms of M, theta_X and s


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

h = enter("h", "h", LENGTH, "thickness of the section", "2.26", positive=True)
A = enter("A", "A", AREA, "area of the section", "2.9", positive=True)
