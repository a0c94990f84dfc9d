"""Which law: films of three materials, fitted by all three laws; and films that are too noisy or too short to tell."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.model_selection import LawComparison, fit_laws
from softcat_sym.fitting.result import FitOutcome
from tests.common.draws import draws
from tests.common.table import show

LAWS = ("maxwell", "bingham", "newtonian")
PAPER = {"run.effects": "paper", "numerics.cells": 6}

pytestmark = pytest.mark.slow


@dataclass(frozen=True)
class Film:
    """How it was filmed, and what may be said of it."""

    law: str
    noise: float
    frames: int
    verdicts: tuple[str, ...]


CANNOT = "cannot tell"
FAR = 100.0
"""Difference of the criterion beyond which the residuals of a wrong law must be seen to be no noise."""

FILMS = (
    Film("maxwell", 0.01, 100, ("maxwell",)),
    Film("bingham", 0.01, 100, ("bingham",)),
    # Maxwell with a stiff spring and Bingham with a low yield stress are Newtonian too.
    Film("newtonian", 0.01, 100, ("newtonian", CANNOT)),
    Film("newtonian", 0.2, 60, ("newtonian", CANNOT)),
    Film("maxwell", 0.2, 20, ("maxwell", CANNOT)),
    Film("bingham", 0.2, 20, ("bingham", CANNOT)),
    Film("maxwell", 0.01, 8, ("maxwell", CANNOT)),
    Film("bingham", 0.01, 8, ("bingham", CANNOT)),
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


@pytest.mark.parametrize("film", FILMS, ids=lambda film: f"{film.law}, {film.noise:g} noise, {film.frames} frames")
def test_the_right_law_wins_or_it_cannot_be_told(film: Film) -> None:
    found = _compared(film)
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
    assert found.choice.verdict in film.verdicts
    # Of few readings the wider law may have more unknowns, those of camera and theory among them, than there are.
    assert film.law in (*found.choice.close, *found.failures)
    if found.choice.verdict == CANNOT:
        assert found.sentence.startswith("cannot tell: ")
        return
    assert found.fits[film.law].outcome is not FitOutcome.model_error
    if film.noise <= 0.01:
        far = [row.law.name for row in found.choice.table if row.difference > FAR]
        assert all(found.fits[name].checks.verdict == "not white" for name in far)
