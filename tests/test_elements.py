"""The elements: exact solutions, beams, runs of scenes, finished runs, meshes."""

from __future__ import annotations

import math
import signal
from dataclasses import fields

import numpy as np
import pytest
import sympy as sp

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.physics.loads import quintic_step
from softcat_sym.reference.element_loop import (
    NODES,
    POINTS,
    Clamp,
    ElementLoop,
    Mesh,
    half_span_supports,
    largest_frequency,
    mass_shares,
    shape_gradients,
    shape_values,
)
from softcat_sym.reference.elements import ElementRun, recalled_elements, run_elements
from tests.common.material_point import MaterialPoint
from tests.common.strips import (
    BINGHAM,
    ELASTIC,
    POISSON,
    Floats,
    clamped_loop,
    deformed,
    free_loop,
    internal_force,
    shortened,
    timoshenko_frequency,
    timoshenko_sag,
)

PATCH = Mesh(5, 4, grading=2.5)
THICKNESS = 0.2
GRADIENT = np.array([[1.3, 0.2], [-0.1, 0.8]])


def test_uniform_deformation_leaves_no_force_inside_and_exact_tractions_outside() -> None:
    loop = free_loop(PATCH, THICKNESS)
    loop.displacement[...] = deformed(loop.strip, GRADIENT)
    force = internal_force(loop)
    point = MaterialPoint("elastic", ELASTIC)
    point.step(GRADIENT, 0.0)
    X, Y = loop.strip.position.T
    inside = (X > 0) & (X < 0.5) & (abs(Y) < THICKNESS / 2)
    assert inside.sum() > 20
    assert force[inside] == pytest.approx(0, abs=1e-14)
    # On the clamped face the shares of the upper and the lower edge cancel.
    assert force[X == 0.5].sum(axis=0) == pytest.approx(point.stress[:, 0] * THICKNESS, rel=1e-12)
    # Virial: the sum of f_i X_J is P_iJ times the volume.
    assert force.T @ loop.strip.position == pytest.approx(point.stress * THICKNESS / 2, rel=1e-12)
    assert loop.elastic_energy == pytest.approx(point.energy * THICKNESS / 2, rel=1e-13)


def test_rigid_rotation_costs_nothing() -> None:
    loop = free_loop(PATCH, THICKNESS)
    c, s = np.cos(2.0), np.sin(2.0)
    loop.displacement[...] = deformed(loop.strip, [[c, -s], [s, c]]) + np.array([0.3, -0.7])
    assert internal_force(loop) == pytest.approx(0, abs=1e-14)
    assert loop.elastic_energy < 1e-26


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
    assert errors[1] < 1e-5
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.02)


PULL = 0.3
"""Of the surface over E."""


def stiffness_of(loop: ElementLoop) -> Floats:
    """Derivatives of the internal forces by the displacements where an unheld strip is at rest."""
    count, tiny = loop.displacement.size, 1e-6
    stiffness = np.empty((count, count))
    for k in range(count):
        sides = []
        for sign in (1, -1):
            loop.displacement[...] = 0
            loop.displacement.flat[k] = sign * tiny
            sides.append(internal_force(loop).ravel())
        stiffness[:, k] = (sides[0] - sides[1]) / (2 * tiny)
    return stiffness


def test_the_surface_pulls_a_stretched_bar_with_its_closed_form() -> None:
    """Energy 2 Gam h0 L/2 (s^1/2 - 1), s the stretch F e_X of both edges; force Gam h0 s^-1/2 along them."""
    bare, pulled = (free_loop(PATCH, THICKNESS, pull=pull) for pull in (0.0, PULL))
    for loop in (bare, pulled):
        loop.displacement[...] = deformed(loop.strip, GRADIENT)
    force = internal_force(pulled) - internal_force(bare)
    fibre = GRADIENT[:, 0]
    stretch = float(np.linalg.norm(fibre))
    axial = PULL * THICKNESS / math.sqrt(stretch) * fibre / stretch
    X, Y = pulled.strip.position.T
    assert force[X == 0.5].sum(axis=0) == pytest.approx(axial, rel=1e-12)
    assert force[X == 0].sum(axis=0) == pytest.approx(-axial, rel=1e-12)
    assert force[(X > 0) & (X < 0.5)] == pytest.approx(0, abs=1e-14)
    assert force[abs(Y) < THICKNESS / 2] == pytest.approx(0, abs=1e-14)
    assert pulled.surface_energy == pytest.approx(PULL * THICKNESS * (math.sqrt(stretch) - 1), rel=1e-12)
    assert bare.surface_energy == 0


