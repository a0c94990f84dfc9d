"""Rules of the house that a machine can check: style, complexity, types, layers, exceptions."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from softcat_sym import errors

LAYERS = "from importlinter.cli import lint_imports_command; lint_imports_command()"
TOOLS = {
    "style": ("-m", "ruff", "check", "--no-cache", "."),
    "format": ("-m", "ruff", "format", "--no-cache", "--check", "."),
    "types": ("-m", "mypy", "--no-incremental"),
    "layers": ("-c", LAYERS, "--no-cache"),
}


@pytest.mark.tooling
@pytest.mark.parametrize("tool", TOOLS)
def test_tool_is_content(tool: str) -> None:
    command, root = [sys.executable, *TOOLS[tool]], Path(__file__).parent.parent
    done = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert tool != "layers" or "0 broken" in done.stdout


def test_at_most_eight_exception_classes_each_with_advice() -> None:
    classes = [each for each in vars(errors).values() if isinstance(each, type) and issubclass(each, Exception)]
    assert len(classes) <= 8
    assert all(each.__doc__ for each in classes)
