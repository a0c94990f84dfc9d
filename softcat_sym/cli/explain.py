"""``softcat explain``: what a scene calls for, before it is run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli.application import QuietOption, SceneArgument, SetOption, app, check_directory, directory, scene_of


@app.command()
def explain(
    scene: SceneArgument,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="DIR", help="Write explain.json, equations.tex, scene.toml.", parser=directory
        ),
    ] = None,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Say what a scene calls for: groups, regime, each effect in or out and why, equations, size, limits."""
    asked = scene_of(scene, changes)
    if output is not None:
        check_directory(output)
    from softcat_sym.report.explain import print_explanation, write_explanation
    from softcat_sym.study.explanation import explain as explained

    explanation = explained(asked)
    written = [] if output is None else write_explanation(explanation, asked, output)
    if not quiet:
        print_explanation(explanation)
        if written:
            typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
