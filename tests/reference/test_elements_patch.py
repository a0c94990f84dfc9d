"""Exact solutions that any mesh must hold: uniform deformation, rigid rotation, free fall, modes of a free strip."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from softcat_sym.codegen.library import compile_library
from softcat_sym.errors import SoftcatError
from softcat_sym.physics.loads import quintic_step
from softcat_sym.reference.element_loop import Mesh, element_sources, largest_frequency
from softcat_sym.reference.material_point import MaterialPoint
from tests.reference.strips import BINGHAM, ELASTIC, POISSON, code_of, deformed, free_loop, internal_force

MESH = Mesh(5, 4, grading=2.5)
THICKNESS = 0.2
GRADIENT = np.array([[1.3, 0.2], [-0.1, 0.8]])


def test_uniform_deformation_leaves_no_force_inside_and_exact_tractions_outside() -> None:
    loop = free_loop(MESH, THICKNESS)
    loop.displacement[...] = deformed(loop.strip, GRADIENT)
    force = internal_force(loop)
    point = MaterialPoint("elastic", ELASTIC)
    point.step(GRADIENT, 0.0)
    X, Y = loop.strip.position.T
    inside = (X > 0) & (X < 0.5) & (abs(Y) < THICKNESS / 2)
    assert inside.sum() > 20
    assert force[inside] == pytest.approx(0, abs=2e-16)
    # On the clamped face the shares of the upper and the lower edge cancel.
    assert force[X == 0.5].sum(axis=0) == pytest.approx(point.stress[:, 0] * THICKNESS, rel=1e-12)
    # Virial: the sum of f_i X_J is P_iJ times the volume.
    assert force.T @ loop.strip.position == pytest.approx(point.stress * THICKNESS / 2, rel=1e-12)
    assert loop.elastic_energy == pytest.approx(point.energy * THICKNESS / 2, rel=1e-13)


def test_rigid_rotation_costs_nothing() -> None:
    loop = free_loop(MESH, THICKNESS)
    c, s = np.cos(2.0), np.sin(2.0)
    loop.displacement[...] = deformed(loop.strip, [[c, -s], [s, c]]) + np.array([0.3, -0.7])
    assert internal_force(loop) == pytest.approx(0, abs=1e-15)
    assert loop.elastic_energy < 1e-28


def test_a_patch_pulled_far_flows_like_the_material_point() -> None:
    loop = free_loop(Mesh(2, 2), THICKNESS, "bingham")
    point = MaterialPoint("bingham", BINGHAM)
    step, volume = 0.05, THICKNESS / 2
    for k in range(1, 101):
        u = k / 100
        gradient = [[1 + 1.2 * u, 0.4 * u**2], [0.1 * u, 1 - 0.35 * u]]
        loop.displacement[...] = deformed(loop.strip, gradient)
        loop.evaluate(step, 0.0)
        point.step(gradient, step)
    force = -loop.strip.mass[:, None] * loop.acceleration
    assert force.T @ loop.strip.position == pytest.approx(point.stress * volume, rel=1e-12)
    assert loop.plastic_work == pytest.approx(point.work * volume, rel=1e-12)
    assert loop.elastic_energy == pytest.approx(point.energy * volume, rel=1e-12)
    assert loop.rate == pytest.approx(np.full((4, 4), point.rate), rel=1e-11)
    assert loop.point == pytest.approx(np.tile(point.state, (4, 4, 1)), rel=1e-12)
    print(f"\nstretch 2.2: dissipated {loop.plastic_work / volume:.6f} E, point {point.work:.6f} E")


def test_free_fall() -> None:
    loop = free_loop(Mesh(4, 2), THICKNESS, gravity=0.3)
    loop.evaluate(0.01, 0.0)
    loop.begin(0.0, 0.01, 500)
    before = loop.kinetic_energy
    loop.march(500)
    assert loop.time == pytest.approx(5.0)
    assert loop.displacement == pytest.approx(np.tile([0.0, -0.3 * 5.0**2 / 2], (len(loop.strip.mass), 1)), abs=1e-11)
    assert loop.velocity[:, 1] == pytest.approx(-0.3 * 5.0, rel=1e-12)
    # Product of the speeds half a step before and after: balanced to round-off, at a step of any length.
    assert loop.kinetic_energy - before == pytest.approx(loop.gravity_work, rel=1e-12)
    assert before == pytest.approx(-(0.3**2) * 0.01**2 / 8 * loop.strip.mass.sum(), rel=1e-12)


def test_free_fall_while_gravity_grows_is_second_order_in_the_step() -> None:
    time = sp.Symbol("time")
    speed = sp.integrate(0.3 * quintic_step(time / 4).subs(sp.Min(1, sp.Max(0, time / 4)), time / 4), (time, 0, time))
    exact = -float(sp.integrate(speed, (time, 0, 4)) + speed.subs(time, 4) * 2 + 0.3 * 2**2 / 2)
    errors = []
    for steps in (300, 600):
        loop = free_loop(Mesh(1, 2), THICKNESS, gravity=0.3, ramp=4.0)
        loop.evaluate(0.01, 0.0)
        loop.begin(0.0, 6.0 / steps, steps)
        loop.march(steps)
        errors.append(abs(loop.displacement[0, 1] - exact))
    print(f"\nfall {exact:.9f}, errors {errors[0]:.3e} {errors[1]:.3e}, ratio {errors[0] / errors[1]:.3f}")
    assert errors[1] < 1e-5
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.02)


def test_gravity_follows_the_ramp_of_the_equations() -> None:
    loop = free_loop(Mesh(1, 2), THICKNESS, gravity=0.3, ramp=4.0)
    for time in (-1.0, 0.0, 0.4, 2.0, 3.9, 4.0, 7.0):
        assert loop.gravity(time) == pytest.approx(0.3 * float(quintic_step(sp.Float(time) / 4)), abs=1e-15)
    assert free_loop(Mesh(1, 2), THICKNESS, gravity=0.3).gravity(0.0) == 0.3


@pytest.mark.parametrize(("along", "through"), [(1, 2), (4, 2)])
def test_a_free_mesh_has_three_modes_without_energy_and_stays_below_the_bound(along: int, through: int) -> None:
    """Two elements are enough to be rid of the one spurious mode of the reduced integration."""
    loop = free_loop(Mesh(along, through), THICKNESS)
    count, tiny = loop.displacement.size, 1e-6
    stiffness = np.empty((count, count))
    for k in range(count):
        sides = []
        for sign in (1, -1):
            loop.displacement[...] = 0
            loop.displacement.flat[k] = sign * tiny
            sides.append(internal_force(loop).ravel())
        stiffness[:, k] = (sides[0] - sides[1]) / (2 * tiny)
    scale = np.repeat(loop.strip.mass, 2) ** -0.5
    squares = np.linalg.eigvalsh(stiffness * np.outer(scale, scale))
    bound = largest_frequency(loop.strip.size, POISSON)
    print(f"\n{along} x {through}: lowest squares over the largest {squares[:5] / squares[-1]}")
    print(f"largest frequency {np.sqrt(squares[-1]):.4f}, bound {bound:.4f}")
    assert stiffness == pytest.approx(stiffness.T, abs=1e-8 * abs(stiffness).max())
    assert np.sum(abs(squares) < 1e-8 * squares[-1]) == 3
    assert squares[3] > 1e-5 * squares[-1]
    assert np.sqrt(squares[-1]) < bound < 1.15 * np.sqrt(squares[-1])


def test_the_bound_sees_a_strip_that_thins() -> None:
    loop = free_loop(Mesh(4, 2), THICKNESS)
    rest = largest_frequency(loop.strip.size, POISSON, loop.deformation())
    assert rest == pytest.approx(largest_frequency(loop.strip.size, POISSON), rel=1e-12)
    turned = np.array([[0.0, -1.0], [1.0, 0.0]])
    for gradient, factor in ((turned, 1.0), (0.5 * turned, 2.0)):
        loop.displacement[...] = deformed(loop.strip, gradient)
        found = largest_frequency(loop.strip.size, POISSON, loop.deformation())
        assert found == pytest.approx(factor * rest, rel=1e-12)


def test_the_c_has_nothing_to_warn_of() -> None:
    strict = ("-O1", "-Wall", "-Wextra", "-pedantic", "-Werror")
    assert compile_library(element_sources(code_of("bingham")), units=["elements.c"], flags=strict).exists()


def test_an_element_turned_inside_out_is_named() -> None:
    loop = free_loop(Mesh(3, 2), THICKNESS)
    X = loop.strip.position[:, 0]
    loop.displacement[X == 0.5, 0] = -0.4
    with pytest.raises(SoftcatError, match="element 3 of 3 from midspan, 1 of 2 from below"):
        loop.evaluate(0.01, 0.0)
