"""The ``softcat`` command; a file for each of its commands.

Exit status: 0 a sound answer, 1 an answer not to be trusted, 2 bad input, a place that cannot be written or too little
memory, 130 interrupted by Ctrl-C, 143 ended by SIGTERM, 129 by a terminal that was closed, 141 (without a word) where
nobody reads on, as in ``softcat scenes | head -1``.
"""

from __future__ import annotations

import errno
import os
import sys
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
from softcat_sym.cli.application import BAD_INPUT, INTERRUPTED, app, print_error
from softcat_sym.cli.streams import print_whatever_the_terminal_takes

__all__ = ["app", "main"]

_NOBODY_READS = 141
"""What a shell tells of a program that SIGPIPE has ended."""


def main() -> NoReturn:
    """Entry point: every refusal is one clear message and an exit status; SIGTERM ends a command as Ctrl-C does."""
    from softcat_sym.interrupts import ended_like_ctrl_c

    print_whatever_the_terminal_takes()
    # Commands draw into files: a name of a window system that is not there would only keep matplotlib from loading.
    os.environ["MPLBACKEND"] = "agg"
    with ended_like_ctrl_c() as ending:
        status = _status()
    sys.exit(ending.status if status == INTERRUPTED else status)


def _status() -> int | str | None:
    """Run the command that was asked for; its exit status."""
    from softcat_sym.errors import SoftcatError

    try:
        app()
    except SystemExit as left:
        # Typer turns Ctrl-C where no command expects it into this status, and says nothing.
        if isinstance(getattr(left.__context__, "__cause__", None), KeyboardInterrupt):
            print_error("interrupted; every file is whole, the old one or the new")
        return _NOBODY_READS if _is_broken_pipe(left.__context__) else left.code
    except SoftcatError as error:
        print_error(str(error))
        return BAD_INPUT
    except OSError as error:
        print_error(f"cannot write the results: {_reason(error)}")
        return BAD_INPUT
    except MemoryError:
        print_error("there is too little memory: free some, allow more (ulimit -v), or ask for fewer cells or frames")
        return BAD_INPUT
    except ImportError as error:
        reason = str(error).strip().rpartition("\n")[2]  # of what numpy says, the last line tells
        print_error(f"cannot be loaded: {reason}; allow more memory (ulimit -v), or install softcat_sym again")
        return BAD_INPUT
    return 0


def _is_broken_pipe(error: BaseException | None) -> bool:
    """Whether Typer or rich, which then exit with 1, ended because nobody reads the output any more."""
    return isinstance(error, OSError) and error.errno == errno.EPIPE


def _reason(error: OSError) -> str:
    """What went wrong with a file, without the numbers and passing names of the system."""
    if error.strerror is None:
        return str(error)
    where = f" ({Path(error.filename).parent})" if isinstance(error.filename, str) and error.filename else ""
    return f"{error.strerror}{where}"
