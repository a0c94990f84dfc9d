"""``softcat compare``: a filament against finite elements."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    INTERRUPTED,
    OutputOption,
    QuietOption,
    SceneArgument,
    SetOption,
    app,
    check_directory,
    complain,
    judge,
    scene_of,
)

if TYPE_CHECKING:
    from softcat_sym.reference import Mesh


@app.command()
def compare(
    scene: SceneArgument,
    output: OutputOption,
    mesh: Annotated[
        str, typer.Option("--mesh", metavar="ALONGxTHROUGH", help="Elements over half the span, and the thickness.")
    ] = "64x4",
    fixed_face: Annotated[
        bool, typer.Option("--fixed-face", help="Hold every point of the clamped face, which then cannot thin.")
    ] = False,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Compare the filament with finite elements: compare.json, pictures and tables in DIR.

    Where the scene's effects are auto, the published theory stands beside them in both closures. The elements keep
    their state in DIR/elements.npz: after Ctrl-C the same command goes on from there.
    """
    asked = scene_of(scene, changes)
    check_directory(output)
    from softcat_sym.reference import Clamp
    from softcat_sym.report.compare_files import write_comparison
    from softcat_sym.report.progress import IntegrationProgress
    from softcat_sym.study.compare import compare as against_elements

    checkpoint, size = output / "elements.npz", _mesh(mesh)
    if checkpoint.is_file() and not quiet:
        typer.echo(f"the elements go on from {checkpoint}")
    try:
        comparison = against_elements(
            asked,
            size,
            clamp=Clamp.FIXED if fixed_face else Clamp.THINNING,
            checkpoint=checkpoint,
            progress=lambda what: IntegrationProgress(asked.run.duration, what, quiet=quiet),
        )
    except KeyboardInterrupt:
        kept = f"the same command goes on from {checkpoint}" if checkpoint.is_file() else "nothing was written"
        complain(f"interrupted; {kept}")
        raise typer.Exit(INTERRUPTED) from None
    written = write_comparison(comparison, output)
    if not quiet:
        from softcat_sym.report.compare_terminal import print_comparison

        print_comparison(comparison)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
    own = comparison.filament.trajectory
    judge(own.outcome, own.summary["complaint"], quiet=quiet)


def _mesh(text: str) -> Mesh:
    """Read ``64x4``; what is no mesh of this kind is refused by the mesh itself."""
    from softcat_sym.reference import Mesh

    found = re.fullmatch(r"\s*(\d{1,6})\s*[xX×]\s*(\d{1,6})\s*", text, re.ASCII)
    if found is None:
        raise typer.BadParameter(f"{text!r} is no mesh: write two whole numbers, such as 64x4", param_hint="--mesh")
    return Mesh(*map(int, found.groups()))
