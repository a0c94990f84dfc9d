"""``softcat sweep``: a filament for every value of some parameters."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.cli.completing import complete_change
from softcat_sym.errors import SoftcatError
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import MembersBar

with lazy_imports():
    from softcat_sym.batch import executor
    from softcat_sym.batch import plan as plans
    from softcat_sym.batch import sweep as batch

WorkersOption = Annotated[int | None, cli.option("THREADS", "Number of threads; by default one for each core.")]


def sweep(
    scene: cli.SceneArgument,
    output: cli.OutputOption = None,
    vary: Annotated[
        cli.Texts,
        cli.option(
            "KEY=VALUES",
            "KEY=a:b:n, KEY=a:b:n:log, or KEY=v1,v2,v3; units as in the scene: 'filament.span=5:50 mm:10'. "
            "With --mode lhs, KEY=a:b is enough. Repeatable.",
            autocompletion=complete_change,
        ),
    ] = None,
    mode: Annotated[
        str, cli.option("MODE", "Combination of the values: grid, all; zip, side by side; lhs, a Latin hypercube.")
    ] = "grid",
    table: Annotated[
        Path | None,
        cli.option(
            "FILE", "Table with one member a row; its header names the keys: 'filament.span [mm]'.", "--from-csv"
        ),
    ] = None,
    samples: Annotated[int | None, cli.option("N", "Number of members of a hypercube.")] = None,
    seed: Annotated[int, cli.option("S", "Seed of the hypercube.")] = 0,
    estimate: Annotated[
        bool, cli.switch("Estimate the error of each member, as softcat run does: much slower.", "--estimate")
    ] = False,
    workers: WorkersOption = None,
    fresh: cli.FreshOption = False,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Simulate a filament for every value of some parameters.

    DIR gets sweep.nc, sweep.csv, sweep.json, scene.toml and a picture.
    The member in the middle of the ranges is run as by `softcat run`: its error is estimated and its grid refined. All
    others run once, in threads, at least as finely. --estimate estimates the error of each member, --set
    numerics.estimate=false that of none. A member that cannot be run, or that has no sound answer, is a row like the
    others. Fewer frames make a sweep faster: --set run.frames=41. After Ctrl-C the same command resumes from the
    finished members.
    """
    executor.check_workers(workers, None)
    if (table is None) is not bool(vary):
        raise SoftcatError("say what varies by --vary KEY=VALUES or by --from-csv FILE, and not by both")
    base, output = cli.scene_and_directory(scene, changes, output, "sweep")
    plan = plans.plan_sweep(base, table or vary or [], mode, samples=samples, seed=seed, estimate=estimate)
    with cli.study(fresh=fresh), MembersBar("sweep", quiet=quiet) as bar:
        done = batch.run_sweep(plan, bar, workers)
    cli.present(done, output, quiet=quiet)
    if not done.outcomes["solved"]:
        first = next(filter(None, done.data.message.values), "")
        cli.print_error(f"no member is an answer; sweep.csv has the reason of each, the first: {first}")
        raise typer.Exit(cli.UNTRUSTED)
