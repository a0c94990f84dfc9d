"""Surface tension: the filament minus the elements in the overdamped arrest; ``-s`` prints the table.

Gam = gamma (1/h0 + 1/D0) in units of the yield stress. Both take the section to shrink alike in height and depth.
"""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.scene.scene import Scene
from tests.common.elements import digits, elements, midpoints, name_of, percent, plane
from tests.common.strips import shortened
from tests.common.table import show

PULLS = (0.0, 0.3, 0.8)
GOALS = (0.005, 0.005, 0.006)
"""Errors allowed up to t~ = 115: with the strongest pull the filament ends half a percent lower on all grids tried."""

INSTANTS = (10.0, 46.0, 115.0, 230.0)
MESHES = (Mesh(32, 2), Mesh(48, 6, grading=10.0))


def pulled(pull: float) -> Scene:
    scene = plane("arrested-overdamped", {"numerics.solver": "idas", "numerics.rtol": 1e-4, "numerics.fibres": 12})
    sides = 1 / scene.filament.thickness + 1 / scene.filament.width
    return shortened(scene, INSTANTS[-1], 231).replace(
        {"surroundings.surface_tension": f"{pull * (scene.material.yield_stress or 0.0) / sides!r} N/m"}
    )


@pytest.mark.slow
def test_arrest_under_surface_tension() -> None:
    rows, sags, errors = [], [], []
    for pull in PULLS:
        scene = pulled(pull)
        runs = [elements(scene, mesh) for mesh in MESHES]
        truth = midpoints(scene, runs[-1], INSTANTS)
        run = sc.simulate(scene)
        found = midpoints(scene, run, INSTANTS)
        for one in runs:
            rows.append([f"{pull:g}", name_of(one.mesh), *digits(midpoints(scene, one, INSTANTS))])
        both = [f"{value} ({apart})" for value, apart in zip(digits(found), percent(found, truth), strict=True)]
        rows.append([f"{pull:g}", "filament", *both])
        sags.append(truth[2])
        errors.append(np.abs(found / truth - 1))
        assert max(one.energy_error for one in runs) < 1e-4
        assert run.outcome.is_success
    title = "arrested-overdamped, delta = 0.03, midpoint/L; differences from the last elements"
    show(title, ["Gam/sigma_Y", "", *(f"t~ = {t:g}" for t in INSTANTS)], rows)
    assert sags[1] / sags[0] == pytest.approx(0.82, abs=0.01)
    assert sags[2] / sags[0] == pytest.approx(0.61, abs=0.015)
    assert np.all(np.array(errors)[:, :3].max(axis=1) < GOALS)
