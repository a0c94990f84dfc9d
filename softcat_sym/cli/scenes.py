"""``softcat scenes``, ``show`` and ``keys``: the bundled scenes, a scene in full, and the keys of scenes."""

from __future__ import annotations

import textwrap
from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.cli.completing import complete_scene
from softcat_sym.errors import SoftcatError
from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.bundled import bundled_lesson, bundled_names, bundled_title

with lazy_imports():
    from softcat_sym.plotting import gallery, terminal
    from softcat_sym.scene import keys as scene_keys
    from softcat_sym.scene import reading
    from softcat_sym.scene import toml as scene_toml


def scenes(
    output: Annotated[
        Path | None, cli.output_option(None, "Run the scenes, and write a gallery into this folder.")
    ] = None,
    only: Annotated[
        cli.Texts, cli.option("NAME", "Take only this scene. Repeatable.", autocompletion=complete_scene)
    ] = None,
    changes: cli.SetOption = None,
    quiet: cli.QuietOption = False,
) -> None:
    """List the bundled scenes, with the lesson of each.

    With -o the command runs all scenes, and writes a gallery into DIR.
    The gallery is gallery.html and gallery.png, a picture and a TOML file of each scene, gallery.csv and gallery.json.
    Each scene is run once, without an estimate of its error: a minute for all. After Ctrl-C the same command resumes
    from the finished scenes.
    """
    if unknown := [name for name in only or () if name not in bundled_names()]:
        raise typer.BadParameter(f"no bundled scene {unknown[0]!r}: softcat scenes lists them", param_hint="--only")
    names = [name for name in bundled_names() if not only or name in only]
    if output is not None:
        cli.check_directory(output)
        for name in names:
            reading.load_scene(name, changes or [])
        shown = []
        with cli.study(fresh=False), terminal.StepProgress(len(names), "gallery", quiet=quiet) as progress:
            for name in names:
                progress.step(name)
                shown.append(gallery.scene_run(name, changes or []))
            written = gallery.gallery_report(shown, changes or []).write(output)
        if not quiet:
            files = ", ".join(path.name for path in written[:4])
            typer.echo(f"wrote {files} and {len(shown)} scenes to {output}")
        return
    if changes:
        raise typer.BadParameter("--set changes what is run: add -o DIR, which runs the scenes", param_hint="--set")
    width = max(map(len, names))
    for name in names:
        typer.echo(f"{name:{width}}  {bundled_title(name)}\n    {bundled_lesson(name)}")


def show(scene: cli.SceneArgument, changes: cli.SetOption = None) -> None:
    """Print a scene as resolved, with every default.

    The output is TOML in SI units, and a valid scene itself: softcat show ink-bridge > my-ink.toml
    """
    typer.echo(scene_toml.toml_of(cli.scene_of(scene, changes), every_default=True), nl=False)


def keys(
    part: Annotated[str, typer.Argument(metavar="[PART]", help="Part of a key's name: material, or stress.")] = "",
    markdown: Annotated[bool, cli.switch("Print the list as a page of the manual.", "--markdown")] = False,
) -> None:
    """List the keys of a scene: unit, default and meaning.

    With PART, the command lists the keys whose names contain it, and the values that each accepts.
    """
    if markdown:
        typer.echo(scene_keys.keys_in_markdown(), nl=False)
        return
    found = scene_keys.scene_keys(part)
    if not found:
        tables = sorted({key.path.split(".")[0] for key in scene_keys.scene_keys()})
        raise SoftcatError(f"no key has {part!r} in its name; tables and keys outside them: {', '.join(tables)}")
    for key in found:
        default = key.default if key.default in ("", "required") else f"default {key.default}"
        typer.echo("  ".join(word for word in (key.path, key.unit and f"[{key.unit}]", default) if word))
        for sentence in [key.meaning, *([f"Accepted: {key.accepted}."] if part else [])]:
            typer.echo(textwrap.fill(sentence, 80, initial_indent="    ", subsequent_indent="    "))
