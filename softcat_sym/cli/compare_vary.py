"""``softcat compare --vary``: where the one-dimensional theory ends, as one variable of the scene changes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from softcat_sym.cli.application import INTERRUPTED, complain, scene_and_directory, scene_of

if TYPE_CHECKING:
    from softcat_sym.reference import Clamp, Mesh
    from softcat_sym.scene import Scene
    from softcat_sym.study.compare import Listening


def compare_varied(
    name: str, changes: list[str] | None, vary: str, output: Path | None, mesh: Mesh, clamp: Clamp, *, quiet: bool
) -> None:
    """Measure the theories at every value; compare.json, a chart and tables in DIR.

    The elements keep their states in DIR/elements: what is finished there is not run again.
    """
    from softcat_sym.report.progress import IntegrationProgress
    from softcat_sym.report.theory_end_files import write_theory_end
    from softcat_sym.report.theory_end_terminal import print_theory_end
    from softcat_sym.study.theory_end import where_theory_ends
    from softcat_sym.study.theory_end_values import read_variation

    variation = read_variation(vary)
    asked, output = scene_and_directory(name, changes, output, "compare")

    def listening(value: str, scene: Scene) -> Listening:
        return lambda what: IntegrationProgress(scene.run.duration, f"{value}, {what}", quiet=quiet)

    def scene_with(change: str) -> Scene:
        return scene_of(name, [*(changes or []), change])

    folder = output / "elements"
    try:
        end = where_theory_ends(
            asked,
            variation,
            scene_with,
            folder,
            along=mesh.along,
            through=mesh.through,
            clamp=clamp,
            progress=listening,
        )
    except KeyboardInterrupt:
        kept = f"the same command goes on from {folder}" if folder.is_dir() else "nothing was written"
        complain(f"interrupted; {kept}")
        raise typer.Exit(INTERRUPTED) from None
    written = write_theory_end(end, output)
    if not quiet:
        print_theory_end(end)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
