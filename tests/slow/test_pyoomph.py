"""Surface tension thins a viscous thread: the filament beside axisymmetric flow with a free surface, by pyoomph.

``pip install pyoomph`` (GPL-3.0: of these tests alone; in a process of its own). A wave on a thread between two planes
of symmetry, a fifth of the mean radius high, drains its neck without inertia; units are the mean radius, viscosity and
surface tension. What is compared are the times at which the neck has a given radius. The filament knows uniform flow
over its section only: what is left is less for a wave twice as long.
"""

from __future__ import annotations

import subprocess
import sys
import time
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from tests.common.table import show

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_spec("pyoomph") is None, reason="pyoomph is not installed: pip install pyoomph"),
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: install gcc, or set CC"),
]

PROGRAM = Path(__file__).parents[1] / "common" / "programs" / "pyoomph_thread.py"
HEIGHT, RADII = 0.2, (0.7, 0.6, 0.5, 0.4, 0.3, 0.2)
END = 14.0
Array = npt.NDArray[np.float64]


def by_elements(half: float, step: float, across: int, along: int, folder: Path) -> tuple[Array, float]:
    """Times at which the neck has the radii, and seconds."""
    began = time.perf_counter()
    arguments = map(str, (half, HEIGHT, END, step, across, along, folder))
    done = subprocess.run(
        [sys.executable, PROGRAM, *arguments], capture_output=True, text=True, check=False, timeout=900, cwd=folder
    )
    found = np.array([line.split()[1:] for line in done.stdout.splitlines() if line.startswith("neck")], dtype=float)
    assert done.returncode == 0 and found[-1, 1] < RADII[-1], done.stderr[-2000:]
    return np.interp(-np.array(RADII), -found[:, 1], found[:, 0]), time.perf_counter() - began


@cache
def by_filament(half: float, cells: int) -> tuple[Array, float]:
    """The same of a filament."""
    at = np.linspace(-1, 1, 801)
    middle = 1 - HEIGHT
    scene = sc.Scene.from_dict(
        {
            "filament": {"span": 2 * half, "diameter": 2 * middle, "density": 1e-4}
            | {"profile": [float(one) for one in (1 - HEIGHT * np.cos(np.pi * at)) / middle]},
            "material": {"law": "newtonian", "shear_viscosity": 1.0},
            "load": {"gravity": 0.0},
            "surroundings": {"surface_tension": 1.0},
            "run": {"duration": 12.0, "frames": 481}
            | {
                "effects": [
                    *("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation"),
                    *("viscous-stress", "surface-tension"),
                ]
            },
            # Cells grow as they are drawn out: at the neck they begin small.
            "numerics": {"cells": cells, "grading": 0.05, "rtol": 1e-7, "estimate": False},
        }
    )
    began = time.perf_counter()
    run = sc.simulate(scene)
    assert run.outcome.is_success, run.summary["message"]
    place = run.data.sizes["node"] // 2
    radius = middle / np.sqrt(run.data["stretch"].values[:, place - 1 : place + 1].mean(axis=1))
    assert radius[-1] < RADII[-1]
    return np.interp(-np.array(RADII), -radius, run.data["time"].values), time.perf_counter() - began


def test_a_neck_thins_as_the_free_surface_says(tmp_path: Path) -> None:
    rows, misses, seconds = [], {}, []
    for wave, half in ((0.5, 2 * np.pi), (0.25, 4 * np.pi)):
        along = round(30 * half / (2 * np.pi))
        # Half the step on a mesh that is coarser: it tells what both are worth.
        (other, _), (fine, spent) = (
            by_elements(half, step, across, number, tmp_path)
            for step, across, number in ((0.05, 3, along), (0.025, 2, 2 * along // 3))
        )
        (few, _), (many, own) = (by_filament(half, cells) for cells in (80, 160))
        misses[wave] = many / fine - 1
        rows.append([f"{wave}", "pyoomph", *(f"{one:.3f}" for one in fine)])
        rows.append(["", "finer mesh, twice the step", *(f"{one:+.3%}" for one in other / fine - 1)])
        rows.append(["", "filament", *(f"{one:+.2%}" for one in misses[wave])])
        rows.append(["", "half its cells", *(f"{one:+.2%}" for one in few / fine - 1)])
        seconds.append(f"k R = {wave}: pyoomph {spent:.0f} s, filament {own:.1f} s")
        assert np.abs(other / fine - 1).max() < 2e-4
        assert np.abs(few / many - 1).max() < 2e-3
    header = ("k R", "", *(f"R/R0 = {one:g}" for one in RADII))
    show("Time at which a draining neck has a radius [mu R0/gamma]", header, rows)
    print("; ".join(seconds))
    assert np.abs(misses[0.5]).max() < 6e-3
    assert np.abs(misses[0.25]).max() < 4e-3
    # From the middle on, where the numbers are well above what either program is worth.
    assert np.all(np.abs(misses[0.25][2:]) < 0.75 * np.abs(misses[0.5][2:]))
