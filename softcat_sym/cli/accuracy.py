"""``softcat accuracy``: computing time over accuracy, on this machine."""

from __future__ import annotations

from typing import Annotated

from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import Display

with lazy_imports():
    from softcat_sym.studies import integrators, work_precision


def accuracy(
    scene: cli.SceneArgument,
    output: cli.OutputOption = None,
    everything: Annotated[
        bool, cli.switch("Measure every integrator of the package, and every rival.", "--all")
    ] = False,
    limit: Annotated[
        cli.Number,
        cli.option(
            "SECONDS",
            "Time for all measurements; those that do not finish in this time are left out.",
            min=0.1,
            show_default="45, with --all 600",
        ),
    ] = None,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Measure time over accuracy, against IDAS and SciPy's Radau.

    DIR gets accuracy.csv, accuracy.json and accuracy.png.
    The error is that of grid and time steps together, against an answer that is extrapolated from the finest grids and
    confirmed by a rival. The programs share the time; measurements that are cut off are listed. Nothing comes from the
    store.
    """
    resolved, output = cli.scene_and_directory(scene, changes, output, "accuracy")
    methods = integrators.METHODS if everything else integrators.RIVALS
    limit = limit or (work_precision.LIMIT_OF_ALL if everything else work_precision.LIMIT)
    try:
        with Display(quiet=quiet) as progress:
            progress.stage("accuracy")
            found = work_precision.study(
                scene, resolved, methods, limit, lambda what, share: progress.reach(share, what)
            )
    except KeyboardInterrupt:
        raise cli.interrupted("nothing was written") from None
    cli.present(found, output, quiet=quiet)
