"""The whole span from its half, in SI units, of the whole filament."""

from __future__ import annotations

import math

import numpy as np
import pytest

from softcat_sym import simulate
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.results.fields import ENERGIES, VARIABLES, mirrored
from softcat_sym.scene.scene import undeformed_area

from .runs import run, scene_of

ODD = ("x", "shear", "shear_force")
# Without surface tension no axial force is shown beside the tension.
CELLS = [v.name for v in VARIABLES if v.place == "cell" and v.name != "axial_force"]
HALF = np.array([[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]])


def test_nodes_are_mirrored_about_the_one_on_the_plane() -> None:
    np.testing.assert_array_equal(mirrored("y", HALF), [[2, 1, 0, 1, 2], [5, 4, 3, 4, 5]])
    np.testing.assert_array_equal(mirrored("x", HALF), [[-2, -1, 0, 1, 2], [-5, -4, 3, 4, 5]])


def test_cells_are_mirrored_about_the_plane_between_them() -> None:
    np.testing.assert_array_equal(mirrored("stretch", HALF), [[2, 1, 0, 0, 1, 2], [5, 4, 3, 3, 4, 5]])
    np.testing.assert_array_equal(mirrored("shear_force", HALF[:1]), [[-2, -1, 0, 0, 1, 2]])


def test_a_symmetric_run_is_symmetric() -> None:
    for name in ["x", "y", *CELLS]:
        values = run().data[name].values
        sign = -1 if name in ODD else 1
        np.testing.assert_array_equal(values[:, ::-1], sign * values)


def test_the_whole_span_agrees_with_the_mirrored_half() -> None:
    """A scene that is symmetric but for a pin that is a clamp in all but name runs on the whole span: same parities."""
    lopsided = run("bingham", "pinned").data
    # gravity still pulls down on the left half, and the transverse force changes sign
    assert np.all(np.diff(lopsided["x"].values, axis=1) > 0)
    last = lopsided["shear_force"].values[-1]
    assert last[0] * last[-1] < 0


def test_ends_do_not_move() -> None:
    data = run().data
    for end in (0, -1):
        np.testing.assert_allclose(data["x"][:, end], data["X_node"][end], atol=1e-15)
        np.testing.assert_array_equal(data["y"][:, end], 0.0)


def test_the_midpoint_is_the_node_at_zero() -> None:
    data = run().data
    (middle,) = np.flatnonzero(np.abs(data["X_node"].values) < 1e-12)
    np.testing.assert_array_equal(data["midpoint"], data["y"][:, middle])
    assert float(data["midpoint"][-1]) == float(data["y"][-1].min()) < 0


def test_the_first_frame_is_straight_and_at_rest() -> None:
    data = run().data.isel(time=0)
    np.testing.assert_allclose(data["x"], data["X_node"], atol=1e-15)
    for name in ("y", "curvature", "tension", "moment", "shear_force", "yielded_fraction", "plastic_rate", *ENERGIES):
        np.testing.assert_array_equal(data[name], 0.0, err_msg=name)
    np.testing.assert_array_equal(data["stretch"], 1.0)


def test_stretch_and_thickness_belong_together() -> None:
    data = simulate(scene_of(run={"effects": "paper"})).data
    lengths = np.hypot(np.diff(data["x"], axis=1), np.diff(data["y"], axis=1)) / np.diff(data["X_node"])
    np.testing.assert_allclose(data["stretch"], lengths, rtol=1e-12)
    np.testing.assert_allclose(data["thickness"], 0.006 / np.sqrt(lengths), rtol=1e-12)


def test_a_sheared_section_thins_with_the_stretch_along_its_normal() -> None:
    data = run().data
    normal = data["stretch"].values / np.hypot(1, data["shear"].values)
    np.testing.assert_allclose(data["thickness"], 0.006 / np.sqrt(normal), rtol=1e-12)


def test_tension_is_area_times_mean_stress() -> None:
    data = run().data
    area = (data["thickness"].values) ** 2
    np.testing.assert_allclose(data["tension"], area * data["stress_mean"], rtol=1e-12, atol=1e-12)
    second = area * data["thickness"].values / 6
    np.testing.assert_allclose(data["moment"], second * data["stress_bending"], rtol=1e-12, atol=1e-12)


def test_potential_energy_is_weight_times_height() -> None:
    data = run().data.isel(time=-1)
    half = 1900 * 0.006**2 * np.diff(data["X_node"].values) / 2
    weights = np.append(half, 0) + np.append(0, half)
    assert float(data["energy_potential"]) == pytest.approx(9.81 * float(np.sum(weights * data["y"].values)), rel=1e-12)


def test_kirchhoff_has_no_shear() -> None:
    np.testing.assert_array_equal(simulate(scene_of(run={"effects": "paper"})).data["shear"], 0.0)
    assert float(np.max(np.abs(run().data["shear"]))) > 1e-4


def test_areas() -> None:
    assert undeformed_area(scene_of()) == pytest.approx(0.006**2)
    assert undeformed_area(scene_of(filament={"width": "2 mm"})) == pytest.approx(0.006 * 0.002)
    assert undeformed_area(scene_of(filament={"section": "circle"})) == pytest.approx(math.pi * 0.006**2 / 4)


def test_a_wider_filament_of_the_same_material_only_carries_more() -> None:
    plain = [name for name in choose_effects(scene_of()).names if name != "necking-gradient"]
    wide = simulate(scene_of(filament={"width": "12 mm"}, run={"effects": plain})).data
    data = simulate(scene_of(run={"effects": plain})).data
    for v in VARIABLES:
        if v.name not in data:
            continue
        factor = 2.0 if v.per_area else 1.0
        np.testing.assert_allclose(wide[v.name], factor * data[v.name], rtol=1e-12, atol=1e-300, err_msg=v.name)


def test_names_are_unique_and_energies_are_joules() -> None:
    assert len({v.name for v in VARIABLES}) == len(VARIABLES)
    assert set(ENERGIES) == {
        "energy_kinetic",
        "energy_elastic",
        "energy_surface",
        "energy_potential",
        "energy_dissipated",
        "energy_gradient",
        "work_external",
    }
