"""Rows become the scenes that `Scene.replace` gives; every fault is told with its rows, before anything runs."""

from __future__ import annotations

import pytest

import softcat_sym as sc
from softcat_sym.ensemble.table import Choosing, Row, members_of, rows_of
from softcat_sym.errors import SceneError

SCENE = sc.load_scene("arrested-overdamped", {"run.effects": "paper"})


def the_fault(rows: list[Row], choosing: Choosing = "once", scene: sc.Scene = SCENE) -> str:
    with pytest.raises(SceneError) as caught:
        members_of(scene, rows, choosing)
    return str(caught.value)


def test_each_row_is_the_scene_with_its_values_replaced() -> None:
    rows = rows_of(
        {"material.yield_stress": ["5 kPa", 6e3], "filament.span": ["25 cm", 0.3], "ends.right": ["pinned"] * 2}
    )
    found = [member.scene for member in members_of(SCENE, rows, "once")]
    asked = [
        {"material.yield_stress": f"{k} kPa", "filament.span": f"{s} m", "ends.right": "pinned"}
        for k, s in ((5, 0.25), (6, 0.3))
    ]
    assert found == [SCENE.replace(one) for one in asked]


def test_groups_are_measured_with_the_span_of_their_row() -> None:
    member = members_of(SCENE, [{"filament.span": 0.4, "groups.G": 0.5}], "once")[0]
    assert sc.load_scene("arrested-overdamped", {"groups.G": 0.5, "filament.span": "0.4 m"}).material.yield_stress == (
        member.scene.material.yield_stress
    )


def test_faults_name_row_and_key_and_what_rows_share_is_told_once() -> None:
    said = the_fault([{"material.yield_stress": value} for value in (5e3, -1.0, "5 kg", 4e3, float("inf"))])
    assert "3 faults" in said
    assert "row 1: material.yield_stress: '-1.0 Pa' is negative" in said
    assert "row 2: material.yield_stress: 'kg' is" in said
    assert "row 4: material.yield_stress: 'inf Pa' is not finite" in said
    said = the_fault([{"material.yeild_stress": 1.0 * k} for k in range(9)])
    assert "1 fault" in said
    assert "rows 0, 1, 2, 3 and 5 more: material.yeild_stress: unknown key" in said
    said = the_fault([{"groups.G": 0.4}, {"groups.G": -0.4}])
    assert "row 1: groups.G: -0.4 is no positive number" in said
    said = the_fault([{"filament": 3}])
    assert "row 0" in said


def test_a_long_list_of_faults_ends() -> None:
    said = the_fault([{"material.yield_stress": -1.0 - k} for k in range(100)])
    assert said.count("row ") == 20
    assert "and 80 more faults" in said


def test_effects_that_a_row_cannot_have_are_refused_at_once() -> None:
    named = SCENE.replace({"run.effects": ["inertia", "bending", "extensibility", "yielding", "viscous-flow"]})
    assert "row 1: run.effects: 'yielding' cannot be had" in the_fault(
        [
            {"material.law": "bingham", "material.yield_stress": 5e3},
            {"material.law": "maxwell", "material.yield_stress": None},
        ],
        scene=named,
    )
    for choosing in ("once", "each"):
        said = the_fault([{"run.effects": "paper"}, {"run.effects": ["inertial"]}], choosing)
        assert "row 1: run.effects: unknown effect 'inertial'" in said


def test_once_chooses_for_the_base_and_anew_only_where_equations_differ() -> None:
    auto = sc.load_scene("no-yield")
    rows: list[Row] = [{"filament.thickness": thickness} for thickness in (6e-3, 5e-5)]
    once, each = ([one.effects.names for one in members_of(auto, rows, how)] for how in ("once", "each"))
    assert once[0] == once[1] == each[0]
    assert "shear" in each[0] and "shear" not in each[1]
    # A ramp that vanishes, a curvature that appears: other equations.
    rows = [{"load.ramp": ramp, "filament.curvature": bent} for ramp, bent in ((1.0, 0.0), (0.0, 0.0), (0.0, 1.0))]
    members = members_of(SCENE, rows, "once")
    assert ["gravity-ramp" in one.effects.names for one in members] == [True, False, False]
    assert [one.effects.bare.curved for one in members] == [False, False, True]
    assert len({one.pattern for one in members}) == 3
