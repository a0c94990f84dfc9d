"""``softcat accuracy``: what accuracy costs in time, on this machine."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli.application import (
    INTERRUPTED,
    VALIDATION,
    OutputOption,
    QuietOption,
    SceneArgument,
    SetOption,
    commands,
    print_error,
    scene_and_directory,
)

_CELLS, _TOLERANCES = "10,20,40,60,100,200", "1e-2,1e-3,1e-4,1e-5,1e-6"
_LIMIT = typer.Option(metavar="SECONDS", min=0.01, help="An integration that takes longer is stopped.")
_PROGRAM = typer.Option(metavar="KEY", help="Only this program. Repeatable.")


@commands.command(rich_help_panel=VALIDATION)
def accuracy(
    scene: SceneArgument,
    output: OutputOption = None,
    limit: Annotated[float, _LIMIT] = 10.0,
    cells: Annotated[str, typer.Option(metavar="N,N,...", help="Cells per half span.")] = _CELLS,
    rtol: Annotated[str, typer.Option(metavar="X,X,...", help="Tolerances, loose to tight.")] = _TOLERANCES,
    program: Annotated[list[str] | None, _PROGRAM] = None,
    warm_only: Annotated[bool, typer.Option("--warm-only", help="Leave out cold starts.")] = False,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Measure what accuracy costs with every integrator.

    DIR gets accuracy.csv, accuracy.json and accuracy.png.
    The error is of space and time together, against a converged answer in which two families of methods agree. What
    takes longer than the limit, or cannot solve the scene, is listed. It takes minutes, and begins anew each time.
    """
    from softcat_sym.plotting.accuracy import print_accuracy, write_accuracy
    from softcat_sym.plotting.terminal import StepProgress
    from softcat_sym.studies.work_precision import Plan, study
    from softcat_sym.studies.work_precision_programs import PROGRAMS

    keys = tuple(each.key for each in PROGRAMS)
    if unknown := [key for key in program or () if key not in keys]:
        raise typer.BadParameter(f"{unknown[0]!r}; accepted: {', '.join(keys)}", param_hint="--program")
    plan = Plan(
        cells=tuple(sorted({int(n) for n in _numbers(cells, "--cells", 4, 2000)})),
        tolerances=tuple(sorted(set(_numbers(rtol, "--rtol", 1e-12, 0.5)), reverse=True)),
        programs=tuple(key for key in keys if not program or key in program),
        limit=limit,
        cold=not warm_only,
    )
    asked, output = scene_and_directory(scene, changes, output, "accuracy")
    try:
        with StepProgress(plan.max_steps, "accuracy", quiet=quiet) as progress:
            found = study(scene, asked, plan, progress.step)
    except KeyboardInterrupt:
        print_error("interrupted; nothing was written")
        raise typer.Exit(INTERRUPTED) from None
    written = write_accuracy(found, output)
    if not quiet:
        print_accuracy(found)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")


def _numbers(text: str, name: str, low: float, high: float) -> tuple[float, ...]:
    try:
        values = tuple(float(part) for part in text.split(","))
    except ValueError:
        values = ()
    whole = name != "--cells" or all(value == round(value) for value in values)
    if not values or not whole or not all(low <= value <= high for value in values):
        what = "whole numbers" if name == "--cells" else "numbers"
        raise typer.BadParameter(
            f"{text!r}; accepted: {what} from {low:g} to {high:g}, with commas between", param_hint=name
        )
    return values
