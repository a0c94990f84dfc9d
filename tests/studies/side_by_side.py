"""Is anything slower than in another checkout? Warm runs, the command, an ensemble: seconds of the processor, in turns.

``python -m tests.studies.side_by_side CHECKOUT [SCENE ...]`` prints medians of new over old; the checkout is a folder,
such as ``git worktree add ../before COMMIT`` makes. Each side has a cache of its own, filled before the clock starts.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median

from tests.common.table import show

HERE, TURNS = Path(__file__).parents[2], 5
SCENES = ("continual-descent", "arrested-overdamped", "glass-rod", "maxwell-fast", "ink-bridge")
# Each prints a JSON table of seconds.
WARM = """
import json, sys, time, warnings
import softcat_sym as sc
warnings.simplefilter("ignore")
found = {}
for name in sys.argv[1:]:
    scene = sc.load_scene(name)
    sc.simulate(scene)
    spent = []
    for _ in range(7):
        begun = time.process_time()
        sc.simulate(scene)
        spent.append(time.process_time() - begun)
    found[f"sc.simulate {name}, warm"] = sorted(spent)[3]
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
sc.simulate_many(scene, {key: values[:160] for key, values in table.items()})
begun = time.process_time()
sc.simulate_many(scene, table)
print(json.dumps({"400 filaments": time.process_time() - begun}))
"""
SOFTCAT = "from softcat_sym.cli import main; main()"


def spent(checkout: Path, folder: Path, *command: str) -> tuple[float, str]:
    """Seconds of the processor of a Python process with all that it starts, and what it prints."""
    environment = {**os.environ, "PYTHONPATH": str(checkout), "SOFTCAT_CACHE": str(folder / "cache")}
    environment |= {"OMP_NUM_THREADS": "1", "MPLBACKEND": "agg", "PYTHONPYCACHEPREFIX": str(folder / "bytecode")}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(
        [sys.executable, *command], capture_output=True, text=True, check=True, env=environment, cwd=folder
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def measured(checkout: Path, folder: Path, scenes: list[str]) -> dict[str, float]:
    """Seconds by what is measured."""
    found: dict[str, float] = {}
    for program in ((WARM, *scenes), (ENSEMBLE,)):
        found |= json.loads(spent(checkout, folder, "-c", *program)[1])
    for name in ("--help", *(f"run {scene} -q" for scene in scenes)):
        found[f"softcat {name}"] = spent(checkout, folder, "-c", SOFTCAT, *name.split())[0]
    return found


def main(other: Path, scenes: list[str]) -> None:
    """Print the table."""
    with tempfile.TemporaryDirectory() as temporary:
        sides = {"old": (other.resolve(), Path(temporary) / "old"), "new": (HERE, Path(temporary) / "new")}
        for _, folder in sides.values():
            folder.mkdir()
        # In turns, so that a busy machine slows both; the first turn fills caches.
        turns = [{side: measured(*where, scenes) for side, where in sides.items()} for _ in range(TURNS + 1)][1:]
    rows = []
    for name in turns[0]["new"]:
        old, new = (median(turn[side][name] for turn in turns) for side in ("old", "new"))
        ratio = median(turn["new"][name] / turn["old"][name] for turn in turns)
        rows.append([name, f"{1e3 * old:.1f}", f"{1e3 * new:.1f}", f"{ratio - 1:+.1%}"])
    show(f"milliseconds of the processor, medians of {TURNS} turns", ("", "old", "new", "new over old, less 1"), rows)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), sys.argv[2:] or list(SCENES))
