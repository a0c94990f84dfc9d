"""From films to constants: runs of five materials are rendered with faults of cameras, tracked and fitted."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import softcat_sym as sc
from tests.common.draws import misses, shares
from tests.common.in_process import Softcat
from tests.studies.film_to_constants import MATERIALS, answer

pytestmark = [pytest.mark.slow, pytest.mark.statistical]

FILMS = 4


def test_intervals_of_constants_from_films_hold_them(tmp_path: Path) -> None:
    """Twenty films: honey, Maxwell, Bingham and Herschel-Bulkley inks, and one that stops."""
    answers = [answer(name, seed, tmp_path) for name in MATERIALS for seed in range(FILMS)]
    assert all(one.outcome in ("solved", "not_identified", "model_error", "outliers") for one in answers)
    holds = [good for one in answers for good in one.holds.values()]
    # Nominal intervals hold 95 %; the constants of one film are not independent, so that each film counts once.
    least, _ = shares(len(answers), 0.95)
    assert sum(all(one.holds.values()) for one in answers) >= least * len(answers)
    assert len(holds) == FILMS * sum(len(one.free) for one in MATERIALS.values())
    # The midpoint is known to a hundredth of a pixel, the constants to what scale and theory leave.
    values = [value for one in answers for value in one.values.values()]
    assert all(0.5 < value < 2.0 for value in values)


def test_one_command_from_the_film_of_the_samples_to_its_constants(softcat: Softcat, tmp_path: Path) -> None:
    sample = Path(sc.__file__).parent / "samples" / "film.mov"
    given = ["--film-scale", "span=10 mm", "--set", "load.ramp=20 ms", "--set", "run.duration=40 ms"]
    how = ["--free", "viscosity", "--free", "yield_stress", "--starts", "0", "--no-profile-likelihood"]
    done = softcat(
        "fit", str(sample), "--scene", str(sample.with_name("my-ink.toml")), *given, *how, "-o", str(tmp_path)
    )
    assert done.status == 0
    assert {"film.csv", "film.png", "fit.json", "fit.html"} < {one.name for one in tmp_path.iterdir()}
    parameters = json.loads((tmp_path / "fit.json").read_text())["parameters"]
    for name, truth in (("viscosity", 30.0), ("yield_stress", 346.4)):
        assert not misses(parameters[name]["best"], tuple(parameters[name]["ci95"]), truth)
