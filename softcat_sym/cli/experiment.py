"""``softcat experiment``: design of a film that determines a material."""

from __future__ import annotations

from typing import Annotated

from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import StudyDisplay

with lazy_imports():
    from softcat_sym.design import experiment as design

_RANGE = "LOW:HIGH"


def experiment(
    scene: cli.SceneArgument,
    free: Annotated[list[str], cli.option("NAME", "Parameter that the film is to determine: viscosity. Repeatable.")],
    noise: Annotated[str, cli.option("LENGTH", "Error of one reading: '10 um', or '1 %' of the largest sag.")],
    output: cli.OutputOption = None,
    span: Annotated[
        cli.Text, cli.option(_RANGE, "Spans to choose from: 5:50 mm. By default the scene's span stays.")
    ] = None,
    thickness: Annotated[
        cli.Text, cli.option(_RANGE, "Thicknesses to choose from: 1:4 mm. By default the scene's thickness stays.")
    ] = None,
    frame_rate: Annotated[cli.Text, cli.option(_RANGE, "Frame rates that the camera has: 25:1000 Hz.")] = None,
    duration: Annotated[cli.Text, cli.option(_RANGE, "Durations that the film may have: 1:60 s.")] = None,
    nuisance: Annotated[
        cli.Texts, cli.option("NAME", "Parameter that is unknown too, but not asked for: time_offset. Repeatable.")
    ] = None,
    max_frames: Annotated[int | None, cli.option("NUMBER", "Frames that the camera can store.", min=2)] = None,
    max_sag: Annotated[
        cli.Text, cli.option("LENGTH", "Largest sag of the designed filament: '5 mm', or '5 %' of its span.")
    ] = None,
    fresh: cli.FreshOption = False,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Design the film that determines a material best.

    DIR gets experiment.json, scene.toml, a picture and a table.
    The scene holds rough values. Among the experiments allowed, the command chooses the one whose largest relative
    error is smallest; quantities without a range stay as in the scene. After Ctrl-C the same command resumes from the
    experiments that were tried.
    """
    resolved, output = cli.scene_and_directory(scene, changes, output, "experiment")
    given = {"span": span, "thickness": thickness, "frame_rate": frame_rate, "duration": duration}
    # A text that is no pair is passed on, as one value or for the design to refuse.
    within = {name: cli.read_pair(text) or text for name, text in given.items() if text is not None}
    with cli.study(fresh=fresh), StudyDisplay(quiet=quiet) as progress:
        progress.doing("reading and compiling")
        judge = design.judge_of(resolved, free, noise, within, nuisance or [], max_frames, max_sag)
        found = design.best_experiment(judge, progress)
    cli.present(found, output, quiet=quiet)
