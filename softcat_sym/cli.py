"""The ``softcat`` command.

Exit status: 0 a sound answer, 1 an answer not to be trusted, 2 bad input, 130 interrupted.
"""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

if TYPE_CHECKING:
    from softcat_sym.reference import Mesh
    from softcat_sym.scene import Scene
    from softcat_sym.trajectory import Trajectory

_BAD_INPUT, _UNTRUSTED, _INTERRUPTED = 2, 1, 130

app = typer.Typer(
    name="softcat",
    help="Slender soft filaments that sag, stretch, yield and stop.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

SceneArgument = Annotated[str, typer.Argument(metavar="SCENE", help="Name of a bundled scene, or path of a TOML file.")]
SetOption = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Change a value of the scene: --set 'material.yield_stress=5 kPa'. Repeatable.",
    ),
]
OutputOption = Annotated[Path, typer.Option("--output", "-o", metavar="DIR", help="Where the files go.")]
QuietOption = Annotated[bool, typer.Option("--quiet", "-q", help="No progress, no summary.")]


@app.command()
def run(
    scene: SceneArgument,
    output: OutputOption,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Run a scene: trajectory.nc, summary.json, scene.toml, pictures and a table in DIR."""
    asked = _scene(scene, changes)
    _check_directory(output)
    from softcat_sym.report.progress import IntegrationProgress
    from softcat_sym.report.run_files import write_run
    from softcat_sym.simulate import simulate

    try:
        with IntegrationProgress(asked.run.duration, asked.title or "integrating", quiet=quiet) as progress:
            trajectory = simulate(asked, progress)
    except KeyboardInterrupt:
        _complain("interrupted; nothing was written")
        raise typer.Exit(_INTERRUPTED) from None
    written = write_run(trajectory, output)
    if not quiet:
        from softcat_sym.report.terminal import print_summary

        print_summary(written.summary, asked)
        typer.echo(f"wrote {', '.join(path.name for path in written.files)} to {output}")
    _judge(trajectory, quiet=quiet)


@app.command()
def figures(
    output: OutputOption,
    only: Annotated[
        list[int] | None, typer.Option("--only", metavar="NUMBER", help="Only this figure of the paper. Repeatable.")
    ] = None,
    quiet: QuietOption = False,
) -> None:
    """Draw the paper's figures: PNG, data as CSV, facts and caption as JSON. Now there is figure 2."""
    asked = only or [2]
    if set(asked) != {2}:
        raise typer.BadParameter("figure 2 is the one there is; the others are not yet available", param_hint="--only")
    _check_directory(output)
    from softcat_sym.report.maxwell_descent import caption, write_maxwell_descent
    from softcat_sym.report.progress import StepProgress
    from softcat_sym.study.maxwell_descent import RELAXATION, SLENDERNESS, maxwell_descents

    with StepProgress(2 * len(RELAXATION) * len(SLENDERNESS), "figure 2", quiet=quiet) as progress:
        panels = maxwell_descents(progress.step)
    written = write_maxwell_descent(panels, output)
    if not quiet:
        typer.echo(caption(panels))
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")


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
    asked = _scene(scene, changes)
    _check_directory(output)
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
        _complain(f"interrupted; {kept}")
        raise typer.Exit(_INTERRUPTED) from None
    written = write_comparison(comparison, output)
    if not quiet:
        from softcat_sym.report.compare_terminal import print_comparison

        print_comparison(comparison)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
    _judge(comparison.filament.trajectory, quiet=quiet)


@app.command("flow-curve")
def flow_curve(
    curve: Annotated[str, typer.Argument(metavar="CSV", help="Columns shear_rate_1_s and shear_stress_Pa.")],
    output: OutputOption,
    scene: Annotated[
        str | None, typer.Option("--scene", metavar="SCENE", help="Write this scene with the fitted material, too.")
    ] = None,
    law: Annotated[
        str | None, typer.Option("--law", metavar="LAW", help="Hand this law on: bingham, power-law, herschel-bulkley.")
    ] = None,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Fit a rheometer's flow curve: flow_curve.json, picture and table in DIR; with --scene, scene.toml."""
    if changes and scene is None:
        raise typer.BadParameter("it changes a scene: name one with --scene", param_hint="--set")
    _check_directory(output)
    from softcat_sym.inverse import fit_flow_curve, fitted_scene
    from softcat_sym.report.flow_curve import print_flow_curve, write_flow_curve

    fit = fit_flow_curve(curve)
    handed_on = None if scene is None else fitted_scene(fit, scene, law, changes or [])
    written = write_flow_curve(fit, output, law, handed_on)
    if not quiet:
        print_flow_curve(fit)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")


@app.command()
def scenes() -> None:
    """List the bundled scenes."""
    from softcat_sym.scene import bundled_names, bundled_title

    names = bundled_names()
    width = max(map(len, names))
    for name in names:
        typer.echo(f"{name:{width}}  {bundled_title(name)}")


def _version(asked: bool) -> None:
    if asked:
        import importlib.metadata

        typer.echo(f"softcat {importlib.metadata.version('softcat_sym')}")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and stop.")
    ] = False,
) -> None:
    del version


def _scene(name: str, changes: list[str] | None) -> Scene:
    from softcat_sym.scene import load_scene

    return load_scene(name, changes or [])


def _mesh(text: str) -> Mesh:
    """Read ``64x4``; what is no mesh of this kind is refused by the mesh itself."""
    from softcat_sym.reference import Mesh

    found = re.fullmatch(r"\s*(\d{1,6})\s*[xX×]\s*(\d{1,6})\s*", text, re.ASCII)
    if found is None:
        raise typer.BadParameter(f"{text!r} is no mesh: write two whole numbers, such as 64x4", param_hint="--mesh")
    return Mesh(*map(int, found.groups()))


def _judge(trajectory: Trajectory, *, quiet: bool) -> None:
    """Exit with 1 if the answer is not to be trusted."""
    if trajectory.outcome.is_success:
        return
    if quiet:
        _complain(f"{trajectory.outcome.name}: {trajectory.summary['complaint']}; {trajectory.outcome.value}")
    raise typer.Exit(_UNTRUSTED)


def _check_directory(directory: Path) -> None:
    """Refuse a DIR that cannot be written before anything is computed."""
    parent = directory
    while not parent.exists() and parent != parent.parent:
        parent = parent.parent
    if not parent.is_dir():
        raise NotADirectoryError(f"{parent} is not a directory")
    if not os.access(parent, os.W_OK):
        raise PermissionError(f"{parent} cannot be written")


def _complain(text: str) -> None:
    typer.echo(f"softcat: {text}", err=True)


def main() -> NoReturn:
    """Entry point: every refusal is one clear message and an exit status."""
    from softcat_sym.errors import SoftcatError

    try:
        app()
    except SoftcatError as error:
        _complain(str(error))
        sys.exit(_BAD_INPUT)
    except OSError as error:
        _complain(f"cannot write the results: {error}")
        sys.exit(_BAD_INPUT)
    sys.exit(0)
