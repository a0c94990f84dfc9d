"""The ``softcat`` command; a file for each of its commands.

Exit status: 0 a sound answer, 1 an answer not to be trusted, 2 bad input or a place that cannot be written, 130
interrupted by Ctrl-C, 143 ended by SIGTERM, 129 by a terminal that was closed.
"""

from __future__ import annotations

import contextlib
import gc
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NoReturn

# Importing a command registers it, in the order in which the help lists them.
from softcat_sym.cli import new as new  # isort: skip
from softcat_sym.cli import samples as samples  # isort: skip
from softcat_sym.cli import run as run  # isort: skip
from softcat_sym.cli import show as show  # isort: skip
from softcat_sym.cli import keys as keys  # isort: skip
from softcat_sym.cli import explain as explain  # isort: skip
from softcat_sym.cli import card as card  # isort: skip
from softcat_sym.cli import draw as draw  # isort: skip
from softcat_sym.cli import sweep as sweep  # isort: skip
from softcat_sym.cli import scenes as scenes  # isort: skip
from softcat_sym.cli import fit as fit  # isort: skip
from softcat_sym.cli import flow_curve as flow_curve  # isort: skip
from softcat_sym.cli import experiment as experiment  # isort: skip
from softcat_sym.cli import compare as compare  # isort: skip
from softcat_sym.cli import accuracy as accuracy  # isort: skip
from softcat_sym.cli import effects as effects  # isort: skip
from softcat_sym.cli import phase as phase  # isort: skip
from softcat_sym.cli import figures as figures  # isort: skip
from softcat_sym.cli import generate as generate  # isort: skip
from softcat_sym.cli import cache as cache  # isort: skip
from softcat_sym.cli.application import BAD_INPUT, INTERRUPTED, app, complain

__all__ = ["app", "main"]


def main() -> NoReturn:
    """Entry point: every refusal is one clear message and an exit status; SIGTERM ends a command as Ctrl-C does."""
    from softcat_sym.interrupts import ended_like_ctrl_c

    with ended_like_ctrl_c() as ending, _collecting_seldom():
        status = _status()
    sys.exit(ending.status if status == INTERRUPTED else status)


@contextlib.contextmanager
def _collecting_seldom() -> Iterator[None]:
    """Look for unreachable cycles a hundredth as often: SymPy's imports alone would be searched for them 600 times.

    A tenth of a short run is that search, which finds next to nothing.
    """
    before = gc.get_threshold()
    gc.set_threshold(100 * before[0], *before[1:])
    try:
        yield
    finally:
        gc.set_threshold(*before)


def _status() -> int | str | None:
    """Run the command that was asked for; its exit status."""
    from softcat_sym.errors import SoftcatError

    try:
        app()
    except SystemExit as left:
        # Typer turns Ctrl-C where no command expects it into this status, and says nothing.
        if isinstance(getattr(left.__context__, "__cause__", None), KeyboardInterrupt):
            complain("interrupted; every file is whole, the old one or the new")
        return left.code
    except SoftcatError as error:
        complain(str(error))
        return BAD_INPUT
    except OSError as error:
        complain(f"cannot write the results: {_reason(error)}")
        return BAD_INPUT
    return 0


def _reason(error: OSError) -> str:
    """What went wrong with a file, without the numbers and passing names of the system."""
    if error.strerror is None:
        return str(error)
    where = f" ({Path(error.filename).parent})" if isinstance(error.filename, str) and error.filename else ""
    return f"{error.strerror}{where}"
