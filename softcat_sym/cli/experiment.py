"""``softcat experiment``: design of a film that determines a material."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, TypedDict

import typer

from softcat_sym import drawing
from softcat_sym.cli.application import (
    FreshOption,
    OutputOption,
    QuietOption,
    SceneArgument,
    SetOption,
    commands,
    present,
    read_pair,
    scene_and_directory,
    study,
)

if TYPE_CHECKING:
    from softcat_sym.design.critical_span import CriticalSpan
    from softcat_sym.scene.scene import Scene
    from softcat_sym.solvers.solution import Progress

_RANGE = "LOW:HIGH"

FreeOption = Annotated[
    list[str],
    typer.Option("--free", metavar="NAME", help="Parameter that the film is to determine: viscosity. Repeatable."),
]
NoiseOption = Annotated[
    str, typer.Option("--noise", metavar="LENGTH", help="Error of one reading: '10 um', or '1 %' of the largest sag.")
]
SpanOption = Annotated[
    str | None,
    typer.Option("--span", metavar=_RANGE, help="Spans to choose from: 5:50 mm. By default the scene's span stays."),
]
ThicknessOption = Annotated[
    str | None,
    typer.Option(
        "--thickness",
        metavar=_RANGE,
        help="Thicknesses to choose from: 1:4 mm. By default the scene's thickness stays.",
    ),
]
RateOption = Annotated[
    str | None, typer.Option("--frame-rate", metavar=_RANGE, help="Frame rates that the camera has: 25:1000 Hz.")
]
DurationOption = Annotated[
    str | None, typer.Option("--duration", metavar=_RANGE, help="Durations that the film may have: 1:60 s.")
]
NuisanceOption = Annotated[
    list[str] | None,
    typer.Option(
        "--nuisance", metavar="NAME", help="Parameter that is unknown too, but not asked for: time_offset. Repeatable."
    ),
]
FramesOption = Annotated[
    int | None, typer.Option("--max-frames", metavar="NUMBER", min=2, help="Frames that the camera can store.")
]
RoughOption = Annotated[
    float,
    typer.Option("--rough", metavar="FACTOR", help="Factor by which the scene's values may be too large or too small."),
]
DepthOption = Annotated[
    str | None,
    typer.Option(
        "--max-sag", metavar="LENGTH", help="Largest sag of the designed filament: '5 mm', or '5 %' of its span."
    ),
]
SagOption = Annotated[
    str | None,
    typer.Option("--sag", metavar="LENGTH", help="Also find the largest span of the scene that sags less: '1 mm'."),
]


@commands.command()
def experiment(
    scene: SceneArgument,
    free: FreeOption,
    noise: NoiseOption,
    output: OutputOption = None,
    span: SpanOption = None,
    thickness: ThicknessOption = None,
    frame_rate: RateOption = None,
    duration: DurationOption = None,
    nuisance: NuisanceOption = None,
    max_frames: FramesOption = None,
    rough: RoughOption = 1.0,
    max_sag: DepthOption = None,
    sag: SagOption = None,
    fresh: FreshOption = False,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Design the film that determines a material best.

    DIR gets experiment.json, scene.toml, a picture and a table.
    The scene holds rough values. Among the experiments allowed, the command chooses the one whose largest relative
    error is smallest; quantities without a range stay as in the scene. After Ctrl-C the same command resumes from the
    experiments that were tried.
    """
    asked, output = scene_and_directory(scene, changes, output, "experiment")
    within = _within({"span": span, "thickness": thickness, "frame_rate": frame_rate, "duration": duration})
    from softcat_sym.design.experiment import design_experiment
    from softcat_sym.progress import StudyDisplay

    how = _How(nuisance=nuisance or [], max_frames=max_frames, rough=rough, max_sag=max_sag)
    with study(output, fresh=fresh), StudyDisplay(quiet=quiet) as progress:
        progress.doing("reading and compiling")
        # The faster of the two comes first.
        critical = None if sag is None else _critical(asked, sag, progress)
        design = design_experiment(asked, free, noise, within, **how, progress=progress)
        progress.stage("drawing")
        report = drawing.report(design, critical=critical)
        written = report.write(output)
    present(report, written, output, quiet=quiet)


class _How(TypedDict):
    """Further options of a design."""

    nuisance: list[str]
    max_frames: int | None
    rough: float
    max_sag: str | None


def _within(given: dict[str, str | None]) -> dict[str, object]:
    """Read the ranges; a text that is no pair is passed on, as one value or for the design to refuse."""
    return {name: read_pair(text) or text for name, text in given.items() if text is not None}


def _critical(scene: Scene, limit: str, progress: Progress) -> CriticalSpan:
    from softcat_sym.design.critical_span import critical_span

    return critical_span(scene, limit, progress=progress)
