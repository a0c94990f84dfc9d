"""The application that every command registers with, and what commands share: options, scenes, exit statuses."""

from __future__ import annotations

import contextlib
import os
import re
import threading
from collections.abc import Iterable, Iterator, Sequence
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
import typer.main
from typer.core import TyperGroup

from softcat_sym.cli.completing import complete_change, complete_scene
from softcat_sym.cli.overview import COMMANDS, HELP, INSTANT, SUMMARY, home_of, overview
from softcat_sym.interrupts import ending
from softcat_sym.lazy import lazy_imports

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene
    from softcat_sym.solvers.outcome import Outcome

with lazy_imports():
    from importlib import metadata

    from softcat_sym import drawing, store
    from softcat_sym.effects import selection
    from softcat_sym.scene import reading

BAD_INPUT, UNTRUSTED, INTERRUPTED = 2, 1, 130

_CHANGES_SHOWN = 4

_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"


_LOOK: dict[str, Any] = {
    "context_settings": {"help_option_names": list(HELP)},
    "pretty_exceptions_enable": False,
    "rich_markup_mode": None,
}


class _Softcat(TyperGroup):
    """Loads a command when it is called, and lists all commands under the names of their groups."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings)
        # The names alone; typer looks among them for the one that was meant.
        self.commands: Any = dict.fromkeys(name for group in COMMANDS.values() for name in group)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """Load the module of a command, and make its function a command, with a time limit if it computes."""
        if cmd_name not in self.commands:
            return None
        alone = typer.Typer(add_completion=False, **_LOOK)
        alone.command(cmd_name)(getattr(import_module(home_of(cmd_name)), cmd_name.replace("-", "_")))
        command = typer.main.get_command(alone)
        if cmd_name not in INSTANT and not any(one.name == "time_limit" for one in command.params):
            command.params.extend(typer.main.get_command(_limit).params)
        return command

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Answer a call for the help of a command early, as typer would load pydantic to read the option."""
        name, *others = args or [""]
        if name in self.commands and not ctx.resilient_parsing and not {*HELP}.isdisjoint(others):
            command = self.get_command(ctx, name)
            typer.echo(command.get_help(type(ctx)(command, info_name=name, parent=ctx)))
            ctx.exit()
        return super().parse_args(ctx, args)

    def get_help(self, ctx: Any) -> str:
        return overview(ctx.command_path)


def _begin_limit(ctx: typer.Context, seconds: float | None) -> None:
    if checked_limit(seconds) and not ctx.resilient_parsing:
        ending().limit(float(seconds or 0.0))


def checked_limit(seconds: float | None) -> float | None:
    """Refuse what is no time limit [s]."""
    if seconds is not None and not 0 < seconds < threading.TIMEOUT_MAX:
        raise typer.BadParameter(f"{seconds:g} s is no limit; accepted: a positive number", param_hint="--time-limit")
    return seconds


def option(metavar: str | None, help_text: str, *names: str, **settings: Any) -> Any:
    """An option of a command, named as its parameter unless `names` say otherwise."""
    return typer.Option(*names, metavar=metavar, help=help_text, **settings)


def switch(help_text: str, *names: str) -> Any:
    """An option without a value."""
    return typer.Option(*names, help=help_text)


Text = str | None
Texts = list[str] | None
Number = float | None
"""Types of options that may be left out."""

_TimeLimit = Annotated[
    Number,
    option(
        "SECONDS",
        "Time after which the command stops, with what it has and status 1.",
        callback=_begin_limit,
        expose_value=False,
    ),
]
_limit = typer.Typer(add_completion=False)


@_limit.command()
def _limited(time_limit: _TimeLimit = None) -> None:
    """Have the option of every command that computes: at the limit it ends as by Ctrl-C."""


app = typer.Typer(name="softcat", cls=_Softcat, help=SUMMARY, no_args_is_help=True, **_LOOK)

_SCENE = typer.Argument(
    metavar="SCENE", help="Name of a bundled scene, or path of a TOML file.", autocompletion=complete_scene
)
SceneArgument = Annotated[str, _SCENE]
OptionalScene = Annotated[str | None, _SCENE]
SetOption = Annotated[
    Texts,
    option(
        "KEY=VALUE",
        "Change a value of the scene: --set 'material.yield_stress=5 kPa'. Repeatable.",
        "--set",
        autocompletion=complete_change,
    ),
]


def directory(text: str) -> Path:
    """Read the name of a folder; an empty name, such as that of an unset variable, is refused."""
    if not text.strip():
        raise typer.BadParameter("an empty name is no folder; accepted: the name of a folder, or . for the present one")
    return Path(text)


