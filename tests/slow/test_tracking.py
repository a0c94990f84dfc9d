"""From films to constants: runs of five materials are rendered with faults of cameras, tracked and fitted."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.common.draws import shares
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
