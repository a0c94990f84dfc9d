"""What a run costs: against the plain RK4 oracle in the same minute, and from a cold start to files on disk."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.scene.scene import groups_of
from tests.common.rk4_filament import run as oracle
from tests.common.table import show

REPEATS = 9

FULL, EMPTY, HELP = "softcat run, compiled before", "softcat run, empty cache", "softcat --help"
LIMITS = {FULL: 4.5, EMPTY: 10.0, HELP: 0.2}
"""Processor seconds, over those of importing the libraries."""


@pytest.mark.slow
def test_descent_against_the_rk4_oracle() -> None:
    published = {"run.effects": "paper", "numerics.cells": 40, "numerics.grading": 1.0}
    scene = sc.load_scene("continual-descent", published)
    groups = groups_of(scene)
    assert groups.G is not None
    assert groups.V is not None
    runs = [sc.simulate(scene) for _ in range(REPEATS)]
    ours = float(np.median([run.summary["wall_s"]["solve"] for run in runs]))
    rival = oracle(groups.delta, groups.G, groups.V, groups.eps_Y, "bingham", "material", 40, 460.0)
    midpoint = runs[0].summary["midpoint_final_m"] / scene.filament.span
    ratio = rival.wall_seconds / ours
    show(
        "continual-descent, N = 40, paper's effects, to t~ = 460",
        ("", "seconds", "steps", "us per right-hand side", "midpoint/L at 460"),
        [
            ["solve stage, median of 9", f"{ours:.4f}", runs[0].summary["steps"], "", f"{midpoint:.6f}"],
            [
                "RK4 in NumPy at its stability limit",
                f"{rival.wall_seconds:.2f}",
                rival.steps,
                f"{rival.rhs_microseconds:.0f}",
                f"{rival.midpoint[-1]:.6f}",
            ],
            ["ratio", f"{ratio:.0f}", "", "", f"{abs(midpoint / rival.midpoint[-1] - 1):.1e}"],
        ],
    )
    # The goal is 500 times a rival that needs at most 200 us a right-hand side. This one needs 40 us, so that the ratio
    # is 300 to 550 as the machine has it, and over 1500 per right-hand side of the goal; the bound below is what holds.
    per_goal = ratio * 200 / rival.rhs_microseconds
    print(f"ratio to the same oracle at 200 us a right-hand side: {per_goal:.0f}")
    assert rival.rhs_microseconds < 200
    assert per_goal > 500
    assert abs(midpoint / rival.midpoint[-1] - 1) < 1e-3
    assert ours < 0.05
    assert ratio > 250


LIBRARIES = "casadi, h5netcdf, matplotlib.figure, numpy, pydantic, rich, sympy, typer, xarray"
"""What a run cannot do without: importing it is the measure of the machine, and of what else it does meanwhile."""


@dataclass(frozen=True)
class Spent:
    """What a process took, those that it started included."""

    wall: float
    processor: float


def _spent(command: list[str], cache: Path) -> Spent:
    environment = {**os.environ, "SOFTCAT_CACHE": str(cache), "OMP_NUM_THREADS": "1"}
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(command, check=True, capture_output=True, env=environment)
    wall, after = time.perf_counter() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    return Spent(wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


@pytest.mark.tooling
def test_cold_start(tmp_path: Path) -> None:
    """The promise is 6 s from a cold start to files on disk, on a machine that does nothing else.

    Beside other work seconds tell of that work, and processor seconds less so: they are judged in units of those that
    importing the libraries takes, in the same minute. A limit is 1.5 to 2 times what was measured on one machine, as
    machines differ in that, and a start that takes twice as long fails; seconds are only printed. With an empty cache a
    run first writes two C texts, and compiles three.
    """
    softcat, cache, output = str(Path(sys.executable).with_name("softcat")), tmp_path / "cache", tmp_path / "run"
    run = [softcat, "run", "arrested-overdamped", "-o", str(output)]
    imports = [sys.executable, "-c", f"import {LIBRARIES}"]
    spent: dict[str, list[Spent]] = {"": [], EMPTY: [_spent(run, cache)], FULL: [], HELP: []}
    for _ in range(3):
        spent[""].append(_spent(imports, cache))
        spent[FULL].append(_spent(run, cache))
        spent[HELP].append(_spent([softcat, "--help"], cache))
    least = {
        what: Spent(min(one.wall for one in taken), min(one.processor for one in taken))
        for what, taken in spent.items()
    }
    unit = least.pop("").processor
    times = {what: taken.processor / unit for what, taken in least.items()}
    show(
        f"cold start to files on disk; importing the libraries takes {unit:.2f} s of the processor",
        ("", "seconds", "of the processor", "imports", "limit"),
        [
            [what, f"{taken.wall:.2f}", f"{taken.processor:.2f}", f"{times[what]:.2f}", LIMITS[what]]
            for what, taken in least.items()
        ],
    )
    assert (output / "trajectory.nc").exists()
    assert {what for what, limit in LIMITS.items() if times[what] > limit} == set()
