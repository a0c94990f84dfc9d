"""``softcat card``: one page on a spanning filament, for people who print such filaments."""

from __future__ import annotations

import shlex
from typing import Annotated

import typer

from softcat_sym import drawing
from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports

with lazy_imports():
    from softcat_sym.plotting import card as drawn
    from softcat_sym.plotting import terminal
    from softcat_sym.studies import card as study


def card(
    scene: cli.SceneArgument,
    output: cli.OutputOption = None,
    max_sag: Annotated[
        cli.Text, cli.option("LENGTH", "Largest sag allowed: '1 mm', or '5 %' of the span (default).")
    ] = None,
    sag: Annotated[cli.Text, cli.option("LENGTH", "The same as --max-sag.", hidden=True)] = None,
    pillars: Annotated[
        cli.Text,
        cli.option("RADIUS", "Radius of the edges of two pillars, the span apart, on which it lies: '0 mm' if sharp."),
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
    resolved, output = cli.scene_and_directory(scene, changes, output, "card")
    notes: tuple[str, ...] = ()
    if pillars is not None:
        resolved, note = study.on_pillars(resolved, pillars)
        notes = (note,)
    options = {"max-sag": sag, "pillars": pillars}
    words = ["softcat", "card", scene]
    words += [word for name, text in options.items() if text is not None for word in (f"--{name}", text)]
    words += [word for change in changes or [] for word in ("--set", change)]
    command, printer = shlex.join([*words, "-o", "DIR"]), drawn.CardPrinter(quiet=quiet)
    study.check_limit(study.LIMIT if sag is None else sag)
    printer.print_forecast(resolved)
    with cli.study(fresh=fresh), terminal.IntegrationProgress(resolved.run.duration, quiet=quiet) as progress:
        try:
            found = study.card(
                resolved,
                sag,
                name=scene,
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
