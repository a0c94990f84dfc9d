"""``softcat run`` and ``softcat draw``: one filament, and new pictures of a finished run."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym import drawing
from softcat_sym.cli import application as cli
from softcat_sym.interrupts import ending

if TYPE_CHECKING:
    from softcat_sym.plotting.animation import FilmOrder
    from softcat_sym.results.run import Run

AnimateOption = Annotated[
    cli.Text, cli.option("FILM", "Write a film of the filament into DIR: gif, mp4, or a name such as ink.gif.")
]
SecondsOption = Annotated[float, cli.option("SECONDS", "Length of the film.")]
StyleOption = Annotated[
    str, cli.option("STYLE", "Style of the pictures: screen; publication (a column wide, PDF too); page.")
]
RadiusOption = Annotated[float, cli.option("FACTOR", "Factor by which shapes are drawn thicker, to show beads.")]


@cli.commands.command()
def run(
    scene: cli.SceneArgument,
    output: Annotated[Path | None, cli.output_option("softcat-out/SCENE")] = None,
    changes: cli.SetOption = None,
    animate: AnimateOption = None,
    animate_seconds: SecondsOption = 8.0,
    style: StyleOption = "screen",
    radius: RadiusOption = 1.0,
    no_pictures: Annotated[
        bool, cli.switch("Write only trajectory.nc, summary.json and scene.toml, which is faster.", "--no-pictures")
    ] = False,
    verbose: cli.VerboseOption = False,
    quiet: cli.QuietOption = False,
) -> None:
    """Simulate one filament.

    DIR gets trajectory.nc, summary.json, scene.toml, pictures and a table.
    """
    plain = no_pictures and (animate, style, radius) == (None, "screen", 1.0)
    order, drawn = (None, style) if plain else _requested_pictures(animate, animate_seconds, style, radius)
    asked, output = cli.scene_and_directory(scene, changes, output, "run")
    from softcat_sym.plotting.terminal import IntegrationProgress
    from softcat_sym.simulate import simulated
    from softcat_sym.solvers.solution import Interrupted

    files, films = list[Path](), list[Path]()
    again = f"softcat draw {output} -o {output}"
    try:
        with IntegrationProgress(asked.run.duration, quiet=quiet) as progress:
            progress.doing("reading")
            try:
                trajectory = simulated(asked, progress, cli.print_error)
            except Interrupted as stopped:
                # What there is, at once: pictures can be drawn of it later.
                trajectory, no_pictures, order = stopped.part(), True, None
                cli.print_error(f"{ending()}; what was computed is in {output}, its pictures are not: {again}")
            ending().no_limit()
            progress.stage("writing")
            # The numbers are written first, so that they remain after Ctrl-C during the drawing.
            trajectory, files = trajectory.written(output, trajectory.files())
            if not no_pictures:
                progress.stage("drawing pictures")
                report = drawing.report(trajectory, name=drawn, radius=radius)
                trajectory, pictures = trajectory.written(output, report.files)
                files += pictures
    except KeyboardInterrupt:
        left = "nothing was written" if not files else f"the run is in {output}, its pictures are not: {again}"
        raise cli.interrupted(left) from None
    if order is not None:
        try:
            films = [_film(order, output, trajectory, quiet=quiet)]
        except KeyboardInterrupt:
            left = f"the run is in {output}, its film is not: {again} --animate {order.name}"
            raise cli.interrupted(left) from None
    if not quiet:
        from softcat_sym.plotting.terminal import print_summary

        print_summary(trajectory.summary, asked, (*films, *files), verbose=verbose)
    cli.judge(trajectory.outcome, trajectory.summary["message"], quiet=quiet)


@cli.commands.command()
def draw(
    trajectory: Annotated[
        Path, typer.Argument(metavar="TRAJECTORY", help="A trajectory.nc that softcat run wrote, or its folder.")
    ],
    output: cli.OutputOption = None,
    animate: AnimateOption = None,
    animate_seconds: SecondsOption = 8.0,
    style: StyleOption = "screen",
    radius: RadiusOption = 1.0,
    vtk: Annotated[
        bool, cli.switch("Write every frame for ParaView into DIR/vtk; this needs the extra fem.", "--vtk")
    ] = False,
    quiet: cli.QuietOption = False,
) -> None:
    """Draw a finished run again: in another style, as a film, or for ParaView.

    Nothing is solved. The pictures, the table and a film go to DIR (by default the folder of the run with -draw),
    with copies of the run's summary.json and scene.toml.
    """
    order, drawn = _requested_pictures(animate, animate_seconds, style, radius)
    if vtk:
        from softcat_sym.plotting.vtk import require_meshio, write_run_vtk

        require_meshio()
    folder = trajectory.parent if trajectory.suffix == ".nc" else trajectory
    output = cli.output_directory(output, "draw", folder.resolve().name)
    from softcat_sym.files import made, write_results, written_together
    from softcat_sym.results.run import check_drawable, open_run

    run = open_run(trajectory)
    check_drawable(run)
    try:
        with made(output), written_together():
            beside = {"summary.json": run.summary, "scene.toml": run.scene.to_toml()}
            files = write_results(output, {**drawing.report(run, name=drawn, radius=radius).files, **beside})
            files += [] if order is None else [_film(order, output, run, quiet=quiet)]
            files += write_run_vtk(run, output / "vtk")[:1] if vtk else []
    except KeyboardInterrupt:
        raise cli.interrupted("nothing was written") from None
    if not quiet:
        cli.print_written(files, output)


def _requested_pictures(animate: str | None, seconds: float, style: str, radius: float) -> tuple[FilmOrder | None, str]:
    """Read the options of films and pictures; faults are refused before anything is computed."""
    from softcat_sym.plotting.style import drawn_radius, picture_style

    drawn_radius(radius)
    drawn = picture_style(style)
    if animate is None:
        return None, drawn
    from softcat_sym.plotting.animation import film_order

    return film_order(animate, seconds), drawn


def _film(order: FilmOrder, output: Path, run: Run, *, quiet: bool) -> Path:
    """Draw a film, with a progress bar on the terminal."""
    from softcat_sym.plotting.animation import write_film
    from softcat_sym.plotting.terminal import StepProgress

    with StepProgress(order.pictures, "drawing", quiet=quiet) as progress:
        path, note = write_film(order, output, (run.fields, run.summary, run.scene), progress.step)
    if note:
        cli.print_error(f"{path.name}: {note}")
    return path