def output_option(default: str | None, help_text: str = "Folder for the files.") -> Any:
    """The option ``-o DIR`` of a command."""
    return option("DIR", help_text, "--output", "-o", show_default=default or False, parser=directory)


OutputOption = Annotated[Path | None, output_option("softcat-out/SCENE-COMMAND")]
FreshOption = Annotated[
    bool, switch("Run everything again, even what an earlier command has finished (see softcat cache).", "--fresh")
]
MaxSagOption = Annotated[str, option("LENGTH", "Largest sag allowed: '0.2 mm', or '5 %' of the span.")]
QuietOption = Annotated[bool, switch("Print no progress and no summary.", "--quiet", "-q")]
VerboseOption = Annotated[bool, switch("Print everything, with reasons and formulas.", "--verbose", "-v")]


def _version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"softcat {metadata.version('softcat_sym')}")
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
    return reading.load_scene(name, changes or [])


def output_directory(
    output: Path | None, command: str, scene: str | None = None, resolved: Scene | None = None
) -> Path:
    """Return the writable DIR of a command: that of ``-o``, or a separate folder for each scene and command."""
    if output is None:
        parts = ([] if scene is None else [Path(scene).name.removesuffix(".toml")]) + [command] * (command != "run")
        output = Path("softcat-out") / "-".join(parts)
    try:
        check_directory(output)
    except OSError:
        if resolved is not None:
            selection.choose_effects(resolved)
        raise
    return output


def scene_and_directory(
    name: str, changes: list[str] | None, output: Path | None, command: str, settings: Sequence[str] = ()
) -> tuple[Scene, Path]:
    """Return the scene and the DIR of a command; faults of the scene and of its effects are reported first."""
    resolved = scene_of(name, [*settings, *(changes or [])])
    output = output_directory(output, command, name, resolved)
    if (output / "scene.toml").is_file():
        _tell_what_is_replaced(resolved, output)
    return resolved, output


def _tell_what_is_replaced(resolved: Scene, output: Path) -> None:
    """Print what is different in the scene whose results are in DIR, if it is another one."""
    from softcat_sym.errors import SceneError
    from softcat_sym.scene.reading import load_scene

    try:
        there = load_scene(output / "scene.toml")
    except SceneError:
        return
    changed = [f"{path} {before} -> {now}" for path, (before, now) in there.differences(resolved).items()]
    if changed:
        more = f" and {len(changed) - _CHANGES_SHOWN} more" if len(changed) > _CHANGES_SHOWN else ""
        listed = ", ".join(changed[:_CHANGES_SHOWN])
        print_error(f"{output} has results of another scene, which are replaced: {listed}{more}; -o DIR keeps them")


def present(result: object, output: Path, *, quiet: bool, **beside: Any) -> None:
    """Write the files of a result into DIR, and print its report and their names."""
    report = result if isinstance(result, drawing.Report) else drawing.report(result, **beside)
    written = report.write(output)
    if not quiet:
        report.print()
        print_written(written, output)


def print_written(written: Iterable[Path], output: Path) -> None:
    """Print the names of files in DIR."""
    typer.echo(f"wrote {', '.join(path.relative_to(output).as_posix() for path in written)} to {output}")


def judge(outcome: Outcome, message: str, *, quiet: bool) -> None:
    """Exit with 1 if the answer is not to be trusted."""
    if outcome.is_answer:
        return
    if quiet:
        print_error(f"{outcome.name}: {message}; {outcome.value}")
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


def interrupted(left: str) -> typer.Exit:
    """Print what is left of an interrupted command, and return its exit."""
    print_error(f"{ending()}; {left}")
    return typer.Exit(INTERRUPTED)


@contextlib.contextmanager
def study(*, fresh: bool) -> Iterator[None]:
    """Use finished runs from the store unless `fresh`; after Ctrl-C print how to resume."""
    with store.fresh(fresh):
        try:
            yield
        except KeyboardInterrupt:
            raise interrupted("the same command resumes from what was finished") from None


def read_pair(text: str) -> tuple[str, str] | None:
    """Split ``low:high unit``; a lower value without a unit has that of the upper one. None if the text is no pair."""
    ends = [end.strip() for end in text.split(":")]
    if len(ends) != 2 or not all(ends):
        return None
    low, high = ends
    unit = re.sub(rf"^{_NUMBER}\s*", "", high)
    return (f"{low} {unit}".strip() if re.fullmatch(_NUMBER, low) else low, high)


def print_error(text: str) -> None:
    """Print a message on standard error."""
    with contextlib.suppress(BrokenPipeError):  # If nobody reads the message, the exit status remains
        typer.echo(f"softcat: {text}", err=True)
