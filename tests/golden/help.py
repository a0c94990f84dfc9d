"""What ``softcat --help``, ``softcat COMMAND --help`` and ``softcat_sym.__all__`` say, in one text file.

``python -m tests.golden.help`` writes ``help.txt`` anew; ``tests/test_command_line.py`` compares it.
"""

from __future__ import annotations

import os
from pathlib import Path

import typer.main

import softcat_sym as sc
from softcat_sym.cli.application import app

FILE = Path(__file__).with_name("help.txt")
WIDTH = 80


def texts() -> str:
    """The help of the program, where COLUMNS is 80, and of every command, and the public names."""
    group = typer.main.get_command(app)
    settings = {"terminal_width": WIDTH, "max_content_width": WIDTH, "color": False, "resilient_parsing": True}
    parts = []
    with group.make_context("softcat", [], **settings) as above:
        parts.append(("softcat --help", group.get_help(above)))
        for name in group.list_commands(above):  # type: ignore[attr-defined]
            command = group.get_command(above, name)  # type: ignore[attr-defined]
            with command.make_context(name, [], parent=above, **settings) as context:
                parts.append((f"softcat {name} --help", command.get_help(context)))
    parts.append(("softcat_sym.__all__", "\n".join(sc.__all__)))
    return "\n\n".join(f"===== {title}\n{text.rstrip()}" for title, text in parts) + "\n"


if __name__ == "__main__":
    os.environ["COLUMNS"] = str(WIDTH)
    FILE.write_text(texts(), encoding="utf-8")
