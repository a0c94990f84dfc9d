"""Ensembles: tables become members, every member is what `simulate` makes of its row, and what fails is a row."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.batch.ensemble import Ensemble
from softcat_sym.batch.members import Choosing, Row, constants_of, members_of, rows_of
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.scene.scene import groups_of
from softcat_sym.solvers import compiled
from softcat_sym.solvers.compiled import CModel

SHORT = {"run.effects": "paper", "numerics.cells": 6, "run.frames": 11, "numerics.estimate": False}
SCENE = sc.load_scene("arrested-overdamped", SHORT)
TABLE = {"groups.G": [0.6, 0.3, 0.45, 0.5], "groups.V": [10.0, 30.0, 20.0, 25.0]}


class Listener:
    """Notes its updates, and does something of its own."""

    def __init__(self, do: Callable[[], object] = lambda: None) -> None:
        self.updates: list[tuple[int, int, float]] = []
        self._do = do

    def update(self, done: int, members: int, left: float) -> None:
        self.updates.append((done, members, left))
        self._do()


def fault_of(rows: list[Row], choosing: Choosing = "once", scene: sc.Scene = SCENE) -> str:
    with pytest.raises(SceneError) as caught:
        members_of(scene, rows, choosing)
    return str(caught.value)


def same_as_single_runs(ensemble: Ensemble) -> None:
    for number, scene in enumerate(ensemble.scenes):
        single = sc.simulate(scene)
        row = ensemble.data.isel(member=number)
        reached = single.data.sizes["time"]
        np.testing.assert_array_equal(row.midpoint.values[:reached], single.data.midpoint.values)
        assert np.all(np.isnan(row.midpoint.values[reached:]))
        assert float(row.midpoint_final) == single.summary["midpoint_final_m"]
        assert float(row.time_final) == single.summary["time_final_s"]
        assert str(row.outcome.values) == single.outcome.name == ensemble.outcomes[number].name
        assert str(row.message.values) == single.summary["message"]
        assert int(row.steps) == single.summary["steps"]
        assert str(row.effects.values).split(", ") == list(single.summary["effects"])
        # The largest energy of two frames is no larger than that of all.
        assert float(row.energy_residual) <= 1.1 * single.summary["energy_residual"] + 1e-15


def test_what_is_no_table_is_refused() -> None:
    for table, message in (
        ({"filament.span": [1, 2], "load.gravity": [1]}, "columns that make no table .*same length"),
        ({}, "without rows"),
        ([], "without rows"),
        ({"filament.span": []}, "without rows"),
        ({"filament.span": "20 cm"}, "columns that make no table"),
        ({"filament.span": 0.2}, "columns that make no table"),
        ({"filament.span": np.array(0.2)}, "columns that make no table"),
        ("arrested", "'arrested' is no table"),
        (3, "3 is no table"),
        ([{"filament.span": 0.2}, 3], "row 1: 3 is not a mapping"),
        ([{"filament.span": 0.2}, {"filament.spam": 0.2}], "row 1: its keys differ from those of row 0"),
        ({"run.frames": [3, 4]}, "run.frames: given in the table, but members share"),
    ):
        with pytest.raises(SceneError, match=message):
            rows_of(table)


def test_groups_give_the_scene_that_a_file_with_them_gives() -> None:
    rows: tuple[Row, ...] = (
        {"groups.G": 0.55},
        {"groups.V": 13.0},
        {"groups.G": 0.35, "groups.V": 31.0},
        {"groups.delta": 0.04},
    )
    for name in ("arrested-overdamped", "continual-descent"):
        scene = sc.load_scene(name)
        for row in rows:
            assert scene.replace(constants_of(scene, row)) == sc.load_scene(name, row), (name, row)
    scene = sc.load_scene("arrested-overdamped")
    found = groups_of(
        scene.replace(constants_of(scene, {"groups.E_star": 900, "groups.eps_Y": 4e-3, "groups.tau": 0.02}))
    )
    assert (found.E_star, found.eps_Y, found.tau_star) == pytest.approx((900.0, 0.004, 0.02), rel=1e-14)
    # Alone, a ratio to Young's modulus leaves that as it is; what comes out as it is is not set again.
    assert list(constants_of(scene, {"groups.eps_Y": 0.004})) == ["material.yield_stress"]
    both = constants_of(scene, {"groups.G": 0.5, "groups.eps_Y": 0.004})
    assert list(both) == ["material.yield_stress", "material.youngs_modulus"]
    assert groups_of(scene.replace(constants_of(scene, {"groups.B": 0.25}))).V == pytest.approx(2.0, rel=1e-14)
    assert constants_of(scene, {"groups.G": 0.4, "groups.V": 26}) == {}
    # Groups are measured with the span of their row.
    member = members_of(SCENE, [{"filament.span": 0.4, "groups.G": 0.5}], "once")[0]
    asked = sc.load_scene("arrested-overdamped", {"groups.G": 0.5, "filament.span": "0.4 m"})
    assert asked.material.yield_stress == member.scene.material.yield_stress


def test_faults_name_row_and_key_and_those_that_rows_share_are_listed_once() -> None:
    message = fault_of([{"material.yield_stress": value} for value in (5e3, -1.0, "5 kg", 4e3, float("inf"))])
    assert "3 faults" in message
    assert "row 1: material.yield_stress: '-1.0 Pa' is negative" in message
    assert "row 2: material.yield_stress: 'kg' is" in message
    assert "row 4: material.yield_stress: 'inf Pa' is not finite" in message
    message = fault_of([{"material.yeild_stress": 1.0 * k} for k in range(9)])
    assert "1 fault" in message and "rows 0, 1, 2, 3 and 5 more: material.yeild_stress: unknown key" in message
    assert "row 1: groups.G: -0.4 is no positive number" in fault_of([{"groups.G": 0.4}, {"groups.G": -0.4}])
    assert "row 0" in fault_of([{"filament": 3}])
    message = fault_of([{"material.yield_stress": -1.0 - k} for k in range(100)])
    assert message.count("row ") == 20 and "and 80 more faults" in message
    named = SCENE.replace({"run.effects": ["inertia", "bending", "extensibility", "yielding", "viscous-flow"]})
    laws: list[Row] = [
        {"material.law": "bingham", "material.yield_stress": 5e3},
        {"material.law": "maxwell", "material.yield_stress": None},
    ]
    assert "row 1: run.effects: 'yielding' cannot be had" in fault_of(laws, scene=named)
    for choosing in ("once", "each"):
        message = fault_of([{"run.effects": "paper"}, {"run.effects": ["inertial"]}], choosing)
        assert "row 1: run.effects: unknown effect 'inertial'" in message


def test_members_are_single_runs_to_the_last_bit_whatever_the_workers() -> None:
    listener = Listener()
    single = sc.simulate_many(SCENE, TABLE, workers=1)
    double = sc.simulate_many(SCENE, TABLE, workers=2, progress=listener)
    assert single.data.drop_vars("wall_s").identical(double.data.drop_vars("wall_s").assign_attrs(single.data.attrs))
    assert len(double) == 4 and double.data["groups.G"].values.tolist() == TABLE["groups.G"]
    assert [float(scene.material.viscosity or 0) for scene in double.scenes] == pytest.approx(
        [value * 1900 * np.sqrt(9.81 * 0.2**3) for value in TABLE["groups.V"]]
    )
    same_as_single_runs(double)
    final = double.data.midpoint_final.values
    assert len(set(final.tolist())) == 4
    assert final.argmin() == 0  # the heaviest and least viscous hangs lowest
    assert double.trajectory(1).data.midpoint.values[-1] == final[1]
    with pytest.raises(IndexError):
        double.trajectory(4)
    assert [update[:2] for update in listener.updates] == [(done, 4) for done in (1, 2, 3, 4)]
    assert listener.updates[-1][2] == 0.0 < listener.updates[0][2]


def test_failures_are_rows_and_the_others_continue(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = sc.load_scene("continual-descent", SHORT)
    rupture = {"groups.G": [0.4, 4.0], "groups.V": [30.0, 1.0], "run.duration": [0.1, 1.0]}
    ensemble = sc.simulate_many(scene, rupture)
    assert [outcome.name for outcome in ensemble.outcomes] == ["solved", "descends"]
    monkeypatch.setattr(compiled, "_MAX_STEPS", 1)
    monkeypatch.setattr(compiled, "_STEPS_PER_FRAME", 20)
    table = {"groups.G": [0.4, 8.0, 0.4], "groups.V": [30.0, 0.3, 20.0], "run.duration": [0.05, 0.4, 0.06]}
    ensemble = sc.simulate_many(scene, table)
    assert [outcome.is_success for outcome in ensemble.outcomes] == [True, False, True]
    lost = np.isnan(ensemble.data.midpoint.values)
    assert lost[1].any() and not lost[1].all() and not lost[[0, 2]].any()
    assert np.isfinite(ensemble.data.midpoint_final.values).all()
    same_as_single_runs(ensemble)


def test_refusals_come_before_any_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(CModel, "integrate", lambda *_: pytest.fail("something ran"))
    with pytest.raises(SceneError, match=r"row 1: groups.G"):
        sc.simulate_many(SCENE, {"groups.G": [0.5, -0.5]})
    with pytest.raises(SceneError, match=r"'once' or 'each'"):
        sc.simulate_many(SCENE, TABLE, effects="twice")  # type: ignore[arg-type]
    for workers in (0, -1, 1.5, True):
        with pytest.raises(SoftcatError, match="whole number of threads"):
            sc.simulate_many(SCENE, TABLE, workers=workers)  # type: ignore[arg-type]
    no_flow = dict.fromkeys(("material.viscosity", "material.yield_stress"))
    elastic = SCENE.replace({"run.effects": ["bending", "extensibility"], "material.law": "elastic"} | no_flow)
    with pytest.raises(SceneError, match=r"row 1: numerics.backend: 'compiled', but without inertia"):
        sc.simulate_many(elastic, {"numerics.backend": ["auto", "compiled"]})
