"""The ``softcat`` command; a file for each of its commands.

Exit status: 0 for a sound answer, 1 for an answer not to be trusted, 2 for bad input, a folder that cannot be written
or too little memory, 130 after Ctrl-C, 143 after SIGTERM, 129 after the terminal was closed, 141 (without a message)
if the output is no longer read, as in ``softcat scenes | head -1``. A time limit ends a command as Ctrl-C does, with 1.
"""

from __future__ import annotations

import contextlib
import errno
import io
import os
import sys
import warnings
from pathlib import Path
from typing import NoReturn

from softcat_sym.cli.overview import HELP, overview
from softcat_sym.lazy import lazy_imports

with lazy_imports():
    from softcat_sym import errors, interrupts
    from softcat_sym.cli import application

__all__ = ["main"]

_BROKEN_PIPE = 141
"""Exit status of a program that SIGPIPE has ended."""


def main() -> NoReturn:
    """Entry point: an error is one message and an exit status; SIGTERM ends a command as Ctrl-C does."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            # A character that the terminal's encoding lacks is written by its name.
            stream.reconfigure(errors="namereplace")
    if sys.argv[1:] in ([word] for word in HELP):
        # Typer below handles output that is no longer read.
        with contextlib.suppress(BrokenPipeError):
            print(overview(Path(sys.argv[0]).name), flush=True)
            sys.exit()
    # Commands draw into files; the backend of a missing window system would prevent matplotlib from loading.
    os.environ["MPLBACKEND"] = "agg"
    # Scenes need no plugins, and pydantic would search all installed packages for them.
    os.environ["PYDANTIC_DISABLE_PLUGINS"] = "1"
    # The matrices of this package are too small for the threads of OpenBLAS, which would compete with a command's own.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    warnings.showwarning = _show_warning
    with interrupts.ended_like_ctrl_c() as ending:
        status = _status(ending)
    sys.exit(ending.status if status == application.INTERRUPTED else status)


def _show_warning(
    message: Warning | str,
    category: type[Warning],
    filename: str,
    lineno: int,
    file: object = None,
    line: object = None,
) -> None:
    """Print a warning as one line; only of those that are not for users, where in the program it arose."""
    application.print_error(
        str(message) if issubclass(category, UserWarning) else f"{message} ({filename}, line {lineno})"
    )


def _status(ending: interrupts.Ending) -> int | str | None:
    """Run the command, and return its exit status."""
    try:
        application.app()
    except SystemExit as left:
        # If a command does not handle Ctrl-C, typer exits without a message.
        if isinstance(getattr(left.__context__, "__cause__", None), KeyboardInterrupt):
            application.print_error(f"{ending}; every file is whole, the old one or the new")
            return application.INTERRUPTED
        # Typer and rich exit with 1 if the output is no longer read.
        unread = isinstance(left.__context__, OSError) and left.__context__.errno == errno.EPIPE
        return _BROKEN_PIPE if unread else left.code
    except errors.SoftcatError as error:
        application.print_error(str(error))
    except OSError as error:
        # The message has neither error numbers nor names of temporary files.
        where = f" ({Path(error.filename).parent})" if isinstance(error.filename, str) and error.filename else ""
        results = f"cannot write the results: {f'{error.strerror}{where}' if error.strerror else error}"
        # A note says what else it was that could not be written.
        application.print_error("; ".join(getattr(error, "__notes__", [results])))
    except MemoryError:
        application.print_error(
            "there is too little memory: free some, allow more (ulimit -v), or ask for fewer cells or frames"
        )
    except ImportError as error:
        reason = str(error).strip().rpartition("\n")[2]  # NumPy has the reason in the last line
        application.print_error(
            f"cannot be loaded: {reason}; allow more memory (ulimit -v), or install softcat_sym again"
        )
    else:
        return 0
    return application.BAD_INPUT
