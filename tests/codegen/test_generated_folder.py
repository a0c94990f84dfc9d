"""The checked-in products are what the program writes today, small enough to read, and build without Python."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
from pathlib import Path

import casadi
import pytest
import sympy

import softcat_sym as sc
from softcat_sym import generation as products
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.export import model_files
from softcat_sym.generation import export

from .building import SANITIZED

ROOT = Path(__file__).parents[2]
FOLDERS = ("arrested-overdamped", "drying-ink")
DIGESTS = Path(__file__).with_name("products.sha256")
LOCKED = dict(line.split("==") for line in (ROOT / ".ci/requirements.txt").read_text("utf-8").split() if "==" in line)
HELP = "run pytest tests/codegen/test_generated_folder.py --update"
needs_locked_versions = pytest.mark.skipif(
    (casadi.__version__, sympy.__version__) != (LOCKED["casadi"], LOCKED["sympy"]),
    reason="the text is that of the locked CasADi and SymPy; answers are compared in test_generated_program.py",
)


def checked_in(path: str) -> bool:
    return path == "README.md" or path.startswith(FOLDERS)


def listed(files: dict[str, str]) -> str:
    """Digests of all files but the runtime, which is package data, as ``sha256sum`` writes them."""
    generated = {path: text for path, text in sorted(files.items()) if not path.startswith("runtime/")}
    return "".join(f"{hashlib.sha256(text.encode()).hexdigest()}  {path}\n" for path, text in generated.items())


@pytest.fixture(scope="module", autouse=True)
def updated(request: pytest.FixtureRequest) -> None:
    if request.config.getoption("--update", default=False):
        files = products.contents(products.bundled())
        DIGESTS.write_text(listed(files), encoding="utf-8")
        for path in filter(checked_in, files):
            (ROOT / "generated" / path).parent.mkdir(exist_ok=True)
            (ROOT / "generated" / path).write_text(files[path], encoding="utf-8")


@needs_locked_versions
def test_the_two_products_are_what_is_generated_today() -> None:
    digests = DIGESTS.read_text(encoding="utf-8")
    for folder in FOLDERS:
        files = model_files(export(sc.load_scene(folder)).description, products.NAME, products.PRODUCTS_COMMAND)
        assert listed({f"{folder}/{name}": text for name, text in files.items()}) in digests, HELP
        for name, text in files.items():
            assert (ROOT / "generated" / folder / name).read_text(encoding="utf-8") == text, HELP


@pytest.mark.slow
@needs_locked_versions
def test_all_products_have_their_digests_and_nothing_is_left_over() -> None:
    files = products.contents(products.bundled())
    assert listed(files) == DIGESTS.read_text(encoding="utf-8"), HELP
    found = {path.relative_to(ROOT / "generated").as_posix() for path in ROOT.glob("generated/**/*") if path.is_file()}
    assert {path for path in found if not path.startswith("examples/")} == set(filter(checked_in, files)), HELP


def test_the_products_are_small_and_say_that_they_are_not_to_be_edited() -> None:
    files = [path for path in ROOT.glob("generated/**/*") if path.is_file()]
    assert sum(len(path.read_text(encoding="utf-8").splitlines()) for path in files) < 5000
    for folder in FOLDERS:
        for name in ("filament.c", "filament.h", "manifest.json"):
            head = (ROOT / "generated" / folder / name).read_text(encoding="utf-8")[:400].lower()
            assert "do not edit" in head and products.PRODUCTS_COMMAND in head


@pytest.fixture(scope="module")
def examples(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder, away from the repository, so that nothing is built within it."""
    copy = tmp_path_factory.mktemp("products")
    for folder in ("generated", "softcat_sym/codegen"):
        shutil.copytree(ROOT / folder, copy / folder)
    return copy / "generated" / "examples"


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
