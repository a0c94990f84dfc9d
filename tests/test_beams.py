"""Filaments against beams, strings, oracles, orders, limits and symmetries."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.scene.scene import Scene
from tests.common.closed_forms import (
    BEAM_CONSTANT,
    FIRST_EIGENVALUE,
    GYRATION,
    soft_beam_sag,
    viscous_string_sag,
    von_karman_sag,
)
from tests.common.filaments import GEOMETRY, PAPER, extrapolated, paper_scene, run, sag, scene, upward_crossings
from tests.common.reissner_filament import E_STAR
from tests.common.reissner_filament import run as oracle
from tests.common.rk4_filament import run as straight_oracle
from tests.marks import few

# The same filament in plain NumPy, written without a look at this package: staggered in space, RK4 in time.
CELLS_STRAIGHT = 20


@pytest.mark.parametrize(
    ("G", "end", "closure"),
    few(
        [(0.4, "clamped", "material"), (0.4, "pinned", "printed"), (1.9, "clamped", "printed")],
        (0.4, "clamped", "material"),
        (0.4, "pinned", "printed"),
    ),
)
def test_midpoint_and_shape_agree_with_the_straight_oracle(G: float, end: str, closure: str) -> None:
    """Overdamped arrests and a descent."""
    V = 26.0
    expected = straight_oracle(
        PAPER["delta"], G, V, None, "bingham", closure, CELLS_STRAIGHT, 20.0, outputs=(5, 10, 15), ends=end
    )
    asked = paper_scene(
        G, V, 20, frames=5, cells=CELLS_STRAIGHT, rtol=1e-7, solver="rosenbrock", closure=closure, ends=(end, end)
    )
    done = run(asked)
    assert done.outcome.is_success
    data, span = done.data, PAPER["span"]
    found = data["midpoint"].values[1:] / span
    shape = np.abs(data["x"].values[-1, CELLS_STRAIGHT:] / span - expected.x[-1]) + np.abs(
        data["y"].values[-1, CELLS_STRAIGHT:] / span - expected.y[-1]
    )
    error = np.max(np.abs(found / expected.midpoint - 1))
    assert error < 1e-5
    assert np.max(shape) < 1e-6


# The shearing filament in plain NumPy, written without a look at this package: complex plane, RK4, Newton for psi.
CELLS, FIBRES, FRAMES = 10, 4, 5
DURATION = 20.0
TIMES = tuple(np.linspace(0, DURATION, FRAMES)[1:])


def filament(G: float, V: float, effects: list[str], **changes: object) -> sc.Run:
    """The scene of the oracle, in plane stress, on the same equal cells, with a tolerance that leaves no time error."""
    published = ["inertia", "bending", "finite-stretch", "thinning", "large-rotation", "gravity-ramp"]
    overrides = {
        "groups.G": G,
        "groups.V": V,
        "groups.duration": DURATION,
        "filament.width": "1 um",
        "run.frames": FRAMES,
        "run.effects": [*published, "viscous-flow", "yielding", "shear", "fibres", *effects],
        "numerics.cells": CELLS,
        "numerics.grading": 1.0,
        "numerics.fibres": FIBRES,
        "numerics.solver": "rosenbrock",
        "numerics.rtol": 1e-7,
        **changes,
    }
    return sc.simulate(sc.load_scene("continual-descent", overrides))


# The oracle's gradient is that of the stretch along the normal, ours that of the centreline's.
GRADIENT = (0.25, 0.4, 1 / 48, 1e-5)


@pytest.mark.parametrize(
    ("G", "V", "beta", "tolerance"),
    few([(0.4, 26.0, None, 2e-6), (1.9, 26.0, None, 2e-6), GRADIENT], (0.4, 26.0, None, 2e-6), GRADIENT),
)
def test_midpoint_and_energies_agree(G: float, V: float, beta: float | None, tolerance: float) -> None:
    expected = oracle(0.03, G, V, CELLS, fibres=FIBRES, duration=DURATION, beta=beta, times=TIMES)
    run = filament(G, V, [] if beta is None else ["necking-gradient"])
    found = run.data["midpoint"].values[1:] / run.scene.filament.span
    error = np.max(np.abs(found / expected.midpoint - 1))
    filament_of = run.scene.filament
    unit = run.scene.material.youngs_modulus * filament_of.width * filament_of.thickness * filament_of.span
    lost = run.data["energy_dissipated"].values[1:] / unit / 2
    assert error < tolerance
    np.testing.assert_allclose(lost, expected.energies["dissipated"], rtol=20 * tolerance, atol=1e-12)
    if beta is not None:
        steepened = run.data["energy_gradient"].values[1:] / unit / 2
        np.testing.assert_allclose(steepened, expected.energies["gradient"], rtol=0.03, atol=1e-9)


@pytest.mark.slow
def test_the_pull_of_the_surface_agrees() -> None:
    """Gam half the yield stress, on an overdamped arrest; its energy too."""
    G, V, half = 0.4, 26.0, 0.5
    pull = half / (E_STAR * G)
    expected = oracle(0.03, G, V, CELLS, fibres=FIBRES, duration=DURATION, times=TIMES, surface=pull)
    gamma = pull * 4e6 / (1 / 6e-3 + 1 / 1e-6)
    run = filament(G, V, ["surface-tension"], **{"surroundings.surface_tension": f"{gamma!r} N/m"})
    found = run.data["midpoint"].values[1:] / run.scene.filament.span
    unit = 4e6 * 1e-6 * 6e-3 * 0.2
    surface = run.data["energy_surface"].values[1:] / unit / 2
    np.testing.assert_allclose(found, expected.midpoint, rtol=2e-6)
    np.testing.assert_allclose(surface, expected.energies["surface"], rtol=2e-5, atol=1e-13)
    assert run.summary["energy_residual"] < 1e-5


@pytest.mark.parametrize("ends", ["clamped", "pinned"])
def test_energies_of_a_linear_beam_are_clapeyrons(ends: str) -> None:
    """Stored q^2 L^5/(1440 E I) between clamps, q^2 L^5/(240 E I) between pins; the weight has given twice that."""
    h, E, q_per_area = 0.02, 1e12, 1e4
    asked = scene(thickness=h, E=E, ends=(ends, ends), effects=GEOMETRY, cells=40)
    data = run(asked).data
    area, second_moment = h**2, h**4 / 12
    expected = (q_per_area * area) ** 2 / ((1440 if ends == "clamped" else 240) * E * second_moment)
    stored, potential = float(data["energy_elastic"][-1]), float(data["energy_potential"][-1])
    assert stored == pytest.approx(expected, rel=3e-3)
    assert potential == pytest.approx(-2 * stored, rel=1e-6)


def vertical_force(data: xr.Dataset, axial: np.ndarray) -> np.ndarray:
    """Vertical component of the internal force Q t + N n on the cells, from the positions of the nodes."""
    dx, dy = np.diff(data["x"].values, axis=1), np.diff(data["y"].values, axis=1)
    length = np.hypot(dx, dy)
    return (axial * dy + data["shear_force"].values * dx) / length


def support_forces(data: xr.Dataset, axial: np.ndarray, density: float, area: float, gravity: float) -> np.ndarray:
    """Upward force of both supports: internal force in the end cells and the weight of the half cells at the ends."""
    force = vertical_force(data, axial)
    end_cells = data["X_node"].values[[1, -1]] - data["X_node"].values[[0, -2]]
    return force[:, -1] - force[:, 0] + density * gravity * area * np.sum(end_cells) / 2


def test_supports_carry_the_weight_in_the_material_closure() -> None:
    """Q = T + (3/2) M theta_s is rebuilt from cell means of M and theta_s here: third order in 1/N, as seen."""
    thickness, errors = 0.05, []
    for count in (40, 80):
        data = run(scene(thickness=thickness, E=3e5, effects=GEOMETRY, cells=count)).data
        axial = data["tension"].values + 1.5 * data["moment"].values * data["curvature"].values
        errors.append(support_forces(data, axial, 1000.0, thickness**2, 10.0)[-1] / (1e4 * thickness**2) - 1)
    assert abs(errors[1]) < 1e-4
    assert np.log2(errors[0] / errors[1]) == pytest.approx(3, abs=0.2), errors


def test_supports_carry_weight_and_inertia_while_falling() -> None:
    """Force on the supports = weight + rate of the vertical momentum, by differences of the positions in time."""
    thickness, density, gravity = 0.05, 1000.0, 10.0
    material = {"E": 3e6, "eta": 1e5, "closure": "printed"}
    asked = scene(thickness=thickness, **material, ramp=0.3, duration=1.0, frames=401, cells=8, rtol=1e-7)
    data = run(asked).data
    t, y = data["time"].values, data["y"].values
    u = np.clip(t / 0.3, 0, 1)
    now = gravity * u**3 * (10 - 15 * u + 6 * u**2)
    nodes = data["X_node"].values
    mass = density * thickness**2 * np.gradient(nodes) * np.where((nodes == nodes[0]) | (nodes == nodes[-1]), 0.5, 1)
    step = t[1] - t[0]
    second = (-y[4:] + 16 * y[3:-1] - 30 * y[2:-2] + 16 * y[1:-3] - y[:-4]) / (12 * step**2)
    inertia = second @ mass
    force = vertical_force(data, data["tension"].values)
    end_weight = density * thickness**2 * (nodes[1] - nodes[0]) * now
    supports = (force[:, -1] - force[:, 0] + end_weight)[2:-2]
    weight = density * thickness**2 * now[2:-2]
    error = np.max(np.abs(supports - weight - inertia)) / np.max(weight)
    share = np.max(np.abs(inertia)) / np.max(weight)
    assert share > 0.3
    assert error < 1e-4


# Beams: static sag for every pair of ends, stretching columns, large deflections, viscous creep.
TINY = 2e-5
"""Sag of the linear beams, over the span: a thousandth of their thickness."""


def test_static_sag_of_a_linear_beam() -> None:
    for section in ["rectangle", "circle"]:
        for ends in list(BEAM_CONSTANT):
            thickness, weight = 0.02, 1000.0 * 10.0
            E = weight / (BEAM_CONSTANT[ends] * GYRATION[section] * thickness**2 * TINY)
            found = [
                sag(run(scene(thickness=thickness, E=E, section=section, ends=ends, effects=GEOMETRY, cells=cells)))
                for cells in (20, 40)
            ]
            error = extrapolated(*found) / TINY - 1
            assert abs(found[1] / TINY - 1) < 2e-3
            assert abs(error) < 1e-4


def column_sag(E: float, effects: tuple[str, ...], cells: int) -> float:
    asked = scene(thickness=0.02, E=E, section="circle", density=636.62, gravity=9.80665, effects=effects, cells=cells)
    return sag(run(asked))


def test_small_strain_column_is_von_karmans() -> None:
    """Without large rotation, finite stretch and thinning the package solves von Karman's equations.

    The softer the column, the thinner the layers at its clamps: 2 cells of N = 40 at 1e5 Pa.
    """
    for E, tolerance in [(1e8, 1e-5), (1e7, 5e-5), (1e6, 3e-4), (1e5, 1.5e-3)]:
        expected = von_karman_sag(E, GYRATION["circle"] * 0.02**2, 636.62 * 9.80665)
        error = extrapolated(*(column_sag(E, ("bending", "extensibility"), cells) for cells in (20, 40))) / expected - 1
        assert abs(error) < tolerance


@pytest.mark.parametrize(
    ("E_star", "delta", "section"),
    few([(10.0, 0.05, "rectangle"), (20.0, 0.05, "circle"), (300.0, 0.03, "rectangle")], (20.0, 0.05, "circle")),
)
def test_large_deflection_against_a_boundary_value_solver(E_star: float, delta: float, section: str) -> None:
    expected = soft_beam_sag(E_star, delta, GYRATION[section])
    found = [
        sag(run(scene(thickness=delta, E=E_star * 1e4, section=section, effects=GEOMETRY, cells=cells)))
        for cells in (20, 40)
    ]
    error = extrapolated(*found) / expected - 1
    assert abs(error) < 3e-4


def test_creep_of_a_clamped_viscous_beam_of_circular_section() -> None:
    """sag = rho g L^4 t/(72 mu D^2) with the shear viscosity mu, on top of the elastic sag."""
    D, mu, E, weight = 0.02, 1e9, 1e12, 1000.0 * 10.0
    duration = 72 * mu * D**2 * TINY / weight
    asked = scene(
        thickness=D,
        E=E,
        eta=3 * mu,
        section="circle",
        effects=(*GEOMETRY, "viscous-flow"),
        duration=duration,
        frames=5,
        cells=40,
        rtol=1e-6,
    )
    done = run(asked)
    assert done.outcome.is_success
    t, found = done.data["time"].values, -done.data["midpoint"].values
    expected = weight * t / (72 * mu * D**2) + weight / (24 * E * D**2)
    np.testing.assert_allclose(found, expected, rtol=2e-3)


# Strings and cables, which carry their weight by tension alone: elastic and viscous.
WEIGHT = 1000.0 * 10.0


@pytest.mark.parametrize("E_star", [50.0, 1e3, 1e5])
def test_shallow_elastic_cable(E_star: float) -> None:
    """sag^3 = 3 rho g L^4/(64 E), with its prefactor: exact for the barest filament whatever E."""
    barest = (scene(thickness=0.01, E=E_star * WEIGHT, effects=("extensibility",), cells=n) for n in (20, 40))
    found = [sag(run(asked)) for asked in barest]
    prefactor = extrapolated(*(depth**3 * E_star for depth in found))
    assert prefactor == pytest.approx(3 / 64, rel=1e-6)


def viscous_string(*effects: str, E_star: float, final_sag: float) -> tuple[np.ndarray, np.ndarray, float]:
    """Times and sags of a quasi-static Maxwell string that should end at a given sag, and its viscosity."""
    eta = 1e6
    duration = final_sag**3 * 128 * eta / (9 * WEIGHT)
    done = run(
        scene(
            thickness=1e-4,
            E=E_star * WEIGHT,
            eta=eta,
            effects=("viscous-flow", *effects),
            duration=duration,
            frames=6,
            cells=40,
            rtol=1e-7,
        )
    )
    assert done.outcome.is_success, done.summary["message"]
    return done.data["time"].values, -done.data["midpoint"].values, eta


def test_shallow_maxwell_string_from_elastic_sag_to_creep() -> None:
    """The whole history, elastic sag, logarithm and one-third law, against its closed form."""
    E_star = 1e4
    t, found, eta = viscous_string(E_star=E_star, final_sag=0.03)
    expected = np.array([viscous_string_sag(time, E_star * WEIGHT, eta, WEIGHT) for time in t])
    np.testing.assert_allclose(found, expected, rtol=2e-4)


# Second order in 1/N: the observed order of three grids, each twice as fine as the last.
SCENES = {
    "elastic-beam": scene(thickness=0.03, E=3e6, effects=GEOMETRY),
    "elastic-swing": scene(thickness=0.03, E=3e6, ramp=0.3, duration=0.4, rtol=1e-5),
    "maxwell-creep": scene(
        thickness=0.03, E=1e7, eta=1e5, effects=(*GEOMETRY, "viscous-flow"), duration=0.3, rtol=1e-6
    ),
    "maxwell-descent": scene(thickness=0.03, E=1e7, eta=2.6e5, duration=1.0, rtol=1e-6, solver="rosenbrock"),
    "bingham-descent": paper_scene(1.9, 26, 46, rtol=1e-6, solver="rosenbrock"),
}


@pytest.mark.parametrize("name", few(SCENES, "elastic-beam", "bingham-descent"))
def test_midpoint_is_second_order(name: str) -> None:
    asked = SCENES[name]
    sags = [sag(run(asked.replace({"numerics.cells": cells}))) / asked.filament.span for cells in (20, 40, 80)]
    order = np.log2((sags[0] - sags[1]) / (sags[1] - sags[2]))
    assert 1.7 < order < 2.3


def depth(asked: Scene, cells: int, grading: float | None) -> float:
    """Final sag over span, on this grid alone; the program chooses a grading of None."""
    gridded = asked.replace({"numerics.cells": cells, "numerics.grading": grading, "numerics.estimate": False})
    return sag(run(gridded)) / asked.filament.span


# Inertia: free fall, and the first frequency of beams.
GRAVITY = 10.0


@pytest.mark.parametrize("law", ["elastic", "maxwell", "bingham"])
def test_midpoint_falls_freely_until_the_ends_are_felt(law: str) -> None:
    """-g t^2/2: the news of the supports travels a half span at the axial wave speed sqrt(E/rho)."""
    E_star = 100.0
    before_the_news = 0.9 * 0.5 / np.sqrt(E_star)
    asked = scene(
        thickness=0.01,
        E=E_star * 1e4,
        eta=None if law == "elastic" else 1e5,
        yield_stress=1e4 if law == "bingham" else None,
        duration=before_the_news * np.sqrt(1 / GRAVITY),
        frames=21,
        cells=40,
        rtol=1e-6,
    )
    data = run(asked).data
    t, y = data["time"].values[1:], data["midpoint"].values[1:]
    error = np.max(np.abs(y / (-GRAVITY * t**2 / 2) - 1))
    assert error < 1e-6


@pytest.mark.parametrize("ends", list(FIRST_EIGENVALUE), ids="-".join)
def test_first_frequency_of_a_beam(ends: tuple[str, str]) -> None:
    """Gravity at once: the midpoint swings about the static sag, between zero and about twice it."""
    thickness, density, static = 0.01, 1000.0, 1e-4
    E = density * GRAVITY / (BEAM_CONSTANT[ends] * GYRATION["rectangle"] * thickness**2 * static)
    rigidity = E * GYRATION["rectangle"] * thickness**2 / density
    period = 2 * np.pi / (FIRST_EIGENVALUE[ends] ** 2 * np.sqrt(rigidity))
    asked = scene(thickness=thickness, E=E, ends=ends, duration=10.5 * period, frames=801, cells=40, rtol=3e-4)
    done = run(asked)
    assert done.outcome.is_success
    t, y = done.data["time"].values, done.data["midpoint"].values
    crossings = upward_crossings(t, y + static)
    found = (crossings[-1] - crossings[0]) / (len(crossings) - 1)
    assert len(crossings) == 10
    assert found == pytest.approx(period, rel=2e-3)
    assert -np.mean(y[t < 10 * period]) == pytest.approx(static, rel=5e-3)
    assert -np.min(y) == pytest.approx(2 * static, rel=0.03)


def asked(*texts: str) -> Scene:
    """A Bingham scene from quantities with their units."""
    span, thickness, density, E, eta, yield_stress, gravity, ramp, duration = texts
    table = {
        "filament": {"span": span, "thickness": thickness, "density": density},
        "material": {"law": "bingham", "youngs_modulus": E, "viscosity": eta, "yield_stress": yield_stress},
        "load": {"gravity": gravity, "ramp": ramp},
        "run": {"duration": duration, "frames": 11},
        "numerics": {"cells": 20},
    }
    return Scene.model_validate(table)
