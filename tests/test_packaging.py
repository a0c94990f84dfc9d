"""What others get: the wheel in an empty environment, the documentation without a warning, the citation."""

from __future__ import annotations

import html
import inspect
import os
import re
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urldefrag

import pytest
import typer.main
import yaml

import softcat_sym as sc
from softcat_sym.cli.application import app
from softcat_sym.results.run import REFERENCES

ROOT = Path(__file__).parents[1]
COMMANDS = list(typer.main.get_command(app).commands)  # type: ignore[attr-defined]


def test_the_citation_is_whole_and_says_what_the_package_says() -> None:
    citation: dict[str, Any] = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert (citation["cff-version"], citation["type"], bool(citation["message"])) == ("1.2.0", "software", True)
    assert (citation["version"], citation["license"]) == (project["version"], project["license"])
    assert [author["name"] for author in citation["authors"]] == [author["name"] for author in project["authors"]]
    for work in citation["references"]:
        assert {"authors", "title", "type"} <= set(work) and isinstance(work.get("year", 2012), int)
        assert re.fullmatch(r"10\.\d{4,9}/\S+", work.get("doi", "10.1000/x"))
    # The paper is the one that a run rests on, and the README names.
    paper = citation["references"][0]
    readme = (ROOT / "README.md").read_text(encoding="utf-8").split("## Cite")[1]
    for text in (" ".join(REFERENCES), readme):
        assert all(author["family-names"] in text for author in paper["authors"])
        assert paper["title"] in text and str(paper["year"]) in text


BUILD = "import sys; from hatchling import build; print(getattr(build, 'build_' + sys.argv[1])(sys.argv[2]))"
USER = """
import softcat_sym as sc

scene: sc.Scene = sc.load_scene("cold-honey", {"numerics.estimate": False})
run: sc.Run = sc.simulate(scene)
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
    paths = (path.relative_to(ROOT) for path in (ROOT / "softcat_sym").rglob("*") if path.is_file())
    return {path.as_posix() for path in paths if "__pycache__" not in path.parts and path.name[0] != "."}


@pytest.mark.tooling
def test_wheel_and_sdist_hold_the_package_and_nothing_else(tmp_path: Path) -> None:
    with zipfile.ZipFile(built("wheel", tmp_path)) as wheel:
        names = set(wheel.namelist())
        (about,) = (name for name in names if name.endswith("/METADATA"))
        metadata = wheel.read(about).decode()
        entries = wheel.read(about.replace("METADATA", "entry_points.txt")).decode()
    inside = {name for name in names if not name.split("/")[0].endswith(".dist-info")}
    assert inside == data_of_package()
    assert {"softcat_sym/py.typed", "softcat_sym/scene/bundled/ink-bridge.toml"} < inside
    assert sum(name.endswith((".c", ".h")) for name in inside) >= 30
    assert sum(name.endswith(".html") for name in inside) >= 1
    assert "softcat = softcat_sym.cli:main" in entries
    assert "[cosseratbench.solvers]\nsoftcat_sym = softcat_sym.cosserat_benchmark:" in entries
    # README is the page of the package: its relative pictures would be broken there, its text is not.
    assert "Requires-Dist: casadi>=" in metadata and "# softcat_sym" in metadata
    path = built("sdist", tmp_path)
    assert path.stat().st_size < 2_000_000
    with tarfile.open(path) as sdist:
        names = {name.partition("/")[2] for name in sdist.getnames()}
    assert data_of_package() | {"pyproject.toml", "README.md", "LICENSE", "CITATION.cff"} <= names
    assert not any(name.startswith(("tests/", "derivations/", "generated/", ".readme/")) for name in names)


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of an environment that holds the wheel and what it requires, nothing else."""
    folder = tmp_path_factory.mktemp("wheel")
    wheel, home = built("wheel", folder), folder / "environment"
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
@pytest.mark.tooling
def test_python_finds_the_installed_package_with_its_types_and_no_tests(installed: Path, tmp_path: Path) -> None:
    python = installed / "bin" / "python"
    for name, text in (("right.py", USER), ("wrong.py", WRONG)):
        (tmp_path / name).write_text(text, encoding="utf-8")
    done = away(tmp_path, python, "right.py")
    assert done.returncode == 0, done.stderr
    sag, outcome, count = done.stdout.split()
    # As deep as its scene says, and no further.
    assert 0.3 < float(sag) / 0.05 < 0.4
    assert (outcome, int(count) >= 29) == ("solved", True)
    assert str(installed) in away(tmp_path, python, "-c", "import softcat_sym; print(softcat_sym.__file__)").stdout
    (site,) = installed.glob("lib/python*/site-packages")
    assert (site / "softcat_sym" / "py.typed").is_file()
    assert not [name for name in ("tests", "derivations", "generated") if (site / name).exists()]
    mypy = [sys.executable, "-m", "mypy", "--strict", "--python-executable", python]
    right, wrong = away(tmp_path, *mypy, "right.py"), away(tmp_path, *mypy, "wrong.py")
    assert (right.returncode, wrong.returncode) == (0, 1), right.stdout
    assert 'expression has type "Run", variable has type "int"' in wrong.stdout


NOTEBOOKS = ("tutorials/13_first_run", "tutorials/14_ink_bridging", "tutorials/15_fit_your_data")
NOTEBOOKS += ("howto/12_own_rheology", "howto/16_take_the_c_away")
KINDS = ("Tutorials", "How-to guides", "Reference", "Explanation")


