"""What commands share that keep what is finished: an interrupted one goes on from there with ``--resume``."""

from __future__ import annotations

import hashlib
import importlib.metadata
import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import INTERRUPTED, print_error
from softcat_sym.errors import SoftcatError

if TYPE_CHECKING:
    from softcat_sym.ensemble.block_store import KeptResults

ResumeOption = Annotated[
    bool, typer.Option("--resume", help="Go on from where the same command was interrupted; see DIR/parts.")
]


@contextmanager
def going_on(
    output: Path, what: str, asked: Mapping[str, object], *, resume: bool, left: Callable[[], str] = str
) -> Iterator[None]:
    """Keep what is computed meanwhile in DIR/parts until all is written; Ctrl-C says what is kept, and exits."""
    from softcat_sym.ensemble.block_store import kept_text
    from softcat_sym.files import made
    from softcat_sym.solvers.checkpoint import kept_by

    results = _results(output, what, asked, resume=resume)
    with made(output):
        try:
            with kept_by(results):
                yield
        except KeyboardInterrupt:
            results.flush()
            print_error(f"interrupted; {left() or results.trouble or kept_text(output) or 'nothing was written'}")
            raise typer.Exit(INTERRUPTED) from None
        except SoftcatError:
            # It would end so again.
            results.clear()
            raise
        except OSError:
            results.flush()
            if text := kept_text(output):
                print_error(text)
            raise
        results.clear()


def _results(output: Path, what: str, asked: Mapping[str, object], *, resume: bool) -> KeptResults:
    from softcat_sym.ensemble.block_store import KeptBlocks, KeptResults

    told = {"what": what, "version": importlib.metadata.version("softcat_sym"), **asked}
    digest = hashlib.sha256(json.dumps(told, sort_keys=True, default=str).encode()).hexdigest()
    return KeptResults(KeptBlocks(output, digest, {"what": f"softcat {what}"}, resume=resume))
