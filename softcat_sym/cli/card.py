"""``softcat card``: everything a printer asks of a spanning filament, on one page."""

from __future__ import annotations

import shlex
from contextlib import ExitStack
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    EVERYDAY,
    FreshOption,
    OptionalScene,
    OutputOption,
    QuietOption,
    SetOption,
    app,
    judge,
    output_directory,
    scene_and_directory,
    study,
)

if TYPE_CHECKING:
    from contextlib import AbstractContextManager
    from pathlib import Path

    from softcat_sym.scene.scene import Scene
    from softcat_sym.solvers.solution import Progress

SagOption = Annotated[
    str | None,
    typer.Option("--sag", metavar="LENGTH", help="What the filament may sag: '1 mm', or '5 %' of the span (default)."),
]


def _flag(name: str, help_text: str) -> object:
    return typer.Option(f"--{name}", metavar="VALUE", help=help_text)


Density = Annotated[str | None, _flag("density", "Instead of a SCENE: '1900 kg/m^3'.")]
Span = Annotated[str | None, _flag("span", "Likewise: '2 mm'.")]
Diameter = Annotated[str | None, _flag("diameter", "Of the round filament: '250 um'.")]
Law = Annotated[str | None, _flag("law", "bingham, newtonian, elastic, herschel-bulkley, ...")]
Modulus = Annotated[str | None, _flag("youngs-modulus", "'300 kPa'; three times the storage modulus of an ink.")]
Viscosity = Annotated[str | None, _flag("viscosity", "Extensional: '30 Pa*s'.")]
YieldStress = Annotated[str | None, _flag("yield-stress", "In tension: '350 Pa'.")]
Index = Annotated[str | None, _flag("index", "Of a power law: 0.5.")]
ShearViscosity = Annotated[str | None, _flag("shear-viscosity", "From a rheometer, converted: '10 Pa*s'.")]
ShearConsistency = Annotated[str | None, _flag("shear-consistency", "Likewise, of a law with an index.")]
ShearYield = Annotated[str | None, _flag("shear-yield-stress", "Likewise: '200 Pa'.")]
FlowCurve = Annotated[
    str | None, typer.Option("--flow-curve", metavar="CSV", help="Columns shear_rate_1_s, shear_stress_Pa.")
]
Ends = Annotated[str | None, _flag("ends", "clamped (default) or pinned.")]
Duration = Annotated[str | None, _flag("duration", "How long to look: '1 s'. Chosen if not given.")]

NoSpan = Annotated[
    bool, typer.Option("--no-span", help="Do not seek the longest span, which takes a good part of the time.")
]


@app.command(rich_help_panel=EVERYDAY)
def card(
    scene: OptionalScene = None,
    output: OutputOption = None,
    sag: SagOption = None,
    density: Density = None,
    span: Span = None,
    diameter: Diameter = None,
    law: Law = None,
    youngs_modulus: Modulus = None,
    viscosity: Viscosity = None,
    yield_stress: YieldStress = None,
    index: Index = None,
    shear_viscosity: ShearViscosity = None,
    shear_consistency: ShearConsistency = None,
    shear_yield_stress: ShearYield = None,
    flow_curve: FlowCurve = None,
    ends: Ends = None,
    duration: Duration = None,
    no_span: NoSpan = False,
    fresh: FreshOption = False,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Tell how far, when and over which gap a filament sags.

    One page: sag, arrest, longest span, the field's rules beside the solver: card.html, .json, .csv, .png in DIR.
    After Ctrl-C the same command goes on from the runs that were finished, to the same card.
    """
    flags = {
        "density": density,
        "span": span,
        "diameter": diameter,
        "law": law,
        "youngs-modulus": youngs_modulus,
        "viscosity": viscosity,
        "yield-stress": yield_stress,
        "index": index,
        "shear-viscosity": shear_viscosity,
        "shear-consistency": shear_consistency,
        "shear-yield-stress": shear_yield_stress,
        "flow-curve": flow_curve,
        "ends": ends,
        "duration": duration,
    }
    if no_span and sag is not None:
        raise typer.BadParameter("it is what the longest span may sag", param_hint="--sag with --no-span")
    asked, output, notes = _asked(scene, flags, changes or [], output)
    command = _command(scene, flags, sag, changes or [])
    order = _Order(asked, scene or "", None if no_span else sag, notes, not no_span)
    _make(order, output, command, fresh=fresh, quiet=quiet)


@dataclass(frozen=True)
class _Order:
    """What is asked of a card."""

    scene: Scene
    name: str
    sag: str | None
    notes: tuple[str, ...]
    seek: bool


def _asked(
    scene: str | None, flags: dict[str, str | None], changes: list[str], output: Path | None
) -> tuple[Scene, Path, tuple[str, ...]]:
    """The scene that is named, or the one of the flags, and DIR."""
    given = [f"--{name}" for name, text in flags.items() if text is not None]
    if scene is not None:
        if given:
            found = f"a scene and {', '.join(given)}: change the scene with --set, or leave it out"
            raise typer.BadParameter(found, param_hint="SCENE")
        return *scene_and_directory(scene, changes, output, "card"), ()
    if not given:
        raise typer.BadParameter("name a scene, or give --density, --span, --diameter, --law ...", param_hint="SCENE")
    from softcat_sym.studies.card import scene_from_flags

    asked, notes = scene_from_flags(flags, changes)
    return asked, output_directory(output, "card", asked=asked), notes


def _make(order: _Order, output: Path, command: str, *, fresh: bool, quiet: bool) -> None:
    from softcat_sym.plotting.card import print_card, write_card
    from softcat_sym.plotting.terminal import FitProgressBar as Bar
    from softcat_sym.plotting.terminal import IntegrationProgress
    from softcat_sym.studies.card import card as made

    def listening(what: str) -> AbstractContextManager[Progress]:
        return IntegrationProgress(order.scene.run.duration, what, quiet=quiet)

    def told(what: str) -> None:
        # One display at a time: this one begins when that of the first run has ended.
        if not bars:
            bars.append(stack.enter_context(Bar(quiet=quiet)))
        bars[0].stage(what, 0, 1)

    bars: list[Bar] = []
    with study(output, fresh=fresh), ExitStack() as stack:
        found = made(
            order.scene,
            order.sag,
            name=order.name,
            listening=listening,
            told=told,
            span=order.seek,
            notes=order.notes,
        )
        told("drawing")
        written = write_card(found, output, command)
    if not quiet:
        print_card(found)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
    judge(found.run.outcome, str(found.summary["message"]), quiet=quiet)


def _command(scene: str | None, flags: dict[str, str | None], sag: str | None, changes: list[str]) -> str:
    """That makes the same card again."""
    words = ["softcat", "card", *([scene] if scene else [])]
    for name, text in {**flags, "sag": sag}.items():
        words += [f"--{name}", text] if text is not None else []
    for change in changes:
        words += ["--set", change]
    return shlex.join([*words, "-o", "DIR"])
