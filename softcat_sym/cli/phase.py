"""``softcat phase``: regimes over planes of dimensionless groups."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli.application import (
    INTERRUPTED,
    OutputOption,
    QuietOption,
    SetOption,
    app,
    check_directory,
    complain,
    scene_of,
)


@app.command()
def phase(
    output: OutputOption,
    scene: Annotated[
        str, typer.Argument(metavar="[SCENE]", help="Name of a bundled scene, or path of a TOML file.")
    ] = "arrested-overdamped",
    plane: Annotated[
        list[str] | None,
        typer.Option("--plane", metavar="NAME", help="G-delta or G-V. Repeatable; both by default."),
    ] = None,
    resolution: Annotated[
        int, typer.Option("--resolution", metavar="CELLS", help="Cells of the finest lattice along each axis.")
    ] = 40,
    workers: Annotated[
        int | None, typer.Option("--workers", metavar="THREADS", help="Threads; as many as there are cores by default.")
    ] = None,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Run filaments over (G, delta) and (G, V) and map their regimes: phase.json, pictures and tables in DIR.

    Only along boundaries the lattice is refined. A regime is what a run shows; a run that is no answer is a row and a
    mark of its own. Unless --set says otherwise, the physics is the paper's, the accuracy 1e-2, with 40 graded cells.
    """
    check_directory(output)
    from softcat_sym.ensemble import MembersBar
    from softcat_sym.ensemble.progress import NobodyListens
    from softcat_sym.report.phase_files import write_phase_diagram
    from softcat_sym.report.phase_terminal import print_phase_diagram
    from softcat_sym.study.phase_diagram import SETTINGS, phase_diagram
    from softcat_sym.study.phase_plane import PLANES

    asked = scene_of(scene, [*SETTINGS, *(changes or [])])
    planes = plane or list(PLANES)
    try:
        if quiet:
            diagram = phase_diagram(asked, planes, resolution, workers=workers, progress=NobodyListens())
        else:
            with MembersBar("phase diagram") as bar:
                diagram = phase_diagram(asked, planes, resolution, workers=workers, progress=bar)
        written = write_phase_diagram(diagram, output)
    except KeyboardInterrupt:
        complain("interrupted; nothing was written")
        raise typer.Exit(INTERRUPTED) from None
    if not quiet:
        print_phase_diagram(diagram)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
