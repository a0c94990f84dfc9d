"""``softcat compare``: a filament against finite elements."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    VALIDATION,
    OutputOption,
    QuietOption,
    SceneArgument,
    SetOption,
    app,
    scene_and_directory,
)
from softcat_sym.cli.compare_calculix import Engine, compare_in_calculix
from softcat_sym.cli.compare_elements import compare_with_elements

if TYPE_CHECKING:
    from softcat_sym.reference import Mesh


MeshOption = Annotated[
    str | None,
    typer.Option(
        "--mesh",
        metavar="ALONGxTHROUGH",
        help="Elements over half the span, and the thickness.",
        show_default="64x4; with --vary 32x4",
    ),
]
VaryOption = Annotated[
    str | None,
    typer.Option(
        "--vary",
        metavar="KEY=VALUE,VALUE,...",
        help="Measure the theories at several values of one variable, or KEY=FIRST:LAST:NUMBER[:log].",
    ),
]
FaceOption = Annotated[
    bool, typer.Option("--fixed-face", help="Hold every point of the clamped face, which then cannot thin.")
]
EngineOption = Annotated[
    Engine, typer.Option("--engine", help="Our own elements, CalculiX (Debian: calculix-ccx), or both.")
]
DeckOption = Annotated[
    bool, typer.Option("--deck-only", help="Write CalculiX's input deck into DIR/calculix, and run nothing.")
]


@app.command(rich_help_panel=VALIDATION)
def compare(
    scene: SceneArgument,
    output: OutputOption = None,
    mesh: MeshOption = None,
    vary: VaryOption = None,
    fixed_face: FaceOption = False,
    engine: EngineOption = Engine.ELEMENTS,
    deck_only: DeckOption = False,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Compare a filament with finite elements.

    DIR gets compare.json, pictures and tables.
    Where the scene's effects are auto, the published theory stands beside them in both closures. The elements keep
    their state in DIR/elements.npz: after Ctrl-C the same command goes on from there. Where meshio is installed, meshes
    and fields go to DIR/vtk for ParaView. With --engine calculix a solver that is not ours takes the elements'
    place; its finished run is kept in DIR/parts until all is there, one that is interrupted begins again.

    With --vary the errors of the theories stand against one variable, beside those of half as many elements and what
    each run costs; where the filament gets thinner, the slender limit is extrapolated.
    """
    from softcat_sym.reference import Clamp

    face = Clamp.FIXED if fixed_face else Clamp.THINNING
    if vary is not None:
        from softcat_sym.cli.compare_vary import compare_varied

        if deck_only or engine is not Engine.ELEMENTS:
            raise typer.BadParameter("it varies the runs of our own elements only", param_hint="--vary")
        compare_varied(scene, changes, vary, output, _mesh(mesh or "32x4"), face, quiet=quiet)
        return
    asked, output = scene_and_directory(scene, changes, output, "compare")
    size = _mesh(mesh or "64x4")
    if deck_only or engine is not Engine.ELEMENTS:
        compare_in_calculix(asked, output, size, face, engine=engine, deck_only=deck_only, quiet=quiet)
    else:
        compare_with_elements(asked, output, size, face, quiet=quiet)


def _mesh(text: str) -> Mesh:
    """Read ``64x4``; what is no mesh of this kind is refused by the mesh itself."""
    from softcat_sym.reference import Mesh

    found = re.fullmatch(r"\s*(\d{1,6})\s*[xX×]\s*(\d{1,6})\s*", text, re.ASCII)
    if found is None:
        raise typer.BadParameter(f"{text!r} is no mesh: write two whole numbers, such as 64x4", param_hint="--mesh")
    return Mesh(*map(int, found.groups()))
