"""Balances: energy over a run, forces on the supports."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from softcat_sym.results.trajectory import Trajectory

from .scenes import GEOMETRY, paper_scene, run, scene

LAWS = {
    "elastic": scene(thickness=0.03, E=3e6, duration=1.0, frames=41, cells=10),
    "maxwell": scene(thickness=0.03, E=3e6, eta=3e4, duration=1.0, frames=41, cells=10, solver="rosenbrock"),
    "bingham": paper_scene(0.4, 26, 60, frames=41, cells=10, solver="rosenbrock"),
    "bingham-bdf": paper_scene(0.4, 26, 60, frames=41, cells=10, solver="cvodes"),
}


def imbalance(done: Trajectory) -> float:
    """Largest change of kinetic + elastic + potential + dissipated - work, over the largest of them."""
    data = done.data
    stored = ("energy_kinetic", "energy_elastic", "energy_potential", "energy_dissipated")
    balance = sum(data[name].values for name in stored) - data["work_external"].values
    return float(np.ptp(balance) / max(np.max(np.abs(data[name].values)) for name in (*stored, "work_external")))


def test_energy_closes_with_the_tolerance_in_the_material_closure() -> None:
    for asked in LAWS.values():
        tolerances = (1e-3, 1e-4, 1e-5)
        residuals = [imbalance(run(asked.replace({"numerics.rtol": rtol}))) for rtol in tolerances]
        print(
            "  ".join(f"rtol {rtol:.0e}: {residual:.1e}" for rtol, residual in zip(tolerances, residuals, strict=True))
        )
        assert residuals[0] > 3 * residuals[1] > 9 * residuals[2]
        assert residuals[2] < 2e-5


@pytest.mark.parametrize("law", ["elastic", "bingham"])
def test_energy_does_not_close_in_the_printed_closure(law: str) -> None:
    """Its forces have no potential: a tighter tolerance does not help."""
    printed = LAWS[law].replace({"run.closure": "printed"})
    loose, tight = (imbalance(run(printed.replace({"numerics.rtol": rtol}))) for rtol in (1e-4, 1e-6))
    print(f"{law}, printed: rtol 1e-4 {loose:.2e}, 1e-6 {tight:.2e}")
    assert tight > 1e-3
    assert tight == pytest.approx(loose, rel=0.02)


def test_dissipation_never_decreases() -> None:
    for closure in ["material", "printed"]:
        for law in ["maxwell", "bingham", "bingham-bdf"]:
            done = run(LAWS[law].replace({"numerics.rtol": 1e-5, "run.closure": closure}))
            lost = done.data["energy_dissipated"].values
            worst = float(np.min(np.diff(lost)) / lost[-1])
            print(f"{law}, {closure}: smallest increment {worst:.1e} of the total")
            assert lost[0] == 0
            assert lost[-1] > 0
            # A high-order method sums the power with weights of both signs: where flow sets in they leave a trace.
            assert worst > -1e-7


@pytest.mark.parametrize("ends", ["clamped", "pinned"])
def test_energies_of_a_linear_beam_are_clapeyrons(ends: str) -> None:
    """Stored q^2 L^5/(1440 E I) between clamps, q^2 L^5/(240 E I) between pins; the weight has given twice that."""
    h, E, q_per_area = 0.02, 1e12, 1e4
    asked = scene(thickness=h, E=E, ends=(ends, ends), effects=GEOMETRY, cells=40)
    data = run(asked).data
    area, second_moment = h**2, h**4 / 12
    expected = (q_per_area * area) ** 2 / ((1440 if ends == "clamped" else 240) * E * second_moment)
    stored, potential = float(data["energy_elastic"][-1]), float(data["energy_potential"][-1])
    print(f"{ends}: stored {stored / expected - 1:+.1e}, potential {potential / (-2 * expected) - 1:+.1e}")
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


@pytest.mark.parametrize(
    ("effects", "closure", "ends"),
    [
        (("large-rotation", "finite-stretch", "thinning"), "material", ("clamped", "clamped")),
        (GEOMETRY, "printed", ("clamped", "clamped")),
        (GEOMETRY, "printed", ("clamped", "pinned")),
    ],
    ids=["string", "beam", "clamped-pinned-beam"],
)
def test_supports_carry_the_weight(effects: tuple[str, ...], closure: str, ends: tuple[str, str]) -> None:
    """Exactly, on any grid: with the printed closure Q = T, and the discrete forces balance cell by cell."""
    thickness, density, gravity = 0.05, 1000.0, 10.0
    asked = scene(thickness=thickness, E=3e5, ends=ends, effects=effects, closure=closure, cells=8)
    data = run(asked).data
    weight = density * gravity * thickness**2
    found = support_forces(data, data["tension"].values, density, thickness**2, gravity)[-1]
    print(f"{closure} {ends}: supports/weight - 1 = {found / weight - 1:+.1e}")
    assert found == pytest.approx(weight, rel=1e-9)


def test_supports_carry_the_weight_in_the_material_closure() -> None:
    """Q = T + (3/2) M theta_s is rebuilt from cell means of M and theta_s here: second order in 1/N."""
    thickness, weight = 0.05, 1e4 * 0.05**2
    errors = []
    for cells in (10, 20, 40):
        data = run(scene(thickness=thickness, E=3e5, effects=GEOMETRY, cells=cells)).data
        axial = data["tension"].values + 1.5 * data["moment"].values * data["curvature"].values
        errors.append(support_forces(data, axial, 1000.0, thickness**2, 10.0)[-1] / weight - 1)
    print("material closure, N = 10, 20, 40:", [f"{error:+.1e}" for error in errors])
    assert abs(errors[2]) < abs(errors[1]) < abs(errors[0])
    assert abs(errors[2]) < 3e-3


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
    print(f"falling: largest imbalance {error:.1e} of the weight, inertia up to {share:.2f}")
    assert share > 0.3
    assert error < 1e-4
