"""``softcat figures``: the paper's figures."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    INTERRUPTED,
    VALIDATION,
    FreshOption,
    OutputOption,
    QuietOption,
    app,
    output_directory,
    print_error,
)

if TYPE_CHECKING:
    from softcat_sym.studies.paper_figures import FigureScene, FilmedScene

_NUMBERS = ("2", "3a", "3b", "4")


@app.command(rich_help_panel=VALIDATION)
def figures(
    output: OutputOption = None,
    only: Annotated[
        list[str] | None,
        typer.Option("--only", metavar="NUMBER", help=f"Only this figure: {', '.join(_NUMBERS)}. Repeatable."),
    ] = None,
    fresh: FreshOption = False,
    quiet: QuietOption = False,
) -> None:
    """Draw the paper's figures 2, 3(a), 3(b) and 4.

    Each as PNG and PDF, its data as CSV, facts and caption as JSON.
    Figure 3(a) runs a thousand filaments, a minute or two. Figures 3(b) and 4 run finite elements, a minute or so a
    scene; these keep their state in DIR/elements-*.npz. After Ctrl-C the same command goes on from what was finished;
    figures that are there need not be asked for again.
    """
    asked = only or list(_NUMBERS)
    unknown = [number for number in asked if number not in _NUMBERS]
    if unknown:
        raise typer.BadParameter(f"no figure {unknown[0]!r}: take {', '.join(_NUMBERS)}", param_hint="--only")
    output = output_directory(output, "figures")
    from softcat_sym import store
    from softcat_sym.files import made, write_all

    filmed: dict[str, FilmedScene] = {}
    waiting = [number for number in _NUMBERS if number in asked]
    try:
        while waiting:
            with store.fresh(fresh), made(output):
                contents, said = _MADE[waiting[0]](output, filmed, quiet)
                written = write_all(output, contents)
            waiting.pop(0)
            if not quiet:
                typer.echo(said)
                typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
    except KeyboardInterrupt:
        print_error(f"interrupted; {_left(output, [number for number in _NUMBERS if number in asked], waiting)}")
        raise typer.Exit(INTERRUPTED) from None


_Made = tuple[dict[str, bytes], str]


def _left(output: Path, asked: list[str], waiting: list[str]) -> str:
    """What an interrupted command leaves behind, and how to go on."""
    again = " ".join(f"--only {number}" for number in waiting)
    if waiting != asked:
        done = " and ".join(number for number in asked if number not in waiting)
        return f"figure {done} is written; softcat figures -o {output} {again} goes on from {output}"
    return "the same command goes on from what was finished"


def _descent_of_maxwell(output: Path, filmed: dict[str, FilmedScene], quiet: bool) -> _Made:
    """Figure 2."""
    del output, filmed
    from softcat_sym.plotting.paper_figures import maxwell_caption as caption
    from softcat_sym.plotting.paper_figures import maxwell_descent_files
    from softcat_sym.plotting.terminal import StepProgress
    from softcat_sym.studies.paper_figures import RELAXATION, SLENDERNESS, maxwell_descents

    with StepProgress(2 * len(RELAXATION) * len(SLENDERNESS), "figure 2", quiet=quiet) as progress:
        panels = maxwell_descents(progress.step)
    return maxwell_descent_files(panels), caption(panels)


def _phases(output: Path, filmed: dict[str, FilmedScene], quiet: bool) -> _Made:
    """Figure 3(a)."""
    del output, filmed
    from softcat_sym.ensemble.ensemble import MembersBar
    from softcat_sym.plotting.paper_figures import phase_caption as caption
    from softcat_sym.plotting.paper_figures import phase_files
    from softcat_sym.scene.reading import load_scene
    from softcat_sym.studies.phase import SETTINGS, phase_diagram

    scene = load_scene("arrested-overdamped", list(SETTINGS))
    with MembersBar("figure 3(a)", quiet=quiet) as progress:
        diagram = phase_diagram(scene, progress=progress)
    return phase_files(diagram), caption(diagram)


def _midpoints(output: Path, filmed: dict[str, FilmedScene], quiet: bool) -> _Made:
    """Figure 3(b)."""
    from softcat_sym.plotting.paper_figures import midpoint_files
    from softcat_sym.plotting.paper_figures import midpoints_caption as caption
    from softcat_sym.studies.paper_figures import SCENES, scene_facts

    scenes = [_film(of, output, filmed, quiet) for of in SCENES]
    return midpoint_files(scenes), caption({each.of.name: scene_facts(each) for each in scenes})


def _snapshots(output: Path, filmed: dict[str, FilmedScene], quiet: bool) -> _Made:
    """Figure 4."""
    from softcat_sym.plotting.paper_figures import snapshot_files
    from softcat_sym.plotting.paper_figures import snapshots_caption as caption
    from softcat_sym.studies.paper_figures import SCENES, SNAPSHOTS

    scenes = [_film(of, output, filmed, quiet) for of in SCENES if of.name in SNAPSHOTS]
    return snapshot_files(scenes), caption({each.of.name: each for each in scenes})


def _film(of: FigureScene, output: Path, filmed: dict[str, FilmedScene], quiet: bool) -> FilmedScene:
    """Run a scene, once for all figures."""
    from softcat_sym.plotting.terminal import IntegrationProgress
    from softcat_sym.studies.paper_figures import film_scene

    if of.name not in filmed:
        filmed[of.name] = film_scene(
            of, output, lambda what, duration: IntegrationProgress(duration, what, quiet=quiet)
        )
    return filmed[of.name]


_MADE: dict[str, Callable[[Path, dict[str, FilmedScene], bool], _Made]] = {
    "2": _descent_of_maxwell,
    "3a": _phases,
    "3b": _midpoints,
    "4": _snapshots,
}
