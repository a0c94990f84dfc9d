"""What ``softcat compare --engine calculix`` does."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from softcat_sym.cli.application import judge
from softcat_sym.cli.going_on import going_on

if TYPE_CHECKING:
    from softcat_sym.reference import Clamp, Mesh
    from softcat_sym.scene import Scene


class Engine(StrEnum):
    """What the filament is held against."""

    ELEMENTS = "elements"
    CALCULIX = "calculix"
    BOTH = "both"


def compare_in_calculix(
    asked: Scene, output: Path, mesh: Mesh, clamp: Clamp, *, engine: Engine, deck_only: bool, quiet: bool
) -> None:
    """Run CalculiX and the filament, with our elements if wanted; write, print and judge. Or write the deck alone."""
    if deck_only:
        _write_deck(asked, output, mesh, clamp, quiet=quiet)
        return
    from softcat_sym.report.calculix_files import calculix_table, write_calculix_comparison
    from softcat_sym.report.progress import IntegrationProgress
    from softcat_sym.study.blocks.kept import FOLDER
    from softcat_sym.study.calculix import compare_with_calculix

    checkpoint = output / "elements.npz" if engine is Engine.BOTH else None
    told = {"scene": asked.to_toml(), "mesh": str(mesh), "clamp": clamp.value, "engine": engine.value}

    def left() -> str:
        kept = [one.name for one in (checkpoint, output / FOLDER) if one is not None and one.exists()]
        return f"{' and '.join(kept)} in {output}: the same command goes on from there" if kept else ""

    # The same command goes on, as with our elements.
    with going_on(output, "compare", told, resume=True, left=left):
        comparison = compare_with_calculix(
            asked,
            mesh,
            clamp=clamp,
            with_elements=engine is Engine.BOTH,
            checkpoint=checkpoint,
            progress=lambda what: IntegrationProgress(asked.run.duration, what, quiet=quiet),
        )
        written = write_calculix_comparison(comparison, output)
    if not quiet:
        from rich.console import Console

        Console().print(calculix_table(comparison))
        for warning in comparison.warnings:
            typer.echo(f"note: {warning}")
        typer.echo(f"wrote {', '.join(path.relative_to(output).as_posix() for path in written)} to {output}")
    judge(comparison.trajectory.outcome, comparison.trajectory.summary["complaint"], quiet=quiet)


def _write_deck(asked: Scene, output: Path, mesh: Mesh, clamp: Clamp, *, quiet: bool) -> None:
    """Write the deck of CalculiX, which need not be installed."""
    from softcat_sym.reference.calculix_deck import calculix_deck
    from softcat_sym.report.calculix_files import write_deck

    written = write_deck(asked, calculix_deck(asked, mesh, clamp=clamp), output)
    if not quiet:
        typer.echo(f"wrote {', '.join(path.relative_to(output).as_posix() for path in written)} to {output}")
