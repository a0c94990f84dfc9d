"""``softcat effects``: what each effect is worth, and what it costs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    VALIDATION,
    FreshOption,
    OptionalScene,
    OutputOption,
    QuietOption,
    SetOption,
    app,
    judge,
    output_directory,
    scene_and_directory,
    scene_of,
    study,
)
from softcat_sym.errors import SoftcatError

if TYPE_CHECKING:
    from collections.abc import Callable
    from contextlib import AbstractContextManager
    from pathlib import Path

    from softcat_sym.scene.scene import Scene
    from softcat_sym.solvers.solution import Progress


@app.command(rich_help_panel=VALIDATION)
def effects(
    scene: OptionalScene = None,
    output: OutputOption = None,
    bundled: Annotated[bool, typer.Option("--bundled", help="All bundled scenes instead, with a table.")] = False,
    fresh: FreshOption = False,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """Tell what each effect is worth, and what it costs.

    Each is put in or left out in turn: effects.csv, .json and .png in DIR.
    After Ctrl-C the same command takes finished answers from the store; times are always measured anew. With --bundled
    --set changes every scene, and a scene that cannot be priced is a line of the table; it takes many minutes.
    """
    if bundled is (scene is not None):
        raise typer.BadParameter("name one scene, or ask for --bundled, not both", param_hint="SCENE")
    if scene is None:
        _all(output, changes or [], fresh=fresh, quiet=quiet)
    else:
        _one(scene, *scene_and_directory(scene, changes, output, "effects"), fresh=fresh, quiet=quiet)


def _one(name: str, asked: Scene, output: Path, *, fresh: bool, quiet: bool) -> None:
    from softcat_sym.plotting.pricing import print_pricing, write_pricing
    from softcat_sym.plotting.terminal import FitProgressBar
    from softcat_sym.studies.pricing import price_effects

    with study(output, fresh=fresh):
        pricing = price_effects(asked, _listening(asked, "", quiet=quiet), name)
        with FitProgressBar(quiet=quiet) as progress:
            progress.stage("drawing", 0, 1)
            written = write_pricing(pricing, output)
    if not quiet:
        print_pricing(pricing)
        typer.echo(f"wrote {', '.join(path.name for path in written)} to {output}")
    judge(pricing.base.outcome, pricing.base.message, quiet=quiet)


def _all(output: Path | None, changes: list[str], *, fresh: bool, quiet: bool) -> None:
    from softcat_sym.plotting.pricing import write_pricings
    from softcat_sym.scene.bundled import bundled_names
    from softcat_sym.studies.pricing import price_bundled

    refused = [error for name in bundled_names() if (error := _refusal(name, changes)) is not None]
    if len(refused) == len(bundled_names()):
        raise refused[0]
    output = output_directory(output, "effects")

    def listening(name: str, asked: Scene) -> Callable[[str], AbstractContextManager[Progress]]:
        names = bundled_names()
        return _listening(asked, f"{names.index(name) + 1} of {len(names)}, {name}, ", quiet=quiet)

    with study(output, fresh=fresh):
        written = write_pricings(price_bundled(bundled_names(), listening, changes), output)
    if not quiet:
        typer.echo(f"wrote {len(written)} files to {output}, among them {written[-1].name}")


def _refusal(name: str, changes: list[str]) -> SoftcatError | None:
    """What is wrong with the changes of a scene, if anything is."""
    from softcat_sym.effects.choosing import choose_effects

    try:
        choose_effects(scene_of(name, changes))
    except SoftcatError as error:
        return error
    return None


def _listening(asked: Scene, before: str, *, quiet: bool) -> Callable[[str], AbstractContextManager[Progress]]:
    from softcat_sym.plotting.terminal import IntegrationProgress

    return lambda what: IntegrationProgress(asked.run.duration, f"{before}{what}", quiet=quiet)
