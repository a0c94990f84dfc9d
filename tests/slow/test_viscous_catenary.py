"""The viscous catenary, a Newtonian filament that stretches, and breaks in a finite time.

Teichman & Mahadevan, J. Fluid Mech. 478, 71 (2003): bending first, then stretching with bending left at the clamps,
then breaking. The viscous string and its breaking time are derived in ``viscous_string``; ``softcat validate`` has the
exponent of Brochard-Wyart & de Gennes.
"""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from tests.common.rheology import Array, scene, solved
from tests.common.table import show
from tests.common.viscous_string import breaking_time, viscous_string

pytestmark = pytest.mark.slow

EFFECTS = ("bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-stress")
VISCOSITY = 1e4
"""Tensile [Pa s]: with rho g L = 1e4 Pa the unit of time is 1 s."""
THICKNESSES = (0.02, 0.01, 0.005)
TIMES = (0.1, 0.5, 1.0, 1.5)
"""Up to where the clamp's element is eight times as long; the string breaks at 1.7375."""
FINE = 160


def run(thickness: float, times: Array, cells: int) -> xr.Dataset:
    """A filament clamped at both ends on a grid graded towards them, at equally spaced times from the start."""
    material, filament = {"law": "newtonian", "viscosity": VISCOSITY}, {"thickness": thickness, "section": "circle"}
    span = {"duration": times[-1], "frames": len(times)}
    asked = scene(material, filament, effects=EFFECTS, run=span, cells=cells, rtol=1e-6)
    return solved(asked.model_copy(update={"numerics": asked.numerics.model_copy(update={"grading": None})}))


def test_filament_tends_to_the_string_until_it_breaks() -> None:
    """At a sag of the order of the span and beyond; the clamps' bending is of first order in the thickness."""
    exact, times = viscous_string(np.array(TIMES)), np.linspace(0, TIMES[-1], 16)
    places = [int(np.argmin(np.abs(times - t))) for t in TIMES]
    data = [run(thickness, times, FINE) for thickness in THICKNESSES]
    drawn = [float(each["stretch"].values[-1].max()) for each in data]
    misses = np.array([-each["midpoint"].values[places] / exact.sag - 1 for each in data])
    rates = np.log2(misses[:-1] / misses[1:])
    rows = [["string", *(f"{sag:.5f}" for sag in exact.sag), f"{exact.end_stretch[-1]:.2f}"]]
    for thickness, miss, stretch in zip(THICKNESSES, misses, drawn, strict=True):
        rows.append([f"D/L = {thickness:g}", *(f"{m:+.2%}" for m in miss), f"{stretch:.2f}"])
    rows.append(["rate in D/L", *(f"{rate:.2f}" for rate in rates[-1]), ""])
    header = ("t rho g L/eta", *(f"{t:g}" for t in TIMES), "largest stretch")
    show("sag/L of the string, and how far a clamped Newtonian filament is from it", header, rows)
    print(f"\nthe string breaks at {breaking_time():.5f} eta/(rho g L), eta = 3 mu")
    assert np.all(misses < 0)
    assert np.max(np.abs(misses[-1])) < 0.01
    # The later the coarser: the elements at the clamp are drawn out, and the grid adds to the difference.
    assert rates == pytest.approx(1, abs=0.3)
    assert drawn[-1] == pytest.approx(exact.end_stretch[-1], rel=0.1)