def test_the_force_of_the_surface_is_the_slope_of_its_energy() -> None:
    bare, pulled = (free_loop(PATCH, THICKNESS, pull=pull) for pull in (0.0, PULL))
    random = np.random.default_rng(3)
    place = deformed(pulled.strip, GRADIENT) + 0.004 * random.standard_normal(pulled.displacement.shape)
    bare.displacement[...] = pulled.displacement[...] = place
    force = internal_force(pulled) - internal_force(bare)
    for _ in range(5):
        direction = random.standard_normal(place.shape)
        energies = []
        for sign in (1, -1):
            pulled.displacement[...] = place + sign * 1e-6 * direction
            pulled.evaluate(0.0, 0.0)
            energies.append(pulled.surface_energy)
        assert (energies[0] - energies[1]) / 2e-6 == pytest.approx(np.sum(force * direction), rel=1e-7)


@pytest.mark.parametrize("tension", [4.4, 18.0])
def test_a_strip_held_up_by_its_surface_sags_as_a_beam_in_tension(tension: float) -> None:
    """EI (1 + F/K) psi'' - F psi = q x, w' = (K psi - q x)/(K + F): Timoshenko's beam, pulled with F along w'."""
    thickness, inertia = 0.03, 0.03**3 / 12
    shear, axial = REISSNER * thickness / (2 * (1 + POISSON)), tension * inertia
    loop = free_loop(Mesh(24, 2, grading=4.0), thickness, pull=axial / thickness)
    supports = half_span_supports(loop.strip, Clamp.FIXED)
    free = ~supports.held.ravel()
    weight = np.stack([np.zeros_like(loop.strip.mass), -loop.strip.mass], axis=1).ravel()
    sag = np.zeros(weight.size)
    sag[free] = np.linalg.solve(stiffness_of(loop)[np.ix_(free, free)], weight[free])
    k = math.sqrt(axial / (inertia * (1 + axial / shear)))
    turned = thickness / axial * (1 / 8 - math.tanh(k / 4) / (2 * k))
    exact = (shear * turned + thickness / 8) / (shear + axial)
    assert -sag.reshape(-1, 2)[loop.strip.centreline[0], 1] == pytest.approx(exact, rel=5e-3)


@pytest.mark.parametrize(("along", "through"), [(1, 2), (4, 2)])
def test_a_free_mesh_has_three_modes_without_energy_and_stays_below_the_bound(along: int, through: int) -> None:
    """Two elements are enough to be rid of the one spurious mode of the reduced integration."""
    loop = free_loop(Mesh(along, through), THICKNESS)
    stiffness = stiffness_of(loop)
    scale = np.repeat(loop.strip.mass, 2) ** -0.5
    squares = np.linalg.eigvalsh(stiffness * np.outer(scale, scale))
    bound = largest_frequency(loop.strip.size, POISSON)
    assert stiffness == pytest.approx(stiffness.T, abs=1e-8 * abs(stiffness).max())
    assert np.sum(abs(squares) < 1e-8 * squares[-1]) == 3
    assert squares[3] > 1e-5 * squares[-1]
    assert np.sqrt(squares[-1]) < bound < 1.15 * np.sqrt(squares[-1])


def test_an_element_turned_inside_out_is_named() -> None:
    loop = free_loop(Mesh(3, 2), THICKNESS)
    X = loop.strip.position[:, 0]
    loop.displacement[X == 0.5, 0] = -0.4
    with pytest.raises(SoftcatError, match="element 3 of 3 from midspan, 1 of 2 from below"):
        loop.evaluate(0.01, 0.0)


