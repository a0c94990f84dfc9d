"""``softcat sweep``: a filament for every value of some parameters."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli.application import (
    UNTRUSTED,
    FreshOption,
    OutputOption,
    QuietOption,
    SceneArgument,
    SetOption,
    commands,
    print_error,
    scene_and_directory,
    study,
)
from softcat_sym.cli.completing import complete_change
from softcat_sym.errors import SoftcatError

VaryOption = Annotated[
    list[str] | None,
    typer.Option(
        "--vary",
        metavar="KEY=VALUES",
        help="KEY=a:b:n, KEY=a:b:n:log, or KEY=v1,v2,v3; units as in the scene: 'filament.span=5:50 mm:10'. "
        "With --mode lhs, KEY=a:b is enough. Repeatable.",
        autocompletion=complete_change,
    ),
]
ModeOption = Annotated[
    str,
    typer.Option(
        "--mode",
        metavar="MODE",
        help="Combination of the values: grid, all; zip, side by side; lhs, a Latin hypercube.",
    ),
]
TableOption = Annotated[
    Path | None,
    typer.Option(
        "--from-csv",
        metavar="FILE",
        help="Table with one member a row; its header names the keys: 'filament.span [mm]'.",
    ),
]
WorkersOption = Annotated[
    int | None, typer.Option("--workers", metavar="THREADS", help="Number of threads; by default one for each core.")
]
SchedulerOption = Annotated[
    str | None, typer.Option("--scheduler", metavar="ADDRESS", help="Run on this Dask cluster: tcp://host:8786.")
]
ClusterOption = Annotated[
    int | None, typer.Option("--local-cluster", metavar="N", help="Start a Dask cluster of N processes, and run on it.")
]


@commands.command()
def sweep(
    scene: SceneArgument,
    output: OutputOption = None,
    vary: VaryOption = None,
    mode: ModeOption = "grid",
    table: TableOption = None,
    samples: Annotated[
        int | None, typer.Option("--samples", metavar="N", help="Number of members of a hypercube.")
    ] = None,
    seed: Annotated[int, typer.Option("--seed", metavar="S", help="Seed of the hypercube.")] = 0,
    shapes: Annotated[bool, typer.Option("--shapes", help="Store the shapes, and write sliders.html.")] = False,
    estimate: Annotated[
        bool,
        typer.Option("--estimate", help="Estimate the error of each member, as softcat run does: much slower."),
    ] = False,
    workers: WorkersOption = None,
    scheduler: SchedulerOption = None,
    local_cluster: ClusterOption = None,
    fresh: FreshOption = False,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Simulate a filament for every value of some parameters.

    DIR gets sweep.nc, sweep.csv, sweep.json, scene.toml and a picture.
    The member in the middle of the ranges is run as by `softcat run`: its error is estimated and its grid refined. All
    others run once, in threads, at least as finely. --estimate estimates the error of each member, --set
    numerics.estimate=false that of none. A member that cannot be run, or that has no sound answer, is a row like the
    others. The memory needed does not grow with the number of members. Fewer frames make a sweep faster: --set
    run.frames=41. After Ctrl-C the same command resumes from the finished members.
    """
    from softcat_sym.batch.executor import Where
    from softcat_sym.batch.plan import plan_sweep
    from softcat_sym.batch.sweep import run_sweep
    from softcat_sym.plotting.sweep import print_sweep, write_sweep
    from softcat_sym.progress import MembersBar

    where = Where(workers, scheduler, local_cluster)
    if (table is None) is not bool(vary):
        raise SoftcatError("say what varies by --vary KEY=VALUES or by --from-csv FILE, and not by both")
    base, output = scene_and_directory(scene, changes, output, "sweep")
    plan = plan_sweep(base, table or vary or [], mode, samples=samples, seed=seed, shapes=shapes, estimate=estimate)
    with study(output, fresh=fresh):
        with MembersBar("sweep", quiet=quiet) as bar:
            done = run_sweep(plan, output, where, bar)
        written = write_sweep(done, output)
    if not quiet:
        print_sweep(done)
        names = ["sweep.nc", "sweep.csv", *(path.name for path in written)]
        typer.echo(f"wrote {', '.join(names)} to {output}")
    if not done.counts.outcomes.get("solved"):
        print_error("no member is an answer; sweep.csv has the reason of each")
        raise typer.Exit(UNTRUSTED)
