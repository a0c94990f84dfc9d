"""``softcat scenes``, ``show`` and ``keys``: the bundled scenes, a scene in full, and what it may hold."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli.application import (
    EVERYDAY,
    INTERRUPTED,
    QuietOption,
    SceneArgument,
    SetOption,
    app,
    check_directory,
    directory,
    print_error,
    scene_of,
)
from softcat_sym.cli.completing import complete_scene
from softcat_sym.errors import SoftcatError


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
    from softcat_sym.plotting.gallery import asked_of, exhibit_of, kept_exhibits, write_exhibit, write_gallery
    from softcat_sym.plotting.terminal import StepProgress

    requested = [asked_of(name, changes) for name in names]
    check_directory(output)
    found = kept_exhibits(output)
    done = {
        scene.name: found[scene.name]
        for scene in requested
        if scene.name in found and found[scene.name].identity == scene.identity
    }
    before = len(done)
    try:
        with StepProgress(len(requested) - before, "gallery", quiet=quiet) as progress:
            for scene in requested:
                if scene.name in done:
                    continue
                progress.step(scene.name)
                exhibit, trajectory = exhibit_of(scene)
                write_exhibit(scene, trajectory, {**done, scene.name: exhibit}, output)
                done[scene.name] = exhibit
        written = write_gallery(done, output)
    except KeyboardInterrupt:
        resume = f"{len(done)} of {len(requested)} scenes are in {output}: the same command goes on from there"
        print_error(f"interrupted; {resume if done else 'nothing was written'}")
        raise typer.Exit(INTERRUPTED) from None
    if not quiet:
        there = f" ({before} of them were there)" if before else ""
        files = ", ".join(path.name for path in written)
        typer.echo(f"wrote {files} and {len(done)} scenes{there} to {output}")


@app.command(rich_help_panel=EVERYDAY)
def show(scene: SceneArgument, changes: SetOption = None) -> None:
    """Print a scene as resolved, with every default.

    TOML in SI units, which is a scene again: softcat show ink-bridge > my-ink.toml
    """
    from softcat_sym.scene.toml import toml_of

    typer.echo(toml_of(scene_of(scene, changes), every_default=True), nl=False)


@app.command(rich_help_panel=EVERYDAY)
def keys(
    part: Annotated[
        str, typer.Argument(metavar="[PART]", help="Only keys with this in their names: material, or stress.")
    ] = "",
    markdown: Annotated[bool, typer.Option("--markdown", help="Print the page of the manual instead.")] = False,
) -> None:
    """List the keys of a scene: unit, default and meaning.

    Given a PART of their names, also what each accepts.
    """
    from softcat_sym.scene.keys import keys_in_markdown, scene_keys

    if markdown:
        typer.echo(keys_in_markdown(), nl=False)
        return
    found = scene_keys(part)
    if not found:
        tables = sorted({key.path.split(".")[0] for key in scene_keys()})
        raise SoftcatError(f"no key has {part!r} in its name; tables and keys outside them: {', '.join(tables)}")
    for key in found:
        default = key.default if key.default in ("", "required") else f"default {key.default}"
        typer.echo("  ".join(word for word in (key.path, key.unit and f"[{key.unit}]", default) if word))
        for sentence in [key.meaning, *([f"Accepted: {key.accepted}."] if part else [])]:
            typer.echo(textwrap.fill(sentence, 80, initial_indent="    ", subsequent_indent="    "))
