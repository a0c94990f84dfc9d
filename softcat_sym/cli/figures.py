"""``softcat figures``: the paper's figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.files import new_folder
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import MembersBar

if TYPE_CHECKING:
    from softcat_sym.drawing import Report

with lazy_imports():
    from softcat_sym import store
    from softcat_sym.plotting import paper_figures as figure_reports
    from softcat_sym.plotting import terminal
    from softcat_sym.scene import reading
    from softcat_sym.studies import paper_figures as study
    from softcat_sym.studies import phase

_NUMBERS = ("2", "3a", "3b", "4")


def figures(
    output: cli.OutputOption = None,
    only: Annotated[
        cli.Texts, cli.option("NUMBER", f"Draw only this figure: {', '.join(_NUMBERS)}. Repeatable.")
    ] = None,
    fresh: cli.FreshOption = False,
    quiet: cli.QuietOption = False,
) -> None:
    """Draw the paper's figures 2, 3(a), 3(b) and 4.

    Each figure is written as PNG and PDF, its data as CSV, facts and caption as JSON.
    Figure 3(a) runs a thousand filaments in a minute or two. Figures 3(b) and 4 run finite elements, about a minute for
    each scene. After Ctrl-C the same command resumes from what was finished; finished figures can be left out with
    --only.
    """
    if unknown := [number for number in only or [] if number not in _NUMBERS]:
        raise typer.BadParameter(f"no figure {unknown[0]!r}: take {', '.join(_NUMBERS)}", param_hint="--only")
    output = cli.output_directory(output, "figures")
    filmed: dict[str, study.FilmedScene] = {}
    wanted = [number for number in _NUMBERS if number in (only or _NUMBERS)]
    waiting = list(wanted)
    try:
        while waiting:
            with store.fresh(fresh), new_folder(output):
                cli.present(_draw(waiting[0], output, filmed, quiet), output, quiet=quiet)
            waiting.pop(0)
    except KeyboardInterrupt:
        text = "the same command resumes from what was finished"
        if waiting != wanted:
            done = " and ".join(number for number in wanted if number not in waiting)
            again = " ".join(f"--only {number}" for number in waiting)
            text = f"figure {done} is written; softcat figures -o {output} {again} resumes from {output}"
        raise cli.interrupted(text) from None


def _draw(number: str, output: Path, filmed: dict[str, study.FilmedScene], quiet: bool) -> Report:
    """A figure with its data and its caption; scenes are filmed once for all figures."""
    if number == "2":
        steps = 2 * len(study.RELAXATION) * len(study.SLENDERNESS)
        with terminal.StepProgress(steps, "figure 2", quiet=quiet) as progress:
            panels = study.maxwell_descents(progress.step)
        return figure_reports.maxwell_descent_report(panels)
    if number == "3a":
        scene = reading.load_scene("arrested-overdamped", list(phase.SETTINGS))
        with MembersBar("figure 3(a)", quiet=quiet) as members:
            diagram = phase.phase_diagram(scene, progress=members)
        return figure_reports.phase_report(diagram)
    for scene_of in study.SCENES:
        if scene_of.name not in filmed and (number == "3b" or scene_of.name in study.SNAPSHOTS):
            duration = reading.load_scene(scene_of.name).run.duration
            with terminal.IntegrationProgress(duration, quiet=quiet) as bar:
                filmed[scene_of.name] = study.film_scene(scene_of, bar)
    scenes = [filmed[each.name] for each in study.SCENES if each.name in filmed]
    return figure_reports.midpoint_report(scenes) if number == "3b" else figure_reports.snapshot_report(scenes)
