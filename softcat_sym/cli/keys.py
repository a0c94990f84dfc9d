"""``softcat keys``: what a scene may hold."""

from __future__ import annotations

import textwrap
from typing import Annotated

import typer

from softcat_sym.cli.application import EVERYDAY, app
from softcat_sym.errors import SoftcatError

_WIDTH = 80


@app.command(rich_help_panel=EVERYDAY)
def keys(
    part: Annotated[
        str, typer.Argument(metavar="[PART]", help="Only keys with this in their names: material, or stress.")
    ] = "",
    markdown: Annotated[bool, typer.Option("--markdown", help="Print the page of the manual instead.")] = False,
) -> None:
    """List the keys of a scene: unit, default and meaning.

    Given a PART of their names, also what each accepts.
    """
    from softcat_sym.scene.keys import keys_in_markdown, scene_keys

    if markdown:
        typer.echo(keys_in_markdown(), nl=False)
        return
    found = scene_keys(part)
    if not found:
        tables = sorted({key.path.split(".")[0] for key in scene_keys()})
        raise SoftcatError(f"no key has {part!r} in its name; tables and keys outside them: {', '.join(tables)}")
    for key in found:
        default = key.default if key.default in ("", "required") else f"default {key.default}"
        typer.echo("  ".join(word for word in (key.path, key.unit and f"[{key.unit}]", default) if word))
        told = [key.meaning, *([f"Accepted: {key.accepted}."] if part else [])]
        for sentence in told:
            typer.echo(textwrap.fill(sentence, _WIDTH, initial_indent="    ", subsequent_indent="    "))
