"""Which law: films of three materials, fitted by all three laws; and films that are too noisy or too short to tell."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.model_selection import CANNOT, LawComparison, fit_laws
from softcat_sym.fitting.result import FitOutcome
from softcat_sym.scene.laws import LAWS as SPECS
from tests.common.draws import draws, gain
from tests.common.fitting import is_sound
from tests.common.table import show

LAWS = ("maxwell", "bingham", "newtonian")
PAPER = {"run.effects": "paper", "numerics.cells": 6}

pytestmark = pytest.mark.slow


@dataclass(frozen=True)
class Film:
    """How it was filmed, and whether it tells the law from those that it is no limit of."""

    law: str
    noise: float
    frames: int
    tells: bool = False


FAR = 100.0
"""Difference of the criterion beyond which the residuals of a wrong law must be seen to be no noise."""

FILMS = (
    Film("maxwell", 0.01, 100, tells=True),
    Film("bingham", 0.01, 100, tells=True),
    # Maxwell with a stiff spring and Bingham with a low yield stress are Newtonian too.
    Film("newtonian", 0.01, 100),
    Film("newtonian", 0.2, 60),
    Film("bingham", 0.2, 20),
    Film("maxwell", 0.01, 8),
)


def _scene(law: str) -> sc.Scene:
    """A filament of the law that a film of its whole run tells."""
    if law == "bingham":
        scene = sc.load_scene("arrested-overdamped", PAPER)
        return scene.replace({"run.duration": f"{0.5 * scene.run.duration!r} s"})
    scene = sc.load_scene("maxwell-slow", PAPER)
    scene = scene.replace({"run.duration": f"{0.15 * scene.run.duration!r} s"})
    if law == "newtonian":
        return scene.replace({"material.law": law, "material.youngs_modulus": None})
    return scene


@cache
def _compared(film: Film) -> LawComparison:
    scene = _scene(film.law).replace({"run.frames": film.frames + 1})
    run, random = sc.simulate(scene).data, draws(film.frames, LAWS.index(film.law))
    height = run.midpoint.values[1:]
    noise = film.noise * float(np.max(np.abs(height)))
    readings = Measurements.of(run.time.values[1:], height + noise * random.standard_normal(height.size))
    return fit_laws(readings, scene, LAWS, starts=0)


@pytest.mark.statistical
@pytest.mark.parametrize("film", FILMS, ids=lambda film: f"{film.law}, {film.noise:g} noise, {film.frames} frames")
def test_the_right_law_wins_or_it_cannot_be_told(film: Film) -> None:
    found = _compared(film)
    ranked = {row.law.name: row for row in found.choice.table}
    rows = [
        [
            row.law.name,
            row.law.unknowns,
            f"{row.criterion:.1f}",
            f"{row.bic:.1f}",
            f"{row.difference:.1f}",
            row.law.failure,
        ]
        for row in found.choice.table
    ]
    title = f"{film.law}, {film.noise:.0%} noise, {film.frames} frames: {found.sentence}"
    show(title, ["law", "constants", "criterion", "BIC", "difference", "failure"], rows)
    if film.law in found.failures or math.isinf(ranked[film.law].criterion):
        # Of few readings a law may have more unknowns, those of camera and theory among them, than there are.
        assert film.frames < 10 and found.choice.verdict == CANNOT
        return
    # Noise of a hundredth and wrong laws are apart by hundreds. Where a law wins that is not the film's, it has gained
    # no more than its constants do by chance; laws that were confused, or misfits that were miscounted, would.
    true, best = ranked[film.law].law, found.choice.table[0].law
    if best.name != film.law:
        chance = gain(film.frames, best.unknowns)
        assert film.frames * math.log(true.squares / best.squares) < chance
    if found.choice.verdict == CANNOT:
        assert found.sentence.startswith("cannot tell: ")
    if film.tells:
        # A law that has the film's as a limit gains by its further constant now and then; no other is left.
        assert all(name == film.law or film.law in SPECS[name].contains for name in found.choice.close)
    # Residuals that are noise are called otherwise once in a hundred.
    fit = found.fits[film.law]
    assert fit.outcome is not FitOutcome.model_error or is_sound(fit)
    if film.noise <= 0.01:
        far = [row.law.name for row in found.choice.table if FAR < row.difference < math.inf]
        assert all(found.fits[name].checks.verdict == "not white" for name in far)
