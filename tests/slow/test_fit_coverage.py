"""Are 95 % intervals right 95 times of 100, and estimates not off to one side: 200 films of each of four materials.

Seeds are the numbers of scene and film. Student's interval for the modulus of the arrested filament was seen to fall
short in this very study, so that its profile's, which `fit` gives unless told otherwise, is what is held to the limits;
both are in the table.
"""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from tests.common.coverage_study import CASES, CELLS, PROFILED, SETS, Case, Fitted, covered, study
from tests.common.table import show

LEAST, MOST = 0.90, 0.99
BIAS = 0.25
NARROWER = 0.2
"""Of a profile's interval against Student's, in the median."""

pytestmark = pytest.mark.slow


@cache
def _study() -> dict[str, list[Fitted]]:
    found = study()
    _show(found)
    return found


def _show(found: dict[str, list[Fitted]]) -> None:
    rows: list[list[object]] = []
    for case in CASES:
        films = found[case.scene]
        for k, name in enumerate(case.free):
            errors = np.array([one.error[k] for one in films])
            traced = [one for one in films if name in one.profiled]
            pair = covered([one.profiled[name] for one in traced]), covered([one.interval[k] for one in traced])
            rows.append(
                [
                    case.scene,
                    name,
                    f"{_share(case, films, k):.1%}",
                    "profile" if name in case.curved else "Student",
                    f"{errors.mean() / errors.std(ddof=1):+.2f}",
                    f"{errors.std(ddof=1):.2%}",
                    sum(one.words[k] == "identified" for one in films),
                    f"{_ratio(traced, name, k):.3f}",
                    f"{pair[0]:.1%}, {pair[1]:.1%} of {len(traced)}",
                ]
            )
    header = [
        "scene",
        "parameter",
        "interval contains the truth",
        "interval",
        "bias/std",
        "std",
        "identified",
        "profile/Student width",
        "profile, Student contain the truth",
    ]
    show(
        f"Coverage of 95 % intervals: {SETS} films per scene, 1 % noise, {CELLS} cells, published theory", header, rows
    )
    spent = sum(one.seconds for films in found.values() for one in films)
    white = {name: f"{np.mean([one.white != 'not white' for one in films]):.1%}" for name, films in found.items()}
    print(f"\n{spent / 60:.1f} min of fitting; residuals called white: {white}")


def _share(case: Case, films: list[Fitted], k: int) -> float:
    """Share of the films whose interval, the profile's where the case asks for it, contains the truth."""
    name = case.free[k]
    return covered([one.profiled[name] if name in case.curved else one.interval[k] for one in films])


def _ratio(films: list[Fitted], name: str, k: int) -> float:
    """Median width of the profile's interval over Student's."""
    both = [(one.profiled[name], one.interval[k]) for one in films]
    return float(np.median([(a[1] - a[0]) / (b[1] - b[0]) for a, b in both]))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.scene)
def test_intervals_contain_the_truth(case: Case) -> None:
    films = _study()[case.scene]
    assert len(films) == SETS
    share = {name: _share(case, films, k) for k, name in enumerate(case.free)}
    assert all(LEAST <= one <= MOST for one in share.values()), share


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.scene)
def test_estimates_are_not_off_to_one_side(case: Case) -> None:
    errors = np.array([one.error for one in _study()[case.scene]])
    assert np.all(np.abs(errors.mean(axis=0)) < BIAS * errors.std(axis=0, ddof=1))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.scene)
def test_noise_is_found_and_residuals_are_white(case: Case) -> None:
    films = _study()[case.scene]
    found = np.array([one.noise for one in films])
    frames = np.array([one.frames for one in films])
    # chi^2/(m - k) has a variance of 2/(m - k).
    score = (found**2 - 1) * np.sqrt((frames - len(case.free)) / 2)
    assert abs(score.mean()) < 4 / math.sqrt(SETS)
    assert 0.8 < score.std() < 1.2
    # A test at 1 % accuses 2 of 200 that are white, and hardly ever 9.
    assert sum(one.white == "not white" for one in films) <= 8


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.scene)
def test_profiles_agree_with_student(case: Case) -> None:
    for k, name in enumerate(case.free):
        traced = [one for one in _study()[case.scene] if name in one.profiled]
        assert len(traced) == (SETS if name in case.curved else PROFILED)
        # 16 of 20 or fewer have a probability of 1.6 %, 15 or fewer of 0.3 %.
        assert covered([one.profiled[name] for one in traced]) >= 15.5 / 20
        assert abs(_ratio(traced, name, k) - 1) < NARROWER, name
