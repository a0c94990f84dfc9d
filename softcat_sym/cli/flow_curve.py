"""``softcat flow-curve``: fit of a material to a rheometer's flow curve."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli.application import OutputOption, QuietOption, SetOption, commands, output_directory
from softcat_sym.cli.completing import complete_scene


@commands.command("flow-curve")
def flow_curve(
    curve: Annotated[
        str, typer.Argument(metavar="CSV", help="CSV file with columns shear_rate_1_s and shear_stress_Pa.")
    ],
    scene: Annotated[
        str | None,
        typer.Option(
            "--scene",
            metavar="SCENE",
            help="Scene to write with the fitted material.",
            autocompletion=complete_scene,
        ),
    ] = None,
    law: Annotated[
        str | None,
        typer.Option(
            "--law",
            metavar="LAW",
            help="Take this law instead of the best, such as herschel-bulkley.",
        ),
    ] = None,
    sample: Annotated[
        str | None,
        typer.Option("--sample", metavar="NAME", help="Sample to fit, where a column sample_id names several."),
    ] = None,
    output: OutputOption = None,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Fit a law to a rheometer's flow curve.

    DIR gets flow_curve.json, a picture and a table; with --scene also scene.toml, that scene with the fitted material.
    """
    if changes and scene is None:
        raise typer.BadParameter("--set changes a scene: name one with --scene", param_hint="--set")
    from softcat_sym.fitting.flow_curve import fit_flow_curve, fitted_scene
    from softcat_sym.plotting.flow_curve import print_flow_curve, write_flow_curve

    fit = fit_flow_curve(curve, sample)
    handed_on = None if scene is None else fitted_scene(fit, scene, law, changes or [])
    output = output_directory(output, "flow-curve", scene, handed_on)
    written = write_flow_curve(fit, output, law, handed_on)
    if not quiet:
        print_flow_curve(fit)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