def build_pages(source: Path, out: Path) -> subprocess.CompletedProcess[str]:
    """Build without running the notebooks: that takes a minute, and tests/slow does it."""
    options = ["-t", "without_outputs", "-W", "--keep-going", "-q", "-b", "html", "-d", out / "read"]
    command = [sys.executable, "-m", "sphinx", *options, source, out / "html"]
    return subprocess.run(command, cwd=out, capture_output=True, text=True, check=False, timeout=300)


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The built pages; the build leaves nothing in the repository."""

    def sources() -> list[Path]:
        return sorted(path for path in (ROOT / ".docs").rglob("*.*") if "__pycache__" not in path.parts)

    out, before = tmp_path_factory.mktemp("documentation"), sources()
    done = build_pages(ROOT / ".docs", out)
    assert (done.returncode, done.stderr) == (0, ""), done.stdout + done.stderr
    assert sources() == before
    return out / "html"


@pytest.mark.tooling
def test_every_public_name_command_notebook_and_picture_has_its_place(pages: Path) -> None:
    api = (pages / "api.html").read_text(encoding="utf-8")
    assert [name for name in sc.__all__ if f'id="softcat_sym.{name}"' not in api] == []
    text = html.unescape(re.sub(r"<[^>]+>", "", (pages / "commands.html").read_text(encoding="utf-8")))
    assert len(COMMANDS) > 10
    assert [name for name in COMMANDS if f"Usage: softcat {name} [OPTIONS]" not in text] == []
    for name in NOTEBOOKS:
        text = (pages / f"{name}.html").read_text(encoding="utf-8")
        source = (ROOT / "derivations" / f"{name.partition('/')[2]}.py").read_text(encoding="utf-8")
        first = source.split("# # ")[1].splitlines()[0]
        assert f"<h1>{html.escape(first.split('. ', 1)[1], quote=False)}" in text and "softcat_sym" in text
    named = re.findall(r"\]\(\.readme/([^)]+)\)", (ROOT / "README.md").read_text(encoding="utf-8"))
    front = (pages / "index.html").read_text(encoding="utf-8")
    assert re.findall(r'class="caption"[^>]*><span class="caption-text">([^<]+)', front) == [*KINDS]
    assert len(named) > 5
    assert [name for name in named if f"_images/{name}" not in front] == []


@pytest.mark.tooling
def test_every_link_and_picture_leads_somewhere(pages: Path) -> None:
    """All pages' own links, those of the README with them."""
    broken, count = [], 0
    for page in pages.rglob("*.html"):
        for link in re.findall(r'(?:href|src)="([^"]+)"', page.read_text(encoding="utf-8")):
            place, anchor = urldefrag(html.unescape(link))
            if re.match(r"[a-z]+:|//", link):
                continue
            count += 1
            # Behind the question mark stands a checksum, for browsers that store old files.
            target = (page.parent / unquote(place.partition("?")[0])) if place else page
            lost = not target.is_file()
            if not lost and anchor and target.suffix == ".html":
                lost = anchor not in re.findall(r'id="([^"]+)"', target.read_text(encoding="utf-8"))
            broken += [f"{page.name}: {link}"] * lost
    assert count > 100
    assert broken == []


@pytest.mark.tooling
def test_a_reference_to_nowhere_fails_the_build(tmp_path: Path) -> None:
    """A wrong name in a docstring is noticed: the build is as strict as it claims."""
    source = tmp_path / "source"
    source.mkdir()
    settings = (ROOT / ".docs" / "conf.py").read_text(encoding="utf-8").partition("GROUPS = {")[0]
    (source / "conf.py").write_text(settings, encoding="utf-8")
    (source / "index.rst").write_text("Title\n=====\n\nSee :func:`softcat_sym.simulat`.\n", encoding="utf-8")
    done = build_pages(source, tmp_path)
    assert done.returncode == 1, done.stderr
    assert "reference target not found: softcat_sym.simulat" in done.stderr


@pytest.mark.tooling
def test_public_functions_records_and_methods_are_documented() -> None:
    for name in sc.__all__:
        thing = getattr(sc, name)
        text = inspect.getdoc(thing) or ""
        if not inspect.isclass(thing):
            signature = inspect.signature(thing)
            if signature.parameters:
                section = text.split("Parameters\n----------\n")[1].split("\n\n")[0]
                heads = [line.partition(" :")[0].split(", ") for line in section.splitlines() if line[0] != " "]
                listed = {word for head in heads for word in head}
                # What only makes sense beside another is told there, `so`.
                assert listed <= set(signature.parameters) <= listed | set(re.findall(r"(?<!`)`(\w+)`(?!`)", section))
            # A public class that is given back has its own place, where it tells what it holds.
            assert "Returns\n-------\n" in text or signature.return_annotation in sc.__all__, name
            continue
        if is_dataclass(thing):
            section = text.split("Attributes\n----------\n")[1].split("\n\n")[0]
            listed = {word.strip() for line in re.findall(r"(?m)^(\S.*?) :", section) for word in line.split(",")}
            assert {field.name for field in fields(thing) if not field.name.startswith("_")} <= listed, name
        for key, value in vars(thing).items():
            public = inspect.isfunction(value) or isinstance(value, property | classmethod)
            assert key.startswith("_") or not public or inspect.getdoc(value), (name, key)
