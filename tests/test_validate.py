"""Published cases: each is whole, the command says what came out, what is missing and what is wrong."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import pandas as pd
import pytest

from softcat_sym.errors import SoftcatError
from softcat_sym.studies import validate as study
from softcat_sym.studies.published.case import Case, Finding, PublishedValue, published_scene
from tests.common.in_process import Softcat

FAST = ("smay", "martinie", "u-shape")


@pytest.fixture(autouse=True)
def elsewhere(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)


def test_every_case_is_whole() -> None:
    names = [case.name for case in study.CASES]
    assert len(set(names)) == len(names) >= 18
    for case in study.CASES:
        assert (case.run is None) is bool(case.reason), case.name
        assert case.title and case.source and case.stated
        assert case.run is None or (case.independent and case.explains), case.name
        for name in case.scenes:
            assert published_scene(name).title


def test_a_row_tells_its_difference_and_whether_it_agrees() -> None:
    row = PublishedValue("sag", "mm", 2.0, 2.1, band=(1.9, 2.05))
    assert row.difference == pytest.approx(0.05) and row.agrees is False
    assert replace(row, ours=2.02).agrees is True and replace(row, band=None).agrees is None
    assert replace(row, is_absolute=True).difference == pytest.approx(0.1)


def test_the_command_holds_the_cases_that_are_named(softcat: Softcat) -> None:
    done = softcat("validate", *FAST)
    assert (done.status, done.err) == (0, "")
    out = Path("softcat-out/validate")
    found = json.loads((out / "validation.json").read_text())["cases"]
    by_name = {case["name"]: case for case in found}
    assert list(by_name) == ["smay", "u-shape", "martinie"]
    # A pinned beam in bending alone: 5 rho g A L^4/(384 E I) = 0.05 D, E = 3 G'.
    (rule,) = by_name["smay"]["rows"]
    assert rule["ours"] == pytest.approx(5 * 16 / (384 * 3 * 0.05), rel=2e-3)
    assert rule["agrees"] is True and rule["published"] == 1.4
    assert by_name["martinie"]["kind"] == "assumed, not predicted"
    assert by_name["u-shape"]["rows"] == [] and "catenary" in by_name["u-shape"]["stated"]
    assert "not run: neither the number nor its value" in done.out and "1 assumed, 1 not run" in done.out
    table = pd.read_csv(out / "validation.csv")
    assert table["ours"].notna().sum() == 2 and len(table) == 3
    page = (out / "validation.html").read_text()
    assert page.count("data:image/png") == 2 and "softcat validate smay martinie u-shape -o DIR" in page
    assert {path.name for path in out.glob("*.png")} == {"validation.png", "smay.png"}
    # The scene of a case is one to run.
    done = softcat("run", str(out / "spanning-strand.toml"), "-o", "again", "-q")
    assert (done.status, done.err) == (0, "")


def test_without_its_extra_a_case_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "rheodata", None)
    (result,) = study.validate(["rheodata"]).results
    assert result.finding is None and result.not_run == "it needs rheodata: pip install softcat_sym[peers]"


def made(run: object) -> tuple[Case, ...]:
    return (replace(next(case for case in study.CASES if case.name == "martinie"), name="own", run=run, scenes=()),)  # type: ignore[arg-type]


def test_a_run_that_is_no_answer_stands_in_the_table_and_fails_the_command(
    monkeypatch: pytest.MonkeyPatch, softcat: Softcat
) -> None:
    def breaks() -> Finding:
        raise SoftcatError("it runs away")

    monkeypatch.setattr(study, "CASES", made(breaks))
    done = softcat("validate", "-o", "out", "-q")
    assert (done.status, done.err) == (1, "softcat: own: it runs away\n")
    assert json.loads(Path("out/validation.json").read_text())["cases"][0]["failure"] == "it runs away"
    assert "no answer: it runs away" in softcat("validate", "-o", "out").out
