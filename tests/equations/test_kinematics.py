"""Gradients of stretch and angle, and the balance written through them."""

from __future__ import annotations

import math

import pytest
import sympy as sp

from softcat_sym.physics.kinematics import LARGE_ROTATION, SMALL_SLOPE, SMALL_STRAIN, TRUE_STRAIN, internal_force
from softcat_sym.physics.symbols import M_X, Q, s, theta, x_X, x_X_before, y_X, y_X_before

TANGENT = {x_X: s * sp.cos(theta), y_X: s * sp.sin(theta)}


def test_the_stretch_grows_along_the_tangent() -> None:
    along = [sp.simplify(part.subs(TANGENT)) for part in LARGE_ROTATION.stretch_gradient()]
    assert along == [sp.cos(theta), sp.sin(theta)]


def test_the_angle_grows_along_the_normal_over_the_stretch() -> None:
    across = [sp.simplify(part.subs(TANGENT)) for part in LARGE_ROTATION.angle_gradient()]
    assert sp.simplify(across[0] + sp.sin(theta) / s) == 0
    assert sp.simplify(across[1] - sp.cos(theta) / s) == 0


def test_small_slopes_keep_the_leading_order_of_both() -> None:
    assert SMALL_SLOPE.stretch_gradient() == (1, y_X)
    assert SMALL_SLOPE.angle_gradient() == (0, 1)
    size = sp.Symbol("size", positive=True)
    near = {x_X: 1 + size**2 * x_X, y_X: size * y_X}
    difference = (LARGE_ROTATION.stretch - SMALL_SLOPE.stretch).subs(near, simultaneous=True)
    assert sp.limit(difference / size**3, size, 0) == 0


def test_the_turning_does_not_wrap_past_the_vertical() -> None:
    for turned in [-3.0, -1.2, 0.0, 0.4, 2.0, 3.1]:
        for start in [-2.5, 0.3, 3.0]:
            at = {
                x_X_before: 1.3 * math.cos(start),
                y_X_before: 1.3 * math.sin(start),
                x_X: 0.7 * math.cos(start + turned),
                y_X: 0.7 * math.sin(start + turned),
            }
            assert float(LARGE_ROTATION.turning.subs(at)) == pytest.approx(turned, abs=1e-14)


def test_turning_back_is_turning_the_other_way() -> None:
    back = {x_X_before: x_X, y_X_before: y_X, x_X: x_X_before, y_X: y_X_before}
    swapped = SMALL_SLOPE.turning.subs(back, simultaneous=True)
    assert sp.simplify(swapped + SMALL_SLOPE.turning) == 0
    at = {x_X_before: 1, y_X_before: sp.Rational(1, 3), x_X: sp.Rational(1, 2), y_X: -2}
    turned = LARGE_ROTATION.turning
    assert float((turned.subs(back, simultaneous=True) + turned).subs(at)) == 0


@pytest.mark.parametrize("measure", [TRUE_STRAIN, SMALL_STRAIN], ids=["true", "small"])
def test_strain_measures_agree_near_one(measure: object) -> None:
    strain = measure.strain  # type: ignore[attr-defined]
    assert strain.subs(s, 1) == 0
    assert sp.diff(strain, s).subs(s, 1) == 1
    assert measure.arc_stretch in (s, 1)  # type: ignore[attr-defined]


def test_the_force_is_q_along_and_the_shear_across() -> None:
    """Q t + (M_X/s) n for large rotations (2.1, 2.2)."""
    force = internal_force(LARGE_ROTATION, bending=True)
    wanted = (
        Q * sp.cos(theta) - M_X / s * sp.sin(theta),
        Q * sp.sin(theta) + M_X / s * sp.cos(theta),
    )
    for found, right in zip((force.horizontal, force.vertical), wanted, strict=True):
        assert sp.simplify(found.subs(TANGENT) - right) == 0


def test_the_small_slope_force() -> None:
    force = internal_force(SMALL_SLOPE, bending=True)
    assert (force.horizontal, force.vertical) == (Q, Q * y_X + M_X)


@pytest.mark.parametrize("kinematics", [LARGE_ROTATION, SMALL_SLOPE], ids=["large", "small"])
def test_a_string_has_no_transverse_force(kinematics: object) -> None:
    force = internal_force(kinematics, bending=False)  # type: ignore[arg-type]
    assert M_X not in force.horizontal.free_symbols | force.vertical.free_symbols
    assert internal_force(kinematics, bending=True).vertical.coeff(Q) == force.vertical.coeff(Q)  # type: ignore[arg-type]
