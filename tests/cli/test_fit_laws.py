"""``softcat fit --law`` as a user meets it: one law, several ranked, refusals."""

from __future__ import annotations

import csv
import io
import json
import math
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from tests.cli.in_process import Softcat, sets
from tests.inverse.filmed import CHEAP, TRUTH, write_film

SCENE = ("--scene", "continual-descent", *sets(*CHEAP))
QUICK = ("--starts", "0", "--no-profile-likelihood")


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def _laws(*names: str) -> list[str]:
    return [word for name in names for word in ("--law", name)]


def test_several_laws_are_ranked_and_the_best_is_the_fit(softcat: Softcat, tmp_path: Path) -> None:
    film, output = write_film(tmp_path / "film.csv"), tmp_path / "out"
    done = softcat("fit", str(film), *SCENE, *_laws("newtonian", "bingham"), *QUICK, "-o", str(output))
    assert done.status == 0, done.err
    assert "the films speak for bingham" in done.out
    found = json.loads((output / "fit.json").read_text())
    laws = found["laws"]
    assert laws["verdict"] == "bingham" and laws["close"] == ["bingham"]
    assert [row["law"] for row in laws["table"]] == ["bingham", "newtonian"]
    # The fit that is written is the best law's.
    assert found["parameters"] == laws["table"][0]["parameters"]
    assert found["parameters"]["yield_stress"]["value"] == pytest.approx(TRUTH["yield_stress"], rel=0.05)
    assert sc.load_scene(str(output / "scene.toml")).material.law == "bingham"
    rows = list(csv.DictReader(io.StringIO((output / "laws.csv").read_text())))
    assert [(row["rank"], row["law"], row["constants"]) for row in rows] == [
        ("1", "bingham", "3"),
        ("2", "newtonian", "1"),
    ]
    # Root mean square and Akaike's criterion by hand, from the table of the fit.
    fitted = list(csv.DictReader(io.StringIO((output / "fit.csv").read_text())))
    left = np.array([float(row["model_m"]) - float(row["measured_m"]) for row in fitted])
    assert float(rows[0]["residual_std_m"]) == pytest.approx(math.sqrt(float(np.mean(left**2))), rel=1e-9)
    ratio = float(rows[1]["residual_std_m"]) / float(rows[0]["residual_std_m"])
    apart = len(left) * 2 * math.log(ratio) - 2 * (3 - 1)
    assert float(rows[1]["aic"]) - float(rows[0]["aic"]) == pytest.approx(apart, rel=1e-6)
    page = (output / "fit.html").read_text(encoding="utf-8")
    assert "Which law" in page and "The films speak for bingham." in page and 'id="laws"' in page
    assert (output / "laws.png").read_bytes().startswith(b"\x89PNG")


def test_one_law_is_one_fit_of_all_its_constants(softcat: Softcat, tmp_path: Path) -> None:
    film, output = write_film(tmp_path / "film.csv"), tmp_path / "out"
    output.mkdir()
    for name in ("laws.png", "laws.csv"):
        (output / name).write_bytes(b"of an earlier comparison")
    words = ("--law", "newtonian", "--free", "time_offset", "--bounds", "viscosity=1:1e3 kPa*s", *QUICK, "-q")
    done = softcat("fit", str(film), *SCENE, *words, "-o", str(output))
    assert (done.status, done.out, done.err) == (0, "", "")
    found = json.loads((output / "fit.json").read_text())
    assert [*found["parameters"]] == ["viscosity", "time_offset"] and "laws" not in found
    assert found["parameters"]["viscosity"]["bounds"] == pytest.approx([1e3, 1e6])
    assert not {"laws.png", "laws.csv"} & {path.name for path in output.iterdir()}


BAD = {
    "misspelt": (_laws("maxwel", "bingham"), "did you mean 'maxwell'"),
    "misspelt alone": (_laws("maxwel"), "did you mean 'maxwell'"),
    "twice": (_laws("maxwell", "maxwell"), "one is named twice"),
    "without constants": (_laws("custom", "maxwell"), "none that can be fitted"),
    "free by itself": ([*_laws("maxwell", "bingham"), "--free", "viscosity"], "free without being named"),
    "free by its path": ([*_laws("maxwell"), "--free", "material.viscosity"], "free without being named"),
    "unknown besides": ([*_laws("maxwell"), "--free", "tmie_offset"], "tmie_offset"),
    "bounds of no constant": (
        [*_laws("maxwell", "newtonian"), "--bounds", "density=1:2 g/cm^3"],
        "not free in any law",
    ),
    "bounds reversed": ([*_laws("maxwell"), "--bounds", "viscosity=2:1 kPa*s"], "the lower one first"),
    "nothing": ([], "--law"),
}


@pytest.mark.parametrize(("arguments", "message"), BAD.values(), ids=BAD)
def test_bad_input_is_one_message_and_leaves_nothing(
    arguments: list[str], message: str, softcat: Softcat, tmp_path: Path
) -> None:
    film, output = write_film(tmp_path / "film.csv"), tmp_path / "out"
    done = softcat("fit", str(film), *SCENE, *arguments, *QUICK, "-o", str(output))
    assert done.status == 2 and done.out == ""
    assert message in " ".join(done.err.replace("│", " ").split())
    assert not output.exists()
