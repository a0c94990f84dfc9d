"""``softcat run``: one filament."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    EVERYDAY,
    INTERRUPTED,
    QuietOption,
    SceneArgument,
    SetOption,
    VerboseOption,
    app,
    directory,
    judge,
    print_error,
    scene_and_directory,
)

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.plotting.animation import FilmOrder
    from softcat_sym.plotting.units import Summary
    from softcat_sym.scene.scene import Scene

RunOutputOption = Annotated[
    Path | None,
    typer.Option(
        "--output", "-o", metavar="DIR", help="Where the files go.", show_default="softcat-out/SCENE", parser=directory
    ),
]
AnimateOption = Annotated[
    str | None,
    typer.Option(
        "--animate", metavar="FILM", help="A film of the filament in DIR: gif, mp4, or a name such as ink.gif."
    ),
]
SecondsOption = Annotated[float, typer.Option("--animate-seconds", metavar="SECONDS", help="Length of the film.")]
StyleOption = Annotated[
    str,
    typer.Option(
        "--style", metavar="STYLE", help="Of the pictures: screen; publication (a column wide, PDF too); page."
    ),
]


@app.command(rich_help_panel=EVERYDAY)
def run(
    scene: SceneArgument,
    output: RunOutputOption = None,
    changes: SetOption = None,
    animate: AnimateOption = None,
    animate_seconds: SecondsOption = 8.0,
    style: StyleOption = "screen",
    verbose: VerboseOption = False,
    quiet: QuietOption = False,
) -> None:
    """Simulate one filament.

    DIR gets trajectory.nc, summary.json, scene.toml, pictures and a table.
    """
    order, drawn = pictures_asked(animate, animate_seconds, style)
    asked, output = scene_and_directory(scene, changes, output, "run")
    from softcat_sym.files import made, written_together
    from softcat_sym.plotting.run import write_run
    from softcat_sym.plotting.terminal import IntegrationProgress
    from softcat_sym.simulate import simulated

    try:
        with IntegrationProgress(asked.run.duration, quiet=quiet) as progress:
            progress.doing("reading")
            trajectory = simulated(asked, progress)
            progress.stage("drawing pictures")
            with made(output), written_together():
                written = write_run(trajectory, output, drawn)
    except KeyboardInterrupt:
        print_error("interrupted; nothing was written")
        raise typer.Exit(INTERRUPTED) from None
    if order is not None:
        _film_of_a_run(order, output, (trajectory.fields, written.summary, asked), quiet=quiet)
    if not quiet:
        from softcat_sym.plotting.terminal import print_summary

        films = (output / order.name,) if order else ()
        print_summary(written.summary, asked, (*films, *written.files), verbose=verbose)
    judge(trajectory.outcome, trajectory.summary["message"], quiet=quiet)


def pictures_asked(animate: str | None, seconds: float, style: str) -> tuple[FilmOrder | None, str]:
    """What the options of films and pictures ask for, refused before anything is computed."""
    from softcat_sym.plotting.style import picture_style

    drawn = picture_style(style)
    if animate is None:
        return None, drawn
    from softcat_sym.plotting.animation import film_order

    return film_order(animate, seconds), drawn


def film(order: FilmOrder, output: Path, run: tuple[xr.Dataset, Summary, Scene], *, quiet: bool) -> Path:
    """Draw a film, with a bar on the terminal."""
    from softcat_sym.plotting.animation import write_film
    from softcat_sym.plotting.terminal import StepProgress

    with StepProgress(order.pictures, "drawing", quiet=quiet) as progress:
        path, note = write_film(order, output, run, progress.step)
    if note:
        print_error(f"{path.name}: {note}")
    return path


def _film_of_a_run(order: FilmOrder, output: Path, run: tuple[xr.Dataset, Summary, Scene], *, quiet: bool) -> None:
    """Draw the film of a run that is there already: interrupted, it says how to have it later."""
    try:
        film(order, output, run, quiet=quiet)
    except KeyboardInterrupt:
        again = f"softcat draw {output} -o {output} --animate {order.name}"
        print_error(f"interrupted; the run is in {output}, its film is not: {again}")
        raise typer.Exit(INTERRUPTED) from None
