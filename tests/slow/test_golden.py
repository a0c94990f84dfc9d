"""The golden record: what the program answers today is what it answered when the record was taken.

``pytest -s -m slow tests/slow/test_golden.py`` prints a line a case.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest


@pytest.mark.slow
def test_the_program_answers_as_recorded() -> None:
    command = [sys.executable, "-m", "tests.golden.golden", "check"]
    done = subprocess.run(command, cwd=Path(__file__).parents[2], capture_output=True, text=True, check=False)
    print(f"\n{done.stdout}")
    assert done.returncode == 0, f"{done.stdout}\n{done.stderr}"
