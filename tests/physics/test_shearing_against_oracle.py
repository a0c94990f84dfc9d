"""The shearing filament in plain NumPy, written without a look at this package: complex plane, RK4, Newton for psi."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.reissner_filament import E_STAR
from tests.common.reissner_filament import run as oracle

CELLS, FIBRES, FRAMES = 10, 4, 5
DURATION = 20.0
TIMES = tuple(np.linspace(0, DURATION, FRAMES)[1:])


def filament(G: float, V: float, effects: list[str], **changes: object) -> sc.Trajectory:
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


@pytest.mark.parametrize(
    ("G", "V", "beta", "tolerance"),
    [
        (0.01, 26.0, None, 2e-6),
        (0.4, 26.0, None, 2e-6),
        (1.9, 26.0, None, 2e-6),
        (0.25, 0.4, None, 5e-6),
        # The oracle's gradient is that of the stretch along the normal, ours that of the centreline's.
        (0.25, 0.4, 1 / 48, 1e-5),
    ],
    ids=["no-yield", "overdamped", "descent", "underdamped", "with gradient"],
)
def test_midpoint_and_energies_agree(G: float, V: float, beta: float | None, tolerance: float) -> None:
    expected = oracle(0.03, G, V, CELLS, fibres=FIBRES, duration=DURATION, beta=beta, times=TIMES)
    run = filament(G, V, [] if beta is None else ["necking-gradient"])
    found = run.data["midpoint"].values[1:] / run.scene.filament.span
    error = np.max(np.abs(found / expected.midpoint - 1))
    filament_of = run.scene.filament
    unit = run.scene.material.youngs_modulus * filament_of.width * filament_of.thickness * filament_of.span
    lost = run.data["energy_dissipated"].values[1:] / unit / 2
    print(f"G = {G}, V = {V}, beta = {beta}: sag {-found[-1]:.6f} L, midpoint {error:.0e}")
    assert error < tolerance
    np.testing.assert_allclose(lost, expected.energies["dissipated"], rtol=20 * tolerance, atol=1e-12)
    if beta is not None:
        steepened = run.data["energy_gradient"].values[1:] / unit / 2
        np.testing.assert_allclose(steepened, expected.energies["gradient"], rtol=0.03, atol=1e-9)


@pytest.mark.parametrize("backend", ["compiled", "interpreted"])
def test_the_pull_of_the_surface_agrees(backend: str) -> None:
    """Gam half the yield stress, on an overdamped arrest; its energy too."""
    G, V, half = 0.4, 26.0, 0.5
    pull = half / (E_STAR * G)
    expected = oracle(0.03, G, V, CELLS, fibres=FIBRES, duration=DURATION, times=TIMES, surface=pull)
    gamma = pull * 4e6 / (1 / 6e-3 + 1 / 1e-6)
    changes = {"surroundings.surface_tension": f"{gamma!r} N/m", "numerics.backend": backend}
    run = filament(G, V, ["surface-tension"], **changes)
    found = run.data["midpoint"].values[1:] / run.scene.filament.span
    unit = 4e6 * 1e-6 * 6e-3 * 0.2
    surface = run.data["energy_surface"].values[1:] / unit / 2
    print(f"{backend}: sag {-found[-1]:.6f} L, error {np.max(np.abs(found / expected.midpoint - 1)):.0e}")
    np.testing.assert_allclose(found, expected.midpoint, rtol=2e-6)
    np.testing.assert_allclose(surface, expected.energies["surface"], rtol=2e-5, atol=1e-13)
    assert run.summary["energy_residual"] < 1e-5
