"""``softcat phase``: regimes over planes of dimensionless groups."""

from __future__ import annotations

import hashlib
import importlib.metadata
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    INTERRUPTED,
    VALIDATION,
    OutputOption,
    QuietOption,
    SetOption,
    app,
    print_error,
    scene_and_directory,
)
from softcat_sym.cli.sweep import ClusterOption, ResumeOption, SchedulerOption, WorkersOption

if TYPE_CHECKING:
    from softcat_sym.ensemble.block_store import KeptBlocks
    from softcat_sym.scene.scene import Scene

PlaneOption = Annotated[
    list[str] | None,
    typer.Option("--plane", metavar="NAME", help="G-delta or G-V. Repeatable; both by default."),
]
ResolutionOption = Annotated[
    int, typer.Option("--resolution", metavar="CELLS", help="Cells of the finest lattice along each axis.")
]


@app.command(rich_help_panel=VALIDATION)
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
    resume: ResumeOption = False,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Map the regimes over planes of dimensionless groups.

    Filaments are run over (G, delta) and (G, V): phase.json, pictures and tables in DIR.
    Only along boundaries the lattice is refined. A regime is what a run shows; a run that is no answer is a row and a
    mark of its own. Unless --set says otherwise, the physics is the paper's, the accuracy 1e-2, with 40 graded cells.
    Finished runs are kept in DIR/parts until all are there: an interrupted diagram goes on with --resume.
    """
    from softcat_sym.ensemble.block_store import kept_text
    from softcat_sym.ensemble.ensemble import MembersBar, NobodyListens
    from softcat_sym.plotting.phase import print_phase_diagram, write_phase_diagram
    from softcat_sym.studies.phase import SETTINGS, phase_diagram
    from softcat_sym.studies.phase_runs import PLANES

    asked, output = scene_and_directory(scene, changes, output, "phase", SETTINGS)
    planes = plane or list(PLANES)
    kept = _kept(asked, output, resume=resume)
    try:
        with nullcontext(NobodyListens()) if quiet else MembersBar("phase diagram") as bar:
            diagram = phase_diagram(
                asked,
                planes,
                resolution,
                workers=workers,
                scheduler=scheduler,
                local_cluster=local_cluster,
                kept=kept,
                progress=bar,
            )
        written = write_phase_diagram(diagram, output)
    except KeyboardInterrupt:
        print_error(f"interrupted; {kept_text(output) or 'nothing was written'}")
        raise typer.Exit(INTERRUPTED) from None
    kept.clear()
    if not quiet:
        print_phase_diagram(diagram)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")


def _kept(asked: Scene, output: Path, *, resume: bool) -> KeptBlocks:
    """The folder of the finished runs; which scene, and which program, is their owner."""
    from softcat_sym.ensemble.block_store import KeptBlocks

    version = importlib.metadata.version("softcat_sym")
    digest = hashlib.sha256(f"phase diagram\n{version}\n{asked.to_toml()}".encode()).hexdigest()
    return KeptBlocks(output, digest, {"what": "runs of phase diagrams", "title": asked.title}, resume=resume)
