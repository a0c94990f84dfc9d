"""``softcat accuracy``: what accuracy costs in time, on this machine."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    INTERRUPTED,
    VALIDATION,
    OutputOption,
    QuietOption,
    SceneArgument,
    SetOption,
    app,
    print_error,
    scene_and_directory,
)

if TYPE_CHECKING:
    from softcat_sym.studies.work_precision import Plan

LimitOption = Annotated[
    float, typer.Option("--limit", metavar="SECONDS", min=0.01, help="An integration that takes longer is stopped.")
]
CellsOption = Annotated[
    str | None,
    typer.Option("--cells", metavar="N,N,...", help="Cells per half span.", show_default="10,20,40,60,100,200"),
]
ToleranceOption = Annotated[
    str | None,
    typer.Option("--rtol", metavar="X,X,...", help="Tolerances, loose to tight.", show_default="1e-2,...,1e-6"),
]
ProgramOption = Annotated[
    list[str] | None, typer.Option("--program", metavar="KEY", help="Only this program. Repeatable.")
]
WarmOption = Annotated[bool, typer.Option("--warm-only", help="Leave out cold starts.")]


@app.command(rich_help_panel=VALIDATION)
def accuracy(
    scene: SceneArgument,
    output: OutputOption = None,
    limit: LimitOption = 10.0,
    cells: CellsOption = None,
    rtol: ToleranceOption = None,
    program: ProgramOption = None,
    warm_only: WarmOption = False,
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
    from softcat_sym.studies.work_precision import study

    plan = _plan(cells, rtol, program, limit, cold=not warm_only)
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


def _plan(cells: str | None, rtol: str | None, program: list[str] | None, limit: float, *, cold: bool) -> Plan:
    """What the options ask for; what they leave out is as in the study."""
    from softcat_sym.studies.work_precision import CELLS, TOLERANCES, Plan
    from softcat_sym.studies.work_precision_programs import PROGRAMS

    keys = tuple(one.key for one in PROGRAMS)
    unknown = [key for key in program or () if key not in keys]
    if unknown:
        raise typer.BadParameter(f"{unknown[0]!r}; accepted: {', '.join(keys)}", param_hint="--program")
    grids = tuple(int(n) for n in _numbers(cells, "--cells", 4, 2000)) if cells else CELLS
    tolerances = _numbers(rtol, "--rtol", 1e-12, 0.5) if rtol else TOLERANCES
    return Plan(
        cells=tuple(sorted(set(grids))),
        tolerances=tuple(sorted(set(tolerances), reverse=True)),
        programs=tuple(key for key in keys if not program or key in program),
        limit=limit,
        cold=cold,
    )


def _numbers(text: str, name: str, least: float, most: float) -> tuple[float, ...]:
    try:
        values = tuple(float(part) for part in text.split(","))
    except ValueError:
        values = ()
    whole = name != "--cells" or all(value == round(value) for value in values)
    if not values or not whole or not all(least <= value <= most for value in values):
        what = "whole numbers" if name == "--cells" else "numbers"
        raise typer.BadParameter(
            f"{text!r}; accepted: {what} from {least:g} to {most:g}, with commas between", param_hint=name
        )
    return values