REISSNER = 5 / 6
_PERIODS, _SAMPLES = 3, 200


def swing(mesh: Mesh, thickness: float, poisson: float) -> tuple[float, float]:
    """Sag and frequency of the swing under sudden gravity, over Timoshenko's with kappa = 5/6."""
    sag = timoshenko_sag(thickness, 1.0, REISSNER, poisson)
    frequency = timoshenko_frequency(thickness, REISSNER, poisson)
    # A hundredth of the thickness: the tension of the swing is some 1e-4 of the bending force.
    gravity = 0.01 * thickness / sag
    loop = clamped_loop(mesh, thickness, gravity, poisson)
    interval = 2 * math.pi / frequency / _SAMPLES
    steps = math.ceil(interval * largest_frequency(loop.strip.size, poisson) / 1.8)
    loop.evaluate(0.0, 0.0)
    height = [0.0]
    for k in range(_PERIODS * _SAMPLES):
        loop.begin(k * interval, interval / steps, steps)
        loop.march(steps)
        height.append(loop.displacement[loop.strip.centreline[0], 1])
    mean, found = harmonic(interval * np.arange(len(height)), np.array(height), frequency)
    return -mean / (gravity * sag), found / frequency


def harmonic(time: Floats, height: Floats, near: float) -> tuple[float, float]:
    """Mean and frequency of the harmonic that fits best, in least squares."""

    def fit(omega: float) -> tuple[float, float]:
        basis = np.stack([np.ones_like(time), np.cos(omega * time), np.sin(omega * time)], axis=1)
        solution, residual, *_ = np.linalg.lstsq(basis, height, rcond=None)
        return float(residual[0]), float(solution[0])

    centre, reach = near, 0.04 * near
    while reach > 1e-7 * near:
        tried = np.linspace(centre - reach, centre + reach, 21)
        centre, reach = tried[np.argmin([fit(omega)[0] for omega in tried])], reach / 8
    return fit(centre)[1], centre


def test_sag_and_period_of_the_papers_strip() -> None:
    sag, frequency = swing(Mesh(32, 2, grading=4.0), 0.03, 0.45)
    assert sag == pytest.approx(1, abs=5e-3)
    assert frequency == pytest.approx(1, abs=3e-3)


COARSE = Mesh(24, 2)
YIELDING = shortened(sc.load_scene("continual-descent"), 15.0, 6)
STIFF = shortened(sc.load_scene("arrested-underdamped"), 15.0, 6)
UNYIELDING = shortened(sc.load_scene("no-yield", {"load.ramp": "0 s"}), 15.0, 6)
SPAN = YIELDING.filament.span


def drop(run: ElementRun) -> float:
    return float(run.midpoint[-1]) / SPAN


@pytest.fixture(scope="module")
def descent() -> ElementRun:
    return run_elements(YIELDING, COARSE)


def test_energy_is_balanced_and_half_the_step_changes_nothing(descent: ElementRun) -> None:
    for scene in (UNYIELDING, YIELDING, STIFF):
        whole = descent if scene is YIELDING else run_elements(scene, COARSE)
        half = run_elements(scene, COARSE, step_factor=0.5)
        change = abs(drop(half) - drop(whole))
        assert whole.energy_error < 1e-4
        assert half.energy_error < 0.6 * whole.energy_error
        assert change < 1e-5
        assert 1.95 < half.steps / whole.steps < 2.05


