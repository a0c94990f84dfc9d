"""``softcat validate``: what others have measured or computed, beside what comes out here."""

from __future__ import annotations

import shlex
from typing import Annotated

import typer

from softcat_sym.cli.application import (
    UNTRUSTED,
    FreshOption,
    OutputOption,
    QuietOption,
    commands,
    output_directory,
    print_error,
    study,
)

_NAMES = typer.Argument(
    metavar="CASE", help="Only these, such as mora or princeton; a wrong name lists all.", show_default="all of them"
)


@commands.command()
def validate(
    cases: Annotated[list[str] | None, _NAMES] = None,
    output: OutputOption = None,
    fresh: FreshOption = False,
    quiet: QuietOption = False,
) -> None:
    """Hold the package against published experiments and computations.

    One table: source, what was published, what comes out here, the difference, what may explain it. Nothing is fitted.
    DIR gets validation.html, .json, .csv and .png, and the picture and the scenes of each case, as TOML to run again.
    A case that cannot be run stands in the table with the reason; flow curves want pip install softcat_sym[peers].
    """
    from softcat_sym.studies.validate import chosen_cases
    from softcat_sym.studies.validate import validate as hold_against

    names = list(cases or ())
    chosen = chosen_cases(names)
    output = output_directory(output, "validate")
    from softcat_sym.plotting.terminal import StepProgress
    from softcat_sym.plotting.validate import print_validation, write_validation

    with study(output, fresh=fresh), StepProgress(len(chosen), "cases", quiet=quiet) as progress:
        validation = hold_against(names, progress)
        progress.stage("drawing")
        written = write_validation(validation, output, shlex.join(["softcat", "validate", *names, "-o", "DIR"]))
    if not quiet:
        print_validation(validation)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
    for result in validation.failures:
        print_error(f"{result.case.name}: {result.failure}")
    if validation.failures:
        raise typer.Exit(UNTRUSTED)
