"""``softcat phase``: regimes over planes of dimensionless groups."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.cli.sweep import WorkersOption
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import MembersBar

with lazy_imports():
    from softcat_sym.studies import phase as study
    from softcat_sym.studies import phase_runs


def phase(
    scene: Annotated[
        str, typer.Argument(metavar="[SCENE]", help="Name of a bundled scene, or path of a TOML file.")
    ] = "arrested-overdamped",
    output: cli.OutputOption = None,
    plane: Annotated[
        cli.Texts, cli.option("NAME", "Plane of groups: G-delta or G-V. Repeatable; both by default.")
    ] = None,
    resolution: Annotated[int, cli.option("CELLS", "Cells of the finest lattice along each axis.")] = 40,
    workers: WorkersOption = None,
    fresh: cli.FreshOption = False,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Map the regimes over planes of dimensionless groups.

    Filaments are run over (G, delta) and (G, V); DIR gets phase.json, pictures and tables.
    The lattice is refined along boundaries only. The regimes are those of the runs; a run without a sound answer has a
    row and a mark of its own. Unless --set says otherwise, the physics is the paper's, the accuracy is 1e-2 and the
    filament has 40 graded cells. After Ctrl-C the same command resumes from the finished runs.
    """
    resolved, output = cli.scene_and_directory(scene, changes, output, "phase", study.SETTINGS)
    planes = plane or list(phase_runs.PLANES)
    with cli.study(fresh=fresh), MembersBar("phase diagram", quiet=quiet) as bar:
        diagram = study.phase_diagram(resolved, planes, resolution, workers=workers, progress=bar)
    cli.present(diagram, output, quiet=quiet)
