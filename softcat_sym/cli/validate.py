"""``softcat validate``: published experiments and computations, compared with results of this package."""

from __future__ import annotations

import shlex
from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports

with lazy_imports():
    from softcat_sym.plotting import terminal
    from softcat_sym.studies import validate as study

_NAMES = typer.Argument(
    metavar="CASE", help="Only these cases: mora, princeton, ...; a wrong name lists all.", show_default="all of them"
)


def validate(
    cases: Annotated[list[str] | None, _NAMES] = None,
    output: cli.OutputOption = None,
    fresh: cli.FreshOption = False,
    quiet: cli.QuietOption = False,
) -> None:
    """Compare the package with published experiments and computations.

    One table has the source, the published result, that of this package, the difference and a possible explanation.
    Nothing is fitted. DIR gets validation.html, .json, .csv and .png, and the picture and the scenes of each case as
    TOML files that can be run.
    A case that cannot be run is in the table with the reason; flow curves need pip install softcat_sym[peers].
    """
    names = list(cases or ())
    chosen = study.chosen_cases(names)
    output = cli.output_directory(output, "validate")
    with cli.study(fresh=fresh), terminal.StepProgress(len(chosen), "cases", quiet=quiet) as progress:
        validation = study.validate(names, progress)
    cli.present(validation, output, quiet=quiet, command=shlex.join(["softcat", "validate", *names, "-o", "DIR"]))
    for result in validation.failures:
        cli.print_error(f"{result.case.name}: {result.failure}")
    if validation.failures:
        raise typer.Exit(cli.UNTRUSTED)
