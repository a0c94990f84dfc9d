"""``softcat generate``: the compiled solver of a scene as files to take away."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli.application import (
    INTERRUPTED,
    OptionalScene,
    OutputOption,
    QuietOption,
    SetOption,
    commands,
    output_directory,
    print_error,
    scene_and_directory,
)


@commands.command()
def generate(
    scene: OptionalScene = None,
    output: OutputOption = None,
    bundled: Annotated[
        bool, typer.Option("--bundled", help="The structures of the bundled scenes instead, one runtime for all.")
    ] = False,
    changes: SetOption = None,
    rhs: Annotated[
        bool, typer.Option("--rhs", help="Add right-hand side and sparse Jacobian, for an integrator of your own.")
    ] = False,
    name: Annotated[
        str, typer.Option("--name", metavar="NAME", help="Of the C file and of what it exports: one for each filament.")
    ] = "filament",
    quiet: QuietOption = False,
) -> None:
    """Write the solver of a scene as C99 to take away.

    DIR gets sources without Python, a program, parameters.txt, a Makefile and a README.
    """
    if bundled is (scene is not None):
        raise typer.BadParameter("name one scene, or ask for --bundled, not both", param_hint="SCENE")
    if bundled and (changes or rhs or name != "filament"):
        raise typer.BadParameter("--bundled goes with neither --set nor --rhs nor --name", param_hint="--bundled")
    try:
        if scene is None:
            output = output_directory(output, "generate")
            from softcat_sym import generation
            from softcat_sym.plotting.terminal import StepProgress
            from softcat_sym.scene.bundled import bundled_names

            with StepProgress(len(bundled_names()), "bundled scenes", quiet=quiet) as progress:
                written = generation.write(output, progress.step)
        else:
            asked, output = scene_and_directory(scene, changes, output, "generate")
            from softcat_sym import generation

            written = generation.generate(asked, output, rhs, name)
    except KeyboardInterrupt:
        print_error("interrupted; nothing was written; C texts that were made by then are kept in the cache")
        raise typer.Exit(INTERRUPTED) from None
    if not quiet:
        size = sum(path.stat().st_size for path in written)
        typer.echo(f"wrote {len(written)} files, {size / 1000:.0f} kB, to {output}")
        if not bundled:
            typer.echo(f"next: make -C {output} && {output}/{name} {output}/parameters.txt -o midpoint.csv")
