"""``softcat scenes``: the bundled scenes."""

from __future__ import annotations

import typer

from softcat_sym.cli.application import app


@app.command()
def scenes() -> None:
    """List the bundled scenes."""
    from softcat_sym.scene import bundled_names, bundled_title

    names = bundled_names()
    width = max(map(len, names))
    for name in names:
        typer.echo(f"{name:{width}}  {bundled_title(name)}")
