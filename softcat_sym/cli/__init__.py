"""The ``softcat`` command; a file for each of its commands.

Exit status: 0 a sound answer, 1 an answer not to be trusted, 2 bad input, 130 interrupted.
"""

from __future__ import annotations

import sys
from typing import NoReturn

# Importing a command registers it, in the order in which the help lists them.
from softcat_sym.cli import run as run  # isort: skip
from softcat_sym.cli import explain as explain  # isort: skip
from softcat_sym.cli import effects as effects  # isort: skip
from softcat_sym.cli import generate as generate  # isort: skip
from softcat_sym.cli import compare as compare  # isort: skip
from softcat_sym.cli import figures as figures  # isort: skip
from softcat_sym.cli import phase as phase  # isort: skip
from softcat_sym.cli import fit as fit  # isort: skip
from softcat_sym.cli import experiment as experiment  # isort: skip
from softcat_sym.cli import flow_curve as flow_curve  # isort: skip
from softcat_sym.cli import scenes as scenes  # isort: skip
from softcat_sym.cli import cache as cache  # isort: skip
from softcat_sym.cli.application import BAD_INPUT, app, complain

__all__ = ["app", "main"]


def main() -> NoReturn:
    """Entry point: every refusal is one clear message and an exit status."""
    from softcat_sym.errors import SoftcatError

    try:
        app()
    except SoftcatError as error:
        complain(str(error))
        sys.exit(BAD_INPUT)
    except OSError as error:
        complain(f"cannot write the results: {error}")
        sys.exit(BAD_INPUT)
    sys.exit(0)
