"""``softcat effects``: share of each effect in the answer, and its cost."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.errors import SoftcatError
from softcat_sym.files import write_results
from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.bundled import bundled_names

with lazy_imports():
    from softcat_sym.effects import selection
    from softcat_sym.plotting import effect_importance as tables
    from softcat_sym.plotting import terminal
    from softcat_sym.studies import effect_importance


def effects(
    scene: cli.OptionalScene = None,
    output: cli.OutputOption = None,
    bundled: Annotated[bool, cli.switch("Price all bundled scenes instead, and write a table.", "--bundled")] = False,
    fresh: cli.FreshOption = False,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """Measure each effect's share of the answer, and its cost.

    Each effect is put in or left out in turn; DIR gets effects.csv, effects.json and effects.png.
    After Ctrl-C the same command takes finished answers from the store; times are always measured again. With
    --bundled, --set changes every scene, and a scene that cannot be run is a row of the table; this takes many minutes.
    """
    if bundled is (scene is not None):
        raise typer.BadParameter("name one scene, or ask for --bundled, not both", param_hint="SCENE")
    if scene is None:
        _all(output, changes or [], fresh=fresh, quiet=quiet)
        return
    resolved, output = cli.scene_and_directory(scene, changes, output, "effects")
    with cli.study(fresh=fresh), terminal.IntegrationProgress(resolved.run.duration, quiet=quiet) as progress:
        pricing = effect_importance.price_effects(resolved, progress, scene)
    cli.present(pricing, output, quiet=quiet)
    cli.judge(pricing.base.outcome, pricing.base.message, quiet=quiet)


def _all(output: Path | None, changes: list[str], *, fresh: bool, quiet: bool) -> None:
    """Price every bundled scene: ``effects_<scene>.json`` and ``.png`` of each, ``pricing.md`` over all so far."""
    done: dict[str, effect_importance.Pricing | str] = {}
    errors: list[SoftcatError] = []
    for name in bundled_names():
        try:
            selection.choose_effects(cli.scene_of(name, changes))
        except SoftcatError as error:
            errors.append(error)
    if len(errors) == len(bundled_names()):
        raise errors[0]
    output = cli.output_directory(output, "effects")
    with cli.study(fresh=fresh):
        for name in bundled_names():
            contents: dict[str, object] = {}
            try:
                resolved = cli.scene_of(name, changes)
                with terminal.IntegrationProgress(resolved.run.duration, quiet=quiet) as progress:
                    done[name] = pricing = effect_importance.price_effects(resolved, progress, name)
                contents = {
                    f"effects_{name}.json": pricing.to_dict(),
                    f"effects_{name}.png": pricing.plot(),
                }
            # CasADi raises RuntimeError for an integrator that cannot start.
            except (SoftcatError, RuntimeError) as error:
                done[name] = " ".join(str(error).split())
            write_results(output, {"pricing.md": tables.pricing_table(done), **contents})
    if not quiet:
        typer.echo(f"wrote pricing.md and the files of {len(done)} scenes to {output}")
