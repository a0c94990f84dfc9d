"""What users wait for, before and after in the same run: warm runs, commands, ensembles; and where the rest goes.

The version before is taken from this repository's history; SOFTCAT_OTHER names another checkout instead.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import time
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from tests.common.table import show

pytestmark = pytest.mark.slow

HERE, BEFORE = Path(__file__).parents[2], "73a21b0"
SCENES = ("continual-descent", "arrested-overdamped", "glass-rod", "maxwell-fast")
BESIDE_C, WITH_ESTIMATE = 5e-3, 4.0
"""Goals: seconds of a warm run beside its C solve; how many times both it may take with its error estimate."""
TIMES_LESS = 8.0
"""What is reached of the first: this much less beside the C solve than the version before spent."""

WARM = """
import json, sys, time, warnings
import numpy as np
import softcat_sym as sc
from softcat_sym.solvers.compiled import CModel
warnings.simplefilter("ignore")
in_c, integrate = [], CModel.integrate
def timed(*given, **named):
    begun = time.thread_time()
    answer = integrate(*given, **named)
    in_c.append(time.thread_time() - begun)
    return answer
CModel.integrate = timed
found = {}
for name in sys.argv[1].split(","):
    for estimate, repeats in ((False, 20), (True, 7)):
        scene = sc.load_scene(name, {"numerics.estimate": estimate})
        sc.simulate(scene)
        rows = []
        for _ in range(repeats):
            in_c.clear()
            wall, begun = time.perf_counter(), time.process_time()
            run = sc.simulate(scene)
            rows.append([time.perf_counter() - wall, time.process_time() - begun, sum(in_c)])
        found[f"{name}/{estimate}"] = [*np.median(rows, axis=0).tolist(), run.data.midpoint.values.tolist()]
