"""Sweeps: workers killed in the middle, thousands of filaments in constant memory, an interruption resumed from."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.batch.executor import Lost, Where
from tests.common.commands import until
from tests.common.in_process import sets
from tests.common.table import show

pytestmark = pytest.mark.slow

QUICK = {"run.effects": "paper", "numerics.cells": 12, "run.accuracy": 0.01, "run.frames": 41}
OPTIONS = ("continual-descent", *sets(*(f"{key}={value}" for key, value in QUICK.items())))
VARY = ("groups.G=0.05:1.5:15:log", "groups.V=5:100:10:log")
MEMBERS = 150
GROWTH = 5.0  # MB after the first thousand members: the allocator's, not the members'
WRITING = 25.0  # MB to write the store: its libraries, 15 for 1500 members and for 3000, 17 for 10 000


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
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1", silence_logs=50
    ) as cluster:
        address = cluster.scheduler_address
        with distributed.Client(cluster, set_as_default=False) as client:
            before = sorted(client.run(os.getpid).values())
        killer = Killer(before, MEMBERS // 3)
        done = sc.sweep(scene, VARY, tmp_path / "cluster", scheduler=address, fresh=True, progress=killer)
        with distributed.Client(cluster, set_as_default=False) as client:
            client.wait_for_workers(2, timeout=60)
            after = sorted(client.run(os.getpid).values())
    assert killer.killed in before and killer.killed not in after
    rows = [
        [study.place.split(" at ")[0], len(study), study.counts.outcomes["solved"], f"{study.wall_s:.1f}"]
        for study in (alone, done)
    ]
    title = f"one of two workers killed (SIGKILL) after {MEMBERS // 3} of {MEMBERS} members"
    show(title, ("where", "members", "answers", "wall [s]"), rows)
    assert stored(tmp_path / "embedded").identical(stored(tmp_path / "cluster"))


def deadly(number: int) -> int:
    """Twice the number; 17 ends the process."""
    if number == 17:
        os.kill(os.getpid(), signal.SIGKILL)
    time.sleep(0.02)
    return 2 * number


def test_a_member_that_kills_every_worker_loses_its_chunk_alone() -> None:
    with Where(local_cluster=2).pool() as pool:
        found = dict(pool.map_members(deadly, range(40), 8))
    lost = {number for number, result in found.items() if isinstance(result, Lost)}
    # Chunks of eight; one that was beside it in a worker that died may be blamed, too.
    assert set(range(16, 24)) <= lost
    assert all(found[number] == 2 * number for number in set(range(40)) - lost)


STREAMING = """
from softcat_sym.batch.sweep import peak_memory
import json, sys, time
import softcat_sym as sc
class Memory:
    peaks = {}
    def update(self, done, members, left):
        if done % 1000 == 0:
            self.peaks[done] = peak_memory()
changes = {"run.effects": "paper", "numerics.cells": 6, "run.accuracy": 0.01, "run.frames": 41}
vary, members, begun = ("groups.G=0.05:1.5:log", "groups.V=10:100:log"), int(sys.argv[2]), time.monotonic()
scene, memory = sc.load_scene("continual-descent", changes), Memory()
done = sc.sweep(scene, vary, sys.argv[1], mode="lhs", samples=members, seed=1, progress=memory)
memory.peaks[members] = peak_memory()
record = {"peaks": memory.peaks, "wall": time.monotonic() - begun, "outcomes": dict(done.counts.outcomes)}
print(json.dumps(record | {"place": done.place, "bytes": done.path.stat().st_size}))
"""


def test_thousands_of_filaments_in_constant_memory(tmp_path: Path) -> None:
    """In a process of its own, whose peak memory is that of the sweep."""
    count = 3000
    command = [sys.executable, "-c", STREAMING, str(tmp_path), str(count)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    record: dict[str, Any] = json.loads(done.stdout)
    peaks = {int(members): peak for members, peak in record["peaks"].items()}
    title = (
        f"{count} filaments (continual-descent, paper's physics, N = 6, 41 frames), {record['place']}: "
        f"{record['wall']:.0f} s, {count / record['wall']:.0f}/s; {record['outcomes']}; "
        f"store {record['bytes'] / 1e6:.1f} MB"
    )
    show(title, ("members done", "peak memory [MB]"), [[members, f"{peaks[members]:.1f}"] for members in sorted(peaks)])
    assert sorted(peaks) == list(range(1000, count + 1, 1000))
    assert peaks[count - 1000] - peaks[1000] < GROWTH
    assert peaks[count] - peaks[count - 1000] < WRITING
    data = stored(tmp_path)
    assert data.sizes["member"] == count
    assert int((data.outcome == "solved").sum()) == record["outcomes"]["solved"] > 0.9 * count


def test_ctrl_c_in_a_terminal_ends_a_local_cluster_quietly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """There it reaches the workers too."""
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    code = "import sys; sys.argv[0] = 'softcat'; from softcat_sym.cli import main; main()"
    asked = ["sweep", *OPTIONS, "--vary", VARY[0], "--vary", VARY[1], "--local-cluster", "2", "-q"]
    command = [sys.executable, "-c", code, *asked, "-o", str(tmp_path / "out")]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as process:
        until(lambda: len(list((tmp_path / "cache" / "results").glob("*"))) >= 2, process)
        os.killpg(process.pid, signal.SIGINT)
        out, err = process.communicate(timeout=60)
    assert (process.returncode, out) == (130, "")
    assert err.startswith("softcat: interrupted;") and err.count("\n") == 1
