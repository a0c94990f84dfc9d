"""The application that every command registers with, and what commands share: options, scenes, exit statuses."""

from __future__ import annotations

import contextlib
import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from softcat_sym.cli.completing import complete_change, complete_scene

if TYPE_CHECKING:
    from softcat_sym.scene import Scene
    from softcat_sym.solve import Outcome

BAD_INPUT, UNTRUSTED, INTERRUPTED = 2, 1, 130

app = typer.Typer(
    name="softcat",
    help="Slender soft filaments that sag, stretch, yield and stop.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)

_SCENE = typer.Argument(
    metavar="SCENE", help="Name of a bundled scene, or path of a TOML file.", autocompletion=complete_scene
)
SceneArgument = Annotated[str, _SCENE]
OptionalScene = Annotated[str | None, _SCENE]
SetOption = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Change a value of the scene: --set 'material.yield_stress=5 kPa'. Repeatable.",
        autocompletion=complete_change,
    ),
]


def directory(text: str) -> Path:
    """Read the name of a folder; an empty one, as of a variable that is not set, does not mean this folder."""
    if not text.strip():
        raise typer.BadParameter("an empty name is no folder; accepted: the folder of the files, . for this one")
    return Path(text)


OutputOption = Annotated[
    Path, typer.Option("--output", "-o", metavar="DIR", help="Where the files go.", parser=directory)
]
QuietOption = Annotated[bool, typer.Option("--quiet", "-q", help="No progress, no summary.")]


def _version(asked: bool) -> None:
    if asked:
        import importlib.metadata

        typer.echo(f"softcat {importlib.metadata.version('softcat_sym')}")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and stop.")
    ] = False,
) -> None:
    del version


def scene_of(name: str, changes: list[str] | None) -> Scene:
    """Read the scene that a command names, with its changes."""
    from softcat_sym.scene import load_scene

    return load_scene(name, changes or [])


def judge(outcome: Outcome, complaint: str, *, quiet: bool) -> None:
    """Exit with 1 if the answer is not to be trusted."""
    if outcome.is_success:
        return
    if quiet:
        complain(f"{outcome.name}: {complaint}; {outcome.value}")
    raise typer.Exit(UNTRUSTED)


def check_directory(directory: Path) -> None:
    """Refuse a DIR that cannot be written before anything is computed."""
    parent = directory
    while not parent.exists() and parent != parent.parent:
        parent = parent.parent
    if not parent.is_dir():
        raise NotADirectoryError(f"{parent} is not a directory")
    if not os.access(parent, os.W_OK):
        raise PermissionError(f"{parent} cannot be written")


def complain(text: str) -> None:
    """Say what is wrong, where errors go."""
    with contextlib.suppress(BrokenPipeError):  # nobody reads them: the exit status tells
        typer.echo(f"softcat: {text}", err=True)
