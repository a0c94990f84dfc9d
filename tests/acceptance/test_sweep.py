"""Sweeps: a worker killed in the middle, ten thousand filaments in constant memory, an interruption gone on from."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.ensemble.executor import blocks_of, workplace
from softcat_sym.studies.phase import SETTINGS, phase_diagram
from tests.faults.commands import ended, softcat, until

from . import streaming_sweep
from .deadly_work import DeadlyWork
from .table import show

pytestmark = pytest.mark.slow

QUICK = {"run.effects": "paper", "numerics.cells": 12, "run.accuracy": 0.01, "run.frames": 41}
VARY = ("groups.G=0.05:1.5:15:log", "groups.V=5:100:10:log")
MEMBERS = 150
GROWTH = 5.0  # MB after the first thousand members: the allocator's, not the members'
WRITING = 25.0  # MB to write the store: its libraries, 15 for 1500 members and for 3000, 17 for 10 000


def stored(directory: Path) -> xr.Dataset:
    """What is in the store, but for the time that it took."""
    return xr.load_dataset(directory / "sweep.nc", engine="h5netcdf").drop_vars("wall_s")


def largest_difference(one: xr.Dataset, other: xr.Dataset) -> float:
    """Of any number of two sweeps; infinite where one has a number and the other has none."""
    largest = 0.0
    for name in one.data_vars:
        a, b = one[name].values, other[name].values
        if a.dtype.kind == "f":
            if not np.array_equal(np.isnan(a), np.isnan(b)):
                return np.inf
            largest = max(largest, float(np.nanmax(np.abs(a - b), initial=0.0)))
        elif a.tolist() != b.tolist():
            return np.inf
    return largest


class Killer:
    """Kills one of the workers once so many members are done."""

    def __init__(self, workers: list[int], after: int) -> None:
        self.workers, self._after, self.killed = workers, after, 0

    def update(self, done: int, members: int, left: float) -> None:
        """Do it, if it is time to."""
        del left
        if not self.killed and done >= self._after:
            assert done < members
            self.killed = self.workers[0]
            os.kill(self.killed, signal.SIGKILL)


def test_a_killed_worker_loses_nothing(tmp_path: Path) -> None:
    """Two workers, one killed: the same numbers as without a cluster, every member there."""
    import distributed

    scene = sc.load_scene("continual-descent", QUICK)
    begun = time.monotonic()
    sc.sweep(scene, VARY, tmp_path / "embedded", workers=2)
    alone = time.monotonic() - begun
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1", silence_logs=50
    ) as cluster:
        with distributed.Client(cluster, set_as_default=False) as client:
            before = sorted(client.run(os.getpid).values())
        killer = Killer(before, MEMBERS // 3)
        begun = time.monotonic()
        done = sc.sweep(scene, VARY, tmp_path / "cluster", scheduler=cluster.scheduler_address, progress=killer)
        wall = time.monotonic() - begun
        with distributed.Client(cluster, set_as_default=False) as client:
            client.wait_for_workers(2, timeout=60)
            after = sorted(client.run(os.getpid).values())
    assert killer.killed in before and killer.killed not in after
    one, other = stored(tmp_path / "embedded"), stored(tmp_path / "cluster")
    off = largest_difference(one, other)
    rows = [
        ["embedded, 2 threads", one.sizes["member"], int((one.outcome == "solved").sum()), f"{alone:.1f}", ""],
        [
            done.place.split(" at ")[0],
            other.sizes["member"],
            int((other.outcome == "solved").sum()),
            f"{wall:.1f}",
            off,
        ],
    ]
    header = ("where", "members", "answers", "wall [s]", "largest difference of any number")
    show(f"one of two workers killed (SIGKILL) after {MEMBERS // 3} of {MEMBERS} members", header, rows)
    assert off == 0.0 and one.identical(other)


def test_a_member_that_kills_every_worker_loses_its_block_alone() -> None:
    items = list(range(40))
    with workplace(local_cluster=2) as place:
        found = dict(place.run(DeadlyWork(17), blocks_of(items, 8), lambda _: None))
    results = [result for number in range(5) for result in found[number]]
    lost = {item: one for item, one in enumerate(results) if "lost" in one}
    assert all(one.startswith(f"{item} lost: the workers that ran this member") for item, one in lost.items())
    # Blocks of eight; one that was beside it in a worker that died may be blamed, too.
    assert set(range(16, 24)) <= set(lost)
    assert all(results[item] == str(2 * item) for item in items if item not in lost)


def test_ten_thousand_filaments_in_constant_memory(tmp_path: Path) -> None:
    """In a process of its own, whose peak memory is that of the sweep."""
    count = 10_000
    command = [sys.executable, "-m", streaming_sweep.__name__, str(tmp_path), str(count)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    told: dict[str, Any] = json.loads(done.stdout)
    peaks = {int(members): peak for members, peak in told["peaks"].items()}
    rows = [[members, f"{peak:.1f}"] for members, peak in sorted(peaks.items())]
    title = (
        f"{count} filaments (continual-descent, paper's physics, N = 10, 41 frames), {told['place']}: "
        f"{told['wall']:.0f} s, {count / told['wall']:.0f}/s; {told['outcomes']}; store {told['bytes'] / 1e6:.1f} MB"
    )
    show(title, ("members done", "peak memory [MB]"), rows)
    assert sorted(peaks) == list(range(1000, count + 1, 1000))
    assert peaks[count - 1000] - peaks[1000] < GROWTH
    assert peaks[count] - peaks[count - 1000] < WRITING
    data = stored(tmp_path)
    assert data.sizes["member"] == count
    assert int((data.outcome == "solved").sum()) == told["outcomes"]["solved"] > 0.9 * count


@pytest.mark.parametrize(("number", "status"), [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
def test_an_interrupted_sweep_gone_on_from_gives_the_same_file(
    number: signal.Signals, status: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = ("continual-descent", *(word for key, value in QUICK.items() for word in ("--set", f"{key}={value}")))
    asked = ("sweep", *scene, "--vary", VARY[0], "--vary", VARY[1], "--shapes")
    whole, broken = tmp_path / "whole", tmp_path / "broken"
    results = tmp_path / "cache of broken" / "results"
    for output in (whole, broken):
        monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / f"cache of {output.name}"))
        with softcat(*asked, "-o", str(output)) as process:
            if output is whole:
                out, err = process.communicate(timeout=300)
                assert process.returncode == 0, out + err
                continue
            until(lambda: len(list(results.glob("*"))) >= 3, process)
            left, out, err = ended(process, number)
    assert (left, out) == (status, "")
    assert err == "softcat: interrupted; the same command goes on from what was finished\n"
    kept = len(list(results.iterdir()))
    assert 3 <= kept < MEMBERS // 10
    with softcat(*asked, "-o", str(broken)) as process:
        out, err = process.communicate(timeout=300)
    assert process.returncode == 0, out + err
    assert f"{10 * kept} of them from before" in out
    assert stored(broken).identical(stored(whole))


def test_a_phase_diagram_is_the_same_on_a_cluster() -> None:
    scene = sc.load_scene("arrested-overdamped", [*SETTINGS, "numerics.cells=10", "run.frames=41"])
    here = phase_diagram(scene, ["G-V"], 8, workers=2)
    there = phase_diagram(scene, ["G-V"], 8, local_cluster=2)
    assert here.sheets[0].points == there.sheets[0].points
    assert (here.workers, there.workers) == (2, 2)


def test_ctrl_c_in_a_terminal_ends_a_local_cluster_quietly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """There it reaches the workers too."""
    output = tmp_path / "out"
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    scene = [word for key, value in QUICK.items() for word in ("--set", f"{key}={value}")]
    code = "import sys; sys.argv[0] = 'softcat'; from softcat_sym.cli import main; main()"
    asked = ["sweep", "continual-descent", *scene, "--vary", VARY[0], "--vary", VARY[1], "--local-cluster", "2"]
    with subprocess.Popen(
        [sys.executable, "-c", code, *asked, "-o", str(output)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    ) as process:
        until(lambda: len(list((tmp_path / "cache" / "results").glob("*"))) >= 2, process)
        os.killpg(process.pid, signal.SIGINT)
        out, err = process.communicate(timeout=60)
    assert (process.returncode, out) == (130, "")
    assert err.startswith("softcat: interrupted;") and err.count("\n") == 1
