"""What strangers met: every point of their reports, with what happens now, as one table.

`pytest -m slow tests/slow/test_strangers.py` prints the table after the last test.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

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
