"""Every member is what `simulate` makes of its row, in the order of the table, whatever becomes of it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.ensemble.ensemble import Ensemble, MembersBar
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.solvers import compiled
from softcat_sym.solvers.compiled import CModel

SHORT = {"run.effects": "paper", "numerics.cells": 6, "run.frames": 11}
SCENE = sc.load_scene("arrested-overdamped", SHORT)
NO_FLOW = dict.fromkeys(("material.viscosity", "material.yield_stress"))
TABLE = {"groups.G": [0.6, 0.3, 0.45, 0.5], "groups.V": [10.0, 30.0, 20.0, 25.0]}


def same_as_single_runs(ensemble: Ensemble, rtol: float = 0.0) -> None:
    for number, scene in enumerate(ensemble.scenes):
        single = sc.simulate(scene)
        row = ensemble.data.isel(member=number)
        reached = single.data.sizes["time"]
        np.testing.assert_allclose(row.midpoint.values[:reached], single.data.midpoint.values, rtol=rtol, atol=0)
        assert np.all(np.isnan(row.midpoint.values[reached:]))
        assert float(row.midpoint_final) == pytest.approx(single.summary["midpoint_final_m"], rel=rtol, abs=0)
        assert float(row.time_final) == single.summary["time_final_s"]
        assert str(row.outcome.values) == single.outcome.name == ensemble.outcomes[number].name
        assert str(row.message.values) == single.summary["message"]
        assert int(row.steps) == single.summary["steps"]
        assert str(row.effects.values).split(", ") == list(single.summary["effects"])
        # The largest energy of two frames is no larger than that of all.
        assert float(row.energy_residual) <= 1.1 * single.summary["energy_residual"] + 1e-15


def test_members_are_single_runs_to_the_last_bit_whatever_the_workers() -> None:
    one, two = (sc.simulate_many(SCENE, TABLE, workers=workers) for workers in (1, 2))
    assert one.data.drop_vars("wall_s").identical(two.data.drop_vars("wall_s").assign_attrs(one.data.attrs))
    assert len(two) == 4
    assert two.data["groups.G"].values.tolist() == TABLE["groups.G"]
    assert [float(one.material.viscosity or 0) for one in two.scenes] == pytest.approx(
        [value * 1900 * np.sqrt(9.81 * 0.2**3) for value in TABLE["groups.V"]]
    )
    same_as_single_runs(two)
    final = two.data.midpoint_final.values
    assert len(set(final.tolist())) == 4
    assert final.argmin() == 0  # the heaviest and least viscous hangs lowest
    assert two.trajectory(1).data.midpoint.values[-1] == final[1]
    with pytest.raises(IndexError):
        two.trajectory(4)


def test_other_grids_starts_laws_and_durations_in_one_table() -> None:
    scene = sc.load_scene("slack-taffy", {"numerics.cells": 6, "run.frames": 6, "run.duration": "0.2 s"})
    ensemble = sc.simulate_many(
        scene,
        [
            {"filament.span": scene.filament.span, "numerics.cells": 6, "run.duration": 0.1},
            {"filament.span": 0.98 * scene.filament.span, "numerics.cells": 6, "run.duration": 0.2},
            {"filament.span": scene.filament.span, "numerics.cells": 8, "run.duration": "50 ms"},
        ],
    )
    same_as_single_runs(ensemble)
    assert ensemble.data.time.attrs["units"] == "1"
    assert ensemble.data.duration.values.tolist() == [0.1, 0.2, 0.05]
    assert ensemble.data["run.duration"].values.tolist() == [0.1, 0.2, 0.05]
    laws: list[dict[str, object]] = [
        {"material.law": "bingham", "material.yield_stress": 4e3},
        {"material.law": "maxwell", "material.yield_stress": None},
    ]
    ensemble = sc.simulate_many(SCENE, laws)
    same_as_single_runs(ensemble)
    assert ensemble.data["material.law"].values.tolist() == ["bingham", "maxwell"]
    np.testing.assert_array_equal(ensemble.data["material.yield_stress"].values, [4e3, np.nan])
    assert ensemble.data.time.attrs["units"] == "s"


def test_a_shearing_whole_span_with_effects_for_each_row() -> None:
    scene = sc.load_scene("slime-slope", {"numerics.cells": 6, "run.frames": 6, "run.duration": "0.05 s"})
    same_as_single_runs(sc.simulate_many(scene, {"filament.density": [1000.0, 1200.0]}, effects="each"))


def test_without_a_compiler_members_run_one_by_one() -> None:
    scene = SCENE.replace({"numerics.backend": "interpreted", "run.duration": "0.2 s"})
    ensemble = sc.simulate_many(scene, {"groups.G": [0.5, 0.4]}, workers=2)
    assert (ensemble.data.attrs["workers"], ensemble.data.attrs["backend"]) == (
        "1",
        "interpreted: named in numerics.backend",
    )
    same_as_single_runs(ensemble)


def test_a_row_of_equilibria() -> None:
    resting = sc.load_scene(
        "no-yield", {"numerics.cells": 6, "run.frames": 4, "run.effects": ["bending", "gravity-ramp"]}
    )
    same_as_single_runs(sc.simulate_many(resting, {"load.ramp": [1.0, 0.5]}))


def test_failures_are_rows_and_the_others_go_on(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "_MAX_STEPS", 1)
    monkeypatch.setattr(compiled, "_STEPS_PER_FRAME", 20)
    scene = sc.load_scene("continual-descent", SHORT)
    table = {"groups.G": [0.4, 8.0, 0.4], "groups.V": [30.0, 0.3, 20.0], "run.duration": [0.05, 0.4, 0.06]}
    ensemble = sc.simulate_many(scene, table)
    names = ensemble.data.outcome.values.tolist()
    assert (names[0], names[2]) == ("solved", "solved")
    assert not ensemble.outcomes[1].is_success
    assert "stopped after t =" in str(ensemble.data.message.values[1])
    lost = np.isnan(ensemble.data.midpoint.values)
    assert lost[1].any() and not lost[1].all() and not lost[[0, 2]].any()
    assert np.isfinite(ensemble.data.midpoint_final.values).all()
    same_as_single_runs(ensemble)


def test_a_string_without_a_start_is_a_row_too() -> None:
    scene = sc.load_scene("no-yield", {"numerics.cells": 6, "run.frames": 4, "run.effects": ["extensibility"]})
    ensemble = sc.simulate_many(scene.replace({"load.ramp": "0 s"}), {"load.gravity": [9.81, 0.0]})
    assert len(ensemble) == 2
    same_as_single_runs(ensemble)


def test_a_rupture_is_a_row() -> None:
    scene = sc.load_scene("continual-descent", SHORT)
    table = {"groups.G": [0.4, 4.0], "groups.V": [30.0, 1.0], "run.duration": [0.1, 1.0]}
    ensemble = sc.simulate_many(scene, table)
    assert [one.name for one in ensemble.outcomes] == ["solved", "localised"]
    assert "carries" in str(ensemble.data.message.values[1])


def test_refusals_come_before_any_run(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object) -> None:
        pytest.fail("something ran")

    monkeypatch.setattr(CModel, "integrate", never)
    with pytest.raises(SceneError, match=r"row 1: groups.G"):
        sc.simulate_many(SCENE, {"groups.G": [0.5, -0.5]})
    with pytest.raises(SceneError, match=r"'once' or 'each'"):
        sc.simulate_many(SCENE, TABLE, effects="twice")  # type: ignore[arg-type]
    for workers in (0, -1, 1.5, True):
        with pytest.raises(SoftcatError, match="whole number of threads"):
            sc.simulate_many(SCENE, TABLE, workers=workers)  # type: ignore[arg-type]
    without_flow = SCENE.replace({"run.effects": ["bending", "extensibility"], "material.law": "elastic"} | NO_FLOW)
    with pytest.raises(SceneError, match=r"row 1: numerics.backend: 'compiled', but without inertia"):
        sc.simulate_many(without_flow, {"numerics.backend": ["auto", "compiled"]})


class Listener:
    """Notes what it is told, and does something of its own."""

    def __init__(self, do: Callable[[], None] = lambda: None) -> None:
        self.told: list[tuple[int, int, float]] = []
        self._do = do

    def update(self, done: int, members: int, left: float) -> None:
        self.told.append((done, members, left))
        self._do()


def test_the_listener_is_told_of_every_member() -> None:
    listener = Listener()
    sc.simulate_many(SCENE, TABLE, progress=listener)
    assert [done for done, _, _ in listener.told] == [1, 2, 3, 4]
    assert {members for _, members, _ in listener.told} == {4}
    assert listener.told[-1][2] == 0.0 < listener.told[0][2]


def test_the_bar_draws_at_once_on_a_terminal_only(monkeypatch: pytest.MonkeyPatch) -> None:
    from io import StringIO

    from rich.console import Console

    from softcat_sym import progress

    monkeypatch.setattr(progress, "_DELAY", 0.0)
    drawn, plain = StringIO(), StringIO()
    with MembersBar("arrested", console=Console(file=drawn, force_terminal=True, width=100)) as bar:
        sc.simulate_many(SCENE, TABLE, progress=bar)
    assert "arrested" in drawn.getvalue() and "4 of 4" in drawn.getvalue()
    with MembersBar(console=Console(file=plain)) as bar:
        bar.update(1, 2, 3.0)
    assert not plain.getvalue(), "plain lines come after two seconds"
