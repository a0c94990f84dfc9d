"""Elastic filaments: no-yield keeps its energy, and a thin stiff one swings with the period of a clamped beam."""

from __future__ import annotations

import numpy as np

import softcat_sym as sc

from .table import show


def test_no_yield_oscillates_without_yielding_and_keeps_its_energy() -> None:
    rows, residuals = [], []
    for rtol in (1e-3, 1e-4, 1e-5):
        run = sc.simulate(
            sc.load_scene("no-yield", {"run.effects": "paper", "numerics.rtol": rtol, "numerics.estimate": False})
        )
        midpoint = run.data.midpoint.values
        turns = int(np.sum(np.diff(np.sign(np.diff(midpoint))) != 0))
        residuals.append(run.summary["energy_residual"])
        rows.append([f"{rtol:g}", f"{residuals[-1]:.1e}", turns, run.summary["regime"], run.summary["steps"]])
        assert run.outcome is sc.Outcome.solved
        assert run.summary["regime"] == "no-yield"
        assert float(run.data.yielded_fraction.max()) == 0.0
        assert float(run.data.plastic_rate.max()) == 0.0
        assert turns >= 38  # 20 periods in the run
    show("no-yield, N = 80", ("rtol", "energy residual", "turning points", "regime", "steps"), rows)
    assert residuals[1] < 1e-4
    assert residuals[0] > residuals[1] > residuals[2]


STIFF = {
    "title": "Thin stiff rod",
    "filament": {"span": "1 m", "thickness": "5 mm", "density": "1000 kg/m^3"},
    "material": {"law": "elastic", "youngs_modulus": "200 GPa"},
    "run": {"duration": "0.2 s", "frames": 401},
    # The period is judged here, against the beam: an estimate of the midpoint over twenty swings would take a minute.
    "numerics": {"estimate": False},
}


def test_first_period_of_a_thin_stiff_filament_is_that_of_the_clamped_beam() -> None:
    scene = sc.Scene.model_validate(STIFF)
    run = sc.simulate(scene)
    time, midpoint = run.data.time.values, run.data.midpoint.values
    static = midpoint - midpoint.mean()
    up = np.flatnonzero((static[:-1] < 0) & (static[1:] >= 0))
    crossings = time[up] - static[up] * np.diff(time)[up] / np.diff(static)[up]
    period = float(np.mean(np.diff(crossings)))
    filament, modulus = scene.filament, scene.material.youngs_modulus
    assert modulus is not None
    stiffness = modulus * filament.thickness**2 / 12 / filament.density  # EI/(rho A)
    exact = 2 * np.pi / (4.730041**2 * np.sqrt(stiffness) / filament.span**2)
    show(
        "thin stiff clamped rod",
        ("period", "clamped beam", "difference"),
        [[f"{period:.6f} s", f"{exact:.6f} s", f"{100 * (period / exact - 1):+.3f} %"]],
    )
    assert run.outcome is sc.Outcome.solved
    assert abs(period / exact - 1) < 0.005
