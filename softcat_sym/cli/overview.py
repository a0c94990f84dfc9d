"""The commands and the page that lists them, without loading the commands or the parser of their options."""

from __future__ import annotations

from shutil import get_terminal_size
from textwrap import wrap
from typing import Final

HELP: Final = ("-h", "--help")

SUMMARY: Final = "Slender soft filaments that sag, stretch, yield and stop."

_OPTIONS: Final = {
    "--version": "Print the version and stop.",
    "--install-completion": "Install completion for the current shell.",
    "--show-completion": "Show completion for the current shell, to copy it or customize the installation.",
    ", ".join(HELP): "Show this message and exit.",
}

COMMANDS: Final = {
    "Everyday": {
        "new": "Write a first scene of your own, with comments.",
        "samples": "Copy sample files: a scene, a film, a flow curve.",
        "run": "Simulate one filament.",
        "draw": "Draw a finished run again: thicker, as a film, or for ParaView.",
        "scenes": "List the bundled scenes, with the lesson of each.",
        "show": "Print a scene as resolved, with every default.",
        "keys": "List the keys of a scene: unit, default and meaning.",
        "explain": "Explain before a run what to expect, and which effects are on.",
        "card": "Find how far, when and over which gap a filament sags.",
        "span": "Find the longest gap that a filament spans with a sag below a limit.",
        "bridges": "Tabulate the sag of bridges of several lengths, for a slicer.",
        "sweep": "Simulate a filament for every value of some parameters.",
    },
    "Fitting": {
        "track": "Track a strand through a film: midpoint and thickness over time, with errors.",
        "fit": "Fit a material to films of a falling filament.",
        "material": "Make the table [material] of a scene from a rheometer's files.",
        "flow-curve": "Fit a law to a rheometer's flow curve.",
        "experiment": "Design the film that determines a material best.",
    },
    "Validation": {
        "validate": "Compare the package with published experiments and computations.",
        "compare": "Compare a filament with finite elements.",
        "accuracy": "Measure time over accuracy, against IDAS and SciPy's Radau.",
        "effects": "Measure each effect's share of the answer, and its cost.",
        "phase": "Map the regimes over planes of dimensionless groups.",
        "figures": "Draw the paper's figures 2, 3(a), 3(b) and 4.",
    },
    "Developer": {
        "generate": "Write the solver of a scene as C99, or as a web page with sliders.",
        "cache": "Show the libraries and results that are kept, or clear them.",
        "doctor": "Check the installation, the compiler and the cache, and run a test.",
    },
}
"""First lines of the commands' docstrings by their names, in the groups and the order of the help."""

INSTANT: Final = ("new", "samples", "scenes", "show", "keys", "cache")
"""Commands that compute nothing, and need no time limit."""

_SHARED: Final = {"samples": "new", "draw": "run", "show": "scenes", "keys": "scenes"}


def home_of(command: str) -> str:
    """Name of the module of a command."""
    return f"softcat_sym.cli.{_SHARED.get(command, command.replace('-', '_'))}"


def overview(program: str) -> str:
    """Text of ``softcat -h``, as wide as the terminal, up to 80 columns."""
    width = max(min(get_terminal_size().columns, 80) - 2, 50)
    lines = [f"Usage: {program} [OPTIONS] COMMAND [ARGS]...", "", f"  {SUMMARY}"]
    for title, rows in {"Options": _OPTIONS, **COMMANDS}.items():
        column = max(map(len, rows if title == "Options" else (name for group in COMMANDS.values() for name in group)))
        lines += ["", f"{title}:"]
        for name, words in rows.items():
            first, *more = wrap(words, width - column - 4)
            lines += [f"  {name:{column}}  {first}", *(" " * (column + 4) + line for line in more)]
    return "\n".join([*lines, "", "  softcat COMMAND -h describes each command; begin with: softcat run ink-bridge"])
