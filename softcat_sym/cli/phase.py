"""``softcat phase``: regimes over planes of dimensionless groups."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli.application import (
    FreshOption,
    OutputOption,
    QuietOption,
    SetOption,
    commands,
    scene_and_directory,
    study,
)
from softcat_sym.cli.sweep import ClusterOption, SchedulerOption, WorkersOption

PlaneOption = Annotated[
    list[str] | None,
    typer.Option("--plane", metavar="NAME", help="Plane of groups: G-delta or G-V. Repeatable; both by default."),
]
ResolutionOption = Annotated[
    int, typer.Option("--resolution", metavar="CELLS", help="Cells of the finest lattice along each axis.")
]


@commands.command()
def phase(
    scene: Annotated[
        str, typer.Argument(metavar="[SCENE]", help="Name of a bundled scene, or path of a TOML file.")
    ] = "arrested-overdamped",
    output: OutputOption = None,
    plane: PlaneOption = None,
    resolution: ResolutionOption = 40,
    workers: WorkersOption = None,
    scheduler: SchedulerOption = None,
    local_cluster: ClusterOption = None,
    fresh: FreshOption = False,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Map the regimes over planes of dimensionless groups.

    Filaments are run over (G, delta) and (G, V); DIR gets phase.json, pictures and tables.
    The lattice is refined along boundaries only. The regimes are those of the runs; a run without a sound answer has a
    row and a mark of its own. Unless --set says otherwise, the physics is the paper's, the accuracy is 1e-2 and the
    filament has 40 graded cells. After Ctrl-C the same command resumes from the finished runs.
    """
    from softcat_sym.batch.phase_runs import PLANES
    from softcat_sym.plotting.phase import print_phase_diagram, write_phase_diagram
    from softcat_sym.progress import MembersBar
    from softcat_sym.studies.phase import SETTINGS, phase_diagram

    asked, output = scene_and_directory(scene, changes, output, "phase", SETTINGS)
    planes = plane or list(PLANES)
    with study(output, fresh=fresh):
        with MembersBar("phase diagram", quiet=quiet) as bar:
            diagram = phase_diagram(
                asked,
                planes,
                resolution,
                workers=workers,
                scheduler=scheduler,
                local_cluster=local_cluster,
                progress=bar,
            )
        written = write_phase_diagram(diagram, output)
    if not quiet:
        print_phase_diagram(diagram)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
