"""Filaments that rupture, or hold energy that nothing gave them: refused, and cut where they end."""

from __future__ import annotations

import math

import numpy as np

import softcat_sym as sc
from softcat_sym.results.verdict import gained_energy, largest_stretch, neck_strain, rupture, rupture_frame
from softcat_sym.simulate import without_estimate

from .runs import scene_of


def test_a_solid_is_strongest_at_e_and_a_fluid_ends_as_a_thread() -> None:
    assert largest_stretch(scene_of("elastic")) == math.e
    assert largest_stretch(scene_of("maxwell")) == 1000


def test_the_first_frame_beyond_counts_and_is_told() -> None:
    stretch = np.ones((4, 3))
    stretch[2:, 1] = 2.8
    assert rupture_frame(scene_of("elastic"), stretch) == 2
    assert rupture_frame(scene_of("maxwell"), stretch) is None
    text = rupture(scene_of("elastic"), np.array([0.0, 1.0, 2.0, 3.0]), stretch, np.linspace(-0.5, 0.5, 4))
    assert "t = 2 s" in text
    assert "X/L = 0 " in text
    assert rupture_frame(scene_of("maxwell"), np.full((2, 3), np.nan)) == 0


def energies(
    kinetic: float, elastic: float, potential: float, work: float, surface: float = 0.0
) -> dict[str, np.ndarray]:
    names = ("energy_kinetic", "energy_elastic", "energy_potential", "work_external", "energy_surface")
    pairs = zip(names, (kinetic, elastic, potential, work, surface), strict=True)
    return {name: np.array([0.0, value]) for name, value in pairs}


def test_nothing_holds_more_than_it_was_given() -> None:
    assert not gained_energy(energies(0.5, 0.4, -1.0, 0.0), 0.0)
    assert not gained_energy(energies(0.5, 1.4, -1.0, 1.0), 0.0)
    assert "weight and supports gave 1 J" in gained_energy(energies(1.0, 0.4, -1.0, 0.0), 0.0)
    assert not gained_energy(energies(1.0, 0.4, -1.0, 0.0, -0.4), 0.0)
    assert not gained_energy(energies(1e-9, 0.0, 0.0, 0.0), 1e-8)


def test_a_filament_too_weak_for_its_weight_ends_at_its_rupture() -> None:
    weak = scene_of("elastic").replace(
        {"material.youngs_modulus": "2 kPa", "run.effects": "paper", "load.ramp": "0 s", "run.duration": "1 s"}
    )
    run = sc.simulate(without_estimate(weak))
    assert run.outcome is sc.Outcome.ruptured
    assert float(run.data["stretch"].max()) <= math.e
    assert run.summary["time_final_s"] < weak.run.duration
    assert run.summary["regime"] is None


def test_what_varies_smoothly_over_cells_longer_than_a_neck_is_no_neck() -> None:
    """A thin string yields most at its supports: from cell to cell by far more than a neck of its thickness holds."""
    cells = 40
    length = np.full(2 * cells, 0.5 / cells)
    at = np.abs(np.arange(2 * cells) - cells + 0.5) / cells
    smooth = 1 + 0.1 * at**2
    assert neck_strain(smooth, length, 1e-5) < 0.1
    drawn = smooth.copy()
    drawn[0] += 0.1
    assert neck_strain(drawn, length, 1e-5) > 10
