"""Rules of the house that a machine can check: style, complexity, types, layers, exceptions."""

from __future__ import annotations

import ast
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

from softcat_sym import errors
from softcat_sym.effects.registry import REGISTRY

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


@pytest.mark.tooling
def test_no_module_imports_itself_by_way_of_others() -> None:
    graph = pytest.importorskip("grimp").build_graph("softcat_sym", cache_dir=None)
    # It raises CycleError, with the circle; imports that only annotations need count, too.
    TopologicalSorter({name: graph.find_modules_directly_imported_by(name) for name in graph.modules}).prepare()


def test_at_most_eight_exception_classes_each_with_advice() -> None:
    classes = [each for each in vars(errors).values() if isinstance(each, type) and issubclass(each, Exception)]
    assert len(classes) <= 8
    assert all(each.__doc__ for each in classes)


WORDS = {"backstress", "bending", "shear", "fibres", "inertia", "structure", "temperature", "thinning", "yielding"}
WORDS |= {"added-mass", "buoyancy", "contact", "curing", "drag", "natural-strain"}
"""Names that are quantities, too: as a column, a key, or of densities and clocks in the physics they name no effect."""

FLAGS = {("cli/new.py", "surface-tension")}
"""An option of the command line for the key of this name."""


@pytest.mark.tooling
def test_no_file_outside_effects_names_one() -> None:
    """Nothing but estimates of them imports an effect, compares with its name or looks it up; words may be keys."""
    package, names = Path(errors.__file__).parent, {effect.name for effect in REGISTRY}
    modules = {f"softcat_sym.effects.{name.replace('-', '_')}" for name in names}
    found = []
    for path in sorted(package.rglob("*.py")):
        where = path.relative_to(package).as_posix()
        if where.startswith(("effects/", "estimates/")):
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        compared = {
            id(part)
            for node in ast.walk(tree)
            if isinstance(node, ast.Compare)
            for side in (node.left, *node.comparators)
            for part in ast.walk(side)
        }
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module in modules:
                found.append(f"{where}:{node.lineno} imports {node.module}")
            if not isinstance(node, ast.Constant) or node.value not in names or (where, node.value) in FLAGS:
                continue
            if node.value not in WORDS or (id(node) in compared and (where, node.value) not in COLUMNS):
                found.append(f"{where}:{node.lineno} names {node.value!r}")
    assert not found, "\n".join(found)
    assert len(modules) == len(REGISTRY) > 15


COLUMNS = {("plotting/paper_figures.py", "shear"), ("discretization/shearing.py", "shear")}
"""A field of the trajectory, and a kind of plastic state, that are asked for by name."""
