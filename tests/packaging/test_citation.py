"""``CITATION.cff`` as who cites reads it: the format's rules for what it holds, and the package's own data."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

import softcat_sym as sc

ROOT = Path(__file__).parents[2]
# Of the schema of the Citation File Format 1.2.0: what is required, and the keys that this file may use.
REQUIRED = {"authors", "cff-version", "message", "title"}
KEYS = REQUIRED | {"abstract", "keywords", "license", "references", "preferred-citation", "type", "version"}
REFERENCE = {"authors", "title", "type"}
REFERENCE_KEYS = REFERENCE | {"doi", "end", "journal", "pages", "start", "volume", "year"}
TYPES = {"article", "book", "software", "standard", "thesis", "report"}


@pytest.fixture(scope="module")
def citation() -> dict[str, Any]:
    return dict(yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8")))


def check_authors(authors: list[dict[str, str]]) -> None:
    assert authors
    for one in authors:
        person, entity = {"family-names", "given-names"}, {"name"}
        assert set(one) in (person, entity), one
        assert all(isinstance(text, str) and text for text in one.values())


def test_it_holds_what_the_format_requires(citation: dict[str, Any]) -> None:
    assert REQUIRED <= set(citation) <= KEYS
    assert citation["cff-version"] == "1.2.0"
    assert citation["type"] == "software"
    check_authors(citation["authors"])


def test_it_says_what_the_package_says(citation: dict[str, Any]) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert citation["version"] == project["version"]
    assert citation["license"] == project["license"]
    assert citation["title"].startswith(project["name"])
    assert [one["name"] for one in citation["authors"]] == [one["name"] for one in project["authors"]]


def test_every_reference_is_whole(citation: dict[str, Any]) -> None:
    for one in citation["references"]:
        assert REFERENCE <= set(one) <= REFERENCE_KEYS
        assert one["type"] in TYPES
        assert isinstance(one.get("year", 2012), int)
        assert re.fullmatch(r"10\.\d{4,9}/\S+", one.get("doi", "10.1000/x"))
        check_authors(one["authors"])


def test_the_paper_is_the_one_that_a_run_rests_on(citation: dict[str, Any]) -> None:
    (paper,) = citation["references"][:1]
    named = [author["family-names"] for author in paper["authors"]]
    run = sc.simulate(sc.load_scene("cold-honey", ["numerics.estimate=false", "numerics.cells=4", "run.frames=3"]))
    told = " ".join(map(str, run.data.attrs.values()))
    assert all(name in told for name in named)
    assert paper["title"] in told
    readme = (ROOT / "README.md").read_text(encoding="utf-8").split("## Cite")[1]
    assert all(name in readme for name in named)
    assert paper["title"] in readme and str(paper["year"]) in readme
