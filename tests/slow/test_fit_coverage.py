"""Are 95 % intervals right 95 times of 100, and estimates not off to one side: films of four materials.

Intervals are those of the curvature, of the arrested filament those of profiles. Whatever is drawn from what the fit
takes for granted, and told, is to be covered as often as it says; what it allows for in vain may be covered more often.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from tests.common.coverage_study import CASES, CELLS, STUDIES, Case, Fitted, covered, study
from tests.common.draws import deviations, errors_away, shares
from tests.common.table import show

HOLD = {
    "noise alone, told so": (0.95, 0.96),
    "noise alone, default": (0.95, 1.0),
    "camera, default": (0.93, 1.0),
    "camera, no theory's error": (0.93, 1.0),
    "camera and theory, default": (0.93, 1.0),
    "correlated by 0.5, camera and theory exact": (0.92, 1.0),
}
"""What share of intervals is to hold the truth in the long run, at least and at most: 95 %, less what fits that lean on
what is known beforehand were measured to lack.

Intervals of one film lean on each other, so that films count and not intervals. Of all 800 films of the first study
90 to 98.6 % may then, as intervals between 0.83 and 1.3 times as wide as they should be; of 160, 79 %, as intervals of
0.65 of their width; of one constant 85 % of 200 and 63 % of 40.
"""

CURVED, WHITE = 0.1, 0.01

pytestmark = pytest.mark.slow


@cache
def _study(name: str) -> dict[str, list[Fitted]]:
    found = study(name)
    rows: list[list[object]] = []
    for case in _cases(name):
        films = found[case.scene]
        for k, free in enumerate(case.free):
            errors = np.array([one.error[k] for one in films])
            rows.append(
                [
                    case.scene,
                    free,
                    f"{covered([one.interval[k] for one in films]):.1%}",
                    f"{errors.mean() / errors.std(ddof=1):+.2f}",
                    f"{errors.std(ddof=1):.2%}",
                    f"{np.median([(one.interval[k][1] - one.interval[k][0]) / 3.92 for one in films]):.2%}",
                    f"{np.mean([one.words[k] == 'identified' for one in films]):.0%}",
                    f"{np.mean([one.noise for one in films]):.3f}",
                    f"{np.mean([one.correlation for one in films]):.2f}",
                    f"{np.mean([one.white == 'not white' for one in films]):.1%}",
                    f"{np.mean([one.seconds for one in films]):.2f}",
                ]
            )
    header = [
        "scene",
        "parameter",
        "holds the truth",
        "bias/std",
        "std",
        "std told",
        "identified",
        "noise",
        "correlation",
        "not white",
        "s",
    ]
    title = f"{name}: {overall(found):.1%}; {STUDIES[name].films} films per scene, 1 % noise, {CELLS} cells"
    show(title, header, rows)
    return found


def _cases(name: str) -> list[Case]:
    return [CASES[number] for number in STUDIES[name].cases]


def overall(found: dict[str, list[Fitted]]) -> float:
    """The mean over films of the share of their intervals that hold the truth."""
    return float(np.mean([covered(one.interval) for films in found.values() for one in films]))


@pytest.mark.statistical
@pytest.mark.parametrize("name", STUDIES)
def test_intervals_hold_the_truth(name: str) -> None:
    found, (least, most) = _study(name), HOLD[name]
    films = sum(map(len, found.values()))
    # Nine constants, and all of them together.
    assert shares(films, least, 10)[0] <= overall(found) <= shares(films, most, 10)[1]
    for case in _cases(name):
        for k in range(len(case.free)):
            intervals = [one.interval[k] for one in found[case.scene]]
            assert covered(intervals) >= shares(len(intervals), least, 10)[0], (case.scene, case.free[k])


@pytest.mark.statistical
@pytest.mark.parametrize("case", _cases("noise alone, told so"), ids=lambda case: case.scene)
def test_estimates_are_not_off_to_one_side(case: Case) -> None:
    errors = np.array([one.error for one in _study("noise alone, told so")[case.scene]])
    # Means of 200 are off by less than 0.39 standard deviations, beside a tenth that curved models bring.
    far = errors_away(len(errors) - 1) / len(errors) ** 0.5 + CURVED
    assert np.all(np.abs(errors.mean(axis=0)) < far * errors.std(axis=0, ddof=1))


@pytest.mark.statistical
@pytest.mark.parametrize("name", ["noise alone, told so", "camera and theory, default"])
def test_noise_is_found_and_residuals_are_white(name: str) -> None:
    scenes = _study(name).values()
    for films in scenes:
        freedom = np.array([one.frames - 3 for one in films])
        low, high = deviations(int(freedom.sum()), 2 * len(scenes))
        # Of 200 films 2.4 %, of 40 some 5 %; what fits make of the errors of camera and theory is not quite linear.
        noise = np.sqrt(np.average([one.noise**2 for one in films], weights=freedom))
        assert 0.98 * low < noise < 1.02 * high
        # A test at 1 % accuses few that are white: 14 of 200, and 8 of 40.
        accused = np.mean([one.white == "not white" for one in films])
        assert accused <= shares(len(films), WHITE, 2 * len(scenes))[1]
