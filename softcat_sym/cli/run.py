"""``softcat run``: one filament."""

from __future__ import annotations

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


@app.command()
def run(
    scene: SceneArgument,
    output: OutputOption,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Run a scene: trajectory.nc, summary.json, scene.toml, pictures and a table in DIR."""
    asked = scene_of(scene, changes)
    check_directory(output)
    from softcat_sym.report.progress import IntegrationProgress
    from softcat_sym.report.run_files import write_run
    from softcat_sym.simulate import simulate

    try:
        with IntegrationProgress(asked.run.duration, asked.title or "integrating", quiet=quiet) as progress:
            trajectory = simulate(asked, progress)
    except KeyboardInterrupt:
        complain("interrupted; nothing was written")
        raise typer.Exit(INTERRUPTED) from None
    written = write_run(trajectory, output)
    if not quiet:
        from softcat_sym.report.terminal import print_summary

        print_summary(written.summary, asked)
        typer.echo(f"wrote {', '.join(path.name for path in written.files)} to {output}")
    judge(trajectory.outcome, trajectory.summary["complaint"], quiet=quiet)
