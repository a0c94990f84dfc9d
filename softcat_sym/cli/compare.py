"""``softcat compare``: a filament against finite elements."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.files import write_results
from softcat_sym.lazy import lazy_imports

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene

with lazy_imports():
    from softcat_sym.plotting import terminal
    from softcat_sym.reference import calculix
    from softcat_sym.reference import element_loop as elements
    from softcat_sym.studies import compare as study
    from softcat_sym.studies import theory_end


def _compare_once(
    scene: Scene, output: Path, mesh: elements.Mesh, clamp: elements.Clamp, *, fresh: bool, quiet: bool
) -> None:
    """Run the elements and the filament; write, print and judge."""
    with cli.study(fresh=fresh):
        comparison = study.compare(
            scene,
            mesh,
            clamp=clamp,
            progress=lambda what: terminal.IntegrationProgress(scene.run.duration, what, quiet=quiet),
        )
    cli.present(comparison, output, quiet=quiet)
    own = comparison.filament.trajectory
    cli.judge(own.outcome, own.summary["message"], quiet=quiet)


def _compare_varied(
    name: str,
    changes: list[str] | None,
    vary: str,
    output: Path | None,
    mesh: elements.Mesh,
    clamp: elements.Clamp,
    *,
    fresh: bool,
    quiet: bool,
) -> None:
    """Measure the theories at every value; write compare.json, a chart and tables into DIR."""
    asked, output = cli.scene_and_directory(name, changes, output, "compare")
    variation = theory_end.read_variation(asked, vary)

    def listening(value: str, scene: Scene) -> study.Listening:
        return lambda what: terminal.IntegrationProgress(scene.run.duration, f"{value}, {what}", quiet=quiet)

    def scene_with(change: str) -> Scene:
        return cli.scene_of(name, [*(changes or []), change])

    with cli.study(fresh=fresh):
        end = theory_end.where_theory_ends(
            asked,
            variation,
            scene_with,
            along=mesh.along,
            through=mesh.through,
            clamp=clamp,
            progress=listening,
        )
    cli.present(end, output, quiet=quiet)


def compare(
    scene: cli.SceneArgument,
    output: cli.OutputOption = None,
    mesh: Annotated[
        cli.Text,
        cli.option(
            "ALONGxTHROUGH",
            "Elements along half the span and through the thickness.",
            show_default="64x4; with --vary 32x4",
        ),
    ] = None,
    vary: Annotated[
        cli.Text,
        cli.option(
            "KEY=VALUE,VALUE,...",
            "Measure the theories at several values of one variable, or KEY=FIRST:LAST:NUMBER[:log].",
        ),
    ] = None,
    fixed_face: Annotated[
        bool, cli.switch("Hold every point of the clamped face, which then cannot thin.", "--fixed-face")
    ] = False,
    deck_only: Annotated[
        bool, cli.switch("Write CalculiX's input deck into DIR/calculix, and run nothing.", "--write-input-only")
    ] = False,
    fresh: cli.FreshOption = False,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Compare a filament with finite elements.

    DIR gets compare.json, pictures and tables. The elements include surface tension, but no density or viscosity of the
    surroundings. If the scene's effects are auto, the published theory is compared too, in both closures.

    With --vary the command gives the errors of the theories over one variable, and those of half as many elements; if
    the thickness varies, it extrapolates to the slender limit.
    """
    face = elements.Clamp.FIXED if fixed_face else elements.Clamp.THINNING
    if vary is not None:
        if deck_only:
            raise typer.BadParameter("a deck is of one scene", param_hint="--vary")
        _compare_varied(scene, changes, vary, output, _mesh(mesh or "32x4"), face, fresh=fresh, quiet=quiet)
        return
    resolved, output = cli.scene_and_directory(scene, changes, output, "compare")
    size = _mesh(mesh or "64x4")
    if deck_only:
        # The deck alone: CalculiX need not be installed
        deck = calculix.calculix_deck(resolved, size, clamp=face).text
        written = write_results(output, {"calculix/deck.inp": deck, "scene.toml": resolved.to_toml()})
        if not quiet:
            cli.print_written(written, output)
    else:
        _compare_once(resolved, output, size, face, fresh=fresh, quiet=quiet)


def _mesh(text: str) -> elements.Mesh:
    """Read ``64x4``; the mesh itself refuses unsuitable numbers."""
    found = re.fullmatch(r"\s*(\d{1,6})\s*[xX×]\s*(\d{1,6})\s*", text, re.ASCII)
    if found is None:
        raise typer.BadParameter(f"{text!r} is no mesh: write two whole numbers, such as 64x4", param_hint="--mesh")
    return elements.Mesh(*map(int, found.groups()))
