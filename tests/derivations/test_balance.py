"""The motion of the centreline, (2.1)-(2.5) corrected, against exact solutions and against numbers."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from softcat_sym.physics import kinematics
from softcat_sym.physics import kinematics as balance
from softcat_sym.physics import kinematics as motion
from softcat_sym.physics.equation import DimensionError, check
from softcat_sym.physics.symbols import A0, M_X, Q, X, g, rho, s, t, x_X, x_X_before, y_X, y_X_before

LAMBDA_0 = rho * A0


def right_sides(solution: dict[sp.Expr, sp.Expr]) -> list[sp.Expr]:
    """Right sides of the corrected (2.4) on a known motion."""
    return [sp.simplify(e.right.subs(solution).doit()) for e in motion.MOTION]


def test_a_term_of_another_dimension_is_found() -> None:
    spoiled = replace(motion.TANGENTIAL, right=motion.TANGENTIAL.right * motion.x)
    with pytest.raises(DimensionError):
        check(spoiled)


def test_the_catenary_hangs_still() -> None:
    """x = a asinh(X/a), tension rho g A0 sqrt(a^2 + X^2): the curve of the exact inextensible catenary."""
    a = sp.Symbol("a", positive=True)
    hanging = {
        motion.angle: sp.atan(X / a),
        motion.stretch: sp.Integer(1),
        motion.moment: sp.Integer(0),
        motion.axial_force: LAMBDA_0 * g * sp.sqrt(a**2 + X**2),
    }
    assert right_sides(hanging) == [0, 0]


def test_a_whirling_rod_is_pulled_inwards() -> None:
    """A straight rod that turns with omega about its middle: acceleration -omega^2 r, gravity aside."""
    omega, length = sp.symbols("omega l", positive=True)
    whirling = {
        motion.angle: omega * t,
        motion.stretch: sp.Integer(1),
        motion.moment: sp.Integer(0),
        motion.axial_force: LAMBDA_0 * omega**2 * (length**2 / 4 - X**2) / 2,
    }
    found = right_sides(whirling)
    wanted = [-(omega**2) * X * sp.cos(omega * t), -(omega**2) * X * sp.sin(omega * t) - g]
    assert [sp.simplify(a - b) for a, b in zip(found, wanted, strict=True)] == [0, 0]


def test_a_uniformly_stretched_beam_feels_its_load_once() -> None:
    """A straight filament drawn to s: N = M_X/s, so that a parabolic moment carries M_XX/s per unit X."""
    load = sp.Symbol("q", positive=True)
    straight = {
        motion.angle: sp.Integer(0),
        motion.stretch: s,
        motion.moment: load * s * X**2 / 2,
        motion.axial_force: sp.Integer(0),
    }
    assert sp.simplify(right_sides(straight)[1] - (load / LAMBDA_0 - g)) == 0


def test_conservative_and_expanded_form_agree_on_a_random_filament() -> None:
    """Central differences of Q t + N n against (2.4), with nothing taken from the derivation."""
    rng = np.random.default_rng(3)
    c = [sp.Float(v, 17) for v in rng.uniform(0.2, 1.0, 8)]
    shape = {
        motion.angle: c[0] * sp.sin(3 * X) + c[1] * X,
        motion.stretch: 1 + c[2] * sp.cos(2 * X) / 3,
        motion.moment: c[3] * sp.sin(c[4] + 4 * X),
        motion.axial_force: c[5] + c[6] * sp.cos(5 * X),
    }
    numbers = {rho: 2, A0: 3, g: 0}
    rights = [sp.lambdify(X, e.right.subs(shape).doit().subs(numbers)) for e in motion.MOTION]
    angle, stretch, moment, axial = (sp.lambdify(X, value) for value in shape.values())

    def force(at: float) -> np.ndarray:
        step = 1e-5
        shear = (moment(at + step) - moment(at - step)) / (2 * step) / stretch(at)
        th = angle(at)
        return axial(at) * np.array([np.cos(th), np.sin(th)]) + shear * np.array([-np.sin(th), np.cos(th)])

    for at in rng.uniform(-1, 1, 20):
        step = 1e-4
        wanted = (force(at + step) - force(at - step)) / (2 * step) / 6
        assert [right(at) for right in rights] == pytest.approx(wanted, rel=1e-5, abs=1e-5)


@pytest.mark.parametrize("centreline", [kinematics.LARGE_ROTATION, kinematics.SMALL_SLOPE], ids=["large", "small"])
def test_power_of_the_internal_force(centreline: kinematics.Kinematics) -> None:
    """F.v_X = Q s_t + M_X theta_t, by finite differences along a random motion of the tangent."""
    force = balance.internal_force(centreline, bending=True)
    stretch_of = sp.lambdify((x_X, y_X), centreline.stretch)
    angle_of = sp.lambdify((x_X, y_X), centreline.turning.subs({x_X_before: 1, y_X_before: 0}))
    force_of = sp.lambdify((x_X, y_X, s, Q, M_X), (force.horizontal, force.vertical))
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


@pytest.mark.parametrize("turns", [0.3, 1.0, -2.7])
def test_turnings_add_up_over_full_turns(turns: float) -> None:
    turning = sp.lambdify((x_X_before, y_X_before, x_X, y_X), kinematics.LARGE_ROTATION.turning)
    angles = np.linspace(0, 2 * math.pi * turns, 33)
    tangents = np.column_stack([np.cos(angles), np.sin(angles)]) * np.linspace(1, 2, 33)[:, None]
    total = sum(turning(*tangents[k], *tangents[k + 1]) for k in range(32))
    assert total == pytest.approx(2 * math.pi * turns, rel=1e-12)


def test_geometry_of_an_ellipse() -> None:
    """(2.5) on x = 3 cos X, y = 2 sin X, whose curvature everybody knows."""
    ellipse = [(motion.x, 3 * sp.cos(X)), (motion.y, 2 * sp.sin(X))]
    stretch, change, _, turning = (e.right.subs(ellipse).doit() for e in motion.GEOMETRY)
    length = sp.sqrt(9 * sp.sin(X) ** 2 + 4 * sp.cos(X) ** 2)
    assert sp.simplify(stretch - length) == 0
    assert sp.simplify(change.subs(motion.stretch, length) - length.diff(X)) == 0
    assert sp.simplify(turning.subs(motion.stretch, length) - 6 / length**2) == 0
