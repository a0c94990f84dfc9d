"""The wheel in an empty environment, on every Python from 3.11 on that the PATH has: install, doctor, a run."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.common.table import show
from tests.test_packaging import built

pytestmark = pytest.mark.slow

NEWEST = 20
"""Of the versions 3.x that are looked for."""


def pythons() -> dict[str, str]:
    """Executables by version, the one that runs the tests among them."""
    found: dict[str, str] = {}
    for program in (sys.executable, *(f"python3.{minor}" for minor in range(11, NEWEST))):
        if (path := shutil.which(program)) is None:
            continue
        asked = [path, "-c", "import platform; print(platform.python_version())"]
        done = subprocess.run(asked, capture_output=True, text=True, check=False)
        # A name on the path may lead to no Python: pyenv has one for each version that it knows of.
        if done.returncode == 0:
            found.setdefault(done.stdout.strip(), path)
    return found


def seconds(folder: Path, *command: str | Path) -> float:
    """Seconds of the wall that a command takes, far from the repository and with nothing compiled before."""
    names = ("PYTHON", "SOFTCAT", "VIRTUAL_ENV")
    environment = {key: value for key, value in os.environ.items() if not key.startswith(names)}
    environment |= {"SOFTCAT_CACHE": str(folder / "cache"), "HOME": str(folder)}
    began = time.monotonic()
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return time.monotonic() - began


def test_the_wheel_works_in_an_empty_environment_on_every_python(tmp_path: Path) -> None:
    wheel, rows = built("wheel", tmp_path), []
    for version, python in pythons().items():
        folder = tmp_path / version
        folder.mkdir()
        seconds(folder, python, "-m", "venv", "--clear", folder / "env")
        programs = folder / "env" / ("Scripts" if sys.platform == "win32" else "bin")
        install = seconds(folder, programs / "python", "-m", "pip", "install", "-q", "--no-cache-dir", wheel)
        doctor = seconds(folder, programs / "softcat", "doctor")
        run = seconds(folder, programs / "softcat", "run", "arrested-overdamped", "-q", "-o", "out")
        rows.append((version, *(f"{spent:.1f}" for spent in (install, doctor, run))))
        assert (folder / "out" / "summary.json").is_file()
    show("The wheel in an empty environment, seconds of the wall", ("Python", "install", "doctor", "run"), rows)
    assert rows
