"""What ``softcat run`` costs for every bundled scene, cold and warm, beside another checkout of the program.

SOFTCAT_OTHER names the folder of the other checkout, SOFTCAT_SCENES some of the scenes (with commas; all if not given).
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import pytest

import softcat_sym as sc
from tests.acceptance.table import show

pytestmark = pytest.mark.slow

HERE = Path(__file__).parents[2]
OTHER = os.environ.get("SOFTCAT_OTHER", "")
SCENES = os.environ.get("SOFTCAT_SCENES", "").split(",") if os.environ.get("SOFTCAT_SCENES") else sc.bundled_names()
# A process of its own, whose only child is the run with all compilers that it starts.
RUN = """
import resource, subprocess, sys
softcat = "from softcat_sym.cli import main; main()"
done = subprocess.run([sys.executable, "-c", softcat, *sys.argv[1:]], capture_output=True, text=True)
spent = resource.getrusage(resource.RUSAGE_CHILDREN)
print(spent.ru_utime + spent.ru_stime, done.returncode)
"""
TOGETHER, EACH = 1.1, 1.4
"""New over old, of all scenes and of each: no slower, but for the scatter of a busy machine."""


@dataclass(frozen=True)
class Spent:
    """Processor seconds of a run, compilers included, and how it ended."""

    seconds: float
    outcome: str


def spent(checkout: Path, scene: str, cache: Path) -> Spent:
    """Run a bundled scene of a checkout in a process of its own."""
    environment = {**os.environ, "PYTHONPATH": str(checkout), "SOFTCAT_CACHE": str(cache), "OMP_NUM_THREADS": "1"}
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-c", RUN, "run", scene, "-q", "-o", folder]
        said = subprocess.run(command, capture_output=True, text=True, check=True, cwd=folder, env=environment).stdout
        seconds, status = said.split()
        assert status in ("0", "1"), f"{scene} of {checkout}: exit status {status}"
        outcome = json.loads((Path(folder) / "summary.json").read_text())["outcome"]
    return Spent(float(seconds), outcome)


@pytest.mark.skipif(not OTHER, reason="SOFTCAT_OTHER names no other checkout")
def test_no_bundled_scene_is_slower_than_in_the_other_checkout(tmp_path: Path) -> None:
    rows, slower, sums = [], [], [0.0, 0.0, 0.0, 0.0]
    for scene in SCENES:
        if not any(Path(OTHER, "softcat_sym").rglob(f"{scene}.toml")):
            print(scene, "is new", flush=True)
            continue
        caches = [tmp_path / scene / which for which in ("old", "new")]
        # In turn, so that a busy neighbour slows both.
        cold, warm = (
            [spent(Path(place), scene, cache) for place, cache in zip((OTHER, HERE), caches, strict=True)]
            for _ in range(2)
        )
        runs = (*cold, *warm)
        sums = [total + run.seconds for total, run in zip(sums, runs, strict=True)]
        outcomes = dict.fromkeys(run.outcome for run in runs)
        if any(new.seconds > EACH * old.seconds for old, new in (cold, warm)):
            slower.append(scene)
        rows.append([scene, *(f"{run.seconds:.1f}" for run in runs), " -> ".join(outcomes)])
        print(*rows[-1], flush=True)
    rows.append(["all", *(f"{total:.1f}" for total in sums), ""])
    show(
        "processor seconds of softcat run, compilers included",
        ("scene", "cold, old", "cold, new", "warm, old", "warm, new", "outcome"),
        rows,
    )
    assert sums[1] < TOGETHER * sums[0]
    assert sums[3] < TOGETHER * sums[2]
    assert slower == []
