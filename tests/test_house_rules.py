"""Rules of the house that a machine can check: layers, types, style, complexity, and how light the import is."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent


def run(*command: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


@pytest.mark.tooling
@pytest.mark.parametrize(
    "tool",
    [
        ("ruff", "check", "--no-cache", "."),
        ("ruff", "format", "--no-cache", "--check", "."),
        ("mypy", "--no-incremental"),
    ],
    ids=lambda tool: " ".join(tool[:2]),
)
def test_tool_is_content(tool: tuple[str, ...]) -> None:
    done = run(sys.executable, "-m", *tool)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.tooling
def test_layers_are_kept() -> None:
    done = run(
        sys.executable, "-c", "from importlinter.cli import lint_imports_command; lint_imports_command()", "--no-cache"
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "0 broken" in done.stdout


def test_at_most_eight_exception_classes_each_with_advice() -> None:
    from softcat_sym import errors

    classes = [e for e in vars(errors).values() if isinstance(e, type) and issubclass(e, Exception)]
    assert len(classes) <= 8
    assert all(e.__doc__ for e in classes)


def test_import_loads_neither_sympy_nor_casadi_nor_matplotlib() -> None:
    code = (
        "import sys, softcat_sym\n"
        "heavy = {'sympy', 'casadi', 'matplotlib', 'xarray', 'pint', 'pydantic'} & set(sys.modules)\n"
        "assert not heavy, heavy"
    )
    done = run(sys.executable, "-c", code)
    assert done.returncode == 0, done.stderr


def test_every_public_name_is_documented() -> None:
    import softcat_sym as sc

    for name in sc.__all__:
        thing = getattr(sc, name)
        assert thing.__doc__, name
    assert callable(sc.simulate)
    with pytest.raises(AttributeError, match="has no attribute 'simulat'"):
        _ = sc.simulat  # type: ignore[attr-defined]


def test_a_filament_is_assembled_without_the_slow_parts_of_sympy() -> None:
    code = (
        "import sys, softcat_sym as sc\n"
        "from softcat_sym.effects.choosing import choose_effects\n"
        "from softcat_sym.solvers.run import assembled\n"
        "scene = sc.load_scene('arrested-overdamped')\n"
        "assembled(scene, choose_effects(scene))\n"
        "assert 'sympy.physics.units' not in sys.modules, 'simplify loads it, in a seventh of a second'"
    )
    done = run(sys.executable, "-c", code)
    assert done.returncode == 0, done.stderr
