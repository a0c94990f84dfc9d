"""Sweeps in other processes: workers killed in the middle."""

from __future__ import annotations

import os
import signal
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import xarray as xr

import softcat_sym as sc
from tests.common.table import show

pytestmark = pytest.mark.slow

QUICK = {"run.effects": "paper", "numerics.cells": 12, "run.accuracy": 0.01, "run.frames": 41}
VARY = ("groups.G=0.05:1.5:15:log", "groups.V=5:100:10:log")
MEMBERS = 150


def stored(directory: Path) -> xr.Dataset:
    """What is in the store, but for the time that it took."""
    return xr.load_dataset(directory / "sweep.nc", engine="h5netcdf").drop_vars("wall_s")


class Killer:
    """Kills one of the workers once so many members are done."""

    def __init__(self, workers: list[int], after: int) -> None:
        self._workers, self._after, self.killed = workers, after, 0

    def update(self, done: int, members: int, left: float) -> None:
        if not self.killed and done >= self._after:
            assert done < members
            self.killed = self._workers[0]
            os.kill(self.killed, signal.SIGKILL)


def test_a_killed_worker_loses_nothing(tmp_path: Path) -> None:
    """Two workers, one killed: the same numbers to the last bit as of threads without lanes, every member there."""
    import distributed

    scene = sc.load_scene("continual-descent", QUICK)
    with ThreadPoolExecutor(2) as threads:
        alone = sc.sweep(scene, VARY, tmp_path / "embedded", executor=threads)
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1", silence_logs=50
        ) as cluster,
        distributed.Client(cluster, set_as_default=False) as client,
    ):
        before = sorted(client.run(os.getpid).values())
        killer, there = Killer(before, MEMBERS // 3), client.get_executor(pure=False, retries=0)
        done = sc.sweep(scene, VARY, tmp_path / "cluster", executor=there, fresh=True, progress=killer)
        client.wait_for_workers(2, timeout=60)
        after = sorted(client.run(os.getpid).values())
    assert killer.killed in before and killer.killed not in after
    rows = [[study.place, len(study), study.outcomes["solved"], f"{study.wall_s:.1f}"] for study in (alone, done)]
    title = f"one of two workers killed (SIGKILL) after {MEMBERS // 3} of {MEMBERS} members"
    show(title, ("where", "members", "answers", "wall [s]"), rows)
    assert stored(tmp_path / "embedded").identical(stored(tmp_path / "cluster"))
