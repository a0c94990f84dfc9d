"""The checked-in products are what the program writes today, small enough to read, and build without Python."""

from __future__ import annotations

import os
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym import generation as products
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.export import model_files, runtime_files
from softcat_sym.generation import export

from .building import SANITIZED

ROOT = Path(__file__).parent.parent.parent / "generated"
FOLDERS = sorted(path.parent.name for path in ROOT.glob("*/manifest.json"))
HELP = f"run `{products.PRODUCTS_COMMAND}` or pytest tests/codegen/test_generated_folder.py --update"


@pytest.fixture(scope="module", autouse=True)
def updated(request: pytest.FixtureRequest) -> None:
    if request.config.getoption("--update", default=False):
        products.write(ROOT)


@cache
def everything() -> dict[str, str]:
    return products.contents(products.bundled())


def test_the_runtime_is_the_one_of_the_package() -> None:
    for name, text in runtime_files().items():
        assert (ROOT / "runtime" / name).read_text(encoding="utf-8") == text, HELP


@pytest.mark.parametrize(
    "folder", [pytest.param(f, marks=() if f == "rubber-strand" else pytest.mark.slow) for f in FOLDERS]
)
def test_a_product_is_what_is_generated_today(folder: str) -> None:
    files = model_files(export(sc.load_scene(folder)).description, products.NAME, products.PRODUCTS_COMMAND)
    for name, text in files.items():
        assert (ROOT / folder / name).read_text(encoding="utf-8") == text, HELP


@pytest.mark.slow
def test_nothing_is_missing_or_left_over() -> None:
    found = {
        path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8")
        for path in ROOT.rglob("*")
        if path.is_file() and path.suffix in (".c", ".h", ".json", ".md") and path.parent.name != "examples"
    }
    assert sorted(found) == sorted(everything()), HELP
    assert found == everything(), HELP


def test_the_products_are_small_and_say_that_they_are_not_to_be_edited() -> None:
    assert sum(path.stat().st_size for path in ROOT.rglob("*") if path.is_file()) < 1_700_000
    for folder in FOLDERS:
        for name in ("filament.c", "filament.h", "manifest.json"):
            head = (ROOT / folder / name).read_text(encoding="utf-8")[:400].lower()
            assert "do not edit" in head and products.PRODUCTS_COMMAND in head


@pytest.mark.slow
def test_every_law_section_end_and_effect_is_shown() -> None:
    described = products.bundled()
    chosen = products.chosen(described)
    shown = frozenset().union(*(product.features for product in chosen))
    for name, one in described.items():
        assert products.Product(name, one).features <= shown, name
    assert {product.scene for product in chosen} == set(FOLDERS)


@pytest.fixture(scope="module")
def examples(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder, away from the repository, so that nothing is built within it."""
    copy = tmp_path_factory.mktemp("products") / "generated"
    shutil.copytree(ROOT, copy)
    return copy / "examples"


def make(folder: Path, target: str) -> None:
    compiler = find_compiler()
    assert compiler is not None
    tool = shutil.which("make")
    needed(tool, "make")
    flags = " ".join(flag for flag in SANITIZED if flag.startswith("-f"))
    command = [str(tool), target, f"CC={compiler.command[0]}", "OPTIMISED=-O1 -g", f"SANITIZED={flags}"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def needed(tool: str | None, name: str) -> None:
    if tool is None and os.environ.get("SOFTCAT_TESTS_NEED_A_COMPILER"):
        pytest.fail(f"{name} is missing where a compiler is promised")
    if tool is None:
        pytest.skip(f"no {name} here")


def run(program: Path) -> list[list[str]]:
    done = subprocess.run([str(program)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert not done.stderr
    return [line.split(",") for line in done.stdout.splitlines()[1:]]


@pytest.mark.slow
def test_the_example_in_c_is_the_scene(examples: Path) -> None:
    make(examples, "midpoint")
    table = run(examples / "midpoint")
    # The scene by its groups cannot be given a yield stress besides: as resolved it can.
    scene = sc.load_scene("arrested-overdamped").replace(
        {"material.yield_stress": "8 kPa", "run.frames": 5, "run.duration": "2 s"}
    )
    names = list(products.export(sc.load_scene("arrested-overdamped")).description.effects.names)
    truth = sc.simulate(scene.replace({"run.effects": names})).data.midpoint.values
    for row, height in zip(table, truth, strict=True):
        assert float(row[1]) == pytest.approx(height, rel=2e-3, abs=1e-9)
    assert all(float(row[2]) > 0 for row in table[1:])


@pytest.mark.slow
def test_the_example_in_cpp_sweeps_in_threads_and_catches_what_is_refused(examples: Path) -> None:
    needed(shutil.which(os.environ.get("CXX", "c++")), "C++ compiler")
    make(examples, "sweep")
    *table, refused = run(examples / "sweep")
    sags = [float(row[1]) for row in table]
    assert len(sags) == 11 and max(sags[1:6]) < sags[0] and sags[10] < 0.7 * sags[0]
    assert refused[2] == "a parameter is not finite or out of range: yield_stress"
