"""``softcat run`` and ``softcat draw``: one filament, and new pictures of a finished run."""

from __future__ import annotations

from contextlib import nullcontext
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Annotated, Final

import typer

from softcat_sym import drawing
from softcat_sym.cli import application as cli
from softcat_sym.files import new_folder, write_results, written_together
from softcat_sym.interrupts import ending
from softcat_sym.lazy import lazy_imports
from softcat_sym.simulate import simulated

with lazy_imports():
    from softcat_sym.codegen import compiler
    from softcat_sym.plotting import animation, terminal
    from softcat_sym.plotting import style as styles
    from softcat_sym.plotting import vtk as paraview
    from softcat_sym.results import run as runs
    from softcat_sym.solvers import solution

_CANVAS: Final = "matplotlib.backends.backend_agg"
"""What all pictures are drawn with."""

AnimateOption = Annotated[
    cli.Text, cli.option("FILM", "Write a film of the filament into DIR: gif, mp4, or a name such as ink.gif.")
]
SecondsOption = Annotated[float, cli.option("SECONDS", "Length of the film.")]
RadiusOption = Annotated[float, cli.option("FACTOR", "Factor by which shapes are drawn thicker, to show beads.")]


def run(
    scene: cli.SceneArgument,
    output: Annotated[Path | None, cli.output_option("softcat-out/SCENE")] = None,
    changes: cli.SetOption = None,
    animate: AnimateOption = None,
    animate_seconds: SecondsOption = 8.0,
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
    plain = (animate, radius) == (None, 1.0)
    order = None if plain else _requested_pictures(animate, animate_seconds, radius)
    resolved, output = cli.scene_and_directory(scene, changes, output, "run")
    files, films = list[Path](), list[Path]()
    again = f"softcat draw {output} -o {output}"
    try:
        with terminal.IntegrationProgress(resolved.run.duration, quiet=quiet) as progress:
            progress.doing("reading")
            try:
                # Half a second of imports, while the solver is in C.
                with nullcontext() if no_pictures else compiler.beside(partial(import_module, _CANVAS)):
                    trajectory = simulated(resolved, progress, cli.print_error)
            except solution.Interrupted as stopped:
                # What there is, at once: pictures can be drawn of it later.
                trajectory, no_pictures, order = stopped.part(), True, None
                cli.print_error(f"{ending()}; what was computed is in {output}, its pictures are not: {again}")
            ending().no_limit()
            progress.stage("writing")
            # The numbers are written first, so that they remain after Ctrl-C during the drawing.
            trajectory, files = trajectory.written(output, trajectory.files())
            if not no_pictures:
                progress.stage("drawing pictures")
                report = drawing.report(trajectory, radius=radius)
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
        terminal.print_summary(trajectory.summary, resolved, (*films, *files), verbose=verbose)
    cli.judge(trajectory.outcome, trajectory.summary["message"], quiet=quiet)


def draw(
    trajectory: Annotated[
        Path, typer.Argument(metavar="TRAJECTORY", help="A trajectory.nc that softcat run wrote, or its folder.")
    ],
    output: cli.OutputOption = None,
    animate: AnimateOption = None,
    animate_seconds: SecondsOption = 8.0,
    radius: RadiusOption = 1.0,
    vtk: Annotated[
        bool, cli.switch("Write every frame for ParaView into DIR/vtk; this needs the extra fem.", "--vtk")
    ] = False,
    quiet: cli.QuietOption = False,
) -> None:
    """Draw a finished run again: thicker, as a film, or for ParaView.

    Nothing is solved. The pictures, the table and a film go to DIR (by default the folder of the run with -draw),
    with copies of the run's summary.json and scene.toml.
    """
    order = _requested_pictures(animate, animate_seconds, radius)
    if vtk:
        paraview.require_meshio()
    folder = trajectory.parent if trajectory.suffix == ".nc" else trajectory
    output = cli.output_directory(output, "draw", folder.resolve().name)
    finished = runs.open_run(trajectory)
    runs.check_drawable(finished)
    try:
        with new_folder(output), written_together():
            beside = {"summary.json": finished.summary, "scene.toml": finished.scene.to_toml()}
            files = write_results(output, {**drawing.report(finished, radius=radius).files, **beside})
            files += [] if order is None else [_film(order, output, finished, quiet=quiet)]
            files += paraview.write_run_vtk(finished, output / "vtk")[:1] if vtk else []
    except KeyboardInterrupt:
        raise cli.interrupted("nothing was written") from None
    if not quiet:
        cli.print_written(files, output)


def _requested_pictures(animate: str | None, seconds: float, radius: float) -> animation.FilmOrder | None:
    """Read the options of films and pictures; faults are refused before anything is computed."""
    styles.drawn_radius(radius)
    return None if animate is None else animation.film_order(animate, seconds)


def _film(order: animation.FilmOrder, output: Path, run: runs.Run, *, quiet: bool) -> Path:
    """Draw a film, with a progress bar on the terminal."""
    with terminal.StepProgress(order.pictures, "drawing", quiet=quiet) as progress:
        path, note = animation.write_film(order, output, (run.fields, run.summary, run.scene), progress.step)
    if note:
        cli.print_error(f"{path.name}: {note}")
    return path
