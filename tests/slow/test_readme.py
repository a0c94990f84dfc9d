"""README's code blocks, run in order in one empty folder, as a newcomer types them.

``pytest -s -m slow tests/slow/test_readme.py`` prints a table: exit status, seconds of the processor and of the wall.
"""

from __future__ import annotations

import os
import re
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
LIMIT = 900.0
"""Seconds of the wall in which a line must end."""


@dataclass(frozen=True)
class Step:
    """What is typed, the file that is written before, and the exit status that is promised."""

    command: str
    status: int = 0
    written: str = ""


def blocks() -> list[tuple[str, str]]:
    """Language and text of every fenced block."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    return re.findall(r"(?ms)^```(\w+)\n(.*?)^```", text)


def steps() -> Iterator[Step]:
    """Every line but the two that install; a scene and a program are run from files."""
    for language, text in blocks():
        if language == "sh":
            for line in text.replace("\\\n", " ").splitlines():
                if line.strip() and not line.startswith("#") and "pip install" not in line:
                    promised = re.search(r"#.*exit status (\d+)", line)
                    yield Step(line, int(promised[1]) if promised else 0)
        elif language == "toml":
            yield Step("softcat run my-ink.toml", written=text)
        elif language == "python":
            yield Step(f"{sys.executable} - <<'END'\n{text}END")
        else:
            yield Step(f"echo 'a block of {language} is not run'; false")


def run(step: Step, folder: Path, environment: dict[str, str]) -> tuple[int | str, float, float, str]:
    """Exit status or ``timeout``, seconds of the processor and of the wall, and the last words."""
    if step.written:
        (folder / "my-ink.toml").write_text(step.written, encoding="utf-8")
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    shell = subprocess.Popen(
        ["bash", "-c", step.command],
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    )
    status: int | str
    try:
        said, _ = shell.communicate(timeout=LIMIT)
        status = shell.returncode
    except subprocess.TimeoutExpired:
        os.killpg(shell.pid, signal.SIGKILL)
        said, _ = shell.communicate()
        status = "timeout"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return status, spent, time.monotonic() - began, said[-1500:]


def test_every_code_block_of_the_readme_runs_as_typed(tmp_path: Path) -> None:
    environment = {**os.environ, "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"}
    environment |= {"MPLBACKEND": "agg", "COLUMNS": "100"}
    wrong = []
    print(f"\n{'status':>8} {'processor':>10} {'wall':>7}")
    for step in steps():
        status, spent, wall, said = run(step, tmp_path, environment)
        first = step.command.splitlines()[0]
        print(f"{status!s:>8} {spent:8.1f} s {wall:5.0f} s  {first}", flush=True)
        if status != step.status:
            wrong.append(f"{first}\n  {status} in place of {step.status}; {said}")
    assert not wrong, "\n".join(wrong)


def test_the_two_installing_commands_are_there_and_not_run() -> None:
    lines = [line for language, text in blocks() if language == "sh" for line in text.splitlines()]
    installing = [line for line in lines if "pip install" in line]
    assert ["softcat run" in line or "pytest" in line for line in installing] == [True, True]
    assert len(list(steps())) > 10


def test_the_scene_of_the_readme_is_the_sample() -> None:
    (scene,) = (text for language, text in blocks() if language == "toml")
    assert (ROOT / "softcat_sym" / "samples" / "my-ink.toml").read_text(encoding="utf-8") == scene
