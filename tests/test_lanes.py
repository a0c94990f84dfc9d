"""Filaments in lanes: the answers of the scalar code, whatever the neighbours are, and whatever becomes of them."""

from __future__ import annotations

import ctypes
from collections.abc import Sequence

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.batch import executor, lane_pool
from softcat_sym.batch.members import members_of, rows_of
from softcat_sym.batch.worker import StructureCache
from softcat_sym.solvers.compiled import (
    SOLVED,
    Answer,
    CModel,
    RunInput,
    Status,
)
from softcat_sym.solvers.lanes import LanesModel, can_be_compiled, lanes_of
from softcat_sym.solvers.solution import Silence

pytestmark = pytest.mark.skipif(not can_be_compiled(), reason="no gcc or clang")

RTOL = 1e-5
QUICK = {"numerics.cells": 8, "run.frames": 5, "run.duration": "0.2 s"}
PAPER = {"run.effects": "paper", "numerics.rtol": RTOL, **QUICK}
SHEARED = ["inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "gravity-ramp"]
SHEARED += ["shear", "fibres", "viscous-flow", "yielding"]
FIBRES = {"run.effects": SHEARED, "numerics.fibres": 4, "numerics.rtol": RTOL, **QUICK}


class Caught(Silence):
    """Listens to integrations, and keeps what they are given."""

    def __init__(self) -> None:
        self.found: list[tuple[CModel, RunInput]] = []

    def integrate(self, model: CModel, run: RunInput, room: Answer) -> None:
        self.found.append((model, run))
        model.integrate(run, room.status, None, room)


def runs_of(settings: dict[str, object], stresses: Sequence[float]) -> tuple[CModel, list[RunInput]]:
    """The runs of filaments that differ in yield stress (relative to the scene's) and in how long they last."""
    scene, caught, structures = sc.load_scene("arrested-overdamped", settings), Caught(), StructureCache()
    table = {"material.yield_stress": [scene.material.yield_stress * one for one in stresses]}
    table["run.duration"] = [scene.run.duration * (0.5 + 0.25 * (k % 3)) for k in range(len(stresses))]
    for member in members_of(scene, rows_of(table), "once"):
        structures.prepare(member).solve(caught)
    return caught.found[0][0], [run for _, run in caught.found]


def in_lanes(
    lanes: LanesModel, model: CModel, runs: Sequence[RunInput], stop: ctypes.c_int | None = None
) -> list[Answer]:
    rooms = [model.room(run, Status()) for run in runs]
    lanes.integrate(runs, rooms, stop)
    return rooms


def alone(model: CModel, run: RunInput) -> Answer:
    return model.integrate(run, Status())


@pytest.mark.parametrize(
    "settings", [pytest.param(PAPER, marks=pytest.mark.slow, id="paper"), pytest.param(FIBRES, id="fibres")]
)
def test_lanes_give_the_answers_of_the_scalar_code(settings: dict[str, object]) -> None:
    """Five filaments that yield more and less, each as long as it lasts: places to a tenth of the time tolerance."""
    model, runs = runs_of(settings, [0.4, 0.6, 0.8, 1.0, 1.3])
    for run, found in zip(runs, in_lanes(lanes_of(model), model, runs), strict=True):
        exact = alone(model, run)
        assert found.status.code == exact.status.code == SOLVED
        assert found.status.reached == exact.status.reached == run.times[-1]
        assert abs(found.status.steps - exact.status.steps) <= 0.1 * exact.status.steps
        size, off = (np.abs(one).max(axis=(0, 1)) for one in (exact.states, found.states - exact.states))
        names = [slot.name for slot in model.model.slots]
        places, others = ([k for k, name in enumerate(names) if (name in "xy") is place] for place in (True, False))
        assert np.all(off[places] <= 0.1 * RTOL * size[places])
        # What waves along the filament leave of its axial velocity is below the tolerance of that.
        assert np.all(off[others] <= RTOL * np.where(np.array(names)[others] == "u", 0.1, size[others]))
        np.testing.assert_allclose(found.work, exact.work, atol=RTOL * np.abs(exact.work).max())
        seen, known = (one.extremes for one in (found, exact))
        assert seen is not None and known is not None and known.height.min() < 0
        seen, known = (one.beyond(1e-3 * np.abs(known.height).max()) for one in (seen, known))
        np.testing.assert_allclose(seen.height, known.height, atol=RTOL * np.abs(known.height).max())


def test_a_lane_depends_on_no_neighbour() -> None:
    """More filaments than lanes, of different durations: the bits of each are those that it has by itself."""
    model, runs = runs_of(PAPER, np.linspace(0.4, 1.4, 11))
    lanes = lanes_of(model)
    for run, found in zip(runs, in_lanes(lanes, model, runs), strict=True):
        (single,) = in_lanes(lanes, model, [run])
        np.testing.assert_array_equal(found.states, single.states)
        np.testing.assert_array_equal(found.work, single.work)
        np.testing.assert_array_equal(found.rows, single.rows)


def test_an_ensemble_in_lanes_does_not_depend_on_its_threads(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bits do not; the scalar code gives the same midpoints to a tenth of the time tolerance."""
    calls: list[int] = []
    integrate = LanesModel.integrate

    def counted(lanes: LanesModel, runs: Sequence[RunInput], *rest: object) -> None:
        calls.append(len(runs))
        integrate(lanes, runs, *rest)  # type: ignore[arg-type]

    monkeypatch.setattr(LanesModel, "integrate", counted)
    monkeypatch.setattr(executor, "WORTHWHILE", lane_pool.AT_ONCE)
    scene, members = sc.load_scene("arrested-overdamped", PAPER), lane_pool.AT_ONCE + 3
    table = {"groups.G": np.linspace(0.3, 0.6, members)}
    one, two = (sc.simulate_many(scene, table, workers=workers) for workers in (1, 2))
    assert sum(calls) == 2 * members
    np.testing.assert_array_equal(one.data.midpoint.values, two.data.midpoint.values)
    few = sc.simulate_many(scene, {"groups.G": table["groups.G"][:3]}).data.midpoint.values
    assert sum(calls) == 2 * members, "few are not worth it"
    np.testing.assert_allclose(one.data.midpoint.values[:3], few, atol=0.1 * RTOL * np.abs(few).max())
