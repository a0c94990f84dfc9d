"""What ``softcat compare`` does with our own elements."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from softcat_sym.cli.application import INTERRUPTED, complain, judge

if TYPE_CHECKING:
    from softcat_sym.reference import Clamp, Mesh
    from softcat_sym.scene import Scene


def compare_with_elements(asked: Scene, output: Path, mesh: Mesh, clamp: Clamp, *, quiet: bool) -> None:
    """Run the elements, or go on with them, and the filament; write, print and judge."""
    from softcat_sym.report.compare_files import write_comparison
    from softcat_sym.report.progress import IntegrationProgress
    from softcat_sym.report.vtk import vtk_available, write_vtk
    from softcat_sym.study.compare import compare as against_elements

    checkpoint = output / "elements.npz"
    if checkpoint.is_file() and not quiet:
        typer.echo(f"the elements go on from {checkpoint}")
    try:
        comparison = against_elements(
            asked,
            mesh,
            clamp=clamp,
            checkpoint=checkpoint,
            progress=lambda what: IntegrationProgress(asked.run.duration, what, quiet=quiet),
        )
    except KeyboardInterrupt:
        kept = f"the same command goes on from {checkpoint}" if checkpoint.is_file() else "nothing was written"
        complain(f"interrupted; {kept}")
        raise typer.Exit(INTERRUPTED) from None
    written = write_comparison(comparison, output)
    if vtk_available():
        written.append(write_vtk(asked, comparison.elements, output / "vtk")[0])
    if not quiet:
        from softcat_sym.report.compare_terminal import print_comparison

        print_comparison(comparison)
        typer.echo(f"wrote {', '.join(path.relative_to(output).as_posix() for path in written)} to {output}")
    own = comparison.filament.trajectory
    judge(own.outcome, own.summary["complaint"], quiet=quiet)
