"""How far the theory is from finite elements, and what constants are worth that are fitted with that in mind.

Both are linear in the error: its size and correlation by film, and by how much generalised least squares with the
covariance of :mod:`softcat_sym.fitting.discrepancy` miss the constants of the elements. Nothing is drawn: shares and
root mean squares are numbers of these films, the same everywhere but for rounding.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest

from softcat_sym.fitting.discrepancy import Discrepancy, discrepancy
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.problem import FilamentProblem
from softcat_sym.simulate import recalled, without_estimate
from softcat_sym.studies.compare import aligned
from tests.common.element_films import HELD, KNOWN, film
from tests.common.elements import Floats
from tests.common.fitting import CONSTANTS
from tests.common.table import show

pytestmark = pytest.mark.slow

THEORIES: Mapping[str, Mapping[str, object]] = {
    "default": {},
    "published, material": {"run.effects": "paper"},
    "published, printed": {"run.effects": "paper", "run.closure": "printed"},
}
NOISE = (1e-2, 1e-3)
"""Of the largest sag."""

RINGING = ("elastic, thick", "ringing arrest")
"""Films of which the covariance holds too little: phases part by a radian; and necks swing, which the published theory
does not have."""


@dataclass(frozen=True)
class Compared:
    """A theory at the constants of a film of the elements."""

    time: Floats
    elements: Floats
    theory: Floats  # On twice the cells and to a tenth of the tolerance: the theory's own
    model: Floats  # As a fit has it
    slopes: Floats  # By the logarithms of the constants
    names: tuple[str, ...]
    stands: Discrepancy

    @property
    def error(self) -> Floats:
        return self.theory - self.elements

    @property
    def pace(self) -> Floats:
        return self.time * np.gradient(self.theory, self.time)

    @property
    def size(self) -> float:
        """What an error of height and of pace would have to be: rms of both."""
        return float(np.sqrt(np.sum(self.error**2) / np.sum(self.theory**2 + self.pace**2)))

    @property
    def correlation(self) -> float:
        """Difference of log t over which the relative error forgets itself: its variogram reaches 1 - 1/e of its size.

        NaN where it does not within the film.
        """
        at = np.exp(np.linspace(np.log(0.05), 0, 60)) * self.time[-1]
        relative = np.interp(at, self.time, self.error / np.sqrt(self.theory**2 + self.pace**2))
        square = np.mean(relative**2)
        for lag in range(1, 40):
            if np.mean((relative[lag:] - relative[:-lag]) ** 2) / 2 > (1 - np.exp(-1)) * square:
                return float(lag * np.log(20) / 59)
        return float("nan")

    def shift(self, noise: float, free: tuple[str, ...]) -> tuple[Floats, Floats]:
        """Errors of the constants' logarithms, and their standard errors."""
        columns = [self.names.index(name) for name in free]
        covariance = self.stands.covariance(self.time, self.model)
        covariance += (noise * np.max(np.abs(self.elements))) ** 2 * np.eye(self.time.size)
        weighed = np.linalg.solve(covariance, np.column_stack([self.slopes[:, columns], -self.error]))
        spread = np.linalg.inv(self.slopes[:, columns].T @ weighed[:, :-1])
        return spread @ (self.slopes[:, columns].T @ weighed[:, -1]), np.sqrt(np.diag(spread))


@cache
def compared(name: str, theory: str) -> Compared:
    scene, time, elements = film(name)
    scene = scene.replace(dict(THEORIES[theory]))
    run = recalled(without_estimate(scene))
    finer = {"numerics.cells": 2 * run.summary["cells"], "numerics.rtol": 0.1 * run.summary["rtol"]}
    data = recalled(without_estimate(run.scene.replace(finer))).data
    names = tuple(key for key in CONSTANTS if getattr(scene.material, key) is not None)
    problem = FilamentProblem(scene, Measurements.of(time, elements, 1.0), names)
    residuals, slopes = problem.linearised(problem.typical)
    return Compared(
        time,
        elements,
        aligned(data["time"].values, data["midpoint"].values, time),
        residuals + elements,
        slopes,
        names,
        discrepancy(scene, problem.films[0].model.effects, problem.films[0].model.terms),
    )


def _asked(names: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    yield names
    if len(names) == 3:
        yield names[1:]


@pytest.mark.parametrize("theory", THEORIES)
def test_amplitude_is_what_elements_show(theory: str) -> None:
    rows, ratios = [], {}
    for name in (*KNOWN, *HELD):
        one = compared(name, theory)
        largest = np.max(np.abs(one.error)) / np.max(np.abs(one.elements))
        ratios[name] = one.size / one.stands.amplitude
        numbers = [f"{100 * each:.2f} %" for each in (one.size, largest, one.stands.amplitude)]
        rows.append([name, *numbers, f"{ratios[name]:.2f}", f"{one.correlation:.1f}"])
    header = [
        "film",
        "rms of height and pace",
        "largest, of the sag",
        "amplitude",
        "rms/amplitude",
        "correlation, log t",
    ]
    show(f"{theory}, minus elements", header, rows)
    told = np.array(list(ratios.values()))
    assert told.max() < 1.4
    assert 0.4 < np.sqrt(np.mean(told**2)) < 1.0


@pytest.mark.parametrize("theory", THEORIES)
def test_constants_lie_within_their_intervals(theory: str) -> None:
    rows, scores, ringing = [], [], []
    for name in (*KNOWN, *HELD):
        one = compared(name, theory)
        for free in _asked(one.names):
            for noise in NOISE:
                shift, error = one.shift(noise, free)
                said = dict(zip(free, zip(shift, error, strict=True), strict=True))
                both = [
                    "{:+.2f} ± {:.2f} %".format(*(100 * x for x in said[key])) if key in said else ""
                    for key in CONSTANTS
                ]
                rows.append([name, f"{100 * noise:g} %", *both])
                (ringing if name in RINGING else scores).extend(shift / error)
    within, every = (float(np.mean(np.abs(each) < 1.96)) for each in (scores, [*scores, *ringing]))
    rms = float(np.sqrt(np.mean(np.square(scores))))
    summary = f"within {100 * every:.0f} %; without what rings {100 * within:.0f} %, shift over error {rms:.2f} in rms"
    show(f"{theory}: {summary}", ["film", "noise", "E", "eta", "sY"], rows)
    assert within > 0.95
    # An error that is smooth in time follows films that ring, and the published closure's, less than one that is not.
    assert every > 0.87
    if theory == "default":
        assert every > 0.92
        assert 0.5 < rms < 1.0
