"""``softcat scenes``: the bundled scenes, as a list or as a gallery."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.application import (
    EVERYDAY,
    INTERRUPTED,
    QuietOption,
    SetOption,
    app,
    check_directory,
    directory,
    print_error,
)
from softcat_sym.cli.completing import complete_scene

if TYPE_CHECKING:
    from softcat_sym.studies.gallery import Asked, Exhibit


@app.command(rich_help_panel=EVERYDAY)
def scenes(
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="DIR", help="Run them, and write a gallery here.", parser=directory),
    ] = None,
    only: Annotated[
        list[str] | None,
        typer.Option("--only", metavar="NAME", help="Only this scene. Repeatable.", autocompletion=complete_scene),
    ] = None,
    changes: SetOption = None,
    quiet: QuietOption = False,
) -> None:
    """List the bundled scenes and what to learn from each.

    With -o they are all run, and a gallery is written into DIR.
    The gallery is gallery.html and gallery.png, a picture and a TOML file of each scene, gallery.csv and gallery.json.
    Each scene is run once, without an estimate of its error: a minute for all. After Ctrl-C the same command goes on;
    scenes that are there already are not run again.
    """
    from softcat_sym.scene.bundled import bundled_lesson, bundled_names, bundled_title

    if unknown := [name for name in only or () if name not in bundled_names()]:
        raise typer.BadParameter(f"no bundled scene {unknown[0]!r}: softcat scenes lists them", param_hint="--only")
    names = [name for name in bundled_names() if not only or name in only]
    if output is not None:
        _gallery(names, changes or [], output, quiet=quiet)
        return
    if changes:
        raise typer.BadParameter("changes what is run: it takes -o DIR beside it", param_hint="--set")
    width = max(map(len, names))
    for name in names:
        typer.echo(f"{name:{width}}  {bundled_title(name)}\n    {bundled_lesson(name)}")


def _gallery(names: list[str], changes: list[str], output: Path, *, quiet: bool) -> None:
    from softcat_sym.plotting.gallery import kept_exhibits, write_gallery
    from softcat_sym.studies.gallery import asked_of

    asked = [asked_of(name, changes) for name in names]
    check_directory(output)
    found = kept_exhibits(output)
    done = {one.name: found[one.name] for one in asked if _stands(found.get(one.name), one)}
    before = len(done)
    try:
        _run([one for one in asked if one.name not in done], done, output, quiet=quiet)
        written = write_gallery(done, output)
    except KeyboardInterrupt:
        kept = f"{len(done)} of {len(asked)} scenes are in {output}: the same command goes on from there"
        print_error(f"interrupted; {kept if done else 'nothing was written'}")
        raise typer.Exit(INTERRUPTED) from None
    if not quiet:
        there = f" ({before} of them were there)" if before else ""
        files = ", ".join(path.name for path in written)
        typer.echo(f"wrote {files} and {len(done)} scenes{there} to {output}")


def _stands(kept: Exhibit | None, asked: Asked) -> bool:
    """Whether an earlier exhibit is of this very scene and program."""
    return kept is not None and kept.identity == asked.identity


def _run(asked: list[Asked], done: dict[str, Exhibit], output: Path, *, quiet: bool) -> None:
    """Run scenes, each of which is in its place before the next begins."""
    from softcat_sym.plotting.gallery import write_exhibit
    from softcat_sym.plotting.terminal import StepProgress
    from softcat_sym.studies.gallery import exhibit_of

    with StepProgress(len(asked), "gallery", quiet=quiet) as progress:
        for one in asked:
            progress.step(one.name)
            exhibit, trajectory = exhibit_of(one)
            write_exhibit(one, trajectory, {**done, one.name: exhibit}, output)
            done[one.name] = exhibit
