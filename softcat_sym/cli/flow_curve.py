"""``softcat flow-curve``: fit of a material to a rheometer's flow curve."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.cli.completing import complete_scene
from softcat_sym.lazy import lazy_imports

with lazy_imports():
    from softcat_sym.fitting import flow_curve as curves


def flow_curve(
    curve: Annotated[
        str, typer.Argument(metavar="CSV", help="CSV file with columns shear_rate_1_s and shear_stress_Pa.")
    ],
    scene: Annotated[
        cli.Text, cli.option("SCENE", "Scene to write with the fitted material.", autocompletion=complete_scene)
    ] = None,
    law: Annotated[cli.Text, cli.option("LAW", "Take this law instead of the best, such as herschel-bulkley.")] = None,
    sample: Annotated[cli.Text, cli.option("NAME", "Sample to fit, where a column sample_id names several.")] = None,
    output: cli.OutputOption = None,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Fit a law to a rheometer's flow curve.

    DIR gets flow_curve.json, a picture and a table; with --scene also scene.toml, that scene with the fitted material.
    """
    if changes and scene is None:
        raise typer.BadParameter("--set changes a scene: name one with --scene", param_hint="--set")
    fit = curves.fit_flow_curve(curve, sample)
    handed_on = None if scene is None else curves.fitted_scene(fit, scene, law, changes or [])
    output = cli.output_directory(output, "flow-curve", scene, handed_on)
    cli.present(fit, output, quiet=quiet, law=law, scene=handed_on)
