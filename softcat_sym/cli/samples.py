"""``softcat samples``: files to try the commands with."""

from __future__ import annotations

from importlib.resources import files

import typer

from softcat_sym.cli.application import EVERYDAY, OutputOption, QuietOption, app, output_directory
from softcat_sym.cli.new import ForceOption, write_new


@app.command(rich_help_panel=EVERYDAY)
def samples(
    output: OutputOption = None,
    force: ForceOption = False,
    quiet: QuietOption = False,
) -> None:
    """Copy sample files: a scene, a film, a flow curve.

    my-ink.toml is an ink; film.csv a film of its fall across a wider gap, my-curve.csv its flow curve, both made by
    this package and made noisy, as their first lines say.
    """
    output = output_directory(output, "samples")
    folder = files("softcat_sym") / "samples"
    contents = {entry.name: entry.read_bytes() for entry in sorted(folder.iterdir(), key=lambda entry: entry.name)}
    write_new(output, contents, force=force)
    if not quiet:
        typer.echo(f"wrote {', '.join(contents)} to {output}")
