"""``softcat run``: one filament."""

from __future__ import annotations

import importlib.metadata
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    INTERRUPTED,
    OutputOption,
    QuietOption,
    SceneArgument,
    SetOption,
    app,
    check_directory,
    complain,
    judge,
    scene_of,
)

if TYPE_CHECKING:
    from softcat_sym.scene import Scene
    from softcat_sym.solve.checkpoint import Checkpoints

_FOLDER = "checkpoint"

ResumeOption = Annotated[
    bool,
    typer.Option("--resume", help="Go on from where the same command was interrupted; states are in DIR/checkpoint."),
]


@app.command()
def run(
    scene: SceneArgument,
    output: OutputOption,
    changes: SetOption = None,
    resume: ResumeOption = False,
    quiet: QuietOption = False,
) -> None:
    """Run a scene: trajectory.nc, summary.json, scene.toml, pictures and a table in DIR.

    A run of more than five seconds keeps what it has reached in DIR/checkpoint until its answer is written.
    """
    asked = scene_of(scene, changes)
    check_directory(output)
    checkpoints = _checkpoints(asked, output, resume=resume)
    from softcat_sym.files import made, written_together
    from softcat_sym.report.progress import IntegrationProgress
    from softcat_sym.report.run_files import write_run
    from softcat_sym.simulate import simulate
    from softcat_sym.solve.checkpoint import Resumable

    try:
        with IntegrationProgress(asked.run.duration, asked.title or "integrating", quiet=quiet) as progress:
            trajectory = simulate(asked, Resumable(progress, checkpoints))
        with made(output), written_together():
            written = write_run(trajectory, output)
    except KeyboardInterrupt:
        complain(f"interrupted; {_kept(checkpoints)}")
        raise typer.Exit(INTERRUPTED) from None
    except OSError:
        if checkpoints.kept or checkpoints.resumed:
            complain(_kept(checkpoints))
        raise
    checkpoints.clear()
    if not quiet:
        from softcat_sym.report.terminal import print_summary

        print_summary(written.summary, asked)
        if resume:
            typer.echo(_resumed(checkpoints))
        typer.echo(f"wrote {', '.join(path.name for path in written.files)} to {output}")
    judge(trajectory.outcome, trajectory.summary["complaint"], quiet=quiet)


def _checkpoints(asked: Scene, output: Path, *, resume: bool) -> Checkpoints:
    """The folder of the states of this run; what it is asked, and of which program, is its owner."""
    from softcat_sym.solve.checkpoint import Checkpoints

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
