"""What strangers met: every point of their reports, with what happens now, as one table.

`pytest -m slow tests/slow/test_strangers.py` prints the table after the last test.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import pytest

from tests.common.table import rows_of

pytestmark = pytest.mark.slow

Says = Callable[..., None]


@pytest.fixture(scope="module")
def says(request: pytest.FixtureRequest) -> Iterator[Says]:
    """Take a row of the table: the point, what was met, what happens now."""
    rows = list[tuple[str, str, str]]()

    def say(point: str, met: str, now: object) -> None:
        rows.append((point, met, str(now)))

    yield say
    lines = rows_of(("point", "what strangers met", "what happens now"), sorted(rows))
    terminal = request.config.pluginmanager.getplugin("terminalreporter")
    for line in ("", *lines) if terminal is not None else ():
        terminal.write_line(line)


# --- A: checks on random draws


STATISTICAL = ("inference", "priors", "closed_forms")
"""Files of tests on draws that take seconds; `.ci/matrix seeds` runs all of them, with twenty seeds."""


def outcome_of(*options: str, heard: bool = True, **variables: str) -> str:
    """The last line of pytest's; an interrupt may go unheard, as in the background of a script."""
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *options]
    deaf = None if heard else partial(signal.signal, signal.SIGINT, signal.SIG_IGN)
    environment, root = {**os.environ, **variables}, Path(__file__).parents[2]
    done = subprocess.run(
        command, cwd=root, env=environment, capture_output=True, text=True, check=False, preexec_fn=deaf
    )
    assert done.returncode == 0, done.stdout
    return done.stdout.strip().splitlines()[-1]


def test_statistical_tests_pass_with_other_draws(says: Says) -> None:
    files = [f"tests/test_{name}.py" for name in STATISTICAL]
    met = "test_the_band_...: 0.8476 for 1 +- 0.15 on another processor, a chance of one in fifty"
    found = outcome_of("-m", "statistical and not slow", *files, SOFTCAT_TEST_SEED="101")
    says("A1", met, f"from the covariance, not drawn; with other draws {found}")


def test_tests_hear_interrupts_in_the_background_of_a_script(says: Says) -> None:
    found = outcome_of("tests/test_least_squares.py", "-k", "raises", heard=False)
    says("A1", "started by a script in the background, tests of Ctrl-C fail", found)


def test_the_matrix_has_a_row_for_each_machine(says: Says) -> None:
    text = (Path(__file__).parents[2] / ".ci" / "matrix").read_text(encoding="utf-8")
    rows = re.findall(r'^    "([\w.]+)": Row\(', text, re.MULTILINE)
    assert {*rows} >= {
        "gcc",
        "clang",
        "zig",
        "none",
        "native",
        "O0",
        "oldest",
        "newest",
        "python3.11",
        "python",
        "seeds",
    }
    says("A2", "one kind of machine", f".ci/matrix: {', '.join(rows)}")


# --- B1: the regime does not depend on the frames


# --- B2: a creep is not a swing


# --- B3: errors are relative to the largest displacement


# --- B4: natural frequencies of what hangs slack


# --- B5: polymer threads


# --- B6: the time of breaking


# --- B7: what a fit calls identified


# --- B8: what explain says an effect is worth


# --- B9: the error of the slender theory


# --- C1: the price of a run is said before it starts


# --- C2: a run that falls for ever ends


# --- C3: time limits and interrupts


# --- C4: helices and histories are bounded when a scene is read


# --- C5: time limits of fits


# --- D1: clearing the cache leaves the user's files alone


# --- D2: nobody else's code or results are loaded


# --- D3: a full disk is no crash
