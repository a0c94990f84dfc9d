"""``softcat figures``: the paper's figures."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli.application import OutputOption, QuietOption, app, check_directory


@app.command()
def figures(
    output: OutputOption,
    only: Annotated[
        list[int] | None, typer.Option("--only", metavar="NUMBER", help="Only this figure of the paper. Repeatable.")
    ] = None,
    quiet: QuietOption = False,
) -> None:
    """Draw the paper's figures: PNG, data as CSV, facts and caption as JSON. Now there is figure 2."""
    asked = only or [2]
    if set(asked) != {2}:
        raise typer.BadParameter("figure 2 is the one there is; the others are not yet available", param_hint="--only")
    check_directory(output)
    from softcat_sym.report.maxwell_descent import caption, write_maxwell_descent
    from softcat_sym.report.progress import StepProgress
    from softcat_sym.study.maxwell_descent import RELAXATION, SLENDERNESS, maxwell_descents

    with StepProgress(2 * len(RELAXATION) * len(SLENDERNESS), "figure 2", quiet=quiet) as progress:
        panels = maxwell_descents(progress.step)
    written = write_maxwell_descent(panels, output)
    if not quiet:
        typer.echo(caption(panels))
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
