"""``softcat card``: one page on a spanning filament, for people who print such filaments."""

from __future__ import annotations

import shlex
from typing import Annotated, Any

import typer

from softcat_sym import drawing
from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports

with lazy_imports():
    from softcat_sym.plotting import card as drawn
    from softcat_sym.plotting import terminal
    from softcat_sym.studies import card as study


def _value(help_text: str) -> Any:
    return cli.option("VALUE", help_text)


def card(
    context: typer.Context,
    scene: cli.OptionalScene = None,
    output: cli.OutputOption = None,
    max_sag: Annotated[
        cli.Text, cli.option("LENGTH", "Largest sag allowed: '1 mm', or '5 %' of the span (default).")
    ] = None,
    sag: Annotated[cli.Text, cli.option("LENGTH", "The same as --max-sag.", hidden=True)] = None,
    density: Annotated[cli.Text, _value("Density, where no SCENE is given: '1900 kg/m^3'.")] = None,
    span: Annotated[cli.Text, _value("Span, where no SCENE is given: '2 mm'.")] = None,
    diameter: Annotated[cli.Text, _value("Diameter of the round filament: '250 um'.")] = None,
    law: Annotated[cli.Text, _value("Law: bingham, newtonian, elastic, herschel-bulkley, ...")] = None,
    youngs_modulus: Annotated[
        cli.Text, _value("Young's modulus: '300 kPa'. That of an ink is three times its storage modulus.")
    ] = None,
    viscosity: Annotated[cli.Text, _value("Viscosity in extension: '30 Pa*s'.")] = None,
    yield_stress: Annotated[cli.Text, _value("Yield stress in tension: '350 Pa'.")] = None,
    index: Annotated[cli.Text, _value("Index of the power law: 0.5.")] = None,
    shear_viscosity: Annotated[cli.Text, _value("Viscosity in shear, which is converted: '10 Pa*s'.")] = None,
    shear_consistency: Annotated[
        cli.Text, _value("Consistency in shear of a law with an index, converted: '10 Pa*s^0.5'.")
    ] = None,
    shear_yield_stress: Annotated[cli.Text, _value("Yield stress in shear, which is converted: '200 Pa'.")] = None,
    surface_tension: Annotated[
        cli.Text, _value("Surface tension: '72 mN/m' is that of water. Without the option there is none.")
    ] = None,
    flow_curve: Annotated[
        cli.Text, cli.option("CSV", "Flow curve of the material: columns shear_rate_1_s, shear_stress_Pa.")
    ] = None,
    pillars: Annotated[
        cli.Text, _value("Radius of the edges of two pillars, --span apart, on which it lies: '0 mm' if sharp.")
    ] = None,
    ends: Annotated[cli.Text, _value("Ends: clamped (default) or pinned.")] = None,
    duration: Annotated[
        cli.Text, _value("Duration of the run: '1 s'. Without the option the program chooses it.")
    ] = None,
    no_span: Annotated[
        bool, cli.switch("Leave out the longest span, which takes a large part of the time.", "--no-span")
    ] = False,
    fresh: cli.FreshOption = False,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Find how far, when and over which gap a filament sags.

    One page has sag, arrest, longest span and the field's rules against the solver; DIR gets card.html, card.json,
    card.csv and card.png.
    After Ctrl-C the same command resumes from the finished runs, and gives the same card.
    """
    if None not in (max_sag, sag):
        raise typer.BadParameter("given twice; accepted: one of the two", param_hint="--max-sag with --sag")
    sag = max_sag or sag
    if no_span and sag is not None:
        raise typer.BadParameter(
            "it limits the longest span, which --no-span leaves out", param_hint="--max-sag with --no-span"
        )
    others = {"scene", "output", "max_sag", "sag", "no_span", "fresh", "changes", "quiet"}
    flags = {
        name.replace("_", "-"): text for name, text in context.params.items() if name not in others and text is not None
    }
    if scene is None and not flags:
        raise typer.BadParameter("name a scene, or give --density, --span, --diameter, --law ...", param_hint="SCENE")
    if scene is not None and flags:
        given = ", ".join(f"--{name}" for name in flags)
        text = f"a scene and {given}: change the scene with --set, or leave it out"
        raise typer.BadParameter(text, param_hint="SCENE")
    notes: tuple[str, ...] = ()
    if scene is not None:
        resolved, output = cli.scene_and_directory(scene, changes, output, "card")
    else:
        resolved, notes = study.scene_from_flags(flags, changes or [])
        output = cli.output_directory(output, "card", resolved=resolved)
    words = ["softcat", "card", *([scene] if scene else [])]
    options = {**flags, **({"max-sag": sag} if sag is not None else {})}
    words += [word for name, text in options.items() for word in (f"--{name}", text)]
    words += [word for change in changes or [] for word in ("--set", change)]
    command, printer = shlex.join([*words, "-o", "DIR"]), drawn.CardPrinter(quiet=quiet)
    study.check_limit(study.LIMIT if sag is None else sag)
    printer.print_forecast(resolved)
    with cli.study(output, fresh=fresh), terminal.IntegrationProgress(resolved.run.duration, quiet=quiet) as progress:
        try:
            found = study.card(
                resolved,
                sag,
                name=scene or "",
                progress=progress,
                span=not no_span,
                notes=notes,
                on_update=printer.update,
            )
        except KeyboardInterrupt:
            if printer.card is None:
                raise
            drawing.report(printer.card, command=command).write(output)
            left = f"what was computed is in {output}, marked as incomplete; the same command goes on from there"
            raise cli.interrupted(left) from None
        progress.stage("drawing")
        report = drawing.report(found, command=command)
        written = report.write(output)
    if not quiet:
        cli.print_written(written, output)
    cli.judge(found.run.outcome, str(found.summary["message"]), quiet=quiet)
