"""The golden record: what the program answers today is what it answered when the record was taken."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.golden.golden import SECTIONS


@pytest.mark.slow
@pytest.mark.parametrize("section", SECTIONS)
def test_the_program_answers_as_recorded(section: str) -> None:
    command = [sys.executable, "-m", "tests.golden.golden", "check", "--sections", section]
    done = subprocess.run(command, cwd=Path(__file__).parents[2], capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{done.stdout}\n{done.stderr}"
