"""``softcat draw``: a finished run, drawn again without solving."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli.application import INTERRUPTED, OutputOption, QuietOption, app, check_directory, complain
from softcat_sym.cli.run import AnimateOption, SecondsOption, StyleOption, film, pictures_asked

TrajectoryArgument = Annotated[
    Path, typer.Argument(metavar="TRAJECTORY", help="A trajectory.nc that softcat run wrote, or its folder.")
]


@app.command()
def draw(
    trajectory: TrajectoryArgument,
    output: OutputOption,
    animate: AnimateOption = None,
    animate_seconds: SecondsOption = 8.0,
    style: StyleOption = "screen",
    quiet: QuietOption = False,
) -> None:
    """Draw a finished run again, without solving: its pictures, its table, a film, in another style, in DIR.

    summary.json and scene.toml of the run go along with them.
    """
    order, drawn = pictures_asked(animate, animate_seconds, style)
    check_directory(output)
    from softcat_sym.files import made, written_together
    from softcat_sym.report import write_pictures
    from softcat_sym.trajectory.files import write_scene, write_summary
    from softcat_sym.trajectory.stored_run import check_drawable, open_run

    run = open_run(trajectory)
    check_drawable(run)
    try:
        with made(output), written_together():
            files = write_pictures(run.data, run.summary, run.scene, output, drawn)
            files += [write_summary(run.summary, output), write_scene(run.scene.to_toml(), output)]
            if order is not None:
                files.append(film(order, output, (run.data, run.summary, run.scene), quiet=quiet))
    except KeyboardInterrupt:
        complain("interrupted; nothing was written")
        raise typer.Exit(INTERRUPTED) from None
    if not quiet:
        typer.echo(f"wrote {', '.join(path.name for path in files)} to {output}")
