"""Beam-bending viscometry as ASTM C598: both of its constants, from the midpoint speeds of glass rods between pins.

A viscous beam of tensile viscosity 3 mu goes down at v = g L^3/(48 (3 mu) I) (M + (5/8) rho A L), M hung at midspan.
Per minute that is mu = g L^3/(2.4 I v) (M + rho A L/1.6): 2.4 = 144/60 and 1.6 = 8/5.
"""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest

from tests.common.rheology import GEOMETRY, flow_of, limit_of, scene, solved
from tests.common.table import show
from tests.marks import few

SPAN, DENSITY, GRAVITY, MU, LOAD = 0.05, 2500.0, 9.81, 1e12, 0.01
THICKNESS = 3e-3
SECTIONS = {
    "circle": (np.pi * THICKNESS**2 / 4, np.pi * THICKNESS**4 / 64),
    "rectangle": (THICKNESS**2, THICKNESS**4 / 12),
}
"""Area and second moment."""
LAWS: dict[str, dict[str, Any]] = {
    "newtonian": {"law": "newtonian", "shear_viscosity": MU},
    "maxwell": {"law": "maxwell", "youngs_modulus": 70e9, "shear_viscosity": MU},
}


def speed(law: str, section: str, mass: float, cells: int) -> float:
    """Midpoint travel in metres a minute, between the fifth and the tenth minute."""
    asked = scene(
        LAWS[law],
        {"span": SPAN, "thickness": THICKNESS, "section": section, "density": DENSITY},
        effects=(*GEOMETRY, *flow_of(law)),
        ends={"left": "pinned", "right": "pinned"},
        load={"gravity": GRAVITY, "point_mass": mass},
        run={"duration": 600.0, "frames": 3},
        cells=cells,
        rtol=1e-6,
    )
    heights = solved(asked)["midpoint"].values
    return float(heights[1] - heights[2]) / 5


@pytest.mark.parametrize(("law", "section"), few(product(LAWS, SECTIONS), ("maxwell", "rectangle")))
def test_constants_of_the_beam_bending_viscometer(law: str, section: str) -> None:
    area, second_moment = SECTIONS[section]
    own = DENSITY * area * SPAN
    rows = []
    for cells in (20, 40):
        bare, loaded = (speed(law, section, mass, cells) for mass in (0.0, LOAD))
        # the load alone gives the first constant, the rod alone then the second
        first = GRAVITY * SPAN**3 * LOAD / (MU * second_moment * (loaded - bare))
        second = GRAVITY * SPAN**3 * own / (MU * second_moment * first * bare)
        viscosities = [
            GRAVITY * SPAN**3 / (2.4 * second_moment * v) * (mass + own / 1.6) / MU - 1
            for v, mass in ((bare, 0.0), (loaded, LOAD))
        ]
        rows.append([cells, first, second, *viscosities])
    ends = [limit_of(a, b) for a, b in zip(rows[0][1:], rows[1][1:], strict=True)]
    text = [[n, f"{a:.5f}", f"{b:.5f}", f"{c:+.1e}", f"{d:+.1e}"] for n, a, b, c, d in [*rows, ["limit", *ends]]]
    show(f"ASTM C598, {law}, {section}", ("N", "2.4", "1.6", "mu, no load", f"mu, {1000 * LOAD:g} g"), text)
    for _, first, second, *viscosities in rows[1:]:
        assert first == pytest.approx(2.4, rel=5e-3)
        assert second == pytest.approx(1.6, rel=5e-3)
        assert np.abs(viscosities).max() < 5e-3
    np.testing.assert_allclose(ends[:2], [2.4, 1.6], rtol=5e-4)
