"""softcat fit: files, exit status, refusals, and several laws."""

from __future__ import annotations

import base64
import csv
import io
import json
import math
import re
from html import unescape
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.filmed import CHEAP, TRUTH, write_film
from tests.common.in_process import Softcat, sets

PICTURES = {"fit.png", "profiles.png", "correlation.png", "features.png"}
FILES = {"fit.json", "scene.toml", "fit.csv", "fit.html", *PICTURES}
FREE = ("--free", "yield_stress", "--free", "viscosity")
SCENE = ("--scene", "continual-descent", *sets(*CHEAP))


def test_files_table_and_page(softcat: Softcat, tmp_path: Path) -> None:
    film, output = write_film(tmp_path / "film & co.csv"), tmp_path / "deep" / "out"
    astray = sets("material.viscosity=20 kPa*s")
    done = softcat("fit", str(film), *SCENE, *astray, *FREE, "-o", str(output), "--starts", "0")
    assert done.status == 0, done.err
    assert {path.name for path in output.iterdir()} == FILES
    assert not re.search(r"nan|inf\b|None", done.out)
    found = json.loads((output / "fit.json").read_text())
    assert set(found["parameters"]) == set(TRUTH) and found["outcome"] == "solved"
    for name, truth in TRUTH.items():
        one = found["parameters"][name]
        assert one["ci95"][0] < truth < one["ci95"][1]
        assert one["verdict"] == "identified" and abs(one["value"] - truth) < 3 * one["std"]
        assert name in done.out
    assert found["correlation"][0][1] == pytest.approx(found["correlation"][1][0])
    assert found["starts"]["count"] >= 1 and found["evaluations"] > 2 and found["advice"]
    assert found["noise_m"] == pytest.approx(5e-4, rel=0.3) and found["noise_known"] is False
    scene = sc.load_scene(str(output / "scene.toml"))
    assert scene.material.viscosity == pytest.approx(found["parameters"]["viscosity"]["value"], rel=1e-9)
    assert scene.material.yield_stress == pytest.approx(found["parameters"]["yield_stress"]["value"], rel=1e-9)
    rows = list(csv.DictReader(io.StringIO((output / "fit.csv").read_text())))
    residual = (np.array([float(row["model_m"]) - float(row["measured_m"]) for row in rows])) / found["noise_m"]
    np.testing.assert_allclose([float(row["residual"]) for row in rows], residual, rtol=1e-9, atol=1e-12)
    assert {row["film"] for row in rows} == {"film & co.csv"}
    page = (output / "fit.html").read_text(encoding="utf-8")
    # The page holds its pictures and loads nothing from elsewhere.
    sources = re.findall(r"""(?:src|href|srcset)=["']([^"']*)["']""", page)
    assert sources and all(one.startswith(("data:", "#")) for one in sources)
    pictures = {base64.b64decode(one.partition("base64,")[2]) for one in sources if one.startswith("data:image/png")}
    assert pictures == {(output / name).read_bytes() for name in PICTURES}
    words = unescape(page)
    assert "film & co.csv" in words and "--free yield_stress" in words and "identified" in words
    # The page repeats what the terminal says.
    assert all(cell in words for cell in re.findall(r"[\d.]+ ± [\d.]+", done.out))


# What is wrong with films and with names stands in test_measurements.py and test_free_parameters.py.
BAD = {
    "no file": (("nowhere.csv", *SCENE, *FREE), "no such file"),
    "unknown name": (("FILM", *SCENE, "--free", "viscsity"), "did you mean"),
    "nothing free": (("FILM", *SCENE), "--free"),
    "no pair": (("FILM", *SCENE, *FREE, "--bounds", "viscosity=1"), "write a name, two values"),
    "bounded twice": (
        ("FILM", *SCENE, *FREE, "--bounds", "viscosity=1:1e5 Pa*s", "--bounds", "viscosity=1:1e6 Pa*s"),
        "bounded twice",
    ),
    "bounds of what is not free": (("FILM", *SCENE, *FREE, "--bounds", "density=1:1e4 kg/m^3"), "not free"),
    "scene": (("FILM", "--scene", "continual-decent", *FREE), "continual-decent"),
    "metres": (("METRES", *SCENE, *FREE), "0.2 m"),
    "same film twice": (("FILM", "FILM", *SCENE, *FREE), "named twice"),
    "method": (("FILM", *SCENE, *FREE, "--method", "newton"), "least-squares, ipopt"),
    "starts": (("FILM", *SCENE, *FREE, "--starts", "-1"), "--starts"),
    "set": (("FILM", *SCENE, *FREE, *sets("material.visosity=1 Pa*s")), "material.visosity"),
    "misspelt law": (("FILM", *SCENE, "--law", "maxwel"), "did you mean 'maxwell'"),
    "free by itself": (("FILM", *SCENE, "--law", "maxwell", "--free", "viscosity"), "free without being named"),
    "bounds of no constant": (
        ("FILM", *SCENE, "--law", "maxwell", "--law", "newtonian", "--bounds", "density=1:2 g/cm^3"),
        "not free in any law",
    ),
}


@pytest.mark.parametrize(("arguments", "message"), BAD.values(), ids=BAD)
def test_bad_input_is_one_message_and_leaves_nothing(
    arguments: tuple[str, ...], message: str, softcat: Softcat, tmp_path: Path
) -> None:
    film = write_film(tmp_path / "FILM.csv").read_text().splitlines()
    metres = [f"{row.partition(',')[0]},{-5 * k / 60}" for k, row in enumerate(film[1:], start=1)]
    (tmp_path / "METRES.csv").write_text("\n".join([film[0], *metres]) + "\n")
    words = [str(tmp_path / f"{word}.csv") if word in ("FILM", "METRES") else word for word in arguments]
    output = tmp_path / "out"
    done = softcat("fit", *words, "-o", str(output))
    assert done.status == 2 and done.out == ""
    assert message in " ".join(done.err.replace("│", " ").split())
    assert not output.exists()


OF_LAWS = ("--scene", "continual-descent", *sets(*CHEAP))
QUICK = ("--starts", "0", "--no-profile-likelihood")
EXACT = ("--calibrated", "--no-discrepancy")  # the criterion by hand knows white noise, and no error of the run


def _laws(*names: str) -> list[str]:
    return [word for name in names for word in ("--law", name)]


@pytest.mark.slow
def test_several_laws_are_ranked_and_the_best_is_the_fit(softcat: Softcat, tmp_path: Path) -> None:
    film, output = write_film(tmp_path / "film.csv"), tmp_path / "out"
    done = softcat("fit", str(film), *OF_LAWS, *_laws("newtonian", "bingham"), *QUICK, *EXACT, "-o", str(output))
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
    assert float(rows[1]["aic"]) - float(rows[0]["aic"]) == pytest.approx(apart, rel=1e-3)
    page = (output / "fit.html").read_text(encoding="utf-8")
    assert "Which law: the films speak for bingham" in page
    assert (output / "laws.png").read_bytes().startswith(b"\x89PNG")
