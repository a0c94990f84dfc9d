"""``softcat show``: a scene as the program understands it."""

from __future__ import annotations

import typer

from softcat_sym.cli.application import EVERYDAY, SceneArgument, SetOption, app, scene_of


@app.command(rich_help_panel=EVERYDAY)
def show(scene: SceneArgument, changes: SetOption = None) -> None:
    """Print a scene as resolved, with every default.

    TOML in SI units, which is a scene again: softcat show ink-bridge > my-ink.toml
    """
    from softcat_sym.scene.toml import toml_of

    typer.echo(toml_of(scene_of(scene, changes), every_default=True), nl=False)