def test_the_energy_of_the_surface_is_its_tension_times_what_it_grows_by() -> None:
    filament = STIFF.filament
    # It pulls with 0.8 of the yield stress.
    gamma = 0.8 * (STIFF.material.yield_stress or 0.0) / (1 / filament.thickness + 1 / filament.width)
    run = run_elements(STIFF.replace({"surroundings.surface_tension": f"{gamma!r} N/m"}), COARSE)
    bare = run_elements(STIFF, COARSE)
    assert run.energy_error < 1e-4
    assert drop(run) / drop(bare) < 0.95
    assert 0 == run.energy_surface[0] < run.energy_surface[1]
    assert np.all(bare.energy_surface == 0)
    stretch = np.hypot(np.diff(run.x[-1]), np.diff(run.y[-1])) / np.diff(run.X)
    grown = 2 * np.sum((np.sqrt(stretch) - 1) * np.diff(run.X)) * 2 * (filament.thickness + filament.width)
    assert run.energy_surface[-1] == pytest.approx(gamma * grown, rel=0.02)


@pytest.mark.slow
def test_meshes_converge() -> None:
    for scene in (UNYIELDING, YIELDING):
        found = [drop(run_elements(scene, Mesh(*m))) for m in ((8, 2), (16, 4), (24, 6))]
        first, second = abs(found[1] - found[0]), abs(found[2] - found[1])
        # Even at first order the ratio would be 3.
        assert first > 3 * second


def test_a_step_beyond_the_stable_one_is_refused_not_returned(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("softcat_sym.reference.elements.SAFETY", 1.3)
    with pytest.raises(SoftcatError, match=r"shorten the steps"):
        run_elements(UNYIELDING, COARSE)


def test_energies_that_do_not_add_up_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("softcat_sym.reference.elements._UNBALANCED", 1e-9)
    with pytest.raises(SoftcatError, match="energies miss the work of gravity"):
        run_elements(YIELDING, COARSE)


SCENE = shortened(sc.load_scene("continual-descent"), 12.0, 4)
MESH = Mesh(16, 2)


class Stop:
    """Interrupts a run at its n-th report, as the terminal does."""

    def __init__(self, at: int) -> None:
        self.at, self.reports = at, 0

    def update(self, simulated_time: float, step_size: float | None) -> None:
        del simulated_time, step_size
        self.reports += 1
        if self.reports == self.at:
            signal.raise_signal(signal.SIGINT)


@pytest.fixture(scope="module")
def straight() -> ElementRun:
    return run_elements(SCENE, MESH)


def same(one: ElementRun, other: ElementRun) -> bool:
    """Bit for bit, but for the wall time."""
    names = [field.name for field in fields(one) if field.name != "wall"]
    return all(np.array_equal(getattr(one, name), getattr(other, name)) for name in names)


def test_a_finished_run_is_kept_to_the_last_bit(straight: ElementRun) -> None:
    with pytest.raises(KeyboardInterrupt):
        recalled_elements(SCENE, MESH, progress=Stop(2))
    first = recalled_elements(SCENE, MESH)
    again = recalled_elements(SCENE, MESH, progress=Stop(1))
    assert same(first, straight) and same(again, straight) and again.wall == first.wall


def quadratic(at: np.ndarray) -> np.ndarray:
    x, y = at.T
    return 2 - x + 3 * y + x * y - 2 * x**2 + y**2 + 0.5 * x**2 * y - x * y**2


def test_shape_functions_hold_every_serendipity_polynomial_and_its_slope() -> None:
    at = np.array([[0.3, -0.7], [-0.9, 0.2], *POINTS])
    x, y = at.T
    nodal = quadratic(NODES)
    assert shape_values(NODES) == pytest.approx(np.eye(8), abs=1e-14)
    assert shape_values(at) @ nodal == pytest.approx(quadratic(at), abs=1e-13)
    slopes = np.einsum("jap,a->jp", shape_gradients(at), nodal)
    assert slopes[0] == pytest.approx(-1 + y - 4 * x + x * y - y**2, abs=1e-13)
    assert slopes[1] == pytest.approx(3 + x + 2 * y + 0.5 * x**2 - 2 * x * y, abs=1e-13)


def test_mass_is_lumped_after_hinton_rock_and_zienkiewicz() -> None:
    assert mass_shares() == pytest.approx([3 / 76] * 4 + [16 / 76] * 4, rel=1e-12)
