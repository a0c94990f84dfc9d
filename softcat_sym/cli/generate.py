"""``softcat generate``: the solver of a scene as C sources or as a web page."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.bundled import bundled_names

with lazy_imports():
    from softcat_sym import generation
    from softcat_sym.plotting import terminal
    from softcat_sym.web import page as pages

_NAME = "filament"


def generate(
    scene: cli.OptionalScene = None,
    output: cli.OutputOption = None,
    bundled: Annotated[
        bool, cli.switch("Write the C of all bundled scenes instead, with one runtime for all.", "--bundled")
    ] = False,
    changes: cli.SetOption = None,
    rhs: Annotated[
        bool, cli.switch("Add the right-hand side and its sparse Jacobian, for an integrator of your own.", "--rhs")
    ] = False,
    static: Annotated[
        bool, cli.switch("Add the solver in memory of fixed size for one grid, and print what it takes.", "--static")
    ] = False,
    fmu: Annotated[
        bool, cli.switch("Add NAME.fmu, FMI 3.0 for co-simulation, with sources and binaries.", "--fmu")
    ] = False,
    simulink: Annotated[bool, cli.switch("Add a C MEX S-function for Simulink.", "--simulink")] = False,
    name: Annotated[
        str, cli.option("NAME", "Name of the C file and of its functions, where a program holds several filaments.")
    ] = _NAME,
    web: Annotated[
        bool, cli.switch("Write a page NAME.html instead, with sliders, that solves the scene in a browser.", "--web")
    ] = False,
    sliders: Annotated[
        cli.Texts,
        cli.option(
            "KEY=LOW:HIGH[:log]", "With --web: a slider for one more key, or another range. Repeatable.", "--slider"
        ),
    ] = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Write the solver of a scene as C99, or as a web page with sliders.

    DIR gets sources that need no Python, a program, parameters.txt, a Makefile and a README; and NAME.py, the solver as
    a class that needs NumPy and a C compiler alone. The command first runs the scene: cells, fibres and tolerances are
    the final ones of `softcat run`; --set numerics.estimate=false skips this run. With --web DIR gets one HTML file
    that needs no server and no network. Making it needs a compiler for WebAssembly: pip install "softcat_sym[web]".
    """
    asked = {"static": static, "fmu": fmu, "simulink": simulink}
    forms, notes = [form for form, is_asked in asked.items() if is_asked], list[str]()
    own = bool(changes or rhs or forms or web or sliders or name != _NAME)
    _refuse_together(scene, bundled=bundled, own=own, web=web, rhs=rhs or bool(forms))
    if sliders and not web:
        raise typer.BadParameter("sliders belong to a page: add --web", param_hint="--slider")
    try:
        if scene is None:
            output = cli.output_directory(output, "generate")
            with terminal.StepProgress(len(bundled_names()), "bundled scenes", quiet=quiet) as steps:
                written = generation.write(output, steps.step)
        else:
            resolved, output = cli.scene_and_directory(scene, changes, output, "generate")
            if web:
                page = name if name != _NAME else Path(scene).stem
                with terminal.StepProgress(pages.STEPS, "a live page", quiet=quiet) as steps:
                    written = [pages.live_page(resolved, output, sliders or (), page, steps.step)]
            else:
                with terminal.IntegrationProgress(resolved.run.duration, quiet=quiet) as progress:
                    written = generation.generate(
                        resolved, output, rhs, name, progress, forms=forms, on_note=notes.append
                    )
    except KeyboardInterrupt:
        raise cli.interrupted("nothing was written; finished C texts are kept in the cache") from None
    if quiet:
        return
    size = sum(path.stat().st_size for path in written)
    typer.echo(f"wrote {len(written)} file{'s' * (len(written) != 1)}, {size / 1000:.0f} kB, to {output}")
    for note in notes:
        typer.echo(note)
    if not bundled:
        made = f"make -C {output} && {output}/{name} {output}/parameters.txt -o midpoint.csv"
        typer.echo(f"next: {f'open {written[0]} in a browser' if web else made}")


def _refuse_together(scene: str | None, *, bundled: bool, own: bool, web: bool, rhs: bool) -> None:
    """Refuse options that do not go together."""
    if bundled is (scene is not None):
        raise typer.BadParameter("name one scene, or ask for --bundled, not both", param_hint="SCENE")
    if bundled and own:
        raise typer.BadParameter("--bundled takes no option of a single scene", param_hint="--bundled")
    if web and rhs:
        raise typer.BadParameter("a page comes alone, without --rhs, --static, --fmu, --simulink", param_hint="--web")