print(json.dumps(found))
"""
ENSEMBLE = """
import json, time
import numpy as np
import softcat_sym as sc
random = np.random.default_rng(0)
table = {"groups.G": random.uniform(0.3, 0.6, 400), "groups.V": random.uniform(15, 40, 400)}
quick = {"run.effects": "paper", "numerics.cells": 40, "numerics.rtol": 1e-2}
scene = sc.load_scene("arrested-overdamped", quick)
# The lanes are compiled beforehand.
sc.simulate_many(scene, {key: values[:160] for key, values in table.items()})
wall, begun = time.perf_counter(), time.process_time()
sc.simulate_many(scene, table)
print(json.dumps([time.perf_counter() - wall, time.process_time() - begun]))
"""
SOFTCAT = "from softcat_sym.cli import main; main()"
COMMANDS = {
    "--help": ("--help",),
    "run --no-pictures": ("run", "continual-descent", "-q", "--no-pictures"),
    "run": ("run", "continual-descent", "-q"),
    "card --no-span": ("card", "ink-bridge", "-q", "--fresh", "--no-span"),
    "effects": ("effects", "no-yield", "-q", "--fresh"),
    "sweep, 16 members": (
        *("sweep", "ink-bridge", "-q", "--fresh", "--vary", "filament.span=3 mm:9 mm:4"),
        *("--vary", "material.yield_stress=100 Pa:900 Pa:4:log"),
    ),
    "phase, 10 cells": ("phase", "-q", "--fresh", "--resolution", "10"),
    "experiment": ("experiment", "arrested-overdamped", "-q", "--fresh", "--free", "viscosity", "--noise", "1 %"),
}
FIRST = "run, nothing cached"
GOALS = {"--help": 0.1, "run --no-pictures": 0.4, "run": 1.0, FIRST: 4.0}
REACHED = {"--help": 0.1, "run --no-pictures": 0.75, "run": 1.9, FIRST: 4.4}
"""Seconds of the processor; of the goals the first is met."""
IMPORT = "import numpy, matplotlib.figure, matplotlib.backends.backend_agg"
UNIT, MARGIN = 0.5, 1.5
"""Seconds of that import where the goals are meant; how much longer than what was reached a call may take: machines
differ in the ratio of loading files to calculating, and in what else they do meanwhile."""


@dataclass(frozen=True)
class Checkout:
    """One version of the package, with a cache of its own."""

    folder: Path
    cache: Path
    bytecode: Path

    def spent(self, *command: str) -> tuple[float, float, str]:
        """Wall and processor seconds of a Python process with all that it starts, and what it prints."""
        environment = {**os.environ, "PYTHONPATH": str(self.folder), "SOFTCAT_CACHE": str(self.cache)}
        environment |= {"OMP_NUM_THREADS": "1", "MPLBACKEND": "agg"}
        # As an installed package has them, whatever the shell of who tests forbids.
        environment |= {"PYTHONPYCACHEPREFIX": str(self.bytecode)}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        self.cache.mkdir(parents=True, exist_ok=True)
        before, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        done = subprocess.run(
            [sys.executable, *command], capture_output=True, text=True, check=False, env=environment, cwd=self.cache
        )
        after, wall = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter() - wall
        assert done.returncode in (0, 1), done.stderr
        return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


@pytest.fixture(scope="module")
def checkouts(tmp_path_factory: pytest.TempPathFactory) -> tuple[Checkout, Checkout]:
    """The version before, and this one."""
    folder = tmp_path_factory.mktemp("times")
    other = Path(os.environ.get("SOFTCAT_OTHER") or folder / "before")
    if not other.is_dir():
        other.mkdir()
        packed = subprocess.run(["git", "archive", BEFORE, "softcat_sym"], cwd=HERE, capture_output=True, check=True)
        subprocess.run(["tar", "-x", "-C", str(other)], input=packed.stdout, check=True)
    old, new = ((place, folder / name, folder / f"bytecode-{name}") for place, name in ((other, "old"), (HERE, "new")))
    return Checkout(*old), Checkout(*new)


def test_warm_runs(checkouts: tuple[Checkout, Checkout]) -> None:
    """Goal: the C solve and 5 ms, which is missed; with the estimate at most four times that."""
    old, new = (json.loads(one.spent("-c", WARM, ",".join(SCENES))[2]) for one in checkouts)
    rows, missed = [], []
    for key, (wall, processor, in_c, midpoint) in new.items():
        name, estimate = key.split("/")
        before, rest, alone = old[key], processor - in_c, new[f"{name}/False"]
        off = np.max(np.abs(np.subtract(midpoint, before[3]))) / np.max(np.abs(midpoint))
        goal = alone[2] + BESIDE_C if estimate == "False" else WITH_ESTIMATE * (alone[2] + BESIDE_C)
        numbers = [f"{1e3 * one:.1f}" for one in (*before[:3], wall, processor, in_c, rest, goal)]
        rows.append([name, {"False": "no", "True": "yes"}[estimate], *numbers, f"{off:.0e}"])
        missed += [key] if rest * TIMES_LESS > before[1] - before[2] else []
        assert off < 1e-2
    head = ("scene", "estimate", "before: wall", "processor", "in C", "now: wall", "processor", "in C", "rest", "goal")
    show("a further simulate of the same scene [ms], medians", (*head, "midpoint differs by"), rows)
    assert not missed


def test_commands(checkouts: tuple[Checkout, Checkout], tmp_path: Path) -> None:
    """Goals: --help 0.1 s of the processor, a run 0.4 s and with pictures 1 s, the first of all 4 s; the first is met.

    On a machine that imports NumPy and Matplotlib in half a second, and does nothing else.
    """
    rows, late = [], []
    unit = min(checkouts[1].spent("-c", IMPORT)[1] for _ in range(3)) / UNIT
    for label, command in {FIRST: COMMANDS["run"], **COMMANDS}.items():
        taken: tuple[list[tuple[float, float]], ...] = ([], [])
        for k in range(4 if label in GOALS else 1):
            # In turn, so that a busy neighbour slows both; the first call of a short one fills its caches.
            for one, rows_of in zip(checkouts, taken, strict=True):
                place = replace(one, cache=tmp_path / f"{one.cache.name} {k}") if label == FIRST else one
                rows_of.append(place.spent("-c", SOFTCAT, *command)[:2])
        (old_wall, old), (wall, now) = (min(rows_of, key=lambda pair: pair[1]) for rows_of in taken)
        goal = GOALS.get(label)
        rows.append(
            [label, *(f"{one:.2f}" for one in (old_wall, old, wall, now, now / unit)), goal or "", f"{old / now:.1f}"]
        )
        print(*rows[-1], flush=True)
        late += [label] if goal and now / unit > MARGIN * REACHED[label] else []
    head = ("softcat", "before: wall", "processor", "now: wall", "processor", f"where importing takes {UNIT} s", "goal")
    show("seconds of a command, compilers included", (*head, "times less"), rows)
    assert not late


def test_filaments_a_second(checkouts: tuple[Checkout, Checkout]) -> None:
    """Goal: 250 filaments a second on two cores."""
    found = [json.loads(one.spent("-c", ENSEMBLE)[2]) for one in checkouts]
    rows = [
        [name, f"{400 / wall:.0f}", f"{400 / used:.0f}"]
        for name, (wall, used) in zip(("before", "now"), found, strict=True)
    ]
    show("400 filaments, the paper's physics", ("", "a second of wall", "a second of the processor"), rows)
    assert found[1][1] < found[0][1]


def test_where_the_seconds_of_a_run_go(checkouts: tuple[Checkout, Checkout]) -> None:
    """Self times of imports by package, and the stages of the run."""
    new = checkouts[1]
    new.spent("-c", SOFTCAT, *COMMANDS["run"], "-o", "profiled")
    environment = {**os.environ, "PYTHONPATH": str(new.folder), "SOFTCAT_CACHE": str(new.cache), "MPLBACKEND": "agg"}
    done = subprocess.run(
        [sys.executable, "-X", "importtime", "-c", SOFTCAT, *COMMANDS["run"], "-o", "profiled"],
        **{"capture_output": True, "text": True, "check": True, "env": environment, "cwd": new.cache},
    )
    packages: dict[str, float] = {}
    for line in done.stderr.splitlines():
        parts = line.removeprefix("import time:").split("|")
        if len(parts) == 3 and parts[0].strip().isdigit():
            package = parts[2].strip().split(".")[0]
            packages[package] = packages.get(package, 0.0) + int(parts[0]) * 1e-6
    summary = json.loads((new.cache / "profiled" / "summary.json").read_text())
    stages = {f"stage {name}": seconds for name, seconds in summary["wall_s"].items()}
    largest = sorted(packages.items(), key=lambda one: -one[1])[:10]
    rest = sum(packages.values()) - sum(seconds for _, seconds in largest)
    rows = [[f"import {name}", f"{seconds:.3f}"] for name, seconds in largest]
    rows += [["import all else", f"{rest:.3f}"], *([name, f"{seconds:.3f}"] for name, seconds in stages.items())]
    show("where the seconds of softcat run continual-descent go (imports under -X importtime)", ("", "seconds"), rows)
    assert not {"sympy", "casadi", "xarray", "scipy"} & set(packages)
