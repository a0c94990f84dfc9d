"""Every notebook runs, as a script and as a notebook, and leaves the errata table as it is checked in."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.tooling

FOLDER = Path(__file__).parents[1] / "derivations"
NOTEBOOKS = sorted(FOLDER.glob("[0-9][0-9]_*.py"))
EXECUTE = """
import sys, warnings
warnings.simplefilter("ignore")
import jupytext, nbclient
notebook = jupytext.read(sys.argv[1])
assert sum(cell.cell_type == "markdown" for cell in notebook.cells) >= 2
nbclient.NotebookClient(notebook, timeout=170, kernel_name="python3").execute()
"""
SECONDS: dict[str, float] = {}
"""Of the processor: one notebook keeps one core busy, which a neighbour may be using."""


def run(*command: str) -> float:
    """Seconds of the processor that a command took."""
    environment, before = {**os.environ, "PYDEVD_DISABLE_FILE_VALIDATION": "1"}, os.times()
    done = subprocess.run(
        [sys.executable, *command],
        cwd=FOLDER,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
        timeout=180,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_proves_what_it_says(path: Path) -> None:
    before = {table: table.read_bytes() for table in (FOLDER / "ERRATA.md", *(FOLDER / "errata").glob("*.json"))}
    SECONDS[path.stem] = run(path.name)
    for table, content in before.items():
        assert table.read_bytes() == content, f"{table.name} is not what {path.stem} proves"


def test_there_are_ten_chapters_and_all_take_less_than_three_minutes() -> None:
    assert [path.name[:2] for path in NOTEBOOKS[:10]] == [f"{k:02}" for k in range(1, 11)]
    assert len(SECONDS) == len(NOTEBOOKS), "run the whole file"
    print("\n".join(f"{name:28} {seconds:5.1f} s" for name, seconds in SECONDS.items()))
    # Three minutes where importing SymPy, the measure of the machine, takes a quarter of a second.
    unit = min(run("-c", "import sympy") for _ in range(3)) / 0.25
    assert 0 < sum(SECONDS.values()) < 180 * max(1.0, unit)


@pytest.mark.parametrize("path", [NOTEBOOKS[0], NOTEBOOKS[-1]], ids=lambda path: path.stem)
def test_they_are_notebooks_too(path: Path) -> None:
    run("-c", EXECUTE, path.name)
