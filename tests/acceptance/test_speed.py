"""What a run costs: against the plain RK4 oracle in the same minute, and from a cold start to files on disk."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.scene import groups_of
from tests.oracle.rk4_filament import run as oracle

from .table import show

REPEATS = 9


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


def _seconds(command: list[str]) -> float:
    began = time.perf_counter()
    subprocess.run(command, check=True, capture_output=True)
    return time.perf_counter() - began


def test_cold_start(tmp_path: Path) -> None:
    softcat = Path(sys.executable).with_name("softcat")
    rows = [
        [
            "softcat run arrested-overdamped",
            min(_seconds([str(softcat), "run", "arrested-overdamped", "-o", str(tmp_path)]) for _ in range(2)),
            6.0,
        ],
        ["softcat --help", min(_seconds([str(softcat), "--help"]) for _ in range(3)), 0.5],
    ]
    show(
        "cold start to files on disk", ("command", "seconds", "limit"), [[c, f"{s:.2f}", limit] for c, s, limit in rows]
    )
    assert os.listdir(tmp_path)  # noqa: PTH208
    for command, seconds, limit in rows:
        assert seconds < limit, command
