"""ASTM C338: a glass fibre in its furnace, heated at 5 K/min, elongates 1 mm/min at its softening point.

Glasses 710 and 717a of the National Bureau of Standards by their published constants. What the test method states is
held against what comes out, and against an independent quadrature: there is no free number in either.
"""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.studies.published.glass import ELONGATES, GLASSES, RATE, Glass, softening
from tests.common.table import show

pytestmark = pytest.mark.slow

LENGTH, HEATED, DIAMETER, GRAVITY = 0.235, 0.1, 0.65e-3, 9.81
CAPACITY, TRANSFER, CONDUCTIVITY, OUTSIDE = 1250.0, 250.0, 1.3, 500.0
"""Those of the published scene."""


def by_quadrature(glass: Glass) -> float:
    """The same of the furnace, slice by slice: each is drawn by the weight below it less what its surface pulls.

    Slices of the undeformed fibre stretch at (rho g (L - X) - gamma sqrt(s)/R0) s/(3 eta), s its stretch; the fibre
    follows the furnace by rho c_p d/(4 h), and is half way to the outside at its end, within sqrt(k d/(4 h)).
    """
    X = (np.arange(800) + 0.5) * HEATED / 800
    s, radius = np.ones(800), DIAMETER / 2
    lag = glass.density * CAPACITY * DIAMETER / (4 * TRANSFER)
    cold = np.exp((X - HEATED) / np.sqrt(CONDUCTIVITY * DIAMETER / (4 * TRANSFER))) / 2
    time, step, before = 0.0, 0.1, 0.0
    furnace = glass.softens - 40.0
    while True:
        inside = furnace - RATE * lag * -np.expm1(-time / lag)
        rate = (glass.density * GRAVITY * (LENGTH - X) * s - glass.surface / radius * np.sqrt(s)) * s
        rate /= 3 * glass.viscosity(inside + (OUTSIDE - inside) * cold)
        speed = float(np.sum(rate)) * HEATED / 800
        if speed >= ELONGATES:
            return furnace - RATE * step * (speed - ELONGATES) / (speed - before)
        s, time, before = s + step * rate, time + step, speed
        furnace += RATE * step


@pytest.mark.parametrize("name", GLASSES)
def test_a_fibre_elongates_where_the_method_says(name: str) -> None:
    """At 10^6.5 to 10^7 Pa s, as the method states; the published softening point is ten kelvin higher."""
    glass = GLASSES[name]
    found = softening(glass)
    furnace, fibre = found.at, found.fibre
    exact, decades = by_quadrature(glass), float(np.log10(glass.viscosity(fibre)))
    rows = [[f"{one:.2f}" for one in (glass.softens, furnace, exact, fibre, decades)]]
    header = ("published [C]", "furnace at 1 mm/min, run", "quadrature", "fibre", "log10 eta [Pa s]")
    show(f"ASTM C338, glass {name}", header, rows)
    assert furnace == pytest.approx(exact, abs=0.15)
    assert 6.5 < decades < 7.0
    # The lag of the fibre, rho c_p d/(4 h) times 5 K/min, is no explanation: a sixth of a kelvin.
    assert 0.05 < furnace - fibre < 0.3
    assert -14 < furnace - glass.softens < -8
