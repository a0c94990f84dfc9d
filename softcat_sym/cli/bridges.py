"""``softcat bridges``: sag against the length of a bridge, for a slicer."""

from __future__ import annotations

from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.cli.sweep import WorkersOption
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import MembersBar

with lazy_imports():
    from softcat_sym.design import bridges as design


def bridges(
    scene: cli.SceneArgument,
    lengths: Annotated[str, cli.option("a:b:n", "Lengths of the bridges: '2mm:20mm:10', or '5 mm, 8 mm'.")],
    max_sag: cli.MaxSagOption = "5 %",
    output: cli.OutputOption = None,
    workers: WorkersOption = None,
    fresh: cli.FreshOption = False,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Tabulate the sag of bridges of several lengths, for a slicer.

    Each has its sag with an error, the time at which it has settled, and whether it is within the limit. DIR gets
    bridges.csv, bridges.json, bridges.png, scene.toml, and the fields of two slicers as key = value: orcaslicer.txt,
    superslicer.ini.
    """
    asked, output = cli.scene_and_directory(scene, changes, output, "bridges")
    with cli.study(fresh=fresh), MembersBar("bridges", quiet=quiet) as bar:
        found = design.bridges(asked, lengths, max_sag, workers=workers, progress=bar)
    cli.present(found, output, quiet=quiet)
    if all(one.within == "no answer" for one in found.bridges):
        cli.print_error(f"no bridge has an answer; the first: {found.bridges[0].message}")
        raise typer.Exit(cli.UNTRUSTED)
