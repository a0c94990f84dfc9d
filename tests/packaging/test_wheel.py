"""The wheel: nothing missing, nothing too many, and it works in an empty environment far from the repository."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

pytestmark = pytest.mark.tooling

ROOT = Path(__file__).parents[2]
BUILD = "import sys; from hatchling import build; print(getattr(build, 'build_' + sys.argv[1])(sys.argv[2]))"
USER = """
import softcat_sym as sc

scene: sc.Scene = sc.load_scene("cold-honey", {"numerics.estimate": False})
run: sc.Trajectory = sc.simulate(scene)
sag: float = -float(run.data["midpoint"].values[-1])
names: tuple[str, ...] = sc.bundled_names()
print(sag, run.outcome.name, len(names))
"""
WRONG = USER + "wrong: int = sc.simulate(scene)\n"


def built(kind: str, folder: Path) -> Path:
    """Build a wheel or an sdist without pip, as pip does it."""
    done = subprocess.run(
        [sys.executable, "-c", BUILD, kind, folder], cwd=ROOT, capture_output=True, text=True, check=False, timeout=120
    )
    assert done.returncode == 0, done.stderr
    return folder / done.stdout.split()[-1]


def data_of_package() -> set[str]:
    """Whatever belongs to the package, by path; what an editor or Python leaves behind aside."""
    paths = (path for path in (ROOT / "softcat_sym").rglob("*") if path.is_file())
    return {str(path.relative_to(ROOT)) for path in paths if "__pycache__" not in path.parts and path.name[0] != "."}


def test_wheel_holds_the_package_and_nothing_else(tmp_path: Path) -> None:
    with zipfile.ZipFile(built("wheel", tmp_path)) as wheel:
        names = set(wheel.namelist())
        (about,) = (name for name in names if name.endswith("/METADATA"))
        metadata = wheel.read(about).decode()
        entries = wheel.read(about.replace("METADATA", "entry_points.txt")).decode()
    inside = {name for name in names if not name.split("/")[0].endswith(".dist-info")}
    assert inside == data_of_package()
    assert {"softcat_sym/py.typed", "softcat_sym/scene/bundled/ink-bridge.toml"} < inside
    assert sum(name.endswith((".c", ".h")) for name in inside) >= 30
    assert sum(name.endswith(".html") for name in inside) >= 2
    assert "softcat = softcat_sym.cli:main" in entries
    assert "Requires-Dist: casadi>=" in metadata
    # README is the page of the package: its relative pictures would be broken there, its text is not.
    assert "# softcat_sym" in metadata


def test_sdist_is_small_and_holds_what_builds(tmp_path: Path) -> None:
    path = built("sdist", tmp_path)
    assert path.stat().st_size < 2_000_000
    with tarfile.open(path) as sdist:
        names = {name.partition("/")[2] for name in sdist.getnames()}
    assert data_of_package() <= names
    assert {"pyproject.toml", "README.md", "LICENSE", "CITATION.cff"} <= names
    assert not any(name.startswith(("tests/", "derivations/", "generated/", ".readme/")) for name in names)


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of an environment that holds the wheel and what it requires, nothing else."""
    folder = tmp_path_factory.mktemp("wheel")
    wheel = built("wheel", folder)
    home = folder / "environment"
    subprocess.run([sys.executable, "-m", "venv", home], check=True, timeout=120)
    pip = [home / "bin" / "python", "-m", "pip", "install", "-q", "--disable-pip-version-check", wheel]
    done = subprocess.run(pip, cwd=folder, capture_output=True, text=True, check=False, timeout=900)
    assert done.returncode == 0, done.stderr
    return home


def away(folder: Path, *command: str | Path) -> subprocess.CompletedProcess[str]:
    """Run a command in a folder of no meaning, with no path to the repository and nothing compiled before."""
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "SOFTCAT", "MYPY"))}
    environment |= {"SOFTCAT_CACHE": str(folder / "cache"), "HOME": str(folder)}
    return subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, check=False, timeout=300
    )


@pytest.mark.slow
def test_commands_work_far_from_the_repository(installed: Path, tmp_path: Path) -> None:
    softcat = installed / "bin" / "softcat"
    assert away(tmp_path, softcat, "--version").stdout.startswith("softcat 0.")
    assert "continual-descent" in away(tmp_path, softcat, "scenes").stdout
    assert "Usage: softcat" in away(tmp_path, softcat, "--help").stdout
    done = away(tmp_path, softcat, "run", "continual-descent", "-o", "out")
    assert done.returncode == 0, done.stderr
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert (summary["outcome"], summary["regime"]) == ("solved", "descending")
    assert {"trajectory.nc", "scene.toml", "midpoint.csv", "shapes.png"} <= {
        p.name for p in (tmp_path / "out").iterdir()
    }
    # The C runtime and the templates are package data: they are there, and so they are written.
    assert away(tmp_path, softcat, "generate", "cold-honey", "-o", "c", "-q").returncode == 0
    assert (tmp_path / "c" / "softcat_rosenbrock.c").is_file()
    assert away(tmp_path, softcat, "scenes", "-q", "--only", "cold-honey", "-o", "gallery").returncode == 0
    assert (tmp_path / "gallery" / "gallery.html").is_file()


@pytest.mark.slow
def test_every_command_shows_its_help(installed: Path, tmp_path: Path) -> None:
    from typer.main import get_command

    from softcat_sym.cli.application import app

    for name in get_command(app).commands:  # type: ignore[attr-defined]
        done = away(tmp_path, installed / "bin" / "softcat", name, "--help")
        assert done.returncode == 0, done.stderr


@pytest.mark.slow
def test_python_finds_the_installed_package(installed: Path, tmp_path: Path) -> None:
    (tmp_path / "user.py").write_text(USER, encoding="utf-8")
    done = away(tmp_path, installed / "bin" / "python", "user.py")
    assert done.returncode == 0, done.stderr
    sag, outcome, count = done.stdout.split()
    # As deep as its scene says, and no further.
    assert 0.3 < float(sag) / 0.05 < 0.4
    assert (outcome, int(count) >= 29) == ("solved", True)
    where = away(tmp_path, installed / "bin" / "python", "-c", "import softcat_sym; print(softcat_sym.__file__)").stdout
    assert str(installed) in where


@pytest.mark.slow
def test_a_users_types_are_checked_against_the_installed_package(installed: Path, tmp_path: Path) -> None:
    mypy = [sys.executable, "-m", "mypy", "--strict", "--python-executable", installed / "bin" / "python"]
    for name, text in (("right.py", USER), ("wrong.py", WRONG)):
        (tmp_path / name).write_text(text, encoding="utf-8")
    right = away(tmp_path, *mypy, "right.py")
    assert right.returncode == 0, right.stdout
    wrong = away(tmp_path, *mypy, "wrong.py")
    assert wrong.returncode == 1
    assert 'expression has type "Trajectory", variable has type "int"' in wrong.stdout


@pytest.mark.slow
def test_nothing_of_the_test_suite_is_installed(installed: Path) -> None:
    (site,) = installed.glob("lib/python*/site-packages")
    assert (site / "softcat_sym" / "py.typed").is_file()
    assert not [name for name in ("tests", "derivations", "generated") if (site / name).exists()]
