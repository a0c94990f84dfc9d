"""``softcat material``: the table [material] of a scene from a rheometer's files."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.cli.completing import complete_scene
from softcat_sym.lazy import lazy_imports

with lazy_imports():
    from softcat_sym.fitting import rheometer


def material(
    files: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE...", help="Tables of a flow curve, an amplitude sweep, a frequency sweep, a recovery test."
        ),
    ],
    scene: Annotated[
        cli.Text, cli.option("SCENE", "Scene to write with this material.", autocompletion=complete_scene)
    ] = None,
    law: Annotated[cli.Text, cli.option("LAW", "Law of the flow curve in place of the best: herschel-bulkley.")] = None,
    sample: Annotated[cli.Text, cli.option("NAME", "Sample to take, where a column sample_id names several.")] = None,
    output: cli.OutputOption = None,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Make the table [material] of a scene from a rheometer's files.

    Which test a file is, its columns say. DIR gets material.toml, material.json and a picture; with --scene also
    scene.toml, that scene with this material. What no file determines is named, with the test that would.
    """
    if changes and scene is None:
        raise typer.BadParameter("--set changes a scene: name one with --scene", param_hint="--set")
    found = rheometer.read_material(files, law, sample)
    handed_on = None if scene is None else found.scene(scene, changes or [])
    output = cli.output_directory(output, "material", scene, handed_on)
    cli.present(found, output, quiet=quiet, scene=handed_on)
