"""The documentation: built without a warning, nothing public without its page, nothing told that is not so."""

from __future__ import annotations

import html
import inspect
import re
import subprocess
import sys
from dataclasses import fields, is_dataclass
from pathlib import Path
from urllib.parse import unquote, urldefrag

import pytest

import softcat_sym as sc

pytestmark = pytest.mark.tooling

ROOT = Path(__file__).parents[2]
HOW_TO = ("12_own_rheology", "13_first_run", "14_ink_bridging", "15_fit_your_data", "16_take_the_c_away")
FUNCTIONS = [name for name in sc.__all__ if not inspect.isclass(getattr(sc, name))]
RECORDS = [name for name in sc.__all__ if is_dataclass(getattr(sc, name))]


def build(source: Path, out: Path) -> subprocess.CompletedProcess[str]:
    """Build without running the how-to notebooks: that takes a minute, and tests/slow does it."""
    command = [
        sys.executable,
        "-m",
        "sphinx",
        "-t",
        "without_outputs",
        "-W",
        "--keep-going",
        "-q",
        "-b",
        "html",
        "-d",
        out / "read",
        source,
    ]
    return subprocess.run([*command, out / "html"], cwd=out, capture_output=True, text=True, check=False, timeout=300)


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The built pages. Five to ten seconds, twice that on a busy machine: not slow, since CI is to build them."""
    out = tmp_path_factory.mktemp("documentation")
    before = sorted(ROOT.joinpath(".docs").rglob("*.*"))
    done = build(ROOT / ".docs", out)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stderr == ""
    after = sorted(ROOT.joinpath(".docs").rglob("*.*"))
    assert [path for path in after if "__pycache__" not in path.parts] == [
        path for path in before if "__pycache__" not in path.parts
    ], "the build leaves something in the repository"
    return out / "html"


def test_every_public_name_has_its_place_in_the_api(pages: Path) -> None:
    text = (pages / "api.html").read_text(encoding="utf-8")
    assert [name for name in sc.__all__ if f'id="softcat_sym.{name}"' not in text] == []


def test_every_command_has_its_help(pages: Path) -> None:
    import typer.main

    from softcat_sym.cli.application import app

    text = html.unescape(re.sub(r"<[^>]+>", "", (pages / "commands.html").read_text(encoding="utf-8")))
    names = list(typer.main.get_command(app).commands)  # type: ignore[attr-defined]
    assert len(names) > 10
    assert [name for name in names if f"Usage: softcat {name} [OPTIONS]" not in text] == []


@pytest.mark.parametrize("name", HOW_TO)
def test_every_how_to_has_its_page(pages: Path, name: str) -> None:
    text = (pages / "howto" / f"{name}.html").read_text(encoding="utf-8")
    first = (ROOT / "derivations" / f"{name}.py").read_text(encoding="utf-8").split("# # ")[1].splitlines()[0]
    assert f"<h1>{html.escape(first.split('. ', 1)[1], quote=False)}" in text
    assert "softcat_sym" in text


def test_every_link_and_picture_leads_somewhere(pages: Path) -> None:
    """All pages' own links, those of the README with them."""
    broken, seen = [], 0
    for page in pages.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        for link in re.findall(r'(?:href|src)="([^"]+)"', text):
            place, anchor = urldefrag(html.unescape(link))
            if re.match(r"[a-z]+:|//", link):
                continue
            seen += 1
            # Behind the question mark stands a checksum, for browsers that keep old files.
            target = (page.parent / unquote(place.partition("?")[0])) if place else page
            if not target.is_file():
                broken.append(f"{page.name}: {link}")
            elif anchor and target.suffix == ".html":
                known = re.findall(r'id="([^"]+)"', target.read_text(encoding="utf-8"))
                if anchor not in known:
                    broken.append(f"{page.name}: {link}")
    assert seen > 100
    assert broken == []


def test_pictures_of_the_readme_are_on_the_front_page(pages: Path) -> None:
    named = re.findall(r"\]\(\.readme/([^)]+)\)", (ROOT / "README.md").read_text(encoding="utf-8"))
    text = (pages / "index.html").read_text(encoding="utf-8")
    assert len(named) > 5
    assert [name for name in named if f"_images/{name}" not in text] == []


def test_a_reference_to_nowhere_fails_the_build(tmp_path: Path) -> None:
    """A wrong name in a docstring is noticed: the build is as strict as it claims."""
    source = tmp_path / "source"
    source.mkdir()
    settings = (ROOT / ".docs" / "conf.py").read_text(encoding="utf-8").partition("GROUPS = {")[0]
    (source / "conf.py").write_text(settings, encoding="utf-8")
    (source / "index.rst").write_text("Title\n=====\n\nSee :func:`softcat_sym.simulat`.\n", encoding="utf-8")
    done = build(source, tmp_path)
    assert done.returncode == 1, done.stderr
    assert "reference target not found: softcat_sym.simulat" in done.stderr


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_tell_what_they_take_and_give(name: str) -> None:
    function = getattr(sc, name)
    text, signature = inspect.getdoc(function) or "", inspect.signature(function)
    if signature.parameters:
        section = text.split("Parameters\n----------\n")[1].split("\n\n")[0]
        heads = [line.partition(" :")[0].split(", ") for line in section.splitlines() if line[0] != " "]
        # What only makes sense beside another is told there, `so`.
        told = {word for head in heads for word in head} | set(re.findall(r"(?<!`)`(\w+)`(?!`)", section))
        assert set(signature.parameters) <= told
        assert {word for head in heads for word in head} <= set(signature.parameters)
    # A public class that is given back has its own place, where it tells what it holds.
    assert "Returns\n-------\n" in text or signature.return_annotation in sc.__all__


@pytest.mark.parametrize("name", RECORDS)
def test_records_tell_what_they_hold(name: str) -> None:
    record = getattr(sc, name)
    text = inspect.getdoc(record) or ""
    section = text.split("Attributes\n----------\n")[1].split("\n\n")[0]
    told = {word.strip() for line in re.findall(r"(?m)^(\S.*?) :", section) for word in line.split(",")}
    public = {one.name for one in fields(record) if not one.name.startswith("_")}
    assert public <= told, public - told


@pytest.mark.parametrize("name", sc.__all__)
def test_public_methods_are_documented(name: str) -> None:
    thing = getattr(sc, name)
    members = vars(thing).items() if inspect.isclass(thing) else ()
    bare = [
        key
        for key, value in members
        if not key.startswith("_") and (inspect.isfunction(value) or isinstance(value, property | classmethod))
        if not inspect.getdoc(value)
    ]
    assert bare == []
