"""Seconds of the processor that a call of ``softcat`` takes, with all that it starts; ``pytest -s`` shows the table.

SOFTCAT_OTHER names the folder of another checkout, which is then called in turn with this one.
"""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from tests.common.table import show

pytestmark = pytest.mark.slow

HERE, OTHER = Path(__file__).parents[2], os.environ.get("SOFTCAT_OTHER", "")
REPEATS = 5

GOALS = {"--help": 0.1, "run --no-pictures": 0.4, "run": 1.0, "first run ever": 4.0}
"""Seconds on a machine that imports NumPy and Matplotlib in half a second, and does nothing else."""
UNIT, MARGIN = 0.5, 1.5
"""Seconds of that import there; and how much longer than its goal a call may take, since machines differ in the ratio
of loading files to calculating, and in what else they do meanwhile."""
IMPORT = "import numpy, matplotlib.figure, matplotlib.backends.backend_agg"
SOFTCAT = "from softcat_sym.cli import main; main()"


def seconds(checkout: Path, folder: Path, code: str, *arguments: str, cache: str = "kept") -> float:
    """Of a process of its own and its children."""
    environment = {**os.environ, "PYTHONPATH": str(checkout), "SOFTCAT_CACHE": str(folder / cache)}
    # As an installed package has them, whatever the shell of who tests forbids.
    environment |= {"PYTHONPYCACHEPREFIX": str(folder / "bytecode"), "OMP_NUM_THREADS": "1"}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [sys.executable, "-c", code, *arguments]
    subprocess.run(command, env=environment, cwd=folder, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def test_a_command_takes_no_longer_than_its_goal(tmp_path: Path) -> None:
    run = ("run", "continual-descent", "-q", "-o", "out")
    calls = {"--help": ("--help",), "run --no-pictures": (*run, "--no-pictures"), "run": run}
    checkouts = {place: tmp_path / str(k) for k, place in enumerate([HERE, *([Path(OTHER)] if OTHER else [])])}
    taken: dict[tuple[Path, str], list[float]] = {}
    for place, folder in checkouts.items():
        folder.mkdir()
        seconds(place, folder, IMPORT)
        seconds(place, folder, SOFTCAT, *run)
    # In turn, so that a busy neighbour slows all.
    for k in range(REPEATS):
        for place, folder in checkouts.items():
            spent = {what: seconds(place, folder, SOFTCAT, *call) for what, call in calls.items()}
            spent["first run ever"] = seconds(place, folder, SOFTCAT, *run, cache=f"new {k}")
            spent[IMPORT] = seconds(place, folder, IMPORT)
            for what, one in spent.items():
                taken.setdefault((place, what), []).append(one)
    least = {key: min(all_of_it) for key, all_of_it in taken.items()}
    unit = least[HERE, IMPORT]
    rows = [
        [
            f"softcat {what}", f"{least[HERE, what]:.2f}", f"{least[HERE, what] / unit * UNIT:.2f}", f"{goal:g}",
            *(f"{least[Path(OTHER), what]:.2f}" for _ in range(bool(OTHER))),
        ]
        for what, goal in GOALS.items()
    ]  # fmt: skip
    header = ["", "seconds", f"where importing takes {UNIT:g} s", "goal there", *(["the other's"] if OTHER else [])]
    show(f"processor seconds, least of {REPEATS}; importing NumPy and Matplotlib takes {unit:.2f} s", header, rows)
    late = [what for what, goal in GOALS.items() if least[HERE, what] / unit * UNIT > MARGIN * goal]
    assert not late
