"""``softcat run``: one filament."""

from __future__ import annotations

import importlib.metadata
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
from softcat_sym.cli.without_dask import without_dask

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.plotting.animation import FilmOrder
    from softcat_sym.plotting.units import Summary
    from softcat_sym.scene.scene import Scene
    from softcat_sym.solvers.checkpoint import Checkpoints

_FOLDER = "checkpoint"

RunOutputOption = Annotated[
    Path | None,
    typer.Option(
        "--output", "-o", metavar="DIR", help="Where the files go.", show_default="softcat-out/SCENE", parser=directory
    ),
]
ResumeOption = Annotated[
    bool,
    typer.Option("--resume", help="Go on from where the same command was interrupted; states are in DIR/checkpoint."),
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
    resume: ResumeOption = False,
    animate: AnimateOption = None,
    animate_seconds: SecondsOption = 8.0,
    style: StyleOption = "screen",
    verbose: VerboseOption = False,
    quiet: QuietOption = False,
) -> None:
    """Simulate one filament.

    DIR gets trajectory.nc, summary.json, scene.toml, pictures and a table.
    A run of more than five seconds keeps what it has reached in DIR/checkpoint until its answer is written.
    """
    order, drawn = pictures_asked(animate, animate_seconds, style)
    asked, output = scene_and_directory(scene, changes, output, "run")
    checkpoints = _checkpoints(asked, output, resume=resume)
    from softcat_sym.files import made, written_together
    from softcat_sym.plotting.run import write_run
    from softcat_sym.plotting.terminal import IntegrationProgress
    from softcat_sym.simulate import simulated
    from softcat_sym.solvers.checkpoint import Resumable

    try:
        with without_dask(), IntegrationProgress(asked.run.duration, quiet=quiet) as progress:
            progress.doing("reading")
            trajectory = simulated(asked, Resumable(progress, checkpoints))
            progress.stage("drawing pictures")
            with made(output), written_together():
                written = write_run(trajectory, output, drawn)
    except KeyboardInterrupt:
        print_error(f"interrupted; {_kept(checkpoints)}")
        raise typer.Exit(INTERRUPTED) from None
    except OSError:
        if checkpoints.kept or checkpoints.resumed:
            print_error(_kept(checkpoints))
        raise
    checkpoints.clear()
    if order is not None:
        _film_of_a_run(order, output, (trajectory.data, written.summary, asked), quiet=quiet)
    if not quiet:
        from softcat_sym.plotting.terminal import print_summary

        films = (output / order.name,) if order else ()
        print_summary(written.summary, asked, (*films, *written.files), verbose=verbose)
        if resume:
            typer.echo(_resumed(checkpoints))
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


def _checkpoints(asked: Scene, output: Path, *, resume: bool) -> Checkpoints:
    """The folder of the states of this run; what it is asked, and of which program, is its owner."""
    from softcat_sym.solvers.checkpoint import Checkpoints

    version = importlib.metadata.version("softcat_sym")
    return Checkpoints(output / _FOLDER, f"{version}\n{asked.to_toml()}".encode(), resume=resume)


def _kept(checkpoints: Checkpoints) -> str:
    """What an interrupted run leaves behind."""
    if checkpoints.kept or checkpoints.resumed:
        return f"what was reached is in {checkpoints.folder}: the same command with --resume goes on from there"
    return f"{checkpoints.trouble}; nothing was written" if checkpoints.trouble else "nothing was written"


def _resumed(checkpoints: Checkpoints) -> str:
    """Whether it went on from a state, or began anew."""
    if checkpoints.resumed:
        return f"went on from {checkpoints.folder}"
    return f"there was no state in {checkpoints.folder}: begun anew"
