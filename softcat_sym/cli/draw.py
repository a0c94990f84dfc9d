"""``softcat draw``: a finished run, drawn again without solving."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli.application import (
    EVERYDAY,
    INTERRUPTED,
    OutputOption,
    QuietOption,
    app,
    output_directory,
    print_error,
)
from softcat_sym.cli.run import AnimateOption, SecondsOption, StyleOption, film, pictures_asked

TrajectoryArgument = Annotated[
    Path, typer.Argument(metavar="TRAJECTORY", help="A trajectory.nc that softcat run wrote, or its folder.")
]


@app.command(rich_help_panel=EVERYDAY)
def draw(
    trajectory: TrajectoryArgument,
    output: OutputOption = None,
    animate: AnimateOption = None,
    animate_seconds: SecondsOption = 8.0,
    style: StyleOption = "screen",
    quiet: QuietOption = False,
) -> None:
    """Draw a finished run again: in another style, or as a film.

    Without solving; its pictures, its table and a film go to DIR (by default the folder of the run with -draw).
    summary.json and scene.toml of the run go along with them.
    """
    order, drawn = pictures_asked(animate, animate_seconds, style)
    folder = trajectory.parent if trajectory.suffix == ".nc" else trajectory
    output = output_directory(output, "draw", folder.resolve().name)
    from softcat_sym.files import made, written_together
    from softcat_sym.plotting.files import write_results
    from softcat_sym.plotting.run import pictures
    from softcat_sym.results.trajectory import check_drawable, open_run

    run = open_run(trajectory)
    check_drawable(run)
    try:
        with made(output), written_together():
            contents = pictures(run.fields, run.summary, run.scene, drawn)
            beside = {"summary.json": run.summary, "scene.toml": run.scene.to_toml()}
            files = write_results(output, contents | beside)
            if order is not None:
                files.append(film(order, output, (run.fields, run.summary, run.scene), quiet=quiet))
    except KeyboardInterrupt:
        print_error("interrupted; nothing was written")
        raise typer.Exit(INTERRUPTED) from None
    if not quiet:
        typer.echo(f"wrote {', '.join(path.name for path in files)} to {output}")
