"""``softcat validate``: published experiments and computations, compared with results of this package."""

from __future__ import annotations

import shlex
from typing import Annotated

import typer

from softcat_sym import drawing
from softcat_sym.cli import application as cli

_NAMES = typer.Argument(
    metavar="CASE", help="Only these cases: mora, princeton, ...; a wrong name lists all.", show_default="all of them"
)


@cli.commands.command()
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
    from softcat_sym.studies.validate import chosen_cases
    from softcat_sym.studies.validate import validate as compare_with_published

    names = list(cases or ())
    chosen = chosen_cases(names)
    output = cli.output_directory(output, "validate")
    from softcat_sym.plotting.terminal import StepProgress

    with cli.study(output, fresh=fresh), StepProgress(len(chosen), "cases", quiet=quiet) as progress:
        validation = compare_with_published(names, progress)
        progress.stage("drawing")
        report = drawing.report(validation, command=shlex.join(["softcat", "validate", *names, "-o", "DIR"]))
        written = report.write(output)
    cli.present(report, written, output, quiet=quiet)
    for result in validation.failures:
        cli.print_error(f"{result.case.name}: {result.failure}")
    if validation.failures:
        raise typer.Exit(cli.UNTRUSTED)
