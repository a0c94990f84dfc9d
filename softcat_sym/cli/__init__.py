"""The ``softcat`` command; a file for each of its commands.

Exit status: 0 a sound answer, 1 an answer not to be trusted, 2 bad input, a place that cannot be written or too little
memory, 130 interrupted by Ctrl-C, 143 ended by SIGTERM, 129 by a terminal that was closed, 141 (without a word) where
nobody reads on, as in ``softcat scenes | head -1``.
"""

from __future__ import annotations

import codecs
import contextlib
import errno
import io
import os
import sys
import unicodedata
from pathlib import Path
from typing import NoReturn

from softcat_sym.cli.overview import HELP, overview

__all__ = ["main"]

_BROKEN_PIPE = 141
"""Exit status that a shell gives a program that SIGPIPE has ended."""


def main() -> NoReturn:
    """Entry point: every refusal is one clear message and an exit status; SIGTERM ends a command as Ctrl-C does."""
    print_whatever_the_terminal_takes()
    if sys.argv[1:] in ([word] for word in HELP):
        # Where nobody reads it, typer below knows how to leave.
        with contextlib.suppress(BrokenPipeError):
            print(overview(Path(sys.argv[0]).name), flush=True)
            sys.exit()
    from softcat_sym.cli.application import INTERRUPTED
    from softcat_sym.interrupts import ended_like_ctrl_c

    # Commands draw into files: a name of a window system that is not there would only keep matplotlib from loading.
    os.environ["MPLBACKEND"] = "agg"
    # Scenes need no plugin, and pydantic would look for one in all that is installed.
    os.environ["PYDANTIC_DISABLE_PLUGINS"] = "1"
    # No matrix of ours is large enough for the threads of OpenBLAS, which only wait beside a command's own.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    with ended_like_ctrl_c() as ending:
        status = _status()
    sys.exit(ending.status if status == INTERRUPTED else status)


def _status() -> int | str | None:
    """Run the command that was asked for; its exit status."""
    from softcat_sym.cli.application import BAD_INPUT, app, print_error
    from softcat_sym.errors import SoftcatError

    try:
        app()
    except SystemExit as left:
        # Typer turns Ctrl-C where no command expects it into this status, and says nothing.
        if isinstance(getattr(left.__context__, "__cause__", None), KeyboardInterrupt):
            print_error("interrupted; every file is whole, the old one or the new")
        # Typer and rich exit with 1 where nobody reads the output any more.
        unread = isinstance(left.__context__, OSError) and left.__context__.errno == errno.EPIPE
        return _BROKEN_PIPE if unread else left.code
    except SoftcatError as error:
        print_error(str(error))
    except OSError as error:
        # What went wrong with a file, without the numbers and passing names of the system.
        where = f" ({Path(error.filename).parent})" if isinstance(error.filename, str) and error.filename else ""
        print_error(f"cannot write the results: {f'{error.strerror}{where}' if error.strerror else error}")
    except MemoryError:
        print_error("there is too little memory: free some, allow more (ulimit -v), or ask for fewer cells or frames")
    except ImportError as error:
        reason = str(error).strip().rpartition("\n")[2]  # numpy explains itself in its last line
        print_error(f"cannot be loaded: {reason}; allow more memory (ulimit -v), or install softcat_sym again")
    else:
        return 0
    return BAD_INPUT


# What has no plain letter for its base, or another one than its look suggests.
_PLAIN = str.maketrans(
    {**dict(zip("−–—×·÷~µμ█━│⁄≈‘’“”", "---x*/~uu#-|/~''\"\"", strict=True))}
    | {"±": "+-", "≤": "<=", "≥": ">=", "≠": "!=", "→": "->", "←": "<-", "…": "...", "°": " deg", "√": "sqrt"}
    | {"α": "alpha", "β": "beta", "γ": "gamma", "δ": "delta", "Δ": "Delta", "ε": "eps", "ζ": "zeta", "η": "eta"}
    | {"θ": "theta", "κ": "kappa", "λ": "lambda", "ν": "nu", "π": "pi", "ρ": "rho", "σ": "sigma", "τ": "tau"}
    | {"φ": "phi", "ω": "omega", "Ω": "Ohm", "∞": "inf", "ß": "ss"}
)


def plain(text: str) -> str:
    """Write a text in ASCII: signs by what they mean, letters without their accents, and ``?`` for what is left."""
    parts = unicodedata.normalize("NFKD", text.translate(_PLAIN))
    bare = "".join(letter for letter in parts if not unicodedata.combining(letter))
    return bare.translate(_PLAIN).encode("ascii", "replace").decode()


def print_whatever_the_terminal_takes() -> None:
    """Let standard output and error write :func:`plain` text where their encoding lacks a letter, and never fail."""
    codecs.register_error("softcat-plain", _replaced)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="softcat-plain")


def _replaced(error: UnicodeError) -> tuple[str | bytes, int]:
    """Replace what cannot be encoded; the bytes of a file's name that is no text are written as they are."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    letter = error.object[error.start]
    is_byte = "\udc80" <= letter <= "\udcff"
    return bytes([ord(letter) - 0xDC00]) if is_byte else plain(letter), error.start + 1
