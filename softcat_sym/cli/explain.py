"""``softcat explain``: what a scene calls for, before it is run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli.application import (
    EVERYDAY,
    QuietOption,
    SceneArgument,
    SetOption,
    VerboseOption,
    app,
    directory,
    scene_and_directory,
    scene_of,
)


@app.command(rich_help_panel=EVERYDAY)
def explain(
    scene: SceneArgument,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="DIR", help="Write explain.json, equations.tex, scene.toml.", parser=directory
        ),
    ] = None,
    changes: SetOption = None,
    verbose: VerboseOption = False,
    quiet: QuietOption = False,
) -> None:
    """Say what a scene calls for, before it is run.

    Its groups, regime, each effect in or out and why, equations, size and limits.
    """
    if output is None:
        asked = scene_of(scene, changes)
    else:
        asked, output = scene_and_directory(scene, changes, output, "explain")
    from softcat_sym.plotting.explain import print_explanation, write_explanation
    from softcat_sym.studies.explanation import explain as explained

    explanation = explained(asked)
    written = [] if output is None else write_explanation(explanation, asked, output)
    if not quiet:
        print_explanation(explanation, verbose=verbose)
        if written:
            typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
